// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/cut_rows.h"

#include <cmath>
#include <utility>

#include <QTest>

#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cut_rows {

constexpr double length = 0.4e-3, width = 0.3e-3; // of the slider [m]

/// A rectangle about (x, y), turned by an angle [rad]; all its edges have this wall.
Rail turned(double x, double y, double from, double to, double halfWidth, double angle, double recess, int wall)
{
    const double c = std::cos(angle), s = std::sin(angle);
    const auto corner = [&](double a, double b) { return RailPoint{x + a * c - b * s, y + a * s + b * c, wall}; };
    return {
        .points = {corner(from, -halfWidth), corner(to, -halfWidth), corner(to, halfWidth), corner(from, halfWidth)},
        .recess = {recess}};
}

double load(const AirBearingSurface& surface, int nx, int ny)
{
    FilmSetting setting;
    setting.disk = uniformMotion(15.0, 0.0);
    FilmProblem problem(surface, length, width, uniformGrid(length, width, nx, ny), setting, {14e-9, 140e-6, 0.0});
    return problem.solve({.tolerance = 1e-7, .maximumIterations = 80}).converged ? problem.load() : std::nan("");
}

/// How far a grid of these cells is from one of a sixth of their size, in per cent of the load.
double error(const AirBearingSurface& surface, int nx, int ny)
{
    return 100.0 * (load(surface, nx, ny) / load(surface, 6 * nx, 6 * ny) - 1.0);
}

class TestCutRows : public QObject {
    Q_OBJECT

private slots:
    /// A rail turned by 20 degrees: the mean error of three coarse grids, with cells of 6 to 7 um, is below 0.35 %.
    /// With the flow along a path taken for constant through a slanted wall of 4 um it was 1.5 %.
    void slantedWalls_data()
    {
        QTest::addColumn<double>("wall"); // [m]
        QTest::newRow("vertical") << 0.1e-6;
        QTest::newRow("1 um") << 1e-6;
        QTest::newRow("4 um") << 4e-6;
    }
    void slantedWalls()
    {
        QFETCH(const double, wall);
        AirBearingSurface surface;
        surface.baseRecess = 1.5e-6;
        surface.walls = {{.distance = {0.0, wall}, .recess = {0.0, 1.5e-6}}};
        surface.rails = {turned(0.19e-3, 0.15e-3, -0.13e-3, 0.13e-3, 0.09e-3, M_PI / 9.0, 0.0, 1)};
        const double mean = (error(surface, 60, 45) + error(surface, 64, 48) + error(surface, 69, 53)) / 3.0;
        QVERIFY2(std::abs(mean) < 0.35, qPrintable(QString::number(mean)));
    }

    /// A step with a ridge along its edges, some 0.5 um wide, turned by 15 degrees: where the rows of a face passed the
    /// ridge by, in the next path, the load was 5 % off.
    void slantedRidge()
    {
        AirBearingSurface surface;
        surface.baseRecess = 1.5e-6;
        surface.walls = {{.distance = {0.0, 4e-6}, .recess = {0.0, 1.5e-6}},
                         {.distance = {0.0, 4e-6}, .recess = {0.0, 0.21e-6}}};
        surface.rails = {turned(0.2e-3, 0.15e-3, -0.15e-3, 0.15e-3, 0.11e-3, M_PI / 12.0, 0.21e-6, 1),
                         turned(0.2e-3, 0.15e-3, -0.05e-3, 0.13e-3, 0.08e-3, M_PI / 12.0, 0.0, 2)};
        for (const auto& [nx, ny] : {std::pair{64, 48}, {69, 53}}) {
            const double found = error(surface, nx, ny);
            QVERIFY2(std::abs(found) < 0.8, qPrintable(QString::number(found)));
        }
    }
};

TOUCHDOWN_TEST(TestCutRows)

} // namespace test_cut_rows

#include "test_cut_rows.moc"
