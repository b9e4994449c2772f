// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/contact_rest.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/case_key.h"
#include "core/case/contact_kind.h"
#include "core/simulation/run.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_near.h"
#include "tests/simulation/run_trace.h"
#include "tests/support/sample_case.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_rest {

const std::function<bool()> always = [] { return true; };

/// A small slider that its preload presses below its flying height, onto a pad of asperities or menisci.
Case pressed(ContactKind contact)
{
    Case c = test::smallSlider(33);
    c.film.grid = GridKind::Graded;
    c.contact = contact;
    c.onoYamane = {.meniscusForce = 2e-3,
                   .contactStiffness = 3e6,
                   .initialContactForce = 3e-3,
                   .touchDown = 12e-9,
                   .takeOff = 14e-9,
                   .friction = 0.3};
    c.asperity = {.radius = 2e-6, .density = 8e12, .heightDeviation = 0.8e-9, .planeHeight = 11e-9, .friction = 0.3};
    c.meniscus = {.surfaceTension = 0.02, .filmThickness = 1e-9, .breakingLength = 2e-9};
    c.pad.length = c.pad.width = 15e-6;
    c.elastic.friction = 0.3;
    c.elastic.cell = 2e-6;
    c.run.fieldSnapshots = 0;
    return c;
}

/// The sample whose film alone leaves the pad 5 nm inside the disk.
Case pressedPad()
{
    Case c = sample("film_fig2_pressed_pad");
    c.film.nodes = {65, 65};
    c.steady.loadTolerance = 1e-8;
    c.elastic.tolerance = 1e-10; // a run solves contacts 1e4 times as loosely
    c.run.fieldSnapshots = 0;
    return c;
}

/// The run that begins in the state.
Summary runFrom(const Case& c, const SteadyResult& state, double duration)
{
    Case there = c;
    there.initial.state = InitialState::Static;
    there.initial.branch = state.contact.branch;
    there.run.duration = duration;
    there.run.sampleInterval = 0.1e-6;
    return run(there, {});
}

class TestContactRest : public QObject {
    Q_OBJECT

private slots:
    void forcesBalance_data()
    {
        QTest::addColumn<int>("contact");
        QTest::newRow("ono-yamane") << int(ContactKind::OnoYamane);
        QTest::newRow("asperity") << int(ContactKind::Asperity);
        QTest::newRow("multi-asperity") << int(ContactKind::MultiAsperity);
        QTest::newRow("elastic") << int(ContactKind::Elastic);
    }
    /// Film, contact and preload, to the tolerance; and the run stays there.
    void forcesBalance()
    {
        QFETCH(int, contact);
        const Case c = contact == int(ContactKind::Elastic) ? pressedPad() : pressed(static_cast<ContactKind>(contact));
        const SteadyResult state = steadyWithContact(c);
        QCOMPARE(state.status, SteadyStatus::Converged);
        QVERIFY2(state.contact.contact > 1e-4, qPrintable(QString::number(state.contact.contact)));
        const double carried = state.forces.net + state.contact.contact + state.contact.adhesion;
        QVERIFY2(std::abs(carried - c.suspension.preload) < 1e-5 * c.suspension.preload,
                 qPrintable(QString::number(carried / c.suspension.preload)));
        QVERIFY(state.contact.friction > 0.29 * state.contact.contact);
        const Summary end = runFrom(c, state, contact == int(ContactKind::Elastic) ? 1e-6 : 20e-6);
        QVERIFY2(std::abs(test::finalValue(end, "minimum_spacing") - state.minimumSpacing) < 2e-12,
                 qPrintable(QString::number(test::finalValue(end, "minimum_spacing") - state.minimumSpacing)));
        QVERIFY(std::abs(test::finalValue(end, "pitch") - state.attitude.pitch) < 2e-3 * state.attitude.pitch);
    }

    /// Far above its contact a slider flies as without one.
    void fliesWhereItIsOutOfReach()
    {
        Case c = pressed(ContactKind::Asperity);
        c.asperity.planeHeight = -10e-9;
        const SteadyResult state = steadyWithContact(c), alone = steady(c);
        QCOMPARE(QString::fromStdString(state.contact.state), QStringLiteral("flying"));
        QCOMPARE(state.minimumSpacing, alone.minimumSpacing);
        QCOMPARE(state.contact.contact, 0.0);
        QVERIFY(state.contactStates.empty());
    }

