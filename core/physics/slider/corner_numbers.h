// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of rails and corners through an edit that changes them, so that kept distances and symmetries stay with
// their corners. The list is changed as the rails are; at the end it renumbers the relations of the surface.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

class CornerNumbers {
public:
    using Old = std::optional<std::pair<std::size_t, std::size_t>>; // rail and corner before; a new corner has none

    explicit CornerNumbers(const AirBearingSurface& before);

    /// The corners of each rail, as they are now.
    std::vector<std::vector<Old>>& rails() { return rails_; }
    void insert(std::size_t rail, std::size_t corner);
    void erase(std::size_t rail, std::size_t corner);
    void eraseRail(std::size_t rail);

    /// Removes a distance of which a corner or an edge is no more, and a symmetry of a rail whose corners are not the
    /// same ones.
    void apply(AirBearingSurface& surface) const;

private:
    std::vector<std::vector<Old>> rails_;
    std::vector<std::size_t> counts_; // corners of each rail before
};

} // namespace touchdown
