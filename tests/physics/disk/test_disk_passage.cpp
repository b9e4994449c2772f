// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_passage.h"

#include <cmath>

#include <QTest>

#include "core/physics/disk/disk_topography.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_passage {

class TestDiskPassage : public QObject {
    Q_OBJECT

private slots:
    void wavesPassAtTheirAngle()
    {
        DiskSurface s;
        s.kind = DiskSurfaceKind::Waves;
        s.waveAmplitudes = {1e-9, 1e-9};
        s.waveLengths = {160e-6, 32e-6};
        QCOMPARE(finestPassage(s, {10.0, 0.0}), 32e-6 / 16.0 / 10.0);
        s.waveAngles = {0.0, std::acos(0.125)}; // the short one crosses the track, at an eighth of the speed
        QVERIFY(std::abs(finestPassage(s, {10.0, 0.0}) - 160e-6 / 16.0 / 10.0) < 1e-18);
        QVERIFY(std::isinf(finestPassage(s, {})));
    }
    void mapsPassByHalfACell()
    {
        DiskSurface s;
        s.kind = DiskSurfaceKind::Rough;
        s.cell = 0.25e-6;
        QVERIFY(std::abs(finestPassage(s, {10.0, -2.0}) - 12.5e-9) < 1e-20);
        s.kind = DiskSurfaceKind::File;
        const HeightMap map{.nx = 8, .ny = 4, .dx = 2e-6, .dy = 0.1e-6, .heights = std::vector(32, 1e-9)};
        QVERIFY(std::abs(finestPassage(s, DiskTopography(s, map), {10.0, -2.0}) - 25e-9) < 1e-20);
        const HeightMap profile{.nx = 8, .ny = 1, .dx = 2e-6, .dy = 0.1e-6, .heights = std::vector(8, 1e-9)};
        QVERIFY(std::abs(finestPassage(s, DiskTopography(s, profile), {10.0, -2.0}) - 100e-9) < 1e-20);
    }
    void bumpsPassByTheirBase()
    {
        DiskSurface s;
        s.kind = DiskSurfaceKind::Bumps;
        s.bumpHeights = {1e-9};
        s.bumpLengths = {32e-6};
        QVERIFY(std::abs(finestPassage(s, {10.0, 4.0}) - 0.2e-6) < 1e-18); // as wide as long
        s.bumpWidths = {8e-6};
        QVERIFY(std::abs(finestPassage(s, {10.0, 4.0}) - 0.125e-6) < 1e-18);
        s.kind = DiskSurfaceKind::Flat;
        QVERIFY(std::isinf(finestPassage(s, {10.0, 4.0})));
    }
};

TOUCHDOWN_TEST(TestDiskPassage)

} // namespace test_disk_passage

#include "test_disk_passage.moc"
