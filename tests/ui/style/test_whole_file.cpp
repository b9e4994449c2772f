// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/style/whole_file.h"

using namespace touchdown;

namespace test_whole_file {

class TestSavedFile : public QObject {
    Q_OBJECT

private slots:
    void holdsWhatWasWritten()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.csv"));
        QVERIFY(!SavedFile().holds());
        QVERIFY(!SavedFile(QString()).holds());
        QVERIFY(!SavedFile(path).holds()); // there is none
        QCOMPARE(writeWholeFile(path, "1,2\n"), QString());
        const SavedFile saved(path);
        QVERIFY(saved.holds());
        QCOMPARE(writeWholeFile(path, "1,3\n"), QString());
        QVERIFY(!saved.holds());
        QCOMPARE(writeWholeFile(path, "1,2\n"), QString());
        QVERIFY(saved.holds());
        QVERIFY(QFile::remove(path));
        QVERIFY(!saved.holds());
    }
};

TOUCHDOWN_TEST(TestSavedFile)

} // namespace test_whole_file

#include "test_whole_file.moc"
