// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <Eigen/Dense>

#include <cmath>
#include <numbers>
#include <thread>

#include "core/numerics/gauss_legendre.h"
#include "core/physics/contact/half_space.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_half_space {

class TestHalfSpace : public QObject {
    Q_OBJECT

private slots:
    void squareUnderUniformPressure_data();
    void squareUnderUniformPressure();
    void oblongUnderUniformPressure();
    void oneCellMovesItsNeighbours();
    void isAPointForceFarAway();
    void periodicWavesAreExact();
    void freeStiffnessIsTheInverse();
    void freeStiffnessIsPositive_data();
    void freeStiffnessIsPositive();
    void periodicStiffnessIsTheInverse();
    void ownCellsAreTheirOwn();
    void threadsGiveTheSameBits();
    void isAskedAtEachRow();
};

using std::numbers::pi;
constexpr double modulus = 8e10;

std::vector<double> someField(std::size_t count)
{
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k) values[k] = std::sin(1.0 + 3.7 * static_cast<double>(k * k % 1009));
    return values;
}

void TestHalfSpace::squareUnderUniformPressure_data()
{
    QTest::addColumn<int>("n");
    for (const int n : {1, 3, 9, 45, 129}) QTest::newRow(qPrintable(QString("%1 x %1 cells").arg(n))) << n;
}

void TestHalfSpace::squareUnderUniformPressure()
{
    // Love: corners at (+-a, +-a), r = sqrt(2) a: u = p/(pi E*) 4 (2 a asinh 1) = (8/pi) ln(1 + sqrt 2) p a/E*
    // = 2.24440 p a/E*.
    QFETCH(int, n);
    const double a = 3e-6;
    const double pressure = 1e9;
    HalfSpace space({n, n, 2.0 * a / n, 2.0 * a / n}, modulus);
    std::vector<double> field(space.grid().cells(), pressure);
    space.displace(field, field);
    const double expected = 8.0 / pi * std::log(1.0 + std::sqrt(2.0)) * pressure * a / modulus;
    QVERIFY(std::abs(expected * modulus / (pressure * a) - 2.2444) < 1e-6);
    QVERIFY(std::abs(field[field.size() / 2] / expected - 1.0) < 1e-12);
}

void TestHalfSpace::oblongUnderUniformPressure()
{
    // Corners at (+-a, +-b): u = (4 p/(pi E*)) (a asinh(b/a) + b asinh(a/b)), with cells three times as long as wide.
    const double a = 15e-6, b = 4.5e-6;
    HalfSpace space({15, 9, 2e-6, 1e-6, 1.0, 1.0}, modulus);
    std::vector<double> field(space.grid().cells(), 1.0);
    space.displace(field, field);
    const double expected = 4.0 / (pi * modulus) * (a * std::asinh(b / a) + b * std::asinh(a / b));
    QVERIFY(std::abs(field[field.size() / 2] / expected - 1.0) < 1e-12);
}

void TestHalfSpace::oneCellMovesItsNeighbours()
{
    // Boussinesq's u = F/(pi E* r), summed over the cell by quadrature where it is smooth: a cell's length away or
    // more, where 24 points each way leave nothing but rounding.
    const double dx = 2e-6, dy = 0.7e-6;
    HalfSpace space({9, 9, dx, dy}, modulus);
    std::vector<double> field(81, 0.0);
    field[40] = 1.0;
    space.displace(field, field);
    const GaussLegendre<24> rule;
    for (int j = -4; j <= 4; ++j)
        for (int i = -4; i <= 4; ++i) {
            if (std::abs(i) < 2 && std::abs(j) < 4) continue; // nearer along y than the cell is long
            double sum = 0.0;
            rule.sample(-0.5 * dx, 0.5 * dx, [&](double x, double wx) {
                rule.sample(-0.5 * dy, 0.5 * dy,
                            [&](double y, double wy) { sum += wx * wy / std::hypot(i * dx - x, j * dy - y); });
            });
            QVERIFY(std::abs(field[static_cast<std::size_t>(40 + 9 * j + i)] / (sum / (pi * modulus)) - 1.0) < 1e-12);
        }
}

