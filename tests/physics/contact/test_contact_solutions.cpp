// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact against exact solutions (Johnson 1985): sphere, flat punches, waves in partial contact;
// and against the same conditions solved by factorised matrices.
#include <QtTest>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/physics/contact/elastic_contact.h"
#include "tests/support/self_affine.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_solutions {

class TestContactSolutions : public QObject {
    Q_OBJECT

private slots:
    void sphereAtGivenApproach_data();
    void sphereAtGivenApproach();
    void sphereConvergesAtSecondOrder();
    void roundPunch();
    void squarePunch();
    void waveInPartialContact_data();
    void waveInPartialContact();
    void isTheDenseSolution_data();
    void isTheDenseSolution();
};

using std::numbers::pi;
constexpr double modulus = 8e10;

UniformGrid square(int n, double side) { return {n, n, side / n, side / n, -side / 2, -side / 2}; }

template <typename F>
std::vector<double> sample(const UniformGrid& grid, F&& function)
{
    std::vector<double> values;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) values.push_back(function(grid.x(i), grid.y(j)));
    return values;
}

double peak(const ElasticContact& contact)
{
    return *std::max_element(contact.pressure().begin(), contact.pressure().end());
}

// Hertz: a = sqrt(R d), F = (4/3) E* sqrt(R) d^1.5, p0 = 2 E* a/(pi R), p = p0 sqrt(1 - (r/a)^2).
struct Sphere {
    double radius = 1e-3, approach = 1e-9;
    double contactRadius() const { return std::sqrt(radius * approach); }
    double load() const { return 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(approach, 1.5); }
    double peak() const { return 2.0 * modulus * contactRadius() / (pi * radius); }
    std::vector<double> separation(const UniformGrid& grid, double lowered) const
    {
        return sample(grid, [&](double x, double y) { return (x * x + y * y) / (2.0 * radius) - lowered; });
    }
};

// At 128^2 load, radius and peak are to be within half a per cent. Load, approach and peak are of second order in the
// larger side of a cell, a quarter of its square (1e-4) and less; the staircase that stands for the circle is off by a
// quarter of a cell (0.5 %) and less.
void TestContactSolutions::sphereAtGivenApproach_data()
{
    QTest::addColumn<int>("nx");
    QTest::addColumn<int>("ny");
    QTest::newRow("square cells") << 128 << 128;
    QTest::newRow("long cells") << 64 << 128;
    QTest::newRow("wide cells") << 128 << 64;
}

void TestContactSolutions::sphereAtGivenApproach()
{
    QFETCH(int, nx);
    QFETCH(int, ny);
    const Sphere sphere;
    const double side = 2.5 * sphere.contactRadius(), cell = 2.5 / std::min(nx, ny); // the larger side of a cell [a]
    const UniformGrid grid{nx, ny, side / nx, side / ny, -side / 2, -side / 2};
    ElasticContact contact(HalfSpace(grid, modulus));
    const ElasticContactSummary summary = contact.solve(sphere.separation(grid, sphere.approach));
    QVERIFY(summary.converged);
    QVERIFY(std::abs(summary.load / sphere.load() - 1.0) < 0.25 * cell * cell);
    QVERIFY(std::abs(std::sqrt(contact.contactArea() / pi) / sphere.contactRadius() - 1.0) < 0.25 * cell);
    QVERIFY(std::abs(peak(contact) / sphere.peak() - 1.0) < 0.25 * cell * cell);
}

void TestContactSolutions::sphereConvergesAtSecondOrder()
{
    const Sphere sphere;
    double errors[4] = {};
    int k = 0;
    for (const int n : {32, 64, 128, 256}) {
        const UniformGrid grid = square(n, 2.5 * sphere.contactRadius());
        ElasticContact contact(HalfSpace(grid, modulus));
        QVERIFY(contact.solve(sphere.separation(grid, sphere.approach)).converged);
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < grid.cells(); ++i) {
            const double r = std::hypot(grid.x(int(i) % n), grid.y(int(i) / n)) / sphere.contactRadius();
            if (r > 0.7) continue;
            const double error = contact.pressure()[i] / sphere.peak() - std::sqrt(1.0 - r * r);
            sum += error * error;
            ++count;
        }
        errors[k++] = std::sqrt(sum / count);
    }
    // How the edge falls among the cells scatters single steps; over three doublings the order shows.
    QVERIFY(errors[3] < 1e-5);
    QVERIFY(std::abs(std::log2(errors[0] / errors[3]) / 3.0 - 2.0) < 0.15);
}

