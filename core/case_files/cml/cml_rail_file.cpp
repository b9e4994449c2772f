// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_rail_file.h"

#include <algorithm>
#include <cmath>

#include "core/case/parameters.h"
#include "core/formats/cml_text.h"
#include "core/formats/decimal.h"

namespace touchdown {

namespace {

constexpr int mostRails = 1000;
constexpr int mostRailPoints = 10000;
constexpr int mostPointsInAll = 100000; // of all rails
constexpr int mostWalls = 1000;
constexpr int mostWallPoints = 1000;
constexpr std::size_t mostPointsOfInterest = 250; // those of the established program
constexpr double largest = 1.0;                   // of a coordinate [m]; beyond it a count or a unit is wrong

class RailReader {
public:
    RailReader(std::string_view text, const std::string& file, CmlRails& rails)
        : text_(text), file_(file), rails_(rails)
    {}

    void read()
    {
        readHeader();
        readSlider();
        const int railCount = text_.whole("the number of rails", 0, mostRails);
        wallCount_ = text_.whole("the number of wall profiles", 0, mostWalls);
        endList();
        for (int i = 1; i <= railCount; ++i) within("rail " + std::to_string(i), [&] { readRail(); });
        if (wallCount_ > 0) readWalls();
        setParameter("abs.taper_length", "the taper length");
        setParameter("abs.taper_angle", "the taper angle");
        setParameter("abs.base_recess", "the base recess");
        endList();
        setParameter("abs.crown", "the crown");
        setParameter("abs.camber", "the camber");
        setParameter("abs.twist", "the twist");
        endList();
        readPointsOfInterest();
        takeParameters();
    }

private:
    void readHeader()
    {
        if (text_.peekWord().empty()) throw CmlError(0, "is empty");
        for (int i = 0; i < 2; ++i) {
            if (text_.onThisLine() && text_.nextIsNumber())
                throw CmlError(text_.line(), "two lines of text are needed before the first number");
            text_.takeLine();
        }
    }

    void readSlider()
    {
        setParameter("slider.length", "the slider's length");
        setParameter("slider.width", "the slider's width");
        setParameter("slider.thickness", "the slider's thickness");
        endList();
    }

    /// A number that is a parameter of a case, checked as such.
    void setParameter(std::string_view key, std::string_view what)
    {
        const CmlNumber n = text_.number(what);
        lastLine_ = n.line;
        rails_.lines[std::string(key)] = n.line;
        if (const auto problem = setFromNumber(parameters_, *findParameter(key), n.value))
            throw CmlError(n.line, std::string(what) + ": " + *problem);
    }
    void takeParameters()
    {
        rails_.length = parameters_.slider.length;
        rails_.width = parameters_.slider.width;
        rails_.thickness = parameters_.slider.thickness;
        parameters_.surface.rails = std::move(rails_.surface.rails);
        parameters_.surface.walls = std::move(rails_.surface.walls);
        parameters_.surface.pointsOfInterest = std::move(rails_.surface.pointsOfInterest);
        rails_.surface = std::move(parameters_.surface);
    }

    void readRail()
    {
        const int pointCount = text_.whole("the number of points", 3, mostRailPoints);
        rails_.railLines.push_back(text_.line());
        pointCount_ += pointCount;
        if (pointCount_ > mostPointsInAll)
            throw CmlError(text_.line(), "more than " + std::to_string(mostPointsInAll) + " points in all");
        Rail rail;
        rail.kind = text_.whole("the type (1 step, 0 ramp)", 0, 1) == 1 ? RailKind::Step : RailKind::Ramp;
        endList();
        for (int i = 0; i < pointCount; ++i) {
            RailPoint point;
            point.x = length("x of a point");
            point.y = length("y of a point");
            point.wall = wallOf();
            rail.points.push_back(point);
            if (i + 1 < pointCount) text_.skipRemark();
        }
        endList();
        rail.recess[0] = length("the recess");
        if (rail.kind == RailKind::Ramp) {
            rail.recess[1] = length("the recess at the second point");
            rail.recess[2] = length("the recess at the third point");
        }
        endList();
        rails_.surface.rails.push_back(std::move(rail));
    }

    /// A profile that does not exist is none, as for the established program.
    int wallOf()
    {
        const int wall = text_.whole("the wall profile of a point", 0, mostWalls);
        if (wall <= wallCount_) return wall;
        warn(text_.line(), "wall profile " + std::to_string(wall) + " does not exist; the edge is taken as vertical");
        return 0;
    }

    void readWalls()
    {
        std::vector<int> pointCounts;
        pointCounts.reserve(static_cast<std::size_t>(wallCount_));
        for (int i = 0; i < wallCount_; ++i)
            pointCounts.push_back(text_.whole("the number of points of a wall profile", 2, mostWallPoints));
        endList();
        for (int i = 1; i <= wallCount_; ++i)
            within("wall profile " + std::to_string(i), [&] {
                const int pointCount = pointCounts[static_cast<std::size_t>(i - 1)];
                WallProfile wall;
                for (int k = 0; k < pointCount; ++k) {
                    wall.distance.push_back(length("a distance"));
                    if (k == 0) rails_.wallLines.push_back(lastLine_);
                }
                endList();
                for (int k = 0; k < pointCount; ++k) wall.recess.push_back(length("a recess"));
                endList();
                rails_.surface.walls.push_back(std::move(wall));
            });
    }

