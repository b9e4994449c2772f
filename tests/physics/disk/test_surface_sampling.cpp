// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_sampling.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_sampling {

DiskSurface wave(double length, double angle)
{
    DiskSurface surface;
    surface.kind = DiskSurfaceKind::Waves;
    surface.waveAmplitudes = {1e-9};
    surface.waveLengths = {length};
    surface.waveAngles = {angle};
    surface.track = 64e-6;
    surface.trackWidth = 16e-6;
    return surface;
}

UniformGrid cells(int count, double side) { return {count, count, side, side, 0.0, 0.0}; }

class TestSurfaceSampling : public QObject {
    Q_OBJECT

private slots:
    /// In the middle of four cells a wave along x exceeds their mean by 1 - cos(pi cell/length) of itself.
    void unresolved_data()
    {
        QTest::addColumn<double>("cellsInWave");
        QTest::newRow("8 cells") << 8.0;
        QTest::newRow("4 cells") << 4.0;
        QTest::newRow("2.5 cells") << 2.5;
    }
    void unresolved()
    {
        QFETCH(double, cellsInWave);
        const double cell = 0.5e-6;
        const SurfaceSampling sampling =
            surfaceSampling(DiskTopography(wave(cellsInWave * cell, 0.0)), cells(16, cell));
        const double share = 1.0 - std::cos(std::numbers::pi / cellsInWave);
        QVERIFY2(std::abs(sampling.unresolved / (share * 1e-9 / std::numbers::sqrt2) - 1.0) < 0.02,
                 qPrintable(QString::number(sampling.unresolved)));
    }

    /// A map of cells as large as the patch's, whose centres lie halfway between its points: the spline passes these
    /// lower. On the points nothing is lost.
    void betweenThePoints()
    {
        DiskSurface rough;
        rough.kind = DiskSurfaceKind::Rough;
        rough.spectrum = RoughnessSpectrum::Exponential;
        rough.rms = 1e-9;
        rough.correlationLength = 1e-6;
        rough.cell = 0.25e-6;
        rough.track = 128e-6;
        rough.trackWidth = 64e-6;
        const DiskTopography surface(rough);
        const SurfaceSampling halfway = surfaceSampling(surface, cells(16, 0.25e-6));
        QVERIFY(std::abs(halfway.rmsOfMap / 1e-9 - 1.0) < 1e-6); // the whole period
        QVERIFY2(halfway.rms < 0.98e-9 && halfway.rms > 0.95e-9, qPrintable(QString::number(halfway.rms)));
        const SurfaceSampling onPoints = surfaceSampling(surface, {16, 16, 0.25e-6, 0.25e-6, -0.125e-6, -0.125e-6});
        QVERIFY(std::abs(onPoints.rms / 1e-9 - 1.0) < 1e-6);
    }

    /// A wave of 8 um repeats after 16 um, not after 18 um: at a quarter of a wave, and more, it jumps.
    void seam()
    {
        const DiskTopography surface(wave(8e-6, 0.0));
        QVERIFY(largestSeam(surface, cells(16, 1e-6)) < 1e-18);
        const UniformGrid other = cells(18, 1e-6);
        const double jump = std::abs(surface.height(18.5e-6, 0.0) - surface.height(0.5e-6, 0.0));
        QVERIFY(jump > 0.5e-9);
        QVERIFY(std::abs(largestSeam(surface, other) - jump) < 1e-18);
    }
};

TOUCHDOWN_TEST(TestSurfaceSampling)

} // namespace test_surface_sampling

#include "test_surface_sampling.moc"
