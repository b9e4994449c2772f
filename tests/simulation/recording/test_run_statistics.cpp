// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_statistics.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/simulation/run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_statistics {

class TestRunStatistics : public QObject {
    Q_OBJECT

private slots:
    /// A ramp 0, 1, ..., n - 1: any share of it has a known mean, spread and ends; blocks are merged along the way.
    void ramp_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("few") << 1000;
        QTest::newRow("merged many times") << 1000000;
    }
    void ramp()
    {
        QFETCH(int, count);
        BlockStatistics blocks;
        for (int i = 0; i < count; ++i) blocks.add(double(i));
        const Statistics tail = blocks.over(0.9, 1.0);
        const double resolution = count / 1000.0; // blocks are at most 1/2048 of all
        QVERIFY(std::abs(tail.min - 0.9 * count) <= resolution);
        QCOMPARE(tail.max, double(count - 1));
        QVERIFY(std::abs(tail.mean - 0.95 * count) <= resolution);
        // Uniform over a tenth: 0.1 n/sqrt 12
        QVERIFY(std::abs(tail.std - 0.1 * count / std::sqrt(12.0)) <= resolution);
    }
    void oneSample()
    {
        BlockStatistics blocks;
        blocks.add(3.0);
        const Statistics all = blocks.over(0.9, 1.0);
        QCOMPARE(all.mean, 3.0);
        QCOMPARE(all.std, 0.0);
        QCOMPARE(all.min, all.max);
    }

    void bouncing_data()
    {
        QTest::addColumn<double>("swing"); // amplitude at the end [m]
        QTest::addColumn<double>("decay"); // over the last tenth [-]
        QTest::addColumn<bool>("bouncing");
        QTest::addColumn<double>("early"); // amplitude of the first half, of the later one [-]
        QTest::newRow("at rest") << 0.0 << 1.0 << false << 1.0;
        QTest::newRow("constant swing") << 1e-9 << 1.0 << true << 1.0;
        QTest::newRow("constant after a larger one") << 1e-9 << 1.0 << true << 10.0;
        QTest::newRow("growing swing") << 1e-9 << 1.5 << true << 1.0;
        QTest::newRow("decaying swing") << 1e-9 << 0.7 << false << 1.0;
        QTest::newRow("too small to matter") << 0.005e-9 << 1.0 << false << 1.0;
    }
    void bouncing()
    {
        QFETCH(double, swing);
        QFETCH(double, decay);
        QFETCH(bool, bouncing);
        QFETCH(double, early);
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        RunStatistics statistics(c, quantities);
        SampleBatch batch;
        batch.columns.resize(quantities.size());
        const int count = 20001;
        for (int i = 0; i < count; ++i) {
            const double t = 1e-7 * i;
            batch.time.push_back(t);
            const double amplitude =
                swing * std::pow(decay, 10.0 * (double(i) / count - 1.0)) * (2 * i < count ? early : 1.0);
            for (auto& column : batch.columns)
                column.push_back(7e-9 + amplitude * std::sin(2 * std::numbers::pi * 100e3 * t));
        }
        statistics.add(batch);
        Summary summary;
        statistics.finish(summary);
        QCOMPARE(summary.bouncing, bouncing);
        QVERIFY(!summary.bouncingRule.empty());
        if (bouncing) QVERIFY(std::abs(summary.peaks.front().frequency - 100e3) < 1e3);
        // Quantities that this model lacks are absent, not zero.
        for (const auto& [name, tail] : summary.tail) QVERIFY(name != "roll");
    }
    void nothingFromNothing()
    {
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        Summary summary;
        RunStatistics(c, quantities).finish(summary);
        QVERIFY(summary.tail.empty() && summary.peaks.empty() && !summary.bouncing);
    }
    void welchOptionsOfACase()
    {
        SpectrumCase spectrum;
        spectrum.segment = 0.2e-3;
        QCOMPARE(welchOptions(spectrum, 1e-7).segment, std::size_t{2000});
        spectrum.segment = 1e-9;
        QCOMPARE(welchOptions(spectrum, 1e-7).segment, std::size_t{8});
        spectrum.segment = 100.0;
        QCOMPARE(welchOptions(spectrum, 1e-300).segment, std::size_t{1'000'000'000'000'000}); // all there is
    }
};

TOUCHDOWN_TEST(TestRunStatistics)

} // namespace test_run_statistics

#include "test_run_statistics.moc"
