// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_points.h"

#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_series_points {

constexpr double degree = std::numbers::pi / 180.0;

class TestSeriesPoints : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        case_ = sampleFilmCase();
        case_.disk.radius = 20e-3;
        case_.disk.skew = 8.0 * degree;
        case_.disk.speed = 500.0;
    }
    void aboutTheCase();
    void listsGiveTheEnds();
    void evenSteps();
    void skewFollowsTheRadius();
    void listsAsTheyAre();
    void staysWithinTheRanges();
    void axisAndNames();

private:
    Case case_;
};

void TestSeriesPoints::aboutTheCase()
{
    const SeriesChoice radius = usualChoice(case_, Varied::Radius);
    QCOMPARE(radius.from, 10e-3);
    QCOMPARE(radius.to, 30e-3);
    QCOMPARE(radius.skewFrom, 8.0 * degree);
    QCOMPARE(radius.skewTo, 8.0 * degree);
    QCOMPARE(usualChoice(case_, Varied::Skew).from, -2.0 * degree);
    QCOMPARE(usualChoice(case_, Varied::Skew).to, 18.0 * degree);
    QCOMPARE(usualChoice(case_, Varied::Speed).from, 250.0);
    QCOMPARE(usualChoice(case_, Varied::Speed).to, 750.0);
    QCOMPARE(usualChoice(case_, Varied::Altitude).from, 0.0);
    QCOMPARE(usualChoice(case_, Varied::Altitude).to, 3000.0);
}

void TestSeriesPoints::listsGiveTheEnds()
{
    case_.steady.radii = {30e-3, 15e-3, 22e-3};
    case_.steady.skews = {12.0 * degree, -5.0 * degree, 3.0 * degree};
    case_.steady.speeds = {400.0, 600.0};
    const SeriesChoice radius = usualChoice(case_, Varied::Radius);
    QCOMPARE(radius.from, 15e-3);
    QCOMPARE(radius.to, 30e-3);
    QCOMPARE(radius.skewFrom, -5.0 * degree);
    QCOMPARE(radius.skewTo, 12.0 * degree);
    QCOMPARE(usualChoice(case_, Varied::Speed).to, 600.0);
}

void TestSeriesPoints::evenSteps()
{
    const auto speeds = pointsOf(case_, {.varied = Varied::Speed, .from = 100.0, .to = 500.0, .states = 5});
    QCOMPARE(speeds.size(), std::size_t(5));
    for (std::size_t i = 0; i < 5; ++i) {
        QCOMPARE(speeds[i].speed, 100.0 * static_cast<double>(i + 1));
        QCOMPARE(speeds[i].radius, case_.disk.radius);
        QCOMPARE(speeds[i].skew, case_.disk.skew);
        QVERIFY(!speeds[i].altitude);
    }
    const auto altitudes = pointsOf(case_, {.varied = Varied::Altitude, .from = 0.0, .to = 1000.0, .states = 2});
    QCOMPARE(*altitudes.front().altitude, 0.0);
    QCOMPARE(*altitudes.back().altitude, 1000.0);
    // The middle of the usual series is the case itself.
    QCOMPARE(pointsOf(case_, usualChoice(case_, Varied::Radius))[4].radius, case_.disk.radius);
}

void TestSeriesPoints::skewFollowsTheRadius()
{
    const auto points = pointsOf(case_, {Varied::Radius, 10e-3, 30e-3, -0.1, 0.3, 3});
    QCOMPARE(points[1].radius, 20e-3);
    QVERIFY(std::abs(points[1].skew - 0.1) < 1e-15);
    QCOMPARE(points[2].skew, 0.3);
}

void TestSeriesPoints::listsAsTheyAre()
{
    QVERIFY(!hasLists(case_));
    case_.steady.radii = {15e-3, 30e-3};
    case_.steady.speeds = {400.0, 600.0, 800.0};
    QVERIFY(hasLists(case_));
    const auto points = pointsOf(case_, usualChoice(case_, Varied::Lists));
    QCOMPARE(points.size(), std::size_t(6));
    QCOMPARE(points[2].speed, 600.0);
    QCOMPARE(points[3].radius, 30e-3);
}

/// disk.radius is at most 1 m.
void TestSeriesPoints::staysWithinTheRanges()
{
    case_.disk.radius = 0.9;
    QCOMPARE(usualChoice(case_, Varied::Radius).to, 1.0);
}

void TestSeriesPoints::axisAndNames()
{
    case_.steady.radii = {15e-3, 30e-3};
    case_.steady.skews = {0.0, 0.1};
    case_.steady.speeds = {100.0 * std::numbers::pi, 200.0 * std::numbers::pi}; // 3000 and 6000 rpm
    const auto points = seriesOf(case_);
    QCOMPARE(axisOf(points), Varied::Radius);
    QCOMPARE(curveName(points.front(), points), QString::fromUtf8("3000\u00A0rpm"));
    QCOMPARE(curveName(points.back(), points), QString::fromUtf8("6000\u00A0rpm"));
    case_.steady.radii.clear();
    case_.steady.skews.clear();
    const auto speeds = seriesOf(case_);
    QCOMPARE(axisOf(speeds), Varied::Speed);
    QVERIFY(curveName(speeds.back(), speeds).isEmpty());
    QCOMPARE(valueOf(speeds.back(), Varied::Speed), 200.0 * std::numbers::pi);
    QCOMPARE(axisOf(pointsOf(case_, usualChoice(case_, Varied::Skew))), Varied::Skew);
    QCOMPARE(axisOf(pointsOf(case_, usualChoice(case_, Varied::Altitude))), Varied::Altitude);
    for (const Varied varied : {Varied::Radius, Varied::Skew, Varied::Speed, Varied::Altitude})
        QVERIFY(!quantityOf(varied).displayUnit.empty());
}

TOUCHDOWN_TEST(TestSeriesPoints)

} // namespace test_series_points

#include "test_series_points.moc"
