// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/motion_verdict.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_motion_verdict {

/// amplitude * exp(-decay i/n) * sin(2 pi periods i/n) + drift i/n, of n = 1000 samples.
std::vector<double> signal(double amplitude, double periods, double decay = 0.0, double drift = 0.0)
{
    std::vector<double> result;
    for (int i = 0; i < 1000; ++i) {
        const double share = i / 1000.0;
        result.push_back(amplitude * std::exp(-decay * share) * std::sin(2 * std::numbers::pi * periods * share) +
                         drift * share);
    }
    return result;
}

class TestMotionVerdict : public QObject {
    Q_OBJECT

private slots:
    /// A ripple of a tenth of the main motion counts for nothing; a drift has no period.
    void periods()
    {
        const auto ruleOf = [](const std::vector<double>& signal) {
            MotionSamples samples;
            samples.interval = 1e-8;
            for (const double s : signal) samples.add(s, Touch::Never);
            return QString::fromStdString(judgeMotion(samples).rule);
        };
        std::vector<double> both = signal(1e-9, 50.0);
        const std::vector<double> ripple = signal(0.1e-9, 400.0);
        for (std::size_t i = 0; i < both.size(); ++i) both[i] += ripple[i];
        QVERIFY2(ruleOf(both).contains(QStringLiteral("in 4.5 periods")), qPrintable(ruleOf(both)));
        QVERIFY(ruleOf(signal(1e-9, 50.0)).contains(QStringLiteral("in 4.5 periods")));
        QVERIFY(ruleOf(signal(0.0, 1.0, 0.0, 1e-9)).contains(QStringLiteral("in 0.5 periods")));
        const QString one = ruleOf(signal(1e-9, 4.5)); // 1.5 of them in the last third, with two changes
        QVERIFY2(one.contains(QStringLiteral("in 1 period,")), qPrintable(one));
    }
    /// A strongly damped swing has come to rest; the turn of a slow and large one has not.
    void whatMovesOn()
    {
        QVERIFY(!movesOn(signal(1e-9, 20.0, 12.0)));
        QVERIFY(!movesOn(signal(0.0, 1.0)));
        QVERIFY(!movesOn(signal(0.0, 1.0, 0.0, 0.05e-9)));
        QVERIFY(movesOn(signal(0.0, 1.0, 0.0, 0.07e-9)));
        QVERIFY(movesOn(signal(1e-9, 0.25)));
        QVERIFY(!movesOn({}));
    }
    /// Each row of the rule, at its border.
    void verdicts()
    {
        const MotionEvidence lasting{
            .swings = {1e-9, 1e-9}, .parts = 2, .rms = 0.3e-9, .rmsBefore = 0.3e-9, .periods = 3.0};
        QCOMPARE(verdictOf(lasting).motion, Motion::Swings);
        const auto with = [&](auto change) {
            MotionEvidence evidence = lasting;
            change(evidence);
            return verdictOf(evidence).motion;
        };
        using E = MotionEvidence&;
        const auto touching = [](E e) { e.touch = Touch::Always; };
        const auto leaving = [](E e) { e.touch = Touch::AtTimes; };
        QCOMPARE(with(touching), Motion::Vibrates);
        QCOMPARE(with(leaving), Motion::Bounces);
        QCOMPARE(with([](E e) { e.periods = 2.5; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.samples = 9; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.samples = 9, e.swings[0] = 0.0; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.swings[1] = 1.12e-9; }), Motion::Settles);
        QCOMPARE(with([&](E e) { e.swings[1] = 1.12e-9, touching(e); }), Motion::Settles);
        // A slider that still takes off may bounce on.
        QCOMPARE(with([&](E e) { e.swings[1] = 1.12e-9, leaving(e); }), Motion::TooShort);
        // A swing that lasts, but the contact ended or began lately.
        QCOMPARE(with([](E e) { e.switchedLately = true; }), Motion::TooShort);
        QCOMPARE(with([&](E e) { e.switchedLately = true, touching(e); }), Motion::TooShort);
        QCOMPARE(with([&](E e) { e.switchedLately = true, leaving(e); }), Motion::Bounces);
        QCOMPARE(with([](E e) { e.swings[1] = 1.12e-9, e.switchedLately = true; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.swings[1] = 1.10e-9; }), Motion::Swings);
        QCOMPARE(with([](E e) { e.swings[0] = 0.019e-9; }), Motion::AtRest);
        QCOMPARE(with([](E e) { e.swings[0] = 0.019e-9, e.movedOn = true; }), Motion::TooShort);
        // What it would still move by, at a rate r: swing times r/(1 - r).
        const auto movedOn = [&](double swing, double before, double first) {
            return with([=](E e) { e.parts = 3, e.swings = {swing, before, first}, e.movedOn = true; });
        };
        QCOMPARE(movedOn(0.009e-9, 0.0135e-9, 0.02025e-9), Motion::AtRest);   // r = 2/3: 0.018 nm
        QCOMPARE(movedOn(0.011e-9, 0.0165e-9, 0.02475e-9), Motion::TooShort); // 0.022 nm
        QCOMPARE(movedOn(0.009e-9, 0.0135e-9, 0.0180e-9), Motion::TooShort);  // r = 3/4: 0.027 nm
        QCOMPARE(movedOn(0.009e-9, 0.0120e-9, 0.0180e-9), Motion::TooShort);
        QCOMPARE(movedOn(0.002e-9, 0.0022e-9, 0.00242e-9), Motion::TooShort); // 10/11: no decay
        QCOMPARE(movedOn(0.0, 0.0, 0.0), Motion::AtRest);
        QCOMPARE(movedOn(0.9e-13, 0.8e-13, 0.7e-13), Motion::AtRest); // round-off
        QCOMPARE(with([](E e) { e.swings = {0.021e-9, 0.021e-9}; }), Motion::Swings);
        // Slow and modulated, by 5.4 % from three parts to the next ones; 2.9 % are sustained, as is what takes off.
        const std::array slow{1.30e-9, 1.39e-9, 1.45e-9, 1.44e-9, 1.42e-9, 1.516e-9};
        QCOMPARE(with([&](E e) { e.parts = 6, e.oneLaw = true, e.swings = slow; }), Motion::Settles);
        QCOMPARE(with([&](E e) { e.parts = 5, e.oneLaw = true, e.swings = slow; }), Motion::Swings);
        QCOMPARE(with([&](E e) { e.parts = 6, e.swings = slow; }), Motion::Swings);
        QCOMPARE(with([](E e) {
                     e.parts = 6, e.oneLaw = true, e.swings = {0.971e-9, 0.971e-9, 0.971e-9, 1e-9, 1e-9, 1e-9};
                 }),
                 Motion::Swings);
        QCOMPARE(with([](E e) {
                     e.parts = 6, e.oneLaw = true, e.swings = {0.969e-9, 0.969e-9, 0.969e-9, 1e-9, 1e-9, 1e-9};
                 }),
                 Motion::Settles);
        // Small, but half as large again in each part: an instability at its beginning.
        QCOMPARE(with([](E e) { e.parts = 3, e.swings = {16e-12, 10e-12, 6e-12}; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.parts = 3, e.swings = {16e-12, 11e-12, 6e-12}; }), Motion::AtRest);
        QCOMPARE(with([](E e) { e.parts = 3, e.swings = {0.9e-13, 0.5e-13, 0.3e-13}; }), Motion::AtRest); // round-off
    }
    /// Over a moving surface the swing of a part is random: its standard deviation decides, and nothing settles.
    void aMovingSurfaceForces()
    {
        MotionEvidence evidence{.swings = {0.5e-9, 0.7e-9},
                                .parts = 2,
                                .rms = 0.1e-9,
                                .rmsBefore = 0.16e-9,
                                .periods = 10.0,
                                .frequency = 8e5,
                                .touch = Touch::Always,
                                .surface = {.period = 1e-3, .wait = 1e-6}};
        evidence.length = 1e-4;
        evidence.touchBefore = Touch::Always;
        const MotionVerdict forced = verdictOf(evidence);
        QCOMPARE(forced.motion, Motion::Vibrates);
        QVERIFY(forced.forced);
        QCOMPARE(forced.rms, 0.1e-9);
        QCOMPARE(textOf(forced), std::string("vibrates in contact, forced by the disk (800 kHz, 0.1 nm rms)"));
        evidence.rmsBefore = 0.17e-9;
        QCOMPARE(verdictOf(evidence).motion, Motion::TooShort);
        QVERIFY(!verdictOf(evidence).forced);
        evidence.surface = {};
        QCOMPARE(verdictOf(evidence).motion, Motion::Settles);
    }
    /// What grows there by more than it may decay, or touches in one part and flies in the other, does not last yet.
    void aMovingSurfaceNeedsTwoLikeParts()
    {
        const MotionEvidence lasting{.swings = {1e-9, 1e-9},
                                     .parts = 2,
                                     .rms = 0.3e-9,
                                     .rmsBefore = 0.3e-9,
                                     .periods = 10.0,
                                     .length = 1e-4,
                                     .surface = {.period = 1e-3, .wait = 1e-6}};
        const auto with = [&](auto change) {
            MotionEvidence evidence = lasting;
            change(evidence);
            return verdictOf(evidence).motion;
        };
        using E = MotionEvidence&;
        QCOMPARE(verdictOf(lasting).motion, Motion::Swings);
        QCOMPARE(with([](E e) { e.rmsBefore = 0.19e-9; }), Motion::Swings);   // 0.63 of it
        QCOMPARE(with([](E e) { e.rmsBefore = 0.17e-9; }), Motion::TooShort); // 0.57
        QCOMPARE(with([](E e) { e.touch = e.touchBefore = Touch::AtTimes; }), Motion::Bounces);
        QCOMPARE(with([](E e) { e.touch = Touch::AtTimes; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.touchBefore = Touch::AtTimes; }), Motion::TooShort);
        // One period of the motion, but a whole one of the surface, and less.
        QCOMPARE(with([](E e) { e.periods = 1.0; }), Motion::TooShort);
        QCOMPARE(with([](E e) { e.periods = 1.0, e.surface.period = 1e-4; }), Motion::Swings);
    }
    /// At rest for 10 us, but the rarest feature of the surface comes every 3 us, or within 6 us: half of the run is
    /// less, and one of 1.02 * 2 * 6 us = 12.24 us, in two digits 13 us, would tell.
    void aRareFeatureIsAwaited()
    {
        const auto judged = [](double wait, double period) {
            MotionSamples samples;
            samples.interval = 1e-8;
            samples.surface = {.period = period, .wait = wait};
            for (int i = 0; i < 1000; ++i) samples.add(7e-9, Touch::Never);
            return judgeMotion(samples);
        };
        QCOMPARE(judged(3e-6, 3e-6).motion, Motion::AtRest);
        QCOMPARE(judged(5e-6, 5e-6).motion, Motion::AtRest); // half of the run
        QCOMPARE(judged(6e-6, 6e-6).motion, Motion::TooShort);
        QVERIFY(judged(6e-6, 6e-6).rule.find("13 us") != std::string::npos);
        QCOMPARE(judged(6e-6, INFINITY).motion, Motion::TooShort);
        QCOMPARE(judged(3e-6, INFINITY).motion, Motion::AtRest);
    }
    /// The time that a short run names is enough, however long the landing takes: a run of that time waits for the
    /// surface no more. One that lands later does so without a time.
    void theNamedTimeIsEnough()
    {
        const auto judged = [](double landing, double duration) {
            MotionSamples samples;
            samples.interval = 1e-8;
            samples.surface = {.period = 6e-6, .wait = 6e-6};
            for (int i = 0; i * samples.interval < duration; ++i) {
                const double time = i * samples.interval;
                samples.add(7e-9 + 0.1e-9 * std::sin(6.28 * time / 0.5e-6) +
                                20e-9 * std::max(0.0, 1.0 - time / landing),
                            Touch::Never);
            }
            return judgeMotion(samples);
        };
        for (const double landing : {1e-6, 3e-6, 6e-6}) {
            QVERIFY(judged(landing, 8e-6).rule.find("at least 13 us") != std::string::npos);
            QVERIFY2(judged(landing, 13e-6).rule.find("surface repeats") == std::string::npos,
                     qPrintable(QString::fromStdString(judged(landing, 13e-6).rule)));
        }
        const std::string late = judged(9e-6, 13e-6).rule;
        QVERIFY(late.find("surface repeats") != std::string::npos && late.find("at least") == std::string::npos);
        QCOMPARE(judged(1e-6, 13e-6).motion, Motion::Swings);
        QCOMPARE(judged(6e-6, 13e-6).motion, Motion::TooShort); // the landing is in the part before
        QCOMPARE(judged(6e-6, 26e-6).motion, Motion::Swings);
    }
    /// A dip of 0.1 us every 2.3 us, at the end of a part of 3 us or not: whole periods hold as many each, so that the
    /// motion lasts. The last two periods of 2.3 us begin at 5.4 us.
    void wholePeriodsOfTheSurface()
    {
        for (int phase = 0; phase < 230; phase += 23) {
            MotionSamples samples;
            samples.interval = 1e-8;
            samples.surface = {.period = 2.3e-6, .wait = 2.3e-6};
            for (int i = 0; i < 1000; ++i)
                samples.add((i + phase) % 230 < 10 ? 4e-9 : 7e-9,
                            (i + phase) % 230 < 10 ? Touch::Always : Touch::Never);
            QCOMPARE(judgeMotion(samples).motion, Motion::Bounces);
        }
    }
    /// A drop from 100 nm within 3 % of the run, then a swing of constant size in and out of contact: the third that
    /// holds three periods begins after the landing. Without it the swing before would be 100 nm.
    void theLandingIsLeftOut()
    {
        MotionSamples samples;
        samples.interval = 1e-8;
        const int count = 1000, landing = 30, period = 100;
        for (int i = 0; i < count; ++i) {
            const double s = i < landing ? 100e-9 * (1.0 - double(i) / landing) + 6e-9
                                         : 5e-9 + 1e-9 * std::cos(2 * std::numbers::pi * (i - landing) / period);
            samples.add(s, s < 5e-9 ? Touch::Always : Touch::Never);
        }
        const MotionVerdict verdict = judgeMotion(samples);
        QCOMPARE(verdict.motion, Motion::Bounces);
        QVERIFY(std::abs(verdict.swing - 2e-9) < 1e-12);
        QVERIFY(std::abs(verdict.frequency - 1e6) < 0.02e6); // 100 samples of 10 ns
    }
    /// Parabolas from touch to touch are above a limit for another part of the period than below it, so that half
    /// periods differ; whole ones are P samples, wherever the judged part ends.
    void periodsNeedNotBeSymmetric()
    {
        for (const double period : {41.3, 57.9, 61.7, 83.1, 97.77})
            for (const double phase : {0.0, 0.2, 0.4, 0.6, 0.8}) {
                MotionSamples samples;
                samples.interval = 1e-8;
                for (int i = 0; i < 1000; ++i) {
                    const double u = 2.0 * (i / period + phase - std::floor(i / period + phase)) - 1.0;
                    samples.add(5e-9 + 100e-9 * (1.0 - u * u), std::abs(u) > 0.9 ? Touch::Always : Touch::Never);
                }
                const MotionVerdict verdict = judgeMotion(samples);
                QCOMPARE(verdict.motion, Motion::Bounces);
                QVERIFY(std::abs(verdict.frequency * period * samples.interval - 1.0) < 2e-3);
            }
    }
    /// A frequency over a moving surface is one that the standard deviation belongs to. Slow noise of about 43 nm has
    /// none, though a sine of 2 nm stands out of it; one of 80 nm has most of the variance.
    void theFrequencyOfForcedMotion()
    {
        for (const double amplitude : {0.0, 2e-9, 80e-9}) {
            MotionSamples samples;
            samples.interval = 1e-8;
            samples.surface = {.period = 1e-6, .wait = 1e-6};
            std::mt19937 random(7);
            double noise = 0.0;
            for (int i = 0; i < 6000; ++i) {
                noise += 0.02 * (static_cast<double>(random()) / 4294967296.0 - 0.5 - noise);
                const double s = 1500e-9 * noise + amplitude * std::sin(2.0 * std::numbers::pi * i / 12.3);
                samples.add(s, Touch::Never);
            }
            const MotionVerdict verdict = judgeMotion(samples);
            QCOMPARE(verdict.motion, Motion::Swings);
            QVERIFY(verdict.forced && verdict.rms > 20e-9);
            const bool told = amplitude > 50e-9;
            QCOMPARE(verdict.frequency > 0.0, told);
            if (told) QVERIFY(std::abs(verdict.frequency * 12.3e-8 - 1.0) < 1e-3);
            QCOMPARE(textOf(verdict).find("kHz") != std::string::npos, told);
            QVERIFY(textOf(verdict).find("nm rms") != std::string::npos);
        }
    }
    /// The contact ends and begins between two samples that both touch.
    void aTakeOffBetweenSamples()
    {
        MotionSamples samples;
        samples.interval = 1e-8;
        for (int i = 0; i < 1000; ++i)
            samples.add(3e-9 + 1e-9 * std::cos(2 * std::numbers::pi * i / 20), Touch::Always);
        QCOMPARE(judgeMotion(samples).motion, Motion::Vibrates);
        samples.switches = {9.5012e-6, 9.5014e-6};
        QCOMPARE(judgeMotion(samples).motion, Motion::Bounces);
        samples.switches = {5.5012e-6, 5.5014e-6}; // before the judged part
        QCOMPARE(judgeMotion(samples).motion, Motion::Vibrates);
    }
    /// A long hop between two bounces is no decay: it swings 4, 2 and 1 nm in its parts, and touched before.
    void aHopIsNoDecay()
    {
        MotionSamples samples;
        samples.interval = 1e-8;
        for (int i = 0; i < 1000; ++i)
            samples.add(9e-9 + 4e-9 * std::exp(-0.005 * i) * std::cos(2 * std::numbers::pi * i / 20), Touch::Never);
        QCOMPARE(judgeMotion(samples).motion, Motion::Settles);
        samples.switches = {7.2e-6, 7.3e-6};
        QCOMPARE(judgeMotion(samples).motion, Motion::TooShort);
        samples.switches = {6.2e-6, 6.3e-6};
        QCOMPARE(judgeMotion(samples).motion, Motion::Settles);
    }
    /// The last sample stands for the interval before it.
    void aSwitchInTheLastInterval()
    {
        MotionSamples samples;
        samples.interval = 1e-8;
        for (int i = 0; i < 1000; ++i)
            samples.add(3e-9 + 1e-9 * std::cos(2 * std::numbers::pi * i / 20), Touch::Always);
        samples.switches = {9.985e-6};
        QCOMPARE(judgeMotion(samples).motion, Motion::Bounces);
        samples.switches = {9.995e-6}; // after the last sample
        QCOMPARE(judgeMotion(samples).motion, Motion::Vibrates);
    }
    void theOldestSamplesGo()
    {
        MotionSamples samples;
        samples.interval = 1e-6;
        for (int i = 0; i < 5; ++i) samples.add(i, i - 0.5, i + 0.5, Touch::Never);
        samples.dropFirst(2);
        QCOMPARE(samples.spacing, (std::vector<double>{2, 3, 4}));
        QCOMPARE(samples.least.front(), 1.5);
        QCOMPARE(samples.most.front(), 2.5);
        QCOMPARE(samples.touch.size(), std::size_t(3));
        QCOMPARE(samples.first, 2e-6);
    }
    /// A swing of 2 nm whose period is no more than a sample's interval: the samples alone would show a slow one.
    void aFrequencyThatSamplesDoNotShow()
    {
        const auto judged = [](double samplesInPeriod) {
            MotionSamples samples;
            samples.interval = 1e-8;
            const auto at = [&](double i) {
                return 5e-9 + 1e-9 * std::cos(2 * std::numbers::pi * i / samplesInPeriod);
            };
            for (int i = 0; i < 1000; ++i) {
                double least = at(i), most = at(i);
                for (double back = 0.0; i > 0 && back < 1.0; back += 0.01) {
                    least = std::min(least, at(i - back));
                    most = std::max(most, at(i - back));
                }
                samples.add(at(i), least, most, Touch::Never);
            }
            return judgeMotion(samples);
        };
        for (const double fast : {0.4, 0.66, 0.75, 1.0, 1.05, 1.5, 1.8, 1.96, 2.2}) {
            const MotionVerdict verdict = judged(fast);
            QCOMPARE(verdict.motion, Motion::Swings);
            QVERIFY(verdict.undersampled);
            QCOMPARE(verdict.frequency, 0.0);
            QVERIFY(QString::fromStdString(verdict.rule).contains("in more than"));
        }
        for (const double slow : {2.9, 3.3, 4.0, 5.3, 20.0}) {
            const MotionVerdict verdict = judged(slow);
            QVERIFY(!verdict.undersampled);
            QVERIFY(std::abs(verdict.frequency * slow * 1e-8 - 1.0) < 0.02);
        }
        // A dip between two samples in each of slow periods is no reason to withhold a frequency.
        MotionSamples dips;
        dips.interval = 1e-8;
        for (int i = 0; i < 1000; ++i) {
            const double s = 5e-9 + 1e-9 * std::cos(2 * std::numbers::pi * i / 50);
            dips.add(s, i % 50 == 3 ? 4e-9 : s, s, Touch::Never);
        }
        QVERIFY(!judgeMotion(dips).undersampled);
    }
    void nothingToJudge() { QCOMPARE(judgeMotion({}).motion, Motion::NotJudged); }
    void theRuleHasTheFigures()
    {
        const QString rule = QString::fromStdString(
            verdictOf({.swings = {1.25e-9, 1.3e-9}, .parts = 2, .periods = 20.5, .touch = Touch::AtTimes}).rule);
        for (const char* part : {"1.25 nm", "1.3 nm", "20.5 periods", "takes off", "90 %"})
            QVERIFY2(rule.contains(part), qPrintable(rule));
        QVERIFY(QString::fromStdString(verdictOf({.swings = {1e-9, 1e-9}, .parts = 2, .periods = 1.0}).rule)
                    .contains("3 periods are needed"));
    }
    void namesAreDifferent()
    {
        std::set<std::string_view> names;
        for (const Motion motion : {Motion::NotJudged, Motion::AtRest, Motion::Settles, Motion::Swings,
                                    Motion::Vibrates, Motion::Bounces, Motion::TooShort})
            names.insert(name(motion));
        QCOMPARE(names.size(), std::size_t(7));
    }