void TestHalfSpace::isAPointForceFarAway()
{
    // F/(pi E* r) (1 + d^2/(24 r^2) + ...) for a square of side d, since the Laplacian of 1/r in the plane is 1/r^3.
    // The next term is of the order (d/r)^4: 1e-8/r^4 of 100 cells is far below rounding.
    HalfSpace space({601, 3, 1.0, 1.0}, modulus);
    std::vector<double> field(space.grid().cells(), 0.0);
    field[601] = 1.0;
    space.displace(field, field);
    for (const int r : {100, 300, 600}) {
        const double expected = (1.0 + 1.0 / (24.0 * r * r)) / (pi * modulus * r);
        QVERIFY(std::abs(field[static_cast<std::size_t>(601 + r)] / expected - 1.0) < 1e-9);
    }
}

void TestHalfSpace::periodicWavesAreExact()
{
    const UniformGrid grid{15, 12, 2e-6, 1e-6};
    HalfSpace space(grid, modulus, HalfSpaceEdges::Periodic);
    for (const auto& [wavesX, wavesY] : {std::pair{1, 0}, {0, 2}, {7, 5}, {-3, 6}}) {
        const double kx = 2.0 * pi * wavesX / 30e-6;
        const double ky = 2.0 * pi * wavesY / 12e-6;
        std::vector<double> pressure, displacement(grid.cells());
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) pressure.push_back(1e9 * std::cos(kx * grid.x(i) + ky * grid.y(j)));
        space.displace(pressure, displacement);
        const double factor = 2.0 / (modulus * std::hypot(kx, ky));
        for (std::size_t k = 0; k < pressure.size(); ++k)
            QVERIFY(std::abs(displacement[k] - factor * pressure[k]) < 1e-13 * factor * 1e9);
    }
    std::vector<double> field(grid.cells(), 1e9);
    space.displace(field, field);
    for (const double u : field) QVERIFY(std::abs(u) < 1e-13 * 1e9 * space.ownCompliance());
}

void TestHalfSpace::freeStiffnessIsTheInverse()
{
    // On the padded grid K u = p with p only on the grid: there u must be what displace() gives. K column by column.
    const UniformGrid grid{5, 4, 1e-6, 2e-6};
    HalfSpace space(grid, modulus);
    const UniformGrid& wide = space.stiffnessGrid();
    QCOMPARE(wide.nx, 10);
    QCOMPARE(wide.ny, 8);
    const auto cells = static_cast<Eigen::Index>(wide.cells());
    Eigen::MatrixXd stiffness(cells, cells);
    std::vector<double> column(wide.cells());
    for (Eigen::Index c = 0; c < cells; ++c) {
        std::fill(column.begin(), column.end(), 0.0);
        column[static_cast<std::size_t>(c)] = 1.0;
        space.stress(column, column);
        stiffness.col(c) = Eigen::Map<Eigen::VectorXd>(column.data(), cells);
    }
    QVERIFY(std::abs(stiffness(0, 0) / space.ownStiffness() - 1.0) < 1e-13);
    std::vector<double> field = someField(grid.cells());
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(cells);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) pressure[j * wide.nx + i] = field[static_cast<std::size_t>(j * grid.nx + i)];
    const Eigen::VectorXd displacement = stiffness.ldlt().solve(pressure);
    space.displace(field, field);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            QVERIFY(std::abs(displacement[j * wide.nx + i] - field[static_cast<std::size_t>(j * grid.nx + i)]) <
                    1e-12 * space.ownCompliance());
}

void TestHalfSpace::freeStiffnessIsPositive_data()
{
    QTest::addColumn<UniformGrid>("grid");
    QTest::newRow("one cell") << UniformGrid{1, 1, 1.0, 1.0};
    QTest::newRow("square") << UniformGrid{64, 64, 1.0, 1.0};
    QTest::newRow("strip") << UniformGrid{200, 2, 1.0, 1.0};
    QTest::newRow("long cells") << UniformGrid{40, 40, 16.0, 1.0};
    QTest::newRow("odd sizes") << UniformGrid{37, 100, 1.0, 1.5};
}

