// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sample_times.h"

#include <algorithm>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_sample_times {

class TestSampleTimes : public QObject {
    Q_OBJECT

private slots:
    /// Against the standard library, with times that come twice and three times, also across blocks.
    void searchesAsTheStandardLibrary_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {0, 1, 63, 64, 65, 128, 129, 1000}) QTest::addRow("%d", count) << count;
    }
    void searchesAsTheStandardLibrary()
    {
        QFETCH(int, count);
        SampleTimes times;
        std::vector<double> all;
        for (int i = 0; i < count; ++i) {
            all.push_back(static_cast<double>((i / 3) + (i / 65)));
            times.push_back(all.back());
        }
        for (double time = -1.0; time < count; time += 0.5) {
            const auto lower = static_cast<std::size_t>(std::ranges::lower_bound(all, time) - all.begin());
            const auto upper = static_cast<std::size_t>(std::ranges::upper_bound(all, time) - all.begin());
            QCOMPARE(times.lowerBound(time), lower);
            QCOMPARE(times.upperBound(time), upper);
            const std::size_t block = times.blockFrom(time);
            QVERIFY(block * SampleTimes::blockSize >= all.size() || all[block * SampleTimes::blockSize] >= time);
            QVERIFY(block == 0 || all[(block - 1) * SampleTimes::blockSize] < time);
            for (std::size_t from = 0; from <= block; ++from) QCOMPARE(times.blockFrom(time, from), block);
        }
    }

    void copiesTheFirst()
    {
        SampleTimes times;
        for (int i = 0; i < 200; ++i) times.push_back(i);
        const SampleTimes part(times, 100);
        QCOMPARE(part.size(), std::size_t(100));
        QCOMPARE(part[99], 99.0);
        QCOMPARE(part.lowerBound(150.0), std::size_t(100));
    }
};

TOUCHDOWN_TEST(TestSampleTimes)

} // namespace test_sample_times

#include "test_sample_times.moc"
