// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/gmres.h"

#include <cmath>
#include <complex>
#include <random>
#include <span>
#include <type_traits>

#include <Eigen/Dense>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_gmres {

template <typename T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
template <typename T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;

/// Entries of a normal distribution about zero, plus `diagonal`.
template <typename T>
Matrix<T> randomMatrix(int n, double diagonal, std::mt19937& random)
{
    std::normal_distribution<double> normal;
    Matrix<T> a(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if constexpr (std::is_same_v<T, double>)
                a(i, j) = normal(random);
            else
                a(i, j) = T(normal(random), normal(random));
        }
    a.diagonal().array() += diagonal;
    return a;
}

template <typename T>
GmresResult solve(Gmres<T>& gmres, const Matrix<T>& a, const Matrix<T>& inverse, const Vector<T>& b, Vector<T>& x,
                  const GmresOptions& options)
{
    const auto times = [](const Matrix<T>& m) {
        return [&m](std::span<const T> v, std::span<T> out) {
            const auto size = static_cast<Eigen::Index>(v.size());
            Eigen::Map<Vector<T>>(out.data(), size) = m * Eigen::Map<const Vector<T>>(v.data(), size);
        };
    };
    const auto span = [](auto& v) { return std::span(v.data(), static_cast<std::size_t>(v.size())); };
    return gmres.solve(times(a), times(inverse), std::span<const T>(span(b)), std::span<T>(span(x)), options);
}

template <typename T>
void checkAgainstEigen(double diagonal, int restart)
{
    std::mt19937 random(3);
    constexpr int n = 30;
    const Matrix<T> a = randomMatrix<T>(n, diagonal, random), identity = Matrix<T>::Identity(n, n);
    const Vector<T> b = randomMatrix<T>(n, 0.0, random).col(0);
    Gmres<T> gmres(n, restart);
    Vector<T> x = Vector<T>::Zero(n);
    const GmresResult result = solve<T>(gmres, a, identity, b, x, {.tolerance = 1e-12, .maximumIterations = 400});
    QVERIFY(result.converged);
    const Vector<T> exact = a.partialPivLu().solve(b);
    QVERIFY((x - exact).norm() < 1e-9 * exact.norm());
    // What it says it has reached is so.
    QVERIFY(std::abs((b - a * x).norm() / b.norm() - result.residual) < 1e-13);
}

class TestGmres : public QObject {
    Q_OBJECT

private slots:
    void againstEigen()
    {
        checkAgainstEigen<double>(0.0, 40);
        checkAgainstEigen<std::complex<double>>(0.0, 40);
    }
    /// Eigenvalues lie about 20, within sqrt(30) (sqrt(60) complex): each five steps shrink the residual by (5.5/20)^5.
    void withRestarts()
    {
        checkAgainstEigen<double>(20.0, 5);
        checkAgainstEigen<std::complex<double>>(20.0, 5);
    }

    /// Asked after each iteration but the one that reaches the tolerance; once it says no, x is the least residual of
    /// the iterations so far, as with so many of them at most.
    void stops()
    {
        std::mt19937 random(5);
        constexpr int n = 30;
        const Matrix<double> a = randomMatrix<double>(n, 20.0, random), identity = Matrix<double>::Identity(n, n);
        const Vector<double> b = randomMatrix<double>(n, 0.0, random).col(0);
        Gmres<double> gmres(n, 5);
        int calls = 0;
        Vector<double> x = Vector<double>::Zero(n);
        const GmresResult whole =
            solve<double>(gmres, a, identity, b, x,
                          {.tolerance = 1e-10, .maximumIterations = 400, .goOn = [&] { return ++calls > 0; }});
        QVERIFY(whole.converged && whole.iterations > 10);
        QCOMPARE(calls, whole.iterations - 1);
        for (const int last : {1, 4, 5, 7}) {
            Vector<double> stopped = Vector<double>::Zero(n), limited = stopped;
            int asked = 0;
            const GmresResult result =
                solve<double>(gmres, a, identity, b, stopped,
                              {.tolerance = 1e-10, .maximumIterations = 400, .goOn = [&] { return ++asked < last; }});
            QVERIFY(!result.converged);
            QCOMPARE(asked, last);
            QCOMPARE(result.iterations, last);
            solve<double>(gmres, a, identity, b, limited,
                          {.tolerance = 0.5 * result.residual, .maximumIterations = last});
            QVERIFY(stopped == limited);
        }
    }

    /// A shift of the unknowns in a circle: no step before the last one comes nearer, so that restarts never would.
    void givesUp()
    {
        constexpr int n = 30;
        Matrix<double> a = Matrix<double>::Zero(n, n);
        for (int i = 0; i < n; ++i) a((i + 1) % n, i) = 1.0;
        const Matrix<double> identity = Matrix<double>::Identity(n, n);
        Vector<double> b = Vector<double>::Zero(n), x = b;
        b[0] = 1.0;
        Gmres<double> restarted(n, 5), whole(n, n);
        const GmresResult result = solve<double>(restarted, a, identity, b, x, {.maximumIterations = 400});
        QVERIFY(!result.converged && result.residual == 1.0);
        QCOMPARE(result.iterations, 5);
        QVERIFY(solve<double>(whole, a, identity, b, x, {.maximumIterations = 400}).converged);
    }

