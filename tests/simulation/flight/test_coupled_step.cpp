// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/coupled_step.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/contact/pad_contact.h"
#include "tests/support/allocation_count.h"
#include "tests/support/flying_slider.h"
#include "tests/support/mass_on_a_spring.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_coupled_step {

class TestCoupledStep : public QObject {
    Q_OBJECT

private slots:
    void order_data()
    {
        QTest::addColumn<int>("coupling");
        QTest::newRow("monolithic") << int(FilmCoupling::Monolithic);
        QTest::newRow("staggered") << int(FilmCoupling::Staggered);
    }
    /// A pico slider let go 1 nm above its static state, for 4 us: a quarter of the slowest mode's period, about one of
    /// the fastest's. Results with halved steps differ by e, e/4, e/16.
    void order()
    {
        QFETCH(int, coupling);
        const int steps = 400;
        Vector3 last = Vector3::Zero();
        double before = 0.0;
        for (int k = 0; k < 4; ++k) {
            FlyingSlider slider(pico(), picoAtRest(), tight(FilmCoupling(coupling)), {1e-9, 0.0, 0.0});
            QVERIFY(slider.takeAll(4e-6, steps << k));
            const double change = k > 0 ? slider.from(last) : 0.0;
            if (k > 1) {
                const double observed = std::log2(before / change);
                QVERIFY2(std::abs(observed - 2.0) < 0.15,
                         qPrintable(QString("order %1 with %2 steps").arg(observed).arg(steps << k)));
            }
            before = change;
            last = slider.q();
        }
    }
    /// Both go to the same motion: with steps h and h/2, e and e/4 from it, (4 q(h/2) - q(h))/3 is nearer still. The
    /// slider has gone 1 nm; what is left of either is of the third order, a hundredth of the last change.
    void bothWaysGoToTheSameMotion()
    {
        std::array<Vector3, 2> limits{Vector3::Zero(), Vector3::Zero()};
        double coarse = 0.0;
        for (const FilmCoupling coupling : {FilmCoupling::Monolithic, FilmCoupling::Staggered}) {
            Vector3& limit = limits[coupling == FilmCoupling::Staggered ? 1 : 0];
            for (const int steps : {200, 400}) {
                FlyingSlider slider(pico(), picoAtRest(), tight(coupling), {1e-9, 0.0, 0.0});
                QVERIFY(slider.takeAll(4e-6, steps));
                if (steps == 400) coarse = std::max(coarse, slider.from(limit));
                limit = steps == 200 ? slider.q() : Vector3((4.0 * slider.q() - limit) / 3.0);
            }
        }
        const SliderBody body(pico(), picoAtRest().attitude);
        const double apart = body.displacement(limits[0] - limits[1]);
        QVERIFY2(apart < 0.02 * coarse, qPrintable(QString("%1 of %2 m").arg(apart).arg(coarse)));
    }
    /// A force of a third of the preload sets in between steps.
    void orderAfterAJump()
    {
        Vector3 last = Vector3::Zero();
        double before = 0.0;
        for (int k = 0; k < 4; ++k) {
            SpringAndJump contact(0.0, 0.0, 5e-3);
            FlyingSlider slider(pico(), picoAtRest(), tight(FilmCoupling::Monolithic), {1e-9, 0.0, 0.0}, &contact);
            QVERIFY(slider.takeAll(2e-6, 400 << k));
            contact.cross(true);
            slider.stepper.restartAcceleration();
            QVERIFY(slider.takeAll(2e-6, 400 << k));
            const double change = k > 0 ? slider.from(last) : 0.0;
            if (k > 1) {
                const double observed = std::log2(before / change);
                QVERIFY2(std::abs(observed - 2.0) < 0.15,
                         qPrintable(QString("order %1 with %2 steps").arg(observed).arg(400 << k)));
            }
            before = change;
            last = slider.q();
        }
    }

