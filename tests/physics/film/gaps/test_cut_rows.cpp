// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gaps/cut_rows.h"

#include <cmath>

#include <QTest>

#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cut_rows {

constexpr double size = 0.3e-3;    // of a square slider [m]
constexpr double pitch = 140e-6;   // along the motion [rad]
constexpr double height = 4e-9;    // nominal, at the trailing edge [m]
constexpr double halfSide = 60e-6; // of a square rail in its middle [m]

/// A square rail, turned by an angle [rad] about the middle of the slider. Its wall falls by 1.5 um over this width,
/// then to 6 um over another 6 um. A rail of this recess above 0 is a shelf with a pad on it: as the wall begins at
/// recess 0, a narrow ridge runs along its edges.
AirBearingSurface turnedSurface(double angle, double wall, double shelf)
{
    AirBearingSurface surface;
    surface.baseRecess = 6e-6;
    surface.walls = {
        {.distance = {-0.1 * wall, 0.5 * wall, 0.9 * wall, 0.9 * wall + 6e-6}, .recess = {0.0, 0.75e-6, 1.5e-6, 6e-6}}};
    const double c = std::cos(angle), s = std::sin(angle);
    const auto addRail = [&](double from, double to, double side, double recess) {
        const auto corner = [&](double a, double b) {
            return RailPoint{0.5 * size + a * c - b * s, 0.5 * size + a * s + b * c, 1};
        };
        surface.rails.push_back(
            {.points = {corner(from, -side), corner(to, -side), corner(to, side), corner(from, side)},
             .recess = {recess}});
    };
    addRail(-halfSide, halfSide, halfSide, shelf);
    if (shelf > 0.0) addRail(-20e-6, 50e-6, 45e-6, 0.0);
    return surface;
}

double load(const AirBearingSurface& surface, int cells, double skew, const Attitude& attitude)
{
    FilmSetting setting;
    setting.disk = uniformMotion(15.0, skew);
    FilmProblem problem(surface, size, size, uniformGrid(size, size, cells, cells), setting, attitude);
    return problem.solve({.tolerance = 1e-7, .maximumIterations = 80}).converged ? problem.load() : std::nan("");
}

class TestCutRows : public QObject {
    Q_OBJECT

private slots:
    /// A turned rail on coarse grids along the motion, against a fine grid along its edges: there motion, pitch and
    /// roll are turned instead. The mean error of three grids with cells near 5 um is below 1 %. With the flow along a
    /// path taken for constant through slanted walls, and rows that pass a ridge by in the next path, it was -1.0,
    /// -0.7, 2.5, 3.2, 2.5 and 1.0 %.
    void turnedRails_data()
    {
        QTest::addColumn<double>("angle"); // [deg]
        QTest::addColumn<double>("wall");  // [m]
        QTest::addColumn<double>("shelf"); // [m]
        QTest::newRow("8 deg, 1 um") << 8.0 << 1e-6 << 0.0;
        QTest::newRow("70 deg, 1 um") << 70.0 << 1e-6 << 0.0;
        QTest::newRow("20 deg, 8 um") << 20.0 << 8e-6 << 0.0;
        QTest::newRow("5 deg, ridge") << 5.0 << 2e-6 << 0.21e-6;
        QTest::newRow("20 deg, ridge") << 20.0 << 2e-6 << 0.21e-6;
        QTest::newRow("75 deg, ridge") << 75.0 << 2e-6 << 0.21e-6;
    }
    void turnedRails()
    {
        QFETCH(const double, angle);
        QFETCH(const double, wall);
        QFETCH(const double, shelf);
        const double turn = angle * M_PI / 180.0;
        const Attitude turnedToo{height + 0.5 * pitch * size * (1.0 - std::cos(turn)), pitch * std::cos(turn),
                                 -pitch * std::sin(turn)};
        const double limit = load(turnedSurface(0.0, wall, shelf), 480, turn, turnedToo);
        double mean = 0.0; // [%]
        for (const int cells : {58, 61, 64})
            mean +=
                100.0 / 3.0 * (load(turnedSurface(turn, wall, shelf), cells, 0.0, {height, pitch, 0.0}) / limit - 1.0);
        QVERIFY2(std::abs(mean) < 1.0, qPrintable(QString::number(mean)));
    }
};

TOUCHDOWN_TEST(TestCutRows)

} // namespace test_cut_rows

#include "test_cut_rows.moc"
