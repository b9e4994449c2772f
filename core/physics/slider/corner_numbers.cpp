// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/corner_numbers.h"

#include <algorithm>
#include <map>
#include <utility>

namespace touchdown {

CornerNumbers::CornerNumbers(const AirBearingSurface& before)
{
    for (std::size_t i = 0; i < before.rails.size(); ++i) {
        counts_.push_back(before.rails[i].points.size());
        rails_.emplace_back();
        for (std::size_t k = 0; k < counts_.back(); ++k) rails_.back().emplace_back(std::pair(i, k));
    }
}

void CornerNumbers::insert(std::size_t rail, std::size_t corner)
{
    rails_[rail].insert(rails_[rail].begin() + static_cast<std::ptrdiff_t>(corner), Old{});
}

void CornerNumbers::erase(std::size_t rail, std::size_t corner)
{
    rails_[rail].erase(rails_[rail].begin() + static_cast<std::ptrdiff_t>(corner));
}

void CornerNumbers::eraseRail(std::size_t rail) { rails_.erase(rails_.begin() + static_cast<std::ptrdiff_t>(rail)); }

void CornerNumbers::apply(AirBearingSurface& surface) const
{
    if (surface.distances.empty() && surface.symmetries.empty()) return;
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> now;
    for (std::size_t i = 0; i < rails_.size(); ++i)
        for (std::size_t k = 0; k < rails_[i].size(); ++k)
            if (rails_[i][k]) now[*rails_[i][k]] = {i, k};
    // False: the place or the rail is no more.
    const auto follow = [&](RailPlace& place) {
        const auto first = now.find({place.rail, place.corner});
        if (first == now.end()) return false;
        const auto second = now.find({place.rail, (place.corner + 1) % counts_[place.rail]});
        const auto [rail, corner] = first->second;
        if (place.edge && second == now.end()) return false; // of an edge that is parted the first half counts
        place = {rail, corner, place.edge};
        return true;
    };
    const auto followRail = [&](std::size_t& rail) {
        const auto first = now.find({rail, 0});
        if (first == now.end()) return false;
        const std::vector<Old>& corners = rails_[first->second.first];
        if (corners.size() != counts_[rail]) return false;
        const bool same = std::ranges::all_of(corners, [rail](const Old& each) { return each && each->first == rail; });
        rail = first->second.first;
        return same;
    };
    for (KeptDistance each : std::exchange(surface.distances, {}))
        if (follow(each.from) && follow(each.to)) surface.distances.push_back(each);
    for (KeptSymmetry each : std::exchange(surface.symmetries, {}))
        if (followRail(each.rail) && followRail(each.image)) surface.symmetries.push_back(each);
}

} // namespace touchdown
