// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/adhesive_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <QTest>

#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_adhesive_contact {

constexpr double modulus = 1e11; // E* [Pa]

UniformGrid square(int n) { return {n, n, 0.25e-6, 0.25e-6, 0.0, 0.0}; }

/// Separation `d` of a pad from a rough disk of some 0.2 nm RMS: waves that share no period.
std::vector<double> rough(const UniformGrid& grid, double d)
{
    std::vector<double> s(grid.cells());
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            double height = 0.0;
            for (int k = 1; k <= 9; ++k)
                height += 0.1e-9 * std::sin(2.9e6 * (std::cos(2.1 * k) * grid.x(i) + std::sin(2.1 * k) * grid.y(j)) +
                                            1.7 * k * k);
            s[static_cast<std::size_t>(j * grid.nx + i)] = d - height;
        }
    return s;
}

double force(const AdhesiveContactSummary& summary) { return summary.load + summary.adhesionForce; }

struct Balance {
    double gap = 0.0;     // g - s - C (p + f) against the largest displacement [-]
    bool signs = true;    // p >= 0, g >= 0, p g = 0
    bool adhesive = true; // f = f(g)
};

Balance balance(AdhesiveContact& contact, const std::vector<double>& separation)
{
    std::vector<double> u(separation.size());
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = contact.pressure()[i] + contact.adhesion()[i];
    contact.space().displace(u, u);
    Balance found;
    double scale = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double p = contact.pressure()[i], f = contact.adhesion()[i], g = contact.gap()[i];
        found.gap = std::max(found.gap, std::abs(g - separation[i] - u[i]));
        scale = std::max(scale, std::abs(u[i]));
        found.signs = found.signs && p >= 0.0 && g >= 0.0 && p * g == 0.0;
        found.adhesive =
            found.adhesive && std::abs(f - contact.law().pressure(g)) <= 1e-12 * contact.law().peakAttraction();
    }
    found.gap /= scale;
    return found;
}

class TestAdhesiveContact : public QObject {
    Q_OBJECT

private slots:
    void withoutAdhesion()
    {
        const UniformGrid grid = square(32);
        const std::vector<double> s = rough(grid, -0.1e-9);
        AdhesiveContact adhesive(HalfSpace(grid, modulus), {});
        ElasticContact elastic(HalfSpace(grid, modulus));
        const AdhesiveContactSummary summary = adhesive.solve(s);
        const ElasticContactSummary expected = elastic.solve(s);
        QVERIFY(summary.converged && summary.load > 0.0);
        QCOMPARE(summary.load, expected.load);
        QCOMPARE(summary.adhesionForce, 0.0);
        QVERIFY(std::equal(elastic.pressure().begin(), elastic.pressure().end(), adhesive.pressure().begin()));
        QVERIFY(std::equal(elastic.gap().begin(), elastic.gap().end(), adhesive.gap().begin()));
    }