    /// A contact that is in reach and hardly acts changes nothing: film and forecast stay fitted to the slider's rate.
    void contactKeepsTheFit()
    {
        SpringAndJump contact(1e-3, picoAtRest().attitude.height, 0.0);
        FlyingSlider alone(pico(), picoAtRest(), tight(FilmCoupling::Monolithic), {1e-9, 0.0, 0.0}),
            touching(pico(), picoAtRest(), tight(FilmCoupling::Monolithic), {1e-9, 0.0, 0.0}, &contact);
        QVERIFY(alone.takeAll(4e-6, 40) && touching.takeAll(4e-6, 40));
        QVERIFY(touching.stepper.contactInReach());
        QVERIFY2(touching.from(alone.q()) < 1e-15, qPrintable(QString::number(touching.from(alone.q()))));
    }
    /// beta k dt^2 < M, thus omega dt < 2, is where the staggered iteration ends; monolithic has no such limit.
    void staggeredEndsAtLongSteps()
    {
        const Case c = almostVacuum();
        const SteadyResult rest = filmAtAmbient(c);
        const double stiffness = 1e8, omega = std::sqrt(stiffness / c.slider.mass);
        for (const FilmCoupling coupling : {FilmCoupling::Monolithic, FilmCoupling::Staggered}) {
            SpringAndJump contact(stiffness, rest.attitude.height, 0.0);
            FlyingSlider slider(c, rest, byDefault(coupling), {1e-9, 0.0, 0.0}, &contact);
            const CoupledStepResult result = slider.stepper.step(2.2 / omega);
            QVERIFY(result.failure ==
                    (coupling == FilmCoupling::Monolithic ? CoupledFailure::None : CoupledFailure::Iteration));
            QVERIFY(slider.stepper.step(1.0 / omega).converged());
        }
    }
    /// The same on air, whose stiffness is about that of the fastest mode, 228 kHz: 2/omega = 1.4 us; steps a quarter
    /// longer.
    void staggeredEndsAtLongStepsOnAir()
    {
        for (const FilmCoupling coupling : {FilmCoupling::Monolithic, FilmCoupling::Staggered}) {
            FlyingSlider slider(pico(), picoAtRest(), byDefault(coupling), {1e-9, 0.0, 0.0});
            const CoupledStepResult result = slider.stepper.step(1.75e-6);
            QVERIFY(result.failure ==
                    (coupling == FilmCoupling::Monolithic ? CoupledFailure::None : CoupledFailure::Iteration));
            QVERIFY(slider.stepper.step(2e-7).converged());
        }
    }

    /// Asked for each attitude and, of the first step, within the film's three responses: whenever it says no, that was
    /// the last time.
    void stops()
    {
        int calls = 0, last = 1000000;
        CoupledStepOptions options = byDefault(FilmCoupling::Monolithic);
        options.goOn = [&] { return ++calls < last; };
        const auto tryStep = [&] {
            FlyingSlider slider(pico(), picoAtRest(), options, {1e-9, 0.0, 0.0});
            calls = 0;
            return slider.stepper.step(2e-8);
        };
        const CoupledStepResult whole = tryStep();
        QVERIFY(whole.converged());
        const int asked = calls;
        QVERIFY2(asked >= whole.iterations + 3, qPrintable(QString::number(asked)));
        for (last = 1; last <= asked; ++last) {
            QVERIFY(tryStep().failure == CoupledFailure::Stopped);
            QCOMPARE(calls, last);
        }
    }

