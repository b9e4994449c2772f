// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/rail_drawing.h"

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_rail_drawing {

class TestRailDrawing : public QObject {
    Q_OBJECT

private slots:
    void laterRailsLieOnTop_data();
    void laterRailsLieOnTop();
    void numbersStandInsideAndUncovered();
    void aCoveredRailIsNumberedAllTheSame();
    void levelsAreThoseOfTopsAndBase();
    void rampsCountWithAllTheirPoints();
    void tooManyLevelsLoseTheNearest();
};

void TestRailDrawing::laterRailsLieOnTop_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<int>("rail"); // -1: base
    QTest::newRow("shelf") << 0.10e-3 << 0.35e-3 << 0;
    QTest::newRow("pad on the shelf") << 0.30e-3 << 0.35e-3 << 1;
    QTest::newRow("rear pad") << 0.80e-3 << 0.35e-3 << 3;
    QTest::newRow("beside the rear pad's point") << 0.71e-3 << 0.40e-3 << 2;
    QTest::newRow("base between the rails") << 0.50e-3 << 0.35e-3 << -1;
}

void TestRailDrawing::laterRailsLieOnTop()
{
    QFETCH(const double, x);
    QFETCH(const double, y);
    QFETCH(const int, rail);
    const auto found = railAt(sampleSurface(), {x, y});
    QCOMPARE(found ? static_cast<int>(*found) : -1, rail);
}

void TestRailDrawing::numbersStandInsideAndUncovered()
{
    const AirBearingSurface surface = sampleSurface();
    const auto points = railNumberPoints(surface);
    QCOMPARE(points.size(), surface.rails.size());
    // The rail that is seen where its number stands is the rail itself.
    for (std::size_t i = 0; i < points.size(); ++i) QCOMPARE(railAt(surface, points[i]), std::optional(i));
}

void TestRailDrawing::aCoveredRailIsNumberedAllTheSame()
{
    AirBearingSurface surface = sampleSurface();
    surface.rails.push_back(surface.rails[1]); // the same outline again
    const auto points = railNumberPoints(surface);
    QVERIFY(railPolygon(surface.rails[1]).containsPoint({points[1].x, points[1].y}, Qt::OddEvenFill));
}

void TestRailDrawing::levelsAreThoseOfTopsAndBase()
{
    QCOMPARE(recessLevels(sampleSurface()), (std::vector<double>{0.0, 150e-9, 1.5e-6}));
    AirBearingSurface empty; // its base has the colour of a base
    empty.baseRecess = 2e-6;
    QCOMPARE(recessLevels(empty), (std::vector<double>{0.0, 2e-6}));
}

void TestRailDrawing::rampsCountWithAllTheirPoints()
{
    AirBearingSurface surface;
    surface.baseRecess = 2e-6;
    surface.rails = {{RailKind::Ramp, {{0, 0, 0}, {1e-4, 0, 0}, {1e-4, 1e-4, 0}}, {50e-9, 20e-9, 20e-9}}};
    QCOMPARE(recessLevels(surface), (std::vector<double>{20e-9, 50e-9, 2e-6}));
    surface.rails[0].kind = RailKind::Step; // only the first counts
    QCOMPARE(recessLevels(surface), (std::vector<double>{50e-9, 2e-6}));
}

void TestRailDrawing::tooManyLevelsLoseTheNearest()
{
    AirBearingSurface surface;
    surface.baseRecess = 1e-6;
    for (const double recess : {0.0, 100e-9, 101e-9, 300e-9, 304e-9})
        surface.rails.push_back({RailKind::Step, {{0, 0, 0}, {1e-4, 0, 0}, {1e-4, 1e-4, 0}}, {recess, 0.0, 0.0}});
    // 101 is nearest to its neighbour below, then 304.
    QCOMPARE(recessLevels(surface, 4), (std::vector<double>{0.0, 100e-9, 300e-9, 1e-6}));
    QCOMPARE(recessLevels(surface, 2), (std::vector<double>{0.0, 1e-6}));
}

TOUCHDOWN_TEST(TestRailDrawing)

} // namespace test_rail_drawing

#include "test_rail_drawing.moc"
