// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/model_defaults.h"

namespace touchdown {

bool takeModelDefaults(Case& c, ModelKind before, const std::function<bool(const Parameter&)>& stated)
{
    const Case old = defaultsOf(before), now = defaultsOf(c.model);
    bool changed = false;
    for (const Parameter& parameter : parameters()) {
        const ParameterValue value = parameter.get(now);
        if (parameter.key == "model" || value == parameter.get(old) || stated(parameter)) continue;
        if (parameter.get(c) != parameter.get(old)) continue;
        parameter.set(c, value);
        changed = true;
    }
    return changed;
}

bool takeFilmStart(Case& c)
{
    const InitialCase usual = defaultsOf(ModelKind::Film).initial;
    const auto same = [&](auto InitialCase::*member) { return c.initial.*member == usual.*member; };
    const bool byDefault = same(&InitialCase::state) && same(&InitialCase::nominalTrailingEdgeHeight) &&
                           same(&InitialCase::pitch) && same(&InitialCase::roll);
    if (c.model != ModelKind::Film || !byDefault) return false;
    c.initial.state = InitialState::Static;
    return true;
}

bool takeFirstUnevenness(Case& c)
{
    DiskSurface& disk = c.diskSurface;
    if (disk.kind == DiskSurfaceKind::Waves && disk.waveAmplitudes.empty() && disk.waveLengths.empty()) {
        disk.waveAmplitudes = {0.5e-9};
        disk.waveLengths = {100e-6};
        return true;
    }
    if (disk.kind == DiskSurfaceKind::Bumps && disk.bumpHeights.empty() && disk.bumpLengths.empty()) {
        disk.bumpHeights = {5e-9};
        disk.bumpLengths = {10e-6};
        disk.bumpX = disk.bumpY = {0.0};
        disk.bumpShape = BumpShape::Cosine; // an ellipsoid is vertical at its base, which moving springs do not bear
        return true;
    }
    return false;
}

} // namespace touchdown
