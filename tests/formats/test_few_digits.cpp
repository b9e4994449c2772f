// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/units.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_few_digits {

class TestFewDigits : public QObject {
    Q_OBJECT

private slots:
    void texts_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("text");
        QTest::newRow("length") << 7.4223e-14 << "nm"
                                << "7.4e-5 nm";
        QTest::newRow("ratio") << 114321.0 << ""
                               << "110000";
        QTest::newRow("below one") << 0.0123 << ""
                                   << "0.012";
        QTest::newRow("rounds up a place") << 9.96 << ""
                                           << "10";
        QTest::newRow("nothing") << 0.0 << "nm"
                                 << "0 nm";
        QTest::newRow("negative") << -2.345e-9 << "nm"
                                  << "-2.3 nm";
    }
    void texts()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(fewDigits(value, unit.toStdString())), text);
    }

    void timesInTheUnitThatReadsBest()
    {
        QCOMPARE(fewDigitsOfTime(12.34), std::string("12 s"));
        QCOMPARE(fewDigitsOfTime(9.448e-3), std::string("9.4 ms"));
        QCOMPARE(fewDigitsOfTime(8.7e-4, 3), std::string("870 us"));
        QCOMPARE(fewDigitsOfTime(1e-8), std::string("10 ns"));
    }
};

TOUCHDOWN_TEST(TestFewDigits)

} // namespace test_few_digits

#include "test_few_digits.moc"
