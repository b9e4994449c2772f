// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/slider_body.h"

#include <cmath>

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_slider_body {

constexpr double length = 1.25e-3, width = 1.0e-3;
constexpr Attitude rest{12e-9, 150e-6, -3e-6};

/// Nothing is zero and nothing is equal to anything else.
Case unlike()
{
    Case c = defaultsOf(ModelKind::Film);
    c.slider = {.mass = 1.6e-6,
                .pitchInertia = 2.2e-13,
                .rollInertia = 1.45e-13,
                .length = length,
                .width = width,
                .thickness = 0.3e-3};
    c.suspension.stiffness = 18.0;
    c.suspension.pitchStiffness = 2e-5;
    c.suspension.rollStiffness = 3e-5;
    c.suspension.damping = 1e-3;
    c.suspension.pitchDamping = 2e-10;
    c.suspension.rollDamping = 4e-10;
    c.suspension.preload = 15e-3;
    c.suspension.offsetX = 20e-6;
    c.suspension.offsetY = -10e-6;
    c.suspension.pitchTorque = 5e-7;
    c.suspension.rollTorque = 1e-7;
    return c;
}

bool near(double value, double expected) { return std::abs(value - expected) <= 1e-12 * std::abs(expected); }

class TestSliderBody : public QObject {
    Q_OBJECT

private slots:
    /// The mass centre lies over the middle, half the length before the trailing edge: 12 nm + 150 urad 0.625 mm =
    /// 105.75 nm.
    void theMassCentreLiesOverTheMiddle()
    {
        const SliderBody body(unlike(), rest);
        const Vector3 q = body.coordinates(rest);
        QVERIFY(near(q[0], 105.75e-9));
        QCOMPARE(q[1], rest.pitch);
        QCOMPARE(q[2], rest.roll);
    }
    void attitudeAndCoordinatesThereAndBack()
    {
        const SliderBody body(unlike(), rest);
        for (const Attitude& a : {rest, Attitude{-2e-9, 300e-6, 40e-6}, Attitude{250e-9, -50e-6, 0.0}}) {
            const Attitude back = body.attitude(body.coordinates(a));
            QVERIFY(std::abs(back.height - a.height) < 1e-21); // rounding of 0.1 um
            QCOMPARE(back.pitch, a.pitch);
            QCOMPARE(back.roll, a.roll);
        }
    }
    /// The corners lie (L/2, W/2) from the middle: |z| + L/2 |pitch| + W/2 |roll| = 1 + 0.625 + 0.5 nm, whatever their
    /// signs.
    void cornersMove()
    {
        const SliderBody body(unlike(), rest);
        QVERIFY(near(body.displacement({1e-9, -1e-6, 1e-6}), 2.125e-9));
    }

    /// At rest the suspension exerts its load alone: the preload down, its torques f0 (offsets) and the static ones:
    /// 15 mN 20 um + 0.5 uN m = 0.8 uN m, -15 mN 10 um + 0.1 uN m = -0.05 uN m.
    void exertsItsLoadAtRest()
    {
        const SliderBody body(unlike(), rest);
        const Vector3 f = body.suspension(body.rest(), Vector3::Zero());
        QVERIFY(near(f[0], -15e-3));
        QVERIFY(near(f[1], 8e-7));
        QVERIFY(near(f[2], -5e-8));
    }
    /// The spring of 18 N/m, 2 nm above rest: 36 nN more; of 2e-5 N m/rad, 10 urad: 0.2 nN m; the dampers with v = 1
    /// mm/s and 1 rad/s: 1 uN and 0.2 nN m.
    void springsAndDampersResist()
    {
        const SliderBody body(unlike(), rest);
        const Vector3 atRest = body.suspension(body.rest(), Vector3::Zero());
        Vector3 q = body.rest();
        q[0] += 2e-9;
        q[1] += 10e-6;
        q[2] -= 1e-6;
        const Vector3 f = body.suspension(q, {1e-3, 1.0, -0.5});
        QVERIFY(std::abs(f[0] - atRest[0] - (-36e-9 - 1e-6)) < 1e-15);
        QVERIFY(std::abs(f[1] - atRest[1] - (-2e-10 - 2e-10)) < 1e-20);
        QVERIFY(std::abs(f[2] - atRest[2] - (3e-11 + 2e-10)) < 1e-20);
    }
    /// A suspension that holds the attitude turns the slider towards its static one wherever it rests, and knows no
    /// static torques: -2e-5 N m/rad (pitch - 100 urad), so 15 mN 20 um - 1 nN m at rest.
    void holdsAnAttitude()
    {
        Case c = unlike();
        c.suspension.holdsAttitude = true;
        c.suspension.staticPitch = 100e-6;
        c.suspension.staticRoll = 2e-6;
        const SliderBody body(c, rest), other(c, {20e-9, 120e-6, 5e-6});
        QVERIFY(near(body.suspension(body.rest(), Vector3::Zero())[1], 15e-3 * 20e-6 - 2e-5 * 50e-6));
        QVERIFY(near(body.suspension(body.rest(), Vector3::Zero())[2], -15e-3 * 10e-6 + 3e-5 * 5e-6));
        // The torque at an attitude does not depend on the place of rest.
        const Vector3 q = body.coordinates({15e-9, 90e-6, 8e-6});
        for (const std::size_t k : {std::size_t(1), std::size_t(2)})
            QVERIFY(std::abs(body.suspension(q, Vector3::Zero())[k] - other.suspension(q, Vector3::Zero())[k]) <
                    1e-12 * std::abs(body.load()[k]));
    }
    /// 1/2 (1.6e-6 (1 mm/s)^2 + 2.2e-13 (2 rad/s)^2 + 1.45e-13 (3 rad/s)^2) = 8e-13 + 4.4e-13 + 6.525e-13 J.
    void kineticEnergy() { QVERIFY(near(SliderBody(unlike(), rest).kineticEnergy({1e-3, 2.0, -3.0}), 1.8925e-12)); }
    /// The force is what the energy falls by along the way; quadratic, so central differences are exact but for
    /// rounding.
    void forceIsTheSlopeOfTheEnergy()
    {
        for (const bool holds : {false, true}) {
            Case c = unlike();
            c.suspension.holdsAttitude = holds;
            c.suspension.staticPitch = 80e-6;
            const SliderBody body(c, rest);
            QCOMPARE(body.suspensionEnergy(body.rest()), 0.0);
            Vector3 q = body.rest();
            q[0] += 40e-9;
            q[1] -= 30e-6;
            q[2] += 5e-6;
            const Vector3 f = body.suspension(q, Vector3::Zero()), steps{1e-8, 1e-5, 1e-5};
            for (std::size_t k = 0; k < 3; ++k) {
                Vector3 high = q, low = q;
                high[k] += steps[k];
                low[k] -= steps[k];
                const double slope = (body.suspensionEnergy(high) - body.suspensionEnergy(low)) / (2.0 * steps[k]);
                QVERIFY(std::abs(slope + f[k]) < 1e-9 * std::abs(f[k]));
            }
        }
    }
    /// Half the thickness, 0.15 mm, from the surface to the mass centre, unless the case says otherwise.
    void armOfTheShear()
    {
        Case c = unlike();
        QVERIFY(near(SliderBody(c, rest).shearArm(), 0.15e-3));
        c.steady.shearArm = 1.0;
        c.steady.torqueSign = -1.0;
        QVERIFY(near(SliderBody(c, rest).shearArm(), -0.3e-3));
    }
    void rollIsHeldWithTwoDegreesOfFreedom()
    {
        Case c = unlike();
        QVERIFY(!SliderBody(c, rest).holdsRoll());
        c.degreesOfFreedom = 2;
        QVERIFY(SliderBody(c, rest).holdsRoll());
    }
};

TOUCHDOWN_TEST(TestSliderBody)

} // namespace test_slider_body

#include "test_slider_body.moc"
