// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/spring_equilibria.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spring_equilibria {

using Mode = SpringModel::Mode;

CaseAt byParameter(const Case& c, const char* key)
{
    return [c, parameter = findParameter(key)](double value) -> std::optional<Case> {
        Case changed = c;
        if (setFromNumber(changed, *parameter, value) || !checkCombinations(changed).empty()) return {};
        return changed;
    };
}

/// One spring under the mass centre, which carries nothing but what the menisci pull: the pitch does not take part.
Case oneSpring()
{
    Case c;
    c.springs.frontStiffness = 0.0;
    c.springs.rearDistance = 0.0;
    c.springs.rearStiffness = 1e6;
    c.springs.flyingHeight = 7e-9;
    c.springs.pitch = 0.0;
    c.suspension.stiffness = 0.0;
    c.springs.padDistance = 0.0;
    c.onoYamane.initialContactForce = 0.0;
    c.onoYamane.touchDown = 2e-9;
    c.onoYamane.takeOff = 5e-9;
    c.onoYamane.takeOffShape = TakeOffShape::Linear;
    return c;
}

class TestSpringEquilibria : public QObject {
    Q_OBJECT

private slots:
    void convergedEndStates_data()
    {
        QTest::addColumn<double>("meniscusForce");
        QTest::addColumn<double>("takeOff");
        QTest::addColumn<double>("cutoff");
        QTest::addColumn<double>("staticHeight");
        QTest::addColumn<double>("flyingHeight"); // [nm]
        QTest::addColumn<double>("pitch");        // [urad]; 0: not known
        // The balances of the default case, solved by SciPy's fsolve.
        QTest::newRow("flying") << 10.7e-3 << 5e-9 << 0.3e-9 << 7e-9 << 7.0 << 90.6;
        QTest::newRow("meniscus force 50 mN") << 50e-3 << 5e-9 << 0.3e-9 << 7e-9 << 1.6018 << 94.172;
        QTest::newRow("take-off height 8 nm") << 10.7e-3 << 8e-9 << 0.3e-9 << 7e-9 << 3.7994 << 94.171;
        QTest::newRow("take-off height 8 nm, lost early") << 10.7e-3 << 8e-9 << 3e-9 << 7e-9 << 3.7994 << 94.171;
        QTest::newRow("50 mN, rear spring lost") << 50e-3 << 5e-9 << 3e-9 << 7e-9 << -5.0363 << 85.686;
        QTest::newRow("Table III, 4 nm") << 10.7e-3 << 5e-9 << 3e-9 << 4e-9 << 2.6473 << 89.054;
        QTest::newRow("Table III, 3 nm") << 10.7e-3 << 5e-9 << 3e-9 << 3e-9 << 2.3298 << 87.577;
    }
    void convergedEndStates()
    {
        QFETCH(double, meniscusForce);
        QFETCH(double, takeOff);
        QFETCH(double, cutoff);
        QFETCH(double, staticHeight);
        QFETCH(double, flyingHeight);
        QFETCH(double, pitch);
        Case c;
        c.onoYamane.meniscusForce = meniscusForce;
        c.onoYamane.takeOff = takeOff;
        c.springs.cutoff = cutoff;
        c.springs.flyingHeight = staticHeight;
        const SpringModel model(c);
        int found = 0;
        for (const FoundEquilibrium& at : springEquilibria(model)) {
            const double d = model.guards(at.q)[SpringModel::Pad];
            if (std::abs(d * 1e9 - flyingHeight) > 1e-3 || (pitch != 0.0 && std::abs(at.q[1] * 1e6 - pitch) > 1e-2))
                continue;
            ++found;
            QCOMPARE(stabilityOf(eigenvaluesAt(model, at.q, at.mode)), Stability::Stable);
        }
        QCOMPARE(found, 1);
    }

