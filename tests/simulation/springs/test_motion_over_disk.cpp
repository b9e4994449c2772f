// SPDX-License-Identifier: GPL-3.0-or-later
//
// How runs of the springs over moving disks end (core/simulation/recording/motion_verdict.h), and whether a run says
// that its tolerance does not determine the motion.
#include "core/simulation/springs/spring_run.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>

#include "core/simulation/run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_motion_over_disk {

/// A slider at rest over one bump of 60 um on a track, in the middle of the slider's width.
Case overBump(double height, double track, double duration)
{
    Case c;
    c.initial.flyingHeight = c.springs.flyingHeight;
    c.initial.pitch = c.springs.pitch;
    c.diskSurface.kind = DiskSurfaceKind::Bumps;
    c.diskSurface.bumpShape = BumpShape::Gaussian;
    c.diskSurface.bumpHeights = {height};
    c.diskSurface.bumpLengths = {60e-6};
    c.diskSurface.bumpX = c.diskSurface.bumpY = {0.0};
    c.diskSurface.track = track;
    c.diskSurface.trackWidth = 100e-6; // half of the slider's width, 500 um, is five of them
    c.run.duration = duration;
    return c;
}

/// Minimum spacing and flying height of all samples.
struct Record {
    Summary summary;
    std::vector<double> spacing, height;
};
Record recorded(const Case& c)
{
    Record record;
    const auto column = [&c](const char* name) {
        return static_cast<std::size_t>(findQuantity(recordedQuantities(c), name));
    };
    const std::size_t spacing = column("minimum_spacing"), height = column("flying_height");
    record.summary = run(c, [&](const RunUpdate& update) {
        const auto append = [&](std::vector<double>& to, std::size_t from) {
            const std::vector<double>& values = update.samples.columns[from];
            to.insert(to.end(), values.begin(), values.end());
        };
        append(record.spacing, spacing);
        append(record.height, height);
        return true;
    });
    return record;
}

double repeatOf(const Summary& summary)
{
    for (const RunFigure& figure : summary.figures)
        if (figure.quantity.name == "surface_repeat") return figure.value;
    return std::nan("");
}

