// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_axis.h"

#include <cmath>
#include <random>

#include <QLocale>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/style/quantity_format.h"

using namespace touchdown;

namespace test_plot_axis {

const QString minus(QChar(0x2212));

QStringList texts(const PlotAxis& axis, int most)
{
    QStringList texts;
    for (const AxisTick& tick : axis.ticks(most))
        if (tick.major) texts += tick.text;
    return texts;
}

class TestPlotAxis : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void ticksAreRoundNumbers_data();
    void ticksAreRoundNumbers();
    void everyAxisHasTwoNumbers();
    void farZoomKeepsNumbersShort();
    void titleHoldsUnitAndPower();
    void readingKeepsFourDigits();
    void frequenciesAboveAMegahertz();
    void decimalComma();
    void logarithmicPositions();
    void rangesThatCannotBeDrawn();
    void autoscaleHolds();
    void autoscaleOfFlatData();
    void autoscaleOnLogarithmicAxis();
};

void TestPlotAxis::ticksAreRoundNumbers_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<double>("factor");
    QTest::addColumn<bool>("logarithmic");
    QTest::addColumn<int>("most");
    QTest::addColumn<QStringList>("expected");
    QTest::addRow("spacing in nm") << 0.0 << 250e-9 << 1e-9 << false << 6
                                   << QStringList{"0", "50", "100", "150", "200", "250"};
    QTest::addRow("about zero") << -1e-3 << 1e-3 << 1e-3 << false << 5
                                << QStringList{minus + "1.0", minus + "0.5", "0.0", "0.5", "1.0"};
    QTest::addRow("range between ticks") << 6.95e-9 << 7.051e-9 << 1e-9 << false << 4
                                         << QStringList{"6.95", "7.00", "7.05"};
    // Steps of 5 would leave 10 alone.
    QTest::addRow("at least two numbers")
        << 5.5e-9 << 14e-9 << 1e-9 << false << 3 << QStringList{"6", "8", "10", "12", "14"};
    QTest::addRow("powers of ten") << 1e-9 << 1e-5 << 1.0 << true << 9
                                   << QStringList{"10\u207b\u2079", "10\u207b\u2078", "10\u207b\u2077",
                                                  "10\u207b\u2076", "10\u207b\u2075"};
    QTest::addRow("frequency in kHz") << 1e3 << 1e6 << 1e3 << true << 6 << QStringList{"1", "10", "100", "1000"};
}

void TestPlotAxis::ticksAreRoundNumbers()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(double, factor);
    QFETCH(bool, logarithmic);
    QFETCH(int, most);
    QFETCH(QStringList, expected);
    PlotAxis axis;
    axis.label = {"y", "u", factor, logarithmic ? AxisScale::Logarithmic : AxisScale::Linear};
    axis.setRange({low, high});
    QCOMPARE(texts(axis, most), expected);
}

// 1.25 ms with a window of 1 ns: the numbers would need 7 decimals. They count from a round offset instead, which the
// title names.
void TestPlotAxis::everyAxisHasTwoNumbers()
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> exponent(-12.0, 12.0), wide(-6.0, 8.0);
    for (int draw = 0; draw < 4000; ++draw) {
        PlotAxis axis;
        const bool logarithmic = draw % 2 == 1;
        axis.label = {"", "nm", 1e-9, logarithmic ? AxisScale::Logarithmic : AxisScale::Linear};
        const double low = (draw % 4 == 2 ? -1.0 : 1.0) * std::pow(10.0, exponent(generator));
        axis.setRange({low, low + std::abs(low) * std::pow(10.0, wide(generator))});
        for (const int most : {1, 2, 3, 5, 9})
            QVERIFY2(
                texts(axis, most).size() >= 2,
                qPrintable(
                    QStringLiteral("%1 to %2, at most %3").arg(axis.range().low).arg(axis.range().high).arg(most)));
    }
}

void TestPlotAxis::farZoomKeepsNumbersShort()
{
    PlotAxis axis;
    axis.label = {"Time", "ms", 1e-3, AxisScale::Linear};
    axis.setRange({1.25e-3, 1.25e-3 + 1e-9});
    const QStringList shown = texts(axis, 6);
    QVERIFY(shown.size() >= 4);
    for (const QString& text : shown) QVERIFY2(text.size() <= 9, qPrintable(text));
    QCOMPARE(axis.text(), QStringLiteral("Time %1 1.250000 [ms]").arg(minus));
}

// A range of 300 nm resolves 0.3 nm with one decimal; a rest of 3.837 nm on it is read with four digits, a rounding
// error as zero.
void TestPlotAxis::readingKeepsFourDigits()
{
    PlotAxis axis;
    axis.label = {"Minimum spacing", "nm", 1e-9, AxisScale::Linear};
    axis.setRange({-50e-9, 250e-9});
    QCOMPARE(axis.reading(3.8369e-9), QStringLiteral("3.837"));
    QCOMPARE(axis.reading(123.456e-9), QStringLiteral("123.5"));
    QCOMPARE(axis.reading(0.012345e-9), QStringLiteral("0.0123"));
    QCOMPARE(axis.reading(1e-20).toDouble(), 0.0);
}

