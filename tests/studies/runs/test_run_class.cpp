// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/run_class.h"

#include <cmath>
#include <set>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/case_files/case_file.h"
#include "core/studies/runs/proven_reference.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_class {

constexpr ClassRule rule{};

MeasuredRun measured(const Case& c) { return measureRun(c, {std::string(spacingOf(c))}, {}, {.energyBalance = true}); }

ProvenReference referenceOf(const Case& c, bool nudged = false)
{
    const std::vector<ReferenceCase> cases = springReferences(c, 1e-9);
    std::vector<MeasuredRun> runs, ends;
    for (const ReferenceCase& each : cases) runs.push_back(measured(each.c));
    ProvenReference reference = proveReference(cases, std::move(runs), rule.agreement);
    if (!nudged) return reference;
    for (const Case& each : nudgedStarts(cases[reference.which].c)) ends.push_back(measured(each));
    proveEnd(reference, ends);
    return reference;
}

Case with(Case c, IntegratorKind integrator, double step)
{
    c.run.integrator = integrator;
    c.run.step = step;
    return c;
}

/// A run that was not made: flat at a spacing.
MeasuredRun flat(double spacing, EndKind kind = EndKind::Flying)
{
    MeasuredRun run;
    run.time = {0.0, 1e-6, 2e-6};
    run.columns = {{spacing, spacing, spacing}};
    run.end = {kind, spacing, 0.0};
    return run;
}
MeasuredRun failed(RunFailure failure, const std::string& message)
{
    MeasuredRun run = flat(5e-9, EndKind::Failed);
    run.summary.status = failure == RunFailure::Diverged ? RunStatus::Diverged : RunStatus::Failed;
    run.summary.failure = failure;
    run.summary.message = message;
    return run;
}
/// Of two runs that were not made.
ProvenReference proven(const MeasuredRun& run, const MeasuredRun& check)
{
    return proveReference({{"a", {}}, {"b", {}}}, {run, check}, rule.agreement);
}
ProvenReference known(const MeasuredRun& run) { return proven(run, run); }

class TestRunClass : public QObject {
    Q_OBJECT

private slots:
    /// Each kind of end against a reference that flies at 7 nm.
    void eachClass()
    {
        const Case c;
        const ProvenReference reference = known(flat(7e-9));
        const auto kindOf = [&](const MeasuredRun& run) { return classify(c, run, reference, rule).kind; };
        QCOMPARE(kindOf(flat(7e-9)), RunClass::Agrees);
        QCOMPARE(kindOf(flat(3e-9, EndKind::Contact)), RunClass::WrongEnd);
        QCOMPARE(kindOf(flat(7.2e-9)), RunClass::WrongEnd);
        MeasuredRun detour = flat(7e-9);
        detour.columns[0][1] = 9e-9;
        QCOMPARE(kindOf(detour), RunClass::OtherWay);
        QVERIFY(std::abs(classify(c, detour, reference, rule).apart - 2e-9) < 1e-24);
        detour.summary.figures.push_back({{"energy_balance", "1", "1", ""}, 0.02});
        QCOMPARE(kindOf(detour), RunClass::DriftingEnergy);
        QCOMPARE(kindOf(failed(RunFailure::Chattering, "chattering at 2 us: ...")), RunClass::Chatter);
        QCOMPARE(kindOf(failed(RunFailure::RearSpringLost, "the rear air spring is lost for good since 2 us")),
                 RunClass::LostSpring);
        QCOMPARE(kindOf(failed(RunFailure::Diverged, "the motion diverged at 2 us")), RunClass::Diverged);
        QCOMPARE(kindOf(failed(RunFailure::Tunnelled, "a step tunnelled at 2 us")), RunClass::Stopped);
    }
    /// A failure that the reference has, too, is the truth; a run that completes instead is wrong.
    void whatFailsAsTheReference()
    {
        const ProvenReference reference =
            known(failed(RunFailure::RearSpringLost, "the rear air spring is lost for good since 2 us"));
        QVERIFY(reference.endKnown);
        QCOMPARE(classify({}, failed(RunFailure::RearSpringLost, "the rear air spring is lost for good since 3 us"),
                          reference, rule)
                     .kind,
                 RunClass::AsReference);
        QCOMPARE(classify({}, failed(RunFailure::FrontSpringLost, "the front air spring is lost for good since 3 us"),
                          reference, rule)
                     .kind,
                 RunClass::LostSpring);
        QCOMPARE(classify({}, flat(7e-9), reference, rule).kind, RunClass::WrongEnd);
    }
    /// Two methods that part, with the same end: the end alone counts. Starts that hardly differ and end otherwise:
    /// nothing does.
    void whatIsNotDetermined()
    {
        MeasuredRun detour = flat(7e-9);
        detour.columns[0][1] = 8e-9;
        ProvenReference reference = proven(flat(7e-9), detour);
        QVERIFY(reference.endKnown && reference.horizon && *reference.horizon == 1e-6);
        detour.columns[0][1] = 9e-9;
        QCOMPARE(classify({}, detour, reference, rule).kind, RunClass::Agrees);
        proveEnd(reference, {flat(7e-9), flat(3e-9, EndKind::Contact)});
        QVERIFY(!reference.endKnown);
        QCOMPARE(classify({}, detour, reference, rule).kind, RunClass::NotDetermined);
        const ProvenReference other = proven(flat(7e-9), flat(3e-9, EndKind::Contact));
        QCOMPARE(classify({}, detour, other, rule).kind, RunClass::NotDetermined);
    }
    /// Fixed steps of a film run that had to be cut; springs have none.
    void cutSteps()
    {
        Case c = openCase("film_plane").value;
        c.run.steps = StepControl::Fixed;
        MeasuredRun run = flat(7e-9);
        run.summary.rejectedSteps = 3;
        QCOMPARE(classify(c, run, known(flat(7e-9)), rule).kind, RunClass::CutSteps);
        QCOMPARE(classify({}, run, known(flat(7e-9)), rule).kind, RunClass::Agrees);
    }
    void classesHaveNamesAndSeverities()
    {
        std::set<std::string_view> names;
        for (int k = 0; k < runClasses; ++k) {
            names.insert(name(static_cast<RunClass>(k)));
            QVERIFY(severity(static_cast<RunClass>(k)) >= 0 && severity(static_cast<RunClass>(k)) <= 3);
        }
        QCOMPARE(names.size(), std::size_t{runClasses});
        QVERIFY(!names.contains(""));
    }