void TestContactSolutions::roundPunch()
{
    // F = 2 E* a d, p = F/(2 pi a^2) (1 - (r/a)^2)^(-1/2). The pressure's square-root singularity at the edge, and the
    // staircase that stands for it, leave an error of first order in the cell.
    const double a = 1e-6, approach = 1e-9;
    for (const int n : {64, 128, 256}) {
        const UniformGrid grid = square(n, 2.5 * a);
        ElasticContact contact(HalfSpace(grid, modulus));
        const auto punch = sample(grid, [&](double x, double y) { return std::hypot(x, y) < a ? -approach : 1e-6; });
        const ElasticContactSummary summary = contact.solve(punch);
        QVERIFY(summary.converged);
        const double load = 2.0 * modulus * a * approach;
        double worst = 0.0;
        for (std::size_t i = 0; i < grid.cells(); ++i) {
            const double r = std::hypot(grid.x(int(i) % n), grid.y(int(i) / n)) / a;
            if (r < 0.7)
                worst = std::max(
                    worst,
                    std::abs(contact.pressure()[i] / (load / (2.0 * pi * a * a)) * std::sqrt(1.0 - r * r) - 1.0));
        }
        QVERIFY(std::abs(summary.load / load - 1.0) < 0.5 / n);
        QVERIFY(worst < 1.0 / n);
    }
}

void TestContactSolutions::squarePunch()
{
    // The load is to the displacement as charge to potential of a square plate of the same side: F = pi E* L d c, where
    // C = 4 pi eps0 L c and c = 0.3667896 (Read 1997: 0.3667896 +- 7e-7). A disk's c = 2/pi gives F = 2 E* a d for L =
    // a. The error is of first order in the cell (the edge's singularity): two grids take it away.
    const double side = 1e-6, approach = 1e-9;
    double loads[3] = {};
    int k = 0;
    for (const int n : {32, 64, 128}) {
        ElasticContact contact(HalfSpace(square(n, side), modulus));
        const ElasticContactSummary summary =
            contact.solve(std::vector<double>(contact.space().grid().cells(), -approach));
        QVERIFY(summary.converged);
        loads[k++] = summary.load / (pi * modulus * side * approach);
    }
    QVERIFY(std::abs((2.0 * loads[1] - loads[0]) / 0.3667896 - 1.0) < 2e-4);
    QVERIFY(std::abs((2.0 * loads[2] - loads[1]) / 0.3667896 - 1.0) < 1e-4);
}

void TestContactSolutions::waveInPartialContact_data()
{
    QTest::addColumn<double>("share");
    QTest::newRow("a tenth of the load of full contact") << 0.1;
    QTest::newRow("half of it") << 0.5;
    QTest::newRow("nine tenths") << 0.9;
}

void TestContactSolutions::waveInPartialContact()
{
    // Westergaard 1939 (Johnson 1985, section 13.2): s = A (1 - cos 2 pi x/L), p* = pi E* A/L, p_mean = p* sin^2(pi
    // a/L) on strips of half-width a; with psi = pi x/L from a crest, p = 2 p_mean cos(psi)/sin^2(psi_a) sqrt(sin^2
    // psi_a - sin^2 psi).
    QFETCH(double, share);
    const double length = 2e-6, amplitude = 1e-9;
    const UniformGrid grid{512, 2, length / 512, length / 512, -length / 2, 0.0};
    ElasticContact contact(HalfSpace(grid, modulus, HalfSpaceEdges::Periodic));
    const double full = pi * modulus * amplitude / length;
    // The approach that takes this load, between none and that of the mean plane, by halving.
    double none = 0.0, most = amplitude;
    for (int i = 0; i < 40; ++i) {
        const double approach = 0.5 * (none + most);
        const auto separation = sample(
            grid, [&](double x, double) { return amplitude * (1.0 - std::cos(2.0 * pi * x / length)) - approach; });
        const ElasticContactSummary summary = contact.solve(separation);
        QVERIFY(summary.converged);
        (summary.load < share * full * length * 2 * grid.dy ? none : most) = approach;
    }
    const double contactShare = contact.contactArea() / (length * 2 * grid.dy);
    // The edge of contact is known to a cell on either side.
    QVERIFY(std::abs(contactShare - 2.0 / pi * std::asin(std::sqrt(share))) <= 2.0 / grid.nx);
    const double edge = std::asin(std::sqrt(share));
    for (int i = 0; i < grid.nx; ++i) {
        const double psi = pi * grid.x(i) / length;
        if (std::abs(std::abs(psi) - edge) < 0.05) continue;
        const double inside = share - std::sin(psi) * std::sin(psi);
        const double expected = inside > 0.0 ? 2.0 * std::cos(psi) * std::sqrt(inside) : 0.0;
        QVERIFY(std::abs(contact.pressure()[static_cast<std::size_t>(i)] / full - expected) < 1e-3);
    }
}

