// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/nearest_name.h"

#include <algorithm>
#include <numeric>

namespace touchdown {

namespace {

std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        beforeLast.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

} // namespace

std::string nearestName(std::string_view name, const std::vector<std::string>& names, std::size_t most)
{
    constexpr std::size_t longest = 100; // no name is nearly as long
    if (name.empty() || name.size() > longest) return {};
    std::string nearest;
    std::size_t least = most + 1;
    for (const std::string& candidate : names) {
        const std::size_t distance = editDistance(name, candidate);
        if (distance >= least) continue;
        nearest = candidate;
        least = distance;
    }
    return nearest;
}

std::string nearestName(std::string_view name, const std::vector<std::string>& names)
{
    return nearestName(name, names, 1 + name.size() / 5);
}

std::string didYouMean(const std::string& name) { return name.empty() ? name : "; did you mean " + name + "?"; }

} // namespace touchdown
