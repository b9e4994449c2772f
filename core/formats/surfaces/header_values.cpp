// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/header_values.h"

#include <algorithm>
#include <cmath>

#include "core/formats/cml_text.h"
#include "core/formats/decimal.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/column_name.h"
#include "core/formats/surfaces/heading_cells.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::string_view numberBegins = "0123456789+-.";
constexpr double nanometre = 1e-9; // [m]

/// Names in lower case, with a blank for each of "-_.".
struct FieldNames {
    HeaderField field;
    std::string_view names; // each between commas
};
constexpr FieldNames fieldNames[] = {
    {HeaderField::SizeX, "width,image width,scan width,x size,xsize,size x,x range,x length,xlength,length x,x scan "
                         "size,x amplitude,xreal,x real,scan size x,scan range x,x scan range"},
    {HeaderField::SizeY, "height,image height,scan height,y size,ysize,size y,y range,y length,ylength,length y,y scan "
                         "size,y amplitude,yreal,y real,scan size y,scan range y,y scan range"},
    {HeaderField::StepX, "dx,x step,step x,x spacing,spacing x,x pixel size,pixel width,x increment,xinc,delta x,x "
                         "pitch,pixel size x,xscale,scale x,x resolution,x sampling"},
    {HeaderField::StepY, "dy,y step,step y,y spacing,spacing y,y pixel size,pixel height,y increment,yinc,delta y,y "
                         "pitch,pixel size y,yscale,scale y,y resolution,y sampling"},
    {HeaderField::Step, "spacing,step,step size,point spacing,sample spacing,data spacing,sampling interval,sampling "
                        "step,sampling distance,sample interval,sample distance,sampling,increment,interval,pitch,"
                        "point distance,cellsize,cell size,pixel size,pixelsize,pixel spacing,lateral resolution,"
                        "lateral step,lateral spacing,xy calibration,grid spacing,distance between points"},
    {HeaderField::PointsX, "x pixels,xpixels,pixels x,xres,columns,number of columns,ncols,cols,nx,numpoints,x points,"
                           "points per line,points per profile,horizontal"},
    {HeaderField::PointsY, "y pixels,ypixels,pixels y,yres,rows,number of rows,nrows,ny,numprofiles,y points,vertical"},
    {HeaderField::LateralUnit, "lateral unit,lateral units,x unit,x units,xunit,xunits,unit x,units x,xy unit,xy units,"
                               "xyunit,xyunits,unit xy,horizontal unit,horizontal units,position unit,distance unit,"
                               "unit of x,units of x,lateral,x,x axis,horizontal,distance,position"},
    {HeaderField::UnitY, "y unit,y units,yunit,yunits,unit y,units y,unit of y,units of y,y,y axis"},
    {HeaderField::HeightUnit, "value units,value unit,values unit,z units,z unit,zunit,zunits,unit z,units z,height "
                              "unit,height units,data units,data unit,unit data,units,unit,vertical unit,vertical "
                              "units,unit of z,units of z,unit of heights,unit of height,units of height,h unit,h "
                              "units,z,height,heights,z axis,h,vertical,einheit,"
                              "werteinheit,z einheit"},
    {HeaderField::HeightRange, "z amplitude"},
    {HeaderField::Bit2nm, "bit2nm"},
    {HeaderField::Scale, "scale factor,z scale,zscale,scale z,z factor,height scale,height factor,height scale factor,"
                         "multiplier,z multiplier,height multiplier,factor,z scale factor,scaling factor,z calibration,"
                         "height conversion factor,z scaling,data scale,scale data,value scale"},
    {HeaderField::Missing, "nodata value,nodata,no data,no data value,missing value,missing,fill value,void value,bad "
                           "value,invalid value"},
    {HeaderField::Channel,
     "channel,channel name,data channel,profile,quantity,signal,image type,output image data,image "
     "data,measured quantity"},
};

bool isNamed(std::string_view names, std::string_view name)
{
    for (std::size_t at = names.find(name); at != std::string_view::npos; at = names.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || names[at - 1] == ',') && (end == names.size() || names[end] == ',')) return true;
    }
    return false;
}

bool isUnit(HeaderField field)
{
    return field == HeaderField::LateralUnit || field == HeaderField::UnitY || field == HeaderField::HeightUnit;
}

/// A number, a unit or a text. A unit stands beside "unit", or is plain: "x: um".
bool takes(HeaderField field, const std::string& name, const std::string& value)
{
    if (value.empty()) return false;
    const bool number = numberBegins.find(value.front()) != std::string_view::npos;
    if (field == HeaderField::Channel) return true;
    if (!isUnit(field)) return number;
    const bool plain = spelledLength(value) || spellsOtherUnit(value);
    return !number &&
           (plain || (name.find("unit") != std::string::npos && value.find_first_of(" ,;") == std::string::npos));
}

