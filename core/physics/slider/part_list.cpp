// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/part_list.h"

namespace touchdown {

std::string partList(const std::string& name, const std::vector<std::size_t>& indices)
{
    constexpr std::size_t most = 5;
    const std::size_t named = indices.size() > most ? most - 1 : indices.size();
    std::string list = name + (indices.size() == 1 ? " " : "s ");
    for (std::size_t i = 0; i < named; ++i) {
        if (i > 0) list += i + 1 == indices.size() ? " and " : ", ";
        list += std::to_string(indices[i] + 1);
    }
    if (named < indices.size()) list += " and " + std::to_string(indices.size() - named) + " more";
    return list;
}

} // namespace touchdown
