// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/physics/film/gas_film.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/allocation_count.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"
#include "tests/support/wide_slider.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_gas_film_load {

constexpr double gramForce = 9.80665e-3; // [N]

/// The infinitely wide slider with h1/h0 = 2, Kn0 and bearing number given, as the middle one of three rows a thousand
/// kilometres wide: its neighbours and the outline are too far for any flow across. W = int (p/p0 - 1) dX.
double wideLoad(double bearingNumber, double knudsen, SlipModel model, ConvectionScheme scheme, int cells)
{
    constexpr double L = 1e-3;
    const Air air{};
    const double h0 = air.meanFreePath / knudsen;
    const double speed = bearingNumber * air.pressure * h0 * h0 / (6.0 * air.viscosity * L);
    CellGrid grid;
    grid.y = {0.0, 1e6, 2e6, 3e6};
    for (int i = 0; i <= cells; ++i) grid.x.push_back(L * (1.0 - std::pow(1.0 - static_cast<double>(i) / cells, 1.6)));
    FilmProblem problem(planeSurface(), L, 3e6, grid, {air, {.model = model}, uniformMotion(speed), scheme},
                        {h0, h0 / L, 0.0});
    if (!problem.solve({.tolerance = 1e-10}).converged) return std::nan("");
    double sum = 0.0;
    for (int i = 0; i < cells; ++i) sum += (problem.at(i, 1) / air.pressure - 1.0) * problem.gaps.grid.widthX(i) / L;
    return sum;
}

/// The plane slider 1.25 x 1.0 mm of the reference: pitch 200 urad, trailing gap 100 nm, 15 m/s, the published fit.
constexpr double planeLength = 1.25e-3, planeWidth = 1e-3;
constexpr Attitude planeAttitude{100e-9, 200e-6, 0.0};

FilmSetting planeSetting()
{
    FilmSetting setting;
    setting.slip.model = SlipModel::FukuiKanekoFit;
    setting.disk = uniformMotion(15.0);
    return setting;
}

class TestGasFilmLoad : public QObject {
    Q_OBJECT

private slots:
    /// Published figures (five digits), and the independent solution of the ordinary equation. For Fukui-Kaneko the
    /// published ones, .17403 and .24276, hold for another table of kinetic values: theirs moves the load by 1e-4 of
    /// it.
    void wideSliders_data()
    {
        QTest::addColumn<SlipModel>("model");
        QTest::addColumn<double>("bearingNumber");
        QTest::addColumn<double>("knudsen");
        QTest::addColumn<double>("expected");
        QTest::newRow("continuum") << SlipModel::Continuum << 61.6 << 1.25 << 0.36045;
        QTest::newRow("first order") << SlipModel::FirstOrder << 61.6 << 1.25 << 0.22472;
        QTest::newRow("second order") << SlipModel::SecondOrder << 61.6 << 1.25 << 0.15387;
        QTest::newRow("1.5 order") << SlipModel::OnePointFiveOrder << 61.6 << 1.25 << 0.18834;
        QTest::newRow("Fukui-Kaneko") << SlipModel::FukuiKaneko << 61.6 << 1.25 << 0.17401;
        QTest::newRow("Fukui-Kaneko fit") << SlipModel::FukuiKanekoFit << 61.6 << 1.25 << 0.17395;
        QTest::newRow("new first order") << SlipModel::NewFirstOrder << 61.6 << 1.25 << 0.26710;
        QTest::newRow("new second order") << SlipModel::NewSecondOrder << 61.6 << 1.25 << 0.21765;
        QTest::newRow("Fukui-Kaneko, number 10") << SlipModel::FukuiKaneko << 10.0 << 1.25 << 0.03029;
        QTest::newRow("Fukui-Kaneko, number 100") << SlipModel::FukuiKaneko << 100.0 << 1.25 << 0.24274;
        QTest::newRow("Fukui-Kaneko, Kn 0.1") << SlipModel::FukuiKaneko << 10.0 << 0.1 << 0.15971;
    }
    void wideSliders()
    {
        QFETCH(SlipModel, model);
        QFETCH(double, bearingNumber);
        QFETCH(double, knudsen);
        QFETCH(double, expected);
        const double load = wideLoad(bearingNumber, knudsen, model, ConvectionScheme::CompleteFlux, 200);
        const auto mobility = [&](double w) { return w * flowFactor({.model = model}, knudsen / w); };
        const double reference = wideSlider(bearingNumber, mobility, 4000).load;
        QVERIFY2(std::abs(load / reference - 1.0) < 4e-5, qPrintable(QString::number(load / reference - 1.0)));
        QVERIFY2(std::abs(load - expected) < 2e-5, qPrintable(QString::number(load, 'f', 6)));
    }
    void wideSliderOrder()
    {
        const auto mobility = [](double w) { return w * flowFactor({.model = SlipModel::FirstOrder}, 1.25 / w); };
        const double reference = wideSlider(61.6, mobility, 4000).load;
        for (const ConvectionScheme scheme : {ConvectionScheme::Exponential, ConvectionScheme::CompleteFlux}) {
            const double coarse = wideLoad(61.6, 1.25, SlipModel::FirstOrder, scheme, 50) - reference;
            const double fine = wideLoad(61.6, 1.25, SlipModel::FirstOrder, scheme, 100) - reference;
            QVERIFY2(std::abs(std::log2(coarse / fine) - 2.0) < 0.15,
                     qPrintable(QString::number(std::log2(coarse / fine))));
        }
    }

