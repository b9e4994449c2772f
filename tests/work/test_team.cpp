// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/team.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <new>
#include <numeric>
#include <thread>
#include <vector>

#include <QTest>

#include "core/work/block_sums.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_team {

class TestTeam : public QObject {
    Q_OBJECT

private slots:
    void everyBlockOnce_data()
    {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3, 4, 7, 32}) QTest::addRow("%d", threads) << threads;
    }
    void everyBlockOnce()
    {
        QFETCH(int, threads);
        const TeamScope scope(threads);
        Team& team = Team::mine();
        QCOMPARE(team.size(), threads);
        for (int loop = 0; loop < 2000; ++loop) {
            const int blocks = loop % (Team::mostBlocks + 1);
            std::array<std::atomic<int>, Team::mostBlocks> calls{};
            std::atomic<bool> known = true;
            team.run(blocks, [&](int b, int thread) {
                ++calls[static_cast<std::size_t>(b)];
                if (thread < 0 || thread >= threads) known = false;
            });
            QVERIFY(known);
            for (int b = 0; b < Team::mostBlocks; ++b) QCOMPARE(calls[static_cast<std::size_t>(b)], b < blocks ? 1 : 0);
        }
    }

    /// What a loop wrote is there in the next one, whoever did it.
    void loopsSeeEachOther()
    {
        const TeamScope scope(3);
        std::vector<int> value(3000, 0);
        for (int loop = 0; loop < 1000; ++loop)
            Team::mine().items(3000, 8, 1, [&](int first, int end, int) {
                for (int k = first; k < end; ++k) value[static_cast<std::size_t>(k)] += k + loop;
            });
        for (int k = 0; k < 3000; ++k) QCOMPARE(value[static_cast<std::size_t>(k)], 1000 * k + 999 * 500);
    }

    void blocksCoverAllItems_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("blocks");
        QTest::addColumn<int>("multiple");
        QTest::newRow("equal parts") << 64 << 4 << 1;
        QTest::newRow("a remainder") << 195 << 7 << 1;
        QTest::newRow("multiples of 16") << 195 << 4 << 16;
        QTest::newRow("fewer groups than blocks") << 20 << 4 << 16;
    }
    void blocksCoverAllItems()
    {
        QFETCH(int, count);
        QFETCH(int, blocks);
        QFETCH(int, multiple);
        int next = 0;
        for (int b = 0; b < blocks; ++b) {
            const Block block = Team::block(count, b, blocks, multiple);
            QCOMPARE(block.first, next);
            QVERIFY(block.first % multiple == 0 || block.first == count);
            next = block.end;
        }
        QCOMPARE(next, count);
    }

    void smallLoopsStayWhole()
    {
        const TeamScope scope(4);
        QCOMPARE(Team::mine().blocksOf(47, 24), 1);
        QCOMPARE(Team::mine().blocksOf(48, 24), 2);
        QCOMPARE(Team::mine().blocksOf(1000, 24), 4);
        QCOMPARE(Team::mine().blocksOf(1000, 24, 2), 8);
    }

    /// A loop within a block is done by the block's thread.
    void loopWithinLoop()
    {
        const TeamScope scope(3);
        std::atomic<int> sum = 0;
        Team::mine().run(6, [&](int b, int) {
            Team::mine().run(4, [&](int inner, int thread) { sum += thread == 0 ? 10 * b + inner : 1000000; });
        });
        QCOMPARE(sum, 6 * (0 + 1 + 2 + 3) + 10 * 4 * (0 + 1 + 2 + 3 + 4 + 5));
    }

    /// As where memory runs out: the other blocks end first, and the team goes on.
    void whatABlockThrows()
    {
        const TeamScope scope(3);
        for (int loop = 0; loop < 200; ++loop) {
            std::atomic<int> ended = 0;
            QVERIFY_EXCEPTION_THROWN(Team::mine().run(9,
                                                      [&](int b, int) {
                                                          if (b % 4 == loop % 4) throw std::bad_alloc();
                                                          ++ended;
                                                      }),
                                     std::bad_alloc);
            QVERIFY(ended <= 7);
            Team::mine().run(9, [&](int, int) { ++ended; });
            QVERIFY(ended >= 9);
        }
    }

    void scopes()
    {
        QCOMPARE(Team::mine().size(), 1);
        {
            const TeamScope scope(3);
            const Team* outer = &Team::mine();
            QCOMPARE(Team::mine().size(), 3);
            {
                const TeamScope inner(5);
                QCOMPARE(&Team::mine(), outer);
            }
            QCOMPARE(&Team::mine(), outer);
            int elsewhere = 0;
            std::thread([&] { elsewhere = Team::mine().size(); }).join();
            QCOMPARE(elsewhere, 1);
        }
        QCOMPARE(Team::mine().size(), 1);
    }

    /// Workers that have gone to sleep come back, and a scope ends while they sleep.
    void sleepingWorkers()
    {
        const TeamScope scope(3);
        std::atomic<int> calls = 0;
        for (int pause = 0; pause < 5; ++pause) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            Team::mine().run(9, [&](int, int) { ++calls; });
        }
        QCOMPARE(calls, 45);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }

    /// Rounding shows any other order: the terms span many decades.
    void sumsHaveTheSameBits()
    {
        std::vector<double> term(50001);
        for (std::size_t k = 0; k < term.size(); ++k) term[k] = std::sin(1.0 + double(k)) * std::exp(double(k % 31));
        const auto sum = [&] {
            return sumOfBlocks(term.size(), [&](std::size_t first, std::size_t count) {
                return std::accumulate(&term[first], &term[first] + count, 0.0);
            });
        };
        const double alone = sum();
        for (const int threads : {2, 3, 4, 7}) {
            const TeamScope scope(threads);
            for (int k = 0; k < 20; ++k) QCOMPARE(sum() - alone, 0.0);
        }
    }

    void threadShares()
    {
        const int all = threadShare();
        QVERIFY(all >= 1);
        QCOMPARE(threadLimit(), Team::mostThreads);
        std::thread([&] {
            QCOMPARE(threadShare(), all);
            setThreadShare(3);
            QCOMPARE(threadShare(), 3);
            QCOMPARE(threadLimit(), Team::mostThreads);
            setThreadShare(0, 2);
            QCOMPARE(threadShare(), 1);
            QCOMPARE(threadLimit(), 2);
        }).join();
        QCOMPARE(threadShare(), all);
    }
};

TOUCHDOWN_TEST(TestTeam)

} // namespace test_team

#include "test_team.moc"
