// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <limits>

#include "core/studies/advice/advisor_candidates.h"
#include "core/studies/advice/advisor_judgement.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_advisor_judgement {

class TestAdvisorJudgement : public QObject {
    Q_OBJECT

private slots:
    void aClaim_data();
    void aClaim();
    void aClaimIsConfirmedWithinAFactorOfTwo_data();
    void aClaimIsConfirmedWithinAFactorOfTwo();
    void aVerdict_data();
    void aVerdict();
    void aForetoldEndIsAsUncertainAsItWasForetold();
    void theStepErrorWidensWhatIsAllowed();
    void aSwingThatStepsMayMakeHasNoPeak_data();
    void aSwingThatStepsMayMakeHasNoPeak();
};

constexpr double infinite = std::numeric_limits<double>::infinity();

AdvisorTask adaptive(double stepError)
{
    AdvisorTask task;
    task.start.run.steps = StepControl::Adaptive;
    task.start.run.stepError = stepError;
    return task;
}

// Known to half of it, 0.4 lies between 0.2 and 0.6: a factor of two at most.
void TestAdvisorJudgement::aClaim_data()
{
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("uncertainty");
    QTest::addColumn<double>("value");
    QTest::addColumn<bool>("bound");
    QTest::addColumn<QString>("text");
    QTest::newRow("known") << 0.4e-9 << 0.0 << 0.4e-9 << false << "0.4 nm";
    QTest::newRow("known to half of it") << 0.4e-9 << 0.2e-9 << 0.4e-9 << false << "0.4 nm";
    QTest::newRow("known less well") << 0.4e-9 << 0.21e-9 << 0.61e-9 << true << "< 0.61 nm";
    QTest::newRow("below the resolution") << 0.001e-9 << 0.0 << 0.01e-9 << true << "< 0.01 nm";
    QTest::newRow("not known") << 0.4e-9 << infinite << infinite << true << "not known";
}

void TestAdvisorJudgement::aClaim()
{
    QFETCH(double, error);
    QFETCH(double, uncertainty);
    QFETCH(double, value);
    QFETCH(bool, bound);
    QFETCH(QString, text);
    const Claim claim = claimOf(error, uncertainty, 0.01e-9);
    QCOMPARE(claim.value, value);
    QCOMPARE(claim.bound, bound);
    QCOMPARE(QString::fromStdString(textOf(claim)), text);
}

void TestAdvisorJudgement::aClaimIsConfirmedWithinAFactorOfTwo_data()
{
    QTest::addColumn<bool>("bound");
    QTest::addColumn<double>("found");
    QTest::addColumn<bool>("came");
    QTest::newRow("as claimed") << false << 0.5 << true;
    QTest::newRow("twice as large") << false << 0.99 << true;
    QTest::newRow("more than that") << false << 1.01 << false;
    QTest::newRow("half as large") << false << 0.26 << true;
    QTest::newRow("less than that") << false << 0.24 << false;
    QTest::newRow("below the bound") << true << 0.001 << true;
    QTest::newRow("above the bound") << true << 0.51 << false;
}

void TestAdvisorJudgement::aClaimIsConfirmedWithinAFactorOfTwo()
{
    QFETCH(bool, bound);
    QFETCH(double, found);
    QFETCH(bool, came);
    QCOMPARE(confirms({0.5, bound}, found), came);
}

// 0.1 nm are allowed of each.
void TestAdvisorJudgement::aVerdict_data()
{
    QTest::addColumn<double>("mean");
    QTest::addColumn<double>("uncertainty");
    QTest::addColumn<bool>("sameEnd");
    QTest::addColumn<bool>("endKnown");
    QTest::addColumn<QString>("verdict");
    QTest::newRow("within at worst") << 0.06e-9 << 0.03e-9 << true << true << "within";
    QTest::newRow("perhaps within") << 0.06e-9 << 0.05e-9 << true << true << "not known";
    QTest::newRow("perhaps too far") << 0.14e-9 << 0.05e-9 << true << true << "not known";
    QTest::newRow("too far at best") << 0.16e-9 << 0.05e-9 << true << true << "too far";
    QTest::newRow("of another kind") << 0.0 << 0.0 << false << true << "another end";
    QTest::newRow("perhaps of another kind") << 0.0 << 0.0 << false << false << "not known";
    QTest::newRow("nothing is known") << 0.0 << infinite << true << true << "not known";
}

void TestAdvisorJudgement::aVerdict()
{
    QFETCH(double, mean);
    QFETCH(double, uncertainty);
    QFETCH(bool, sameEnd);
    QFETCH(bool, endKnown);
    QFETCH(QString, verdict);
    const CandidateErrors errors{
        .mean = mean, .meanUncertainty = uncertainty, .sameEnd = sameEnd, .endKnown = endKnown};
    QCOMPARE(QString(name(verdictOn(errors, {.mean = 0.1e-9, .spread = 0.1e-9})).data()), verdict);
}

void TestAdvisorJudgement::aForetoldEndIsAsUncertainAsItWasForetold()
{
    TailEstimate full, candidate;
    full.kind = candidate.kind = EndKind::Flying;
    full.mean = 10e-9;
    full.meanUncertainty = 0.02e-9;
    full.spreadUncertainty = 0.03e-9;
    candidate.mean = 10.05e-9;
    const CandidateErrors errors = errorsOf(candidate, full, adaptive(5e-12));
    QVERIFY(std::abs(errors.mean - 0.05e-9) < 1e-20);
    QCOMPARE(errors.meanUncertainty, 0.02e-9);
    QVERIFY(!errors.claimedMean().bound);
    QCOMPARE(errors.claimedSpread().value, 0.03e-9);
    QVERIFY(errors.claimedSpread().bound);
}

// 1 % of 10 nm are 0.1 nm, 10 % of that 0.01 nm; two steps may displace it by 1 nm.
void TestAdvisorJudgement::theStepErrorWidensWhatIsAllowed()
{
    TailEstimate full;
    full.mean = 10e-9;
    const Allowance fine = allowanceOf(full, adaptive(5e-12)), coarse = allowanceOf(full, adaptive(0.5e-9));
    QCOMPARE(fine.mean, 0.1e-9);
    QCOMPARE(fine.spread, 0.01e-9);
    QVERIFY(!fine.widened());
    QCOMPARE(coarse.mean, 1e-9);
    QCOMPARE(coarse.spread, 1e-9);
    QCOMPARE(coarse.wantedMean, 0.1e-9);
    QVERIFY(coarse.widened());
}

// The full model swings by 0.5 nm about 10 nm at 300 kHz, of which the static state knows nothing.
void TestAdvisorJudgement::aSwingThatStepsMayMakeHasNoPeak_data()
{
    QTest::addColumn<double>("stepError");
    QTest::addColumn<bool>("same");
    QTest::newRow("fine steps") << 5e-12 << false;
    QTest::newRow("steps that may displace it by as much") << 0.3e-9 << true;
}

void TestAdvisorJudgement::aSwingThatStepsMayMakeHasNoPeak()
{
    QFETCH(double, stepError);
    QFETCH(bool, same);
    const TailEstimate full{
        .kind = EndKind::Flying, .mean = 10e-9, .spread = 0.5e-9, .peakFrequency = 300e3, .resolution = 10e3};
    const TailEstimate still{.kind = EndKind::Flying, .mean = 10e-9};
    QCOMPARE(errorsOf(still, full, adaptive(stepError)).samePeak, same);
}

TOUCHDOWN_TEST(TestAdvisorJudgement)

} // namespace test_advisor_judgement

#include "test_advisor_judgement.moc"