    /// The paper's trouble: d_1 = d_s, from 230 nm. Two methods prove that it flies; steps of 10 ns that look for
    /// switches between steps end in contact, those that locate them agree.
    void naiveSwitchingEndsInTheWrongState()
    {
        Case c = openCase("fig10b_naive_switching").value;
        const ProvenReference reference = referenceOf(c);
        QVERIFY2(reference.endKnown && !reference.horizon && reference.apart < 1e-14, knowledgeOf(reference).c_str());
        QCOMPARE(reference.run.end.kind, EndKind::Flying);
        const RunVerdict naive = classify(c, measured(with(c, IntegratorKind::Rk4, 10e-9)), reference, rule);
        QVERIFY2(naive.kind == RunClass::WrongEnd, naive.sentence.c_str());
        const RunVerdict located = classify(c, measured(with(c, IntegratorKind::Rk4Events, 10e-9)), reference, rule);
        QVERIFY2(located.kind == RunClass::Agrees, located.sentence.c_str());
    }
    /// 50 mN and d_1 = d_s: the rear spring is lost for good by every method that is accurate, which is what there is
    /// to know.
    void aSpringLostForGood()
    {
        const Case c = openCase("fig12b").value;
        const ProvenReference reference = referenceOf(c);
        QVERIFY(reference.endKnown && reference.run.summary.failure == RunFailure::RearSpringLost);
        QCOMPARE(classify(c, measured(with(c, IntegratorKind::Rk4Events, 10e-9)), reference, rule).kind,
                 RunClass::AsReference);
    }
    /// A toss: from 11 nm it flies in the end, from 12 nm it stays in contact. Starts around the height at which that
    /// changes, found by halving, are not determined.
    void aToss()
    {
        Case c = openCase("fig10a").value;
        c.run.duration = 1e-3;
        c.run.tolerance = 1e-12;
        double flies = 11e-9, touches = 12e-9;
        const auto flying = [&](double height) {
            c.initial.flyingHeight = height;
            return measured(c).end.kind == EndKind::Flying;
        };
        QVERIFY(flying(flies) && !flying(touches));
        for (int n = 0; n < 17; ++n) (flying(0.5 * (flies + touches)) ? flies : touches) = 0.5 * (flies + touches);
        QVERIFY(touches - flies < 1e-14);
        c.initial.flyingHeight = 0.5 * (flies + touches);
        QVERIFY(!referenceOf(c, true).endKnown);
    }
};

TOUCHDOWN_TEST(TestRunClass)

} // namespace test_run_class

#include "test_run_class.moc"