    /// Menisci that hold a slider which also flies: both states are named, and initial.branch chooses.
    void namesBothStates()
    {
        Case c = pressed(ContactKind::OnoYamane);
        c.degreesOfFreedom = 2; // with roll, menisci at the nearest corner pull it ever nearer
        c.onoYamane = {.meniscusForce = 6e-3,
                       .contactStiffness = 5e6,
                       .initialContactForce = 1e-3,
                       .touchDown = 5e-9,
                       .takeOff = 20e-9,
                       .friction = 0.3};
        const SteadyResult flying = steadyWithContact(c);
        QCOMPARE(QString::fromStdString(flying.contact.state), QStringLiteral("flying"));
        QVERIFY(!flying.contactStates.empty());
        const auto stable =
            std::ranges::find_if(flying.contactStates, [](const RestingState& s) { return !s.contact.diverges; });
        QVERIFY(stable != flying.contactStates.end());
        c.initial.branch = ContactBranch::TakeOff;
        const SteadyResult held = steadyWithContact(c);
        QVERIFY(std::abs(held.minimumSpacing - stable->minimumSpacing) < 1e-13);
        QVERIFY(
            std::ranges::any_of(held.contactStates, [](const RestingState& s) { return s.contact.state == "flying"; }));
    }

    /// Motions about a state in contact ring as the run does: the period between maxima of the pitch.
    void modesRingAsTheRunDoes()
    {
        Case c = pressed(ContactKind::Asperity);
        const ModesResult found = modes(c);
        QCOMPARE(found.status, SteadyStatus::Converged);
        QVERIFY(found.steady.contact.acts());
        const AirBearingMode& fastest = found.modes.back();
        // Started along the mode's shape, so small that the contact stays linear.
        Case ring = c;
        const double reach = 2e-12; // at the corners [m]
        ring.initial.state = InitialState::Given;
        ring.initial.nominalTrailingEdgeHeight =
            found.steady.attitude.height + reach * (fastest.shape[0][0] - 0.5 * c.slider.length * fastest.shape[1][0]);
        ring.initial.pitch = found.steady.attitude.pitch + reach * fastest.shape[1][0];
        ring.initial.roll = found.steady.attitude.roll + reach * fastest.shape[2][0];
        ring.run.duration = 12.0 / fastest.frequency;
        ring.run.sampleInterval = 0.02 / fastest.frequency;
        ring.run.stepError = 1e-15;
        std::vector<double> crossings;
        double lastTime = 0.0, last = 0.0;
        const auto column = static_cast<std::size_t>(findQuantity(recordedQuantities(ring), "minimum_spacing"));
        run(ring, [&](const RunUpdate& update) {
            for (std::size_t i = 0; i < update.samples.size(); ++i) {
                const double time = update.samples.time[i];
                const double value = update.samples.columns[column][i] - found.steady.minimumSpacing;
                if (last < 0.0 && value >= 0.0) crossings.push_back(std::lerp(lastTime, time, last / (last - value)));
                last = value;
                lastTime = time;
            }
            return true;
        });
        QVERIFY(crossings.size() > 5);
        const double period = (crossings[5] - crossings[1]) / 4.0;
        QVERIFY2(std::abs(period * fastest.frequency - 1.0) < 0.02,
                 qPrintable(QString("%1 %2").arg(1.0 / period).arg(fastest.frequency)));
    }