void TestContactSolutions::isTheDenseSolution_data()
{
    QTest::addColumn<bool>("periodic");
    QTest::newRow("free") << false;
    QTest::newRow("periodic") << true;
}

void TestContactSolutions::isTheDenseSolution()
{
    // The same conditions solved by factorising the matrix of the cells in contact, one cell leaving or joining at a
    // time (the least index first, which cannot cycle: Bland's rule as of Murty 1974 for these problems).
    QFETCH(bool, periodic);
    const UniformGrid grid = square(16, 2e-6);
    const double side = 2e-6;
    std::vector<double> separation = test::selfAffineHeights({.n = 16, .cutOff = 2.0, .slope = 0.02, .seed = 5});
    for (double& s : separation) s = 2e-9 - s * side;
    HalfSpace space(grid, modulus, periodic ? HalfSpaceEdges::Periodic : HalfSpaceEdges::Free);
    const auto cells = static_cast<Eigen::Index>(separation.size());
    Eigen::MatrixXd compliance(cells, cells);
    for (Eigen::Index c = 0; c < cells; ++c) {
        std::vector<double> column(separation.size(), 0.0);
        column[static_cast<std::size_t>(c)] = 1.0;
        space.displace(column, column);
        compliance.col(c) = Eigen::Map<Eigen::VectorXd>(column.data(), cells) * modulus / side; // of the order 1
    }
    std::vector<bool> touches(separation.size(), false);
    Eigen::VectorXd pressure; // [E*]
    for (int exchanges = 0; exchanges < 5000; ++exchanges) {
        std::vector<Eigen::Index> in;
        for (Eigen::Index c = 0; c < cells; ++c)
            if (touches[std::size_t(c)]) in.push_back(c);
        const auto count = static_cast<Eigen::Index>(in.size());
        const Eigen::MatrixXd matrix = compliance(in, in);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
        for (Eigen::Index k = 0; k < count; ++k) right[k] = -separation[std::size_t(in[std::size_t(k)])] / side;
        pressure = Eigen::VectorXd::Zero(cells);
        const Eigen::VectorXd solution = count > 0 ? matrix.partialPivLu().solve(right).eval() : right;
        for (Eigen::Index k = 0; k < count; ++k) pressure[in[std::size_t(k)]] = solution[k];
        const Eigen::VectorXd displaced = compliance * pressure;
        Eigen::Index wrong = -1;
        for (Eigen::Index c = 0; c < cells && wrong < 0; ++c) {
            const double gap = separation[std::size_t(c)] / side + displaced[c];
            if (touches[std::size_t(c)] ? pressure[c] < -1e-12 : gap < -1e-13) wrong = c;
        }
        if (wrong < 0) break;
        touches[std::size_t(wrong)] = !touches[std::size_t(wrong)];
        QVERIFY(exchanges < 4999);
    }
    ElasticContact contact(std::move(space));
    QVERIFY(contact.solve(separation).converged);
    const double peak = pressure.maxCoeff();
    for (Eigen::Index c = 0; c < cells; ++c)
        QVERIFY(std::abs(contact.pressure()[std::size_t(c)] / modulus - pressure[c]) < 1e-7 * peak);
}

TOUCHDOWN_TEST(TestContactSolutions)

} // namespace test_contact_solutions

#include "test_contact_solutions.moc"
