// SPDX-License-Identifier: GPL-3.0-or-later
//
// Derivatives of the film's residual by the attitude.
#include <algorithm>

#include "core/physics/film/gas_film.h"

namespace touchdown {

void GasFilm::AttitudeWork::resize(std::size_t size)
{
    if (!flows.flow[0].empty()) return;
    flows.resize(size);
    flows.stored.assign(size, 0.0);
    for (GapSlopes& axis : slopes)
        for (auto* field : {&axis.flowByGap, &axis.flowByRise, &axis.ownByGap, &axis.ownByRise})
            field->assign(size, 0.0);
}

/// out += derivatives by the attitude's number k of the faces' gaps and rises times those of the flow by them.
void GasFilm::addByAttitude(std::size_t axis, std::size_t k, const std::vector<double>& byGap,
                            const std::vector<double>& byRise, std::vector<double>& out) const
{
    const PaddedGrid& pad = gaps().pad;
    const FilmGaps::Faces& paths = gaps().faces[axis];
    const double* x = axis == 0 ? paths.pathMid.data() : centresX().data();
    const std::size_t count = static_cast<std::size_t>(pad.nx + (axis == 0));
    for (int j = 0; j < pad.ny + (axis == 1); ++j) {
        const std::size_t line = static_cast<std::size_t>(j), first = pad.at(0, j);
        const double y = axis == 0 ? gaps().grid.centreY(j) : paths.pathMid[line];
        const double lift = k == 0 ? 1.0 : 0.5 * gaps().width - y; // of height, of roll
        const double *gap = byGap.data() + first, *rise = byRise.data() + first;
        double* to = out.data() + first;
        if (k == 1)
            for (std::size_t i = 0; i < count; ++i) to[i] += (gaps().length - x[i]) * gap[i];
        else
            for (std::size_t i = 0; i < count; ++i) to[i] += lift * gap[i];
        if (k == 1 && axis == 0)
            for (std::size_t i = 0; i < count; ++i) to[i] -= paths.pathLength[i] * rise[i];
        if (k == 2 && axis == 1)
            for (std::size_t i = 0; i < count; ++i) to[i] -= paths.pathLength[line] * rise[i];
    }
}

void GasFilm::attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out,
                              AttitudeWork& work) const
{
    work.resize(p.size());
    auto& [row, slopes, flows, cutFlows] = work;
    setGapSlopes(p, work);
    for (std::size_t axis = 0; axis < 2; ++axis)
        axes()[axis].cutPaths.flows(p, attitude(), axes()[axis].cutSurface, table_, air().viscosity, row.cut,
                                    cutFlows[axis]);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::size_t step = gaps().pad.step(static_cast<int>(axis));
            std::fill(flows.flow[axis].begin(), flows.flow[axis].end(), 0.0);
            addByAttitude(axis, k, slopes[axis].flowByGap, slopes[axis].flowByRise, flows.flow[axis]);
            for (std::size_t n = 0; n < cutFlows[axis].size(); ++n) {
                const std::size_t at = gaps().faces[axis].cut[n].at;
                flows.flow[axis][at] = cutFlows[axis][n].A.by[k] * p[at - step] - cutFlows[axis][n].B.by[k] * p[at];
            }
        }
        if (storagePerTime_ != 0.0)
            setVolumeSlopes(k, storagePerTime_, p, flows.stored);
        else
            flows.stored.clear();
        if (complete()) {
            setSlopes(flows);
            completeChanges(flows);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                addByAttitude(axis, k, slopes[axis].ownByGap, slopes[axis].ownByRise, flows.flow[axis]);
                addCutCorrections(axis, k, p, cutFlows[axis], flows.flow[axis]);
            }
        }
        out[k].assign(p.size(), 0.0);
        divergence(flows, out[k]);
    }
}

void GasFilm::addCutCorrections(std::size_t axis, std::size_t k, std::span<const double> p,
                                const std::vector<PathFlow<ByAttitude>>& cutFlows, std::vector<double>& out) const
{
    const FilmFaces& f = faces_[axis];
    const std::size_t step = gaps().pad.step(static_cast<int>(axis));
    for (std::size_t n = 0; n < cutFlows.size(); ++n) {
        const std::size_t at = gaps().faces[axis].cut[n].at;
        const PathFlow<ByAttitude>& flow = cutFlows[n];
        const double inflow = axes()[axis].speed[at] < 0.0 ? flow.B.by[k] * p[at] : flow.A.by[k] * p[at - step];
        out[at] -= f.share[at] * (slope_[axis][at - step] * flow.below.by[k] + slope_[axis][at] * flow.above.by[k]) +
                   f.inflowShare[at] * inflow;
    }
}

void GasFilm::attitudeStorageColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out,
                                     AttitudeWork& work) const
{
    work.resize(p.size());
    FaceFlows<double>& flows = work.flows;
    for (std::size_t k = 0; k < 3; ++k) {
        for (auto& flow : flows.flow) std::fill(flow.begin(), flow.end(), 0.0);
        setVolumeSlopes(k, 1.0, p, flows.stored);
        if (complete()) {
            setSlopes(flows);
            completeChanges(flows);
        }
        out[k].assign(p.size(), 0.0);
        divergence(flows, out[k]);
    }
}

} // namespace touchdown
