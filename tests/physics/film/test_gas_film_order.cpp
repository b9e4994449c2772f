// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/physics/film/gas_film.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_gas_film_order {

// Oblique films. The gap h = 2 - s and the disk's motion change and point along one direction only, s = x cos a + y sin
// a, through pitch, roll and skew; so does the pressure, in a flow without divergence:
//
//   U p h/2 - h^2 G(p h)/(12 mu) dp/ds = C,   constant.
//
// Held on the outline to this solution of the ordinary equation, the film must find it inside, where flows along x and
// y each change from cell to cell: what the flow across adds counts as much as the flow along. The gap is a plane, so
// the error is the scheme's alone. Solved against the stream by the Runge-Kutta method from beyond the trailing corner,
// so that all layers at that end are outside: smooth at any Peclet number.

constexpr double side = 1e-3, angle = 0.5, gapAtOrigin = 400e-9, slope = 200e-6; // h = gapAtOrigin - slope s
constexpr Air air{};

class ObliqueFilm {
public:
    ObliqueFilm(double speed, const Slip& slip) : table_(slip, air), speed_(speed)
    {
        // So much air that the pressure is about 2 p0 in the middle.
        const double farthest = 1.5 * side, flow = 0.5 * speed * 2.0 * air.pressure * gap(0.7 * side);
        step_ = farthest / steps;
        double p = 2.0 * flow / (speed * gap(farthest));
        pressure_.resize(steps + 1);
        for (int i = steps; i >= 0; --i) {
            pressure_[static_cast<std::size_t>(i)] = p;
            const double s = i * step_;
            const auto change = [&](double at, double value) {
                const double h = gap(at);
                return (0.5 * speed_ * value * h - flow) * 12.0 * air.viscosity /
                       (h * h * table_.at(value * h, h).mobility);
            };
            const double k1 = change(s, p), k2 = change(s - 0.5 * step_, p - 0.5 * step_ * k1);
            const double k3 = change(s - 0.5 * step_, p - 0.5 * step_ * k2), k4 = change(s - step_, p - step_ * k3);
            p -= step_ / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
    }
    static double gap(double s) { return gapAtOrigin - slope * s; }
    /// Cubic between four points of the solution.
    double pressure(double x, double y) const
    {
        const double place = (x * std::cos(angle) + y * std::sin(angle)) / step_;
        const std::size_t k = std::clamp(static_cast<std::size_t>(place), std::size_t{1}, std::size_t{steps - 2});
        const double t = place - static_cast<double>(k);
        const double a = pressure_[k - 1], b = pressure_[k], c = pressure_[k + 1], d = pressure_[k + 2];
        // Lagrange's polynomial through -1, 0, 1, 2.
        return -a * t * (t - 1.0) * (t - 2.0) / 6.0 + b * (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 -
               c * (t + 1.0) * t * (t - 2.0) / 2.0 + d * (t + 1.0) * t * (t - 1.0) / 6.0;
    }

private:
    static constexpr int steps = 60000;
    FlowTable table_;
    double speed_, step_ = 0.0;
    std::vector<double> pressure_;
};

/// Root mean square of the error over the cells [p0].
double error(const ObliqueFilm& exact, double speed, ConvectionScheme scheme, int n)
{
    // The disk drags along (cos a, sin a): skew -a.
    const FilmSetting setting{.air = air, .slip = {}, .disk = uniformMotion(speed, -angle), .scheme = scheme};
    const double pitch = slope * std::cos(angle), roll = slope * std::sin(angle);
    const Attitude attitude{gapAtOrigin - pitch * side - 0.5 * roll * side, pitch, roll};
    FilmProblem problem(planeSurface(), side, side, uniformGrid(side, side, n, n), setting, attitude);
    const PaddedGrid& pad = problem.gaps.pad;
    for (int k = 0; k < n; ++k) {
        const double centre = (k + 0.5) * side / n;
        problem.p[pad.at(-1, k)] = exact.pressure(0.0, centre);
        problem.p[pad.at(n, k)] = exact.pressure(side, centre);
        problem.p[pad.at(k, -1)] = exact.pressure(centre, 0.0);
        problem.p[pad.at(k, n)] = exact.pressure(centre, side);
    }
    if (!problem.solve({.tolerance = 1e-11}).converged) return std::nan("");
    double sum = 0.0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const double e = problem.at(i, j) - exact.pressure((i + 0.5) * side / n, (j + 0.5) * side / n);
            sum += e * e;
        }
    return std::sqrt(sum) / n / air.pressure;
}

/// The same along a flat gap without diffusion to speak of: each streamline keeps its pressure. The scheme alone mixes
/// them.
double streamlineError(ConvectionScheme scheme, double angleOfFlow, int n)
{
    const FilmSetting setting{.air = air,
                              .slip = {.model = SlipModel::Continuum},
                              .disk = uniformMotion(1e9, -angleOfFlow),
                              .scheme = scheme};
    FilmProblem problem(planeSurface(), side, side, uniformGrid(side, side, n, n), setting, {200e-9, 0.0, 0.0});
    const auto exact = [&](double x, double y) {
        return air.pressure * (2.0 + std::sin(7.0 * (x * std::sin(angleOfFlow) - y * std::cos(angleOfFlow)) / side));
    };
    const PaddedGrid& pad = problem.gaps.pad;
    for (int k = 0; k < n; ++k) {
        const double centre = (k + 0.5) * side / n;
        problem.p[pad.at(-1, k)] = exact(0.0, centre);
        problem.p[pad.at(n, k)] = exact(side, centre);
        problem.p[pad.at(k, -1)] = exact(centre, 0.0);
        problem.p[pad.at(k, n)] = exact(centre, side);
    }
    if (!problem.solve({.tolerance = 1e-11}).converged) return std::nan("");
    double sum = 0.0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            sum += std::pow(problem.at(i, j) - exact((i + 0.5) * side / n, (j + 0.5) * side / n), 2);
    return std::sqrt(sum) / n / air.pressure;
}

class TestGasFilmOrder : public QObject {
    Q_OBJECT

private slots:
    /// Smooth cross-stream profile, no diffusion: exponential fitting is upwind, whose error is that of the flow on
    /// either side of a cell and of first order (it falls like 1/n only slowly here: 0.85 to 0.95 from 64 to 128
    /// cells); the complete flux scheme counts how the flow across feeds the flow along, and is of second.
    void streamlines_data()
    {
        QTest::addColumn<ConvectionScheme>("scheme");
        QTest::addColumn<double>("angleOfFlow");
        QTest::addColumn<double>("order");
        for (const double a : {0.5, -1.2, 2.0}) {
            QTest::addRow("exponential, %g rad", a) << ConvectionScheme::Exponential << a << 0.87;
            QTest::addRow("complete flux, %g rad", a) << ConvectionScheme::CompleteFlux << a << 2.0;
        }
    }
    void streamlines()
    {
        QFETCH(ConvectionScheme, scheme);
        QFETCH(double, angleOfFlow);
        QFETCH(double, order);
        const double coarse = streamlineError(scheme, angleOfFlow, 32), fine = streamlineError(scheme, angleOfFlow, 64);
        const double observed = std::log2(coarse / fine);
        QVERIFY2(std::abs(observed - order) < (order < 1.0 ? 0.03 : 0.05), qPrintable(QString::number(observed)));
    }

