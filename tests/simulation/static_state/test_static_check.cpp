// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/static_check.h"

#include <QtTest>

#include "core/case/case.h"
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
        c.contact = ContactKind::OnoYamane;
        QVERIFY(check(c).refusal.contains("contact has a part in runs in time only"));
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
