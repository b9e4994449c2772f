// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/followed_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/springs/spring_model.h"
#include "core/studies/response/response.h"
#include "core/studies/response/response_result.h"
#include "tests/support/impact_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_followed_motion {

ResponseTask taskOf(const Case& c, double amplitude, double wavelength)
{
    ResponseTask task;
    task.start = c;
    task.quantity = SpringModel::quantities(c)[std::size_t(findQuantity(SpringModel::quantities(c), "flying_height"))];
    task.amplitude = amplitude;
    task.wavelength = wavelength;
    takeSprings(task);
    return task;
}

ForcedMotion motionAt(const ResponseTask& task, double frequency, const ForcedState* start = nullptr)
{
    const std::unique_ptr<ForcedSlider> springs = task.sliderAt(frequency);
    ForcedMotion motion = settledMotion(*springs, start == nullptr ? springs->start() : *start, task.settle);
    motion.frequency = frequency;
    return motion;
}

/// Distance of a state from where it was, after so many periods at a frequency, in amplitudes of the wave.
double moved(const ResponseTask& task, const ForcedState& from, double frequency, int periods)
{
    const std::unique_ptr<ForcedSlider> springs = task.sliderAt(frequency);
    ForcedState at = springs->continued(from);
    for (int k = 0; k < periods; ++k) at = springs->run(at, {}).end;
    return std::abs(at.y[0] - from.y[0]) / task.amplitude;
}

class TestFollowedMotion : public QObject {
    Q_OBJECT

private slots:
    /// The air springs soften: with little damping the large motion, followed downwards, ends at a fold, and the small
    /// one, followed upwards, at another. Drawn slides over drawn waves. Thrice the distance of the two bounds before
    /// the end a long run keeps the motion, thrice beyond it leaves the motion. At a distance e [-] beyond a fold a
    /// motion stays for about 1/sqrt(e) periods: 600 for 3e-6.
    void endsHoldAgainstLongRuns()
    {
        std::mt19937 draw(1);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        int ends = 0;
        for (int set = 0; set < 2; ++set) {
            Case c = openCase("springs_waviness").value;
            c.contact = noContact;
            c.springs.flyingHeight = c.initial.flyingHeight = 6.5e-9 + 1e-9 * share(draw);
            const ResponseTask task = taskOf(c, 0.4e-9 + 0.2e-9 * share(draw), 45e-6 + 10e-6 * share(draw));
            for (const bool down : {false, true}) {
                FollowedMotion way(task, motionAt(task, down ? 290e3 : 200e3));
                QVERIFY(!way.to(down ? 200e3 : 290e3));
                const double gap = way.beyond() - way.frequency();
                QVERIFY(std::abs(gap) <= 1e-6 * way.frequency());
                const ForcedState last = way.motion().end;
                QVERIFY2(moved(task, last, way.frequency() - 3.0 * gap, 1500) < 0.1, "leaves before the end");
                QVERIFY2(moved(task, last, way.beyond() + 3.0 * gap, 4000) > 0.5, "stays beyond the end");
                ++ends;
            }
        }
        QCOMPARE(ends, 4);
    }

    /// An elastic stop: the motion with impacts ends at the fold of the exact solution, which takes the springs as
    /// linear, as they are to a hundred-thousandth (wave/height).
    void foldOfAnElasticStop()
    {
        const ImpactOscillator oscillator{0.05, 6.0, 3.0};
        const ResponseTask task = taskOf(oscillator.slider(), ImpactOscillator::wave, ImpactOscillator::length);
        FollowedMotion way(task, motionAt(task, ImpactOscillator::frequency));
        const double fold = oscillator.fold() * ImpactOscillator::frequency;
        QVERIFY(way.to(0.99 * fold));
        QCOMPARE(way.frequency(), 0.99 * fold);
        QVERIFY(!way.to(1.05 * fold));
        const double error = std::abs(way.frequency() / fold - 1.0);
        QVERIFY2(error < 1e-4, qPrintable(QString::number(error)));
    }

    /// Followed to a frequency, it is the motion to which a run settles there.
    void isTheMotionThatSettles()
    {
        Case c = openCase("springs_waviness").value;
        const ResponseTask task = taskOf(c, 0.5e-9, 50e-6);
        FollowedMotion way(task, motionAt(task, 100e3));
        for (const double frequency : {104e3, 140e3, 190e3, 120e3}) {
            QVERIFY(way.to(frequency));
            QVERIFY(sameMotion(way.motion(), motionAt(task, frequency)));
        }
    }
};

TOUCHDOWN_TEST(TestFollowedMotion)

} // namespace test_followed_motion

#include "test_followed_motion.moc"
