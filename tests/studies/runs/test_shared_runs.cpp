// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/shared_runs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

#include <QTest>

#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_shared_runs {

/// A drop from this height [nm], of 20 us.
Case drop(double height)
{
    Case c = sample("fig10a");
    c.run.duration = 20e-6;
    c.initial.flyingHeight = height * 1e-9;
    return c;
}
const GoOn always = [] { return true; };

class TestSharedRuns : public QObject {
    Q_OBJECT

private slots:
    void theSameCaseIsOneRun()
    {
        SharedRuns runs;
        const std::size_t a = runs.add(drop(10.0), "flying_height"), b = runs.add(drop(20.0));
        QCOMPARE(runs.add(drop(10.0), "pitch"), a);
        QVERIFY(b != a);
        Case elsewhere = drop(10.0);
        elsewhere.folder = "/elsewhere"; // its surface may be another file
        QVERIFY(runs.add(elsewhere) != a);
        QVERIFY(runs.make(std::array{a}, always));
        const MeasuredRun direct = measureRun(drop(10.0), {"flying_height", "pitch"});
        QCOMPARE(runs.run(a).columns[runs.columnOf(a, "flying_height")], direct.columns[0]);
        QCOMPARE(runs.run(a).columns[runs.columnOf(a, "pitch")], direct.columns[1]);
    }

    /// Four threads want all of eight runs at once: each is made once, which the shares tell, and they are the same.
    void eachIsMadeOnce()
    {
        SharedRuns runs;
        std::vector<std::size_t> all;
        for (int k = 0; k < 8; ++k) all.push_back(runs.add(drop(10.0 + k), "flying_height"));
        std::atomic<int> ends = 0;
        const auto want = [&](std::size_t, const GoOn& goOn) {
            double last = 0.0;
            const auto tell = [&](double share) {
                if (share < last || share > 1.0) qFatal("the share goes back");
                // An end is a whole eighth more than others have made.
                if (std::abs(8.0 * share - std::round(8.0 * share)) < 1e-12 && share > last) ++ends;
                last = share;
            };
            if (!runs.make(all, goOn, tell)) qFatal("it was not told to end");
        };
        QVERIFY(runParallel(4, 4, want, [](std::size_t) { return true; }));
        QVERIFY2(ends >= 8, std::to_string(ends).c_str());
        for (int k = 0; k < 8; ++k)
            QCOMPARE(runs.run(all[std::size_t(k)]).columns[0],
                     measureRun(drop(10.0 + k), {"flying_height"}).columns[0]);
    }

    /// A run that was told to end is made again by the next one that wants it; a thread that waits ends, too.
    void endsAndBeginsAgain()
    {
        SharedRuns runs;
        Case c = drop(10.0);
        c.run.duration = 10.0; // far longer than this test
        const std::size_t run = runs.add(c);
        const auto want = [&](std::size_t, const GoOn& goOn) {
            if (runs.make(std::array{run}, goOn)) qFatal("it cannot be there");
        };
        std::atomic<int> polls = 0;
        QVERIFY(!runParallel(2, 2, want, [&](std::size_t) { return ++polls < 3; }));
        QVERIFY(!runs.make(std::array{run}, [] { return false; }));
    }

    void forgets()
    {
        SharedRuns runs;
        const std::size_t run = runs.add(drop(10.0), "flying_height");
        QVERIFY(runs.make(std::array{run}, always));
        const std::vector<double> before = runs.run(run).columns[0];
        runs.forget();
        QVERIFY(runs.run(run).columns.empty());
        QVERIFY(runs.make(std::array{run}, always));
        QCOMPARE(runs.run(run).columns[0], before);
    }
};

TOUCHDOWN_TEST(TestSharedRuns)

} // namespace test_shared_runs

#include "test_shared_runs.moc"
