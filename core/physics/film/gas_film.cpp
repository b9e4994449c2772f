// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gas_film.h"

#include <algorithm>

namespace touchdown {

FaceWork::FaceWork(const FilmGaps& gaps) : cut(gaps)
{
    for (auto* row : {&product, &mobility, &mobilityByProduct, &mobilityByGap, &width, &length, &share})
        row->assign(gaps.pad.stride(), 0.0);
}

GasFilm::GasFilm(const FilmGaps& gaps, const FilmSetting& setting)
    : FilmGeometry(gaps, setting.disk), setting_(setting), table_(setting.slip, setting.air), row_(gaps)
{
    for (std::size_t axis = 0; axis < 2; ++axis) {
        FilmFaces& f = faces_[axis];
        for (auto* field : {&f.flow, &f.inflow, &f.lower, &f.upper, &f.share, &f.inflowShare, &f.below, &f.above,
                            &f.ownLower, &f.ownUpper, &f.diffusion, &f.effective, &f.convection, &slope_[axis]})
            field->assign(pad().size(), 0.0);
        for (FaceMoments& m : rows_.moments[axis])
            for (auto* row : {&m.below, &m.above, &m.belowByMean, &m.aboveByMean, &m.inflowByLower, &m.inflowByUpper})
                row->assign(pad().stride(), 0.0);
        for (auto* rows : {&rows_.flow[axis], &rows_.slope[axis]}) rows->assign(2 * pad().stride(), 0.0);
        cutFlows_[axis].resize(gaps.faces[axis].cut.size());
        cutFlowsByPressure_[axis].resize(gaps.faces[axis].cut.size());
    }
    rows_.stored.assign(2 * pad().stride(), 0.0);
    noStorage_.assign(pad().stride(), 0.0);
    for (int j = 0; j <= pad().ny + 1; ++j) {
        const std::size_t row = pad().at(-PaddedGrid::rings, j);
        const std::vector<std::size_t>& stepped = gaps.steppedCells;
        steppedRows_.push_back(
            static_cast<std::size_t>(std::lower_bound(stepped.begin(), stepped.end(), row) - stepped.begin()));
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::vector<CutPlace>& cut = gaps.faces[axis].cut;
            const auto isBefore = [](const CutPlace& place, std::size_t at) { return place.at < at; };
            cutRows_[axis].push_back(
                static_cast<std::size_t>(std::lower_bound(cut.begin(), cut.end(), row, isBefore) - cut.begin()));
        }
    }
}

double GasFilm::flowScale() const
{
    const double length = gaps().length, volume = std::max(totalVolume(), length * gaps().width * closedGap);
    return 0.5 * ambient() * std::max(speed(), 1e-3) * volume / length;
}

void GasFilm::setStorage(double perTime, std::span<const double> history)
{
    storagePerTime_ = perTime;
    history_ = history;
}

} // namespace touchdown
