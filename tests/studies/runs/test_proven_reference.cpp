// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/proven_reference.h"

#include <QTest>

#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_proven_reference {

const std::vector<ReferenceCase> cases{{"a", {}}, {"b", {}}, {"c", {}}};

/// A run that was not made, of three samples.
MeasuredRun through(std::vector<double> spacings, EndKind kind = EndKind::Flying)
{
    MeasuredRun run;
    run.time = {0.0, 1e-6, 2e-6};
    run.end = {kind, spacings.back(), 0.0};
    run.columns = {std::move(spacings)};
    return run;
}

class TestProvenReference : public QObject {
    Q_OBJECT

private slots:
    /// b and c lie 0.01 nm apart, a 0.04 nm from either.
    void takesTheClosestPair()
    {
        const ProvenReference reference = proveReference(
            cases, {through({7e-9, 7e-9, 7e-9}), through({7e-9, 7.04e-9, 7e-9}), through({7e-9, 7.05e-9, 7e-9})},
            0.1e-9);
        QCOMPARE(reference.label, std::string("b"));
        QCOMPARE(reference.other, std::string("c"));
        QVERIFY(std::abs(reference.apart - 0.01e-9) < 1e-24);
        QVERIFY(!reference.horizon && reference.endKnown);
        QCOMPARE(reference.samples, std::size_t{3});
    }
    /// What was stopped lies as close as it likes.
    void aStoppedRunProvesNothing()
    {
        MeasuredRun stopped = through({7e-9, 7e-9, 7e-9});
        stopped.summary.status = RunStatus::Cancelled;
        const ProvenReference reference =
            proveReference(cases, {stopped, through({7e-9, 7e-9, 7e-9}), through({7e-9, 7.05e-9, 7e-9})}, 0.1e-9);
        QCOMPARE(reference.label, std::string("b"));
    }
    /// No two end alike: a and c stay together for two samples, others for one.
    void takesThoseThatStayTogether()
    {
        const ProvenReference reference = proveReference(
            cases,
            {through({7e-9, 7e-9, 7e-9}), through({7e-9, 8e-9, 5e-9}), through({7e-9, 7e-9, 3e-9}, EndKind::Contact)},
            0.1e-9);
        QCOMPARE(reference.other, std::string("c"));
        QCOMPARE(reference.samples, std::size_t{2});
        QVERIFY(reference.horizon && *reference.horizon == 2e-6 && !reference.endKnown);
    }
    void nothingIsShared()
    {
        const ProvenReference reference =
            proveReference({{"a", {}}, {"b", {}}},
                           {through({7e-9, 7e-9, 7e-9}), through({3e-9, 3e-9, 3e-9}, EndKind::Contact)}, 0.1e-9);
        QVERIFY(!reference.problem.empty() && !reference.endKnown);
        QVERIFY(knowledgeOf(reference).starts_with("not determined"));
    }
    /// Half of a step of 0.01 ns is 5.0000000000000005e-12 s.
    void labelsAreShort()
    {
        QCOMPARE(springReferences(sample("fig10a"), 0.5 * 1e-11)[1].label, std::string("rk4-events (0.005 ns)"));
        QCOMPARE(couplingReferences(sample("film_pico"))[0].label, std::string("monolithic (step error 5e-5 nm)"));
    }
    void startsHardlyDiffer()
    {
        const Case c = sample("fig10a");
        for (const Case& each : nudgedStarts(c)) {
            const double change = std::abs(each.initial.flyingHeight - c.initial.flyingHeight);
            QVERIFY(change > 0.5e-13 && change < 5e-13);
        }
    }
};

TOUCHDOWN_TEST(TestProvenReference)

} // namespace test_proven_reference

#include "test_proven_reference.moc"
