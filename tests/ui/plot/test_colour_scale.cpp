// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/colour_scale.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_colour_scale {

/// CIE lightness L* of an sRGB colour, 0 to 100 (IEC 61966-2-1, CIE 15).
double lightness(const QColor& colour)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const double y =
        0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : 24389.0 / 27.0 * y;
}

class TestColourScale : public QObject {
    Q_OBJECT

private slots:
    void sequentialMapsRiseInLightness_data();
    void sequentialMapsRiseInLightness();
    void divergingMapsAreEvenAboutTheirCentre_data();
    void divergingMapsAreEvenAboutTheirCentre();
    void linearIsEven();
    void logarithmicIsEvenInDecades();
    void zeroIsInTheMiddle();
    void weakPressuresShowOnALogarithm();
    void levelsStandAtEqualSteps();
    void beyondTheEndsTheEndsHold();
    void coloursAreTheMapsAtThePosition_data();
    void coloursAreTheMapsAtThePosition();
    void reversedSwapsTheColours();
    void ticksLieOnTheScale();
    void aFieldWithoutASpreadHasAScale();
};

void TestColourScale::sequentialMapsRiseInLightness_data()
{
    QTest::addColumn<ColourMap>("map");
    QTest::newRow("viridis") << ColourMap::Viridis;
    QTest::newRow("mako") << ColourMap::Mako;
}

// Who sees no hue still sees the order: lightness alone tells any two places a tenth of the map apart.
void TestColourScale::sequentialMapsRiseInLightness()
{
    QFETCH(const ColourMap, map);
    for (int i = 0; i < 100; ++i)
        QVERIFY2(lightness(mapColour(map, (i + 1) / 100.0)) > lightness(mapColour(map, i / 100.0)),
                 qPrintable(QString::number(i)));
    for (int i = 0; i < 10; ++i)
        QVERIFY(lightness(mapColour(map, (i + 1) / 10.0)) - lightness(mapColour(map, i / 10.0)) > 3.0);
}

void TestColourScale::divergingMapsAreEvenAboutTheirCentre_data()
{
    QTest::addColumn<ColourMap>("map");
    QTest::addColumn<bool>("darkCentre");
    QTest::newRow("on light") << ColourMap::DivergingOnLight << false;
    QTest::newRow("on dark") << ColourMap::DivergingOnDark << true;
}

void TestColourScale::divergingMapsAreEvenAboutTheirCentre()
{
    QFETCH(const ColourMap, map);
    QFETCH(const bool, darkCentre);
    const QColor centre = mapColour(map, 0.5);
    QVERIFY(centre.hsvSaturationF() < 0.02F);
    double before = lightness(centre);
    for (int i = 1; i <= 10; ++i) {
        const QColor low = mapColour(map, 0.5 - i / 20.0);
        const QColor high = mapColour(map, 0.5 + i / 20.0);
        // Equal in Oklab's lightness; CIE's differs by a few for such colours.
        QVERIFY2(std::abs(lightness(low) - lightness(high)) < 6.0,
                 qPrintable(QString::number(lightness(low) - lightness(high))));
        QVERIFY(darkCentre ? lightness(low) > before : lightness(low) < before);
        QVERIFY(low.blue() > low.red());
        QVERIFY(high.red() > high.blue());
        before = lightness(low);
    }
}

void TestColourScale::linearIsEven()
{
    const auto scale = ColourScale::linear(ColourMap::Viridis, -2.0, 6.0);
    QCOMPARE(scale.position(0.0), 0.25);
    QCOMPARE(scale.colour(6.0), mapColour(ColourMap::Viridis, 1.0).rgb());
}

void TestColourScale::logarithmicIsEvenInDecades()
{
    const auto scale = ColourScale::logarithmic(ColourMap::Viridis, 1e-9, 1e-5);
    QVERIFY(std::abs(scale.position(1e-8) - 0.25) < 1e-12);
    QVERIFY(std::abs(scale.position(1e-6) - 0.75) < 1e-12);
}

// -1 and +20 atm: half of the weak side is a quarter of the bar, and so is half of the strong one.
void TestColourScale::zeroIsInTheMiddle()
{
    const auto scale = ColourScale::aboutZero(ColourMap::DivergingOnLight, -1.0, 20.0);
    QCOMPARE(scale.position(0.0), 0.5);
    QCOMPARE(scale.position(-0.5), 0.25);
    QCOMPARE(scale.position(10.0), 0.75);
    // Nothing below zero: zero keeps its neutral colour.
    QCOMPARE(ColourScale::aboutZero(ColourMap::DivergingOnLight, 0.0, 4.0).position(0.0), 0.5);
}

