// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis_result.h"

#include <algorithm>
#include <cmath>

#include <QTest>

using namespace touchdown;

namespace {

HeldStep step(double value, bool back, EndKind kind, double spacing)
{
    HeldStep held;
    held.value = value;
    held.back = back;
    held.done = true;
    held.end = {kind, spacing, 0.0};
    held.spacing = {.mean = spacing, .std = 0.0, .min = spacing, .max = spacing};
    return held;
}

/// f_m from 0 to 3 mN and back: touches at 2 mN, lets go at 0.
std::vector<HeldStep> loop()
{
    using enum EndKind;
    return {step(0.0, false, Flying, 7e-9),   step(1e-3, false, Flying, 7e-9),  step(2e-3, false, Contact, 3e-9),
            step(3e-3, false, Contact, 2e-9), step(3e-3, true, Contact, 2e-9),  step(2e-3, true, Contact, 3e-9),
            step(1e-3, true, Contact, 4e-9),  step(0.0, true, Flying, 7e-9)};
}

HeldSteps task()
{
    HeldSteps steps;
    steps.parameter = std::get<DesignKey>(designKey(steps.start, "ono_yamane.meniscus_force"));
    steps.values = {0.0, 1e-3, 2e-3, 3e-3};
    return steps;
}

StudiedEquilibrium at(double value, double spacing, Stability stability, double growth)
{
    return {value, spacing, 90e-6, stability, {{growth, 6.283185307179586e5}, {growth, -6.283185307179586e5}}, 0, false};
}

bool says(const std::vector<std::string>& findings, const std::string& part)
{
    return std::ranges::any_of(findings, [&](const std::string& each) { return each.find(part) != std::string::npos; });
}

} // namespace

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

    void betweenThePointsOfALine()
    {
        const std::vector<EquilibriumLine> lines{
            {"flying", false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.0, 5e-9, Stability::Stable, -1e4), at(2.0, 4e-9, Stability::Stable, -1e4)}},
            {"in contact", true, {at(1.5, 2e-9, Stability::Divergence, 1e4)}}};
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
        QVERIFY(says(findings, "Touch-down at 1.5 mN +- 0.5 mN, rising"));
        QVERIFY(says(findings, "Take-off at 0.5 mN +- 0.5 mN, falling"));
        QVERIFY(says(findings, "Hysteresis at 1 mN: there and back"));
        QVERIFY(says(findings, "3 nm mN"));
        QVERIFY(!says(findings, "Forced"));
    }

    void forcedWhereAllIsStable()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {{"flying", false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(3e-3, 7e-9, Stability::Stable, -1e4)}}};
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(findings.front().starts_with("Forced"));
        QVERIFY(says(findings, "fades by a factor of e within 100 us"));
    }

    void selfExcitedWhereAnOscillationGrows()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {{"in contact", false, {at(0.0, 3e-9, Stability::Stable, -1e4), at(3e-3, 3e-9, Stability::Flutter, 1e4)}}};
        result.marks = {{EquilibriumMark::Hopf, "Hopf point", at(1.5e-3, 3e-9, Stability::Neutral, 0.0), false}};
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(findings.front().starts_with("Self-excited"));
        QVERIFY(says(findings, "Hopf point at 1.5 mN (3 nm spacing, 100 kHz)"));
        QVERIFY(!says(findings, "Forced"));
    }

    void selfExcitedWhereThereIsNoEquilibrium()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {{"flying", false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.5e-3, 7e-9, Stability::Stable, -1e4)}}};
        result.steps[2].end.kind = result.steps[4].end.kind = EndKind::Intermittent;
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "Self-excited: from 2 mN to 3 mN the slider ends in and out of contact"));
        QVERIFY(!says(findings, "Forced"));
    }

    /// At 2 and 3 mN it comes to rest without a known equilibrium: that is no reason to bounce.
    void aMissingEquilibriumIsNoReasonByItself()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {{"flying", false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.5e-3, 7e-9, Stability::Stable, -1e4)}}};
        std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "From 2 mN to 3 mN no equilibrium was found"));
        QVERIFY(!says(findings, "Self-excited") && !says(findings, "Forced"));
        result.unsought = true;
        findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "Not known: from 2 mN to 3 mN the search"));
        QVERIFY(!says(findings, "Self-excited") && !says(findings, "Forced"));
    }

    void whatWasNotFollowedIsNotCalledStable()
    {
        FilmBranches found;
        FilmEquilibrium one{.attitude = {}, .spacing = 7e-9, .touching = false, .netContactForce = 0.0, .eigenvalues = {},
                            .stability = Stability::Stable, .lost = 2};
        found.branches = {{ContactRegion::Apart, {{0.0, one}, {3e-3, one}}}};
        found.branches[0].points[1].at.eigenvalues = {{-1e4, 6.283185307179586e5}};
        found.branches[0].points[1].at.lost = 1;
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
        result.lines = {{"flying", false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(3e-3, 7e-9, Stability::Stable, -1e4)}}};
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
        QVERIFY(says(hysteresisFindings(task(), result), "at none of these values have both come to rest: a longer hold tells"));
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

    void aCoarseGridDoesNotKnow()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.resolved = 99e3; // the oscillation has 100 kHz
        result.lines = {{"in contact", false, {at(0.0, 3e-9, Stability::Stable, -1e4), at(3e-3, 3e-9, Stability::Flutter, 1e4)}}};
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(findings.front().starts_with("Not known on this grid: at 3 mN"));
        QVERIFY(!says(findings, "Self-excited") && !says(findings, "Forced"));
    }

    /// A crossing at 596 kHz on a grid that knows signs up to 200 kHz is none.
    void aHopfPointThatTheGridDoesNotKnowIsNotMarked()
    {
        const FilmEquilibrium one{.attitude = {}, .spacing = 3e-9, .touching = true, .netContactForce = 0.0,
                                  .eigenvalues = {{0.0, 2.0 * 3.141592653589793 * 596e3}}, .stability = Stability::Flutter, .lost = 0};
        FilmBranches found;
        found.branches = {{ContactRegion::Bridged, {{0.0, one}, {1.0, one}}}};
        found.marks = {{EquilibriumMark::Hopf, {0.5, one}, "Hopf point"}};
        found.resolved = 60e3; // ten cells a wave: the sign is known from three
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
        FilmBranches found;
        const FilmEquilibrium saddle{.attitude = {}, .spacing = 4e-9, .touching = true, .netContactForce = 0.0,
                                     .eigenvalues = {{-1e4, 6.283185307179586e5}}, .stability = Stability::Divergence, .lost = 1};
        found.branches = {{ContactRegion::Bridged, {{0.0, saddle}, {3e-3, saddle}}}};
        HysteresisResult result;
        result.steps = loop();
        addFilmEquilibria(found, result);
        QVERIFY(result.warnings.empty());
        QVERIFY(!says(hysteresisFindings(task(), result), "Not known"));
        found.branches[0].points[1].at.lost = 2;
        found.branches[0].points[1].at.eigenvalues.clear();
        HysteresisResult unknown;
        unknown.steps = loop();
        addFilmEquilibria(found, unknown);
        QVERIFY(says(unknown.warnings, "could not be followed"));
        QVERIFY(says(hysteresisFindings(task(), unknown), "Not known: at 3 mN an oscillation"));
    }

    void aHopfPointWithoutAnOscillationIsNone()
    {
        FilmBranches found;
        found.marks = {{EquilibriumMark::Hopf, {}, "Hopf point"}};
        HysteresisResult result;
        addFilmEquilibria(found, result);
        QVERIFY(result.marks.empty());
    }

    /// Stable flying up to 1.5, in contact from 0.5 on, unstable between 1 and 1.2: more than one from 0.5 to 1 and from 1.2 to 1.5.
    void coexistenceBetweenHeldValues()
    {
        using enum Stability;
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {{"flying", false, {at(0.0, 7e-9, Stable, -1e4), at(1.5e-3, 7e-9, Stable, -1e4)}},
                        {"in contact", false,
                         {at(0.5e-3, 3e-9, Stable, -1e4), at(1.0e-3, 3e-9, Stable, -1e4), at(1.01e-3, 3e-9, Flutter, 1e4),
                          at(1.19e-3, 3e-9, Flutter, 1e4), at(1.2e-3, 3e-9, Stable, -1e4), at(3e-3, 3e-9, Stable, -1e4)}}};
        // Between a stable and an unstable point the nearer one counts: to the middle of the span.
        QVERIFY(says(hysteresisFindings(task(), result), "More than one equilibrium is stable from 0.5 mN to 1"));
        QVERIFY(says(hysteresisFindings(task(), result), " mN to 1.5 mN: which one"));
    }

    void saysWhatWasSeenWhereNothingSwitches()
    {
        HysteresisResult result;
        result.steps = loop();
        for (HeldStep& each : result.steps) each.end = {EndKind::Contact, 3e-9, 0.0};
        QVERIFY(says(hysteresisFindings(task(), result), "in contact at every value from 0 mN to 3 mN and back, which it came to from its start"));
        for (HeldStep& each : result.steps) each.end = {EndKind::Intermittent, 3e-9, 0.5e-9};
        QVERIFY(says(hysteresisFindings(task(), result), "goes in and out of contact at every value from 0 mN to 3 mN and back"));
        for (HeldStep& each : result.steps) each.end = {EndKind::Flying, 7e-9, 0.0};
        QVERIFY(says(hysteresisFindings(task(), result), "flies at every value from 0 mN to 3 mN and back: no touch-down was seen"));
    }

    void saysThatOneWayIsAll()
    {
        HysteresisResult result;
        result.steps = loop();
        result.steps.back().end = {EndKind::Contact, 4e-9, 0.0};
        QVERIFY(says(hysteresisFindings(task(), result), "From there on the slider stays in contact: on the way back, to 0 mN, it does not take off again"));
    }
};

QTEST_GUILESS_MAIN(TestHysteresisResult)
#include "test_hysteresis_result.moc"