    /// Along a sloping gap at low and high Peclet numbers; the flow's parts along x and y are constant here, so that
    /// exponential fitting, too, is of second order everywhere: convection carries p h. At 2000 m/s it finds the
    /// solution to eight digits.
    void slopingGap_data()
    {
        QTest::addColumn<ConvectionScheme>("scheme");
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("order");
        QTest::addColumn<double>("bound"); // of the error on 64 x 64 cells [p0]
        using enum ConvectionScheme;
        QTest::newRow("upwind, low Peclet") << Upwind << 1.0 << 1.0 << 1.3e-3;
        QTest::newRow("hybrid, low Peclet") << Hybrid << 1.0 << 2.0 << 1e-5;
        QTest::newRow("power law, low Peclet") << PowerLaw << 1.0 << 2.0 << 2.2e-5;
        QTest::newRow("exponential, low Peclet") << Exponential << 1.0 << 2.0 << 9e-6;
        QTest::newRow("complete flux, low Peclet") << CompleteFlux << 1.0 << 2.0 << 9e-6;
        QTest::newRow("upwind, high Peclet") << Upwind << 2000.0 << 1.0 << 9e-3;
        QTest::newRow("hybrid, high Peclet") << Hybrid << 2000.0 << 1.0 << 9e-3;
        QTest::newRow("power law, high Peclet") << PowerLaw << 2000.0 << 1.0 << 9e-3;
        QTest::newRow("exponential, high Peclet") << Exponential << 2000.0 << 2.0 << 4e-9;
        QTest::newRow("complete flux, high Peclet") << CompleteFlux << 2000.0 << 2.0 << 4e-9;
    }
    void slopingGap()
    {
        QFETCH(ConvectionScheme, scheme);
        QFETCH(double, speed);
        QFETCH(double, order);
        QFETCH(double, bound);
        const ObliqueFilm exact(speed, {});
        const double coarse = error(exact, speed, scheme, 32), fine = error(exact, speed, scheme, 64);
        const double observed = std::log2(coarse / fine);
        QVERIFY2(std::abs(observed - order) < 0.15, qPrintable(QString::number(observed)));
        QVERIFY2(fine < bound, qPrintable(QString::number(fine)));
    }
    /// Between, where diffusion and convection are alike, errors of both signs cancel and no order shows: the error is
    /// small.
    void slopingGapAtPecletOfOne()
    {
        const ObliqueFilm exact(20.0, {});
        for (const ConvectionScheme scheme : {ConvectionScheme::Exponential, ConvectionScheme::CompleteFlux}) {
            QVERIFY(error(exact, 20.0, scheme, 16) < 1.2e-4);
            QVERIFY(error(exact, 20.0, scheme, 64) < 3e-5);
        }
    }
};

TOUCHDOWN_TEST(TestGasFilmOrder)

} // namespace test_gas_film_order

#include "test_gas_film_order.moc"