struct NamedValue {
    HeaderField field;
    HeaderValue value;
};

/// The field with a name, perhaps with a unit in brackets.
std::optional<NamedValue> fieldOf(std::string_view name, std::string_view value, int line)
{
    NamedValue found{HeaderField::Count, {std::string(trimmed(value, " \t\"'=:")), {}, line}};
    name = trimmed(name, " \t\"':=");
    if (const auto open = name.find_first_of("[("); open != std::string_view::npos && open > 0) {
        found.value.unit = trimmed(name.substr(open), " \t[]()");
        name = trimmed(name.substr(0, open));
    }
    std::string plain = lowerCase(name);
    std::ranges::replace_if(
        plain, [](char c) { return c == '-' || c == '_' || c == '.'; }, ' ');
    if (plain.empty() || plain.find(',') != std::string::npos) return std::nullopt;
    for (const FieldNames& each : fieldNames)
        if (isNamed(each.names, plain) && takes(each.field, plain, found.value.value)) {
            if (isUnit(each.field) && !found.value.unit.empty()) return std::nullopt; // "height (downwards): um"
            found.field = each.field;
            return found;
        }
    return std::nullopt;
}

std::optional<NamedValue> valueIn(std::string_view piece, int line)
{
    const std::string_view text = withoutMark(piece);
    if (const auto sign = text.find_first_of(":="); sign != std::string_view::npos)
        return fieldOf(text.substr(0, sign), text.substr(sign + 1), line);
    if (const auto comma = text.find_first_of(",;\t"); comma != std::string_view::npos) { // "Horizontal","64"
        const std::string_view rest = text.substr(comma + 1);
        const std::size_t next = std::min(rest.find(text[comma]), rest.size()); // "500","nm/pixel"
        auto found = fieldOf(text.substr(0, comma), rest.substr(0, next), line);
        if (found && found->field == HeaderField::Channel && text != piece) return std::nullopt; // "# profile, here"
        if (!found || found->field == HeaderField::Channel) return found;
        const std::string_view unit = trimmed(rest.substr(std::min(next + 1, rest.size())), " \t\",;");
        if (found->value.unit.empty()) found->value.unit = unit;
        const std::string& value = found->value.value; // not "x,A" and "Units,um,nm"
        const bool clear = unit.empty() && value.size() > 1 && spelledLength(value);
        return isUnit(found->field) && !clear ? std::nullopt : found;
    }
    for (std::size_t at = text.find(' '); at != std::string_view::npos; at = text.find(' ', at + 1)) // "ncols 64"
        if (at + 1 < text.size() && numberBegins.find(text[at + 1]) != std::string_view::npos)
            return fieldOf(text.substr(0, at), text.substr(at + 1), line);
    return std::nullopt;
}

