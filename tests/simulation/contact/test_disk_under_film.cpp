// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/disk_under_film.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_under_film {

constexpr double wave = 0.25e-3, amplitude = 1e-9;

/// A wave along the track, four periods long under the slider. The disk runs at 5400 rpm under 23 mm: 13.006 m/s.
Case wavy()
{
    Case c = defaultsOf(ModelKind::Film);
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {amplitude};
    c.diskSurface.waveLengths = {wave};
    return c;
}

/// Six by three cells of different widths.
CellGrid grid() { return {{0.0, 0.1e-3, 0.3e-3, 0.5e-3, 0.6e-3, 0.9e-3, 1.25e-3}, {0.0, 0.2e-3, 0.7e-3, 1.0e-3}}; }

/// The mean of sin(k (x - s)) from a to b.
double mean(double a, double b, double shift)
{
    const double k = 2.0 * std::numbers::pi / wave;
    return amplitude * (std::cos(k * (a - shift)) - std::cos(k * (b - shift))) / (k * (b - a));
}

class TestDiskUnderFilm : public QObject {
    Q_OBJECT

private slots:
    void addsNothingOfAFlatDisk()
    {
        const Case c = defaultsOf(ModelKind::Film);
        const DiskTopography surface(c.diskSurface);
        const CellGrid cells = grid();
        const PaddedGrid pad{6, 3};
        DiskUnderFilm disk(c, surface, cells, pad);
        std::vector<double> height(pad.size(), 1.0);
        disk.at(1e-6, height);
        QVERIFY(disk.flat() && !disk.moves());
        QCOMPARE(std::ranges::count(height, 0.0), static_cast<std::ptrdiff_t>(pad.size()));
    }
    /// What the film's cells see is the mean of the wave that has run by U t, with the same beyond the outline.
    void movesTheMeansWithTheDisk()
    {
        const Case c = wavy();
        const DiskTopography surface(c.diskSurface);
        const CellGrid cells = grid();
        const PaddedGrid pad{6, 3};
        DiskUnderFilm disk(c, surface, cells, pad);
        const double speed = c.disk.speed * c.disk.radius;
        QVERIFY(disk.moves());
        QVERIFY(std::abs(disk.velocity().x - speed) < 1e-12);
        std::vector<double> height(pad.size());
        const double time = 3e-6;
        disk.at(time, height);
        for (int j = -2; j < 5; ++j)
            for (int i = -2; i < 8; ++i) {
                const auto cell = static_cast<std::size_t>(std::clamp(i, 0, 5));
                const double expected = mean(cells.x[cell], cells.x[cell + 1], speed * time);
                QVERIFY2(std::abs(height[pad.at(i, j)] - expected) < 1e-18,
                         qPrintable(QString("cell %1, %2").arg(i).arg(j)));
            }
    }
    void stillIsTheSameAtAnyTime()
    {
        Case c = wavy();
        c.diskSurface.motion = SurfaceMotion::Still;
        const DiskTopography surface(c.diskSurface);
        const CellGrid cells = grid();
        const PaddedGrid pad{6, 3};
        DiskUnderFilm disk(c, surface, cells, pad);
        std::vector<double> first(pad.size()), later(pad.size());
        disk.at(0.0, first);
        disk.at(7e-6, later);
        QVERIFY(!disk.moves());
        QCOMPARE(first, later);
        QVERIFY(std::abs(first[pad.at(0, 0)] - mean(0.0, 0.1e-3, 0.0)) < 1e-18);
    }
    void allocatesNothing()
    {
        Case c = wavy();
        c.diskSurface.kind = DiskSurfaceKind::Combined;
        const DiskTopography surface(c.diskSurface);
        const CellGrid cells = grid();
        const PaddedGrid pad{6, 3};
        DiskUnderFilm disk(c, surface, cells, pad);
        std::vector<double> height(pad.size());
        disk.at(1e-6, height);
        const long long before = test::allocations;
        disk.at(2e-6, height);
        disk.at(3e-6, height);
        QCOMPARE(test::allocations.load(), before);
    }
};

TOUCHDOWN_TEST(TestDiskUnderFilm)

} // namespace test_disk_under_film

#include "test_disk_under_film.moc"
