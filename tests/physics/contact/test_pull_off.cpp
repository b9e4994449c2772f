// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere on an elastic half-space with adhesion, s = d + r^2/(2 R), between the limits of Derjaguin, Muller & Toporov
// (1975) and of Johnson, Kendall & Roberts (1971), by Tabor's number mu = (R dgamma^2/(E*^2 z0^3))^(1/3).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <QTest>

#include "core/physics/contact/adhesion_kind.h"
#include "core/physics/contact/adhesive_contact.h"
#include "core/physics/contact/contact_jump.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_pull_off {

constexpr double radius = 1e-6;        // R [m]
constexpr double surfaceEnergy = 0.05; // dgamma [N/m]
constexpr double z0 = 0.3e-9;          // [m]
using std::numbers::pi;

/// E* [Pa] for Tabor's number.
double modulus(double mu) { return std::sqrt(radius * surfaceEnergy * surfaceEnergy / (mu * mu * mu * z0 * z0 * z0)); }

struct Sphere {
    UniformGrid grid;
    AdhesiveContact contact;
    std::vector<double> separation;

    int iterations = 0; // of the last solution

    Sphere(double mu, int n, double halfWidth, double tolerance = ElasticContactOptions{}.tolerance)
        : grid{n, n, 2.0 * halfWidth / n, 2.0 * halfWidth / n, -halfWidth, -halfWidth},
          contact(HalfSpace(grid, modulus(mu)),
                  {.kind = AdhesionKind::LennardJones, .surfaceEnergy = surfaceEnergy, .equilibriumDistance = z0},
                  {.tolerance = tolerance}),
          separation(grid.cells())
    {}

    AdhesiveContactSummary solve(double d)
    {
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i)
                separation[static_cast<std::size_t>(j * grid.nx + i)] =
                    d + (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2.0 * radius);
        return contact.solve(separation);
    }
    /// Force over pi R dgamma; not a number unless it converged.
    double force(double d)
    {
        const AdhesiveContactSummary summary = solve(d);
        iterations = summary.iterations;
        return summary.converged ? (summary.load + summary.adhesionForce) / (pi * radius * surfaceEnergy) : NAN;
    }
    /// The largest attraction on the way up.
    double pullOff(double from, double to, double step)
    {
        double most = 0.0;
        for (double d = from; d <= to; d += step) {
            const double f = force(d);
            if (!(std::abs(f) < 100.0)) return NAN;
            most = std::max(most, -f);
        }
        return most;
    }
};

class TestPullOff : public QObject {
    Q_OBJECT

private slots:
    /// 2 pi R dgamma. The patch cuts the attraction off at s = a^2/(2 R) = 9.8 nm on its edges, which leaves
    /// (4/3)(z0/(s + z0))^2 = 0.11 % of it out.
    void rigid()
    {
        const double force = Sphere(0.05, 96, 1.4e-7).pullOff(-0.04e-9, 0.08e-9, 0.02e-9);
        QVERIFY(std::abs(force - 2.0) < 0.05 * 2.0);
    }

    /// Derjaguin: a sphere that does not deform is attracted with 2 pi R phi(d); the square patch lacks the tail,
    /// bounded as above by phi at its edges and corners, and the deformation adds less than 1.5 % here.
    void derjaguin()
    {
        Sphere sphere(0.02, 96, 1.4e-7);
        for (const double d : {0.3e-9, 0.5e-9, 1e-9}) {
            const double expected = 2.0 * sphere.contact.law().energy(d) / surfaceEnergy;
            QVERIFY(std::abs(sphere.force(d) - expected) < 0.03 * std::abs(expected));
        }
    }

    /// 3/2 pi R dgamma. The cohesive zone, E* dgamma/f_max^2 = 1.5 nm, is as long as a cell.
    void soft()
    {
        const double force = Sphere(5.0, 100, 7e-8).pullOff(0.7e-9, 1.3e-9, 0.3e-9);
        QVERIFY(std::abs(force - 1.5) < 0.05 * 1.5);
    }