void TestPlotAxis::titleHoldsUnitAndPower()
{
    PlotAxis axis;
    axis.label = {"Energy", "J", 1.0, AxisScale::Linear};
    axis.setRange({0.0, 4e-10}); // a common power of 1e-12 gives 0 to 400
    QCOMPARE(axis.text(), QStringLiteral("Energy [10\u207b\u00b9\u00b2 J]"));
    QCOMPARE(texts(axis, 6).last(), QStringLiteral("400"));
    axis.label.factor = 1e-9;
    axis.label.unit = "nJ";
    QCOMPARE(axis.text(), QStringLiteral("Energy [nJ]"));
    axis.label = {"Time", "ms", 1e-3, AxisScale::Linear};
    axis.setRange({0.0, 8e-6}); // 8 us: no power before a unit that has a prefix
    QCOMPARE(axis.text(), QStringLiteral("Time [\u00b5s]"));
    QCOMPARE(texts(axis, 6).last(), QStringLiteral("8"));
    axis.label = {"Density", "ms\u00b2/Hz", 1e-6, AxisScale::Linear};
    axis.setRange({0.0, 8e-9}); // 0.008 of a unit whose prefix stands under a square
    QCOMPARE(axis.text(), QStringLiteral("Density [10\u207b\u00b3 ms\u00b2/Hz]"));
    axis.label = {"", "", 1.0, AxisScale::Linear};
    axis.setRange({0.0, 1.0});
    QCOMPARE(axis.text(), QString());
}

void TestPlotAxis::frequenciesAboveAMegahertz()
{
    PlotAxis axis;
    axis.label = {"Frequency", "kHz", 1e3, AxisScale::Linear};
    axis.setRange({0.0, 1e6});
    QCOMPARE(axis.text(), QStringLiteral("Frequency [kHz]"));
    QCOMPARE(axis.ticks(6).back().text, QStringLiteral("1000"));
    axis.setRange({0.0, 5e6});
    QCOMPARE(axis.text(), QStringLiteral("Frequency [MHz]"));
    QCOMPARE(axis.ticks(6).back().text, QStringLiteral("5"));
    // Other units keep theirs.
    axis.label = {"Height", "nm", 1e-9, AxisScale::Linear};
    axis.setRange({0.0, 5e-6});
    QCOMPARE(axis.text(), QStringLiteral("Height [nm]"));
}

void TestPlotAxis::decimalComma()
{
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const QString text = typeset(-1234.5, 2);
    QLocale::setDefault(QLocale::c());
    QCOMPARE(text, minus + QStringLiteral("1234,50"));
    QCOMPARE(typeset(-0.001, 2), QStringLiteral("0.00"));
}

void TestPlotAxis::logarithmicPositions()
{
    PlotAxis axis;
    axis.label.scale = AxisScale::Logarithmic;
    axis.setRange({1e-4, 1.0});
    QCOMPARE(axis.position(1e-4), 0.0);
    QCOMPARE(axis.position(1e-2), 0.5);
    QCOMPARE(axis.valueAt(0.25), 1e-3);
    for (const double bad : {0.0, -1.0, std::nan("")}) { // finite, and far below the picture
        QVERIFY(std::isfinite(axis.position(bad)));
        QVERIFY(axis.position(bad) < -1000.0);
    }
}

void TestPlotAxis::rangesThatCannotBeDrawn()
{
    PlotAxis axis;
    axis.setRange({3.0, 1.0});
    QCOMPARE(axis.range(), (PlotRange{1.0, 3.0}));
    axis.setRange({std::nan(""), 1.0});
    QCOMPARE(axis.range(), (PlotRange{1.0, 3.0}));
    axis.setRange({5.0, 5.0});
    QVERIFY(axis.range().width() > 0.0);
    QVERIFY(axis.range().contains(5.0));
    axis.label.scale = AxisScale::Logarithmic;
    axis.setRange({-1.0, 10.0});
    QVERIFY(axis.range().low > 0.0);
    QCOMPARE(axis.range().high, 10.0);
}

void TestPlotAxis::autoscaleHolds()
{
    const PlotRange first = autoscaled({0.0, 10.0}, {0.0, 0.0}, AxisScale::Linear, 1.0);
    QVERIFY(first.low < 0.0 && first.high > 10.0);
    QVERIFY(first.width() < 13.0);
    QCOMPARE(autoscaled({1.0, 9.0}, first, AxisScale::Linear, 1.0), first);         // 8 of some 12 are still in use
    QVERIFY(autoscaled({4.0, 5.0}, first, AxisScale::Linear, 1.0) != first);        // too little is
    const PlotRange grown = autoscaled({0.0, 14.0}, first, AxisScale::Linear, 1.0); // it no longer fits
    QVERIFY(grown.contains(14.0));
}

void TestPlotAxis::autoscaleOfFlatData()
{
    const PlotRange zero = autoscaled({0.0, 0.0}, {0.0, 0.0}, AxisScale::Linear, 1e-3);
    QVERIFY(zero.contains(0.0));
    QVERIFY(zero.width() > 1e-3 && zero.width() < 2e-3); // about one display unit
    const PlotRange steady = autoscaled({7e-9, 7e-9 * (1.0 + 1e-15)}, {0.0, 0.0}, AxisScale::Linear, 1e-9);
    QVERIFY(steady.width() >= 7e-15); // rounding errors do not fill the picture
    QVERIFY(steady.contains(7e-9));
}

void TestPlotAxis::autoscaleOnLogarithmicAxis()
{
    const PlotRange range = autoscaled({1e-12, 1e-6}, {0.0, 0.0}, AxisScale::Logarithmic, 1.0);
    QVERIFY(range.low > 0.0 && range.low < 1e-12 && range.high > 1e-6);
    const PlotRange withZero = autoscaled({0.0, 1.0}, {0.0, 0.0}, AxisScale::Logarithmic, 1.0);
    QVERIFY(withZero.low > 0.0 && withZero.low < 1.1e-6); // six decades below the largest
    const PlotRange nothing = autoscaled({-2.0, -1.0}, {0.0, 0.0}, AxisScale::Logarithmic, 1e-9);
    QVERIFY(nothing.low > 0.0 && nothing.high > nothing.low);
}

TOUCHDOWN_TEST(TestPlotAxis)

} // namespace test_plot_axis

#include "test_plot_axis.moc"
