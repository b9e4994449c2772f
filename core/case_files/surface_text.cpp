// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/surface_text.h"

#include "core/formats/nearest_name.h"
#include "core/formats/toml_quantity.h"
#include "core/formats/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace touchdown {

namespace {

constexpr double farthest = 1.0; // of any length [m]
constexpr std::string_view interestKey = "abs.points_of_interest";

/// "abs.rail[12].recess" -> 12 and "recess"; nothing when the key is not of this kind.
struct Place {
    std::size_t number; // from 1
    std::string_view leaf;
};
std::optional<Place> placeOf(std::string_view key, std::string_view kind)
{
    if (!key.starts_with(kind) || key.size() == kind.size() || key[kind.size()] != '[') return {};
    const std::size_t close = key.find(']', kind.size());
    if (close == std::string_view::npos) return {};
    Place place{0, key.substr(close + 1)};
    std::from_chars(key.data() + kind.size() + 1, key.data() + close, place.number);
    if (place.leaf.starts_with('.')) place.leaf.remove_prefix(1);
    return place;
}

class SurfaceReader {
public:
    SurfaceReader(const TomlDocument& toml, AirBearingSurface& surface) : toml_(toml), surface_(surface) {}

    std::vector<InputProblem> read()
    {
        const bool goodRails = readTables("abs.rail", "rail", mostRails, surface_.rails);
        const bool goodWalls = readTables("abs.wall", "wall", mostWalls, surface_.walls);
        railLines_.assign(surface_.rails.size(), {});
        wallLines_.assign(surface_.walls.size(), {});
        for (const TomlEntry& entry : toml_.entries) {
            if (entry.key == interestKey) readInterest(entry);
            if (const auto place = placeOf(entry.key, "abs.rail"); place && goodRails) readRailKey(entry, *place);
            if (const auto place = placeOf(entry.key, "abs.wall"); place && goodWalls) readWallKey(entry, *place);
        }
        if (goodRails) finishRails(goodWalls);
        if (goodWalls) finishWalls();
        return std::move(problems_);
    }

private:
    struct RailLines {
        const TomlEntry* points = nullptr;
        const TomlEntry* walls = nullptr;
    };
    struct WallLines {
        const TomlEntry* distance = nullptr;
        const TomlEntry* recess = nullptr;
    };

    void add(int line, std::string_view key, std::string message)
    {
        problems_.push_back({"", line, std::string(key), std::move(message)});
    }

    /// Makes room for as many as there are tables; false when they are not to be looked at.
    template <typename Item>
    bool readTables(std::string_view kind, std::string_view name, std::size_t most, std::vector<Item>& items)
    {
        std::size_t count = 0;
        bool mentioned = false;
        for (const TomlTable& table : toml_.tables) {
            if (table.key == kind) {
                mentioned = true;
                if (table.kind != TomlTableKind::Array) {
                    add(table.line, kind,
                        "is one table; write [[" + std::string(kind) + "]] for each " + std::string(name));
                    return false;
                }
            } else if (const auto place = placeOf(table.key, kind)) {
                if (place->leaf.empty())
                    count = std::max(count, place->number);
                else if (place->leaf.find('.') == std::string_view::npos)
                    add(table.line, table.key, "unknown table");
            }
        }
        for (const TomlEntry& entry : toml_.entries) {
            if (entry.key != kind) continue;
            const auto* array = std::get_if<TomlArray>(&entry.value);
            if (array == nullptr || !array->elements.empty()) {
                add(entry.line, kind,
                    "is not a table; write [[" + std::string(kind) + "]] for each " + std::string(name));
                return false;
            }
            mentioned = true;
        }
        if (count > most) {
            add(0, kind, counted(count, name) + " are too many; at most " + std::to_string(most) + " are possible");
            return false;
        }
        if (mentioned) items.assign(count, {});
        return true;
    }

    void unknown(const TomlEntry& entry, const Place& place, const std::vector<std::string>& names)
    {
        if (place.leaf.find('.') == std::string_view::npos) // else its table has been named
            add(entry.line, entry.key, "unknown key" + didYouMean(nearestName(place.leaf, names)));
    }

    void readRailKey(const TomlEntry& entry, const Place& place)
    {
        Rail& rail = surface_.rails.at(place.number - 1);
        RailLines& lines = railLines_[place.number - 1];
        if (place.leaf == "recess")
            readRailRecess(entry, rail);
        else if (place.leaf == "points")
            readRailPoints(*(lines.points = &entry), rail);
        else if (place.leaf == "walls")
            lines.walls = &entry;
        else
            unknown(entry, place, {"recess", "points", "walls"});
    }

    void readWallKey(const TomlEntry& entry, const Place& place)
    {
        WallProfile& wall = surface_.walls.at(place.number - 1);
        WallLines& lines = wallLines_[place.number - 1];
        if (place.leaf == "distance")
            readLengths(*(lines.distance = &entry), wall.distance, mostWallPoints);
        else if (place.leaf == "recess")
            readLengths(*(lines.recess = &entry), wall.recess, mostWallPoints);
        else
            unknown(entry, place, {"distance", "recess"});
    }

