// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/multigrid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <span>
#include <type_traits>

#include <Eigen/SparseLU>
#include <QTest>

#include "core/numerics/convection.h"
#include "core/numerics/gmres.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_multigrid {

using Complex = std::complex<double>;

/// Convection and diffusion on nx x ny cells around which zero is held: fluxes F = c (v1 + v2)/2 - E (v2 - v1).
struct Flow {
    PaddedGrid pad;
    std::array<std::vector<double>, 2> diffusion, effective, convection;

    Flow(int nx, int ny) : pad{nx, ny}
    {
        for (auto* pair : {&diffusion, &effective, &convection})
            for (auto& field : *pair) field.assign(pad.size(), 0.0);
    }

    std::array<FaceOperator, 2> faces() const
    {
        return {FaceOperator{diffusion[0], effective[0], convection[0]},
                FaceOperator{diffusion[1], effective[1], convection[1]}};
    }

    /// Its matrix on the cells alone, `shift` added to the diagonal.
    template <typename T>
    Eigen::SparseMatrix<T> matrix(T shift = {}) const
    {
        std::vector<Eigen::Triplet<T>> entries;
        const auto number = [&](int i, int j) {
            return i < 0 || j < 0 || i >= pad.nx || j >= pad.ny ? -1 : j * pad.nx + i;
        };
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (int j = 0; j < pad.ny + (axis == 1); ++j)
                for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                    const std::size_t at = pad.at(i, j);
                    const int lower = axis == 0 ? number(i - 1, j) : number(i, j - 1), upper = number(i, j);
                    const double byLower = 0.5 * convection[axis][at] + effective[axis][at];
                    const double byUpper = 0.5 * convection[axis][at] - effective[axis][at];
                    const auto add = [&](int row, int column, double value) {
                        if (row >= 0 && column >= 0) entries.emplace_back(row, column, value);
                    };
                    add(lower, lower, byLower);
                    add(lower, upper, byUpper);
                    add(upper, lower, -byLower);
                    add(upper, upper, -byUpper);
                }
        for (int k = 0; k < pad.nx * pad.ny; ++k) entries.emplace_back(k, k, shift);
        Eigen::SparseMatrix<T> result(pad.nx * pad.ny, pad.nx * pad.ny);
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    }
};

/// A film's conductances, by gap h and cell sides dx, dy: K = h^3 dy/dx and c = h U dy across x, likewise across y; K
/// of the two half cells in series, and so h. Faces on the outline are half a cell from the held value.
Flow film(int nx, int ny, double dx, double dy, double speedX, double speedY, const std::vector<double>& gap)
{
    Flow flow(nx, ny);
    const auto h = [&](int i, int j) {
        return gap[static_cast<std::size_t>(std::clamp(j, 0, ny - 1) * nx + std::clamp(i, 0, nx - 1))];
    };
    const auto series = [](double a, double b) { return 2.0 * a * b / (a + b); };
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (int j = 0; j < ny + (axis == 1); ++j)
            for (int i = 0; i < nx + (axis == 0); ++i) {
                const std::size_t at = flow.pad.at(i, j);
                const int line = axis == 0 ? i : j, n = axis == 0 ? nx : ny;
                const double h1 = axis == 0 ? h(i - 1, j) : h(i, j - 1), h2 = h(i, j);
                const double shape = axis == 0 ? dy / dx : dx / dy;
                const double K = series(h1 * h1 * h1, h2 * h2 * h2) * shape * (line == 0 || line == n ? 2.0 : 1.0);
                const double c = axis == 0 ? series(h1, h2) * speedX * dy : series(h1, h2) * speedY * dx;
                flow.diffusion[axis][at] = K;
                flow.convection[axis][at] = c;
                flow.effective[axis][at] = effectiveConductance<ConvectionScheme::Exponential>(K, c).value;
            }
    return flow;
}

std::vector<double> evenGap(int nx, int ny) { return std::vector<double>(static_cast<std::size_t>(nx * ny), 1.0); }

