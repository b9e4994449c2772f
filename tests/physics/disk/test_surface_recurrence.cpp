// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_recurrence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <QTest>

#include "core/physics/disk/roughness.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_recurrence {

constexpr double speed = 10.0; // [m/s]
constexpr DiskStrip line{0.5e-3, 0.5e-3};

SurfaceRecurrence of(const DiskSurface& surface, const Velocity& velocity = {speed, 0.0}, const DiskStrip& strip = line)
{
    return surfaceRecurrence(surface, DiskTopography(surface), velocity, strip);
}

DiskSurface waves(std::vector<double> lengths, std::vector<double> amplitudes)
{
    DiskSurface surface;
    surface.kind = DiskSurfaceKind::Waves;
    surface.waveLengths = std::move(lengths);
    surface.waveAmplitudes = std::move(amplitudes);
    return surface;
}

/// On a track of 10 mm by 0.2 mm, at 0.1 mm across, where the middle of the slider is (0.5 mm = 0.1 mm + 2 * 0.2 mm).
DiskSurface bumps(std::vector<double> x, std::vector<double> heights)
{
    DiskSurface surface;
    surface.kind = DiskSurfaceKind::Bumps;
    surface.bumpShape = BumpShape::Gaussian;
    surface.bumpLengths.assign(x.size(), 60e-6);
    surface.bumpY.assign(x.size(), 0.1e-3);
    surface.bumpX = std::move(x);
    surface.bumpHeights = std::move(heights);
    surface.track = 10e-3;
    surface.trackWidth = 0.2e-3;
    return surface;
}

/// Random waves of a map, periodic with n points that are 1 um apart.
HeightMap profile(int n, double bump)
{
    DiskSurface rough;
    rough.kind = DiskSurfaceKind::Rough;
    rough.rms = 0.3e-9;
    rough.correlationLength = 4e-6;
    rough.cell = 1e-6;
    rough.track = n * rough.cell;
    HeightMap map{.nx = n, .ny = 1, .dx = rough.cell, .dy = rough.cell, .heights = generateRoughness(rough)};
    map.heights.resize(static_cast<std::size_t>(n));
    map.closedX = true;
    for (int i = 0; i < 61; ++i)
        map.heights[static_cast<std::size_t>(100 + i)] += bump * std::exp(-0.005 * (i - 30) * (i - 30));
    return map;
}

