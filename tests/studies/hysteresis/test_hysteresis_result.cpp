// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis_result.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/studies/hysteresis/hysteresis_report.h"
#include "tests/support/held_loop.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_hysteresis_result {

/// A branch from 0 to a value, the same at both ends.
EquilibriumBranch between(ContactRegion contact, Equilibrium at, double value)
{
    Equilibrium last = at;
    last.parameter = value;
    return {.contact = contact, .points = {at, last}};
}

class TestHysteresisResult : public QObject {
    Q_OBJECT

private slots:
    void transitions()
    {
        const std::vector<Transition> list = transitionsOf(loop());
        QCOMPARE(list.size(), std::size_t(2));
        QVERIFY(list[0].down && !list[0].back);
        QCOMPARE(list[0].middle(), 1.5e-3);
        QVERIFY(!list[1].down && list[1].back);
        QCOMPARE(list[1].middle(), 0.5e-3);
    }

    void failuresAreNoTransitions()
    {
        std::vector<HeldStep> steps = loop();
        steps[1].end.kind = EndKind::Failed;
        QCOMPARE(transitionsOf(steps).size(), std::size_t(1));
        // Nor is a value with one valid end a known one: of four values one has failed on the way there.
        QCOMPARE(loopOf(steps).known, std::size_t(3));
        QVERIFY(!loopOf(steps).whole);
    }

    /// The ways differ at 1 mN alone, by 3 nm: a triangle of 3 nm over 2 mN.
    void areaOfTheLoop()
    {
        const LoopOf found = loopOf(loop());
        QCOMPARE(found.values, std::vector{1e-3});
        QVERIFY(found.whole);
        QVERIFY(std::abs(found.area - 3e-12) < 1e-24);
    }

    void touchingIsOneStateWhetherItRingsOrNot()
    {
        std::vector<HeldStep> steps = loop();
        steps[2].end = {EndKind::Intermittent, 3.05e-9, 0.3e-9};
        QCOMPARE(loopOf(steps).values, std::vector{1e-3});
    }

    /// At 3 mN it bounces on the way there and rests in contact on the way back, at mean spacings that are alike.
    void bouncingIsAnotherStateThanContact()
    {
        std::vector<HeldStep> steps = loop();
        steps[3].end = {EndKind::Intermittent, 2.05e-9, 0.3e-9, Motion::Bounces};
        QVERIFY(!stillMoves(steps[3]));
        const LoopOf found = loopOf(steps);
        QCOMPARE(found.values, (std::vector{1e-3, 3e-3}));
        QCOMPARE(found.moving, std::size_t(0));
        HysteresisResult result;
        result.steps = steps;
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(!says(findings, "No hysteresis"));
        QVERIFY(says(findings,
                     "At 3 mN the slider bounces about 2.05 nm +- 0.3 nm on the way there and ends in contact "
                     "at 2 nm on the way back"));
    }