    void balanced_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("voltage");
        QTest::newRow("Lennard-Jones") << static_cast<int>(AdhesionKind::LennardJones) << 0.0;
        QTest::newRow("Lennard-Jones with voltage") << static_cast<int>(AdhesionKind::LennardJones) << 0.5;
        QTest::newRow("van der Waals") << static_cast<int>(AdhesionKind::VanDerWaals) << 0.0;
        QTest::newRow("electrostatic") << static_cast<int>(AdhesionKind::None) << 0.5;
    }

    /// The whole way there and back in steps of 0.1 nm, cells snapping: each returned field is a solution to 1e-8.
    void balanced()
    {
        QFETCH(int, kind);
        QFETCH(double, voltage);
        const UniformGrid grid = square(32);
        AdhesiveContact contact(HalfSpace(grid, modulus),
                                {.kind = static_cast<AdhesionKind>(kind), .voltage = voltage});
        for (int step = -20; step <= 40; ++step) {
            const std::vector<double> s = rough(grid, 0.1e-9 * (std::abs(step) - 2));
            const AdhesiveContactSummary summary = contact.solve(s);
            QVERIFY2(summary.converged, qPrintable(QString::fromStdString(summary.message)));
            const Balance found = balance(contact, s);
            QVERIFY2(found.gap <= 1e-8, qPrintable(QString::number(found.gap)));
            QVERIFY(found.signs && found.adhesive);
        }
    }

    /// p <= H, and only where p = H the gap may be negative; the gaps are balanced there, too.
    void hardness()
    {
        const UniformGrid grid = square(24);
        const double limit = 5e7;
        AdhesiveContact contact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones}, {.hardness = limit});
        const std::vector<double> s = rough(grid, -1e-9);
        QVERIFY(contact.solve(s).converged);
        QVERIFY(balance(contact, s).gap <= 1e-8);
        int flowed = 0;
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double p = contact.pressure()[i], g = contact.gap()[i];
            QVERIFY(p >= 0.0 && p <= limit && (g <= 0.0 || p == 0.0) && (g >= 0.0 || p == limit));
            flowed += g < 0.0;
        }
        QVERIFY(flowed > 0);
    }

    /// Pressed together everywhere the energy has one minimum: from far, from nearer and from nothing the same.
    void independentOfStart()
    {
        const UniformGrid grid = square(24);
        const std::vector<double> s = rough(grid, -2e-9);
        AdhesiveContact contact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones});
        const double first = force(contact.solve(s));
        contact.solve(rough(grid, -1e-9));
        const double fromAbove = force(contact.solve(s));
        contact.solve(rough(grid, -4e-9));
        const double fromBelow = force(contact.solve(s));
        QVERIFY(std::abs(fromAbove - first) < 1e-7 * first);
        QVERIFY(std::abs(fromBelow - first) < 1e-7 * first);
    }

    void deterministic()
    {
        const UniformGrid grid = square(24);
        AdhesiveContact a(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones});
        AdhesiveContact b = AdhesiveContact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones});
        for (const double d : {2e-9, 1e-9, 0.3e-9, 1.2e-9})
            QCOMPARE(force(a.solve(rough(grid, d))), force(b.solve(rough(grid, d))));
        a.remember();
        const double up = force(a.solve(rough(grid, 1.4e-9)));
        a.solve(rough(grid, 30e-9));
        a.recall();
        QCOMPARE(force(a.solve(rough(grid, 1.4e-9))), up);
    }

    /// A uniform periodic patch is displaced by nothing: force = f(s) area, exactly.
    void uniformPeriodic()
    {
        const UniformGrid grid = square(16);
        AdhesiveContact contact(HalfSpace(grid, modulus, HalfSpaceEdges::Periodic),
                                {.kind = AdhesionKind::LennardJones});
        for (const double d : {3e-9, 0.5e-9, 0.1e-9, 0.03e-9, 0.2e-9}) {
            const AdhesiveContactSummary summary = contact.solve(std::vector<double>(grid.cells(), d));
            QVERIFY(summary.converged);
            const double expected = contact.law().pressure(d) * static_cast<double>(grid.cells()) * grid.cellArea();
            QVERIFY(std::abs(force(summary) - expected) < 1e-7 * std::abs(expected));
        }
    }

    /// Nothing is solved where the deformation changes no pressure by more than tolerance f_max; compared with a
    /// solution of a tolerance so small that it is solved for.
    void farAway()
    {
        const UniformGrid grid = square(32);
        const Adhesion adhesion{.kind = AdhesionKind::LennardJones};
        AdhesiveContact contact(HalfSpace(grid, modulus), adhesion),
            exact(HalfSpace(grid, modulus), adhesion, {.tolerance = 1e-12});
        const std::vector<double> s = rough(grid, 12e-9);
        const AdhesiveContactSummary summary = contact.solve(s), solved = exact.solve(s);
        QVERIFY(summary.converged && solved.converged);
        QCOMPARE(summary.iterations, 0);
        QVERIFY(solved.iterations > 0);
        double error = 0.0;
        for (std::size_t i = 0; i < s.size(); ++i)
            error = std::max(error, std::abs(contact.adhesion()[i] - exact.adhesion()[i]));
        QVERIFY(error > 0.0 && error <= 1e-8 * contact.law().peakAttraction());
        QVERIFY(contact.solve(rough(grid, 5e-9)).iterations > 0);
    }

    /// A rough pad that came into contact holds on the way back: the force differs between the ways, and each large
    /// change of force sets energy free, more than rounding.
    void hysteresis()
    {
        const UniformGrid grid = square(32);
        AdhesiveContact contact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones});
        const double there = force(contact.solve(rough(grid, 2.2e-9)));
        bool snapped = false, pulled = false;
        for (double d = 2.1e-9; d > 0.3e-9; d -= 0.1e-9) snapped |= contact.solve(rough(grid, d)).jumped;
        double back = 0.0;
        for (double d = 0.4e-9; d < 2.25e-9; d += 0.1e-9) back = force(contact.solve(rough(grid, d)));
        for (double d = 2.3e-9; d < 8e-9; d += 0.1e-9) pulled |= contact.solve(rough(grid, d)).jumped;
        QVERIFY(snapped && pulled);
        QVERIFY(back < 2.0 * there && there < 0.0);
    }

    /// A surface that moves on while the pad goes up and down, three times through snapping in and pulling off: what a
    /// dynamics program asks. A loose tolerance follows the same branches as a tight one, its force within that share
    /// of the largest attraction over the patch.
    void followsAMovingSurface()
    {
        const UniformGrid grid = square(24);
        const Adhesion law{.kind = AdhesionKind::LennardJones};
        AdhesiveContact tight(HalfSpace(grid, modulus), law, {.tolerance = 1e-9}),
            loose(HalfSpace(grid, modulus), law, {.tolerance = 1e-4});
        const double largest = tight.law().peakAttraction() * static_cast<double>(grid.cells()) * grid.cellArea();
        int apart = 0, adhered = 0;
        for (int k = 0; k < 90; ++k) {
            UniformGrid moved = grid;
            moved.x0 -= 0.3e-6 * k; // the surface runs in +x
            const std::vector<double> s = rough(moved, 4e-9 + 4.5e-9 * std::cos(0.21 * k));
            const AdhesiveContactSummary a = tight.solve(s), b = loose.solve(s);
            QVERIFY(a.converged && b.converged);
            QVERIFY2(std::abs(force(a) - force(b)) < 1e-4 * largest, qPrintable(QString("step %1").arg(k)));
            const Balance found = balance(loose, s);
            QVERIFY(found.signs && found.adhesive);
            QVERIFY(b.iterations == 0 || found.gap < 1e-4);
            (a.load > 0.0 ? adhered : apart) += 1;
        }
        QVERIFY(apart > 10 && adhered > 10);
    }
    /// What adheres stays although its undeformed surfaces are so far apart that nothing would have come together
    /// there.
    void adheresWhereTheUndeformedSurfacesAreFar()
    {
        const UniformGrid grid = square(24);
        const Adhesion law{.kind = AdhesionKind::LennardJones};
        AdhesiveContact pressed(HalfSpace(grid, modulus), law, {.tolerance = 1e-4}),
            above(HalfSpace(grid, modulus), law, {.tolerance = 1e-4});
        pressed.solve(rough(grid, 0.0));
        const AdhesiveContactSummary held = pressed.solve(rough(grid, 3e-9));
        const AdhesiveContactSummary far = above.solve(rough(grid, 3e-9));
        QCOMPARE(far.iterations, 0);
        QVERIFY(force(held) < 10.0 * force(far) && force(far) < 0.0);
    }
    /// Many cells at once have the tangents of each alone.
    void tangentsOfManyCells_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("voltage");
        QTest::newRow("Lennard-Jones") << static_cast<int>(AdhesionKind::LennardJones) << 0.0;
        QTest::newRow("Lennard-Jones under a voltage") << static_cast<int>(AdhesionKind::LennardJones) << 2.0;
        QTest::newRow("van der Waals") << static_cast<int>(AdhesionKind::VanDerWaals) << 0.0;
        QTest::newRow("voltage alone") << static_cast<int>(AdhesionKind::None) << 2.0;
    }
    void tangentsOfManyCells()
    {
        QFETCH(int, kind);
        QFETCH(double, voltage);
        const AdhesionLaw law({.kind = static_cast<AdhesionKind>(kind), .voltage = voltage});
        const AdhesiveCell cell(law, 3e-18, 2e9);
        std::vector<double> gap, pressure, offset(203);
        for (int k = 0; k < 203; ++k) {
            gap.push_back(-0.2e-9 + 0.01e-9 * k);
            pressure.push_back(3e8 * std::sin(1.3 * k) + (k % 50 == 0 ? 3e9 : 0.0));
        }
        cell.offsets(gap, offset);
        AdhesiveCell::Tangents many(gap.size());
        cell.tangents(gap, pressure, offset, many);
        for (std::size_t i = 0; i < gap.size(); ++i) {
            const AdhesiveCell::Tangent one = cell.tangent(gap[i], pressure[i], offset[i]);
            QVERIFY(std::abs(offset[i] - cell.offset(gap[i])) <= 1e-12 * law.peakAttraction());
            QCOMPARE(many.state[i], one.state);
            QVERIFY(std::abs(many.gap[i] - one.gap) <= 1e-7 * std::max(law.peakGap(), std::abs(one.gap)));
            QVERIFY(std::abs(many.pressure[i] - one.pressure) <=
                    1e-6 * (law.peakAttraction() + std::abs(one.pressure)));
            if (one.state == AdhesiveCell::State::Contact) QVERIFY(!std::isfinite(many.stiffness[i]));
        }
    }

    void refused()
    {
        const UniformGrid grid = square(16);
        AdhesiveContact contact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones});
        const std::vector<double> good = rough(grid, 0.5e-9);
        const double before = force(contact.solve(good));
        std::vector<double> bad = good;
        bad[7] = std::numeric_limits<double>::quiet_NaN();
        const AdhesiveContactSummary summary = contact.solve(bad);
        QVERIFY(!summary.converged && !summary.message.empty());
        QVERIFY(std::abs(force(contact.solve(good)) - before) < 1e-7 * std::abs(before));
        AdhesiveContact periodic(HalfSpace(grid, modulus, HalfSpaceEdges::Periodic),
                                 {.kind = AdhesionKind::LennardJones});
        QVERIFY(!periodic.solve(std::vector<double>(grid.cells(), -1e-9)).message.empty());
    }

    void saysWhenItDoesNotConverge()
    {
        const UniformGrid grid = square(16);
        AdhesiveContact contact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones},
                                {.maximumIterations = 3});
        const AdhesiveContactSummary summary = contact.solve(rough(grid, 0.2e-9));
        QVERIFY(!summary.converged && summary.error > 1e-8 && !summary.message.empty());
        QVERIFY(std::isfinite(force(summary)));
        for (const double g : contact.gap()) QVERIFY(std::isfinite(g));
    }

    void allocatesNothing()
    {
        const UniformGrid grid = square(16);
        AdhesiveContact contact(HalfSpace(grid, modulus), {.kind = AdhesionKind::LennardJones});
        const std::vector<double> near = rough(grid, 0.5e-9), far = rough(grid, 3e-9), nearer = rough(grid, 0.3e-9);
        contact.solve(near);
        const long long before = test::allocations;
        contact.solve(nearer);
        contact.solve(far);
        contact.remember();
        contact.recall();
        QCOMPARE(test::allocations.load(), before);
    }
};

TOUCHDOWN_TEST(TestAdhesiveContact)

} // namespace test_adhesive_contact

#include "test_adhesive_contact.moc"