class TestMotionOverDisk : public QObject {
    Q_OBJECT

private slots:
    /// A bump of 12 nm passes each 10 mm/(13.006 m/s) = 0.769 ms and makes the slider bounce, which then calms down.
    /// Two passages are needed to tell, 1.54 ms.
    void aBumpAtEachPassage()
    {
        for (const double duration : {0.3e-3, 0.7e-3, 1.4e-3})
            QCOMPARE(run(overBump(12e-9, 10e-3, duration)).verdict.motion, Motion::TooShort);
        for (const double duration : {1.7e-3, 2.2e-3, 3.0e-3}) {
            const Case c = overBump(12e-9, 10e-3, duration);
            const Summary summary = run(c);
            QCOMPARE(summary.verdict.motion, Motion::Bounces);
            QVERIFY(summary.verdict.forced);
            QVERIFY(std::abs(repeatOf(summary) * c.disk.speed * c.disk.radius / 10e-3 - 1.0) < 1e-12);
        }
    }
    /// Once a turn, 144.5 mm: 11.1 ms.
    void aBumpEachTurn() { QCOMPARE(run(overBump(8e-9, 144.5e-3, 2e-3)).verdict.motion, Motion::TooShort); }
    /// A bump that passes beside pad and springs, and a disk that stands still, do nothing.
    void nothingPasses()
    {
        Case beside = overBump(12e-9, 10e-3, 0.2e-3);
        beside.diskSurface.bumpY = {50e-6};
        Case still = overBump(12e-9, 10e-3, 0.2e-3);
        still.diskSurface.motion = SurfaceMotion::Still;
        for (const Case& c : {beside, still}) {
            const Summary summary = run(c);
            QCOMPARE(summary.verdict.motion, Motion::AtRest);
            QVERIFY(std::isnan(repeatOf(summary)));
        }
    }
    /// Dense roughness and a wave need no long run.
    void denseSurfaces()
    {
        Case rough = overBump(0.0, 1e-3, 0.3e-3);
        rough.diskSurface.kind = DiskSurfaceKind::Rough;
        rough.diskSurface.rms = 0.3e-9;
        rough.diskSurface.correlationLength = 4e-6;
        QCOMPARE(run(rough).verdict.motion, Motion::Swings);
        Case wave = overBump(0.0, 1e-3, 0.3e-3);
        wave.diskSurface.kind = DiskSurfaceKind::Waves;
        wave.diskSurface.waveAmplitudes = {0.3e-9};
        wave.diskSurface.waveLengths = {80e-6};
        QCOMPARE(run(wave).verdict.motion, Motion::Swings);
    }
    /// Drawn bumps on drawn tracks, some askew: what rests or settles by the verdict does so in a run four times as
    /// long. By their last tenths alone 9 of these 24 are at rest.
    void restLasts()
    {
        std::mt19937 random(11);
        const auto between = [&](double a, double b) {
            return a + (b - a) * double(random()) / double(std::mt19937::max());
        };
        int told = 0;
        for (int k = 0; k < 24; ++k) {
            const double track = 1e-3 * std::pow(10.0, between(0.0, 1.0)), height = between(2e-9, 12e-9);
            Case c = overBump(height, track, 0.0);
            c.diskSurface.bumpX = {between(0.0, c.diskSurface.track)};
            c.diskSurface.bumpY = {between(-20e-6, 20e-6)};
            c.disk.skew = k % 3 == 0 ? between(-0.2, 0.2) : 0.0;
            c.springs.frontDampingRatio = c.springs.rearDampingRatio = between(0.01, 0.1);
            c.run.stepCheck = false;
            c.run.duration = 1e-3 * std::pow(10.0, between(-0.7, 0.5));
            const Motion motion = run(c).verdict.motion;
            if (motion != Motion::TooShort) ++told;
            if (motion != Motion::AtRest && motion != Motion::Settles) continue;
            const double end = c.run.duration;
            c.run.duration *= 4.0;
            const Record longer = recorded(c);
            const auto after = static_cast<std::ptrdiff_t>(end / c.run.sampleInterval) + 1;
            const auto [least, most] = std::minmax_element(longer.spacing.begin() + after, longer.spacing.end());
            QVERIFY2(*most - *least < 0.05e-9, qPrintable(QString("set %1: %2").arg(k).arg(*most - *least)));
        }
        QVERIFY2(told >= 8, qPrintable(QString::number(told))); // the rule still tells
    }
    /// Drawn waves that make the slider touch: where the run at 1e-8 is off by more than 1e-3 nm from one at 1e-13, it
    /// warns, and else not. Only sets are asked that are off by less than a third or more than three times as much.
    void aToleranceThatDoesNotDetermine()
    {
        std::mt19937 random(5);
        const auto between = [&](double a, double b) {
            return a + (b - a) * double(random()) / double(std::mt19937::max());
        };
        int warned = 0, silent = 0;
        for (int k = 0; k < 16; ++k) {
            Case c = overBump(0.0, 1e-3, 250e-6);
            c.diskSurface.kind = DiskSurfaceKind::Waves;
            c.diskSurface.waveAmplitudes = {between(0.3e-9, 2e-9), between(0.3e-9, 2e-9)};
            c.diskSurface.waveLengths = {between(35e-6, 70e-6), between(60e-6, 150e-6)};
            c.run.sampleInterval = 1e-6;
            const Record normal = recorded(c);
            const bool warns = std::ranges::any_of(normal.summary.warnings, [](const std::string& warning) {
                return warning.find("run.tolerance") != std::string::npos;
            });
            c.run.stepCheck = false;
            QVERIFY(std::ranges::none_of(recorded(c).summary.warnings, [](const std::string& warning) {
                return warning.find("run.tolerance") != std::string::npos;
            }));
            c.run.tolerance = 1e-13;
            const Record fine = recorded(c);
            double apart = 0.0;
            for (std::size_t i = 0; i < std::min(fine.height.size(), normal.height.size()); ++i)
                apart = std::max(apart, std::abs(fine.height[i] - normal.height[i]));
            if (apart > 0.3e-12 && apart < 3e-12) continue;
            QVERIFY2(warns == (apart > 1e-12), qPrintable(QString("set %1: %2").arg(k).arg(apart)));
            ++(warns ? warned : silent);
        }
        QVERIFY2(warned >= 2 && silent >= 4, qPrintable(QString("%1 %2").arg(warned).arg(silent)));
    }
};

TOUCHDOWN_TEST(TestMotionOverDisk)

} // namespace test_motion_over_disk

#include "test_motion_over_disk.moc"