/// Rails: blocks of gap 1 on a ground of gap `ratio`.
std::vector<double> railGap(int nx, int ny, double ratio)
{
    std::vector<double> gap(static_cast<std::size_t>(nx * ny), ratio);
    const auto block = [&](double x0, double x1, double y0, double y1) {
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                if (i + 0.5 > x0 * nx && i + 0.5 < x1 * nx && j + 0.5 > y0 * ny && j + 0.5 < y1 * ny)
                    gap[static_cast<std::size_t>(j * nx + i)] = 1.0;
    };
    block(0.1, 0.35, 0.05, 0.95);
    block(0.55, 0.75, 0.1, 0.3);
    block(0.55, 0.75, 0.7, 0.9);
    block(0.85, 0.97, 0.41, 0.58);
    return gap;
}

/// exp of a normal distribution, cell by cell: neighbouring conductances differ by decades.
std::vector<double> randomGap(int nx, int ny)
{
    std::mt19937 random(8);
    std::normal_distribution<double> normal;
    std::vector<double> gap;
    for (int k = 0; k < nx * ny; ++k) gap.push_back(std::exp(normal(random)));
    return gap;
}

template <typename T>
struct Solved {
    GmresResult result;
    double error; // against the direct solution [-]
};

template <typename T>
Solved<T> solve(const Flow& flow, T shift, double tolerance)
{
    const PaddedGrid& pad = flow.pad;
    const Eigen::SparseMatrix<T> a = flow.matrix<T>(shift);
    using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Column exact(a.rows());
    for (Eigen::Index k = 0; k < exact.size(); ++k) {
        if constexpr (std::is_same_v<T, double>)
            exact(k) = uniform(random);
        else
            exact(k) = T(uniform(random), uniform(random));
    }
    const Column right = a * exact;

    Multigrid<T> multigrid(pad);
    std::vector<T> diagonal(pad.size());
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) diagonal[pad.at(i, j)] = shift;
    multigrid.setOperator(flow.faces(), diagonal);
    const auto plain = [&](std::span<const T> padded) {
        const std::vector<T> cells = pad.unpad<T>(padded);
        return Column(Eigen::Map<const Column>(cells.data(), static_cast<Eigen::Index>(cells.size())));
    };
    const auto apply = [&](std::span<const T> v, std::span<T> out) {
        const Column product = a * plain(v);
        pad.pad<T>(std::span<const T>(product.data(), static_cast<std::size_t>(product.size())), out);
    };
    const auto precondition = [&](std::span<const T> v, std::span<T> out) { multigrid.precondition(v, out); };
    std::vector<T> b(pad.size()), x(pad.size());
    pad.pad<T>(std::span<const T>(right.data(), static_cast<std::size_t>(right.size())), b);
    Gmres<T> gmres(pad.size(), 60);
    Solved<T> solved;
    solved.result = gmres.solve(apply, precondition, std::span<const T>(b), std::span<T>(x),
                                {.tolerance = tolerance, .maximumIterations = 60});
    solved.error = (plain(x) - exact).norm() / exact.norm();
    return solved;
}

/// What the factors leave of b, as |(D + X') D^-1 (D + Y') v - b|/|b|: cells store `mass` and faces pass some of it on.
/// D is the mass, or what flows out of a cell along x and y where that is more; X' and Y' have as much less in their
/// diagonals.
double factorError(double mass)
{
    const int nx = 23, ny = 18;
    const Flow flow = film(nx, ny, 1.0, 0.7, 5.0, 1.0, randomGap(nx, ny));
    const PaddedGrid& pad = flow.pad;
    Flow all = flow;
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t at = 0; at < pad.size(); ++at) {
            all.convection[axis][at] -= 0.3 * mass;
            all.effective[axis][at] -= 0.1 * mass;
        }
    const auto along = [](Flow of, std::size_t axis) {
        for (auto* pair : {&of.convection, &of.effective}) std::ranges::fill((*pair)[1 - axis], 0.0);
        return of.matrix<double>();
    };
    Multigrid<double> multigrid(pad);
    const std::vector<double> masses(pad.size(), mass);
    multigrid.setOperator(all.faces(), masses);
    multigrid.setFactors(all.faces(), flow.faces(), masses);
    std::vector<double> b(pad.size()), v(pad.size());
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) b[pad.at(i, j)] = std::sin(1.3 * i + 0.4 * j * j);
    multigrid.solveFactors(b, v);

    const Eigen::VectorXd flowX = along(flow, 0).diagonal(), flowY = along(flow, 1).diagonal();
    const Eigen::VectorXd D = (flowX + flowY).cwiseMax(mass);
    const Eigen::VectorXd less = (D.array() - mass) / (flowX + flowY).array();
    const std::vector<double> cells = pad.unpad<double>(v), right = pad.unpad<double>(b);
    const Eigen::Map<const Eigen::VectorXd> solution(cells.data(), D.size());
    const Eigen::VectorXd inner =
        along(all, 1) * solution + ((D.array() - less.array() * flowY.array()) * solution.array()).matrix();
    const Eigen::VectorXd quotient = inner.cwiseQuotient(D);
    const Eigen::VectorXd product =
        along(all, 0) * quotient + ((D.array() - less.array() * flowX.array()) * quotient.array()).matrix();
    return (product - Eigen::Map<const Eigen::VectorXd>(right.data(), D.size())).norm() / product.norm();
}

