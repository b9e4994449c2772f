// SPDX-License-Identifier: GPL-3.0-or-later
//
// A coupled step of a mass on a spring against Newmark's exact discrete motion, and its energy.
#include <algorithm>
#include <cmath>

#include "core/simulation/flight/coupled_step.h"
#include "tests/support/mass_on_a_spring.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_coupled_step_springs {

/// A spring that pushes where the mass centre is below it.
class Wall final : public SliderContact {
public:
    Wall(double stiffness, double top) : stiffness_(stiffness), top_(top) {}
    const SliderContactForces& at(const Attitude& attitude, double) override
    {
        depth_ = std::max(0.0, top_ - attitude.height - 0.5 * SpringAndJump::length * attitude.pitch);
        forces_.contact = stiffness_ * depth_;
        return forces_;
    }
    Matrix3 stiffness() const override
    {
        Matrix3 result = Matrix3::Zero();
        if (depth_ > 0.0) result(0, 0) = stiffness_;
        return result;
    }
    bool outOfReach(const Attitude&) const override { return false; }
    void accept() override {}
    double energy() const { return 0.5 * stiffness_ * depth_ * depth_; }

private:
    double stiffness_, top_, depth_ = 0.0; // [N/m], [m], [m]
    SliderContactForces forces_;
};