    void folded_data()
    {
        QTest::addColumn<double>("samplesInPeriod");
        QTest::addColumn<bool>("folded");
        for (const double samples : {0.51, 0.66, 0.99, 1.0, 1.41, 1.65, 1.98, 2.03})
            QTest::newRow(qPrintable(QString("%1 samples in a period").arg(samples))) << samples << true;
        for (const double samples : {2.5, 3.0, 5.0, 20.0, 200.0})
            QTest::newRow(qPrintable(QString("%1 samples in a period").arg(samples))) << samples << false;
    }
    /// A decaying sine over a slow drift, with its extremes between the samples.
    void folded()
    {
        QFETCH(double, samplesInPeriod);
        QFETCH(bool, folded);
        const auto height = [&](double k) {
            return 10e-9 + 5e-9 * std::exp(-k / 400.0) * std::sin(2.0 * std::numbers::pi * k / samplesInPeriod) +
                   1e-12 * k;
        };
        MotionSamples samples;
        for (int k = 0; k < 1000; ++k) {
            double least = INFINITY, most = -INFINITY;
            for (int i = 0; i <= 200; ++i) {
                least = std::min(least, height(k - i / 200.0));
                most = std::max(most, height(k - i / 200.0));
            }
            samples.add(height(k), least, most, Touch::Never);
        }
        QCOMPARE(isFolded(samples, 0), folded);
    }
    void restIsNotFolded()
    {
        MotionSamples samples;
        for (int k = 0; k < 100; ++k) samples.add(7e-9, 7e-9 - 1e-13, 7e-9 + 1e-13, Touch::Never);
        QVERIFY(!isFolded(samples, 0));
    }
};

TOUCHDOWN_TEST(TestMotionVerdict)

} // namespace test_motion_verdict

#include "test_motion_verdict.moc"