    /// JKR: without load a^3 = 9 pi dgamma R^2/(2 E*) at an approach of a^2/(3 R). With cohesive zones of 1.5 nm
    /// against a = 94 nm the edge is known to a cell, 3.3 nm.
    void radiusWithoutLoad()
    {
        const double a = std::cbrt(9.0 * pi * surfaceEnergy * radius * radius / (2.0 * modulus(5.0)));
        Sphere sphere(5.0, 64, 1.05e-7);
        QVERIFY(sphere.solve(-a * a / (3.0 * radius)).converged);
        double area = 0.0;
        for (const double g : sphere.contact.gap())
            if (g < sphere.contact.law().peakGap()) area += sphere.grid.cellArea();
        QVERIFY(std::abs(std::sqrt(area / pi) - a) < 0.05 * a);
    }

    /// Between the limits the pull-off force falls with mu (Greenwood 1997; Maugis 1992).
    void between()
    {
        const double hard = Sphere(0.2, 64, 1e-7).pullOff(-0.05e-9, 0.25e-9, 0.05e-9);
        const double middle = Sphere(1.0, 64, 8e-8).pullOff(0.0, 0.5e-9, 0.05e-9);
        const double softer = Sphere(2.0, 64, 7e-8).pullOff(0.2e-9, 0.9e-9, 0.1e-9);
        QVERIFY(2.0 > hard && hard > middle && middle > softer && softer > 1.5);
    }

    /// Next to the end of a branch one cell hardly holds: a descent creeps along its softest motion, for 2500
    /// iterations in one of these states, where Newton's method takes some 200. The way up, searched for jumps to a
    /// picometre.
    void endsOfBranchesTakeFewIterations()
    {
        Sphere sphere(2.0, 48, 7e-8, 1e-6);
        int worst = 0;
        const TracedContact contact{[&](double d) {
                                        const double force = sphere.force(d);
                                        worst = std::max(worst, sphere.iterations);
                                        return force;
                                    },
                                    [&] { sphere.contact.remember(); }, [&] { sphere.contact.recall(); }};
        double from = 0.0, force = contact.force(from);
        int jumps = 0;
        for (int k = 1; k < 12; ++k) {
            const double to = 0.1e-9 * k;
            jumps += locateJump(contact, from, force, to, 1e-12, 1e-3).found;
            force = contact.force(to);
            QVERIFY(std::isfinite(force));
            from = to;
        }
        QVERIFY(jumps > 0);
        QVERIFY2(worst < 1000, qPrintable(QString::number(worst)));
    }

    /// A soft sphere snaps in on the way down nearer than it pulls off on the way up; each jump is located, and sets
    /// energy free.
    void hysteresis()
    {
        Sphere sphere(2.0, 48, 7e-8);
        const TracedContact contact{[&](double d) { return sphere.force(d); }, [&] { sphere.contact.remember(); },
                                    [&] { sphere.contact.recall(); }};
        const double far = 1.5e-9, near = 0.65e-9;
        const ContactJump in = locateJump(contact, far, contact.force(far), near, 1e-12, 0.05);
        QVERIFY(in.found);
        QVERIFY(std::abs(in.before - in.after) <= 1e-12 && in.forceAfter < in.forceBefore - 0.05);
        const AdhesiveContactSummary snap = sphere.solve(in.after);
        QVERIFY(snap.jumped && snap.energyDrop > 0.0);
        const ContactJump off = locateJump(contact, in.after, contact.force(in.after), far, 1e-12, 0.05);
        QVERIFY(off.found);
        QVERIFY(off.forceAfter > off.forceBefore + 0.05);
        QVERIFY(off.before > in.before + 0.2e-9);
        QVERIFY(sphere.solve(off.after).jumped);
    }
};

TOUCHDOWN_TEST(TestPullOff)

} // namespace test_pull_off

#include "test_pull_off.moc"
