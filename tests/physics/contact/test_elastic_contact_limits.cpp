// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact at its limits: any grid, size and stiffness, from nothing, from anything, and over many solutions.
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/physics/contact/elastic_contact.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_elastic_contact_limits {

class TestElasticContactLimits : public QObject {
    Q_OBJECT

private slots:
    void anyGridAndScale_data();
    void anyGridAndScale();
    void solvesSmallestGrids();
    void startsFromNothing_data();
    void startsFromNothing();
    void roundingDoesNotGrow();
};

constexpr double modulus = 1e11;

/// The largest wrong gap against what the tolerance measures it by, with the displacement taken afresh; infinite beyond
/// the bounds.
double wrongGap(const ElasticContact& contact, HalfSpace& afresh, std::span<const double> separation, double hardness)
{
    std::vector<double> displacement(separation.size());
    afresh.displace(contact.pressure(), displacement);
    double worst = 0.0, peak = 0.0;
    for (std::size_t i = 0; i < separation.size(); ++i) {
        const double p = contact.pressure()[i], gap = separation[i] + displacement[i];
        if (!(p >= 0.0) || (hardness > 0.0 && p > hardness)) return INFINITY;
        const bool flows = hardness > 0.0 && p == hardness;
        worst = std::max(worst, p == 0.0 ? -gap : flows ? gap : std::abs(gap));
        peak = std::max(peak, p);
    }
    const auto [least, most] = std::minmax_element(displacement.begin(), displacement.end());
    const double scale = std::max(*most - *least, 0.1 * peak * afresh.ownCompliance());
    return worst <= 0.0 ? 0.0 : worst / scale;
}

void TestElasticContactLimits::anyGridAndScale_data()
{
    QTest::addColumn<HalfSpaceEdges>("edges");
    QTest::addColumn<bool>("hard");
    QTest::newRow("free") << HalfSpaceEdges::Free << false;
    QTest::newRow("free, flowing") << HalfSpaceEdges::Free << true;
    QTest::newRow("periodic") << HalfSpaceEdges::Periodic << false;
    QTest::newRow("periodic, flowing") << HalfSpaceEdges::Periodic << true;
}

void TestElasticContactLimits::anyGridAndScale()
{
    // Cells of 1 fm to 1 km, up to twice as long as wide, and gaps that have nothing to do with those solved just
    // before.
    QFETCH(HalfSpaceEdges, edges);
    QFETCH(bool, hard);
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    const auto power = [&](double low, double high) { return std::pow(10.0, uniform(low, high)); };
    for (int trial = 0; trial < 80; ++trial) {
        const double scale = power(-15.0, 3.0), stiffness = power(3.0, 13.0), height = scale * power(-4.0, 0.0);
        const auto side = [&] { return random() % 5 == 0 ? 1 : 1 + static_cast<int>(random() % 24); };
        const UniformGrid grid{side(), side(), scale, scale * power(-0.3, 0.3)};
        const double hardness = hard ? stiffness * height / scale * power(-3.0, 1.5) : 0.0;
        ElasticContact contact(HalfSpace(grid, stiffness, edges), {.hardness = hardness});
        HalfSpace afresh(grid, stiffness, edges);
        const int shape = trial % 4;
        std::vector<double> separation(grid.cells());
        for (int solution = 0; solution < 4; ++solution) {
            const double middle = height * uniform(-1.0, 1.5);
            double sum = 0.0;
            for (double& s : separation) {
                const double rise = shape == 0   ? uniform(-1.0, 1.0)
                                    : shape == 1 ? static_cast<double>(random() % 3) - 1.0
                                    : shape == 2 ? (random() % 10 == 0 ? -1.0 : 1.0)
                                                 : -3.0 * std::pow(uniform(0.0, 1.0), 8.0);
                s = middle + height * rise;
                sum += s;
            }
            if (!hard && edges == HalfSpaceEdges::Periodic && sum <= 0.0) continue; // refused
            const ElasticContactSummary summary = contact.solve(separation);
            const QString place =
                QString("trial %1, solution %2: %3").arg(trial).arg(solution).arg(summary.message.c_str());
            QVERIFY2(summary.converged, qPrintable(place));
            QVERIFY2(summary.iterations < 200, qPrintable(place));
            QVERIFY2(wrongGap(contact, afresh, separation, hardness) < 1.01e-8, qPrintable(place));
        }
    }
}

void TestElasticContactLimits::solvesSmallestGrids()
{
    // One cell: p = -s/ownCompliance.
    ElasticContact one(HalfSpace({1, 1, 1e-6, 1e-6}, modulus));
    QVERIFY(one.solve(std::vector{-1e-9}).converged);
    QVERIFY(std::abs(one.pressure()[0] * one.space().ownCompliance() / 1e-9 - 1.0) < 1e-8);
    // A periodic one that overlaps can but flow.
    ElasticContact flows(HalfSpace({1, 1, 1e-6, 1e-6}, modulus, HalfSpaceEdges::Periodic), {.hardness = 1e9});
    QVERIFY(flows.solve(std::vector{-1e-9}).converged);
    QCOMPARE(flows.pressure()[0], 1e9);
    // A row of three, the middle one highest and alone in contact.
    ElasticContact row(HalfSpace({3, 1, 1e-6, 1e-6}, modulus));
    QVERIFY(row.solve(std::vector{5e-9, -1e-9, 5e-9}).converged);
    QCOMPARE(row.pressure()[0], 0.0);
    QVERIFY(std::abs(row.pressure()[1] * row.space().ownCompliance() / 1e-9 - 1.0) < 1e-8);
}

void TestElasticContactLimits::startsFromNothing_data()
{
    QTest::addColumn<UniformGrid>("grid");
    QTest::addColumn<HalfSpaceEdges>("edges");
    QTest::newRow("odd grid") << UniformGrid{21, 17, 1e-7, 1e-7} << HalfSpaceEdges::Free;
    QTest::newRow("row") << UniformGrid{19, 1, 1e-7, 1e-7} << HalfSpaceEdges::Free;
    QTest::newRow("periodic") << UniformGrid{11, 23, 1e-7, 1e-7} << HalfSpaceEdges::Periodic;
    QTest::newRow("periodic row") << UniformGrid{1, 19, 1e-7, 1e-7} << HalfSpaceEdges::Periodic;
}

void TestElasticContactLimits::startsFromNothing()
{
    // No coarser grid, no pressure and so no displacement that would say how small a gap is: separated humps that stay
    // pressed, whose few equations need no more steps than any others.
    QFETCH(UniformGrid, grid);
    QFETCH(HalfSpaceEdges, edges);
    std::vector<double> separation(grid.cells(), 20e-9);
    for (std::size_t i = 3; i < separation.size(); i += 7) separation[i] = i % 2 == 0 ? -1e-9 : -2e-9;
    ElasticContact contact(HalfSpace(grid, modulus, edges));
    const ElasticContactSummary summary = contact.solve(separation);
    QVERIFY2(summary.converged, summary.message.c_str());
    QVERIFY2(summary.iterations <= 24, qPrintable(QString::number(summary.iterations)));
    QVERIFY(summary.load > 0.0);
}

void TestElasticContactLimits::roundingDoesNotGrow()
{
    // A flat pad that goes down and up steadily: its cells stay the same, and each displacement is made from the last
    // two.
    const UniformGrid grid{8, 8, 1e-7, 1e-7};
    ElasticContact contact(HalfSpace(grid, modulus));
    HalfSpace afresh(grid, modulus);
    std::vector<double> separation(grid.cells());
    for (int step = 0; step < 20000; ++step) {
        std::fill(separation.begin(), separation.end(), -10e-9 - 5e-9 * std::sin(1e-3 * step));
        QVERIFY(contact.solve(separation).converged);
        if (step % 997 != 0) continue;
        QVERIFY(wrongGap(contact, afresh, separation, 0.0) < 1.01e-8);
    }
}

TOUCHDOWN_TEST(TestElasticContactLimits)

} // namespace test_elastic_contact_limits

#include "test_elastic_contact_limits.moc"
