// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_statistics.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/contact_kind.h"
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

    /// 100 kHz over 2 ms: 20 periods in the last tenth.
    void motion_data()
    {
        QTest::addColumn<double>("swing"); // amplitude at the end [m]
        QTest::addColumn<double>("decay"); // over the last tenth [-]
        QTest::addColumn<int>("expected");
        QTest::addColumn<double>("early"); // amplitude of the first half, of the later one [-]
        QTest::addColumn<double>("touch"); // contact force while the minimum spacing is below 7 nm [N]
        const auto row = [](const char* title, double swing, double decay, Motion expected, double early,
                            double touch) {
            QTest::newRow(title) << swing << decay << static_cast<int>(expected) << early << touch;
        };
        row("at rest", 0.0, 1.0, Motion::AtRest, 1.0, 0.0);
        row("constant swing", 1e-9, 1.0, Motion::Swings, 1.0, 0.0);
        row("constant swing that touches", 1e-9, 1.0, Motion::Bounces, 1.0, 1e-3);
        row("constant after a larger one", 1e-9, 1.0, Motion::Bounces, 10.0, 1e-3);
        row("growing swing", 1e-9, 1.5, Motion::Swings, 1.0, 0.0);
        row("decaying swing", 1e-9, 0.7, Motion::Settles, 1.0, 0.0);
        row("decaying swing that still takes off", 1e-9, 0.7, Motion::TooShort, 1.0, 1e-3);
        row("too small to matter", 0.005e-9, 1.0, Motion::AtRest, 1.0, 1e-3);
    }
    void motion()
    {
        QFETCH(double, swing);
        QFETCH(double, decay);
        QFETCH(int, expected);
        QFETCH(double, touch);
        QFETCH(double, early);
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        RunStatistics statistics(c, quantities);
        std::vector<double> values(quantities.size());
        const int count = 20001;
        for (int i = 0; i < count; ++i) {
            const double t = 1e-7 * i;
            const double amplitude =
                swing * std::pow(decay, 10.0 * (double(i) / count - 1.0)) * (2 * i < count ? early : 1.0);
            const double spacing = 7e-9 + amplitude * std::sin(2 * std::numbers::pi * 100e3 * t);
            values.assign(values.size(), spacing);
            values[static_cast<std::size_t>(findQuantity(quantities, "adhesion_force"))] = 0.0;
            values[static_cast<std::size_t>(findQuantity(quantities, "contact_force"))] = spacing < 7e-9 ? touch : 0.0;
            statistics.addSample(t, values, values, values);
        }
        Summary summary;
        statistics.finish(summary);
        QCOMPARE(static_cast<int>(summary.verdict.motion), expected);
        QVERIFY(!summary.verdict.rule.empty());
        if (swing > 0.1e-9) QVERIFY(std::abs(summary.peaks.front().frequency - 100e3) < 1e3);
        // Quantities that this model lacks are absent, not zero.
        for (const auto& [name, tail] : summary.tail) QVERIFY(name != "roll");
    }
    /// The same motion, cut off: its last third holds 2 or 4 periods, or its last tenth 4, whenever the spectrum
    /// starts.
    void aShortRun()
    {
        for (const double periods : {0.6, 1.2, 4.0}) // in a tenth
            for (const double start : {0.0, 0.98}) {
                Case c;
                const double period = 1e-5, duration = 10.0 * periods * period;
                c.spectrum.start = start * duration;
                const std::vector<Quantity> quantities = recordedQuantities(c);
                RunStatistics statistics(c, quantities);
                c.run.sampleInterval = duration / 10000;
                for (int i = 0; i <= 10000; ++i) {
                    const double t = duration * i / 10000;
                    const std::vector<double> values(quantities.size(),
                                                     7e-9 + 1e-9 * std::sin(2 * std::numbers::pi * t / period));
                    statistics.addSample(t, values, values, values);
                }
                Summary summary;
                summary.endTime = duration;
                statistics.finish(summary);
                QCOMPARE(summary.verdict.motion, periods > 1.0 ? Motion::Vibrates : Motion::TooShort);
                QVERIFY(!summary.bouncing());
                QCOMPARE(summary.verdict.rule.find("last tenth") != std::string::npos, periods == 4.0);
            }
    }
    /// Extremes between samples reach the tail, the whole run and the swing; those before the tail do not reach it.
    void extremesBetweenSamples()
    {
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        RunStatistics statistics(c, quantities);
        const std::vector<double> values(quantities.size(), 7e-9), low(quantities.size(), 6e-9),
            high(quantities.size(), 9e-9);
        for (int i = 0; i < 1000; ++i)
            statistics.addSample(1e-7 * i, values, i == 100 ? low : values, i == 999 ? high : values);
        Summary summary;
        statistics.finish(summary);
        for (const auto& [name, tail] : summary.tail) {
            QCOMPARE(tail.min, 7e-9);
            QCOMPARE(tail.max, 9e-9);
            QCOMPARE(tail.mean, 7e-9);
        }
        QCOMPARE(summary.extremes.size(), quantities.size());
        for (const auto& [name, extremes] : summary.extremes) {
            QCOMPARE(extremes.least, 6e-9);
            QCOMPARE(extremes.most, 9e-9);
        }
    }
    /// Menisci hold a pad that its asperities do not touch; adhesion of surfaces acts from afar.
    void touching()
    {
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        const auto between = [&](ContactKind contact, Extremes force, Extremes adhesion) {
            c.contact = contact;
            std::vector<double> least(quantities.size()), most(quantities.size());
            const auto set = [&](const char* name, Extremes value) {
                least[static_cast<std::size_t>(findQuantity(quantities, name))] = value.least;
                most[static_cast<std::size_t>(findQuantity(quantities, name))] = value.most;
            };
            set("contact_force", force);
            set("adhesion_force", adhesion);
            return TouchColumns(c, quantities).between(least, most);
        };
        using enum ContactKind;
        QCOMPARE(between(OnoYamane, {0, 0}, {0, 0}), Touch::Never);
        QCOMPARE(between(OnoYamane, {1e-3, 2e-3}, {-1e-3, -1e-3}), Touch::Always);
        QCOMPARE(between(OnoYamane, {0, 0}, {-1e-3, -1e-3}), Touch::Always);
        QCOMPARE(between(OnoYamane, {0, 1e-3}, {-1e-3, 0}), Touch::AtTimes);
        QCOMPARE(between(MultiAsperity, {0, 0}, {-1e-3, 0}), Touch::AtTimes);
        QCOMPARE(between(Elastic, {0, 1e-3}, {-1e-3, -1e-3}), Touch::AtTimes);
        QCOMPARE(between(Elastic, {0, 0}, {-1e-3, -1e-3}), Touch::Never);
    }
    /// The first sample of the tail does not bring what was before it.
    void theTailIsTheTail()
    {
        Case c;
        c.run.duration = 1e-3;
        c.run.sampleInterval = 0.1e-3;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        RunStatistics statistics(c, quantities);
        const std::vector<double> values(quantities.size(), 7e-9), high(quantities.size(), 250e-9);
        for (int i = 0; i <= 10; ++i) statistics.addSample(1e-4 * i, values, values, i <= 9 ? high : values);
        Summary summary;
        statistics.finish(summary);
        for (const auto& [name, tail] : summary.tail) QCOMPARE(tail.max, 7e-9);
        for (const auto& [name, extremes] : summary.extremes) QCOMPARE(extremes.most, 250e-9);
    }
    /// Also where nine tenths of the duration and the time of the sample there round to different numbers.
    void theTailIsTheTailForAnyDuration()
    {
        for (int tens = 1; tens <= 300; ++tens) {
            Case c;
            c.run.sampleInterval = 0.1e-6;
            c.run.duration = tens * 1e-6;
            const std::vector<Quantity> quantities = recordedQuantities(c);
            RunStatistics statistics(c, quantities);
            const std::vector<double> values(quantities.size(), 7e-9), high(quantities.size(), 250e-9);
            for (int i = 0; i <= 10 * tens; ++i)
                statistics.addSample(i * c.run.sampleInterval, values, values, i <= 9 * tens ? high : values);
            Summary summary;
            statistics.finish(summary);
            for (const auto& [name, tail] : summary.tail) QCOMPARE(tail.max, 7e-9);
        }
    }
    /// The end of a run that failed is outside the model: there is nothing to judge.
    void aFailedRunIsNotJudged()
    {
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        RunStatistics statistics(c, quantities);
        const std::vector<double> values(quantities.size(), 7e-9);
        for (int i = 0; i < 1000; ++i) statistics.addSample(1e-7 * i, values, values, values);
        for (const RunStatus status : {RunStatus::Completed, RunStatus::Failed, RunStatus::Diverged}) {
            Summary summary;
            summary.status = status;
            statistics.finish(summary);
            QCOMPARE(summary.verdict.motion, status == RunStatus::Completed ? Motion::AtRest : Motion::NotJudged);
        }
    }
    void nothingFromNothing()
    {
        Case c;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        Summary summary;
        RunStatistics(c, quantities).finish(summary);
        QVERIFY(summary.tail.empty() && summary.peaks.empty() && summary.verdict.motion == Motion::NotJudged);
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
