// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/static_check.h"

#include <QtTest>

#include "core/case/case.h"
#include "core/case/contact_kind.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_static_check {

struct Checked {
    QString refusal, note;
};
Checked check(const Case& c)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const MinimumSpacing spacing(c.surface, recess);
    return {QString::fromStdString(whyNoStaticState(c, spacing)), QString::fromStdString(noteOnClosedGap(c, spacing))};
}

/// A plane of 1 mm x 0.8 mm: the trailing edge is lowest, at the height itself.
Case plane(double height)
{
    Case c = test::smallSlider(33);
    c.surface = {};
    c.surface.baseRecess = 0.0;
    c.steady.fixedAttitude = true;
    c.initial.nominalTrailingEdgeHeight = height;
    c.initial.pitch = 100e-6;
    return c;
}

class TestStaticCheck : public QObject {
    Q_OBJECT

private slots:
    void railsInsideTheDisk()
    {
        QCOMPARE(check(plane(1e-12)).refusal, QString());
        QVERIFY(check(plane(0.0)).refusal.contains("at its mean plane"));
        const QString why = check(plane(-20e-9)).refusal;
        for (const char* part : {"inside the disk", "20 nm below", "x = 1 mm", "trailing edge height -20 nm",
                                 "pitch 100 urad", "roll 0 urad", "above 0 nm"})
            QVERIFY2(why.contains(part), qPrintable(why + " lacks " + part));
        QCOMPARE(why.count('.'), 1); // one sentence: the point is that of the parameter's name
    }
    void aContactLawMayCarryThem()
    {
        for (const ContactKind kind : {ContactKind::OnoYamane, ContactKind::Elastic}) {
            Case c = plane(-2e-9);
            c.contact = kind;
            QCOMPARE(check(c).refusal, QString());
            QVERIFY(check(c).note.contains("2 nm below"));
            c.initial.nominalTrailingEdgeHeight = 2e-9;
            QCOMPARE(check(c).note, QString());
        }
    }
    void aSearchMayStartInside()
    {
        Case c = plane(-20e-9);
        c.steady.fixedAttitude = false;
        QCOMPARE(check(c).refusal, QString());
        QCOMPARE(check(c).note, QString());
    }
    void aDiskAtRest()
    {
        Case c = plane(20e-9);
        c.disk.speed = 0.0;
        QCOMPARE(check(c).refusal, QString()); // the film is at ambient pressure
        c.steady.fixedAttitude = false;
        const QString why = check(c).refusal;
        QVERIFY2(why.contains("disk at rest") && why.contains("1 gf"), qPrintable(why));
        QVERIFY(!why.contains("contact"));
        c.disk.speed = 1e-3;
        QCOMPARE(check(c).refusal, QString());
    }
    void withoutLoadEveryHeightIsAStaticState()
    {
        Case c = plane(300e-9);
        c.steady.fixedAttitude = false;
        c.disk.speed = 0.0;
        QVERIFY(!unloadedRest(c)); // a preload
        c.suspension.preload = 0.0;
        c.degreesOfFreedom = 3;
        QVERIFY(unloadedRest(c));
        QCOMPARE(unloadedRest(c)->height, 300e-9);
        QCOMPARE(unloadedRest(c)->pitch, 100e-6);
        c.suspension.rollTorque = 1e-9;
        QVERIFY(!unloadedRest(c));
        c.degreesOfFreedom = 2; // what holds the roll carries it
        QVERIFY(unloadedRest(c));
        c.suspension.pitchTorque = 1e-9;
        QVERIFY(!unloadedRest(c));
        c.suspension.holdsAttitude = true; // torques come from the static attitude instead
        c.suspension.staticPitch = 50e-6;
        QCOMPARE(unloadedRest(c)->pitch, 50e-6);
        c.disk.speed = 1e-3;
        QVERIFY(!unloadedRest(c));
    }
    /// A pressure torque of -4.2 uN m, a shear torque of 0.1 uN m and a load of 10 mN that acts 3.2 um outside of the
    /// centre line, +0.032 uN m, leave -4.068 uN m: as a film of 10 mN that acts 407 um beside it.
    void aRollThatIsHeld()
    {
        Case c = test::smallSlider(33);
        c.suspension.preload = 10e-3;
        c.suspension.offsetY = 3.2e-6;
        SteadyResult state;
        state.forces.net = 10e-3;
        state.forces.rollTorque = -4.2e-6;
        state.shearRollTorque = 0.1e-6;
        QCOMPARE(noteOnHeldRoll(c, state), std::string()); // it is balanced
        c.degreesOfFreedom = 2;
        const QString note = QString::fromStdString(noteOnHeldRoll(c, state));
        QVERIFY2(note.contains("-4.068 uN m") && note.contains("407 um"), qPrintable(note));
        c.suspension.rollTorque = 4.068e-6; // which balances it
        QCOMPARE(noteOnHeldRoll(c, state), std::string());
        c.suspension.rollTorque = 0.0;
        c.steady.fixedAttitude = true; // nothing is balanced, as was asked
        QCOMPARE(noteOnHeldRoll(c, state), std::string());
    }
    /// The torque that is said is the one that keeps the slider level: with it the third degree of freedom changes
    /// nothing. On a slider with a mirror line and straight flow nothing is left.
    void theTorqueOfAHeldRoll()
    {
        Case c = test::smallSlider(33);
        c.degreesOfFreedom = 2;
        const SteadyResult held = steady(c);
        QVERIFY(held.message.find("roll torque") != std::string::npos);
        c.suspension.rollTorque = -held.forces.rollTorque - held.shearRollTorque;
        QCOMPARE(steady(c).message, std::string());
        c.degreesOfFreedom = 3;
        const SteadyResult free = steady(c);
        QCOMPARE(free.status, SteadyStatus::Converged);
        QVERIFY2(std::abs(free.attitude.roll) < 1e-9, qPrintable(QString::number(free.attitude.roll)));
        QVERIFY(std::abs(free.attitude.height - held.attitude.height) < 1e-13);

        Case symmetric = test::smallSlider(33);
        symmetric.degreesOfFreedom = 2;
        symmetric.disk.skew = 0.0;
        symmetric.disk.field = VelocityField::Uniform;
        QCOMPARE(QString::fromStdString(steady(symmetric).message), QString());
    }
    void theLastStateInWords()
    {
        SteadyResult state;
        state.attitude = {4.5e-9, 36e-6, -6e-6};
        state.minimumSpacing = 0.158e-9;
        state.forces.net = 12.5 * 9.80665e-3;
        const QString words = QString::fromStdString(lastStateWords(test::smallSlider(33), state));
        QCOMPARE(words, "the last attitude with rails above the disk was: trailing edge height 4.5 nm, pitch 36 urad, "
                        "roll -6 urad, minimum "
                        "spacing 0.158 nm, net force of the film 12.5 gf for a preload of 1 gf");
    }
};

TOUCHDOWN_TEST(TestStaticCheck)

} // namespace test_static_check

#include "test_static_check.moc"