class TestCoupledStepSprings : public QObject {
    Q_OBJECT

private slots:
    void massOnASpring_data()
    {
        QTest::addColumn<int>("coupling");
        QTest::addColumn<double>("w"); // omega dt
        QTest::addColumn<double>("beta");
        const int monolithic = int(FilmCoupling::Monolithic), staggered = int(FilmCoupling::Staggered);
        QTest::newRow("monolithic, short: Fox and Goodwin") << monolithic << 0.1 << 1.0 / 12;
        QTest::newRow("monolithic, near its end") << monolithic << 1.3 << 1.0 / 12;
        QTest::newRow("monolithic, long: trapezoidal") << monolithic << 1.6 << 0.25;
        QTest::newRow("monolithic, very long") << monolithic << 30.0 << 0.25;
        QTest::newRow("staggered, short: trapezoidal") << staggered << 0.1 << 0.25;
        QTest::newRow("staggered") << staggered << 0.8 << 0.25;
    }
    /// Newmark's exact discrete answer for M z'' = -k z - f0: about the equilibrium z_{n+1} + z_{n-1} = 2 cos(phi) z_n
    /// with cos(phi) = 1 - w^2/2/(1 + beta w^2), so that phi/w - 1 is w^4/480 for Fox and Goodwin, -w^2/12 for the
    /// trapezoidal rule.
    void massOnASpring()
    {
        QFETCH(int, coupling);
        QFETCH(double, w);
        QFETCH(double, beta);
        const Case c = almostVacuum();
        const SteadyResult rest = filmAtAmbient(c);
        const double stiffness = 1e8, omega = std::sqrt(stiffness / c.slider.mass), amplitude = 1e-9;
        const double middle = rest.attitude.height;
        SpringAndJump contact(stiffness, middle, 0.0);
        FlyingSlider slider(c, rest, tight(FilmCoupling(coupling)), {amplitude, 0.0, 0.0}, &contact);
        const double balanced = middle - c.suspension.preload / stiffness;
        const double twice = 2.0 - w * w / (1.0 + beta * w * w);
        QVERIFY(slider.take(w / omega).converged()); // the first step knows no stiffness yet
        double z2 = slider.q()[0] - balanced;
        QVERIFY(slider.take(w / omega).converged());
        double z1 = slider.q()[0] - balanced;
        for (int n = 0; n < 40; ++n) {
            QVERIFY(slider.take(w / omega).converged());
            const double z = slider.q()[0] - balanced;
            QVERIFY2(std::abs(z - (twice * z1 - z2)) < 1e-7 * amplitude,
                     qPrintable(QString("%1 instead of %2").arg(z / amplitude).arg((twice * z1 - z2) / amplitude)));
            z2 = z1;
            z1 = z;
        }
    }
    /// Fox and Goodwin's discrete motion of a uniform step has a velocity of 1 - w^4/288 times omega z, with u = v (1 -
    /// w^2/12): where lengths change the energy is off by twice the difference of two of these, and must not add up
    /// from change to change.
    void changingStepsKeepEnergy()
    {
        const Case c = almostVacuum();
        const SteadyResult rest = filmAtAmbient(c);
        const double stiffness = 1e8, omega = std::sqrt(stiffness / c.slider.mass);
        const double middle = rest.attitude.height, balanced = middle - c.suspension.preload / stiffness;
        SpringAndJump contact(stiffness, middle, 0.0);
        FlyingSlider slider(c, rest, tight(FilmCoupling::Monolithic), {1e-9, 0.0, 0.0}, &contact);
        const auto energy = [&] {
            const double z = slider.q()[0] - balanced, v = slider.stepper.motion().v[0];
            return 0.5 * stiffness * z * z + 0.5 * c.slider.mass * v * v;
        };
        const double first = energy();
        for (int n = 0; n < 1000; ++n) {
            QVERIFY(slider.take((n % 2 == 0 ? 0.6 : 0.3) / omega).converged());
            const double off = std::abs(energy() / first - 1.0);
            QVERIFY2(off < 4.0 * std::pow(0.6, 4) / 288, qPrintable(QString("%1 after %2 steps").arg(off).arg(n + 1)));
        }
    }
    /// The stiffness of a rough contact or of a film in a large motion is stated wrongly. Where lengths change by a
    /// fifth, u - v = w^2/12 omega z is taken from the accelerations: their fitted derivative, of x = w at x0 = 2 w, is
    /// wrong by 3/4 w^3, and the energy by up to 2 (1.44 - 1) w^2/12 times that, 8e-4 for w = 0.36. The stated
    /// stiffness, wrong by a factor of 4, would make that 3e-2.
    void changingStepsKeepEnergyDespiteAWrongStiffness()
    {
        const Case c = almostVacuum();
        const SteadyResult rest = filmAtAmbient(c);
        const double stiffness = 1e8, omega = std::sqrt(stiffness / c.slider.mass);
        const double middle = rest.attitude.height, balanced = middle - c.suspension.preload / stiffness;
        SpringAndJump contact(stiffness, middle, 0.0, 4.0);
        FlyingSlider slider(c, rest, tight(FilmCoupling::Monolithic), {1e-9, 0.0, 0.0}, &contact);
        const auto energy = [&] {
            const double z = slider.q()[0] - balanced, v = slider.stepper.motion().v[0];
            return 0.5 * stiffness * z * z + 0.5 * c.slider.mass * v * v;
        };
        double first = 0.0;
        for (int n = 0; n < 400; ++n) {
            QVERIFY(slider.take((n % 8 < 4 ? 0.36 : 0.3) / omega).converged());
            if (n == 8) first = energy();
            const double off = n > 8 ? std::abs(energy() / first - 1.0) : 0.0;
            QVERIFY2(off < 4e-3, qPrintable(QString("%1 after %2 steps").arg(off).arg(n + 1)));
        }
    }
    /// Falls on a wall in steps of omega dt = 2.2, too long for Fox and Goodwin's velocities, u = v (1 - w^2/12) at
    /// best, and chosen before the wall was met. The trapezoidal rule then loses and gains what a step's penetration
    /// stores: no more than there was.
    void stiffnessMetWithinAStep()
    {
        const Case c = almostVacuum();
        const SteadyResult rest = filmAtAmbient(c);
        const double stiffness = 1e8, omega = std::sqrt(stiffness / c.slider.mass), top = rest.attitude.height - 3e-9;
        Wall wall(stiffness, top);
        FlyingSlider slider(c, rest, tight(FilmCoupling::Monolithic), Vector3::Zero(), &wall);
        const double first = c.suspension.preload * (slider.q()[0] - top);
        bool touched = false;
        for (int n = 0; n < 60; ++n) {
            QVERIFY(slider.take(2.2 / omega).converged());
            const double v = slider.stepper.motion().v[0];
            const double energy =
                wall.energy() + 0.5 * c.slider.mass * v * v + c.suspension.preload * (slider.q()[0] - top);
            QVERIFY2(energy < 2.0 * first, qPrintable(QString("%1 after %2 steps").arg(energy / first).arg(n + 1)));
            touched = touched || wall.energy() > 0.0;
        }
        QVERIFY(touched);
    }
};

TOUCHDOWN_TEST(TestCoupledStepSprings)

} // namespace test_coupled_step_springs

#include "test_coupled_step_springs.moc"