    /// The residual after k steps is the least of b - A y, y in the k-dimensional Krylov space: found here by least
    /// squares.
    void residualIsMinimal()
    {
        std::mt19937 random(9);
        constexpr int n = 12;
        const auto a = randomMatrix<std::complex<double>>(n, 2.0, random);
        const Matrix<std::complex<double>> identity = Matrix<std::complex<double>>::Identity(n, n);
        const Vector<std::complex<double>> b = a.col(0) + identity.col(3);
        Matrix<std::complex<double>> krylov(n, 0);
        Vector<std::complex<double>> next = b;
        for (int k = 1; k <= 8; ++k) {
            krylov.conservativeResize(n, k);
            krylov.col(k - 1) = next.normalized();
            next = a * krylov.col(k - 1);
            const Matrix<std::complex<double>> image = a * krylov;
            const double least = (b - image * image.householderQr().solve(b)).norm() / b.norm();
            Gmres<std::complex<double>> gmres(n, 20);
            Vector<std::complex<double>> x = Vector<std::complex<double>>::Zero(n);
            const GmresResult result = solve(gmres, a, identity, b, x, {.tolerance = 1e-14, .maximumIterations = k});
            QCOMPARE(result.iterations, k);
            QVERIFY(!result.converged);
            QVERIFY(std::abs(result.residual - least) < 1e-11);
        }
    }

    /// With the exact inverse one step is enough.
    void exactPreconditioner()
    {
        std::mt19937 random(4);
        const auto a = randomMatrix<double>(20, 0.0, random);
        const Matrix<double> inverse = a.inverse();
        const Vector<double> b = Vector<double>::Ones(20);
        Vector<double> x = Vector<double>::Zero(20);
        Gmres<double> gmres(20);
        const GmresResult result = solve(gmres, a, inverse, b, x, {.tolerance = 1e-10, .maximumIterations = 10});
        QCOMPARE(result.iterations, 1);
        QVERIFY(result.converged);
        QVERIFY((a * x - b).norm() < 1e-9);
    }

    void theSolutionAsGuess()
    {
        std::mt19937 random(4);
        const auto a = randomMatrix<double>(10, 0.0, random);
        const Matrix<double> identity = Matrix<double>::Identity(10, 10);
        const Vector<double> exact = Vector<double>::LinSpaced(10, 1.0, 2.0), b = a * exact;
        Vector<double> x = exact;
        Gmres<double> gmres(10);
        const GmresResult result = solve(gmres, a, identity, b, x, {.tolerance = 1e-10, .maximumIterations = 10});
        QCOMPARE(result.iterations, 0);
        QVERIFY(result.converged);
        QCOMPARE(x, exact);
    }

    void zeroRightHandSide()
    {
        const Matrix<double> a = Matrix<double>::Identity(5, 5);
        const Vector<double> b = Vector<double>::Zero(5);
        Vector<double> x = Vector<double>::Ones(5);
        Gmres<double> gmres(5);
        const GmresResult result = solve(gmres, a, a, b, x, {});
        QVERIFY(result.converged);
        QCOMPARE(result.iterations, 0);
        QCOMPARE(x, b);
    }

    /// A = diag(1, 2, 0), b = (1, 1, 1): no x brings the last equation down. The residual stays 1/sqrt(3); it says so,
    /// and ends.
    void singular()
    {
        Matrix<double> a = Matrix<double>::Zero(3, 3);
        a(0, 0) = 1.0;
        a(1, 1) = 2.0;
        const Matrix<double> identity = Matrix<double>::Identity(3, 3);
        const Vector<double> b = Vector<double>::Ones(3);
        Vector<double> x = Vector<double>::Zero(3);
        Gmres<double> gmres(3, 10);
        const GmresResult result = solve(gmres, a, identity, b, x, {.tolerance = 1e-6, .maximumIterations = 30});
        QVERIFY(!result.converged);
        QVERIFY(x.allFinite());
        QVERIFY(std::abs(result.residual - 1.0 / std::sqrt(3.0)) < 1e-9);
    }
    /// The same with a right-hand side that has a solution, and with A = 0, where not even one step is possible.
    void singularButConsistent()
    {
        Matrix<double> a = Matrix<double>::Zero(3, 3);
        a(0, 0) = 1.0;
        a(1, 1) = 2.0;
        const Matrix<double> identity = Matrix<double>::Identity(3, 3);
        Vector<double> b(3), x = Vector<double>::Zero(3);
        b << 1.0, 1.0, 0.0;
        Gmres<double> gmres(3, 10);
        QVERIFY(solve(gmres, a, identity, b, x, {.tolerance = 1e-12, .maximumIterations = 30}).converged);
        QVERIFY(std::abs(x(0) - 1.0) < 1e-12 && std::abs(x(1) - 0.5) < 1e-12);

        a.setZero();
        x.setZero();
        const GmresResult none = solve(gmres, a, identity, b, x, {.tolerance = 1e-12, .maximumIterations = 30});
        QVERIFY(!none.converged);
        QVERIFY(x.allFinite());
        QCOMPARE(none.residual, 1.0);
    }

    /// What is not a number ends it without an endless loop.
    void notANumber()
    {
        const Matrix<double> identity = Matrix<double>::Identity(3, 3);
        Matrix<double> a = identity;
        a(1, 1) = std::nan("");
        const Vector<double> b = Vector<double>::Ones(3);
        Vector<double> x = Vector<double>::Zero(3);
        Gmres<double> gmres(3, 10);
        const GmresResult result = solve(gmres, a, identity, b, x, {});
        QVERIFY(!result.converged);
        QVERIFY(result.iterations <= 60);
    }
};

TOUCHDOWN_TEST(TestGmres)

} // namespace test_gmres

#include "test_gmres.moc"
