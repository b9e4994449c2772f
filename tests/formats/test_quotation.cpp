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
