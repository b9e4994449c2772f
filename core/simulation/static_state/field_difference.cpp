// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/field_difference.h"

#include "core/physics/film/film_grid.h"
#include "core/physics/slider/recess.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

FieldDifference fieldDifference(const Case& first, const SteadyResult& firstState, const Case& second,
                                const SteadyResult& secondState)
{
    const CellGrid& grid = firstState.grid;
    const double ambient = airOf(first.air).pressure, otherAmbient = airOf(second.air).pressure;
    const std::vector<double> other = transfer(secondState.grid, secondState.pressure, otherAmbient, grid);
    const FilmGaps gaps(Recess(second.surface, second.slider.length, second.slider.width), grid);
    const std::vector<double> otherRecess = gaps.pad.unpad<double>(gaps.meanRecess);
    FieldDifference difference;
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        const auto nx = static_cast<std::size_t>(grid.nx());
        const double x = grid.centreX(static_cast<int>(cell % nx)), y = grid.centreY(static_cast<int>(cell / nx));
        const double otherGap = otherRecess[cell] + gaps.lift(secondState.attitude, x, y);
        difference.pressure.push_back((firstState.pressure[cell] - ambient) - (other[cell] - otherAmbient));
        difference.gap.push_back(firstState.gap[cell] - otherGap);
        difference.recess.push_back(firstState.recess[cell] - otherRecess[cell]);
    }
    return difference;
}

} // namespace touchdown
