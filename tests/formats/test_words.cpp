// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/words.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_words {

class TestWords : public QObject {
    Q_OBJECT

private slots:
    void trimsBothEnds()
    {
        QVERIFY(trimmed(" \t7 nm\r\n") == "7 nm");
        QVERIFY(trimmed(" \t\r\n").empty());
        QVERIFY(trimmed(" 7 nm\n", blanks) == "7 nm\n");
    }

    void lowersAsciiLettersOnly() { QVERIFY(lowerCase("Rail.DAT \xc3\x84") == "rail.dat \xc3\x84"); }

    void joinsAndCounts()
    {
        QVERIFY(joined({}).empty());
        QVERIFY(joined({"a", "b"}) == "a, b");
        QVERIFY(joined({"a", "b"}, " or ") == "a or b");
        QVERIFY(counted(0, "rail") == "0 rails");
        QVERIFY(counted(1, "rail") == "1 rail");
    }
};

TOUCHDOWN_TEST(TestWords)

} // namespace test_words

#include "test_words.moc"