/// Largest change of 3 M a - M b - M (3 a - b), against the latter's largest; infinite where it touches the rings.
template <typename T>
double nonlinearity()
{
    const Flow flow = film(23, 17, 1.0, 0.7, 5.0, 1.0, randomGap(23, 17));
    const PaddedGrid& pad = flow.pad;
    Multigrid<T> multigrid(pad);
    multigrid.setOperator(flow.faces(), {});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<T> a(pad.size()), b(pad.size()), sum(pad.size()), va = a, vb = a, vSum = a;
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            a[at] = uniform(random);
            b[at] = uniform(random);
            sum[at] = 3.0 * a[at] - b[at];
        }
    multigrid.precondition(a, va);
    multigrid.precondition(b, vb);
    multigrid.precondition(sum, vSum);
    double largest = 0.0, error = 0.0;
    for (const T& v : vSum) largest = std::max(largest, std::abs(v));
    for (std::size_t at = 0; at < pad.size(); ++at) error = std::max(error, std::abs(vSum[at] - 3.0 * va[at] + vb[at]));
    for (int i = -2; i < pad.nx + 2; ++i)
        for (const int j : {-2, -1, pad.ny, pad.ny + 1})
            if (vSum[pad.at(i, j)] != T{}) return INFINITY;
    return error / largest;
}

/// An operator of nine points; `coefficient(i, j, a, b)`: of cell (i + a, j + b) in the row of cell (i, j).
struct Nine {
    PaddedGrid pad;
    std::array<std::vector<float>, 8> beside;
    std::vector<float> sum;
    std::vector<Eigen::Triplet<double>> entries;

    template <typename Coefficient>
    Nine(const PaddedGrid& grid, const Coefficient& coefficient) : pad(grid), sum(grid.size(), 0.0f)
    {
        for (auto& field : beside) field.assign(pad.size(), 0.0f);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i)
                for (int place = 0; place < 9; ++place) {
                    const int m = i + place % 3 - 1, n = j + place / 3 - 1;
                    const float c = coefficient(i, j, m - i, n - j);
                    if (place != 4) beside[static_cast<std::size_t>(place < 4 ? place : place - 1)][pad.at(i, j)] = c;
                    sum[pad.at(i, j)] += c;
                    if (m >= 0 && n >= 0 && m < pad.nx && n < pad.ny)
                        entries.emplace_back(j * pad.nx + i, n * pad.nx + m, static_cast<double>(c));
                }
    }
    NinePoints points() const
    {
        NinePoints result;
        for (std::size_t k = 0; k < beside.size(); ++k) result.beside[k] = beside[k];
        result.sum = sum;
        return result;
    }
    template <typename T>
    Eigen::SparseMatrix<T> matrix(T shift, bool transposed) const
    {
        Eigen::SparseMatrix<double> a(pad.nx * pad.ny, pad.nx * pad.ny);
        a.setFromTriplets(entries.begin(), entries.end());
        if (transposed) a = Eigen::SparseMatrix<double>(a.transpose());
        Eigen::SparseMatrix<T> one(a.rows(), a.cols());
        one.setIdentity();
        return Eigen::SparseMatrix<T>(a.cast<T>() + shift * one);
    }
};

/// What one cycle leaves of b, as |A v - b|/|b|.
template <typename T>
double leftByCycle(Multigrid<T>& multigrid, const PaddedGrid& pad, const Eigen::SparseMatrix<T>& a)
{
    using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    std::vector<T> b(pad.size()), v(pad.size());
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) b[pad.at(i, j)] = std::sin(1.3 * i + 0.4 * j * j);
    multigrid.precondition(b, v);
    const std::vector<T> cells = pad.unpad<T>(v), right = pad.unpad<T>(b);
    const Eigen::Map<const Column> x(cells.data(), a.rows()), y(right.data(), a.rows());
    return Column(a * x - y).norm() / y.norm();
}

