// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/multi_asperity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/allocation_count.h"
#include "tests/support/asperity_pad.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_multi_asperity {

using std::numbers::pi;

using Setting = test::AsperityPad;
using test::stiffBulk;

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

class TestMultiAsperity : public QObject {
    Q_OBJECT

private slots:
    /// k_b: the mean displacement of a unit square under unit pressure on a half-space of E* = 1 is the mean of 1/(pi
    /// r) over pairs of its points: with |x|, |y| of their distance as coordinates, density 4 (1 - x)(1 - y), in polar
    /// coordinates (8/pi) int_0^(pi/4) int_0^(1/cos) (1 - r cos)(1 - r sin) dr da = (8/pi) int [1/c - (c + s)/(2 c^2) +
    /// s/(3 c^2)] da.
    void bulkStiffnessOfASquare()
    {
        const auto ray = [](double angle) {
            const double c = std::cos(angle), sine = std::sin(angle);
            return 1.0 / c - (c + sine) / (2.0 * c * c) + sine / (3.0 * c * c);
        };
        const int n = 100; // Simpson
        const double h = pi / 4.0 / n;
        double sum = ray(0.0) + ray(pi / 4.0);
        for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * ray(i * h);
        const double compliance = 8.0 / pi * sum * h / 3.0;
        const Setting s;
        const double expected = contactModulus(s.pair) * std::sqrt(s.area) / compliance;
        QVERIFY(near(s.model().bulkStiffness(), expected, 1e-8 * expected));
        QVERIFY(near(s.model().bulkStiffness() / (contactModulus(s.pair) * std::sqrt(s.area)), 1.0566, 1e-4));
    }

    /// Infinitely stiff bulk: the contact force is A p(d) on both ways, no jump, and zeta is the play of s = d: on the
    /// way in all above d - t are wetted, on the way out those above max(d_min - t, d - h_b).
    void stiffBulkIsPureGreenwoodWilliamson()
    {
        const Setting s = stiffBulk();
        const MultiAsperity model = s.model();
        const AsperityContact contact(s.asperities, s.pair);
        const double closest = 1.5e-9;
        const auto curve = multiAsperityCurve(model, 6e-9, closest, 101);
        QVERIFY(curve.touchDowns.empty() && curve.takeOffs.empty());
        const auto wetted = [&](double height) {
            return 0.5 * std::erfc((height - s.asperities.planeHeight) / s.asperities.heightDeviation / std::sqrt(2.0));
        };
        // What is left of the bulk's giving way, F_c/k_b, is below 1e-15 m.
        for (const MultiAsperityPoint& point : curve.towards) {
            const double d = point.padSeparation;
            QVERIFY(
                near(point.forces.contact, s.area * contact.pressure(d), 1e-5 * s.area * contact.pressure(closest)));
            QVERIFY(near(-point.forces.adhesion, s.adhesion() * wetted(d - 0.5e-9), 1e-5 * s.adhesion()));
        }
        for (const MultiAsperityPoint& point : curve.away) {
            const double d = point.padSeparation;
            QVERIFY(
                near(point.forces.contact, s.area * contact.pressure(d), 1e-5 * s.area * contact.pressure(closest)));
            QVERIFY(near(-point.forces.adhesion, s.adhesion() * wetted(std::max(closest - 0.5e-9, d - 1.5e-9)),
                         1e-5 * s.adhesion()));
        }
    }