    std::optional<double> length(const TomlValue& value, int line, const std::string& key, const char* unit)
    {
        const auto number = tomlQuantity(value, "m", unit);
        if (const auto* problem = std::get_if<UnitProblem>(&number)) {
            add(line, key, problem->message);
            return {};
        }
        const double metres = std::get<double>(number) + 0.0;
        if (std::abs(metres) <= farthest) return metres;
        add(line, key,
            formatQuantity(metres, "m") + " is out of range: allowed is at most " + formatQuantity(farthest, "m"));
        return {};
    }

    /// False once a number is wrong: one problem of a list is enough.
    bool readLengths(const TomlEntry& entry, std::vector<double>& values, std::size_t most)
    {
        const auto* array = std::get_if<TomlArray>(&entry.value);
        if (array == nullptr) {
            add(entry.line, entry.key, "has the wrong type; a list such as [\"1 um\", \"2 um\"] is needed");
            return false;
        }
        if (array->elements.size() > most) {
            add(entry.line, entry.key,
                counted(array->elements.size(), "number") + " are too many; at most " + std::to_string(most) +
                    " are possible");
            return false;
        }
        for (const TomlElement& element : array->elements) {
            const auto metres = length(element.value, element.line, entry.key, "um");
            if (!metres) return false;
            values.push_back(*metres);
        }
        return true;
    }

    void readRailRecess(const TomlEntry& entry, Rail& rail)
    {
        if (!std::holds_alternative<TomlArray>(entry.value)) {
            if (const auto recess = length(entry.value, entry.line, entry.key, "um")) rail.recess[0] = *recess;
            return;
        }
        std::vector<double> recess;
        if (!readLengths(entry, recess, mostWallPoints)) return;
        if (recess.size() != rail.recess.size()) {
            add(entry.line, entry.key,
                "has " + counted(recess.size(), "number") +
                    "; a step has one recess, a ramp a list of three, at its first three points");
            return;
        }
        rail.kind = RailKind::Ramp;
        std::ranges::copy(recess, rail.recess.begin());
    }

    std::optional<SurfacePoint> point(const TomlElement& element, const std::string& key)
    {
        const auto* pair = std::get_if<TomlArray>(&element.value);
        if (pair == nullptr || pair->elements.size() != 2) {
            add(element.line, key, "a point is a list of two, such as [\"0.1 mm\", \"0.5 mm\"]");
            return {};
        }
        const auto x = length(pair->elements[0].value, element.line, key, "mm");
        const auto y = x ? length(pair->elements[1].value, element.line, key, "mm") : std::nullopt;
        if (!y) return {};
        return SurfacePoint{*x, *y};
    }

    bool readPoints(const TomlEntry& entry, std::vector<SurfacePoint>& points, std::size_t most)
    {
        const auto* array = std::get_if<TomlArray>(&entry.value);
        if (array == nullptr) {
            add(entry.line, entry.key, "has the wrong type; a list such as [[\"0.1 mm\", \"0.5 mm\"]] is needed");
            return false;
        }
        if (array->elements.size() > most) {
            add(entry.line, entry.key,
                counted(array->elements.size(), "point") + " are too many; at most " + std::to_string(most) +
                    " are possible");
            return false;
        }
        for (const TomlElement& element : array->elements) {
            const auto read = point(element, entry.key);
            if (!read) return false;
            points.push_back(*read);
        }
        return true;
    }

    void readInterest(const TomlEntry& entry)
    {
        surface_.pointsOfInterest.clear();
        readPoints(entry, surface_.pointsOfInterest, mostInterestPoints);
    }

    void readRailPoints(const TomlEntry& entry, Rail& rail)
    {
        std::vector<SurfacePoint> points;
        if (!readPoints(entry, points, mostRailPoints)) return;
        const bool hadRoom = pointCount_ <= mostRailPoints;
        pointCount_ += points.size();
        if (pointCount_ > mostRailPoints) {
            if (hadRoom)
                add(entry.line, entry.key,
                    "makes more than " + std::to_string(mostRailPoints) + " points of all rails");
            return;
        }
        if (points.size() < 3) {
            add(entry.line, entry.key, "has " + counted(points.size(), "point") + "; a rail has three or more");
            return;
        }
        for (const SurfacePoint& p : points) rail.points.push_back({p.x, p.y, 0});
    }