/// The same for random nine points plus `rate` times others, whole 64ths, so that sums in single precision are exact.
/// The lines that a sweep solves first do not depend on the others.
template <typename T>
double leftByLines(const PaddedGrid& pad, T rate, bool alongX, bool transposed)
{
    std::mt19937 random(5);
    const auto coefficient = [&](int i, int j, int a, int b) {
        if (a == 0 && b == 0) return 10.0f;
        const int line = alongX ? j : i, across = alongX ? b : a;
        const float c = static_cast<float>(static_cast<int>(random() % 129) - 64) / 64.0f;
        return across == 0 || line % 2 != (transposed ? 1 : 0) ? c : 0.0f;
    };
    const Nine nine(pad, coefficient), stored(pad, coefficient);
    const Flow flow = film(pad.nx, pad.ny, 1.0, 1.0, 0.0, 0.0, evenGap(pad.nx, pad.ny));
    const T shift = 1.0;
    const std::vector<T> diagonal(pad.size(), shift);
    const Eigen::SparseMatrix<T> a = nine.matrix<T>(shift, transposed) + rate * stored.matrix<T>(T{}, transposed);
    Multigrid<T> multigrid(pad);
    multigrid.setOperator(flow.faces(), diagonal);
    if (!(leftByCycle(multigrid, pad, a) > 0.1)) return INFINITY; // the faces' operator is another one
    if (rate == T{})
        multigrid.setFinest(nine.points(), diagonal, transposed);
    else
        multigrid.setFinest(nine.points(), diagonal, transposed, stored.points(), rate);
    return leftByCycle(multigrid, pad, a);
}

/// What eight cycles leave of a random error's residual, for the operator of ninePointsContract.
double leftByCycles(bool hasNine, bool transposed)
{
    const int n = 32;
    const std::array line{-1.5f, 3.0f, -0.5f};
    const Nine nine(PaddedGrid{n, n}, [&](int, int, int a, int b) {
        const float c = line[static_cast<std::size_t>(a + 1)] * line[static_cast<std::size_t>(b + 1)];
        return a == 0 && b == 0 ? c - 1.0f : c; // the one is the diagonal's
    });
    Flow flow(n, n);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        std::ranges::fill(flow.diffusion[axis], 1.0);
        std::ranges::fill(flow.effective[axis], 1.0);
        std::ranges::fill(flow.convection[axis], transposed ? -1.0 : 1.0);
    }
    const PaddedGrid& pad = flow.pad;
    const std::vector<double> diagonal(pad.size(), 1.0);
    Multigrid<double> multigrid(pad);
    multigrid.setOperator(flow.faces(), diagonal);
    if (hasNine) multigrid.setFinest(nine.points(), diagonal, transposed);
    const Eigen::SparseMatrix<double> a = nine.matrix<double>(1.0, transposed);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Eigen::VectorXd x(a.rows());
    for (double& value : x) value = uniform(random);
    const double start = (a * x).norm();
    std::vector<double> right(pad.size()), step(pad.size());
    for (int cycle = 0; cycle < 8; ++cycle) {
        const Eigen::VectorXd rest = -(a * x);
        pad.pad<double>(std::span<const double>(rest.data(), static_cast<std::size_t>(rest.size())), right);
        multigrid.precondition(right, step);
        const std::vector<double> cells = pad.unpad<double>(step);
        x += Eigen::Map<const Eigen::VectorXd>(cells.data(), x.size());
    }
    return (a * x).norm() / start;
}

