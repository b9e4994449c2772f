// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/measured_run.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/case_files/case_settings.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_measured_run {

class TestMeasuredRun : public QObject {
    Q_OBJECT

private slots:
    /// textbook_bounce: x = FH - d_s, A = 100 nm; above the disk half a period of w_1 with mean 2 A/pi and mean square
    /// A^2/2, below it half a period of w_2 = 4 w_1 with -(A/4) 2/pi and (A/4)^2/2. Weights 1 and 1/4 over 5/4:
    ///   mean = (2 A/pi)(1 - 1/16)/(5/4) = (3/2) A/pi,   mean square = (A^2/2)(1 + 1/64)/(5/4) = (13/32) A^2
    /// 20 periods of 5 pi/(4 w_1) end with two whole ones in the tail.
    void bounceHasItsExactTail()
    {
        Case c = sample("textbook_bounce");
        constexpr double a = 100e-9, w1 = 63245.553203367585;
        c.run.duration = 20.0 * 1.25 * std::numbers::pi / w1;
        c.run.sampleInterval = c.run.duration / 20000.0;
        const MeasuredRun run = measureRun(c, {"flying_height"});
        QVERIFY(run.valid());
        QCOMPARE(run.end.kind, EndKind::Intermittent);
        const double mean = 1.5 * a / std::numbers::pi;
        QVERIFY(std::abs(run.end.spacing - (30e-9 + mean)) < 1e-3 * a);
        QVERIFY(std::abs(run.end.spread - std::sqrt(13.0 / 32.0 * a * a - mean * mean)) < 1e-3 * a);
        QCOMPARE(run.time.size(), std::size_t{20001});
        QCOMPARE(run.columns.front().size(), run.time.size());
        QCOMPARE(run.columns.front().front(), c.initial.flyingHeight);
    }

    void endKinds_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<EndKind>("kind");
        QTest::newRow("damped to 7 nm") << "fig10a" << EndKind::Flying;
        QTest::newRow("held by menisci") << "fig12a" << EndKind::Contact;
        QTest::newRow("a spring is lost") << "fig12b" << EndKind::Failed;
    }
    void endKinds()
    {
        QFETCH(QString, name);
        QFETCH(EndKind, kind);
        const MeasuredRun run = measureRun(sample(name.toStdString()), {});
        QCOMPARE(run.end.kind, kind);
        QCOMPARE(run.valid(), kind != EndKind::Failed);
    }

    void stops()
    {
        const MeasuredRun run =
            measureRun(sample("fig10a"), {"flying_height", "no such quantity"}, [] { return false; });
        QCOMPARE(run.summary.status, RunStatus::Cancelled);
        QCOMPARE(run.end.kind, EndKind::Failed);
        QVERIFY(run.columns[1].empty());
    }

    void sameEnds()
    {
        const EndState flying{EndKind::Flying, 7e-9, 0.0}, ringing{EndKind::Flying, 7.3e-9, 0.4e-9},
            contact{EndKind::Contact, 7e-9, 0.0};
        QVERIFY(sameEnd(flying, {EndKind::Flying, 7.05e-9, 0.0}));
        QVERIFY(!sameEnd(flying, {EndKind::Flying, 7.2e-9, 0.0}));
        QVERIFY(sameEnd(ringing, {EndKind::Flying, 6.9e-9, 0.25e-9}));
        QVERIFY(!sameEnd(flying, ringing)); // at rest the one, ringing the other
        QVERIFY(!sameEnd(flying, contact));
        QVERIFY(sameEnd({}, {}));
    }

    /// What fails in one way is one outcome, whenever it failed; the front spring is another than the rear one.
    void sameOutcomes()
    {
        const auto failed = [](RunFailure failure, const std::string& message) {
            MeasuredRun run;
            run.summary.status = RunStatus::Failed;
            run.summary.failure = failure;
            run.summary.message = message;
            return run;
        };
        const MeasuredRun rear = failed(RunFailure::RearSpringLost, "since 2 us"),
                          later = failed(RunFailure::RearSpringLost, "since 3 us");
        MeasuredRun flying;
        flying.end = {EndKind::Flying, 7e-9, 0.0};
        QVERIFY(sameOutcome(rear, later));
        QVERIFY(!sameOutcome(rear, failed(RunFailure::FrontSpringLost, "since 2 us")));
        QVERIFY(!sameOutcome(rear, flying));
        QCOMPARE(outcomeText(flying), std::string("flies at 7 nm"));
        QCOMPARE(outcomeText(rear), std::string("fails: since 2 us"));
    }

    void settings()
    {
        Case c = sample("fig10a");
        QVERIFY(!changeCase(c, {{"run.integrator", "rk4"}, {"run.step", "2 ns"}}));
        QCOMPARE(c.run.integrator, IntegratorKind::Rk4);
        QVERIFY(std::abs(c.run.step - 2e-9) < 1e-20);

        const Case before = c;
        for (const CaseSetting& wrong :
             {CaseSetting{"run.stepp", "1 ns"}, {"run.step", "1 kg"}, {"run.step", "-1 ns"}}) {
            const auto problem = changeCase(c, {{"run.integrator", "dopri5"}, wrong});
            QVERIFY(problem && problem->key == wrong.key && !problem->message.empty());
            QCOMPARE(c.run.integrator, before.run.integrator);
        }
        // Each for itself is allowed, the pair is not: take-off below touch-down.
        const auto pair = changeCase(c, {{"ono_yamane.touch_down", "6 nm"}});
        QVERIFY(pair && pair->key.starts_with("ono_yamane."));
    }
    void aRunTellsItsShare()
    {
        Case c = sample("fig10a");
        c.run.duration = 0.2e-3;
        std::vector<double> shares;
        measureRun(c, {}, {}, {}, [&](double share) { shares.push_back(share); });
        QVERIFY(shares.size() > 1);
        QVERIFY(std::ranges::is_sorted(shares));
        QCOMPARE(shares.back(), 1.0);
        // However it ends.
        shares.clear();
        measureRun(
            c, {}, [] { return false; }, {}, [&](double share) { shares.push_back(share); });
        QCOMPARE(shares.back(), 1.0);
    }
};

TOUCHDOWN_TEST(TestMeasuredRun)

} // namespace test_measured_run

#include "test_measured_run.moc"