void TestHalfSpace::freeStiffnessIsPositive()
{
    // Nothing is more compliant than the constant, so that every wave takes at least the pressure that the constant
    // takes. A factor that was not positive is kept as zero and would be seen here.
    QFETCH(UniformGrid, grid);
    HalfSpace space(grid, 1.0);
    const UniformGrid& wide = space.stiffnessGrid();
    for (int j = 0; j <= wide.ny / 2; ++j)
        for (int i = 0; i <= wide.nx / 2; i += 1 + wide.nx / 16) {
            std::vector<double> wave;
            for (int l = 0; l < wide.ny; ++l)
                for (int k = 0; k < wide.nx; ++k)
                    wave.push_back(std::cos(2.0 * pi * ((i * k) % wide.nx) / wide.nx) *
                                   std::cos(2.0 * pi * ((j * l) % wide.ny) / wide.ny));
            std::vector<double> pressure(wave.size());
            space.stress(wave, pressure);
            QVERIFY(pressure[0] * space.largestCompliance() > 0.999);
            if (j > 8) j += wide.ny / 16;
        }
}

void TestHalfSpace::periodicStiffnessIsTheInverse()
{
    HalfSpace space({10, 9, 1e-6, 2e-6}, modulus, HalfSpaceEdges::Periodic);
    std::vector<double> pressure = someField(90);
    double mean = 0.0;
    for (const double p : pressure) mean += p / 90.0;
    std::vector<double> field = pressure;
    space.displace(field, field);
    space.stress(field, field);
    for (std::size_t k = 0; k < 90; ++k) QVERIFY(std::abs(field[k] + mean - pressure[k]) < 1e-13);
}

void TestHalfSpace::ownCellsAreTheirOwn()
{
    for (const HalfSpaceEdges edges : {HalfSpaceEdges::Free, HalfSpaceEdges::Periodic}) {
        HalfSpace space({12, 7, 1e-6, 2e-6}, modulus, edges);
        std::vector<double> field(84, 0.0);
        field[40] = 1.0;
        space.displace(field, field);
        QVERIFY(std::abs(field[40] / space.ownCompliance() - 1.0) < 1e-13);
    }
    // Free: the square's centre, u = 2.2444 p (d/2)/E*.
    const HalfSpace square({9, 9, 1e-6, 1e-6}, modulus);
    QVERIFY(std::abs(square.ownCompliance() * modulus / 1e-6 - 4.0 / pi * std::log(1.0 + std::sqrt(2.0))) < 1e-13);
}

/// 12 x 10 cells: ten distances across and what a fast transform of twice as many adds, half of 20 or more.
void TestHalfSpace::isAskedAtEachRow()
{
    const UniformGrid grid{12, 10, 1e-6, 1e-6, 0.0, 0.0};
    int calls = 0;
    HalfSpace asked(grid, 1e11, HalfSpaceEdges::Free, [&] { return ++calls > 0; });
    QCOMPARE(calls, asked.stiffnessGrid().ny / 2 + 1);
    QVERIFY(calls >= 11);
    HalfSpace unasked(grid, 1e11);
    QCOMPARE(asked.ownCompliance(), unasked.ownCompliance());
    std::vector<double> field(grid.cells(), 1e8);
    int before = 3;
    HalfSpace stopped(grid, 1e11, HalfSpaceEdges::Free, [&] { return --before > 0; });
    QCOMPARE(before, 0);
    stopped.displace(field, field);
    for (const double u : field) QCOMPARE(u, 0.0);
}

void TestHalfSpace::threadsGiveTheSameBits()
{
    const std::vector<double> pressure = someField(70 * 50);
    std::vector<double> results[3];
    const auto compute = [&](std::vector<double>& out) {
        HalfSpace space({70, 50, 1e-6, 1e-6}, modulus);
        out.resize(pressure.size());
        for (int k = 0; k < 5; ++k) space.displace(pressure, out);
    };
    compute(results[0]);
    {
        std::thread first(compute, std::ref(results[1]));
        std::thread second(compute, std::ref(results[2]));
        first.join();
        second.join();
    }
    QVERIFY(results[0] == results[1]);
    QVERIFY(results[0] == results[2]);
}

TOUCHDOWN_TEST(TestHalfSpace)

} // namespace test_half_space

#include "test_half_space.moc"
