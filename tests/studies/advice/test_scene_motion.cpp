// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <numbers>

#include "core/studies/advice/pilot_run.h"
#include "tests/support/taper_flat.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_scene_motion {

class TestSceneMotion : public QObject {
    Q_OBJECT

private slots:
    void aQuietSceneForetells();
    void wavesDriveItAtTheirOwnRate();
    void aRoughDiskThatPassesByTellsNothing_data();
    void aRoughDiskThatPassesByTellsNothing();
    void whatGrowsIsNotForetold();
    void withoutModesNothingIsForetold();
};

// Two modes and air that creeps at U/L.
void TestSceneMotion::aQuietSceneForetells()
{
    const Case c = test::taperFlat();
    const SceneMotion scene = sceneMotion(c, {});
    QVERIFY(scene.predicts());
    QCOMPARE(scene.growth, 0.0);
    QCOMPARE(scene.rates.size(), 3u);
    QVERIFY(scene.rates[0].rate.real() < 0.0 && !scene.rates[0].fixed);
    QCOMPARE(scene.rates[2].rate, std::complex<double>(-c.disk.speed * c.disk.radius / c.slider.length));
}

void TestSceneMotion::wavesDriveItAtTheirOwnRate()
{
    Case c = test::taperFlat();
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {1e-9};
    c.diskSurface.waveLengths = {c.disk.speed * c.disk.radius / 100e3}; // passes at 100 kHz
    const SceneMotion scene = sceneMotion(c, {});
    QVERIFY(scene.predicts());
    QVERIFY(scene.rates.back().fixed);
    QVERIFY(std::abs(std::abs(scene.rates.back().rate.imag()) / (2.0 * std::numbers::pi * 100e3) - 1.0) <
            0.01); // the velocity varies along the slider
}

void TestSceneMotion::aRoughDiskThatPassesByTellsNothing_data()
{
    QTest::addColumn<bool>("moves");
    QTest::newRow("it moves") << true;
    QTest::newRow("it stands still") << false;
}

void TestSceneMotion::aRoughDiskThatPassesByTellsNothing()
{
    QFETCH(bool, moves);
    Case c = test::taperFlat();
    c.diskSurface.kind = DiskSurfaceKind::Rough;
    c.diskSurface.motion = moves ? SurfaceMotion::Moving : SurfaceMotion::Still;
    QCOMPARE(sceneMotion(c, {}).predicts(), !moves);
}

// A mode that grows by 0.3 e-folds is no more hidden than one that dies away as slowly.
void TestSceneMotion::whatGrowsIsNotForetold()
{
    SceneMotion scene;
    scene.growth = 0.2;
    QVERIFY(scene.predicts());
    scene.growth = 0.4;
    QVERIFY(!scene.predicts());
}

// Critical damping, 2 sqrt(k m), of 1.6 mg on some MN/m of air is a few N s/m: with a hundred the heave does not
// oscillate.
void TestSceneMotion::withoutModesNothingIsForetold()
{
    Case c = test::taperFlat();
    c.suspension.damping = 100.0;
    const SceneMotion scene = sceneMotion(c, {});
    QVERIFY(!scene.growthProblem.empty() && scene.rates.empty());
    QVERIFY(!scene.predicts());
}

TOUCHDOWN_TEST(TestSceneMotion)

} // namespace test_scene_motion

#include "test_scene_motion.moc"
