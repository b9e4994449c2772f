// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include <QTest>

#include "core/physics/film/film_step.h"
#include "tests/support/allocation_count.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_step {

constexpr double L = 0.8e-3, W = 0.6e-3;
constexpr Attitude rest{60e-9, 100e-6, 3e-6};

FilmSetting moving()
{
    FilmSetting setting;
    setting.disk = uniformMotion(20.0, 0.15);
    return setting;
}

/// Two cycles of 50 kHz that set in with zero velocity and acceleration.
Attitude moved(double t)
{
    const double rise = std::pow(std::sin(2 * M_PI * 25e3 * t), 4);
    return {rest.height * (1.0 + 0.3 * rise), rest.pitch * (1.0 - 0.1 * rise), rest.roll};
}

struct Moving : FilmProblem {
    FilmStepper stepper;

    explicit Moving(const FilmStepOptions& options, const AirBearingSurface& surface = steppedSurface(),
                    const FilmSetting& setting = moving())
        : FilmProblem(surface, L, W, uniformGrid(L, W, 17, 14), setting, rest), stepper(film, options)
    {
        solve({.tolerance = 1e-13, .maximumIterations = 60});
        stepper.start(p);
    }
    /// The load after `count` steps to time `end`; alternately long and short where `ratio` is not one.
    double loadAt(double end, int count, double ratio = 1.0)
    {
        double t = 0.0;
        for (int k = 0; k < count; ++k) {
            const double dt = end / count * (k % 2 == 0 ? 2.0 * ratio : 2.0) / (1.0 + ratio);
            t += dt;
            stepper.step(dt, moved(t));
            if (!stepper.accept()) return std::nan("");
        }
        return loads.load(stepper.pressure())[0];
    }
};

double content(const GasFilm& film, std::span<const double> p)
{
    return std::inner_product(p.begin(), p.end(), film.volumes().begin(), 0.0);
}

class TestFilmStep : public QObject {
    Q_OBJECT

private slots:
    void order_data()
    {
        QTest::addColumn<int>("method");
        QTest::addColumn<double>("ratio");
        QTest::addColumn<double>("order");
        QTest::newRow("Euler") << int(FilmTimeMethod::Euler) << 1.0 << 1.0;
        QTest::newRow("BDF2OPT") << int(FilmTimeMethod::Bdf2Opt) << 1.0 << 2.0;
        QTest::newRow("BDF2OPT, steps of two lengths") << int(FilmTimeMethod::Bdf2Opt) << 1.4 << 2.0;
        QTest::newRow("BDF2") << int(FilmTimeMethod::Bdf2) << 1.0 << 2.0;
        QTest::newRow("BDF2, steps of two lengths") << int(FilmTimeMethod::Bdf2) << 1.6 << 2.0;
    }
    /// Halved steps: the loads at a fixed time differ by e, then by e/2^order.
    void order()
    {
        QFETCH(int, method);
        QFETCH(double, ratio);
        QFETCH(double, order);
        std::array<double, 3> loads{};
        for (std::size_t k = 0; k < loads.size(); ++k)
            loads[k] =
                Moving({.method = FilmTimeMethod(method), .tolerance = 1e-12, .share = 0.0, .maximumIterations = 30})
                    .loadAt(1.3e-5, 40 << k, ratio);
        const double observed = std::log2((loads[1] - loads[0]) / (loads[2] - loads[1]));
        QVERIFY2(std::abs(observed - order) < 0.15, qPrintable(QStringLiteral("order %1").arg(observed)));
    }

    /// Air too thick to flow: each cell keeps p V, whatever the slider does. V is linear in the attitude.
    void thickAirIsCompressed()
    {
        FilmSetting setting = moving();
        setting.disk.speed = 0.0;
        setting.air.viscosity = 1e9;
        Moving film({.tolerance = 1e-10, .share = 0.0}, planeSurface(), setting);
        const std::vector<double> volumes = film.film.volumes();
        for (const double height : {80e-9, 75e-9, 40e-9}) {
            QVERIFY(film.stepper.step(1e-6, {height, rest.pitch, rest.roll}).converged);
            QVERIFY(film.stepper.accept());
        }
        for (int j = 0; j < film.gaps.pad.ny; ++j)
            for (int i = 0; i < film.gaps.pad.nx; ++i) {
                const std::size_t at = film.gaps.pad.at(i, j);
                const double expected = film.film.ambient() * volumes[at] / film.film.volumes()[at];
                QVERIFY(std::abs(film.stepper.pressure()[at] / expected - 1.0) < 1e-9);
            }
    }

