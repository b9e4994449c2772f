// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_rate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/physics/film/film_step.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_rate {

constexpr double L = 0.2e-3, W = 0.15e-3;

FilmSetting setting(double speed, SlipModel slip)
{
    FilmSetting result;
    result.disk = uniformMotion(speed);
    result.slip.model = slip;
    result.scheme = ConvectionScheme::Exponential;
    return result;
}

/// A low slider: 2 nm at its trailing edge.
struct LowSlider : FilmProblem {
    LowSlider()
        : FilmProblem(planeSurface(), L, W, uniformGrid(L, W, 24, 16), setting(15.0, SlipModel::FukuiKaneko),
                      {2e-9, 100e-6, 0.0})
    {
        if (!solve({.tolerance = 1e-12, .maximumIterations = 100}).converged) qFatal("the film was not solved");
        linearise();
    }
    double linearise()
    {
        std::vector<double> residual(p.size());
        film.linearise(p, residual);
        return residualNorm(film, residual);
    }
    /// Largest distance from other pressures, against ambient [-].
    double from(const std::vector<double>& other) const
    {
        double largest = 0.0;
        for (std::size_t at = 0; at < p.size(); ++at)
            largest = std::max(largest, std::abs(p[at] - other[at]) / film.ambient());
        return largest;
    }
    /// dp = -dt R/V, a number of times; false where that left what pressures can be.
    bool explicitSteps(double dt, int count)
    {
        std::vector<double> residual(p.size());
        for (int n = 0; n < count; ++n) {
            film.residual(p, residual);
            for (int j = 0; j < gaps.pad.ny; ++j)
                for (int i = 0; i < gaps.pad.nx; ++i) {
                    const std::size_t at = gaps.pad.at(i, j);
                    p[at] -= dt * residual[at] / film.volumes()[at];
                    if (!(p[at] > 0.0) || p[at] > 1e6 * film.ambient()) return false;
                }
        }
        return true;
    }
    void disturb()
    {
        for (int j = 0; j < gaps.pad.ny; ++j)
            for (int i = 0; i < gaps.pad.nx; ++i) p[gaps.pad.at(i, j)] *= 1.0 + 1e-3 * ((i + j) % 2 == 0 ? 1.0 : -1.0);
    }
};

class TestFilmRate : public QObject {
    Q_OBJECT

private slots:
    /// An even gap, a disk at rest, no slip: dp/dt = D div grad p with D = p0 h^2/(12 mu) around ambient, and the
    /// five-point formula has its largest eigenvalue just below 4 D (1/dx^2 + 1/dy^2).
    void evenGap()
    {
        constexpr int nx = 32, ny = 24;
        const double h = 100e-9;
        FilmProblem problem(planeSurface(), L, W, uniformGrid(L, W, nx, ny), setting(0.0, SlipModel::Continuum),
                            {h, 0.0, 0.0});
        std::vector<double> residual(problem.p.size());
        problem.film.linearise(problem.p, residual);
        const Air air;
        const double diffusion = air.pressure * h * h / (12.0 * air.viscosity);
        const double limit = 4.0 * diffusion * (nx * nx / (L * L) + ny * ny / (W * W)),
                     rate = fastestFilmRate(problem.film);
        QVERIFY2(std::abs(rate / limit - 1.0) < 1e-9, qPrintable(QString::number(rate / limit)));
    }
    /// The air under a low slider in explicit steps: below 2/rate it comes back to its steady state, at 1.3 times that
    /// it runs away, as the gap, which is largest at the inlet, is even over a few cells only. Implicit steps of a
    /// thousand times that length lead to the steady state, and stay.
    void explicitStepsHaveALimit()
    {
        LowSlider slider;
        const std::vector<double> steady = slider.p;
        const double limit = 2.0 / fastestFilmRate(slider.film);
        slider.disturb();
        const double disturbed = slider.from(steady);
        QVERIFY(slider.explicitSteps(0.95 * limit, 3000));
        QVERIFY2(slider.from(steady) < 0.1 * disturbed, qPrintable(QString::number(slider.from(steady) / disturbed)));

        slider.p = steady;
        slider.disturb();
        QVERIFY(!slider.explicitSteps(1.3 * limit, 3000) || slider.from(steady) > 10.0 * disturbed);

        slider.p = steady;
        slider.disturb();
        FilmStepper stepper(slider.film, {.tolerance = 1e-11});
        stepper.start(slider.p);
        for (int n = 0; n < 12; ++n) {
            const FilmStepResult step = stepper.step(1000.0 * limit, slider.film.attitude());
            QVERIFY(step.converged && stepper.accept());
        }
        std::copy(stepper.pressure().begin(), stepper.pressure().end(), slider.p.begin());
        QVERIFY2(slider.from(steady) < 1e-6, qPrintable(QString::number(slider.from(steady))));
    }
    /// Halved cells quarter the explicit step of diffusion, which leads beside a slow disk.
    void theLimitGoesWithTheCells()
    {
        const auto rate = [](int n) {
            FilmProblem problem(planeSurface(), L, W, uniformGrid(L, W, n, n), setting(0.1, SlipModel::FukuiKaneko),
                                {10e-9, 100e-6, 0.0});
            std::vector<double> residual(problem.p.size());
            problem.film.linearise(problem.p, residual);
            return fastestFilmRate(problem.film);
        };
        const double order = std::log2(rate(64) / rate(32));
        QVERIFY2(std::abs(order - 2.0) < 0.15, qPrintable(QString::number(order)));
    }
};

TOUCHDOWN_TEST(TestFilmRate)

} // namespace test_film_rate

#include "test_film_rate.moc"