/// "Width: 16 um, Height: 8 um" to its two parts.
std::vector<std::string_view> pieces(std::string_view text)
{
    std::vector<std::string_view> parts;
    if (text.size() > longestHeading) return parts;
    std::size_t begin = 0;
    for (std::size_t at = text.find_first_of(",;"); at != std::string_view::npos;
         at = text.find_first_of(",;", at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t", at + 1);
        const std::size_t colon = text.find_first_of(":=", at);
        const bool name = next != std::string_view::npos && colon != std::string_view::npos && next < colon &&
                          !(text[next] >= '0' && text[next] <= '9');
        if (!name) continue;
        parts.push_back(text.substr(begin, at - begin));
        begin = at + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

std::optional<double> unitIn(const std::optional<HeaderValue>& value)
{
    if (!value) return std::nullopt;
    const std::string unit(trimmed(value->value, " \t[](){}\"'"));
    if (const auto metres = spelledLength(unit)) return metres;
    throw CmlError(value->line, "names the unit " + inQuotes(unit) + ", which is not clearly one of length, as \"nm\"");
}

/// "nm/pixel" to "nm".
std::string perPoint(const std::string& unit)
{
    const auto slash = unit.find('/');
    if (slash == std::string::npos) return unit;
    const std::string point(trimmed(std::string_view(unit).substr(slash + 1)));
    for (const char* each : {"pixel", "pixels", "px", "pix", "point", "points", "pt", "sample"})
        if (point == each) return std::string(trimmed(std::string_view(unit).substr(0, slash)));
    return unit;
}

/// A length along x (axis 0) or y, whose unit may stand beside it, in another line or in the case [m].
double lengthOf(const HeaderValues& values, const HeaderValue& given, const std::string& name, std::size_t axis,
                const ColumnUnits& key)
{
    const auto parts = numberAndUnit(given.value);
    const std::string unit = perPoint(parts && !parts->unit.empty() ? parts->unit : given.unit);
    if (!parts || !(parts->number > 0.0) || (!parts->unit.empty() && !spelledLength(unit)))
        throw CmlError(given.line,
                       name + " must be a length above 0 with its unit, as \"10 um\", not " + inQuotes(given.value));
    if (!unit.empty() && !spelledLength(unit))
        throw CmlError(given.line, name + " must have a unit of length, as \"nm\", not " + inQuotes(unit));
    auto metres = !unit.empty() ? spelledLength(unit) : axis == 1 ? unitOfY(values) : std::nullopt;
    if (!metres) metres = lateralUnit(values);
    if (!metres && values.has(HeaderField::Bit2nm)) metres = nanometre;
    const double byKey = key.empty() ? 0.0 : key[axis];
    if (!metres && byKey <= 0.0)
        throw CmlError(given.line, name + " has no unit of length, as \"um\"; it needs one here, or the case gives "
                                          "all, as disk.surface.unit = \"um, nm\" for x, y and the heights");
    if (metres && byKey > 0.0 && std::abs(*metres - byKey) > 1e-9 * byKey) refuseOtherThanKey(given.line);
    return parts->number * metres.value_or(byKey);
}

/// The distance of the points, given or by the size of the map. Where both are given they must agree; the size may be
/// that from the first point to the last.
double stepOf(const HeaderValues& values, HeaderField step, HeaderField size, std::size_t points, std::size_t axis,
              const ColumnUnits& key)
{
    const auto& own = values.of(step);
    const auto& given = own ? own : values.of(HeaderField::Step);
    const auto& whole = values.of(size);
    const double count = static_cast<double>(points);
    const double length = whole ? lengthOf(values, *whole, axis == 0 ? "Width" : "Height", axis, key) : 0.0;
    if (!given) return length / count;
    const double distance = lengthOf(values, *given, "the distance of the points", axis, key);
    const bool differ = std::abs(length - (count - 0.5) * distance) > 0.6 * distance;
    if (whole && differ)
        throw CmlError(given->line,
                       "gives another distance of the points than the size in line " + std::to_string(whole->line));
    return distance;
}

} // namespace

HeaderValues::HeaderValues(const std::vector<HeadingLine>& lines)
{
    for (const HeadingLine& heading : lines)
        for (const std::string_view piece : pieces(heading.text)) {
            auto found = valueIn(piece, heading.line);
            if (!found) continue;
            std::optional<HeaderValue>& known = values_[static_cast<std::size_t>(found->field)];
            if (known && (known->value != found->value.value || known->unit != found->value.unit)) {
                known->other = found->value.value;
                known->otherLine = heading.line;
            }
            if (!known) known = std::move(found->value);
        }
}

const std::optional<HeaderValue>& HeaderValues::of(HeaderField field) const
{
    const std::optional<HeaderValue>& value = values_[static_cast<std::size_t>(field)];
    if (value && value->otherLine > 0 && field != HeaderField::Channel)
        throw CmlError(value->otherLine, "gives " + inQuotes(value->other) + " after " + inQuotes(value->value) +
                                             " in line " + std::to_string(value->line) +
                                             "; one profile or one channel is read from a file");
    return value;
}

std::vector<std::pair<HeaderField, HeaderValue>> HeaderValues::given() const
{
    std::vector<std::pair<HeaderField, HeaderValue>> all;
    for (std::size_t field = 0; field < values_.size(); ++field)
        if (values_[field]) all.emplace_back(static_cast<HeaderField>(field), *values_[field]);
    return all;
}

bool HeaderValues::sizesMatrix() const
{
    const bool x = has(HeaderField::SizeX) || has(HeaderField::StepX) || has(HeaderField::Step);
    const bool y = has(HeaderField::SizeY) || has(HeaderField::StepY) || has(HeaderField::Step);
    return x && y;
}

std::optional<double> lateralUnit(const HeaderValues& values) { return unitIn(values.of(HeaderField::LateralUnit)); }
std::optional<double> unitOfY(const HeaderValues& values) { return unitIn(values.of(HeaderField::UnitY)); }

std::optional<double> heightUnit(const HeaderValues& values)
{
    const auto& range = values.of(HeaderField::HeightRange);
    const auto& step = values.of(HeaderField::Bit2nm);
    auto unit = unitIn(values.of(HeaderField::HeightUnit));
    if (range && !unit) {
        const auto parts = numberAndUnit(range->value);
        unit = unitIn(HeaderValue{parts ? parts->unit : range->value, {}, range->line});
    }
    if (!step) return unit;
    const auto parts = numberAndUnit(step->value);
    if (!parts || !(parts->number > 0.0) || !parts->unit.empty() || (unit && parts->number != 1.0))
        throw CmlError(step->line, "Bit2nm must be a number above 0, the step of the heights in nm, without another "
                                   "unit of heights beside it");
    return parts->number * unit.value_or(nanometre);
}

PointSteps pointSteps(const MapTable& table, const HeaderValues& values, const ColumnUnits& key)
{
    const auto count = [&](HeaderField field, std::size_t points, const char* what) {
        const auto& given = values.of(field);
        const auto parts = given ? numberAndUnit(given->value) : std::nullopt;
        if (given && (!parts || parts->number != static_cast<double>(points)))
            throw CmlError(given->line,
                           "gives " + inQuotes(given->value) + what + ", but the file has " + std::to_string(points));
    };
    const bool alone = table.columns == 1;
    const bool one = alone || table.rows() == 1; // line
    count(HeaderField::PointsX, alone ? table.rows() : table.columns, " points in a line");
    if (!alone) count(HeaderField::PointsY, table.rows(), " lines");

    PointSteps steps;
    steps.x = stepOf(values, HeaderField::StepX, HeaderField::SizeX, alone ? table.rows() : table.columns, 0, key);
    if (!one) steps.y = stepOf(values, HeaderField::StepY, HeaderField::SizeY, table.rows(), 1, key);
    return steps;
}

bool channelIsTurned(const MapTable& table, const HeaderValues& values, std::size_t first)
{
    if (const auto& scale = values.of(HeaderField::Scale)) {
        const auto parts = numberAndUnit(scale->value);
        if (!parts || parts->number != 1.0 || !parts->unit.empty())
            throw CmlError(scale->line, "gives a factor of the heights, " + inQuotes(scale->value) +
                                            "; the heights must be multiplied by it in the file");
    }
    if (const auto& missing = values.of(HeaderField::Missing))
        if (const auto parts = numberAndUnit(missing->value))
            for (std::size_t row = 0; row < table.rows(); ++row)
                for (std::size_t column = first; column < table.columns; ++column)
                    if (table.at(row, column) == parts->number)
                        throw CmlError(table.lines[row], "a surface has no holes: " + decimalText(parts->number) +
                                                             " marks a missing point by line " +
                                                             std::to_string(missing->line));
    const auto& channel = values.of(HeaderField::Channel);
    if (!channel) return false;
    std::string words = withPlainLetters(channel->value);
    std::ranges::replace_if(
        words, [](char c) { return std::string_view("/|%=+<>~*").find(c) < 9; }, ' ');
    const ColumnName name = columnName(words);
    if (name.role == ColumnRole::None)
        throw CmlError(channel->line, "names the channel " + inQuotes(channel->value) +
                                          ", which is no height: " + inQuotes(name.word));
    return name.turned;
}

bool beginsChannel(std::string_view line)
{
    const auto pieced = pieces(line);
    return std::ranges::any_of(pieced, [](std::string_view each) {
        const auto found = valueIn(each, 0);
        return found && (found->field <= HeaderField::SizeY || found->field == HeaderField::HeightUnit ||
                         found->field == HeaderField::Channel);
    });
}

std::vector<std::string_view> remarksIn(std::string_view line)
{
    auto parts = pieces(line);
    std::erase_if(parts, [](std::string_view each) { return valueIn(each, 0).has_value(); });
    return parts;
}

void refuseOtherThanKey(int line)
{
    throw CmlError(line, "names other units than disk.surface.unit; they must be the same, or one of them left out");
}

bool isValue(std::string_view line)
{
    std::string_view text = line;
    constexpr std::string_view index = "Unnamed: 0"; // as pandas writes it
    if (text.starts_with(index)) text.remove_prefix(index.size());
    for (std::size_t at = text.find_first_of(":="); at != std::string_view::npos;
         at = text.find_first_of(":=", at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t+-.", at + 1);
        if (next != std::string_view::npos && text[next] >= '0' && text[next] <= '9') return true;
    }
    const auto pieced = pieces(line);
    return !pieced.empty() && std::ranges::all_of(pieced, [](std::string_view each) { // "x unit: um"
        const auto found = valueIn(each, 0);
        return found && found->field != HeaderField::Channel;
    });
}

} // namespace touchdown