    /// With d given the contact is known; the force balance falls with z at fixed d where both springs stiffen, and the
    /// moment balance of what remains is scanned: equations (2) and (3) written down once more, and bisection alone.
    void agreesWithAScan()
    {
        const Case c;
        const double z0 = c.springs.flyingHeight + c.springs.padDistance * c.springs.pitch;
        const double df = c.springs.frontDistance, dr = c.springs.rearDistance, dh = c.springs.padDistance;
        const auto spring = [](double k0, double s0, double s) { return k0 * s0 * s0 / (s * s) * (s0 - s); };
        const auto balance = [&](double d, double theta, bool moment) {
            const double z = d + dh * theta;
            const double ff = spring(c.springs.frontStiffness, z0 + df * c.springs.pitch, z + df * theta);
            const double fr = spring(c.springs.rearStiffness, z0 - dr * c.springs.pitch, z - dr * theta);
            const double real = std::max(0.0, c.onoYamane.initialContactForce +
                                                  c.onoYamane.contactStiffness * (c.onoYamane.touchDown - d));
            const double contact = real - c.onoYamane.meniscusForce;
            if (!moment) return ff + fr + contact - c.suspension.stiffness * (z - z0);
            return df * ff - dr * fr - dh * contact - 0.5 * c.slider.thickness * c.onoYamane.friction * real -
                   c.suspension.pitchStiffness * (theta - c.springs.pitch);
        };
        const auto root = [](auto&& f, double low, double high) {
            const bool rising = f(high) > 0.0;
            for (int i = 0; i < 200; ++i) {
                const double middle = 0.5 * (low + high);
                ((f(middle) > 0.0) == rising ? high : low) = middle;
            }
            return 0.5 * (low + high);
        };
        // theta of the force balance at each d, then the sign changes of the moment between 3 and 5 nm.
        const auto pitchAt = [&](double d) {
            return root([&](double theta) { return balance(d, theta, false); }, 40e-6, 140e-6);
        };
        std::vector<double> roots;
        const auto moment = [&](double d) { return balance(d, pitchAt(d), true); };
        for (double d = 3.0005e-9; d < 5e-9; d += 1e-11)
            if ((moment(d) > 0.0) != (moment(d + 1e-11) > 0.0)) roots.push_back(root(moment, d, d + 1e-11));

        const SpringModel model(c);
        std::vector<double> held, heldPitch;
        for (const FoundEquilibrium& at : springEquilibria(model)) {
            if (at.mode.contact != ContactRegion::Lifting && at.mode.contact != ContactRegion::Bridged) continue;
            held.push_back(model.guards(at.q)[SpringModel::Pad]);
            heldPitch.push_back(at.q[1]);
        }
        QCOMPARE(held.size(), roots.size());
        QCOMPARE(held.size(), std::size_t(1));
        QVERIFY2(std::abs(held[0] - roots[0]) < 1e-18, qPrintable(QString::number(held[0] - roots[0])));
        QVERIFY(std::abs(heldPitch[0] - pitchAt(roots[0])) < 1e-14);
    }

    void eigenvaluesFollowDifferences()
    {
        const SpringModel model{Case{}};
        const Mode mode{true, true, ContactRegion::Pressed};
        const Eigen::Vector2d q(60e-9, 95e-6);
        Eigen::Matrix4d a;
        const SpringModel::State scale = model.scale();
        for (int k = 0; k < 4; ++k) {
            SpringModel::State step = SpringModel::State::Zero();
            step[k] = 1e-5 * scale[k];
            const SpringModel::State y(q[0], q[1], 0.0, 0.0);
            a.col(k) = (model.derivative(y + step, mode) - model.derivative(y - step, mode)) / (2e-5 * scale[k]);
        }
        const double rate = scale[2] / scale[0];
        const Eigen::Matrix4d scaled = scale.cwiseInverse().asDiagonal() * a * scale.asDiagonal() / rate;
        const Eigen::Vector4cd expected = Eigen::EigenSolver<Eigen::Matrix4d>(scaled).eigenvalues() * rate;
        // Central differences err by (1e-5)^2 of the third derivative and by rounding over 1e-5.
        for (const std::complex<double>& value : eigenvaluesAt(model, q, mode)) {
            double nearest = 1e300;
            for (int k = 0; k < 4; ++k) nearest = std::min(nearest, std::abs(value - expected[k]));
            QVERIFY2(nearest < 1e-8 * std::abs(value), qPrintable(QString::number(nearest / std::abs(value))));
        }
    }