    void readRailWalls(const TomlEntry& entry, Rail& rail)
    {
        const auto wallOf = [&](const TomlValue& value, int line) -> std::optional<int> {
            const auto* number = std::get_if<std::int64_t>(&value);
            if (number == nullptr) {
                add(line, entry.key, "has the wrong type; the number of a wall is needed, 0 for none");
                return {};
            }
            if (*number >= 0 && static_cast<std::uint64_t>(*number) <= surface_.walls.size())
                return static_cast<int>(*number);
            add(line, entry.key,
                "wall " + std::to_string(*number) + " does not exist: there " +
                    (surface_.walls.size() == 1 ? "is " : "are ") + counted(surface_.walls.size(), "wall"));
            return {};
        };
        if (const auto* array = std::get_if<TomlArray>(&entry.value)) {
            if (array->elements.size() != rail.points.size()) {
                add(entry.line, entry.key,
                    "has " + counted(array->elements.size(), "number") + " for " + counted(rail.points.size(), "edge"));
                return;
            }
            for (std::size_t i = 0; i < rail.points.size(); ++i) {
                const auto wall = wallOf(array->elements[i].value, array->elements[i].line);
                if (!wall) return;
                rail.points[i].wall = *wall;
            }
        } else if (const auto wall = wallOf(entry.value, entry.line)) {
            for (RailPoint& point : rail.points) point.wall = *wall;
        }
    }

    /// What concerns several keys of a rail, or a rail and the walls.
    void finishRails(bool withWalls)
    {
        for (std::size_t i = 0; i < surface_.rails.size(); ++i) {
            const RailLines& lines = railLines_[i];
            if (lines.points == nullptr && mentions("abs.rail", i + 1))
                add(lineOf("abs.rail", i + 1), numbered("abs.rail", i + 1), "needs points");
            if (withWalls && lines.walls != nullptr && !surface_.rails[i].points.empty())
                readRailWalls(*lines.walls, surface_.rails[i]);
        }
    }

    void finishWalls()
    {
        for (std::size_t i = 0; i < surface_.walls.size(); ++i) {
            const WallProfile& wall = surface_.walls[i];
            const WallLines& lines = wallLines_[i];
            if (lines.distance == nullptr || lines.recess == nullptr) {
                if (mentions("abs.wall", i + 1))
                    add(lineOf("abs.wall", i + 1), numbered("abs.wall", i + 1), "needs a distance and a recess");
                continue;
            }
            if (wrong(lines.distance->key) || wrong(lines.recess->key)) continue;
            if (wall.distance.size() != wall.recess.size() || wall.distance.empty())
                add(lines.recess->line, lines.recess->key,
                    "has " + counted(wall.recess.size(), "number") + " for " +
                        counted(wall.distance.size(), "distance"));
        }
    }

    static std::string numbered(std::string_view kind, std::size_t number)
    {
        return std::string(kind) + '[' + std::to_string(number) + ']';
    }
    const TomlTable* tableOf(std::string_view kind, std::size_t number) const
    {
        const auto found = std::ranges::find(toml_.tables, numbered(kind, number), &TomlTable::key);
        return found == toml_.tables.end() ? nullptr : &*found;
    }
    /// False for items that came from elsewhere.
    bool mentions(std::string_view kind, std::size_t number) const { return tableOf(kind, number) != nullptr; }
    int lineOf(std::string_view kind, std::size_t number) const { return tableOf(kind, number)->line; }
    bool wrong(std::string_view key) const
    {
        return std::ranges::find(problems_, key, &InputProblem::key) != problems_.end();
    }

    const TomlDocument& toml_;
    AirBearingSurface& surface_;
    std::vector<RailLines> railLines_;
    std::vector<WallLines> wallLines_;
    std::vector<InputProblem> problems_;
    std::size_t pointCount_ = 0; // of all rails
};

} // namespace

bool isSurfaceKey(std::string_view key)
{
    return key == interestKey || key == "abs.rail" || key == "abs.wall" || key.starts_with("abs.rail.") ||
           key.starts_with("abs.wall.") || placeOf(key, "abs.rail") || placeOf(key, "abs.wall");
}

std::vector<InputProblem> readSurface(const TomlDocument& toml, AirBearingSurface& surface)
{
    return SurfaceReader(toml, surface).read();
}

std::string_view surfaceHelp()
{
    return "The rails of the air bearing surface are tables [[abs.rail]], each with recess = \"0.2 um\" (a step; its "
           "depth below the zero plane) or a list of three (a ramp; at its first three points), points = [[\"0.1 mm\", "
           "\"0.2 mm\"], ...] (three or more corners; x from the leading edge, y from the inner edge) and walls = [1, "
           "0, ...] (the wall on the edge from each point to the next, 0 for none; one number for all). Where rails "
           "overlap, the last one counts. A wall is a table [[abs.wall]] with distance = [...] (normal to the edge, "
           "ascending, negative inside) and recess = [...] (below the zero plane, one for each distance); the first "
           "table is wall 1. abs.points_of_interest = [[x, y], ...] lists points where the spacing is reported. "
           "abs.rails = \"rail.dat\" reads [abs] and the size of the slider from a CML file beside the case instead; "
           "values in the case override it.";
}

} // namespace touchdown