    void betweenThePointsOfALine()
    {
        const std::vector<EquilibriumLine> lines{
            {true,
             false,
             {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.0, 5e-9, Stability::Stable, -1e4),
              at(2.0, 4e-9, Stability::Stable, -1e4)}},
            {false, true, {at(1.5, 2e-9, Stability::Divergence, 1e4)}}};
        QCOMPARE(equilibriaAt(lines, 0.5).size(), std::size_t(1));
        QVERIFY(std::abs(equilibriaAt(lines, 0.5)[0].spacing - 6e-9) < 1e-22);
        QCOMPARE(equilibriaAt(lines, 1.0).size(), std::size_t(1)); // a point between two spans counts once
        QCOMPARE(equilibriaAt(lines, 1.5).size(), std::size_t(2));
        QVERIFY(equilibriaAt(lines, 1.5)[1].outside);
        QCOMPARE(equilibriaAt(lines, 2.0).size(), std::size_t(1));
        QVERIFY(equilibriaAt(lines, 2.1).empty());
    }

    void sentencesOfALoop()
    {
        HysteresisResult result;
        result.steps = loop();
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "Touch-down at 1.5 mN +- 0.5 mN of maximum meniscus force f_m, rising"));
        QVERIFY(says(findings, "Take-off at 0.5 mN +- 0.5 mN, falling"));
        QVERIFY(says(findings, "Hysteresis at 1 mN: the slider ends in different states"));
        QVERIFY(says(findings, "3 nm mN"));
        QVERIFY(!says(findings, "Forced"));
    }

    void whatWasNotFollowedIsNotCalledStable()
    {
        EquilibriumBranches found;
        Equilibrium one{.spacing = 7e-9,
                        .touching = false,
                        .netContactForce = 0.0,
                        .eigenvalues = {},
                        .stability = Stability::Stable,
                        .lost = 2};
        found.branches = {between(ContactRegion::Apart, one, 3e-3)};
        found.branches[0].points[1].eigenvalues = {{-1e4, 6.283185307179586e5}};
        found.branches[0].points[1].lost = 1;
        HysteresisResult result;
        result.steps = loop();
        addFilmEquilibria(found, result);
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(findings.front().starts_with("Not known: from 0 mN to 3 mN an oscillation"));
        QVERIFY(!says(findings, "Forced") && !says(findings, "stable at"));
        const StudyReport report = hysteresisReport(task(), result);
        QCOMPARE(std::get<std::string>(report.tables[1].rows[0][5]), std::string("not known"));
        // The growth of one is known.
        QCOMPARE(report.charts[0].panels[1].series[0].points.size(), std::size_t(1));
    }

    void nothingIsSaidOfHysteresisWhereEveryHoldFails()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(3e-3, 7e-9, Stability::Stable, -1e4)}}};
        for (HeldStep& each : result.steps) {
            each.end.kind = EndKind::Failed;
            each.problem = "the slider left the film";
        }
        QCOMPARE(loopOf(result.steps).known, std::size_t(0));
        const StudyReport report = hysteresisReport(task(), result);
        QCOMPARE(report.status, StudyStatus::Failed);
        QCOMPARE(report.message, std::string("no value has a valid end: the slider left the film"));
        QVERIFY(!says(report.findings, "ysteresis") && !says(report.findings, "No such cycle"));
    }

    void aLagIsNotYetHysteresis()
    {
        HysteresisResult result;
        result.steps = loop();
        result.steps[6].drift = 1e-9; // 1 mN, back
        QVERIFY(says(hysteresisFindings(task(), result), "Hysteresis or a lag at 1 mN"));
        QVERIFY(says(hysteresisFindings(task(), result),
                     "at none of these values both runs are at rest, and only a longer hold shows"));
    }

    /// Between 1 and 2 mN it falls from 7 to 3 nm: a fold at 6 nm is where it was, one at 2 nm where it came to.
    void endsAtTheFoldOfItsOwnBranch()
    {
        HysteresisResult result;
        result.steps = loop();
        result.marks = {{EquilibriumMark::Fold, "fold", at(1.2e-3, 2e-9, Stability::Stable, 0.0), false}};
        QVERIFY(!says(hysteresisFindings(task(), result), "the flying equilibrium ends"));
        result.marks.push_back({EquilibriumMark::Fold, "fold", at(1.4e-3, 6e-9, Stability::Stable, 0.0), false});
        QVERIFY(says(hysteresisFindings(task(), result), "the flying equilibrium ends at 1.4 mN"));
    }

    /// A crossing at 596 kHz on a grid that knows signs up to 200 kHz is none.
    void aHopfPointThatTheGridDoesNotKnowIsNotMarked()
    {
        const Equilibrium one{.spacing = 3e-9,
                              .touching = true,
                              .netContactForce = 0.0,
                              .eigenvalues = {{0.0, 2.0 * 3.141592653589793 * 596e3}},
                              .stability = Stability::Flutter,
                              .lost = 0};
        EquilibriumBranches found;
        found.branches = {between(ContactRegion::Bridged, one, 1.0)};
        MarkedEquilibrium mark;
        mark.kind = EquilibriumMark::Hopf;
        mark.at = one;
        mark.at.parameter = 0.5;
        found.marks.push_back(mark);
        found.resolved = 100e3; // six cells a wave: the sign is known from three
        HysteresisResult coarse;
        addFilmEquilibria(found, coarse);
        QVERIFY(coarse.marks.empty());
        QCOMPARE(coarse.resolved, 200e3);
        found.resolved = 600e3;
        HysteresisResult fine;
        addFilmEquilibria(found, fine);
        QCOMPARE(fine.marks.size(), std::size_t(1));
        QCOMPARE(fine.marks[0].at.value, 0.5);
    }

    /// Of two degrees of freedom one grows without oscillating: the other is all that oscillates.
    void aSaddleHasOneOscillationLess()
    {
        EquilibriumBranches found;
        const Equilibrium saddle{.spacing = 4e-9,
                                 .touching = true,
                                 .netContactForce = 0.0,
                                 .eigenvalues = {{-1e4, 6.283185307179586e5}},
                                 .stability = Stability::Divergence,
                                 .lost = 1};
        found.branches = {between(ContactRegion::Bridged, saddle, 3e-3)};
        HysteresisResult result;
        result.steps = loop();
        addFilmEquilibria(found, result);
        QVERIFY(result.warnings.empty());
        QVERIFY(!says(hysteresisFindings(task(), result), "Not known"));
        found.branches[0].points[1].lost = 2;
        found.branches[0].points[1].eigenvalues.clear();
        HysteresisResult unknown;
        unknown.steps = loop();
        addFilmEquilibria(found, unknown);
        QVERIFY(says(unknown.warnings, "could not be followed"));
        QVERIFY(says(hysteresisFindings(task(), unknown), "Not known: at 3 mN an oscillation"));
    }

    void aHopfPointWithoutAnOscillationIsNone()
    {
        EquilibriumBranches found;
        found.marks = {{EquilibriumMark::Hopf, {}, "Hopf point"}};
        HysteresisResult result;
        addFilmEquilibria(found, result);
        QVERIFY(result.marks.empty());
    }

    void saysWhatWasSeenWhereNothingSwitches()
    {
        HysteresisResult result;
        result.steps = loop();
        for (HeldStep& each : result.steps) each.end = {EndKind::Contact, 3e-9, 0.0};
        QVERIFY(says(hysteresisFindings(task(), result),
                     "in contact at every value from 0 mN to 3 mN and back, already from the start"));
        for (HeldStep& each : result.steps) each.end = {EndKind::Intermittent, 3e-9, 0.5e-9};
        QVERIFY(says(hysteresisFindings(task(), result),
                     "goes in and out of contact at every value from 0 mN to 3 mN and back"));
        for (HeldStep& each : result.steps) each.end = {EndKind::Flying, 7e-9, 0.0};
        QVERIFY(
            says(hysteresisFindings(task(), result), "flies at every value from 0 mN to 3 mN and back: no touch-down"));
    }

    /// It touches down while 3 mN is held again, and takes off on the way back.
    void aChangeAtTheTurnIsAChange()
    {
        HysteresisResult result;
        result.steps = loop();
        result.steps[2].end = result.steps[3].end = {EndKind::Flying, 7e-9, 0.0};
        const std::vector<std::string> back = hysteresisFindings(task(), result);
        QVERIFY(says(back, "Take-off at 0.5 mN"));
        result.steps[7].end = {EndKind::Contact, 4e-9, 0.0};
        const std::vector<std::string> stays = hysteresisFindings(task(), result);
        QVERIFY(!says(stays, "at every value"));
        QVERIFY(says(stays, "the state changed only while the last value was held a second time"));
        result.steps = loop();
        for (const std::size_t i : {4, 5, 6}) result.steps[i].end = {EndKind::Flying, 7e-9, 0.0};
        const std::vector<std::string> flies = hysteresisFindings(task(), result);
        QVERIFY(!says(flies, "From there on"));
        QVERIFY(says(flies, "The state also changed while the last value was held a second time"));
    }

    /// It leaves its branch between 1 and 2 mN, which ends at 2.5 mN.
    void noReasonIsNamedThatNobodySaw()
    {
        HysteresisResult result;
        result.steps = loop();
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(2.5e-3, 7e-9, Stability::Stable, -1e4)}}};
        result.marks = {{EquilibriumMark::Switch, "touch-down", at(2.5e-3, 7e-9, Stability::Stable, -1e4), false}};
        QVERIFY(
            says(hysteresisFindings(task(), result), "ends only at 2.5 mN: the step itself made the slider oscillate"));
        HeldSteps wavy = task();
        wavy.start.diskSurface.kind = DiskSurfaceKind::Waves;
        QVERIFY(says(hysteresisFindings(wavy, result), "ends only at 2.5 mN."));
        result.lines[0].points[1].lost = 1;
        QVERIFY(says(hysteresisFindings(task(), result), "ends only at 2.5 mN."));
    }

    void saysThatOneWayIsAll()
    {
        HysteresisResult result;
        result.steps = loop();
        result.steps.back().end = {EndKind::Contact, 4e-9, 0.0};
        QVERIFY(says(hysteresisFindings(task(), result),
                     "From there the slider stays in contact: on the way back, to 0 mN, it does not take off again"));
    }
};

TOUCHDOWN_TEST(TestHysteresisResult)

} // namespace test_hysteresis_result

#include "test_hysteresis_result.moc"
