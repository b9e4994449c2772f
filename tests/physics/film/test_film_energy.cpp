// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <QTest>

#include "core/physics/film/film_energy.h"
#include "core/physics/film/film_step.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/allocation_count.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"
#include "tests/support/wide_slider.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_energy {

constexpr double L = 0.8e-3, W = 0.6e-3;
constexpr Attitude rest{60e-9, 100e-6, 3e-6};

FilmSetting moving()
{
    FilmSetting setting;
    setting.disk = uniformMotion(20.0, 0.15);
    return setting;
}

/// Two cycles of 50 kHz that set in with zero velocity and acceleration.
double risen(double t) { return std::pow(std::sin(2 * std::numbers::pi * 25e3 * t), 4); }
Attitude moved(double t)
{
    return {rest.height * (1.0 + 0.3 * risen(t)), rest.pitch * (1.0 - 0.1 * risen(t)), rest.roll};
}

constexpr FilmStepOptions tight{.tolerance = 1e-12, .share = 0.0, .maximumIterations = 30};

class TestFilmEnergy : public QObject {
    Q_OBJECT

private slots:
    void nothingAtAmbient()
    {
        FilmProblem level(planeSurface(), L, W, uniformGrid(L, W, 9, 7), moving(), {50e-9, 0.0, 0.0});
        std::vector<double> residual(level.p.size());
        level.film.residual(level.p, residual);
        const FilmEnergyState state = FilmEnergy(level.film).at(level.p);
        QCOMPARE(state.stored, 0.0);
        QCOMPARE(state.dissipation, 0.0);
        QCOMPARE(state.input, 0.0);
    }

    void airInAVessel_data()
    {
        QTest::addColumn<double>("ratio");
        for (const double ratio : {1e-3, 0.2, 0.7072, 0.999, 1.0001, 1.4143, 3.0, 700.0})
            QTest::addRow("%g", ratio) << ratio;
    }
    /// Air compressed from V to V/r at constant temperature takes up p0 V (ln r - (1 - 1/r)) beyond what the ambient
    /// does.
    void airInAVessel()
    {
        QFETCH(double, ratio);
        FilmProblem level(planeSurface(), L, W, uniformGrid(L, W, 9, 7), moving(), {50e-9, 0.0, 0.0});
        std::vector<double> residual(level.p.size());
        level.film.residual(level.p, residual);
        for (int j = 0; j < 7; ++j)
            for (int i = 0; i < 9; ++i) level.p[level.gaps.pad.at(i, j)] *= ratio;
        const double ambient = level.film.ambient(),
                     expected = ambient * 50e-9 * L * W * ratio * (std::log(ratio) - (1.0 - 1.0 / ratio));
        const double stored = FilmEnergy(level.film).at(level.p).stored;
        QVERIFY2(std::abs(stored - expected) < 1e-13 * expected + 3e-16 * ambient * 50e-9 * L * W * ratio,
                 qPrintable(QString::number(stored / expected - 1.0)));
    }

    /// The wide slider in its steady state, per width p0^2 h0^3/(12 mu L) times the integral of H^2 G P'^2/P, G the
    /// mobility; and what the disk puts in is as much: Lambda times the integral of H P'. Second order.
    void wideSliderDissipates()
    {
        constexpr double length = 1e-3, Lambda = 40.0, knudsen = 0.6;
        const Air air{};
        const double h0 = air.meanFreePath / knudsen,
                     speed = Lambda * air.pressure * h0 * h0 / (6.0 * air.viscosity * length);
        const auto mobility = [](double w) { return w * flowFactor({.model = SlipModel::FirstOrder}, knudsen / w); };
        const double flow = wideSlider(Lambda, mobility, 8000).flow;
        double dissipated = 0.0, input = 0.0, P = 1.0;
        constexpr int steps = 100000;
        const double dx = 1.0 / steps;
        const auto slope = [&](double x, double p) {
            return (Lambda * p * (2.0 - x) + flow) / ((2.0 - x) * (2.0 - x) * mobility(p * (2.0 - x)));
        };
        for (int i = steps; i > 0; --i) { // from the outlet, by the middle of each interval
            const double middle = (i - 0.5) * dx, p = P - 0.5 * dx * slope(i * dx, P), s = slope(middle, p),
                         h = 2.0 - middle;
            dissipated += dx * h * h * mobility(p * h) * s * s / p;
            input += dx * Lambda * h * s;
            P -= dx * s;
        }
        QVERIFY(std::abs(dissipated / input - 1.0) < 1e-7);
        const auto error = [&](int cells) {
            CellGrid grid;
            grid.y = {0.0, 1e6, 2e6, 3e6};
            for (int i = 0; i <= cells; ++i)
                grid.x.push_back(length * (1.0 - std::pow(1.0 - static_cast<double>(i) / cells, 1.6)));
            FilmProblem wide(planeSurface(), length, 3e6, grid,
                             {air, {.model = SlipModel::FirstOrder}, uniformMotion(speed)}, {h0, h0 / length, 0.0});
            if (!wide.solve({.tolerance = 1e-11}).converged) return std::nan("");
            std::vector<double> residual(wide.p.size());
            wide.film.residual(wide.p, residual);
            const FilmEnergyState state = FilmEnergy(wide.film).at(wide.p);
            const double scale = air.pressure * air.pressure * h0 * h0 * h0 / (12.0 * air.viscosity * length) * 3e6;
            return state.input == state.dissipation ? state.dissipation / scale / dissipated - 1.0 : std::nan("");
        };
        const double coarse = error(200), fine = error(400);
        const QString both = QStringLiteral("%1, %2").arg(coarse).arg(fine);
        QVERIFY2(std::abs(fine) < 1e-6, qPrintable(both));
        QVERIFY2(std::abs(std::log2(coarse / fine) - 2.0) < 0.15, qPrintable(both));
    }

