// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/surface_text.h"

#include "core/case_files/relation_text.h"
#include "core/case_files/surface_tables.h"
#include "core/formats/words.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace touchdown {

namespace {

constexpr std::string_view interestKey = "abs.points_of_interest";

class SurfaceReader : private SurfaceTables {
public:
    SurfaceReader(const TomlDocument& toml, AirBearingSurface& surface) : SurfaceTables(toml), surface_(surface) {}

    std::vector<InputProblem> read()
    {
        const bool goodRails = readTables("abs.rail", "rail", mostRails, surface_.rails);
        const bool goodWalls = readTables("abs.wall", "wall", mostWalls, surface_.walls);
        railLines_.assign(surface_.rails.size(), {});
        wallLines_.assign(surface_.walls.size(), {});
        for (const TomlEntry& entry : toml_.entries) {
            if (entry.key == interestKey) readInterest(entry);
            if (const auto place = tablePlace(entry.key, "abs.rail"); place && goodRails) readRailKey(entry, *place);
            if (const auto place = tablePlace(entry.key, "abs.wall"); place && goodWalls) readWallKey(entry, *place);
        }
        if (goodRails) finishRails(goodWalls);
        if (goodWalls) finishWalls();
        return takeProblems();
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

    void readRailKey(const TomlEntry& entry, const TablePlace& place)
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

    void readWallKey(const TomlEntry& entry, const TablePlace& place)
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

    AirBearingSurface& surface_;
    std::vector<RailLines> railLines_;
    std::vector<WallLines> wallLines_;
    std::size_t pointCount_ = 0; // of all rails
};

} // namespace

bool isSurfaceKey(std::string_view key)
{
    const auto isOf = [key](const std::string& kind) {
        return key == kind || key.starts_with(kind + '.') || tablePlace(key, kind);
    };
    return key == interestKey || isOf("abs.rail") || isOf("abs.wall") || isOf("abs.distance") || isOf("abs.symmetric");
}

std::vector<InputProblem> readSurface(const TomlDocument& toml, AirBearingSurface& surface)
{
    std::vector<InputProblem> problems = SurfaceReader(toml, surface).read();
    std::ranges::move(readRelations(toml, surface), std::back_inserter(problems));
    return problems;
}

std::string_view surfaceHelp()
{
    return "The rails of the air bearing surface are tables [[abs.rail]], each with recess = \"0.2 um\" (a step; its "
           "depth below the zero plane) or a list of three (a ramp; at its first three points), points = [[\"0.1 mm\", "
           "\"0.2 mm\"], ...] (three or more corners; x from the leading edge, y from the inner edge) and walls = [1, "
           "0, ...] (the wall on the edge from each point to the next, 0 for none; one number for all). Where rails "
           "overlap, the last one counts. A wall is a table [[abs.wall]] with distance = [...] (normal to the edge, "
           "ascending, negative inside) and recess = [...] (below the zero plane, one for each distance); the first "
           "table is wall 1. The editor keeps two kinds of relations: a table [[abs.distance]] with from and to "
           "(\"corner "
           "3 of rail 1\" or \"edge 2 of rail 1\"), along = \"x\" or \"y\" and value = \"80 um\" (to minus from), and "
           "a table [[abs.symmetric]] with rails = [1, 2] (mirror images about the centre line; one rail alone is its "
           "own image); results do not depend on them. abs.points_of_interest = [[x, y], ...] lists points where the "
           "spacing is reported. "
           "abs.rails = \"rail.dat\" reads [abs] and the size of the slider from a CML file beside the case instead; "
           "values in the case override it.";
}

} // namespace touchdown