    /// A pocket with a rim below the disk: what is in it stays in it, however it is dragged about and squeezed.
    void closedPocketKeepsItsAir()
    {
        AirBearingSurface surface;
        surface.baseRecess = 0.4e-6;
        const auto rim = [&](double x0, double y0, double x1, double y1) {
            surface.rails.push_back({.points = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .recess = {0.0}});
        };
        rim(0.0, 0.0, 0.11e-3, W);
        rim(0.69e-3, 0.0, L, W);
        rim(0.0, 0.0, L, 0.12e-3);
        rim(0.0, 0.52e-3, L, W);
        FilmProblem pocket(surface, L, W, uniformGrid(L, W, 21, 17), moving(), {-20e-9, 0.0, 0.0});
        FilmStepper stepper(pocket.film, {.tolerance = 1e-13, .share = 0.0, .maximumIterations = 30});
        stepper.start(pocket.p);
        const double before = content(pocket.film, pocket.p);
        double highest = 0.0, lowest = 1e9;
        for (int k = 1; k <= 12; ++k) {
            QVERIFY(stepper.step(2e-6, {-20e-9 - 9e-9 * k, 0.0, 0.0}).converged);
            QVERIFY(stepper.accept());
            QVERIFY(std::abs(content(pocket.film, stepper.pressure()) / before - 1.0) < 1e-12);
        }
        for (int i = 0; i < pocket.gaps.pad.nx; ++i) {
            const double p = stepper.pressure()[pocket.gaps.pad.at(i, 8)];
            highest = std::max(highest, p);
            lowest = std::min(lowest, p);
        }
        QVERIFY(highest > 1.2 * lowest); // it was dragged about
    }
    /// Pressed 2 nm into the disk: each cell that has no volume any more has closed once, also when it stays so.
    void countsCellsThatClose()
    {
        Moving moving(FilmStepOptions{});
        const auto closed = [&] { return std::ranges::count(moving.film.volumes(), 0.0); };
        const auto before = closed(); // the rings
        for (int k = 1; k <= 620; ++k) {
            moving.stepper.step(5e-9, {rest.height - 0.1e-9 * k, rest.pitch, rest.roll});
            QVERIFY(moving.stepper.accept());
        }
        QVERIFY(closed() > before);
        QCOMPARE(moving.stepper.closings(), static_cast<long long>(closed() - before));
        moving.stepper.step(5e-9, {rest.height - 62e-9, rest.pitch, rest.roll});
        QVERIFY(moving.stepper.accept());
        QCOMPARE(moving.stepper.closings(), static_cast<long long>(closed() - before));
    }

    /// What steps of the default share leave, all together, is less than that share of their errors in time.
    void leavesLittleOfEachStep()
    {
        const FilmStepOptions tight{.tolerance = 1e-12, .share = 0.0, .maximumIterations = 30};
        Moving exact(tight), inTime(tight), byDefault({});
        exact.loadAt(1.3e-5, 160);
        inTime.loadAt(1.3e-5, 40);
        byDefault.loadAt(1.3e-5, 40);
        const auto distance = [&](const Moving& a, const Moving& b) {
            double sum = 0.0;
            for (std::size_t at = 0; at < a.p.size(); ++at)
                sum += std::pow(a.stepper.pressure()[at] - b.stepper.pressure()[at], 2);
            return std::sqrt(sum);
        };
        QVERIFY(distance(byDefault, inTime) < FilmStepOptions{}.share * distance(inTime, exact));
    }

    void steadyStateStays()
    {
        Moving film({});
        for (int k = 0; k < 3; ++k) {
            const FilmStepResult result = film.stepper.step(1e-6, rest);
            QVERIFY(result.converged);
            QVERIFY(film.stepper.accept());
        }
        for (std::size_t at = 0; at < film.p.size(); ++at)
            QVERIFY(std::abs(film.stepper.pressure()[at] / film.p[at] - 1.0) < 1e-9);
    }

    /// A step much longer than the film needs ends in the steady state of the new attitude.
    void longStepEndsSteady()
    {
        Moving film({.method = FilmTimeMethod::Euler, .tolerance = 1e-12, .share = 0.0, .maximumIterations = 30});
        const Attitude attitude{70e-9, 90e-6, -2e-6};
        QVERIFY(film.stepper.step(1e3, attitude).converged);
        FilmProblem steady(steppedSurface(), L, W, uniformGrid(L, W, 17, 14), moving(), attitude);
        QVERIFY(steady.solve({.tolerance = 1e-12, .maximumIterations = 60}).converged);
        for (std::size_t at = 0; at < steady.p.size(); ++at)
            QVERIFY(std::abs(film.stepper.pressure()[at] / steady.p[at] - 1.0) < 1e-8);
    }