class TestMultigrid : public QObject {
    Q_OBJECT

private slots:
    /// Preconditioned iterations until the residual has fallen to 1e-8: at most so many (a third more than measured).
    /// The solution is the direct one, to what the condition of the matrix lets through.
    void iterations_data()
    {
        QTest::addColumn<Flow>("flow");
        QTest::addColumn<int>("bound");
        const auto row = [](const char* name, const Flow& flow, int bound) { QTest::newRow(name) << flow << bound; };
        row("Laplace, 64 x 64", film(64, 64, 1.0, 1.0, 0.0, 0.0, evenGap(64, 64)), 10);
        row("Laplace, odd 61 x 37", film(61, 37, 1.0, 1.0, 0.0, 0.0, evenGap(61, 37)), 10);
        row("cells 100 times longer than wide", film(48, 48, 100.0, 1.0, 0.0, 0.0, evenGap(48, 48)), 4);
        row("cells 100 times wider than long", film(48, 48, 1.0, 100.0, 0.0, 0.0, evenGap(48, 48)), 4);
        row("Peclet 1", film(64, 48, 1.0, 1.0, 1.0, 0.0, evenGap(64, 48)), 8);
        row("Peclet 10, oblique", film(64, 48, 1.0, 1.0, 10.0, -4.0, evenGap(64, 48)), 14);
        row("Peclet 1000", film(64, 48, 1.0, 1.0, 1000.0, 0.0, evenGap(64, 48)), 4);
        row("Peclet 1000, oblique, backwards", film(64, 48, 1.0, 1.0, -1000.0, 300.0, evenGap(64, 48)), 12);
        row("rails, K jumps 1e6", film(64, 64, 1.0, 1.0, 0.0, 0.0, railGap(64, 64, 100.0)), 16);
        row("rails, K jumps 1e6, Peclet 100 on them", film(64, 64, 1.0, 1.0, 100.0, 10.0, railGap(64, 64, 100.0)), 16);
        row("rails, odd 57 x 43, Peclet 1000 on them", film(57, 43, 1.0, 1.3, 1000.0, -100.0, railGap(57, 43, 30.0)),
            13);
        row("random gaps", film(64, 64, 1.0, 1.0, 0.0, 0.0, randomGap(64, 64)), 23);
        row("random gaps, Peclet 10", film(64, 64, 1.0, 1.0, 10.0, 3.0, randomGap(64, 64)), 12);
        row("three rows", film(200, 3, 1.0, 1e6, 20.0, 0.0, evenGap(200, 3)), 3);
        row("a single cell", film(1, 1, 1.0, 1.0, 1.0, 0.0, evenGap(1, 1)), 1);
    }
    void iterations()
    {
        QFETCH(Flow, flow);
        QFETCH(int, bound);
        const Solved<double> solved = solve<double>(flow, 0.0, 1e-8);
        QVERIFY(solved.result.converged);
        QVERIFY2(solved.result.iterations <= bound, qPrintable(QString::number(solved.result.iterations)));
        QVERIFY2(solved.error < 1e-5, qPrintable(QString::number(solved.error)));
        const Solved<double> exact = solve<double>(flow, 0.0, 1e-13);
        QVERIFY2(exact.error < 1e-9, qPrintable(QString::number(exact.error)));
    }

    /// The more cells the more unknowns, not the more iterations.
    void sizeDoesNotMatter()
    {
        const auto count = [](int n) {
            return solve<double>(film(n, n, 1.0, 1.0, 100.0 / n, 20.0 / n, evenGap(n, n)), 0.0, 1e-8).result.iterations;
        };
        QVERIFY(count(128) <= count(32) + 1);
    }

    /// V cycles alone, each with line sweeps both ways before and after: the residual of Laplace's equation falls at
    /// least five times a cycle.
    void oneCycle()
    {
        const Flow flow = film(64, 64, 1.0, 1.0, 0.0, 0.0, evenGap(64, 64));
        const PaddedGrid& pad = flow.pad;
        const Eigen::SparseMatrix<double> a = flow.matrix<double>();
        Multigrid<double> multigrid(pad);
        multigrid.setOperator(flow.faces(), {});
        std::mt19937 random(6);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        Eigen::VectorXd x(a.rows());
        for (double& value : x) value = uniform(random);
        std::vector<double> right(pad.size()), step(pad.size());
        double before = 0.0;
        for (int cycle = 0; cycle < 8; ++cycle) {
            const Eigen::VectorXd rest = -(a * x);
            if (cycle > 1) QVERIFY2(rest.norm() < before / 5.0, qPrintable(QString::number(rest.norm() / before)));
            before = rest.norm();
            pad.pad<double>(std::span<const double>(rest.data(), static_cast<std::size_t>(rest.size())), right);
            multigrid.precondition(right, step);
            const std::vector<double> cells = pad.unpad<double>(step);
            x += Eigen::Map<const Eigen::VectorXd>(cells.data(), x.size());
        }
    }

