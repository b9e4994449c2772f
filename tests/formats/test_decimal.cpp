// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/decimal.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_decimal {

class TestDecimal : public QObject {
    Q_OBJECT

private slots:
    /// 7 * 1e-9 is one unit in the last place above the double nearest to 7e-9; a shifted exponent is not.
    void aShiftRoundsOnce()
    {
        QVERIFY(readDecimal("7", -9).value() == 7e-9);
        QVERIFY(7.0 * 1e-9 != 7e-9);
        QVERIFY(readDecimal("1.25e+3", 6).value() == 1.25e9);
        QVERIFY(readDecimal("-.5E-2", 2).value() == -0.5);
    }
    void whatIsNoNumberIsRefused()
    {
        for (const char* text : {"1e400", "1e99999999999", "1e", "x", "1e10001"})
            QVERIFY2(!readDecimal(text).has_value(), text);
    }
    void text_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("decade");
        QTest::addColumn<QString>("expected");
        QTest::newRow("whole") << 7.0 << 0 << "7";
        QTest::newRow("tens") << 120.0 << 0 << "120";
        QTest::newRow("fraction") << 0.25 << 0 << "0.25";
        QTest::newRow("both") << 12.5 << 0 << "12.5";
        QTest::newRow("shifted up") << 7e-9 << 9 << "7";
        QTest::newRow("shifted down") << 7.0 << -3 << "0.007";
        QTest::newRow("large") << 1.35e6 << 0 << "1.35e6";
        QTest::newRow("largest without exponent") << 999999.0 << 0 << "999999";
        QTest::newRow("small") << 1e-5 << 0 << "1e-5";
        QTest::newRow("negative") << -0.5 << 0 << "-0.5";
        QTest::newRow("zero") << 0.0 << 5 << "0";
        QTest::newRow("all digits") << 0.1 + 0.2 << 0 << "0.30000000000000004";
    }
    void text()
    {
        QFETCH(double, value);
        QFETCH(int, decade);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(decimalText(value, decade)), expected);
    }
    void digitsCanBeChosen()
    {
        QCOMPARE(decimalText(105.99999999999998e-9, 9, 4), std::string("106"));
        QCOMPARE(decimalText(2.0 / 3.0, 0, 3), std::string("0.667"));
    }
};

TOUCHDOWN_TEST(TestDecimal)

} // namespace test_decimal

#include "test_decimal.moc"