    /// 8.2148 gf, centre at 0.73043 L, peak 2.3167 p0 above ambient (independent Newton solution, Richardson), on grids
    /// adapted from 48 x 48 cells: 0.02 % at 192 x 192, of second order on the way there.
    void planeSlider()
    {
        FilmProblem first(planeSurface(), planeLength, planeWidth, uniformGrid(planeLength, planeWidth, 48, 48),
                          planeSetting(), planeAttitude);
        QVERIFY(first.solve().converged);
        KnownFilm known = first.known();
        known.draggedGap = draggedGap(Air{}.viscosity, 15.0, planeLength, known.ambient);
        const auto load = [&](int n) {
            FilmProblem problem(planeSurface(), planeLength, planeWidth,
                                adaptedGrid(planeSurface(), planeLength, planeWidth, n, n, known), planeSetting(),
                                planeAttitude);
            if (!problem.solve().converged) return std::array{std::nan(""), 0.0, 0.0};
            const FilmForces forces = problem.loads.forces(problem.p);
            return std::array{forces.net / gramForce, 0.5 - forces.pitchTorque / forces.net / planeLength,
                              forces.maximumPressure / known.ambient - 1.0};
        };
        const auto coarse = load(48), middle = load(96), fine = load(192);
        QVERIFY2(std::abs(fine[0] / 8.2148 - 1.0) < 2e-4, qPrintable(QString::number(fine[0])));
        QVERIFY2(std::abs(fine[1] - 0.73043) < 3e-5, qPrintable(QString::number(fine[1])));
        QVERIFY2(std::abs(fine[2] / 2.3167 - 1.0) < 1e-3, qPrintable(QString::number(fine[2])));
        const double order = std::log2((coarse[0] - 8.2148) / (middle[0] - 8.2148));
        QVERIFY2(std::abs(order - 2.0) < 0.15, qPrintable(QString::number(order)));
    }

