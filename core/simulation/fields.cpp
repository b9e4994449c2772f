// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/fields.h"

#include "core/simulation/field_builders.h"

#include <algorithm>
#include <numeric>

namespace touchdown {

namespace {

std::vector<Field> allFields()
{
    std::vector<Field> all;
    for (auto part : {descriptionFields, springModelFields, contactFields, runFields})
        for (Field& field : part()) all.push_back(std::move(field));
    return all;
}

/// Letters to insert, delete, replace, or swap with their neighbour (Damerau 1964) to turn one word into the other.
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

std::string_view leaf(std::string_view key) { return key.substr(key.find_last_of('.') + 1); }

} // namespace

std::string Field::group() const
{
    const auto dot = key.find('.');
    return dot == std::string::npos ? std::string() : key.substr(0, dot);
}

std::span<const Field> fields()
{
    static const std::vector<Field> all = allFields();
    return all;
}

const Field* findField(std::string_view key)
{
    const auto all = fields();
    const auto found = std::ranges::find(all, key, &Field::key);
    return found == all.end() ? nullptr : &*found;
}

std::string nearestKey(std::string_view key)
{
    constexpr std::size_t longest = 100; // no key is nearly as long
    if (key.empty() || key.size() > longest) return {};
    const Field* nearest = nullptr;
    std::size_t least = 1 + key.size() / 5;
    for (const Field& field : fields()) {
        const std::size_t distance = editDistance(key, field.key);
        if (distance < least || (distance == least && nearest == nullptr)) {
            nearest = &field;
            least = distance;
        }
    }
    if (nearest != nullptr) return nearest->key;

    // The right name in the wrong table, or in none.
    std::size_t leastLeaf = leaf(key).size() / 5;
    for (const Field& field : fields()) {
        const std::size_t distance = editDistance(leaf(key), leaf(field.key));
        if (distance < leastLeaf || (distance == leastLeaf && nearest == nullptr)) {
            nearest = &field;
            leastLeaf = distance;
        }
    }
    return nearest != nullptr ? nearest->key : std::string();
}

} // namespace touchdown
