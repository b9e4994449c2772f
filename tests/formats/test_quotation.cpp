// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/quotation.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_quotation {

class TestQuotation : public QObject {
    Q_OBJECT

private slots:
    void shortTextStays() { QCOMPARE(inQuotes("7 µm"), std::string("\"7 µm\"")); }
    void controlCharactersAreHidden() { QCOMPARE(inQuotes("a\n\x1b[2J"), std::string("\"a??[2J\"")); }
    void whatTurnsTheDirectionIsHidden() { QCOMPARE(inQuotes("a\u202eb\u2066c\u009bd"), std::string("\"a?b?c?d\"")); }
    void printable_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        QTest::newRow("letters") << QByteArray("7 µm, 𝛑 \u2065\u202f") << QByteArray("7 µm, 𝛑 \u2065\u202f");
        QTest::newRow("an escape sequence") << QByteArray("\x1b]0;title\x07") << QByteArray("\\u001b]0;title\\u0007");
        QTest::newRow("delete, C1") << QByteArray("\x7f\u0080\u009b\u00a0")
                                    << QByteArray("\\u007f\\u0080\\u009b\u00a0");
        QTest::newRow("direction") << QByteArray("\u061c\u200e\u200f\u202a\u202e\u2066\u2069")
                                   << QByteArray("\\u061c\\u200e\\u200f\\u202a\\u202e\\u2066\\u2069");
        QTest::newRow("C1 as a single byte") << QByteArray("a\x9b"
                                                           "1m")
                                             << QByteArray("a\\x9b1m");
        QTest::newRow("cut off") << QByteArray("a\xe2\x80") << QByteArray("a\\xe2\\x80");
        QTest::newRow("lines") << QByteArray("a\nb\r\t") << QByteArray("a\\u000ab\\u000d\t");
    }
    void printable()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, shown);
        const auto is = touchdown::printable({text.constData(), static_cast<std::size_t>(text.size())});
        QCOMPARE(QByteArray::fromStdString(is), shown);
    }
    void linesMayStay() { QCOMPARE(touchdown::printable("a\nb\r", true), std::string("a\nb\\u000d")); }
    void invalidBytesAreHidden() { QCOMPARE(inQuotes("a\xff"), std::string("\"a?\"")); }
    void longTextIsCutBetweenCharacters()
    {
        std::string text = "a";
        for (int i = 0; i < 100; ++i) text += "µ"; // two bytes, so that the limit of 60 falls inside one
        const std::string shown = inQuotes(text);
        QCOMPARE(findInvalidUtf8(shown), std::string::npos);
        QVERIFY(shown.ends_with("µ...\""));
        QVERIFY(shown.size() < 70);
    }
    void utf8_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<qsizetype>("bad"); // -1: valid
        QTest::newRow("ASCII") << QByteArray("abc") << qsizetype(-1);
        QTest::newRow("two, three and four bytes") << QByteArray("µ€𝛑") << qsizetype(-1);
        QTest::newRow("Latin-1") << QByteArray("5 \xb5m") << qsizetype(2);
        QTest::newRow("cut off") << QByteArray("ab\xc2") << qsizetype(2);
        QTest::newRow("overlong slash") << QByteArray("\xc0\xaf") << qsizetype(0);
        QTest::newRow("overlong of three") << QByteArray("a\xe0\x80\xaf") << qsizetype(1);
        QTest::newRow("surrogate") << QByteArray("\xed\xa0\x80") << qsizetype(0);
        QTest::newRow("beyond U+10FFFF") << QByteArray("\xf4\x90\x80\x80") << qsizetype(0);
    }
    void utf8()
    {
        QFETCH(QByteArray, text);
        QFETCH(qsizetype, bad);
        const auto found = findInvalidUtf8({text.constData(), static_cast<std::size_t>(text.size())});
        QCOMPARE(found == std::string_view::npos ? qsizetype(-1) : static_cast<qsizetype>(found), bad);
    }
};

TOUCHDOWN_TEST(TestQuotation)

} // namespace test_quotation

#include "test_quotation.moc"
