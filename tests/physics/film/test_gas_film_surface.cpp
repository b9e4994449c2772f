// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <QTest>

#include "core/physics/film/film_step.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/allocation_count.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"
#include "tests/support/wide_slider.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_gas_film_surface {

using Complex = std::complex<double>;

/// The infinitely wide slider with an inlet gap twice the outlet's, as the middle one of three rows of cells a thousand
/// kilometres wide.
struct WideFilm {
    static constexpr double L = 1e-3, bearingNumber = 40.0, knudsen = 0.6;
    static constexpr SlipModel model = SlipModel::FirstOrder;
    const Air air{};
    const double h0 = air.meanFreePath / knudsen;
    const double speed = bearingNumber * air.pressure * h0 * h0 / (6.0 * air.viscosity * L);
    const Attitude attitude{h0, h0 / L, 0.0};
    FilmProblem problem;
    std::vector<double> disk;

    explicit WideFilm(int cells)
        : problem(planeSurface(), L, 3e6, grid(cells),
                  {air, {.model = model}, uniformMotion(speed), ConvectionScheme::CompleteFlux}, attitude),
          disk(problem.gaps.pad.size(), 0.0)
    {}
    static CellGrid grid(int cells)
    {
        CellGrid result;
        result.y = {0.0, 1e6, 2e6, 3e6};
        for (int i = 0; i <= cells; ++i)
            result.x.push_back(L * (1.0 - std::pow(1.0 - static_cast<double>(i) / cells, 1.6)));
        return result;
    }
    /// Means over the cells of h0 amplitude sin(waves 2 pi X - phase).
    void setWaves(double amplitude, double waves, double phase)
    {
        const PaddedGrid& pad = problem.gaps.pad;
        const std::vector<double>& x = problem.gaps.grid.x;
        const double k = 2.0 * std::numbers::pi * waves / L;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const double a = x[static_cast<std::size_t>(i)], b = x[static_cast<std::size_t>(i) + 1];
                disk[pad.at(i, j)] =
                    h0 * amplitude * (std::cos(k * a - phase) - std::cos(k * b - phase)) / (k * (b - a));
            }
        problem.film.setSurface(disk);
    }
    /// int (p/p0 - 1) dX of the middle row.
    double load(std::span<const double> p) const
    {
        double sum = 0.0;
        for (int i = 0; i < problem.gaps.pad.nx; ++i)
            sum += (p[problem.gaps.pad.at(i, 1)] / air.pressure - 1.0) * problem.gaps.grid.widthX(i) / L;
        return sum;
    }
    static double mobility(double w) { return w * flowFactor({.model = model}, knudsen / w); }
};

/// Load for each amplitude of waves exp(i (2 pi n X - omega t)) that move with the disk, linear. With T = omega t and
/// sigma = 12 mu omega L^2/(p0 h0^2) = 2 Lambda 2 pi n, mass balance d(H^2 G dP/dX - Lambda P H)/dX = sigma d(P H)/dT
/// about the steady state P, H; p, c the changes of the pressure and of the flow, h = -exp(2 pi i n X) that of the gap,
/// w = p H + P h:
///
///   c = H^2 G p' + (2 H h G + H^2 G' w) P' - Lambda w,   c' = -i sigma w,   p(0) = p(1) = 0.
///
/// All by the classical Runge-Kutta method from the outlet; c there such that p(0) = 0. First order slip: G = w + 6 Kn,
/// G' = 1.
Complex waveLoad(double waves, int steps)
{
    constexpr double Lambda = WideFilm::bearingNumber;
    const double flow = wideSlider(Lambda, WideFilm::mobility, steps).flow;
    const double k = 2.0 * std::numbers::pi * waves, sigma = 2.0 * Lambda * k;
    using State = std::array<Complex, 4>; // P, p, c, integral of p
    const auto shoot = [&](Complex outflow, double forced) {
        const auto slope = [&](double x, const State& s) -> State {
            const double H = 2.0 - x;
            const Complex P = s[0], p = s[1], c = s[2], h = -forced * std::exp(Complex(0.0, k * x));
            const Complex G = P * H + 6.0 * WideFilm::knudsen, w = p * H + P * h;
            const Complex dP = (Lambda * P * H + flow) / (H * H * G);
            return {dP, (c - (2.0 * H * h * G + H * H * w) * dP + Lambda * w) / (H * H * G), Complex(0.0, -sigma) * w,
                    p};
        };
        State s{1.0, 0.0, outflow, 0.0};
        const double dx = -1.0 / steps;
        const auto ahead = [&](const State& by, double share) {
            State result = s;
            for (std::size_t n = 0; n < 4; ++n) result[n] += share * dx * by[n];
            return result;
        };
        for (int i = 0; i < steps; ++i) {
            const double x = 1.0 + i * dx;
            const State k1 = slope(x, s), k2 = slope(x + 0.5 * dx, ahead(k1, 0.5)),
                        k3 = slope(x + 0.5 * dx, ahead(k2, 0.5)), k4 = slope(x + dx, ahead(k3, 1.0));
            for (std::size_t n = 0; n < 4; ++n) s[n] += dx / 6.0 * (k1[n] + 2.0 * k2[n] + 2.0 * k3[n] + k4[n]);
        }
        return s;
    };
    const State forced = shoot(0.0, 1.0), free = shoot(1.0, 0.0);
    return -(forced[3] - forced[1] / free[1] * free[3]);
}

