// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/scene_motion.h"

#include <algorithm>
#include <cmath>

#include "core/studies/advice/pilot_run.h"

namespace touchdown {

namespace {

constexpr double mostGrowth = 0.3; // e-folds of a mode over the run, beyond which a part does not predict its end

bool hasNoOrder(const DiskSurface& surface)
{
    return surface.kind != DiskSurfaceKind::Flat && surface.kind != DiskSurfaceKind::Waves &&
           surface.motion == SurfaceMotion::Moving;
}

} // namespace

bool SceneMotion::predicts() const { return growth <= mostGrowth && growthProblem.empty() && !roughPasses; }

SceneMotion sceneMotion(const Case& c, const GoOn& goOn)
{
    const double begin = threadSeconds();
    SceneMotion scene;
    scene.roughPasses = hasNoOrder(c.diskSurface);
    scene.motion = linearMotion(c, [&](const SteadyProgress&) { return !goOn || goOn(); });
    const LinearMotion& motion = scene.motion;
    if (motion.modes.empty())
        scene.growthProblem = motion.message.empty() ? "no static state was found" : motion.message;
    for (const MotionTerm& mode : motion.modes) {
        scene.rates.push_back({mode.rate, false});
        scene.growth = std::max(scene.growth, mode.rate.real() * c.run.duration);
    }
    // Air that creeps out of the cavity takes about as long as the disk drags it along under the slider.
    const double speed = std::abs(c.disk.speed) * c.disk.radius;
    if (!scene.rates.empty() && speed > 0.0) scene.rates.push_back({-speed / c.slider.length, false});
    for (const MotionTerm& wave : motion.waves) scene.rates.push_back({wave.rate, true});
    scene.seconds = threadSeconds() - begin;
    return scene;
}

} // namespace touchdown
