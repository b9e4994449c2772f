// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/damping_doubt.h"

#include <QTest>

#include "core/case/case.h"
#include "core/numerics/spectrum.h"
#include "core/physics/disk/disk_velocity.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_damping_doubt {

constexpr double duration = 1e-3;

std::vector<Peak> peaks()
{
    Peak strong, fast, weak;
    strong.frequency = 100e3;
    strong.amplitude = 1e-9;
    fast.frequency = 250e3;
    fast.amplitude = 0.2e-9;
    weak.frequency = 700e3;
    weak.amplitude = 0.05e-9;
    return {strong, fast, weak};
}

std::string told(const Case& c, double resolved, const UnfittedSteps& unfitted)
{
    std::string text;
    for (const std::string& doubt : doubtsOnDamping(c, peaks(), resolved, unfitted, duration)) text += doubt + "\n";
    return text;
}

/// All steps of a run that takes so many in a period of the fast peak.
UnfittedSteps all(double perPeriod) { return {static_cast<long long>(perPeriod * 250e3 * duration), duration}; }

class TestDampingDoubt : public QObject {
    Q_OBJECT

private slots:
    void noneWithoutReason()
    {
        const Case c;
        QVERIFY(told(c, 300e3, {}).empty());
        QVERIFY(told(c, 300e3, {4, 1e-6}).empty());      // the first steps
        QVERIFY(told(c, 300e3, {500, 0.05e-3}).empty()); // a short contact
        QVERIFY(told(c, 300e3, all(61.0)).empty());      // short steps
        QVERIFY(doubtsOnDamping(c, {}, 1.0, all(10.0), duration).empty());
        QVERIFY(told(c, 0.0, {}).empty()); // a disk at rest
    }
    /// Of the peaks of at least a tenth of the largest, the fastest counts.
    void cells()
    {
        const std::string text = told({}, 200e3, {});
        QVERIFY2(text.find("at 250 kHz depends on the grid: above 200 kHz") != std::string::npos, text.c_str());
        QVERIFY(text.find("film.nodes") != std::string::npos && text.find("steps") == std::string::npos);
    }
    /// A motion that waves of the disk force, with its harmonics, is as large as they make it: its damping is not
    /// asked.
    void noneAboutWhatTheDiskForces()
    {
        Case c;
        c.diskSurface.kind = DiskSurfaceKind::Waves;
        c.diskSurface.waveAmplitudes = {1e-9};
        const Velocity velocity =
            diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width);
        const auto forcedAt = [&](double frequency) {
            c.diskSurface.waveLengths = {velocity.x / frequency};
            return c;
        };
        QVERIFY(told(forcedAt(250e3), 200e3, all(30.0)).empty()); // 75 steps in a period of the other one
        QVERIFY(!told({}, 300e3, all(30.0)).empty());
        QVERIFY(told(forcedAt(125e3), 200e3, {}).empty());
        QVERIFY(told(forcedAt(230e3), 200e3, {}).find("at 250 kHz") != std::string::npos);
        QVERIFY(told(forcedAt(250e3), 90e3, {}).find("at 100 kHz") != std::string::npos);
        forcedAt(250e3);
        c.diskSurface.waveAmplitudes = {0.0};
        QVERIFY(told(c, 200e3, {}).find("at 250 kHz") != std::string::npos);
        c.diskSurface.waveAmplitudes = {1e-9};
        c.diskSurface.motion = SurfaceMotion::Still;
        QVERIFY(told(c, 200e3, {}).find("at 250 kHz") != std::string::npos);
    }
    void steps()
    {
        Case c;
        std::string text = told(c, 300e3, all(20.0));
        QVERIFY2(text.find("the motion at 250 kHz: in 100 % of the run there were 20 steps a period") !=
                     std::string::npos,
                 text.c_str());
        QVERIFY(text.find("by more than a quarter") != std::string::npos && text.find("67 ns") != std::string::npos);
        QVERIFY(text.find("film.nodes") == std::string::npos);
        c.run.steps = StepControl::Fixed;
        text = told(c, 300e3, all(20.0));
        QVERIFY2(text.find("run.steps = \"adaptive\"") != std::string::npos, text.c_str());
        c.film.coupling = FilmCoupling::Staggered;
        text = told(c, 200e3, {500, 0.11e-3});
        QVERIFY2(text.find("film.coupling = \"monolithic\"") != std::string::npos, text.c_str());
        QVERIFY(text.find("in 11 % of the run") != std::string::npos && text.find("film.nodes") != std::string::npos);
    }
};

TOUCHDOWN_TEST(TestDampingDoubt)

} // namespace test_damping_doubt

#include "test_damping_doubt.moc"
