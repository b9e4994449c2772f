// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <cmath>
#include <numbers>

#include "core/studies/advice/tail_estimate.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_tail_estimate {

class TestTailEstimate : public QObject {
    Q_OBJECT

private slots:
    void aWholeRunIsNotEstimated();
    void aLastSampleBeforeTheEndIsTheLast();
    void ringingGoesOn();
    void whatStaysStays();
    void whatDiesAwayDiesAway();
    void aMeanThatCreepsComesToItsEnd();
    void contactOfTheLastQuarter_data();
    void contactOfTheLastQuarter();
    void howLongABounceLastsIsNotKnown();
    void whatDriftsIsNotKnown();
    void aRateThatChangesIsNotKnown();
    void tooFewSamplesFail();
    void tooFewSamplesWithoutTheirLastHalfTellNothing();
};

constexpr double twoPi = 2.0 * std::numbers::pi;
constexpr double interval = 0.1e-6; // [s]
constexpr double frequency = 100e3; // [Hz]
constexpr double duration = 1e-3;   // [s]

SpacingSamples decaying(double until, double amplitude, double damping)
{
    SpacingSamples samples{.interval = interval, .spacing = {}, .touching = {}};
    const auto count = static_cast<std::size_t>(std::lround(until / interval)) + 1;
    for (std::size_t k = 0; k < count; ++k) {
        const double t = interval * static_cast<double>(k);
        samples.spacing.push_back(10e-9 + amplitude * std::exp(-damping * t) * std::sin(twoPi * frequency * t));
    }
    samples.touching.assign(count, 0);
    return samples;
}

/// Standard deviation over the last tenth of amplitude e^(-damping t) sin(omega t): the square's mean over whole
/// periods, where damping is far below omega, is amplitude^2/2 times the mean of e^(-2 damping t).
double tailSpread(double amplitude, double damping)
{
    const double g = 2.0 * damping, from = 0.9 * duration;
    return amplitude * std::sqrt(0.5 * (std::exp(-g * from) - std::exp(-g * duration)) / (g * (duration - from)));
}

// Ten whole periods of 100 samples and one sample more: it moves mean and square by a thousandth of the amplitude.
void TestTailEstimate::aWholeRunIsNotEstimated()
{
    const TailEstimate tail = estimateTail(decaying(duration, 1e-9, 0.0), duration);
    QVERIFY(std::abs(tail.mean - 10e-9) < 1e-12);
    QVERIFY(std::abs(tail.spread / (1e-9 / std::numbers::sqrt2) - 1.0) < 2e-3);
    QCOMPARE(tail.meanUncertainty, 0.0);
    QVERIFY(std::abs(tail.peakFrequency - frequency) < 0.1 * tail.resolution);
    QCOMPARE(tail.kind, EndKind::Flying);
}

// Every 0.6 us up to 1 ms: 1666 intervals end at 999.6 us, one less at 999 us.
void TestTailEstimate::aLastSampleBeforeTheEndIsTheLast()
{
    SpacingSamples samples{
        .interval = 0.6e-6, .spacing = std::vector<double>(1667), .touching = std::vector<char>(1667)};
    for (std::size_t k = 0; k < samples.spacing.size(); ++k)
        samples.spacing[k] = 10e-9 + 1e-12 * static_cast<double>(k % 7);
    QVERIFY(samples.reachEnd(duration));
    QCOMPARE(estimateTail(samples, duration).meanUncertainty, 0.0);
    samples.spacing.pop_back();
    samples.touching.pop_back();
    QVERIFY(!samples.reachEnd(duration));
    QVERIFY(
        !(SpacingSamples{.interval = 1e-6, .spacing = std::vector<double>(1000), .touching = {}}.reachEnd(duration)));
    QVERIFY(
        (SpacingSamples{.interval = 1e-6, .spacing = std::vector<double>(1001), .touching = {}}.reachEnd(duration)));
}

// Its mean over the tail, whole periods, is (e^(-3.6) - e^(-4))/(omega 0.1 ms) of the amplitude: 0.14 pm.
void TestTailEstimate::ringingGoesOn()
{
    constexpr double damping = 4e3; // [1/s]
    const TailEstimate tail =
        estimateTail(decaying(0.3 * duration, 1e-9, damping), duration, {{{-5e3, twoPi * 98e3}, false}});
    QVERIFY(std::abs(tail.mean - 10e-9) < 0.15e-12);
    QVERIFY(std::abs(tail.spread / tailSpread(1e-9, damping) - 1.0) < 5e-3); // damping/omega = 0.6 %
    QVERIFY(tail.spreadUncertainty < 1e-3 * tail.spread);
}

// Hann's window over x = 7.5 periods lets 1/(pi x (x^2 - 1)) = 8e-4 of a motion's amplitude pass into the mean.
void TestTailEstimate::whatStaysStays()
{
    const TailEstimate tail = estimateTail(decaying(0.3 * duration, 1e-9, 0.0), duration);
    QVERIFY(std::abs(tail.mean - 10e-9) < 1e-12);
    QVERIFY(std::abs(tail.spread / (1e-9 / std::numbers::sqrt2) - 1.0) < 1e-3);
}

// Where all blocks shrink by one factor their limit is zero, and the variance goes on with that factor, as it is wrong
// by the window's share, which grows over the 0.6 ms from the last block to the tail. Of the amplitude, 0.55 to 0.3 nm
// there, 8e-4 pass into each block's mean; that is led on by v_3/(v_1 - v_3) = 1.2 times the difference of two: in all
// below 1.5 pm.
void TestTailEstimate::whatDiesAwayDiesAway()
{
    constexpr double damping = 4e3; // [1/s]
    const TailEstimate tail = estimateTail(decaying(0.3 * duration, 1e-9, damping), duration);
    QVERIFY(std::abs(tail.spread / tailSpread(1e-9, damping) - 1.0) < 0.01);
    QVERIFY(std::abs(tail.mean - 10e-9) < 1.5e-12);
}

