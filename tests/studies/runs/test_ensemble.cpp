// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/ensemble.h"

#include <cmath>

#include <QTest>

#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_ensemble {

EnsembleEnd flying(double spacing) { return {.state = {EndKind::Flying, spacing, 0.0}}; }
EnsembleEnd failed(RunFailure how) { return {.state = {}, .failure = how}; }

const auto always = [](std::size_t, double) { return true; };

class TestEnsemble : public QObject {
    Q_OBJECT

private slots:
    /// 2000 starts within [8, 12] nm: the distance of their distribution from the straight line is below 1.63/sqrt(N)
    /// with a probability of 99 % (Kolmogorov). The same seed draws the same starts, another one draws others.
    void startsAreDrawnEvenly()
    {
        Case c = sample("fig10a");
        c.initial.flyingHeight = 10e-9;
        const EnsembleTask task{.key = "initial.flying_height", .starts = 2000, .spread = 2e-9, .seed = 7};
        const std::vector<double> starts = startsOf(c, task);
        QCOMPARE(starts.size(), std::size_t{2000});
        double distance = 0.0;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const double share = (starts[i] - 8e-9) / 4e-9;
            QVERIFY(share >= 0.0 && share <= 1.0);
            QVERIFY(i == 0 || starts[i] >= starts[i - 1]);
            distance = std::max(distance, std::abs(share - (static_cast<double>(i) + 0.5) / 2000.0));
        }
        QVERIFY(distance < 1.63 / std::sqrt(2000.0));
        QCOMPARE(startsOf(c, task), starts);
        EnsembleTask other = task;
        other.seed = 8;
        QVERIFY(startsOf(c, other) != starts);
    }

    /// Wilson 1927 at z = 1.96. Of 10 out of 10: lower = 1/(1 + z^2/10) = 0.72246; of 0 it is the mirror image. Of 150
    /// out of 300: middle 1/2, half = z/(1 + z^2/300) sqrt(1/1200 + z^2/360000) = 0.0562215.
    void wilsonIntervals()
    {
        QVERIFY(std::abs(shareOf(10, 10).lower - 0.72246) < 1e-5);
        QCOMPARE(shareOf(10, 10).upper, 1.0);
        QVERIFY(std::abs(shareOf(0, 10).upper - (1.0 - 0.72246)) < 1e-5);
        QCOMPARE(shareOf(150, 300).share, 0.5);
        QVERIFY(std::abs(shareOf(150, 300).upper - 0.5562215) < 1e-6);
    }

    /// 100 starts; the first way ends 30 of them in class 1 where the second does not (b), and c the other way. b - c
    /// over 100, with the error sqrt(b + c)/100. 30 against 0 is certain: 29 > 2 sqrt(30) = 10.95; 30 against 28 is
    /// not: 1 < 2 sqrt(58).
    void sharesAreComparedStartByStart()
    {
        std::vector<std::size_t> first(100, 0), second(100, 0);
        for (std::size_t i = 0; i < 30; ++i) first[i] = 1;
        const ShareDifference certain = shareDifference(first, second, 1);
        QCOMPARE(certain.difference, 0.3);
        QVERIFY(std::abs(certain.error - 0.01 * std::sqrt(30.0)) < 1e-15);
        QVERIFY(certain.significant);
        QCOMPARE(otherwise(first, second), std::size_t{30});

        for (std::size_t i = 40; i < 68; ++i) second[i] = 1;
        QVERIFY(std::abs(shareDifference(first, second, 1).difference - 0.02) < 1e-15);
        QVERIFY(!shareDifference(first, second, 1).significant);
        QCOMPARE(otherwise(first, second), std::size_t{58});
    }

    /// 4 against 0: 3 < 2 sqrt(4). Such a thing happens once in eight times where the shares are the same (2/2^4).
    void aHandfulIsNoDifference()
    {
        std::vector<std::size_t> first(100, 0);
        const std::vector<std::size_t> second(100, 0);
        for (std::size_t i = 0; i < 4; ++i) first[i] = 1;
        QVERIFY(!shareDifference(first, second, 1).significant);
    }

    void endsAreGroupedByKindAndSpacing()
    {
        std::vector<Ensemble> all(2);
        all[0].ends = {flying(7e-9), flying(7.05e-9), flying(3e-9), failed(RunFailure::Chattering)};
        all[1].ends = {
            flying(7.1e-9), flying(7e-9), {.state = {EndKind::Contact, 3e-9, 0.0}}, failed(RunFailure::Diverged)};
        const EndClasses ends = classifyEnds(all);
        QCOMPARE(ends.classes.size(), std::size_t{5});
        QCOMPARE(ends.classes[0].name, std::string("flying at 7.04 nm"));
        QCOMPARE(ends.of[0][0], ends.of[1][0]);
        QCOMPARE(ends.of[0][0], ends.of[0][1]);
        QVERIFY(ends.of[0][2] != ends.of[1][2]);
        QVERIFY(ends.of[0][3] != ends.of[1][3]);
        QCOMPARE(ends.classes[ends.of[0][3]].name, std::string("failed: chattering"));
    }

    void outcomeDoesNotDependOnTheThreads()
    {
        Case c = sample("fig10b");
        c.run.duration = 0.1e-3;
        const auto run = [&](int jobs) {
            std::vector<Ensemble> all{{"dopri5", "", c, {}}};
            if (!runEnsembles(all, {.key = "initial.flying_height", .starts = 12, .spread = 0.5e-9}, jobs, always))
                qFatal("stopped");
            return all.front().ends;
        };
        const std::vector<EnsembleEnd> one = run(1), three = run(3);
        QCOMPARE(one.size(), std::size_t{12});
        for (std::size_t i = 0; i < one.size(); ++i) {
            QCOMPARE(one[i].state.spacing, three[i].state.spacing);
            QCOMPARE(one[i].state.spread, three[i].state.spread);
            QCOMPARE(one[i].work, three[i].work);
        }
    }

    /// Energy is lost at every bounce, so that a slider that starts close to its static state ends there, wherever
    /// exactly it starts.
    void allOfAQuietEnsembleEndAlike()
    {
        Case c = sample("fig10a");
        c.initial.flyingHeight = 20e-9;
        c.initial.pitch = c.springs.pitch;
        std::vector<Ensemble> all{{"dopri5", "", c, {}}};
        QVERIFY(runEnsembles(all, {.key = "initial.flying_height", .starts = 8, .spread = 0.5e-9}, 2, always));
        const EndClasses ends = classifyEnds(all);
        QCOMPARE(ends.classes.size(), std::size_t{1});
        QCOMPARE(ends.classes[0].name, std::string("flying at 7 nm"));
    }

    void stops()
    {
        std::vector<Ensemble> all{{"dopri5", "", sample("fig10a"), {}}};
        QVERIFY(!runEnsembles(all, {.key = "initial.flying_height", .starts = 1000, .spread = 0.5e-9}, 2,
                              [](std::size_t, double) { return false; }));
    }
};

TOUCHDOWN_TEST(TestEnsemble)

} // namespace test_ensemble

#include "test_ensemble.moc"
