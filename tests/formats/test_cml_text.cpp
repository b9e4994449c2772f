// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/cml_text.h"

#include <QTest>

#include <cmath>
#include <functional>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_cml_text {

/// What an action on a text is refused with, and where; "" and 0 when it is not.
struct Refusal {
    std::string message;
    int line = 0;
};
Refusal refusal(std::string_view text, const std::function<void(CmlText&)>& action)
{
    try {
        CmlText reader(text);
        action(reader);
    } catch (const CmlError& error) {
        return {error.what(), error.line()};
    }
    return {};
}

class TestCmlText : public QObject {
    Q_OBJECT

private slots:
    void numbers_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("whole") << QByteArray("42") << 42.0;
        QTest::newRow("plus") << QByteArray("+1.3200E-08") << 1.32e-8;
        QTest::newRow("minus") << QByteArray("-5") << -5.0;
        QTest::newRow("three digits of exponent") << QByteArray("8.5000E-004") << 8.5e-4;
        QTest::newRow("double precision") << QByteArray("1.0D-7") << 1e-7;
        QTest::newRow("small letter") << QByteArray("1.0d+2") << 100.0;
        QTest::newRow("exponent without a letter") << QByteArray("1.0-100") << 1e-100;
        QTest::newRow("no digit before the point") << QByteArray("-.5") << -0.5;
        QTest::newRow("no digit behind the point") << QByteArray("5.") << 5.0;
        QTest::newRow("nearest double") << QByteArray("0.1") << 0.1;
    }
    void numbers()
    {
        QFETCH(QByteArray, text);
        QFETCH(double, value);
        const auto number = readCmlNumber(text.toStdString());
        QVERIFY(number.has_value());
        QCOMPARE(*number, value);
        CmlText reader(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
        QCOMPARE(reader.number("it").value, value);
    }

    void noNumbers_data()
    {
        QTest::addColumn<QByteArray>("text");
        for (const char* text :
             {"abc", "NaN", "nan", "inf", "-Infinity", "1.#QNAN", "12a",   "0x10",          "1e",    "1e+", "e5",
              ".",   "-",   "+",   "--1", "1.2.3",     "1e5.0",   "1e999", "1e99999999999", "1d2d3", "*",   "1_000"})
            QTest::newRow(text) << QByteArray(text);
    }
    void noNumbers()
    {
        QFETCH(QByteArray, text);
        const std::string file = "1\n" + text.toStdString() + " 7\n";
        const Refusal r = refusal(file, [](CmlText& reader) {
            reader.number("the first");
            reader.number("the width");
        });
        QCOMPARE(r.line, 2);
        QCOMPARE(r.message, "the width must be a number, not \"" + text.toStdString() + "\"");
    }

    void lineEndsCount_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("Unix") << QByteArray("1 2\n\n3\nx");
        QTest::newRow("Windows") << QByteArray("1 2\r\n\r\n3\r\nx");
        QTest::newRow("old Macintosh") << QByteArray("1 2\r\r3\rx");
        QTest::newRow("mixed") << QByteArray("1\t,2  \r\n \n 3\rx");
        QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBF"
                                                       "1 2\n\n3\nx");
        QTest::newRow("end mark of DOS") << QByteArray("1 2\n\n3\nx\x1a garbage \x01");
    }
    void lineEndsCount()
    {
        QFETCH(QByteArray, text);
        CmlText reader(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
        QCOMPARE(reader.number("one").line, 1);
        QCOMPARE(reader.number("two").line, 1);
        QCOMPARE(reader.number("three").line, 3);
        reader.takeLine();
        QCOMPARE(reader.line(), 4);
        QCOMPARE(reader.takeLine(), std::string_view("x"));
        QVERIFY(reader.atEnd());
        QVERIFY(reader.takeLine().empty());
    }

    void listsEndWithTheirLine()
    {
        CmlText reader("1 2 remark 3\n4 5\n6");
        reader.number("one");
        reader.number("two");
        QVERIFY(!reader.endList()); // a remark is no number
        reader.number("four");
        QVERIFY(reader.endList()); // 5 was not asked for
        QCOMPARE(reader.number("six").value, 6.0);
        QVERIFY(!reader.endList());
    }
    void remarksAreSkippedOnTheirLineOnly()
    {
        CmlText reader("1 ! a corner\n2\nword");
        reader.number("one");
        reader.skipRemark();
        QCOMPARE(reader.number("two").value, 2.0);
        reader.skipRemark();
        QCOMPARE(reader.peekWord(), std::string_view("word"));
    }

    void wholeNumbers()
    {
        CmlText reader("3 4.0 -2");
        QCOMPARE(reader.whole("it", 3, 3), 3);
        QCOMPARE(reader.whole("it", 0, 9), 4);
        QCOMPARE(reader.whole("it", -9, 0), -2);
        for (const std::string bad : {"2.5", "11", "0", "2000000000", "1e30", "-1"}) {
            const Refusal r = refusal(bad, [](CmlText& text) { text.whole("the count", 1, 10); });
            QCOMPARE(r.line, 1);
            QCOMPARE(r.message, "the count must be a whole number from 1 to 10, not \"" + bad + "\"");
        }
    }
    void theEndIsTold()
    {
        const Refusal r = refusal("1\n2\n", [](CmlText& reader) {
            reader.number("one");
            reader.number("two");
            reader.number("the crown");
        });
        QCOMPARE(r.line, 2);
        QCOMPARE(r.message, std::string("the file ends where the crown is needed"));
    }

    void binaryIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("zero byte") << QByteArray("1\n2\0", 4);
        QTest::newRow("control character") << QByteArray("1\n\x02");
        QTest::newRow("UTF-16") << QByteArray("\n1\0\n\0", 5);
        QTest::newRow("escape") << QByteArray("\r\n\x1b[1m");
    }
    void binaryIsRefused()
    {
        QFETCH(QByteArray, text);
        const Refusal r = refusal({text.constData(), static_cast<std::size_t>(text.size())}, [](CmlText&) {});
        QCOMPARE(r.line, 2);
        QVERIFY2(r.message.find("binary") != std::string::npos, r.message.c_str());
    }
    void latin1IsText()
    {
        CmlText reader("xfs(\xb5NM) \xff\n1");
        QCOMPARE(reader.takeLine(), std::string_view("xfs(\xb5NM) \xff"));
        QCOMPARE(reader.number("it").line, 2);
    }
    void longTextsTakeLinearTime()
    {
        // Quadratic work would take hours: 4 million blank lines, and as many words.
        const std::string blanks(4'000'000, '\n');
        CmlText reader(blanks);
        QVERIFY(reader.peekWord().empty());
        std::string words;
        for (int i = 0; i < 1'000'000; ++i) words += "7\n";
        CmlText numbers(words);
        int count = 0;
        for (; numbers.nextIsNumber(); ++count) numbers.number("it");
        QCOMPARE(count, 1'000'000);
        QCOMPARE(numbers.line(), 1'000'000);
    }
};

TOUCHDOWN_TEST(TestCmlText)

} // namespace test_cml_text

#include "test_cml_text.moc"