    void sensitivitiesAreDifferences_data()
    {
        QTest::addColumn<int>("contact");
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("step");
        QTest::newRow("preload, ono-yamane") << int(ContactKind::OnoYamane) << "suspension.preload" << 1e-6;
        QTest::newRow("menisci, ono-yamane") << int(ContactKind::OnoYamane) << "ono_yamane.meniscus_force" << 1e-6;
        QTest::newRow("friction, ono-yamane") << int(ContactKind::OnoYamane) << "ono_yamane.friction" << 1e-4;
        QTest::newRow("summits, asperity") << int(ContactKind::Asperity) << "asperity.plane_height" << 1e-12;
        QTest::newRow("friction, asperity") << int(ContactKind::Asperity) << "asperity.friction" << 1e-4;
        QTest::newRow("rail, asperity") << int(ContactKind::Asperity) << "abs.rail[2].recess" << 1e-12;
        QTest::newRow("speed, asperity") << int(ContactKind::Asperity) << "disk.speed" << 1e-2;
    }
    /// Of states on the same grid. Second order in steps of some 1e-4 of what changes; the states are found to 1e-9 of
    /// the load, over changes of some 1e-4 of it.
    void sensitivitiesAreDifferences()
    {
        QFETCH(int, contact);
        QFETCH(QString, key);
        QFETCH(double, step);
        Case c = pressed(static_cast<ContactKind>(contact));
        c.degreesOfFreedom = 2;
        c.steady.sensitivities = true;
        c.steady.loadTolerance = 1e-11;
        c.film.tolerance = 1e-12;
        const SteadyResult state = steadyWithContact(c);
        QVERIFY(state.contact.acts());
        const auto found = std::ranges::find(state.sensitivities, key.toStdString(), &Sensitivity::parameter);
        QVERIFY(found != state.sensitivities.end());
        double spacing[2], pitch[2];
        for (const int side : {0, 1}) {
            Case moved = c;
            auto parameter = std::get<Parameter>(numberKey(c, key.toStdString()));
            parameter.set(moved, std::get<double>(parameter.get(c)) + (side == 0 ? step : -step));
            const SteadyResult there = steadyNear(moved, c, state);
            QCOMPARE(there.status, SteadyStatus::Converged);
            spacing[side] = there.minimumSpacing;
            pitch[side] = there.attitude.pitch;
        }
        const double bySpacing = (spacing[0] - spacing[1]) / (2.0 * step),
                     byPitch = (pitch[0] - pitch[1]) / (2.0 * step);
        const double size = std::abs(bySpacing) + c.slider.length * std::abs(byPitch);
        QVERIFY2(std::abs(bySpacing - found->minimumSpacing) < 2e-5 * size &&
                     c.slider.length * std::abs(byPitch - found->pitch) < 2e-5 * size,
                 qPrintable(
                     QString("%1 %2, %3 %4").arg(bySpacing).arg(found->minimumSpacing).arg(byPitch).arg(found->pitch)));
    }

    /// A slider is listed once, and what it cannot touch has no name.
    void fliesOnce()
    {
        Case c = pressed(ContactKind::Elastic);
        const SteadyResult state = steadyWithContact(c);
        QCOMPARE(QString::fromStdString(state.contact.state), QStringLiteral("flying"));
        QVERIFY(state.contactStates.empty());
        c.contact = ContactKind::Asperity;
        c.asperity.planeHeight = -20e-9;
        c.adhesion.voltage = 0.2;
        const SteadyResult attracted = steadyWithContact(c);
        QCOMPARE(QString::fromStdString(attracted.contact.state), QStringLiteral("flying, attracted"));
        QVERIFY(attracted.minimumSpacing < state.minimumSpacing);
        QVERIFY(!std::isnan(attracted.discretisationError.minimumSpacing));
    }

    /// A run of "static" begins in the state, whichever it is.
    void runBeginsInTheState()
    {
        for (const ContactKind contact : {ContactKind::OnoYamane, ContactKind::Asperity}) {
            Case c = pressed(contact);
            c.initial.state = InitialState::Static;
            c.initial.branch = ContactBranch::TakeOff;
            c.run.duration = 10e-6;
            c.run.sampleInterval = 0.1e-6;
            const SteadyResult state = steadyWithContact(c);
            const long long before = staticSolutions();
            const Summary summary = run(c);
            QCOMPARE(staticSolutions() - before, 1LL);
            QCOMPARE(summary.status, RunStatus::Completed);
            for (const auto& [quantity, extremes] : summary.extremes)
                if (quantity == "minimum_spacing")
                    QVERIFY2(extremes.most - extremes.least < 2e-12 &&
                                 std::abs(extremes.least - state.minimumSpacing) < 2e-12,
                             qPrintable(QString("%1 %2").arg(extremes.most - extremes.least).arg(extremes.least)));
        }
    }

    /// Pressed down beside the only part of the slider that can touch.
    void saysWhereNoContactIsModelled()
    {
        Case c = pressedPad();
        c.suspension.preload = 0.03;
        c.elastic.cell = 4e-6;
        c.elastic.patchPitch = -400e-6;
        c.elastic.patchReach = 1e-9;
        const SteadyResult state = steadyWithContact(c);
        QVERIFY(state.status != SteadyStatus::Converged);
        QCOMPARE(QString::fromStdString(state.contact.state), QStringLiteral("not found"));
        QVERIFY2(state.message.find("; the slider came down to -5.") != std::string::npos &&
                     state.message.find("elastic.patch_pitch") != std::string::npos,
                 state.message.c_str());
    }

    void stopsWhenAsked()
    {
        int left = 40;
        const SteadyResult state =
            steadyWithContact(pressed(ContactKind::Asperity), [&](const SteadyProgress&) { return left-- > 0; });
        QCOMPARE(state.status, SteadyStatus::Cancelled);
    }
};

TOUCHDOWN_TEST(TestContactRest)

} // namespace test_contact_rest

#include "test_contact_rest.moc"
