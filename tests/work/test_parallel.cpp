// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <new>
#include <numeric>
#include <thread>
#include <vector>

#include <QTest>

#include "core/work/team.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_parallel {

class TestParallel : public QObject {
    Q_OBJECT

private slots:
    void everyTaskOnce_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("jobs");
        QTest::newRow("none") << 0 << 4;
        QTest::newRow("one after the other") << 20 << 1;
        QTest::newRow("three at a time") << 20 << 3;
        QTest::newRow("more threads than tasks") << 2 << 8;
        QTest::newRow("no thread asked for counts as one") << 3 << 0;
    }
    void everyTaskOnce()
    {
        QFETCH(int, count);
        QFETCH(int, jobs);
        std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
        std::atomic<int> atOnce = 0, most = 0;
        std::size_t told = 0;
        const auto task = [&](std::size_t i, const GoOn& goOn) {
            const int now = ++atOnce;
            for (int before = most; before < now && !most.compare_exchange_weak(before, now);) {
            }
            if (goOn()) ++calls[i];
            --atOnce;
        };
        const bool ended = runParallel(calls.size(), jobs, task, [&](std::size_t done) {
            told = std::max(told, done);
            return true;
        });
        QVERIFY(ended);
        for (const auto& each : calls) QCOMPARE(each.load(), 1);
        QVERIFY(most <= std::max(jobs, 1));
        QVERIFY(told <= calls.size());
    }

    /// As of a solution that does not fit into the memory: it ends the others and reaches the caller.
    void whatATaskThrowsIsThrownOn()
    {
        std::atomic<int> begun = 0;
        const auto task = [&](std::size_t i, const GoOn& goOn) {
            ++begun;
            if (i == 1) throw std::bad_alloc();
            while (goOn()) std::this_thread::yield();
        };
        QVERIFY_EXCEPTION_THROWN(runParallel(1000, 2, task, [](std::size_t) { return true; }), std::bad_alloc);
        QCOMPARE(begun.load(), 2);
    }

    void oneThreadKeepsTheOrder()
    {
        std::vector<std::size_t> order;
        QVERIFY(runParallel(
            5, 1, [&](std::size_t i, const GoOn&) { order.push_back(i); }, [](std::size_t) { return true; }));
        std::vector<std::size_t> rising(5);
        std::iota(rising.begin(), rising.end(), std::size_t{0});
        QCOMPARE(order, rising);
    }

    /// Each task waits to be told: without a stop it would not end at all.
    void stops()
    {
        std::atomic<int> begun = 0;
        const auto waitForStop = [&](std::size_t, const GoOn& goOn) {
            ++begun;
            while (goOn()) {
            }
        };
        QVERIFY(!runParallel(10, 2, waitForStop, [&](std::size_t done) { return done > 0 || begun < 2; }));
        QCOMPARE(begun.load(), 2);
    }

    /// Each number once; of 100, the first 20 lie in all five fifths, four each but for one.
    void aScatteredOrderIsSpreadEvenly()
    {
        for (const std::size_t count : {0, 1, 2, 3, 6, 100, 441}) {
            std::vector<std::size_t> order = scatteredOrder(count);
            std::ranges::sort(order);
            std::vector<std::size_t> all(count);
            std::iota(all.begin(), all.end(), std::size_t{0});
            QVERIFY(order == all);
        }
        std::array<int, 5> fifths{};
        const std::vector<std::size_t> order = scatteredOrder(100);
        for (std::size_t i = 0; i < 20; ++i) ++fifths[order[i] / 20];
        for (const int count : fifths) QVERIFY(count >= 3 && count <= 5);
    }

    /// What a task computes may use its part of the cores, and no more where it asks for more.
    void tasksShareTheCores_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("jobs");
        QTest::addColumn<int>("share");
        QTest::newRow("one at a time") << 3 << 1 << 8;
        QTest::newRow("three at a time") << 6 << 3 << 2;
        QTest::newRow("fewer tasks than jobs") << 2 << 8 << 4;
        QTest::newRow("more jobs than cores") << 40 << 20 << 1;
    }
    void tasksShareTheCores()
    {
        QFETCH(int, count);
        QFETCH(int, jobs);
        QFETCH(int, share);
        std::atomic<bool> same = true;
        std::thread([&] {
            setThreadShare(8);
            runParallel(
                static_cast<std::size_t>(count), jobs,
                [&](std::size_t, const GoOn&) {
                    if (threadShare() != share || threadLimit() != share) same = false;
                },
                [](std::size_t) { return true; });
            if (threadShare() != 8) same = false;
        }).join();
        QVERIFY(same);
    }
};

TOUCHDOWN_TEST(TestParallel)

} // namespace test_parallel

#include "test_parallel.moc"