    void balance_data()
    {
        QTest::addColumn<bool>("stepped");
        QTest::addColumn<double>("waves");
        QTest::newRow("plane slider") << false << 0.0;
        QTest::newRow("stepped slider") << true << 0.0;
        QTest::newRow("plane slider over waves") << false << 10e-9;
    }
    /// What is stored grows by the work of slider and disk and by what flows bring, to the second order of the steps;
    /// of all that is dissipated, 40 steps leave less than 1 %. The work on the volumes is that of the disk's surface
    /// and, under a plane slider, that of the load against its motion.
    void balance()
    {
        QFETCH(bool, stepped);
        QFETCH(double, waves);
        double dissipated = 0.0;
        const auto left = [&](int count) {
            FilmProblem film(stepped ? steppedSurface() : planeSurface(), L, W, uniformGrid(L, W, 17, 14), moving(),
                             rest);
            const PaddedGrid& pad = film.gaps.pad;
            std::vector<double> disk(pad.size(), 0.0), diskBefore;
            if (waves > 0.0) film.film.setSurface(disk);
            const auto setDisk = [&](double t) { // waves that grow and run
                for (int j = 0; j < pad.ny; ++j)
                    for (int i = 0; i < pad.nx; ++i)
                        disk[pad.at(i, j)] = waves * risen(t) * std::sin(8e3 * film.gaps.grid.centreX(i) - 1.6e5 * t);
            };
            setDisk(0.0);
            film.film.setAttitude(rest);
            film.solve({.tolerance = 1e-13, .maximumIterations = 60});
            FilmStepper stepper(film.film, tight);
            stepper.start(film.p);
            FilmEnergy energy(film.film);
            std::vector<double> before = film.p, volumes = film.film.volumes();
            std::vector<double> residual(pad.size());
            film.film.setStorage(0.0, {});
            film.film.residual(film.p, residual);
            FilmEnergyState last = energy.at(film.p);
            const double start = last.stored, dt = 1.3e-5 / count;
            double gained = 0.0, work = 0.0, workApart = 0.0;
            std::array<double, 3> load = film.loads.load(film.p);
            dissipated = 0.0;
            for (int k = 1; k <= count; ++k) {
                diskBefore = disk;
                setDisk(k * dt);
                stepper.step(dt, moved(k * dt));
                const FilmEnergyState now = energy.at(stepper.pressure());
                if (!stepper.accept() || !(now.dissipation > 0.0)) return std::nan("");
                gained += 0.5 * dt * (last.input + now.input - last.dissipation - now.dissipation);
                dissipated += 0.5 * dt * (last.dissipation + now.dissipation);
                work += energy.volumeWork(before, stepper.pressure(), volumes, film.film.volumes());
                workApart += energy.surfaceWork(before, stepper.pressure(), diskBefore, disk);
                const std::array<double, 3> loadBefore = std::exchange(load, film.loads.load(stepper.pressure()));
                const Attitude from = moved((k - 1) * dt), to = moved(k * dt);
                const double pitched = to.pitch - from.pitch;
                const std::array<double, 3> motion{to.height - from.height + 0.5 * L * pitched, pitched,
                                                   to.roll - from.roll};
                for (std::size_t n = 0; n < 3; ++n) workApart -= 0.5 * (loadBefore[n] + load[n]) * motion[n];
                before.assign(stepper.pressure().begin(), stepper.pressure().end());
                volumes = film.film.volumes();
                last = now;
            }
            return stepped || std::abs(work - workApart) < 1e-10 * dissipated ? last.stored - start - gained - work
                                                                              : std::nan("");
        };
        const double coarse = left(40), middle = left(80), fine = left(160);
        const QString all = QStringLiteral("%1, %2, %3 of %4").arg(coarse).arg(middle).arg(fine).arg(dissipated);
        QVERIFY2(std::abs(coarse) < 0.01 * dissipated, qPrintable(all));
        QVERIFY2(std::abs(std::log2((coarse - middle) / (middle - fine)) - 2.0) < 0.15, qPrintable(all));
        QVERIFY2(std::abs(fine) < 0.1 * std::abs(coarse), qPrintable(all));
    }

    void doesNotAllocate()
    {
        FilmProblem film(steppedSurface(), L, W, uniformGrid(L, W, 17, 14), moving(), rest);
        std::vector<double> residual(film.p.size());
        film.film.residual(film.p, residual);
        FilmEnergy energy(film.film);
        const long long before = allocations;
        energy.at(film.p);
        energy.volumeWork(film.p, film.p, film.film.volumes(), film.film.volumes());
        QCOMPARE(allocations.load(), before);
    }
};

TOUCHDOWN_TEST(TestFilmEnergy)

} // namespace test_film_energy

#include "test_film_energy.moc"