    /// Held by menisci whose pull f_m (d_e - z)/(d_e - d_s) falls with z, against the spring k z_0^2 (z_0 - z)/z^2,
    /// both balance on a branch whose f_m is largest where
    ///     2 z^2 - (3 z_0 + d_e) z + 2 z_0 d_e = 0,   z = (26 - sqrt(116))/4 nm for z_0 = 7 nm, d_e = 5 nm.
    void findsTheFoldOfMenisci()
    {
        const Case c = oneSpring();
        const double z = (26.0 - std::sqrt(116.0)) / 4.0 * 1e-9;
        const double pull = 1e6 * 49e-18 * (7e-9 - z) / (z * z) * (5e-9 - 2e-9) / (5e-9 - z);
        const CaseAt at = byParameter(c, "ono_yamane.meniscus_force");
        const EquilibriumBranches all = traceSpringEquilibria(at, 0.2 * pull, 1.7 * pull, 9);
        QCOMPARE(all.endsLost, 0);
        int folds = 0;
        for (const MarkedEquilibrium& mark : all.marks) {
            if (mark.kind != EquilibriumMark::Fold) continue;
            ++folds;
            // Across p a fold is flat: its place is known to the root of the solver's accuracy.
            QVERIFY2(std::abs(mark.at.spacing - z) < 1e-15, qPrintable(QString::number(mark.at.spacing - z)));
            QVERIFY(std::abs(mark.at.parameter - pull) < 1e-12 * pull);
        }
        QCOMPARE(folds, 1);
        // The branch beyond the fold is the unstable one.
        for (const EquilibriumBranch& branch : all.branches)
            for (const Equilibrium& point : branch.points) {
                if (branch.contact == ContactRegion::Apart || std::abs(point.spacing - z) < 1e-12) continue;
                const bool stiffer =
                    1e6 * 49e-18 * (14e-9 - point.spacing) / std::pow(point.spacing, 3) > point.parameter / 3e-9;
                QCOMPARE(point.stability == Stability::Stable, stiffer);
                if (!stiffer) QCOMPARE(point.stability, Stability::Divergence);
            }
    }