    /// Torques are about the centre: a pressure in one cell at (x, y).
    void torques()
    {
        const double L = 1e-3, W = 0.8e-3;
        FilmProblem problem(planeSurface(), L, W, uniformGrid(L, W, 10, 8), planeSetting(), planeAttitude);
        const std::array<double, 3> none = problem.loads.load(problem.p);
        for (const double force : none) QVERIFY(std::abs(force) < 1e-18);
        problem.p[problem.gaps.pad.at(7, 1)] += 2e5;
        const std::array<double, 3> load = problem.loads.load(problem.p);
        const double force = 2e5 * 1e-8;
        QVERIFY(std::abs(load[0] - force) < 1e-12 * force);
        QVERIFY(std::abs(load[1] + force * 0.25e-3) < 1e-12 * force * L); // behind the centre: nose down
        QVERIFY(std::abs(load[2] - force * 0.25e-3) < 1e-12 * force * W); // inside the centre: inner edge up
        const FilmForces forces = problem.loads.forces(problem.p);
        QVERIFY(std::abs(forces.maximumAt.x - 0.75e-3) < 1e-15 && std::abs(forces.maximumAt.y - 0.15e-3) < 1e-15);
        QVERIFY(std::abs(forces.centreOfPositive.x - 0.75e-3) < 1e-15);
        QCOMPARE(forces.negative, 0.0);
    }

    /// A level slider at ambient pressure: shear mu U/(h + 2 a lambda) on its area, 2 a = 3 with alpha = 0.8; skewed.
    void couetteShear()
    {
        const double L = 1e-3, W = 0.8e-3, h = 200e-9;
        FilmSetting setting;
        setting.slip = {.model = SlipModel::FirstOrder, .accommodation = 0.8};
        setting.disk = uniformMotion(12.0, 0.3);
        FilmProblem problem(planeSurface(), L, W, uniformGrid(L, W, 10, 8), setting, {h, 0.0, 0.0});
        const std::array<double, 2> shear = problem.loads.shear(problem.p);
        const double stress = 1.806e-5 * 12.0 / (h + 3.0 * 63.5e-9);
        QVERIFY(std::abs(shear[0] / (stress * L * W * std::cos(0.3)) - 1.0) < 1e-12);
        QVERIFY(std::abs(shear[1] / (-stress * L * W * std::sin(0.3)) - 1.0) < 1e-12);
    }

    /// Poiseuille -(h/2) dp/dx over a level slider is -(h/2) W times what the pressure gains from end to end: nothing
    /// between two ends at p0. On a pitched one, by parts, (1/2) int (p - p0) dh/dx = -(pitch/2) int (p - p0), where p
    /// is straight between centres and to the outline: of the outermost cells three quarters count.
    void poiseuilleShear()
    {
        const double L = 1e-3, W = 0.8e-3;
        FilmSetting setting;
        setting.disk = uniformMotion(0.0);
        for (const double pitch : {0.0, 150e-6}) {
            FilmProblem problem(planeSurface(), L, W, uniformGrid(L, W, 20, 8), setting, {100e-9, pitch, 0.0});
            const PaddedGrid& pad = problem.gaps.pad;
            double load = 0.0;
            for (int j = 0; j < 8; ++j)
                for (int i = 0; i < 20; ++i) {
                    const double above =
                        problem.film.ambient() * std::sin(0.15 * (i + 0.5)) * std::sin(0.39 * (j + 0.5));
                    problem.p[pad.at(i, j)] += above;
                    load += above * (i == 0 || i == 19 ? 0.75 : 1.0) * L / 20 * W / 8;
                }
            QVERIFY(std::abs(problem.loads.shear(problem.p)[0] + 0.5 * pitch * load) < 1e-11 * 100e-6 * load);
        }
    }

