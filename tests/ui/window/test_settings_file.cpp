// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program starts with its default settings where their file is none, and leaves what lies there.
#include "ui/window/settings_file.h"

#include <sys/stat.h>

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_settings_file {

const QByteArray ownSettings = "[files]\nlast=fig12a\n";

class TestSettingsFile : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_settings_file"));
    }
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        qputenv("XDG_CONFIG_HOME", folder_->path().toLocal8Bit());
        qputenv("XDG_CONFIG_DIRS", path(QStringLiteral("system")).toLocal8Bit());
        for (const auto scope : {QSettings::UserScope, QSettings::SystemScope})
            QSettings::setPath(QSettings::NativeFormat, scope, folder_->path());
        QVERIFY(QDir(folder_->path()).mkpath(QStringLiteral("touchdown")));
    }
    void whatIsNoFileOfSettingsStays_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("where");
        for (const char* what :
             {"a FIFO", "a link to a FIFO", "a directory", "a letter", "a link to a letter", "a large file", "no text"})
            QTest::addRow("%s", what) << what << "touchdown/test_settings_file.conf";
        QTest::newRow("of the organisation") << "a FIFO"
                                             << "touchdown.conf";
        QTest::newRow("of the system") << "a FIFO"
                                       << "system/touchdown.conf";
        QTest::newRow("a lock") << "a FIFO"
                                << "touchdown/test_settings_file.conf.lock";
    }
    void whatIsNoFileOfSettingsStays()
    {
        QFETCH(const QString, what);
        QFETCH(const QString, where);
        QVERIFY(QDir(folder_->path()).mkpath(QStringLiteral("system")));
        const bool isLink = what.startsWith(QLatin1String("a link"));
        const QString file = path(where), thing = isLink ? path(QStringLiteral("elsewhere")) : file;
        QByteArray bytes;
        if (what.endsWith(QLatin1String("FIFO"))) QCOMPARE(::mkfifo(qPrintable(thing), 0600), 0);
        if (what.endsWith(QLatin1String("directory"))) QVERIFY(QDir().mkpath(thing));
        if (what.endsWith(QLatin1String("letter"))) bytes = "Dear reader,\nthis is a letter.\n";
        if (what == QLatin1String("a large file")) bytes = QByteArray("a=1\n").repeated(300'000);
        if (what == QLatin1String("no text")) bytes = QByteArray(100, '\0');
        if (!bytes.isEmpty()) write(thing, bytes);
        if (isLink) QVERIFY(QFile::link(thing, file));
        struct stat before {
        }, after{};
        QCOMPARE(::lstat(qPrintable(file), &before), 0);
        const SettingsFile settings;
        QVERIFY2(settings.problem().contains(path(where.chopped(where.endsWith(QLatin1String(".lock")) ? 5 : 0))),
                 qPrintable(settings.problem()));
        QCOMPARE(QSettings().value("files/last"), QVariant());
        QSettings().setValue("files/last", "fig5");
        QCOMPARE(QSettings().value("files/last").toString(), QStringLiteral("fig5"));
        QCOMPARE(::lstat(qPrintable(file), &after), 0);
        QVERIFY(before.st_ino == after.st_ino && before.st_mode == after.st_mode);
        if (!bytes.isEmpty()) QCOMPARE(read(thing), bytes);
    }
    void aFileOfSettingsIsUsed_data()
    {
        QTest::addColumn<bool>("link");
        QTest::newRow("itself") << false;
        QTest::newRow("through a link") << true;
    }
    void aFileOfSettingsIsUsed()
    {
        QFETCH(const bool, link);
        const QString file = path(QStringLiteral("touchdown/test_settings_file.conf"));
        const QString target = link ? path(QStringLiteral("dotfiles.conf")) : file;
        write(target, ownSettings);
        if (link) QVERIFY(QFile::link(target, file));
        const SettingsFile settings;
        QCOMPARE(settings.problem(), QString());
        QCOMPARE(QSettings().value("files/last").toString(), QStringLiteral("fig12a"));
        QSettings().setValue("files/last", "fig5");
        QCOMPARE(QFileInfo(file).isSymbolicLink(), link);
        QVERIFY(read(target).contains("last=fig5"));
    }
    /// QSettings would wait for it for half a minute.
    void aLockThatStaysIsAProblem()
    {
        const QString file = path(QStringLiteral("touchdown/test_settings_file.conf"));
        write(file, ownSettings);
        write(file + QStringLiteral(".lock"), "no number of a process\n");
        QVERIFY(SettingsFile().problem().contains(QStringLiteral("is locked")));
        QVERIFY(QFile::remove(file + QStringLiteral(".lock")));
        QCOMPARE(SettingsFile().problem(), QString());
    }
    void noFileIsNoProblem() { QCOMPARE(SettingsFile().problem(), QString()); }

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    static void write(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    static QByteArray read(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestSettingsFile)

} // namespace test_settings_file

#include "test_settings_file.moc"
