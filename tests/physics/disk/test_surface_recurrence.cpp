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

constexpr double speed = 10.0;        // [m/s]
constexpr double sliderLength = 1e-3; // [m]
constexpr DiskStrip line{0.5e-3, 0.5e-3, sliderLength};

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
        QVERIFY(std::abs(of(bumps({1e-3, 4e-3}, {12e-9, 10e-9})).wait - 0.7e-3) < 1e-15);
        QVERIFY(std::abs(of(bumps({1e-3, 4e-3}, {-12e-9, -10e-9})).wait - 0.7e-3) < 1e-15);
        QVERIFY(std::abs(of(bumps({1e-3, 4e-3}, {12e-9, 3e-9})).wait - 1e-3) < 1e-15);
        DiskSurface beside = bumps({1e-3}, {12e-9});
        beside.bumpY = {0.0};
        QVERIFY(!of(beside).moves());
        QVERIFY(std::abs(of(beside, {speed, 0.0}, {0.0, 1e-3, sliderLength}).wait - 1e-3) < 1e-15);
        QVERIFY(!of(beside, {}).moves());
    }
    /// Pits every millimetre do not stand for one bump a track: only the bump may touch. One that is lower than a
    /// quarter of their depth does not count.
    void pitsHideNoBump()
    {
        const auto wait = [](double bump) {
            std::vector<double> x, heights(10, -8e-9);
            for (int i = 0; i < 10; ++i) x.push_back((i + 0.5) * 1e-3);
            heights[4] = bump;
            return of(bumps(x, heights)).wait;
        };
        QVERIFY(std::abs(wait(6e-9) - 1e-3) < 1e-15);
        QVERIFY(std::abs(wait(1.5e-9) - 0.2e-3) < 1e-15); // of the other nine pits
    }
    /// One high bump a track between low ones every millimetre counts, however long it is: a slider of 1 mm sees
    /// different heights of it at one time. At f0 = 10 kHz, once along the slider, the share f^2/(f^2 + f0^2) is 1/5 of
    /// 20 nm if it is 2 mm long, 4 nm, and nearly all of the low ones, 0.1 nm. At 300 kHz it is 1/3601, 5.6 pm, less
    /// than the 24 pm of low ones 60 um long. A long one that is low itself needs no wait.
    void aLongBumpAmongShortOnes()
    {
        const auto wait = [](double high, double longest, double low) {
            std::vector<double> x, heights(10, low);
            for (int i = 0; i < 10; ++i) x.push_back((i + 0.5) * 1e-3);
            DiskSurface surface = bumps(x, heights);
            surface.bumpHeights[4] = high;
            surface.bumpLengths[4] = longest;
            surface.bumpShape = BumpShape::Cosine; // which does not reach the next one
            return of(surface).wait;
        };
        for (const double longest : {60e-6, 300e-6, 800e-6, 2e-3})
            QVERIFY2(std::abs(wait(40e-9, longest, 1e-9) - 1e-3) < 1e-15, qPrintable(QString::number(longest)));
        QVERIFY(std::abs(wait(20e-9, 2e-3, 0.1e-9) - 1e-3) < 1e-15);
        QVERIFY(wait(0.1e-9, 1.5e-3, 1e-9) < 0.21e-3);
        // Nor do long ones hide a short one.
        DiskSurface surface = bumps({0.5e-3, 2.5e-3, 4.5e-3, 6.5e-3, 8.5e-3}, std::vector<double>(5, 40e-9));
        surface.bumpLengths = {1e-3, 1e-3, 30e-6, 1e-3, 1e-3};
        surface.bumpHeights[2] = 5e-9;
        QVERIFY(std::abs(of(surface).wait - 1e-3) < 1e-15);
    }
    /// Askew, the path comes back 15 um beside itself after each track: the bump, 60 um wide, is met at 80 % or more of
    /// its height while r^2 < ln(1/0.8)/4.5 = 0.0496, that is over 2 * 0.223 * 30 um = 13.4 um, at most once in 200 um.
    void bumpsAskew()
    {
        const SurfaceRecurrence askew = of(bumps({1e-3}, {12e-9}), {speed, speed * 15e-6 / 10e-3});
        QVERIFY2(askew.wait >= 11.9e-3 && askew.wait <= 14.1e-3, qPrintable(QString::number(askew.wait)));
        // A bump of 12 nm every 0.2 mm under a slider of 1 mm: each track has it.
        const SurfaceRecurrence wide =
            of(bumps({1e-3}, {12e-9}), {speed, speed * 15e-6 / 10e-3}, {0.0, 1e-3, sliderLength});
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
    /// The path over roughness: without skew one track, askew all of the map, whose highest place counts.
    void roughness()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::Rough;
        surface.correlationLength = 4e-6;
        surface.cell = 1e-6;
        surface.track = 0.4e-3;
        surface.trackWidth = 64e-6;
        QVERIFY(std::abs(of(surface).period - 4e-5) < 1e-15);
        QVERIFY(of(surface).wait <= 4e-5 + 1e-12 && of(surface).wait > 1e-5);
        // 10 um beside itself after each track: the middles of 64 um are 2 um apart after 32 of them, 1.28 ms.
        const Velocity askew{speed, speed * 10.0 / 400.0};
        const double wait = of(surface, askew).wait;
        QVERIFY2(wait > 4e-5 && wait <= 1.28e-3, qPrintable(QString::number(wait)));
        // Along any part of the path of that length there is a place at least 0.8 times as high as the highest one.
        const DiskTopography topography(surface);
        const int count = 32 * 400, part = int(std::ceil(wait * speed / surface.cell));
        std::vector<double> heights(std::size_t(2 * count));
        for (int i = 0; i < 2 * count; ++i) {
            const double x = (i % count) * surface.cell;
            heights[std::size_t(i)] = topography.height(x, 0.5e-3 + 0.025 * x);
        }
        const double high = 0.8 * *std::ranges::max_element(heights);
        int since = 0, longest = 0;
        for (const double height : heights) {
            since = height > high ? 0 : since + 1;
            longest = std::max(longest, since);
        }
        QVERIFY2(longest <= part, qPrintable(QString("%1 %2").arg(longest).arg(part)));
        // A slider as wide as the map sees all of it in one track, and meets high places more often than a line of it.
        QVERIFY(of(surface, {speed, 0.0}, {0.0, 64e-6, sliderLength}).wait < of(surface).wait);
        QVERIFY(of(surface, askew, {0.0, 64e-6, sliderLength}).wait <= 4e-5 + 1e-12);
    }
    /// A profile of 10 beats of two equal waves, 60 and 62 um long. The mean over n beats leaves sin(pi n)/(pi n) of a
    /// cosine, its RMS is that over sqrt 2, and a fifth for n = 0.764; the times tried differ by 1.1. The places at
    /// least 0.8 times as high as the highest one are less apart: 1 - 2 arccos(0.8)/pi = 0.59 beats and a wave. A beat
    /// is 1.86 mm long.
    void aBeatOfAProfile()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::File;
        surface.file = "profile.txt";
        HeightMap map{.nx = 18600, .ny = 1, .dx = 1e-6, .dy = 1e-6, .heights = {}};
        map.closedX = true;
        for (int i = 0; i < map.nx; ++i)
            map.heights.push_back(
                1e-9 * (std::sin(2.0 * std::numbers::pi * i / 60.0) + std::sin(2.0 * std::numbers::pi * i / 62.0)));
        const double wait = surfaceRecurrence(surface, DiskTopography(surface, map), {speed, 0.0}, line).wait;
        QVERIFY2(wait > 0.76 * 186e-6 && wait < 1.1 * 0.77 * 186e-6, qPrintable(QString::number(wait)));
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
        QVERIFY2(wait(0.0).wait < 5e-3, qPrintable(QString::number(wait(0.0).wait)));
        QVERIFY2(wait(4e-9).wait > 9.98e-3, qPrintable(QString::number(wait(4e-9).wait)));
        QVERIFY2(wait(8e-9).wait > 9.98e-3 && wait(8e-9).wait <= 10e-3, qPrintable(QString::number(wait(8e-9).wait)));
    }

    /// Under a wide slider several lines of a map are read, each to its end: a bump near that is met once a track.
    void aLongMapIsReadToItsEnd()
    {
        DiskSurface surface;
        surface.kind = DiskSurfaceKind::File;
        surface.file = "map.txt";
        const HeightMap row = profile(70000, 0.0);
        HeightMap map = row;
        map.ny = 33;
        map.closedX = map.closedY = true;
        for (int j = 1; j < map.ny; ++j) map.heights.insert(map.heights.end(), row.heights.begin(), row.heights.end());
        for (int j = 0; j < map.ny; ++j)
            for (int i = -60; i <= 60; ++i)
                map.heights[static_cast<std::size_t>(j * map.nx + 69000 + i)] += 20e-9 * std::exp(-i * i / 400.0);
        const DiskTopography topography(surface, map);
        const SurfaceRecurrence found =
            surfaceRecurrence(surface, topography, {speed, 0.0}, {0.0, 33e-6, sliderLength});
        QVERIFY2(found.wait > 6.9e-3 && found.wait <= 7e-3, qPrintable(QString::number(found.wait)));
    }
};

TOUCHDOWN_TEST(TestSurfaceRecurrence)

} // namespace test_surface_recurrence

#include "test_surface_recurrence.moc"
