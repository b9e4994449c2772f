// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_newton.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/physics/film/slip_model.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_newton {

constexpr double L = 1e-3, W = 0.8e-3;

AirBearingSurface railed()
{
    AirBearingSurface surface;
    surface.baseRecess = 1e-6;
    surface.rails = {{.points = {{0.1 * L, 0.2 * W}, {0.95 * L, 0.2 * W}, {0.95 * L, 0.8 * W}, {0.1 * L, 0.8 * W}},
                      .recess = {0.0}}};
    return surface;
}

FilmSetting setting(ConvectionScheme scheme = ConvectionScheme::CompleteFlux)
{
    FilmSetting result;
    result.disk = uniformMotion(15.0, 0.1);
    result.scheme = scheme;
    return result;
}

constexpr Attitude flying{15e-9, 120e-6, 3e-6};

class TestFilmNewton : public QObject {
    Q_OBJECT

private slots:
    /// Each of Newton's steps near the end takes the residual to a constant of its linear solver's 1e-4, or better.
    void convergesFast()
    {
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 40, 32), setting(), flying);
        std::vector<double> residuals;
        FilmNewton newton(problem.film);
        const FilmSolution solution =
            newton.solve(problem.p, {.tolerance = 1e-10}, [&](int iteration, double residual) {
                const auto told = static_cast<int>(residuals.size());
                if (iteration == told) residuals.push_back(residual);
                return iteration == told || (iteration == told - 1 && residual == residuals.back());
            });
        QVERIFY(solution.converged);
        QVERIFY(!solution.cancelled);
        QVERIFY(solution.residual <= 1e-10);
        QCOMPARE(static_cast<int>(residuals.size()), solution.iterations + 1);
        QVERIFY2(solution.iterations <= 9, qPrintable(QString::number(solution.iterations)));
        QVERIFY(residuals.back() < 0.05 * residuals[residuals.size() - 2]);
        // What it says is so, and the film is left linearised there.
        std::vector<double> residual(problem.p.size());
        problem.film.residual(problem.p, residual);
        QVERIFY(std::abs(residualNorm(problem.film, residual) - solution.residual) < 1e-12);
    }

    void saysWhenItHasNotConverged()
    {
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 24, 20), setting(), flying);
        const FilmSolution one = problem.solve({.maximumIterations = 1});
        QVERIFY(!one.converged);
        QVERIFY(!one.cancelled);
        QCOMPARE(one.iterations, 1);
        QVERIFY(one.residual > 1e-7);
        const FilmSolution none = problem.solve({.maximumIterations = 0});
        QVERIFY(!none.converged);
        QCOMPARE(none.iterations, 0);
        QCOMPARE(none.residual, one.residual); // went on from where it was
        QVERIFY(problem.solve().converged);
        const FilmSolution again = problem.solve();
        QVERIFY(again.converged);
        QCOMPARE(again.iterations, 0);
    }

    void cancels()
    {
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 24, 20), setting(), flying);
        const FilmSolution solution =
            FilmNewton(problem.film).solve(problem.p, {}, [](int iteration, double) { return iteration < 2; });
        QVERIFY(solution.cancelled);
        QVERIFY(!solution.converged);
        QCOMPARE(solution.iterations, 2);
    }

    /// Asked at each of Newton's iterations and after each of the linear solver's but the last one of a solution, which
    /// its tolerance ends: solves + 1 times. Whenever it says no, that was the last time, and the pressure is one that
    /// was accepted.
    void isAskedAtEachLinearIteration()
    {
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 24, 20), setting(), flying);
        const std::vector<double> start = problem.p;
        int calls = 0;
        const FilmSolution whole =
            FilmNewton(problem.film).solve(problem.p, {}, [&](int, double) { return ++calls > 0; });
        QVERIFY(whole.converged);
        QCOMPARE(calls, whole.solves + 1);
        for (int last = 1; last <= calls; ++last) {
            problem.p = start;
            int asked = 0;
            const FilmSolution stopped =
                FilmNewton(problem.film).solve(problem.p, {}, [&](int, double) { return ++asked < last; });
            QVERIFY(stopped.cancelled && !stopped.converged);
            QCOMPARE(asked, last);
            std::vector<double> residual(problem.p.size());
            problem.film.residual(problem.p, residual);
            QVERIFY(std::abs(residualNorm(problem.film, residual) - stopped.residual) < 1e-12);
        }
    }

    /// The guess does not matter: from p0 and from a wild one the same pressure.
    void anyGuess()
    {
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 24, 20), setting(), flying);
        QVERIFY(problem.solve({.tolerance = 1e-11}).converged);
        const std::vector<double> p = problem.p;
        const PaddedGrid& pad = problem.gaps.pad;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i)
                problem.p[pad.at(i, j)] = problem.film.ambient() * (i % 3 == 0 ? 8.0 : 0.3);
        QVERIFY(problem.solve({.tolerance = 1e-11}).converged);
        for (std::size_t at = 0; at < p.size(); ++at) QVERIFY(std::abs(problem.p[at] / p[at] - 1.0) < 1e-7);
    }

    /// The trailing edge at the disk and below: no air where the gap is closed, pressures finite and positive all the
    /// same.
    void contact_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<ConvectionScheme>("scheme");
        for (const double height : {1e-9, 0.0, -1e-9, -5e-9}) {
            QTest::addRow("%g nm, power law", 1e9 * height) << height << ConvectionScheme::PowerLaw;
            QTest::addRow("%g nm, complete flux", 1e9 * height) << height << ConvectionScheme::CompleteFlux;
        }
    }
    void contact()
    {
        QFETCH(double, height);
        QFETCH(ConvectionScheme, scheme);
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 40, 32), setting(scheme), {height, 100e-6, 3e-6});
        const FilmSolution solution = problem.solve();
        QVERIFY2(solution.converged, qPrintable(QString::number(solution.residual)));
        for (const double p : problem.p) QVERIFY(std::isfinite(p) && p > 0.0);
        QVERIFY(std::isfinite(problem.load()) && problem.load() > 0.05);
    }

    /// Newton's system solved by multigrid and gmres, and its transpose: J x = b to the tolerance asked for.
    void linearSystems()
    {
        FilmProblem problem(railed(), L, W, uniformGrid(L, W, 32, 24), setting(), flying);
        QVERIFY(problem.solve().converged);
        const PaddedGrid& pad = problem.gaps.pad;
        std::vector<double> b(pad.size(), 0.0), x(pad.size(), 0.0), image(pad.size(), 0.0);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) b[pad.at(i, j)] = std::sin(0.3 * i) + std::cos(0.5 * j);
        FaceFlows<double> work;
        work.resize(pad.size());
        const auto error = [&] {
            double difference = 0.0, size = 0.0;
            for (std::size_t at = 0; at < b.size(); ++at) {
                difference += (image[at] - b[at]) * (image[at] - b[at]);
                size += b[at] * b[at];
            }
            return std::sqrt(difference / size);
        };
        FilmLinearSolver solver(problem.film);
        solver.prepare();
        QVERIFY(solver.solve(b, x, {.tolerance = 1e-8, .maximumIterations = 60}).converged);
        problem.film.applyJacobian<double>(x, image, work);
        QVERIFY(error() < 1.1e-8);

        std::fill(x.begin(), x.end(), 0.0);
        solver.prepareTransposed();
        QVERIFY(solver.solveTransposed(b, x, {.tolerance = 1e-8, .maximumIterations = 200}).converged);
        problem.film.applyTransposedJacobian(x, image, work);
        QVERIFY(error() < 1.1e-8);
    }

    /// A cavity behind a rail, under a fast disk, and a guess with one cell far too high. Linearised there the
    /// diffusion's dependence on the pressure counts, and Newton's whole step leads to pressures below zero. The
    /// bounded one does not, and the method goes on from there to the solution, whatever the scheme.
    void aWholeStepGoesBelowZero_data()
    {
        QTest::addColumn<ConvectionScheme>("scheme");
        QTest::newRow("power law") << ConvectionScheme::PowerLaw;
        QTest::newRow("complete flux") << ConvectionScheme::CompleteFlux;
    }
    void aWholeStepGoesBelowZero()
    {
        QFETCH(ConvectionScheme, scheme);
        AirBearingSurface surface;
        surface.baseRecess = 0.6e-6;
        surface.rails = {{.points = {{0.0, 0.0}, {0.3 * L, 0.0}, {0.3 * L, W}, {0.0, W}}, .recess = {0.0}}};
        FilmSetting fast = setting(scheme);
        fast.disk = uniformMotion(1000.0);
        fast.slip.model = SlipModel::Continuum;
        FilmProblem problem(surface, L, W, uniformGrid(L, W, 24, 16), fast, {20e-9, 80e-6, 0.0});
        problem.p[problem.gaps.pad.at(12, 8)] *= 100.0;
        std::vector<double> residual(problem.p.size()), step(problem.p.size(), 0.0);
        problem.film.linearise(problem.p, residual);
        for (double& each : residual) each = -each;
        FilmLinearSolver linear(problem.film);
        linear.prepare();
        QVERIFY(linear.solve(residual, step, {.tolerance = 1e-6, .maximumIterations = 200}).converged);
        std::vector<double> whole = problem.p, bounded = problem.p;
        for (std::size_t at = 0; at < whole.size(); ++at) whole[at] += step[at];
        addBounded(bounded, step);
        QVERIFY2(*std::ranges::min_element(whole) < 0.0, qPrintable(QString::number(*std::ranges::min_element(whole))));
        QVERIFY(*std::ranges::min_element(bounded) > 0.0);
        QVERIFY(problem.solve().converged);
        QVERIFY(problem.lowest() > 0.0 && problem.lowest() < 0.5 * problem.film.ambient());
    }

    /// Steps that would empty a cell end at a third, steps that would fill it at three times its pressure.
    void boundedSteps()
    {
        std::vector<double> p{6.0, 6.0, 6.0, 6.0};
        addBounded(p, std::vector<double>{1.0, -3.0, -5.0, 100.0});
        QCOMPARE(p, (std::vector<double>{7.0, 3.0, 2.0, 18.0}));
    }
};

TOUCHDOWN_TEST(TestFilmNewton)

} // namespace test_film_newton

#include "test_film_newton.moc"
