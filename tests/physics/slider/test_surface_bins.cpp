// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of the recess on random surfaces: they hold only if the bins lose nothing.
#include "core/physics/slider/surface_bins.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/physics/slider/recess.h"
#include "tests/support/plain_recess.h"
#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_bins {

constexpr double length = test::RandomSurface::length;
constexpr double width = test::RandomSurface::width;

/// The recess along a line parallel to an axis.
struct Track {
    const Recess& recess;
    ScanAxis along;
    double fixed;

    double at(double s) const { return along == ScanAxis::X ? recess.at(s, fixed) : recess.at(fixed, s); }
    std::vector<double> breaks(double from, double to) const
    {
        std::vector<double> out;
        if (along == ScanAxis::X) {
            recess.breaksAlongX(fixed, from, to, out);
        } else {
            recess.breaksAlongY(fixed, from, to, out);
        }
        return out;
    }
};

Track randomTrack(const Recess& recess, test::RandomSurface& random)
{
    const ScanAxis along = random.whole(0, 1) ? ScanAxis::X : ScanAxis::Y;
    return {recess, along, random.uniform(0.0, along == ScanAxis::X ? width : length)};
}

double extent(const Track& track) { return track.along == ScanAxis::X ? length : width; }

/// Halves [a, b], whose ends differ by a jump, down to neighbouring numbers.
double jumpBetween(const Track& track, double a, double b)
{
    const double before = track.at(a);
    const double after = track.at(b);
    for (double m = 0.5 * (a + b); a < m && m < b; m = 0.5 * (a + b)) {
        (std::abs(track.at(m) - before) < std::abs(track.at(m) - after) ? a : b) = m;
    }
    return a;
}