class TestSurfaceRecurrence : public QObject {
    Q_OBJECT

private slots:
    /// (a sin)^2 = a^2/2 (1 - cos): over T the cosine at 2 f leaves at most 1/(2 pi f T) of itself. Its RMS over all
    /// phases is that over sqrt 2, and a fifth for f T = 0.5627.
    void aWave()
    {
        const SurfaceRecurrence wave = of(waves({50e-6}, {1e-9}));
        QVERIFY(std::abs(wave.period - 5e-6) < 1e-15);
        QVERIFY(wave.wait / wave.period >= 0.5627 && wave.wait / wave.period < 1.1 * 0.5627);
    }
    /// Two equal waves: a product of amplitude a^2 at the difference, of the mean a^2: 1/(pi f T sqrt 2) is a fifth for
    /// f T = 1.1254. They beat at 10 m/s (1/50 um - 1/51 um) = 3.922 kHz.
    void aBeat()
    {
        const SurfaceRecurrence beat = of(waves({50e-6, 51e-6}, {1e-9, 1e-9}));
        const double period = 1.0 / (speed / 50e-6 - speed / 51e-6);
        QVERIFY(beat.wait / period >= 1.12 && beat.wait / period < 1.1 * 1.13);
        QVERIFY(std::abs(beat.period / period - 1.0) < 1e-9); // 50 and 51 waves
        // A wave that runs across does not pass, and beats with none.
        DiskSurface across = waves({50e-6, 51e-6}, {1e-9, 1e-9});
        across.waveAngles = {0.0, 0.5 * std::numbers::pi};
        QVERIFY(of(across).wait < 5e-6);
        // Two that pass at the same frequency are one.
        QVERIFY(of(waves({50e-6, 50e-6}, {1e-9, 1e-9})).wait < 5e-6);
    }
    /// Many equal waves between 40 and 60 um, a band of B = 83.3 kHz, are steady though they never repeat. The sum over
    /// their pairs is the integral of the bound min(1, 1/(pi f T)^2) over the differences f, 4/(pi T), over B: this is
    /// 1/25 at T = 25 * 4/(pi B) = 382 us.
    void manyWaves()
    {
        std::mt19937 random(7);
        std::vector<double> lengths(200), amplitudes(200, 0.1e-9);
        for (double& length : lengths) length = 40e-6 + 20e-6 * double(random()) / double(std::mt19937::max());
        const SurfaceRecurrence many = of(waves(lengths, amplitudes));
        QVERIFY(std::isinf(many.period));
        QVERIFY2(many.wait > 0.85 * 382e-6 && many.wait < 1.2 * 382e-6, qPrintable(QString::number(many.wait)));
    }
    /// One bump passes once a track. Of bumps of like height the longest way between two counts; a small one beside a
    /// large one does not shorten the wait. One beside the line never passes under points, but under a wide slider.
    void bumpsOnATrack()
    {
        const SurfaceRecurrence one = of(bumps({1e-3}, {12e-9}));
        QVERIFY(std::abs(one.period - 1e-3) < 1e-15 && std::abs(one.wait - 1e-3) < 1e-15);
        QVERIFY(std::abs(of(bumps({1e-3, 4e-3}, {12e-9, -10e-9})).wait - 0.7e-3) < 1e-15);
        QVERIFY(std::abs(of(bumps({1e-3, 4e-3}, {12e-9, 3e-9})).wait - 1e-3) < 1e-15);
        DiskSurface beside = bumps({1e-3}, {12e-9});
        beside.bumpY = {0.0};
        QVERIFY(!of(beside).moves());
        QVERIFY(std::abs(of(beside, {speed, 0.0}, {0.0, 1e-3}).wait - 1e-3) < 1e-15);
        QVERIFY(!of(beside, {}).moves());
    }
    /// Askew, the path comes back 15 um beside itself after each track: the bump, 60 um wide, is met at 60 % or more of
    /// its height while r^2 < ln(1/0.6)/4.5 = 0.1135, that is over 2 * 0.337 * 30 um = 20.2 um, once or twice in 200
    /// um.
    void bumpsAskew()
    {
        const SurfaceRecurrence askew = of(bumps({1e-3}, {12e-9}), {speed, speed * 15e-6 / 10e-3});
        QVERIFY2(askew.wait >= 11.9e-3 && askew.wait <= 14.1e-3, qPrintable(QString::number(askew.wait)));
        // A bump of 12 nm every 0.2 mm under a slider of 1 mm: each track has it.
        const SurfaceRecurrence wide = of(bumps({1e-3}, {12e-9}), {speed, speed * 15e-6 / 10e-3}, {0.0, 1e-3});
        QVERIFY(std::abs(wide.wait - 1e-3) < 1e-9);
    }
    /// Against the widest gap of the tracks themselves.
    void tracksBecomeDense()
    {
        std::mt19937 random(3);
        const auto drawn = [&] { return double(random()) / double(std::mt19937::max()); };
        for (int k = 0; k < 50; ++k) {
            const double shift = drawn() * 3.0 - 1.5, apart = 0.02 + 0.3 * drawn();
            const auto widest = [&](int tracks) {
                std::vector<double> places;
                for (int i = 0; i < tracks; ++i) places.push_back(i * shift - std::floor(i * shift));
                std::ranges::sort(places);
                double gap = 1.0 - places.back() + places.front();
                for (std::size_t i = 1; i < places.size(); ++i) gap = std::max(gap, places[i] - places[i - 1]);
                return gap;
            };
            const int tracks = int(tracksUntilDense(shift, 1.0, apart));
            QVERIFY2(widest(tracks) <= apart + 1e-12, qPrintable(QString("%1 %2").arg(shift).arg(apart)));
            QVERIFY(tracks == 1 || widest(tracks / 2) > apart);
        }
        QCOMPARE(tracksUntilDense(0.0, 1.0, 0.1), 1.0);
        QCOMPARE(tracksUntilDense(1.25, 1.0, 0.1), 4.0); // closes
    }
    /// Roughness is steady after sqrt(2 I/s) = 1/5, I = lc sqrt(pi/2): 62.7 correlation lengths.
    void roughness()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::Rough;
        surface.correlationLength = 2e-6;
        const SurfaceRecurrence rough = of(surface);
        QVERIFY(std::abs(rough.wait - 62.67 * 2e-6 / speed) < 1e-8);
        QVERIFY(std::abs(rough.period - 1e-4) < 1e-15);
        surface.correlationLength = 20e-6; // the track of 1 mm is shorter
        QVERIFY(std::abs(of(surface).wait - 1e-4) < 1e-15);
    }
    /// A profile of 100 mm: of dense roughness a part tells, of one bump only the whole, also where it adds little to
    /// the mean square: 4^2 * 18 um of 0.3^2 * 100 mm, 3 %.
    void profiles()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::File;
        surface.file = "profile.txt";
        const auto wait = [&](double bump) {
            const DiskTopography topography(surface, profile(100000, bump));
            return surfaceRecurrence(surface, topography, {speed, 0.0}, line);
        };
        QVERIFY(std::abs(wait(0.0).period - 10e-3) < 1e-12);
        QVERIFY2(wait(0.0).wait < 2e-3, qPrintable(QString::number(wait(0.0).wait)));
        QVERIFY2(wait(4e-9).wait > 9.98e-3, qPrintable(QString::number(wait(4e-9).wait)));
        QVERIFY2(wait(8e-9).wait > 9.98e-3 && wait(8e-9).wait <= 10e-3, qPrintable(QString::number(wait(8e-9).wait)));
    }
};

TOUCHDOWN_TEST(TestSurfaceRecurrence)

} // namespace test_surface_recurrence

#include "test_surface_recurrence.moc"