    /// Another try of a step forgets the one before.
    void triesAreAlike()
    {
        const FilmStepOptions options{.tolerance = 1e-13, .share = 0.0, .maximumIterations = 30};
        Moving once(options), twice(options);
        QVERIFY(twice.stepper.step(3e-6, {90e-9, 130e-6, 0.0}).converged);
        QVERIFY(twice.stepper.step(1e-6, moved(3e-6)).converged);
        QVERIFY(once.stepper.step(1e-6, moved(3e-6)).converged);
        for (std::size_t at = 0; at < once.p.size(); ++at)
            QVERIFY(std::abs(once.stepper.pressure()[at] / twice.stepper.pressure()[at] - 1.0) < 1e-9);
    }

    void saysWhenItDidNotConverge()
    {
        Moving film({.tolerance = 1e-12, .maximumIterations = 1});
        const FilmStepResult result = film.stepper.step(1e-7, {15e-9, 100e-6, 3e-6});
        QVERIFY(!result.converged);
        QVERIFY(result.error > 1e-12);
        QCOMPARE(result.iterations, 1);
        QVERIFY(!film.stepper.accept());
        // What was refused is forgotten: the next step goes on from the start.
        Moving other({});
        QVERIFY(film.stepper.step(1e-7, rest).error < 1e-12);
        QVERIFY(other.stepper.step(1e-7, rest).converged);
        for (std::size_t at = 0; at < film.p.size(); ++at)
            QVERIFY(std::abs(film.stepper.pressure()[at] / other.stepper.pressure()[at] - 1.0) < 1e-9);
    }

    void doesNotAllocate()
    {
        Moving film({});
        film.loadAt(1e-6, 4);
        const long long before = allocations;
        for (int k = 5; k <= 12; ++k) {
            film.stepper.step(k < 9 ? 1e-6 : 4e-7, moved(1e-6 * k));
            QVERIFY(film.stepper.accept());
        }
        QCOMPARE(allocations.load(), before);
    }

    /// The derivatives of the residual with what cells store, against differences, and transposed.
    void derivativesWithStorage()
    {
        Moving film({.tolerance = 1e-12, .share = 0.0});
        film.loadAt(1e-6, 3);
        film.stepper.step(5e-7, moved(1.5e-6));
        GasFilm& gas = film.film;
        const PaddedGrid& pad = gas.pad();
        const std::vector<double> p(film.stepper.pressure().begin(), film.stepper.pressure().end());
        std::vector<double> v(pad.size(), 0.0), w(pad.size(), 0.0), out(pad.size(), 0.0), high(pad.size(), 0.0),
            low(pad.size(), 0.0);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                v[pad.at(i, j)] = std::sin(1.7 * i + 0.9 * j * j);
                w[pad.at(i, j)] = std::cos(2.3 * i * i - 1.1 * j);
            }
        const auto largest = [](const std::vector<double>& values) {
            double result = 0.0;
            for (const double value : values) result = std::max(result, std::abs(value));
            return result;
        };
        FaceFlows<double> work;
        work.resize(pad.size());

        gas.linearise(p, out);
        gas.applyJacobian<double>(v, out, work);
        const double product = std::inner_product(out.begin(), out.end(), w.begin(), 0.0);
        std::vector<double> back(pad.size(), 0.0);
        gas.applyTransposedJacobian(w, back, work);
        QVERIFY(std::abs(std::inner_product(back.begin(), back.end(), v.begin(), 0.0) / product - 1.0) < 1e-10);

        std::array<std::vector<double>, 3> columns;
        AttitudeWork attitudeWork(gas.gaps());
        gas.attitudeColumns(p, columns, attitudeWork);
        const double pressureStep = 1.0; // [Pa]
        std::vector<double> nearby(p);
        for (std::size_t at = 0; at < p.size(); ++at) nearby[at] = p[at] + pressureStep * v[at];
        gas.residual(nearby, high);
        for (std::size_t at = 0; at < p.size(); ++at) nearby[at] = p[at] - pressureStep * v[at];
        gas.residual(nearby, low);
        const double scale = largest(out);
        for (std::size_t at = 0; at < p.size(); ++at)
            QVERIFY(std::abs((high[at] - low[at]) / (2 * pressureStep) - out[at]) < 1e-6 * scale);

        const Attitude attitude = gas.attitude();
        const std::array<double, 3> steps{1e-13, 1e-10, 1e-10};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto shifted = [&](double by) {
                return Attitude{attitude.height + (k == 0 ? by : 0.0), attitude.pitch + (k == 1 ? by : 0.0),
                                attitude.roll + (k == 2 ? by : 0.0)};
            };
            gas.setAttitude(shifted(steps[k]));
            gas.residual(p, high);
            gas.setAttitude(shifted(-steps[k]));
            gas.residual(p, low);
            const double columnScale = largest(columns[k]);
            for (std::size_t at = 0; at < p.size(); ++at)
                QVERIFY(std::abs((high[at] - low[at]) / (2 * steps[k]) - columns[k][at]) < 2e-5 * columnScale);
        }
    }
};

TOUCHDOWN_TEST(TestFilmStep)

} // namespace test_film_step

#include "test_film_step.moc"
