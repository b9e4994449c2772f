// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/whole_file.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "core/formats/output_file.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_whole_file {

class TestWholeFile : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        QCOMPARE(writeWholeFile(path("from"), "new"), QString());
        QCOMPARE(writeWholeFile(path("to"), "old"), QString());
    }

    void copies()
    {
        QCOMPARE(copyWholeFile(path("from"), path("to")), QString());
        QCOMPARE(content("to"), QByteArray("new"));
        QCOMPARE(content("from"), QByteArray("new"));
    }

    void saysWhyItDoesNotCopy_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("reason");
        QTest::newRow("another writer") << "from"
                                        << "to"
                                        << "could not be written: another run writes to it.";
        QTest::newRow("no source") << "none"
                                   << "other"
                                   << "other could not be written: No such file or directory.";
        QTest::newRow("no folder") << "from"
                                   << "none/to"
                                   << "there is no directory";
    }
    void saysWhyItDoesNotCopy()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, reason);
        const OutputLock writer(path("to").toStdString());
        const QString problem = copyWholeFile(path(from), path(to));
        QVERIFY2(problem.contains(reason), qPrintable(problem));
        QCOMPARE(content("to"), QByteArray("old"));
    }

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    QByteArray content(const QString& name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestWholeFile)

} // namespace test_whole_file

#include "test_whole_file.moc"
