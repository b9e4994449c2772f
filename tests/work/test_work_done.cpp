// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/work_done.h"

#include <cmath>
#include <thread>
#include <vector>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_work_done {

class TestWorkDone : public QObject {
    Q_OBJECT

private slots:
    /// Costs 3 and 1: half of the first run and all of the second are (1.5 + 1)/4.
    void runsCountByTheirCost()
    {
        WorkDone work({3.0, 1.0});
        QCOMPARE(work.share(), 0.0);
        const ShareTeller first = work.teller(0), second = work.teller(1);
        first(0.5);
        QCOMPARE(work.share(), 0.375);
        second(1.0);
        QCOMPARE(work.share(), 0.625);
        first(0.9); // a teller replaces what it said
        first(2.0); // no more than all
        QCOMPARE(work.share(), 1.0);
    }
    void nothingIsAllDone()
    {
        QCOMPARE(WorkDone({}).share(), 1.0);
        QCOMPARE(WorkDone({0.0}).share(), 1.0);
    }
    /// Eight threads of 1000 tellings each lose none.
    void threadsTellAtTheSameTime()
    {
        WorkDone work(std::vector<double>(8, 1.0));
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 0; i < 8; ++i)
                threads.emplace_back([tell = work.teller(i)] {
                    for (int k = 1; k <= 1000; ++k) tell(k / 1000.0);
                });
        }
        QVERIFY(std::abs(work.share() - 1.0) < 1e-12);
    }
};

TOUCHDOWN_TEST(TestWorkDone)

} // namespace test_work_done

#include "test_work_done.moc"