    /// A pad ahead of the mass centre, d_h < 0, on nothing but suspension and contact stiffness: with e = d_h + b mu/2
    ///     K_zz = k + k_c, K_zt = -k_c d_h, K_tz = -k_c e, K_tt = k_t + k_c d_h e,
    /// and s^4 + a1 s^3 + a2 s^2 + a3 s + a4 has a pair on the axis where a1 a2 a3 = a3^2 + a1^2 a4 (Hurwitz).
    void findsTheOnsetOfFlutter()
    {
        Case c;
        c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
        c.springs.flyingHeight = 1e-9;
        c.springs.pitch = 0.0;
        c.slider.thickness = 1e-3;
        c.suspension = {.stiffness = 1e6, .pitchStiffness = 0.9, .dampingRatio = 0.01, .pitchDampingRatio = 0.01};
        c.springs.padDistance = -0.3e-3;
        c.onoYamane.meniscusForce = 0.0;
        const auto hurwitz = [&](double mu) {
            const double M = c.slider.mass, J = c.slider.pitchInertia, kc = c.onoYamane.contactStiffness,
                         dh = c.springs.padDistance;
            const double e = dh + 0.5 * c.slider.thickness * mu;
            const double cz = 2 * 0.01 * std::sqrt(1e6 / M), ct = 2 * 0.01 * std::sqrt(0.9 / J); // per mass and inertia
            const double zz = (1e6 + kc) / M, zt = -kc * dh / M, tz = -kc * e / J, tt = (0.9 + kc * dh * e) / J;
            const double a1 = cz + ct, a2 = zz + tt + cz * ct, a3 = cz * tt + ct * zz, a4 = zz * tt - zt * tz;
            return a1 * a2 * a3 - a3 * a3 - a1 * a1 * a4;
        };
        double low = 0.5, high = 0.7;
        QVERIFY(hurwitz(low) > 0.0 && hurwitz(high) < 0.0);
        for (int i = 0; i < 100; ++i) (hurwitz(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);

        const EquilibriumBranches all = traceSpringEquilibria(byParameter(c, "ono_yamane.friction"), 0.5, 0.7, 9);
        std::vector<double> onsets;
        for (const MarkedEquilibrium& mark : all.marks)
            if (mark.kind == EquilibriumMark::Hopf) onsets.push_back(mark.at.parameter);
        QVERIFY2(!onsets.empty(), "no Hopf point");
        const double nearest = *std::ranges::min_element(onsets, {}, [&](double mu) { return std::abs(mu - low); });
        QVERIFY2(std::abs(nearest - low) < 1e-9, qPrintable(QString::number(nearest - low)));
        bool flutters = false;
        for (const EquilibriumBranch& branch : all.branches)
            for (const Equilibrium& point : branch.points) {
                if (std::abs(point.parameter - low) < 1e-6 || branch.contact == ContactRegion::Apart) continue;
                flutters = flutters || point.stability == Stability::Flutter;
                if (point.parameter < low) QCOMPARE(point.stability, Stability::Stable);
            }
        QVERIFY(flutters);
    }

    void piecesEndWhereTheLawSwitches()
    {
        // The default slider, set lower and lower: it touches down where its static height is d_s; caught, it takes off
        // where the pad has risen to d_e.
        const Case c;
        const EquilibriumBranches all = traceSpringEquilibria(byParameter(c, "springs.flying_height"), 14e-9, 1e-9, 9);
        const auto mark = [&](const char* title) {
            return std::ranges::find_if(all.marks, [&](const MarkedEquilibrium& m) { return m.name == title; });
        };
        QVERIFY(mark("touch-down") != all.marks.end());
        QVERIFY(std::abs(mark("touch-down")->at.parameter - 3e-9) < 1e-18);
        QVERIFY(mark("take-off") != all.marks.end());
        QVERIFY(std::abs(mark("take-off")->at.spacing - 5e-9) < 1e-18);
        QVERIFY(mark("take-off")->at.parameter > 7e-9);
        QCOMPARE(mark("take-off")->kind, EquilibriumMark::Switch);
    }

    void withoutDampingNothingIsCalledAHopfPoint()
    {
        Case c;
        c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.0;
        c.suspension.dampingRatio = c.suspension.pitchDampingRatio = 0.0;
        const EquilibriumBranches all =
            traceSpringEquilibria(byParameter(c, "ono_yamane.meniscus_force"), 0.0, 50e-3, 5);
        for (const MarkedEquilibrium& mark : all.marks) QVERIFY(mark.kind != EquilibriumMark::Hopf);
        for (const EquilibriumBranch& branch : all.branches)
            for (const Equilibrium& point : branch.points) QCOMPARE(point.stability, Stability::Neutral);
    }

    void stopsWhenAsked()
    {
        int asked = 0;
        const EquilibriumBranches all = traceSpringEquilibria(byParameter(Case{}, "springs.flying_height"), 14e-9, 1e-9,
                                                              9, [&](double) { return ++asked < 20; });
        QVERIFY(all.stopped);
        QCOMPARE(asked, 20);
    }
};

TOUCHDOWN_TEST(TestSpringEquilibria)

} // namespace test_spring_equilibria

#include "test_spring_equilibria.moc"