class TestSurfaceBins : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 24; ++seed) QTest::addRow("random surface %u", seed) << seed;
    }

    void agreesWithAPlainEvaluation()
    {
        QFETCH_GLOBAL(unsigned, seed);
        test::RandomSurface random(seed);
        const AirBearingSurface surface = random.draw();
        const Recess recess(surface, length, width);
        const test::PlainRecess plain(surface);
        for (int i = 0; i < 3000; ++i) {
            const double x = random.uniform(0.0, length);
            const double y = random.uniform(0.0, width);
            QVERIFY2(
                std::abs(recess.at(x, y) - plain.at(x, y)) < 1e-15,
                qPrintable(QString("x %1 y %2: %3, not %4").arg(x).arg(y).arg(recess.at(x, y)).arg(plain.at(x, y))));
        }
    }

    /// Between breaks the recess changes no faster than its steepest slope; the smallest jumps, of two levels that come
    /// close by chance, are told from it by the short steps.
    void continuousBetweenBreaks()
    {
        QFETCH_GLOBAL(unsigned, seed);
        test::RandomSurface random(seed);
        const AirBearingSurface surface = random.draw();
        const Recess recess(surface, length, width);
        for (int i = 0; i < 60; ++i) {
            const Track track = randomTrack(recess, random);
            std::vector<double> ends = track.breaks(0.0, extent(track));
            QVERIFY(std::is_sorted(ends.begin(), ends.end()));
            ends.insert(ends.begin(), 0.0);
            ends.push_back(extent(track));
            for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
                const double gap = ends[k + 1] - ends[k];
                if (gap < 1e-11) continue;
                const int steps = std::clamp(static_cast<int>(gap / 0.2e-6), 4, 400);
                double previous = 0.0;
                for (int s = 0; s <= steps; ++s) {
                    const double value = track.at(ends[k] + gap * (1e-3 + 0.998 * s / steps));
                    if (s > 0) {
                        const double most = test::RandomSurface::steepest * gap / steps + 1e-15;
                        QVERIFY2(std::abs(value - previous) <= most, qPrintable(QString("jump of %1 near %2, across %3")
                                                                                    .arg(value - previous)
                                                                                    .arg(ends[k] + gap * s / steps)
                                                                                    .arg(track.fixed)));
                    }
                    previous = value;
                }
            }
        }
    }

    /// The jumps that halving finds are breaks to rounding: to what a border's inclination leaves of 1e-15 m.
    void jumpsAreExact()
    {
        QFETCH_GLOBAL(unsigned, seed);
        test::RandomSurface random(seed);
        const AirBearingSurface surface = random.draw();
        const Recess recess(surface, length, width);
        constexpr double step = 0.3e-6;
        int found = 0;
        for (int i = 0; i < 40; ++i) {
            const Track track = randomTrack(recess, random);
            const std::vector<double> breaks = track.breaks(0.0, extent(track));
            for (double s = 0.0; s + step < extent(track); s += step) {
                if (std::abs(track.at(s + step) - track.at(s)) < 0.1e-6) continue;
                const double jump = jumpBetween(track, s, s + step);
                const auto above = std::lower_bound(breaks.begin(), breaks.end(), jump);
                double miss = 1.0;
                if (above != breaks.end()) miss = std::min(miss, *above - jump);
                if (above != breaks.begin()) miss = std::min(miss, jump - *(above - 1));
                QVERIFY2(
                    miss < 1e-13,
                    qPrintable(
                        QString("jump at %1, across %2, misses a break by %3").arg(jump).arg(track.fixed).arg(miss)));
                ++found;
            }
        }
        QVERIFY(found > 0);
    }

    /// Short lines have the breaks of the long line that they are part of.
    void piecesHaveTheSameBreaks()
    {
        QFETCH_GLOBAL(unsigned, seed);
        test::RandomSurface random(seed);
        const AirBearingSurface surface = random.draw();
        const Recess recess(surface, length, width);
        for (int i = 0; i < 20; ++i) {
            const Track track = randomTrack(recess, random);
            const std::vector<double> all = track.breaks(0.0, extent(track));
            std::vector<double> pieces;
            for (int k = 0; k < 200; ++k) {
                for (const double s : track.breaks(extent(track) * k / 200.0, extent(track) * (k + 1) / 200.0))
                    pieces.push_back(s);
            }
            // A break on the end of a piece belongs to neither side.
            QVERIFY(std::includes(all.begin(), all.end(), pieces.begin(), pieces.end()));
            QVERIFY(all.size() - pieces.size() <= 1);
        }
    }

    /// A smooth box has no break on any line through it, and in its recess the plane of a top alone: the middle of two
    /// opposite corners is the same for both pairs, and is the recess in the middle.
    void smoothBoxesHoldNoBreak()
    {
        QFETCH_GLOBAL(unsigned, seed);
        test::RandomSurface random(seed);
        const AirBearingSurface surface = random.draw();
        const Recess recess(surface, length, width);
        int smooth = 0;
        int lumpy = 0;
        for (int i = 0; i < 4000; ++i) {
            const double x0 = random.uniform(0.0, length);
            const double y0 = random.uniform(0.0, width);
            const double x1 = std::min(length, x0 + random.uniform(0.1e-6, 20e-6));
            const double y1 = std::min(width, y0 + random.uniform(0.1e-6, 20e-6));
            if (!recess.isSmooth(x0, x1, y0, y1)) {
                ++lumpy;
                continue;
            }
            ++smooth;
            for (int k = 0; k <= 4; ++k) {
                const Track across{recess, ScanAxis::X, y0 + (y1 - y0) * k / 4.0};
                const Track upwards{recess, ScanAxis::Y, x0 + (x1 - x0) * k / 4.0};
                QVERIFY(across.breaks(x0, x1).empty());
                QVERIFY(upwards.breaks(y0, y1).empty());
            }
            const double middle = recess.at(0.5 * (x0 + x1), 0.5 * (y0 + y1));
            QVERIFY(std::abs(0.5 * (recess.at(x0, y0) + recess.at(x1, y1)) - middle) < 1e-17);
            QVERIFY(std::abs(0.5 * (recess.at(x0, y1) + recess.at(x1, y0)) - middle) < 1e-17);
        }
        QVERIFY(smooth > 400);
        QVERIFY(lumpy > 40);
    }
};

TOUCHDOWN_TEST(TestSurfaceBins)

} // namespace test_surface_bins

#include "test_surface_bins.moc"