// log(1 + 9) of log(1 + 999) is a third: 9 near, of 999 at the end, stands a third up the upper half.
void TestColourScale::weakPressuresShowOnALogarithm()
{
    const auto scale = ColourScale::aboutZeroLogarithmic(ColourMap::DivergingOnLight, -99e3, 999e3, 1e3);
    QCOMPARE(scale.position(0.0), 0.5);
    QVERIFY(std::abs(scale.position(9e3) - (0.5 + 0.5 / 3.0)) < 1e-12);
    QVERIFY(std::abs(scale.position(-9e3) - 0.25) < 1e-12); // log 10 of log 100
    QCOMPARE(scale.position(999e3), 1.0);
    QCOMPARE(scale.position(-2e5), 0.0);
    QStringList numbers;
    for (const ScaleTick& tick : scale.ticks(1e3, 9)) numbers << tick.text;
    QCOMPARE(numbers, (QStringList{"0", "1", "10", "100", QStringLiteral("−1"), QStringLiteral("−10")}));
}

void TestColourScale::levelsStandAtEqualSteps()
{
    const auto scale = ColourScale::throughLevels(ColourMap::Mako, {0.0, 20e-9, 100e-9, 1600e-9});
    QVERIFY(std::abs(scale.position(20e-9) - 1.0 / 3.0) < 1e-12);
    QVERIFY(std::abs(scale.position(60e-9) - 0.5) < 1e-12);
    QVERIFY(std::abs(scale.position(850e-9) - 5.0 / 6.0) < 1e-12);
    QCOMPARE(scale.ticks(1e-9, 2).size(), std::size_t(4));
}

void TestColourScale::beyondTheEndsTheEndsHold()
{
    const auto scale = ColourScale::throughLevels(ColourMap::Mako, {1.0, 2.0, 3.0});
    QCOMPARE(scale.position(-5.0), 0.0);
    QCOMPARE(scale.position(7.0), 1.0);
    QCOMPARE(scale.position(std::nan("")), 0.0);
}

void TestColourScale::coloursAreTheMapsAtThePosition_data()
{
    QTest::addColumn<double>("value");
    for (const double value : {-0.9, -0.2, 0.0, 0.3, 11.0, 19.5})
        QTest::newRow(qPrintable(QString::number(value))) << value;
}

void TestColourScale::coloursAreTheMapsAtThePosition()
{
    QFETCH(const double, value);
    // The colour is the map's at the value's position, to one step of 512.
    const auto scale = ColourScale::aboutZero(ColourMap::DivergingOnDark, -1.0, 20.0);
    const double expected = value < 0.0 ? 0.5 * (1.0 + value) : 0.5 + 0.5 * value / 20.0;
    QVERIFY(std::abs(scale.position(value) - expected) < 1e-12);
    const QColor colour = QColor::fromRgb(scale.colour(value));
    const QColor exact = mapColour(ColourMap::DivergingOnDark, expected);
    QVERIFY(std::abs(colour.red() - exact.red()) <= 2 && std::abs(colour.green() - exact.green()) <= 2 &&
            std::abs(colour.blue() - exact.blue()) <= 2);
}

void TestColourScale::reversedSwapsTheColours()
{
    const auto scale = ColourScale::linear(ColourMap::Viridis, 0.0, 1.0);
    const auto reversed = scale.reversed();
    QCOMPARE(reversed.colour(0.0), scale.colour(1.0));
    QCOMPARE(reversed.position(0.2), scale.position(0.2));
    QCOMPARE(reversed.reversed().colour(0.3), scale.colour(0.3));
}

void TestColourScale::ticksLieOnTheScale()
{
    for (const auto& scale :
         {ColourScale::linear(ColourMap::Viridis, 0.0, 7e5), ColourScale::logarithmic(ColourMap::Viridis, 2e-9, 3e-6),
          ColourScale::aboutZero(ColourMap::DivergingOnLight, -9e4, 2e6)}) {
        const auto ticks = scale.ticks(scale.isLogarithmic() ? 1e-9 : 1e3, 8);
        QVERIFY(ticks.size() >= 3);
        for (const ScaleTick& tick : ticks) {
            QVERIFY(tick.position >= 0.0 && tick.position <= 1.0);
            QVERIFY(!tick.text.isEmpty());
        }
    }
    // 100 kPa of 0 to 700 lies at a seventh.
    bool found = false;
    for (const ScaleTick& tick : ColourScale::linear(ColourMap::Viridis, 0.0, 7e5).ticks(1e3, 8))
        if (tick.text == QStringLiteral("100")) found = std::abs(tick.position - 1.0 / 7.0) < 1e-9;
    QVERIFY(found);
}

void TestColourScale::aFieldWithoutASpreadHasAScale()
{
    for (const auto& scale :
         {ColourScale::linear(ColourMap::Viridis, 5.0, 5.0), ColourScale::linear(ColourMap::Viridis, 0.0, 0.0),
          ColourScale::logarithmic(ColourMap::Viridis, 5.0, 5.0),
          ColourScale::aboutZero(ColourMap::DivergingOnLight, 0.0, 0.0),
          ColourScale::throughLevels(ColourMap::Mako, {0.0})}) {
        QVERIFY(scale.high() > scale.low());
        QVERIFY(std::isfinite(scale.position(scale.low())));
    }
}

TOUCHDOWN_TEST(TestColourScale)

} // namespace test_colour_scale

#include "test_colour_scale.moc"
