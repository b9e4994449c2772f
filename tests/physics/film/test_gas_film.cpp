// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gas_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <QTest>

#include "core/physics/film/slip_model.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_gas_film {

constexpr double gramForce = 9.80665e-3; // [N]
constexpr double L = 1.0e-3, W = 0.8e-3;

void addSchemes()
{
    QTest::addColumn<ConvectionScheme>("scheme");
    using enum ConvectionScheme;
    QTest::newRow("upwind") << Upwind;
    QTest::newRow("hybrid") << Hybrid;
    QTest::newRow("power law") << PowerLaw;
    QTest::newRow("exponential") << Exponential;
    QTest::newRow("complete flux") << CompleteFlux;
}

FilmSetting settingOf(ConvectionScheme scheme, double skew = 0.1)
{
    FilmSetting setting;
    setting.disk = uniformMotion(15.0, skew);
    setting.scheme = scheme;
    return setting;
}

Rail box(double x0, double x1, double y0, double y1)
{
    return {.points = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .recess = {0.0}};
}

class TestGasFilm : public QObject {
    Q_OBJECT

private slots:
    /// R summed over the cells is what leaves through the outline: here the flows of the outermost faces.
    void sumOfResiduals_data() { addSchemes(); }
    void sumOfResiduals()
    {
        QFETCH(ConvectionScheme, scheme);
        if (scheme == ConvectionScheme::CompleteFlux)
            scheme = ConvectionScheme::Exponential; // its flows add a correction
        AirBearingSurface surface;
        surface.rails = {box(0.21e-3, 0.93e-3, 0.13e-3, 0.55e-3)};
        FilmProblem problem(surface, L, W, uniformGrid(L, W, 17, 13), settingOf(scheme), {30e-9, 120e-6, 5e-6});
        const PaddedGrid& pad = problem.gaps.pad;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) problem.p[pad.at(i, j)] *= 1.5 + std::sin(1.7 * i + 0.6 * j);
        std::vector<double> residual(pad.size());
        problem.film.linearise(problem.p, residual);
        const auto& faces = problem.film.faces();
        double sum = 0.0, size = 0.0, outflow = 0.0;
        for (const double r : residual) sum += r, size += std::abs(r);
        for (int j = 0; j < pad.ny; ++j) outflow += faces[0].flow[pad.at(pad.nx, j)] - faces[0].flow[pad.at(0, j)];
        for (int i = 0; i < pad.nx; ++i) outflow += faces[1].flow[pad.at(i, pad.ny)] - faces[1].flow[pad.at(i, 0)];
        QVERIFY(std::abs(sum - outflow) < 1e-14 * size);
    }

    /// Ambient pressure under a level slider without steps is the solution, whatever the disk does; and with the disk
    /// at rest under any slider.
    void nothingHappens_data() { addSchemes(); }
    void nothingHappens()
    {
        QFETCH(ConvectionScheme, scheme);
        FilmProblem level(planeSurface(), L, W, uniformGrid(L, W, 9, 7), settingOf(scheme, 0.4), {50e-9, 0.0, 0.0});
        std::vector<double> residual(level.gaps.pad.size());
        level.film.residual(level.p, residual);
        QVERIFY(residualNorm(level.film, residual) < 1e-13);

        AirBearingSurface surface;
        surface.rails = {box(0.21e-3, 0.93e-3, 0.13e-3, 0.55e-3)};
        FilmSetting setting = settingOf(scheme);
        setting.disk.speed = 0.0;
        FilmProblem still(surface, L, W, uniformGrid(L, W, 9, 7), setting, {50e-9, 100e-6, 3e-6});
        still.film.residual(still.p, residual);
        double largest = 0.0;
        for (const double r : residual) largest = std::max(largest, std::abs(r));
        // Against the flow between p0 and vacuum through the deepest gap, some 1e-6^3 p0^2/(12 mu).
        QVERIFY(largest < 1e-13 * 1e-18 * 1e10 / (12.0 * 1.8e-5));
    }

    /// Gaps do not change: two films of the same gaps are solved at two attitudes on two threads at once, with the bits
    /// of one after the other.
    void filmsOfTheSameGapsAreSolvedAtOnce()
    {
        AirBearingSurface surface;
        surface.rails = {box(0.21e-3, 0.93e-3, 0.13e-3, 0.55e-3)};
        const auto gaps = std::make_shared<const FilmGaps>(Recess(surface, L, W), gradedGrid(surface, L, W, 40, 32));
        const std::array<Attitude, 2> attitudes{Attitude{30e-9, 120e-6, 5e-6}, Attitude{60e-9, 80e-6, -3e-6}};
        const auto solved = [&](std::size_t k) {
            GasFilm film(gaps, settingOf(ConvectionScheme::CompleteFlux));
            film.setAttitude(attitudes[k]);
            std::vector<double> p(gaps->pad.size(), film.ambient());
            return FilmNewton(film).solve(p, {}).converged ? p : std::vector<double>();
        };
        const std::array<std::vector<double>, 2> expected{solved(0), solved(1)};
        QVERIFY(!expected[0].empty() && !expected[1].empty());
        QVERIFY(expected[0] != expected[1]);
        std::array<std::vector<double>, 2> found;
        {
            const std::jthread first([&] { found[0] = solved(0); }), second([&] { found[1] = solved(1); });
        }
        QVERIFY(found == expected);
        QCOMPARE(gaps.use_count(), 1L);
    }

    /// A slider mirrored across y, with roll and skew turned round, has the mirrored pressure, to what the solver
    /// leaves.
    void mirrored_data() { addSchemes(); }
    void mirrored()
    {
        QFETCH(ConvectionScheme, scheme);
        AirBearingSurface surface, mirror;
        surface.walls = mirror.walls = {{.distance = {0.0, 30e-6}, .recess = {0.0, 2e-6}}};
        surface.rails = {
            box(0.1e-3, 0.6e-3, 0.07e-3, 0.33e-3),
            {.points = {{0.5e-3, 0.4e-3, 1}, {0.95e-3, 0.47e-3, 1}, {0.9e-3, 0.7e-3, 1}, {0.5e-3, 0.66e-3, 1}},
             .recess = {0.0}}};
        for (const Rail& rail : surface.rails) {
            Rail other = rail;
            // An edge belongs to the corner where it begins: turned round, it begins where it ended.
            for (RailPoint& point : other.points) point.y = W - point.y;
            mirror.rails.push_back(other);
        }
        const CellGrid grid = uniformGrid(L, W, 30, 26);
        FilmProblem a(surface, L, W, grid, settingOf(scheme, 0.2), {40e-9, 120e-6, 6e-6});
        FilmProblem b(mirror, L, W, grid, settingOf(scheme, -0.2), {40e-9, 120e-6, -6e-6});
        QVERIFY(a.solve({.tolerance = 1e-11}).converged && b.solve({.tolerance = 1e-11}).converged);
        for (int j = 0; j < 26; ++j)
            for (int i = 0; i < 30; ++i)
                QVERIFY2(std::abs(a.at(i, j) / b.at(i, 25 - j) - 1.0) < 1e-8,
                         qPrintable(QString::number(a.at(i, j) / b.at(i, 25 - j) - 1.0)));
        const FilmForces f = a.loads.forces(a.p), g = b.loads.forces(b.p);
        QVERIFY2(std::abs(f.net / g.net - 1.0) < 1e-8, qPrintable(QString::number(f.net / g.net - 1.0)));
        QVERIFY2(std::abs(f.pitchTorque / g.pitchTorque - 1.0) < 1e-8,
                 qPrintable(QString::number(f.pitchTorque / g.pitchTorque - 1.0)));
        QVERIFY2(std::abs(f.rollTorque / g.rollTorque + 1.0) < 1e-8,
                 qPrintable(QString::number(f.rollTorque / g.rollTorque + 1.0)));
        QVERIFY2(std::abs(f.shearX / g.shearX - 1.0) < 1e-8, qPrintable(QString::number(f.shearX / g.shearX - 1.0)));
        QVERIFY2(std::abs(f.shearY / g.shearY + 1.0) < 1e-8, qPrintable(QString::number(f.shearY / g.shearY + 1.0)));
    }

    /// The plane slider with cells far too coarse for its boundary layers: pressures stay above ambient, rise along the
    /// middle to one peak and fall, and the peak is not above the converged 2.3167 p0 (physics: h1/h0 = 3.5, Peclet up
    /// to 20 a cell).
    void noOvershoot_data()
    {
        QTest::addColumn<ConvectionScheme>("scheme");
        QTest::addColumn<int>("n");
        for (const int n : {12, 24, 48, 96}) {
            QTest::addRow("exponential, %d", n) << ConvectionScheme::Exponential << n;
            QTest::addRow("complete flux, %d", n) << ConvectionScheme::CompleteFlux << n;
        }
    }
    void noOvershoot()
    {
        QFETCH(ConvectionScheme, scheme);
        QFETCH(int, n);
        FilmSetting setting = settingOf(scheme, 0.0);
        setting.slip.model = SlipModel::FukuiKanekoFit;
        const double length = 1.25e-3, width = 1e-3;
        FilmProblem problem(planeSurface(), length, width, uniformGrid(length, width, n, n), setting,
                            {100e-9, 200e-6, 0.0});
        QVERIFY(problem.solve().converged);
        const double ambient = problem.film.ambient();
        QVERIFY(problem.lowest() >= ambient * (1.0 - 1e-9));
        QVERIFY2(problem.peak() / ambient - 1.0 < 2.3167 * 1.001,
                 qPrintable(QString::number(problem.peak() / ambient - 1.0)));
        int turns = 0;
        for (int i = 1; i + 1 < n; ++i)
            turns +=
                (problem.at(i, n / 2) > problem.at(i - 1, n / 2)) != (problem.at(i + 1, n / 2) > problem.at(i, n / 2));
        QVERIFY(turns <= 1);
    }

    /// Deep below the rails a cavity draws the pressure down, never below zero, however coarse the cells and fast the
    /// disk.
    void pressuresStayPositive_data() { addSchemes(); }
    void pressuresStayPositive()
    {
        QFETCH(ConvectionScheme, scheme);
        AirBearingSurface surface;
        surface.baseRecess = 0.6e-6;
        surface.rails = {box(0.05e-3, 0.3e-3, 0.0, W), box(0.3e-3, 0.97e-3, 0.0, 0.15e-3),
                         box(0.3e-3, 0.97e-3, 0.65e-3, W)};
        for (const double speed : {10.0, 100.0, 1000.0}) {
            FilmSetting setting = settingOf(scheme);
            setting.disk = uniformMotion(speed, 0.15);
            FilmProblem problem(surface, L, W, uniformGrid(L, W, 20, 16), setting, {20e-9, 80e-6, 2e-6});
            const FilmSolution solution = problem.solve();
            QVERIFY2(solution.converged, qPrintable(QString("%1 m/s: %2").arg(speed).arg(solution.residual)));
            QVERIFY(problem.lowest() > 0.0);
            QVERIFY(problem.lowest() < 0.95 * problem.film.ambient());
        }
    }

    /// A rail whose side moves across two cells in 24 steps, against the flow's: the load falls at each step by at
    /// least half of the mean, and is within 1.5 % of that on four times as many cells along x and y. Grids that see
    /// only whole cells would stand still and jump.
    void sideEdgeMovesThroughCells()
    {
        const auto load = [](int cells, int k) {
            AirBearingSurface surface;
            surface.baseRecess = 1e-6;
            surface.rails = {box(0.3125e-3, 0.90625e-3, (0.3 + k / 384.0) * W, 0.7 * W)};
            FilmProblem problem(surface, L, W, uniformGrid(L, W, cells, cells),
                                settingOf(ConvectionScheme::CompleteFlux), {20e-9, 100e-6, 2e-6});
            return problem.solve({.tolerance = 1e-9}).converged ? problem.load() / gramForce : 0.0;
        };
        std::vector<double> loads;
        for (int k = 0; k <= 24; ++k) loads.push_back(load(32, k));
        const double mean = (loads.front() - loads.back()) / 24.0;
        for (std::size_t k = 1; k < loads.size(); ++k) {
            const double step = loads[k - 1] - loads[k];
            QVERIFY2(step > 0.5 * mean, qPrintable(QString("%1: %2 of %3").arg(k).arg(step).arg(mean)));
        }
        for (int k = 0; k <= 24; k += 2) {
            const double error = loads[std::size_t(k)] / load(128, k) - 1.0;
            QVERIFY2(std::abs(error) < 0.015, qPrintable(QString("%1: %2").arg(k).arg(error)));
        }
    }

    /// A rail with oblique edges that moves: within 2 % of its load on 128 x 128 cells wherever it is on 32 x 32.
    void obliqueEdgesMoveThroughCells()
    {
        const auto load = [](double shift, int n) {
            AirBearingSurface surface;
            surface.baseRecess = 1e-6;
            surface.rails = {{.points = {{(0.3 + shift) * L, 0.3 * W},
                                         {0.9 * L, 0.36 * W},
                                         {0.84 * L, 0.7 * W},
                                         {(0.36 + shift) * L, 0.64 * W}},
                              .recess = {0.0}}};
            FilmProblem problem(surface, L, W, uniformGrid(L, W, n, n), settingOf(ConvectionScheme::CompleteFlux),
                                {20e-9, 100e-6, 2e-6});
            return problem.solve().converged ? problem.load() / gramForce : std::numeric_limits<double>::quiet_NaN();
        };
        for (const double shift : {0.0, 0.02, 0.05}) {
            const double fine = load(shift, 128);
            for (const double more : {0.0, 0.004}) {
                const double coarse = load(shift + more, 32);
                QVERIFY2(std::abs(coarse / fine - 1.0) < 0.03,
                         qPrintable(QString("%1: %2 of %3").arg(shift + more).arg(coarse).arg(fine)));
            }
        }
    }
};

TOUCHDOWN_TEST(TestGasFilm)

} // namespace test_gas_film

#include "test_gas_film.moc"