    void derivatives_data()
    {
        QTest::addColumn<double>("waves");
        QTest::newRow("flat disk") << 0.0;
        QTest::newRow("wavy disk") << 4e-9;
    }
    /// Derivatives of load and shear by pressures and attitude against central differences.
    void derivatives()
    {
        QFETCH(double, waves);
        const double L = 1e-3, W = 0.8e-3;
        AirBearingSurface surface;
        surface.baseRecess = 0.7e-6;
        surface.walls = {{.distance = {0.0, 40e-6}, .recess = {0.0, 0.7e-6}}};
        surface.rails = {
            {.points = {{0.13e-3, 0.11e-3, 1}, {0.88e-3, 0.17e-3, 1}, {0.81e-3, 0.61e-3, 0}, {0.2e-3, 0.5e-3, 0}},
             .recess = {0.0}}};
        FilmSetting setting;
        setting.disk = {.skew = 0.2};
        const Attitude attitude{30e-9, 120e-6, 4e-6};
        FilmProblem problem(surface, L, W, uniformGrid(L, W, 12, 9), setting, attitude);
        const PaddedGrid& pad = problem.gaps.pad;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) problem.p[pad.at(i, j)] *= 1.6 + std::sin(1.1 * i + 0.8 * j);
        std::vector<double> disk(pad.size());
        for (std::size_t at = 0; at < disk.size(); ++at) disk[at] = waves * std::sin(2.1 * static_cast<double>(at));
        if (waves > 0.0) problem.film.setSurface(disk);
        problem.film.setAttitude(attitude);
        FilmLoads::Derivatives exact;
        problem.loads.derivatives(problem.p, exact);
        const auto values = [&] {
            const std::array<double, 3> load = problem.loads.load(problem.p);
            const std::array<double, 2> shear = problem.loads.shear(problem.p);
            return std::array{load[0], load[1], load[2], shear[0], shear[1]};
        };
        const std::array<double, 5> now = values();
        for (std::size_t k = 0; k < 5; ++k) QVERIFY(std::abs(exact.value[k] - now[k]) < 1e-13 * std::abs(now[0]));
        // Again, as a step of time does.
        std::array<std::vector<double>, 3> columns;
        std::vector<double> residual(pad.size());
        problem.film.linearise(problem.p, residual);
        problem.film.attitudeColumns(problem.p, columns, problem.attitudeWork);
        const long long before = allocations;
        problem.film.setAttitude(attitude);
        const std::array<double, 5> both = problem.loads.loadAndShear(problem.p);
        QCOMPARE(values(), now);
        problem.film.attitudeColumns(problem.p, columns, problem.attitudeWork);
        problem.loads.derivatives(problem.p, exact);
        QCOMPARE(allocations.load(), before);
        for (std::size_t k = 0; k < 5; ++k) QVERIFY(std::abs(both[k] - now[k]) < 1e-15 * std::abs(now[0]));
        std::array<double, 5> largest{};
        for (std::size_t k = 0; k < 5; ++k)
            for (const double d : exact.byPressure[k]) largest[k] = std::max(largest[k], std::abs(d));
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                double& p = problem.p[pad.at(i, j)];
                const double middle = p, step = 1e-4 * p;
                p = middle + step;
                const std::array<double, 5> up = values();
                p = middle - step;
                const std::array<double, 5> down = values();
                p = middle;
                for (std::size_t k = 0; k < 5; ++k)
                    QVERIFY(std::abs((up[k] - down[k]) / (2.0 * step) - exact.byPressure[k][pad.at(i, j)]) <
                            1e-6 * largest[k]);
            }
        const std::array<double, 3> steps{0.01e-9, 0.01e-9 / L, 0.01e-9 / W};
        for (std::size_t m = 0; m < 3; ++m) {
            const auto moved = [&](double share) {
                const double d = share * steps[m];
                problem.film.setAttitude({attitude.height + (m == 0 ? d : 0.0), attitude.pitch + (m == 1 ? d : 0.0),
                                          attitude.roll + (m == 2 ? d : 0.0)});
                return values();
            };
            const std::array<double, 5> up = moved(1.0), down = moved(-1.0);
            for (std::size_t k = 0; k < 5; ++k) {
                const double difference = (up[k] - down[k]) / (2.0 * steps[m]);
                // Sums of forces of either sign: against the load that a change of its own gap would make.
                QVERIFY(std::abs(difference - exact.byAttitude[k][m]) <
                        1e-6 * std::abs(exact.byAttitude[k][m]) + 1e-9 * std::abs(now[k]) / steps[m] * 1e-2);
            }
        }
    }
};

TOUCHDOWN_TEST(TestGasFilmLoad)

} // namespace test_gas_film_load

#include "test_gas_film_load.moc"