    /// All summits alike (sigma -> 0, at y_s). Way in: no force until s = d = y_s + t; there all wet, and s drops to
    /// where A eta (4/3) E* sqrt(R) (y_s - s)^(3/2) - f_m = k_b (s - d). Way out: held until s = y_s + h_b, at d = y_s
    /// + h_b + f_m/k_b, then no force. sigma = 1 pm: folds lie within 5 sigma of these.
    void summitsOfOneHeight()
    {
        Setting s;
        s.asperities.heightDeviation = 1e-12;
        const MultiAsperity model = s.model();
        const double fm = s.adhesion();
        const double kb = model.bulkStiffness();
        const auto curve = multiAsperityCurve(model, 8e-9, 1e-9, 101);
        QCOMPARE(curve.touchDowns.size(), std::size_t(1));
        QCOMPARE(curve.takeOffs.size(), std::size_t(1));
        const MultiAsperityJump& in = curve.touchDowns[0];
        const MultiAsperityJump& out = curve.takeOffs[0];
        QVERIFY(near(in.padSeparation, 2.5e-9, 5e-12));
        QVERIFY(near(out.padSeparation, 3.5e-9 + fm / kb, 5e-12));

        // s after touch-down, by halving.
        const double hertz =
            s.asperities.density * s.area * 4.0 / 3.0 * contactModulus(s.pair) * std::sqrt(s.asperities.radius);
        const auto excess = [&](double place) {
            return hertz * std::pow(std::max(0.0, 2e-9 - place), 1.5) - fm - kb * (place - in.padSeparation);
        };
        double low = 0.0, high = in.padSeparation;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            (excess(middle) > 0.0 ? low : high) = middle;
        }
        const MultiAsperityForces after = model.forces(in.to);
        QVERIFY(near(in.to.separation, low, 1e-13));
        QVERIFY(near(after.adhesion, -fm, 1e-9 * fm));
        QVERIFY(
            near(after.total(), kb * (low - in.padSeparation), 2e-3 * fm)); // 0.1 pm of 2 nm pressed by k_b + dF_cr/ds
        QVERIFY(near(model.forces(out.from).adhesion, -fm, 0.02 * fm));
        QCOMPARE(model.forces(out.to).total(), 0.0);
    }

    /// A jump stands at a fold, where d(s) has its extremum: d'(s) = 0 by differences, and d is met again after it.
    /// Between sampling every 7.5 pm or 0.5 pm the curve has the same jumps.
    void jumpsStandAtFolds()
    {
        const Setting s;
        const MultiAsperity model = s.model();
        const auto coarse = multiAsperityCurve(model, 8e-9, 0.5e-9, 11);
        const auto fine = multiAsperityCurve(model, 8e-9, 0.5e-9, 15001);
        QCOMPARE(coarse.touchDowns.size(), std::size_t(1));
        QCOMPARE(coarse.takeOffs.size(), std::size_t(1));
        QCOMPARE(fine.touchDowns.size(), std::size_t(1));
        QCOMPARE(fine.takeOffs.size(), std::size_t(1));
        QVERIFY(near(coarse.touchDowns[0].padSeparation, fine.touchDowns[0].padSeparation, 1e-21));
        QVERIFY(near(coarse.takeOffs[0].padSeparation, fine.takeOffs[0].padSeparation, 1e-21));

        const auto slopeAt = [&](const MultiAsperityJump& jump, double lag) {
            const double h = 1e-14;
            const auto d = [&](double place) { return model.padSeparation({place, place - lag}); };
            return (d(jump.from.separation + h) - d(jump.from.separation - h)) / (2.0 * h);
        };
        QVERIFY(std::abs(slopeAt(coarse.touchDowns[0], 0.5e-9)) < 1e-6);
        QVERIFY(std::abs(slopeAt(coarse.takeOffs[0], 1.5e-9)) < 1e-6);
        for (const auto& jump : {coarse.touchDowns[0], coarse.takeOffs[0]}) {
            QVERIFY(near(model.padSeparation(jump.from), jump.padSeparation, 1e-23));
            QVERIFY(near(model.padSeparation(jump.to), jump.padSeparation, 1e-18));
        }
        QVERIFY(coarse.touchDowns[0].to.separation < coarse.touchDowns[0].from.separation);
        QVERIFY(coarse.takeOffs[0].to.separation > coarse.takeOffs[0].from.separation);
    }

    /// The state depends on the way, not on its steps: many small ones or one large one lead to the same.
    void stepsDoNotMatter()
    {
        const MultiAsperity model = Setting{}.model();
        MultiAsperityState small = model.start(8e-9), large = small;
        for (const double turn : {1e-9, 4e-9, 2e-9, 4.8e-9, 2.6e-9, 7.9e-9, 2.9e-9}) {
            const double from = model.padSeparation(small);
            for (int i = 1; i <= 1000; ++i) small = model.advance(small, from + (turn - from) * i / 1000.0);
            large = model.advance(large, turn);
            QVERIFY2(near(small.separation, large.separation, 1e-18), qPrintable(QString::number(turn)));
            QVERIFY(near(model.forces(small).total(), model.forces(large).total(), 1e-9));
            QVERIFY(near(model.padSeparation(large), turn, 1e-20));
        }
    }

    /// A dried summit wets again only at the film's thickness: after a partial way out and in the same wetted height
    /// returns, and on the way between none forms or breaks (play).
    void wettedHeightHasPlay()
    {
        const MultiAsperity model = stiffBulk().model();
        MultiAsperityState state = model.advance(model.start(6e-9), 2.5e-9);
        const double wetted = state.wettedAbove;
        QVERIFY(near(wetted, 2.0e-9, 1e-14));
        state = model.advance(state, 3.4e-9); // drags from 2.0 + 1.5 nm
        QCOMPARE(state.wettedAbove, wetted);
        state = model.advance(state, 3.7e-9);
        QVERIFY(near(state.wettedAbove, 2.2e-9, 1e-14));
        const double dried = state.wettedAbove;
        state = model.advance(state, 2.8e-9); // drags from 2.2 + 0.5 nm
        QCOMPARE(state.wettedAbove, dried);
        state = model.advance(state, 2.6e-9);
        QVERIFY(near(state.wettedAbove, 2.1e-9, 1e-14));
    }

    /// Menisci so strong against the bulk that it stretches half a millimetre before they let go: still one jump each
    /// way, and take-off at y_s + h_b + f_m/k_b, where the lowest summits (nine deviations) are of no account.
    void strongMenisciOnASoftBulk()
    {
        Setting s;
        s.asperities = {.radius = 78e-6, .density = 8e12, .heightDeviation = 5e-12, .planeHeight = 2e-9};
        s.meniscus = {.surfaceTension = 0.66, .contactAngle = 0.0, .filmThickness = 1e-9, .breakingLength = 4e-9};
        s.pair.diskModulus = 40e6;
        s.area = 18e-12;
        const MultiAsperity model = s.model();
        const double stretch = s.adhesion() / model.bulkStiffness();
        QVERIFY(stretch > 0.4e-3);
        const auto curve = multiAsperityCurve(model, model.reach(), 2e-9, 101);
        QCOMPARE(curve.touchDowns.size(), std::size_t(1));
        QCOMPARE(curve.takeOffs.size(), std::size_t(1));
        QVERIFY(near(curve.takeOffs[0].padSeparation, 6e-9 + stretch, 1e-6 * stretch));
        QVERIFY(curve.work > 0.0);
    }

    /// Menisci that break where they formed lose nothing on a smooth way: the loop is lost in its jumps.
    void withoutPlayTheLoopIsLostInJumps()
    {
        Setting s;
        s.meniscus.breakingLength = s.meniscus.filmThickness;
        s.pair.diskModulus = 1e9; // soft, so that it jumps
        const MultiAsperity model = s.model();
        const auto curve = multiAsperityCurve(model, model.reach(), s.asperities.planeHeight - 1e-9, 4001);
        QCOMPARE(curve.touchDowns.size(), std::size_t(1));
        QCOMPARE(curve.takeOffs.size(), std::size_t(1));
        QVERIFY(curve.work > 0.0);
        QVERIFY2(near(curve.lostInJumps, curve.work, 1e-3 * curve.work),
                 qPrintable(QString("%1 %2").arg(curve.lostInJumps).arg(curve.work)));
    }

    /// The stiffness is the force's change over a small move, on either side where they differ: on the way in menisci
    /// gather, on turning back nothing breaks.
    void stiffnessIsTheForcesSlope()
    {
        const MultiAsperity model = Setting{}.model();
        for (const double d : {3.2e-9, 2.6e-9, 2.3e-9, 1.5e-9}) {
            const MultiAsperityState state = model.advance(model.start(8e-9), d);
            for (const PadMotion motion : {PadMotion::Towards, PadMotion::Away}) {
                const double h = motion == PadMotion::Away ? 1e-14 : -1e-14;
                const auto force = [&](double at) { return model.forces(model.advance(state, at)).total(); };
                // One-sided, second order.
                const double slope = (4.0 * force(d + h) - force(d + 2.0 * h) - 3.0 * force(d)) / (2.0 * h);
                const MultiAsperitySlopes slopes = model.slopes(state, motion);
                const double stiffness = -(slopes.contact + slopes.adhesion);
                QVERIFY2(near(-slope, stiffness, 1e-5 * model.bulkStiffness()),
                         qPrintable(QString("d %1: %2 %3").arg(d).arg(-slope).arg(stiffness)));
            }
        }
    }

    /// Where nothing wets or dries, the work of the pad's drive goes into what is stored and into the menisci's
    /// stretch: -int F_c dd = [E] + |F_m| [s]. The integral by trapezoids.
    void storedEnergyIsTheWork()
    {
        const MultiAsperity model = Setting{}.model();
        MultiAsperityState state = model.advance(model.start(8e-9), 0.5e-9);
        const MultiAsperityState begin = state;
        const MultiAsperityForces first = model.forces(state);
        double work = 0.0, force = first.total();
        const int steps = 4000;
        for (int i = 1; i <= steps; ++i) {
            state = model.advance(state, 0.5e-9 + 1.5e-9 * i / steps);
            const double next = model.forces(state).total();
            work -= 0.5 * (force + next) * 1.5e-9 / steps;
            force = next;
        }
        QCOMPARE(state.wettedAbove, begin.wettedAbove);
        const MultiAsperityForces last = model.forces(state);
        const double expected =
            last.storedEnergy - first.storedEnergy - last.adhesion * (state.separation - begin.separation);
        QVERIFY2(near(work, expected, 1e-6 * std::abs(expected)), qPrintable(QString("%1 %2").arg(work).arg(expected)));
    }

    void advanceAllocatesNothing()
    {
        const MultiAsperity model = Setting{}.model();
        MultiAsperityState state = model.start(8e-9);
        double sum = 0.0;
        const auto before = test::allocations.load();
        for (const double d : {6e-9, 2e-9, 0.5e-9, 3e-9, 4e-9, 7e-9, 1e-9, -5e-9, 20e-9}) {
            state = model.advance(state, d);
            sum += model.forces(state).total();
            if (const auto jump = model.nextJump(state, PadMotion::Towards)) sum += jump->padSeparation;
        }
        QCOMPARE(test::allocations.load(), before);
        QVERIFY(std::isfinite(sum));
    }
};

TOUCHDOWN_TEST(TestMultiAsperity)

} // namespace test_multi_asperity

#include "test_multi_asperity.moc"