/// Every kind of face, and at the least height parts that are closed.
AirBearingSurface richSurface()
{
    AirBearingSurface surface;
    surface.baseRecess = 1.2e-6;
    surface.crown = 15e-9;
    surface.camber = -4e-9;
    surface.taperLength = 0.1e-3;
    surface.taperAngle = 1e-3;
    surface.walls = {{.distance = {0.0, 20e-6}, .recess = {0.0, 1.2e-6}}};
    surface.rails = {
        {.points = {{0.05e-3, 0.08e-3, 1}, {0.62e-3, 0.11e-3, 1}, {0.58e-3, 0.31e-3, 1}, {0.05e-3, 0.27e-3, 1}},
         .recess = {0.0}},
        {.points = {{0.0, 0.4e-3}, {0.33e-3, 0.4e-3}, {0.33e-3, 0.7e-3}, {0.0, 0.7e-3}}, .recess = {150e-9}},
        {.points = {{0.66e-3, 0.3e-3}, {0.87e-3, 0.3e-3}, {0.87e-3, 0.52e-3}, {0.66e-3, 0.52e-3}}, .recess = {0.0}}};
    return surface;
}

double largest(std::span<const double> values)
{
    double result = 0.0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

class TestGasFilmSurface : public QObject {
    Q_OBJECT

private slots:
    void evenDiskIsALowerSlider_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<bool>("ringsToo");
        QTest::newRow("raised") << 7e-9 << true;
        QTest::newRow("raised, rings not given") << 7e-9 << false;
        QTest::newRow("lowered") << -12e-9 << true;
        QTest::newRow("raised until it touches") << 24e-9 << false;
    }
    /// A disk that is the same height everywhere is a slider that is lower by that: everything to rounding.
    void evenDiskIsALowerSlider()
    {
        QFETCH(double, height);
        QFETCH(bool, ringsToo);
        constexpr double L = 0.9e-3, W = 0.7e-3;
        FilmSetting setting;
        setting.disk = {.speed = 600.0, .radius = 22e-3, .skew = 0.2};
        const auto make = [&](double lift) {
            return std::make_unique<FilmProblem>(richSurface(), L, W, uniformGrid(L, W, 31, 26), setting,
                                                 Attitude{22e-9 + lift, 150e-6, 8e-6});
        };
        const auto over = make(0.0), lower = make(-height);
        const PaddedGrid& pad = over->gaps.pad;
        std::vector<double> disk(pad.size(), ringsToo ? height : 1.0), history(pad.size());
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) disk[pad.at(i, j)] = height;
        over->film.setSurface(disk);
        over->film.setAttitude(over->film.attitude());
        const auto near = [](std::span<const double> a, std::span<const double> b) {
            const double scale = std::max(largest(a), largest(b));
            for (std::size_t at = 0; at < a.size(); ++at)
                if (!(std::abs(a[at] - b[at]) <= 1e-12 * scale)) return false;
            return true;
        };
        QVERIFY(near(over->film.volumes(), lower->film.volumes()));
        QVERIFY(std::abs(over->film.totalVolume() / lower->film.totalVolume() - 1.0) < 1e-12);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                QVERIFY(std::abs(over->film.meanGap(i, j) - lower->film.meanGap(i, j)) < 1e-18);
                for (FilmProblem* problem : {over.get(), lower.get()})
                    problem->p[pad.at(i, j)] *= 1.5 + std::sin(1.1 * i + 0.4 * j * j);
                history[pad.at(i, j)] = 1e5 * lower->p[pad.at(i, j)] * lower->film.volumes()[pad.at(i, j)];
            }
        std::array<std::vector<double>, 2> residuals;
        std::array<FilmLoads::Derivatives, 2> forces;
        std::array<std::array<std::vector<double>, 3>, 2> columns;
        for (std::size_t k = 0; k < 2; ++k) {
            FilmProblem& problem = k == 0 ? *over : *lower;
            residuals[k].resize(pad.size());
            problem.film.setStorage(3e5, history);
            problem.film.linearise(problem.p, residuals[k]);
            problem.loads.derivatives(problem.p, forces[k]);
            problem.film.attitudeColumns(problem.p, columns[k], problem.attitudeWork);
        }
        QVERIFY(near(residuals[0], residuals[1]));
        for (std::size_t axis = 0; axis < 2; ++axis) {
            QVERIFY(near(over->film.faces()[axis].lower, lower->film.faces()[axis].lower));
            QVERIFY(near(over->film.faces()[axis].upper, lower->film.faces()[axis].upper));
        }
        QVERIFY(near(over->loads.load(over->p), lower->loads.load(lower->p)));
        QVERIFY(near(over->loads.shear(over->p), lower->loads.shear(lower->p)));
        for (std::size_t k = 0; k < 5; ++k) {
            QVERIFY(near(forces[0].byPressure[k], forces[1].byPressure[k]));
            QVERIFY(near(forces[0].byAttitude[k], forces[1].byAttitude[k]));
        }
        for (std::size_t k = 0; k < 3; ++k) QVERIFY(near(columns[0][k], columns[1][k]));
        // Without a surface again all is as it was.
        over->film.setSurface({});
        over->film.setAttitude(lower->film.attitude());
        QVERIFY(over->film.volumes() == lower->film.volumes());
        QVERIFY(near(over->loads.load(over->p), lower->loads.load(lower->p)));
    }

    /// Waves of a tenth of the gap, two and a half over the length, that stand still: the ordinary equation with the
    /// gap 2 - X - 0.1 sin(2.5 2 pi X - 0.7); second order.
    void wavesThatStandStill()
    {
        const auto gap = [](double x) { return 2.0 - x - 0.1 * std::sin(5.0 * std::numbers::pi * x - 0.7); };
        const double expected = wideSlider(WideFilm::bearingNumber, WideFilm::mobility, 8000, gap).load;
        const auto error = [&](int cells) {
            WideFilm wide(cells);
            wide.setWaves(0.1, 2.5, 0.7);
            wide.problem.film.setAttitude(wide.attitude);
            return wide.problem.solve({.tolerance = 1e-11}).converged ? wide.load(wide.problem.p) / expected - 1.0
                                                                      : std::nan("");
        };
        const double coarse = error(100), fine = error(200);
        const QString both = QStringLiteral("%1, %2").arg(coarse).arg(fine);
        QVERIFY2(std::abs(fine) < 3e-4, qPrintable(both));
        QVERIFY2(std::abs(std::log2(coarse / fine) - 2.0) < 0.15, qPrintable(both));
    }

    void wavesThatMove_data()
    {
        QTest::addColumn<double>("waves");
        QTest::newRow("thirty times as long as the slider") << 1.0 / 30;
        QTest::newRow("as long as the slider") << 1.0;
        QTest::newRow("a third of the slider") << 3.0;
    }
    /// Low waves that move with the disk: the load oscillates as the linear equation says, in amplitude and phase;
    /// second order in cells and steps. Waves of 1e-4 of the gap are linear to 1e-8, with the harmonic alone.
    void wavesThatMove()
    {
        QFETCH(double, waves);
        const Complex expected = waveLoad(waves, 8000);
        const auto error = [&](int cells, int steps) {
            constexpr double amplitude = 1e-4;
            WideFilm wide(cells);
            const auto set = [&](double phase) {
                wide.setWaves(amplitude, waves, phase);
                wide.problem.film.setAttitude(wide.attitude);
            };
            set(0.0);
            if (!wide.problem.solve({.tolerance = 1e-12, .maximumIterations = 60}).converged) return std::nan("");
            FilmStepper stepper(wide.problem.film, {.tolerance = 1e-13, .share = 0.0, .maximumIterations = 30});
            stepper.start(wide.problem.p);
            const double period = WideFilm::L / waves / wide.speed;
            // What the start leaves is carried out at half the disk's speed, and decays: four times that way.
            const int before = steps * static_cast<int>(std::ceil(8.0 * waves));
            Complex harmonic = 0.0;
            for (int n = 1; n <= before + steps; ++n) {
                const double phase = 2.0 * std::numbers::pi * n / steps;
                set(phase);
                stepper.step(period / steps, wide.attitude);
                if (!stepper.accept()) return std::nan("");
                // sin(2 pi n X - T) is the real part of -i exp(i (2 pi n X - T)).
                if (n > before)
                    harmonic += wide.load(stepper.pressure()) * std::exp(Complex(0.0, phase)) * Complex(0.0, 1.0) *
                                (2.0 / steps / amplitude);
            }
            return std::abs(harmonic - expected) / std::abs(expected);
        };
        const double coarse = error(60, 60), fine = error(120, 120);
        const QString both = QStringLiteral("%1, %2").arg(coarse).arg(fine);
        QVERIFY2(fine < 3e-3, qPrintable(both));
        QVERIFY2(std::abs(std::log2(coarse / fine) - 2.0) < 0.15, qPrintable(both));
    }

    void doesNotAllocate()
    {
        WideFilm wide(40);
        wide.setWaves(0.1, 2.0, 0.0);
        const long long before = allocations;
        wide.problem.film.setAttitude(wide.attitude);
        QCOMPARE(allocations.load(), before);
    }
};

TOUCHDOWN_TEST(TestGasFilmSurface)

} // namespace test_gas_film_surface

#include "test_gas_film_surface.moc"
