// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/watched_file.h"

#include <vector>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_watched_file {

class TestWatchedFile : public QObject {
    Q_OBJECT

private slots:
    void tellsEachChangeOnce()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mine.toml"));
        const auto write = [&file](const QByteArray& bytes) {
            QFile out(file);
            QVERIFY(out.open(QIODevice::WriteOnly));
            out.write(bytes);
        };
        QWidget window;
        WatchedFile watched(window);
        std::vector<FileNow> told;
        connect(&watched, &WatchedFile::changed, this, [&told](FileNow now) { told.push_back(now); });
        QCOMPARE(watched.now(), FileNow::Same); // no file
        write("a");
        watched.expect(file, identityOfBytes("a"));
        watched.look();
        QVERIFY(told.empty());
        write("b");
        watched.look();
        watched.look();
        QCOMPARE(told, std::vector{FileNow::Other});
        write("c");
        watched.look();
        QCOMPARE(told.size(), std::size_t(2));
        write("a");
        watched.look();
        QCOMPARE(told.back(), FileNow::Same);
        QVERIFY(QFile::remove(file));
        watched.look();
        QCOMPARE(told.back(), FileNow::Gone);
        watched.expect(file, identityOfBytes("d")); // as after Save
        QCOMPARE(told.back(), FileNow::Same);
        QCOMPARE(told.size(), std::size_t(5));
    }
    /// By the system: also a file that takes its place, and the one after it.
    void seesFilesThatTakeItsPlace()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mine.toml")), part = file + QStringLiteral(".part");
        const auto replace = [&](const QByteArray& bytes) {
            QFile out(part);
            QVERIFY(out.open(QIODevice::WriteOnly));
            out.write(bytes);
            out.close();
            std::filesystem::rename(part.toStdString(), file.toStdString());
        };
        replace("a");
        QWidget window;
        WatchedFile watched(window);
        int told = 0;
        connect(&watched, &WatchedFile::changed, this, [&told] { ++told; });
        watched.expect(file, identityOfBytes("a"));
        for (int i = 1; i <= 3; ++i) {
            replace(QByteArray::number(i));
            QTRY_COMPARE(told, i);
        }
    }
};

TOUCHDOWN_TEST(TestWatchedFile)

} // namespace test_watched_file

#include "test_watched_file.moc"