// 1 nm that decays within 100 us and nothing else: each block's mean is one factor nearer to the limit, so that the
// limit is exact, and over the tail (e^(-9) - e^(-10))/1 of it are left, 0.08 pm.
void TestTailEstimate::aMeanThatCreepsComesToItsEnd()
{
    SpacingSamples samples{.interval = interval, .spacing = {}, .touching = std::vector<char>(3001, 1)};
    for (std::size_t k = 0; k < 3001; ++k)
        samples.spacing.push_back(2e-9 + 1e-9 * std::exp(-1e4 * interval * static_cast<double>(k)));
    const TailEstimate tail = estimateTail(samples, duration);
    QVERIFY(std::abs(tail.mean - 2e-9) < 0.1e-12);
    QCOMPARE(tail.kind, EndKind::Contact);
}

void TestTailEstimate::contactOfTheLastQuarter_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<int>("kind");
    QTest::newRow("never") << 2.0 << 2.0 << static_cast<int>(EndKind::Flying);
    QTest::newRow("before it") << 0.0 << 0.5 << static_cast<int>(EndKind::Flying);
    QTest::newRow("all of it") << 0.6 << 2.0 << static_cast<int>(EndKind::Contact);
    QTest::newRow("a part of it") << 0.8 << 0.9 << static_cast<int>(EndKind::Intermittent);
}

void TestTailEstimate::contactOfTheLastQuarter()
{
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(int, kind);
    SpacingSamples samples = decaying(0.3 * duration, 1e-9, 0.0);
    const double count = static_cast<double>(samples.touching.size());
    for (std::size_t k = 0; k < samples.touching.size(); ++k) {
        const double share = static_cast<double>(k) / count;
        samples.touching[k] = share >= from && share < to;
    }
    QCOMPARE(static_cast<int>(estimateTail(samples, duration).kind), kind);
}

// It touches in each period, in all of what is seen.
void TestTailEstimate::howLongABounceLastsIsNotKnown()
{
    SpacingSamples samples = decaying(0.3 * duration, 1e-9, 0.0);
    for (std::size_t k = 0; k < samples.touching.size(); ++k) samples.touching[k] = samples.spacing[k] < 10e-9;
    const TailEstimate tail = estimateTail(samples, duration);
    QCOMPARE(tail.kind, EndKind::Intermittent);
    QVERIFY(!tail.sameKind);
}

// Blocks of what falls steadily by g have steady means, so that their average, that of 3/4 of a part, is what is
// predicted. In durations, of a part of 0.3: g 0.225 for the tail, at 0.95. From 0.65 of the part it is g 0.14625 for
// what is seen from 0.2 to 0.3, on average g 0.25: missed by g 0.10375, 0.055 ahead; the tail is 0.65 ahead of the
// part. So it is known to g 0.10375 0.65/0.055 = 1.226 g, and misses by g 0.725.
void TestTailEstimate::whatDriftsIsNotKnown()
{
    constexpr double g = 1e-9; // [m] over the duration
    SpacingSamples samples{.interval = interval, .spacing = {}, .touching = std::vector<char>(3001, 0)};
    for (std::size_t k = 0; k < 3001; ++k)
        samples.spacing.push_back(10e-9 - g * interval * static_cast<double>(k) / duration);
    const TailEstimate tail = estimateTail(samples, duration);
    QVERIFY(std::abs(tail.mean - (10e-9 - 0.225 * g)) < 1e-3 * g); // samples: 1/750 of a block
    QVERIFY2(std::abs(tail.meanUncertainty - 1.226 * g) < 0.02 * g, QByteArray::number(tail.meanUncertainty / g));
}

// Of 1 nm it rings by e^(-4e3 t) at first, as from its beginning until 0.16 ms is predicted for what follows; from
// there on by half of that rate. At 0.25 ms it rings e^(2e3 0.09 ms) = 1.2 times as much as that: by 0.2 e^(-1)/sqrt 2
// = 0.052 nm in the spread, and that of the tail is not known better.
void TestTailEstimate::aRateThatChangesIsNotKnown()
{
    SpacingSamples samples = decaying(0.3 * duration, 1e-9, 4e3);
    for (std::size_t k = 1600; k < samples.spacing.size(); ++k)
        samples.spacing[k] =
            10e-9 + (samples.spacing[k] - 10e-9) * std::exp(2e3 * interval * static_cast<double>(k - 1600));
    const TailEstimate tail = estimateTail(samples, duration, {{{-4e3, twoPi * 100e3}, false}});
    QVERIFY2(tail.spreadUncertainty > 0.04e-9, QByteArray::number(tail.spreadUncertainty));
}

void TestTailEstimate::tooFewSamplesFail()
{
    const TailEstimate tail = estimateTail(decaying(2e-6, 1e-9, 0.0), duration);
    QCOMPARE(tail.kind, EndKind::Failed);
    QVERIFY(!tail.sameKind && std::isinf(tail.meanUncertainty) && std::isinf(tail.spreadUncertainty));
}

// Of 51 samples half are 25, fewer than an estimate takes.
void TestTailEstimate::tooFewSamplesWithoutTheirLastHalfTellNothing()
{
    const TailEstimate tail = estimateTail(decaying(5e-6, 1e-9, 0.0), duration);
    QVERIFY(!tail.sameKind && std::isinf(tail.meanUncertainty) && std::isinf(tail.spreadUncertainty));
}

TOUCHDOWN_TEST(TestTailEstimate)

} // namespace test_tail_estimate

#include "test_tail_estimate.moc"