    /// All numbers that are left: x first, then y, as many. Long lists may be broken over lines.
    void readPointsOfInterest()
    {
        std::vector<double> values;
        std::size_t onFirstLine = 0;
        int lines = 0;
        while (text_.nextIsNumber() && values.size() <= 2 * mostPointsOfInterest) {
            if (!text_.onThisLine() || values.empty()) ++lines;
            values.push_back(length("a coordinate of the points of interest"));
            if (lines == 1) ++onFirstLine;
        }
        const std::size_t count = values.size() / 2;
        if (values.size() > 2 * mostPointsOfInterest)
            throw CmlError(lastLine_, "more than " + std::to_string(mostPointsOfInterest) + " points of interest");
        if (values.size() % 2 != 0 || (lines == 2 && onFirstLine != count))
            throw CmlError(lastLine_, "the points of interest need as many y as x");
        for (std::size_t i = 0; i < count; ++i)
            rails_.surface.pointsOfInterest.push_back({values[i], values[count + i]});
        if (!text_.peekWord().empty()) warn(lastLine_, "text after the last number is not used");
    }

    template <typename Read>
    void within(const std::string& part, Read read)
    {
        try {
            read();
        } catch (const CmlError& error) {
            throw CmlError(error.line(), part + ": " + error.what());
        }
    }

    double length(std::string_view what)
    {
        const CmlNumber n = text_.number(what);
        lastLine_ = n.line;
        if (std::abs(n.value) > largest)
            throw CmlError(n.line, std::string(what) + " is " + std::string(n.text) +
                                       ", which is too large; a count above it may be wrong");
        return n.value + 0.0; // -0 has one spelling
    }
    void endList()
    {
        const int line = text_.line();
        if (text_.endList()) warn(line, "more numbers than are needed; the last ones are not used");
    }
    void warn(int line, std::string message) { rails_.warnings.push_back({file_, line, "", std::move(message)}); }

    CmlText text_;
    const std::string& file_;
    CmlRails& rails_;
    Case parameters_; // takes the numbers that are parameters
    int wallCount_ = 0;
    int pointCount_ = 0; // of all rails so far
    int lastLine_ = 0;   // of the last length
};

class RailWriter {
public:
    std::string text;

    void line(std::string_view words) { text.append(words).append("\r\n"); }
    /// A list of numbers, in columns.
    template <typename... Value>
    void list(Value... value)
    {
        (add(value), ...);
        end();
    }
    void add(double value)
    {
        constexpr std::size_t column = 16;
        std::string number = decimalText(value);
        number.resize(std::max(column, number.size() + 1), ' ');
        text += number;
    }
    void add(int value) { add(static_cast<double>(value)); }
    void add(std::size_t value) { add(static_cast<double>(value)); }
    void end()
    {
        while (text.ends_with(' ')) text.pop_back();
        text += "\r\n";
    }
};

void writeRail(RailWriter& out, const Rail& rail)
{
    out.list(rail.points.size(), rail.kind == RailKind::Step ? 1 : 0);
    for (const RailPoint& point : rail.points) out.list(point.x, point.y, point.wall);
    if (rail.kind == RailKind::Step)
        out.list(rail.recess[0]);
    else
        out.list(rail.recess[0], rail.recess[1], rail.recess[2]);
}

} // namespace

CmlRails readCmlRails(std::string_view text, const std::string& file)
{
    CmlRails rails;
    try {
        RailReader(text, file, rails).read();
    } catch (const CmlError& error) {
        rails.problems.push_back({file, error.line(), "", error.what()});
    }
    return rails;
}

std::string formatCmlRails(double length, double width, double thickness, const AirBearingSurface& surface)
{
    RailWriter out;
    out.line("CML Version 7.0  RAIL.DAT");
    out.line("written by touchdown " TOUCHDOWN_VERSION);
    out.list(length, width, thickness);
    out.list(surface.rails.size(), surface.walls.size());
    for (const Rail& rail : surface.rails) writeRail(out, rail);
    if (!surface.walls.empty()) {
        for (const WallProfile& wall : surface.walls) out.add(wall.distance.size());
        out.end();
    }
    for (const WallProfile& wall : surface.walls) {
        for (const double distance : wall.distance) out.add(distance);
        out.end();
        for (const double recess : wall.recess) out.add(recess);
        out.end();
    }
    out.list(surface.taperLength, surface.taperAngle, surface.baseRecess);
    out.list(surface.crown, surface.camber, surface.twist);
    if (!surface.pointsOfInterest.empty()) {
        for (const SurfacePoint& point : surface.pointsOfInterest) out.add(point.x);
        out.end();
        for (const SurfacePoint& point : surface.pointsOfInterest) out.add(point.y);
        out.end();
    }
    return out.text;
}

} // namespace touchdown