    /// (D + X) D^-1 (D + Y) v = b, with the parts of the matrix: entries one cell away are along x, nx cells away along
    /// y. Complex numbers are double; real ones are single, 2^-24 from the exact ones, and each row of the product sums
    /// some ten of them.
    void factorsAreSolved()
    {
        for (const double mass : {0.0, 0.01, 1.0, 3.0, 1e3}) QVERIFY(factorError(mass) < 20 * 0x1p-24);
    }

    /// The power of two that keeps single precision within its range changes nothing: neither do the film's small
    /// units.
    void unitsDoNotMatter()
    {
        Flow flow = film(23, 18, 1.0, 0.7, 5.0, 1.0, randomGap(23, 18));
        const PaddedGrid& pad = flow.pad;
        Multigrid<double> multigrid(pad);
        std::vector<double> b(pad.size()), v(pad.size()), vScaled(pad.size());
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) b[pad.at(i, j)] = std::sin(1.3 * i + 0.4 * j * j);
        multigrid.setOperator(flow.faces(), {});
        multigrid.precondition(b, v);
        const double unit = 0x1p-180; // squares and inverses of such numbers are beyond single precision
        for (auto* pair : {&flow.diffusion, &flow.effective, &flow.convection})
            for (auto& field : *pair)
                for (double& value : field) value *= unit;
        for (double& value : b) value *= unit;
        multigrid.setOperator(flow.faces(), {});
        multigrid.precondition(b, vScaled);
        QCOMPARE(vScaled, v);
    }

    /// The smoothest error, which lines of cells hardly change, falls more than five times.
    void halfCycleTakesWhatIsSmooth()
    {
        const int n = 64;
        const Flow flow = film(n, n, 1.0, 1.0, 0.0, 0.0, evenGap(n, n));
        const PaddedGrid& pad = flow.pad;
        const Eigen::SparseMatrix<double> a = flow.matrix<double>();
        Multigrid<double> multigrid(pad);
        multigrid.setOperator(flow.faces(), {});
        Eigen::VectorXd x(a.rows());
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) x(j * n + i) = std::sin(M_PI * (i + 0.5) / n) * std::sin(M_PI * (j + 0.5) / n);
        const Eigen::VectorXd right = a * x;
        std::vector<double> b(pad.size()), v(pad.size());
        pad.pad<double>(std::span<const double>(right.data(), static_cast<std::size_t>(right.size())), b);
        const auto errorOf = [&] {
            const std::vector<double> cells = pad.unpad<double>(v);
            return (Eigen::Map<const Eigen::VectorXd>(cells.data(), x.size()) - x).norm() / x.norm();
        };
        multigrid.setFactors(flow.faces(), flow.faces(), std::vector<double>(pad.size(), 0.0));
        multigrid.solveFactors(b, v);
        QVERIFY(errorOf() > 0.9);
        multigrid.halfCycle(b, v);
        QVERIFY2(errorOf() < 0.2, qPrintable(QString::number(errorOf())));
    }

    /// Linear, and without effect on the rings, or gmres would search in the wrong space.
    void isLinear()
    {
        QVERIFY(nonlinearity<Complex>() < 10 * 0x1p-24);
        QVERIFY(nonlinearity<double>() < 10 * 0x1p-24);
    }

    /// Films that oscillate: a diagonal i omega from small to overwhelming against the conductances of 1.
    void complexDiagonal_data()
    {
        QTest::addColumn<double>("omega");
        QTest::addColumn<int>("bound");
        QTest::newRow("slow") << 1e-3 << 12;
        QTest::newRow("as fast as a grid of cells settles") << 0.05 << 12;
        QTest::newRow("as fast as a cell settles") << 2.0 << 10;
        QTest::newRow("fast") << 1e3 << 3;
    }
    void complexDiagonal()
    {
        QFETCH(double, omega);
        QFETCH(int, bound);
        const Flow flow = film(48, 40, 1.0, 1.0, 3.0, 1.0, railGap(48, 40, 3.0));
        const Solved<Complex> solved = solve<Complex>(flow, Complex(0.0, omega), 1e-8);
        QVERIFY(solved.result.converged);
        QVERIFY2(solved.result.iterations <= bound, qPrintable(QString::number(solved.result.iterations)));
        QVERIFY(solved.error < 1e-6);
    }

    /// A film in time: a real diagonal.
    void realDiagonal()
    {
        const Flow flow = film(48, 40, 1.0, 1.0, 3.0, 1.0, railGap(48, 40, 3.0));
        const Solved<double> solved = solve<double>(flow, 0.5, 1e-10);
        QVERIFY(solved.result.converged);
        QVERIFY(solved.error < 1e-8);
    }

    /// A block without air: its faces are closed, its cells keep what they have, and the rest is solved as before.
    void closedBlock()
    {
        Flow flow = film(40, 32, 1.0, 1.0, 4.0, 0.0, evenGap(40, 32));
        const auto close = [](Flow& f) {
            for (int j = 10; j < 17; ++j)
                for (int i = 20; i < 31; ++i)
                    for (auto* fields : {&f.diffusion, &f.effective, &f.convection}) {
                        (*fields)[0][f.pad.at(i, j)] = (*fields)[0][f.pad.at(i + 1, j)] = 0.0;
                        (*fields)[1][f.pad.at(i, j)] = (*fields)[1][f.pad.at(i, j + 1)] = 0.0;
                    }
        };
        close(flow);
        const PaddedGrid& pad = flow.pad;
        Multigrid<double> multigrid(pad);
        multigrid.setOperator(flow.faces(), {});
        // Its matrix has empty rows; only the open cells get a right-hand side.
        const Eigen::SparseMatrix<double> a = flow.matrix<double>();
        Eigen::VectorXd exact(a.rows());
        for (Eigen::Index k = 0; k < exact.size(); ++k) exact(k) = std::sin(0.37 * static_cast<double>(k));
        for (int j = 10; j < 17; ++j)
            for (int i = 20; i < 31; ++i) exact(j * pad.nx + i) = 0.0;
        const Eigen::VectorXd right = a * exact;
        std::vector<double> b(pad.size()), x(pad.size());
        pad.pad<double>(std::span<const double>(right.data(), static_cast<std::size_t>(right.size())), b);
        Gmres<double> gmres(pad.size(), 40);
        const auto apply = [&](std::span<const double> v, std::span<double> out) {
            const std::vector<double> cells = pad.unpad<double>(v);
            const Eigen::VectorXd product = a * Eigen::Map<const Eigen::VectorXd>(cells.data(), a.cols());
            pad.pad<double>(std::span<const double>(product.data(), static_cast<std::size_t>(product.size())), out);
        };
        const GmresResult result = gmres.solve(
            apply, [&](std::span<const double> v, std::span<double> out) { multigrid.precondition(v, out); },
            std::span<const double>(b), std::span<double>(x), {.tolerance = 1e-11, .maximumIterations = 60});
        QVERIFY(result.converged);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) QVERIFY(std::abs(x[pad.at(i, j)] - exact(j * pad.nx + i)) < 1e-8);
    }

    /// Where the lines that come first do not depend on the others, a sweep along them is a direct solution, which the
    /// sweep the other way leaves as it is: one cycle solves A v = b, or A^T v = b, to rounding. Each row sums nine
    /// products.
    void ninePointsAlongLines()
    {
        for (const PaddedGrid& pad : {PaddedGrid{23, 18}, PaddedGrid{23, 3}})
            for (const bool alongX : {true, false})
                for (const bool transposed : {false, true}) {
                    const auto small = [](double left) { return left < 30 * 0x1p-24; };
                    QVERIFY(small(leftByLines<double>(pad, 0.0, alongX, transposed)));
                    QVERIFY(small(leftByLines<double>(pad, 0.5, alongX, transposed)));
                    QVERIFY(small(leftByLines<Complex>(pad, {0.25, 0.5}, alongX, transposed)));
                }
    }

    /// (1 + X)(1 + Y), X and Y convection and diffusion along the axes, where the faces know 1 + X + Y. The roughest
    /// error has X = Y = 4: the faces alone take 25/9 of it, so that it grows; sweeps of the nine points take it.
    void ninePointsContract()
    {
        for (const bool transposed : {false, true}) {
            const double without = leftByCycles(false, transposed), with = leftByCycles(true, transposed);
            const QString both = QStringLiteral("%1, %2").arg(without).arg(with);
            QVERIFY2(without > 0.1 && with < 1e-2, qPrintable(both));
        }
    }
};

TOUCHDOWN_TEST(TestMultigrid)

} // namespace test_multigrid

#include "test_multigrid.moc"
