// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/relation_text.h"

#include "core/case_files/surface_tables.h"
#include "core/formats/toml_quantity.h"
#include "core/formats/words.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace touchdown {

namespace {

constexpr std::string_view distanceKind = "abs.distance", symmetryKind = "abs.symmetric";

/// "edge 2 of rail 1", counted from 1; nothing where the text is none of this form.
std::optional<RailPlace> railPlace(std::string_view text)
{
    const auto take = [&text](std::string_view words) {
        if (!text.starts_with(words)) return false;
        text.remove_prefix(words.size());
        return true;
    };
    const auto number = [&text](std::size_t& value) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || value == 0) return false;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        --value;
        return true;
    };
    RailPlace place;
    place.edge = take("edge ");
    if (!place.edge && !take("corner ")) return {};
    if (!number(place.corner) || !take(" of rail ") || !number(place.rail) || !text.empty()) return {};
    return place;
}

class RelationReader : private SurfaceTables {
public:
    RelationReader(const TomlDocument& toml, AirBearingSurface& surface) : SurfaceTables(toml), surface_(surface) {}

    std::vector<InputProblem> read()
    {
        const bool distances = readTables(distanceKind, "distance", mostRelations, surface_.distances);
        const bool symmetries = readTables(symmetryKind, "symmetry", mostRelations, surface_.symmetries);
        std::vector<int> given(surface_.distances.size()), paired(surface_.symmetries.size()); // how many keys
        for (const TomlEntry& entry : toml_.entries) {
            if (const auto place = tablePlace(entry.key, distanceKind); place && distances)
                given[place->number - 1] += readDistance(entry, *place);
            if (const auto place = tablePlace(entry.key, symmetryKind); place && symmetries)
                paired[place->number - 1] += readSymmetry(entry, *place);
        }
        const bool good = !anyProblem();
        if (distances) needs(distanceKind, given, 4, "needs from, to, along and value");
        if (symmetries) needs(symmetryKind, paired, 1, "needs rails");
        if (!good) return takeProblems();
        refuseRepeated(distanceKind, surface_.distances, [](const KeptDistance& a, const KeptDistance& b) {
            return a.alongX == b.alongX && ((a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from));
        });
        refuseRepeated(symmetryKind, surface_.symmetries, [](const KeptSymmetry& a, const KeptSymmetry& b) {
            return a == b || a == KeptSymmetry{b.image, b.rail};
        });
        for (std::size_t i = 0; i < given.size(); ++i)
            if (given[i] == 4 && surface_.distances[i].from == surface_.distances[i].to)
                addTo(distanceKind, i, "has from and to at one place");
        return takeProblems();
    }

private:
    void addTo(std::string_view kind, std::size_t i, const std::string& message)
    {
        if (mentions(kind, i + 1)) add(lineOf(kind, i + 1), numbered(kind, i + 1), message);
    }
    void needs(std::string_view kind, const std::vector<int>& keys, int all, const char* message)
    {
        for (std::size_t i = 0; i < keys.size(); ++i)
            if (keys[i] < all) addTo(kind, i, message);
    }
    void refuseRepeated(std::string_view kind, const auto& items, const auto& same)
    {
        for (std::size_t i = 0; i < items.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (same(items[k], items[i])) {
                    addTo(kind, i, "repeats " + numbered(kind, k + 1));
                    break;
                }
    }

    /// 1 for a key of a distance.
    int readDistance(const TomlEntry& entry, const TablePlace& place)
    {
        KeptDistance& distance = surface_.distances.at(place.number - 1);
        const auto* text = std::get_if<std::string>(&entry.value);
        if (place.leaf == "from" || place.leaf == "to") {
            RailPlace& end = place.leaf == "from" ? distance.from : distance.to;
            if (const auto read = text ? railPlace(*text) : std::nullopt)
                checkPlace(entry, end = *read);
            else
                add(entry.line, entry.key, "a place is \"corner 3 of rail 1\" or \"edge 2 of rail 1\"");
        } else if (place.leaf == "along") {
            distance.alongX = text != nullptr && *text == "x";
            if (!distance.alongX && (text == nullptr || *text != "y"))
                add(entry.line, entry.key, "is neither \"x\" nor \"y\"");
        } else if (place.leaf == "value") {
            distance.value = length(entry.value, entry.line, entry.key, "um").value_or(0.0);
        } else {
            unknown(entry, place, {"from", "to", "along", "value"});
            return 0;
        }
        return 1;
    }

    bool hasRail(int line, const std::string& key, std::size_t rail)
    {
        const std::size_t count = surface_.rails.size();
        if (rail < count) return true;
        add(line, key,
            "rail " + std::to_string(rail + 1) + " does not exist: there " + (count == 1 ? "is " : "are ") +
                counted(count, "rail"));
        return false;
    }

    void checkPlace(const TomlEntry& entry, const RailPlace& place)
    {
        if (!hasRail(entry.line, entry.key, place.rail)) return;
        const std::size_t count = surface_.rails[place.rail].points.size();
        if (place.corner >= count)
            add(entry.line, entry.key,
                (place.edge ? "edge " : "corner ") + std::to_string(place.corner + 1) + " does not exist: rail " +
                    std::to_string(place.rail + 1) + " has " + counted(count, "corner"));
    }

    int readSymmetry(const TomlEntry& entry, const TablePlace& place)
    {
        if (place.leaf != "rails") {
            unknown(entry, place, {"rails"});
            return 0;
        }
        KeptSymmetry& symmetry = surface_.symmetries.at(place.number - 1);
        const auto* array = std::get_if<TomlArray>(&entry.value);
        std::vector<std::size_t> rails;
        for (std::size_t i = 0; array && i < array->elements.size(); ++i)
            if (const auto* number = std::get_if<std::int64_t>(&array->elements[i].value); number && *number > 0)
                rails.push_back(static_cast<std::size_t>(*number) - 1);
        if (array == nullptr || rails.size() != array->elements.size() || rails.empty() || rails.size() > 2) {
            add(entry.line, entry.key, "is no list of one or two numbers of rails, such as [1, 2]");
            return 1;
        }
        symmetry = {rails.front(), rails.back()};
        if (!hasRail(entry.line, entry.key, symmetry.rail) || !hasRail(entry.line, entry.key, symmetry.image)) return 1;
        const std::size_t one = surface_.rails[symmetry.rail].points.size();
        const std::size_t other = surface_.rails[symmetry.image].points.size();
        if (one != other)
            add(entry.line, entry.key,
                "has rails with " + std::to_string(one) + " and " + counted(other, "corner") +
                    "; mirror images have equally many");
        return 1;
    }

    AirBearingSurface& surface_;
};

} // namespace

std::vector<InputProblem> readRelations(const TomlDocument& toml, AirBearingSurface& surface)
{
    return RelationReader(toml, surface).read();
}

} // namespace touchdown