    void triesAreAlike_data() { order_data(); }
    /// Another try of a step, of another length, forgets the one before; both end within their tolerances.
    void triesAreAlike()
    {
        QFETCH(int, coupling);
        const CoupledStepOptions options = tight(FilmCoupling(coupling));
        FlyingSlider once(pico(), picoAtRest(), options, {1e-9, 0.0, 0.0}),
            often(pico(), picoAtRest(), options, {1e-9, 0.0, 0.0});
        for (int n = 0; n < 6; ++n) {
            QVERIFY(often.stepper.step(3e-7).converged());
            QVERIFY(often.stepper.step(2e-8).converged());
            QVERIFY(often.take(1e-7).converged());
            QVERIFY(once.take(1e-7).converged());
            QVERIFY2(once.from(often.q()) < 1e-15, qPrintable(QString::number(once.from(often.q()))));
        }
    }
    void forcesBalance_data() { order_data(); }
    /// Staggered, a step of h leaves M/(beta h^2) = 4e9 N/m times its position's rest unbalanced: 1e-18 m are 3e-7 of
    /// the load, 15 mN. Monolithic ends with forces that know the last change. The acceleration is that of the forces,
    /// both ways.
    void forcesBalance()
    {
        QFETCH(int, coupling);
        CoupledStepOptions options = byDefault(FilmCoupling(coupling));
        options.tolerance = FilmCoupling(coupling) == FilmCoupling::Monolithic ? 5e-14 : 1e-18;
        FlyingSlider slider(pico(), picoAtRest(), options, {1e-9, 0.0, 0.0});
        for (int n = 0; n < 50; ++n) {
            const CoupledStepResult result = slider.take(4e-8);
            QVERIFY(result.converged());
            QVERIFY2(result.forceBalance < 1e-6, qPrintable(QString::number(result.forceBalance)));
            QVERIFY(result.positionLeft <= options.tolerance);
            slider.level.film.setAttitude(slider.body.attitude(slider.q()));
            const double load = slider.level.loads.load(slider.film.pressure())[0];
            const SliderMotion& m = slider.stepper.motion();
            const double missing = load + slider.body.suspension(m.q, m.v)[0] - slider.body.inertia()[0] * m.a[0];
            QVERIFY2(std::abs(missing) < 1e-6 * pico().suspension.preload, qPrintable(QString::number(missing)));
        }
    }
    /// A roll that is held stays to the last bit; the same slider free to roll does not.
    void rollThatIsHeldStays()
    {
        for (const int freedom : {2, 3}) {
            Case c = coarseFlight("film_femto"); // at a skew
            c.degreesOfFreedom = freedom;
            const SteadyResult rest = steady(c);
            FlyingSlider slider(c, rest, {}, {1e-9, 0.0, 0.0});
            QVERIFY(slider.takeAll(1e-6, 20));
            QCOMPARE(slider.q()[2] == rest.attitude.roll, freedom == 2);
            QCOMPARE(slider.stepper.motion().v[2] == 0.0, freedom == 2);
        }
    }
    void restStays()
    {
        FlyingSlider slider(pico(), picoAtRest(), {}, Vector3::Zero());
        const Vector3 rest = slider.q();
        QVERIFY(slider.takeAll(4e-6, 40));
        QVERIFY2(slider.from(rest) < 1e-13, qPrintable(QString::number(slider.from(rest))));
    }

    void doesNotAllocate_data() { order_data(); }
    void doesNotAllocate()
    {
        QFETCH(int, coupling);
        Case c = pico();
        c.onoYamane.touchDown = 9.5e-9;
        c.onoYamane.takeOff = 12e-9;
        const Recess recess(c.surface, c.slider.length, c.slider.width);
        const MinimumSpacing spacing(c.surface, recess);
        PadContact contact(c, std::make_unique<CharacteristicLaw>(c.onoYamane), spacing);
        FlyingSlider slider(c, picoAtRest(), byDefault(FilmCoupling(coupling)), {-1e-9, 0.0, 0.0}, &contact);
        QVERIFY(slider.takeAll(1e-7, 5));
        const long long before = allocations;
        for (int n = 0; n < 20; ++n) QVERIFY(slider.take(n < 10 ? 2e-8 : 5e-8).converged());
        QCOMPARE(allocations.load(), before);
        QVERIFY(slider.stepper.contactInReach());
        QVERIFY(slider.stepper.cost().contactSolves > 20);
    }
};

TOUCHDOWN_TEST(TestCoupledStep)

} // namespace test_coupled_step

#include "test_coupled_step.moc"
