// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis_report.h"

#include <QTest>

#include "tests/support/held_loop.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_hysteresis_answer {

class TestHysteresisAnswer : public QObject {
    Q_OBJECT

private slots:
    void forcedWhereAllIsStable()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(3e-3, 7e-9, Stability::Stable, -1e4)}}};
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(findings.front().starts_with("Forced"));
        QVERIFY(says(findings, "decays by a factor of e within 100 us"));
    }

    void selfExcitedWhereAnOscillationGrows()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {
            {false, false, {at(0.0, 3e-9, Stability::Stable, -1e4), at(3e-3, 3e-9, Stability::Flutter, 1e4)}}};
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
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.5e-3, 7e-9, Stability::Stable, -1e4)}}};
        for (const std::size_t i : {2, 4}) letBounce(result.steps[i]);
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "Self-excited: from 2 mN to 3 mN the slider bounces to the end"));
        QVERIFY(!says(findings, "Forced"));
    }

    /// At 2 and 3 mN it comes to rest without a known equilibrium: that is no reason to bounce.
    void aMissingEquilibriumIsNoReasonByItself()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.5e-3, 7e-9, Stability::Stable, -1e4)}}};
        std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "From 2 mN to 3 mN no equilibrium was found"));
        QVERIFY(!says(findings, "Self-excited") && !says(findings, "Forced"));
        result.unsought = true;
        findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "Not known: from 2 mN to 3 mN the search"));
        QVERIFY(!says(findings, "Self-excited") && !says(findings, "Forced"));
    }

    void aCoarseGridDoesNotKnow()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.resolved = 99e3; // the oscillation has 100 kHz
        result.lines = {
            {false, false, {at(0.0, 3e-9, Stability::Stable, -1e4), at(3e-3, 3e-9, Stability::Flutter, 1e4)}}};
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(findings.front().starts_with("Not known on this grid: at 3 mN"));
        QVERIFY(!says(findings, "Self-excited") && !says(findings, "Forced"));
    }

    /// Stable flying up to 1.5, in contact from 0.5 on, unstable between 1 and 1.2: more than one from 0.5 to 1 and
    /// from 1.2 to 1.5.
    void coexistenceBetweenHeldValues()
    {
        using enum Stability;
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stable, -1e4), at(1.5e-3, 7e-9, Stable, -1e4)}},
            {false,
             false,
             {at(0.5e-3, 3e-9, Stable, -1e4), at(1.0e-3, 3e-9, Stable, -1e4), at(1.01e-3, 3e-9, Flutter, 1e4),
              at(1.19e-3, 3e-9, Flutter, 1e4), at(1.2e-3, 3e-9, Stable, -1e4), at(3e-3, 3e-9, Stable, -1e4)}}};
        // Between a stable and an unstable point the nearer one counts: to the middle of the span.
        QVERIFY(says(hysteresisFindings(task(), result), "More than one equilibrium is stable from 0.5 mN to 1"));
        QVERIFY(says(hysteresisFindings(task(), result), " mN to 1.5 mN: the way there decides"));
    }

    /// Bouncing at 2 and 3 mN about equilibria that diverge is not forced.
    void aSaddleIsNoPlaceToComeToRestIn()
    {
        HysteresisResult result;
        result.steps = loop();
        result.traced = true;
        for (const std::size_t i : {2, 3, 4, 5}) letBounce(result.steps[i]);
        result.lines = {
            {true, false, {at(0.0, 7e-9, Stability::Stable, -1e4), at(1.5e-3, 7e-9, Stability::Stable, -1e4)}},
            {false,
             false,
             {at(1.5e-3, 4e-9, Stability::Divergence, -1e4), at(3e-3, 4e-9, Stability::Divergence, -1e4)}}};
        const std::vector<std::string> findings = hysteresisFindings(task(), result);
        QVERIFY(says(findings, "Self-excited: from 2 mN to 3 mN the slider bounces to the end, and no "
                               "equilibrium was found that it could"));
        QVERIFY(!says(findings, "Forced"));
    }

    /// In contact at 3 nm where a saddle lies at 3.1 nm and a stable one at 2.5 nm.
    void onlyWhatIsStableIsComeToRestIn()
    {
        HysteresisResult result;
        result.traced = true;
        result.steps = {step(2e-3, false, EndKind::Contact, 3e-9), step(2e-3, true, EndKind::Flying, 7e-9)};
        result.lines = {
            {false,
             false,
             {at(1e-3, 3.1e-9, Stability::Divergence, -1e4), at(3e-3, 3.1e-9, Stability::Divergence, -1e4)}},
            {false, false, {at(1e-3, 2.5e-9, Stability::Stable, -1e4), at(3e-3, 2.5e-9, Stability::Stable, -1e4)}}};
        QVERIFY(says(hysteresisFindings(task(), result),
                     "1 of 2 runs at rest came to rest within 0.5 nm of an equilibrium that is stable"));
    }
};

TOUCHDOWN_TEST(TestHysteresisAnswer)

} // namespace test_hysteresis_answer

#include "test_hysteresis_answer.moc"
