// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_hdf5.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/formats/cml_text.h"
#include "core/formats/decimal.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/hdf5_inspection.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/column_name.h"
#include "core/formats/surfaces/height_map_builder.h"
#include "core/formats/surfaces/map_holes.h"
#include "core/formats/surfaces/surface_units.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

struct Dataset {
    std::vector<hsize_t> shape;
    std::vector<double> values; // [m]
    double unit = 1.0;          // [m]
};

std::string shapeText(const std::vector<hsize_t>& shape)
{
    std::string text;
    for (const hsize_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
    return text.empty() ? "a single number" : text;
}

/// The unit of the file, which must be that of the case where both give one; `byKey` 0: the case gives none.
double unitOf(const Hdf5Dataset& dataset, const std::string& name, double byKey)
{
    const auto named = [&](const char* attribute) -> std::optional<double> {
        const std::string unit = dataset.attribute(attribute);
        if (unit.empty()) return std::nullopt;
        if (const auto metres = spelledLength(unit)) return metres;
        throw CmlError(0, "the unit of dataset \"" + name + "\" must be a length, as \"nm\", not " + inQuotes(unit));
    };
    const auto one = named("unit"), two = named("units");
    const auto differ = [](double a, double b) { return std::abs(a - b) > 1e-9 * b; };
    if (one && two && differ(*one, *two))
        throw CmlError(0, "dataset \"" + name + "\" has different units in its attributes \"unit\" and \"units\"");
    const auto unit = one ? one : two;
    if (unit && byKey > 0.0 && differ(*unit, byKey))
        throw CmlError(
            0, "dataset \"" + name +
                   "\" has another unit than disk.surface.unit; they must be the same, or one of them left out");
    if (unit) return *unit;
    if (byKey > 0.0) return byKey;
    throw CmlError(0,
                   "dataset \"" + name +
                       "\" has no unit; it needs an attribute \"unit\" or \"units\", as \"um\", or the case gives the "
                       "units of x and height as disk.surface.unit = \"um, nm\"");
}

/// netCDF: marks of holes are compared before, a scale and an offset are applied after.
void refuseMarks(const Hdf5Dataset& dataset, const std::string& name, const std::vector<double>& values)
{
    const auto refuse = [&](std::size_t at, const std::string& why) {
        throw CmlError(0, "dataset \"" + name + "\", entry " + std::to_string(at + 1) + ": " + why);
    };
    for (const char* attribute : {"_FillValue", "missing_value"})
        for (const double mark : dataset.numberAttributes(attribute)) {
            const auto same = [&](double v) { return v == mark || static_cast<float>(v) == static_cast<float>(mark); };
            if (const auto hole = std::ranges::find_if(values, same); hole != values.end())
                refuse(static_cast<std::size_t>(hole - values.begin()),
                       "a surface has no holes: " + decimalText(*hole) + " is its " + attribute);
        }
    if (name == "height")
        if (const auto hole = findHole(values)) refuse(*hole, holeText(values[*hole]));
}

/// Attributes of netCDF that say that heights count downwards or are no heights.
void refuseQuantity(const Hdf5Dataset& dataset, const std::string& name)
{
    if (name != "height") return;
    for (const char* attribute : {"long_name", "standard_name", "positive"}) {
        const std::string text = dataset.attribute(attribute);
        const ColumnName quantity = columnName(text);
        if (quantity.turned)
            throw CmlError(0, "dataset \"height\" counts downwards: its " + std::string(attribute) + " is " +
                                  inQuotes(text) + "; heights count away from the disk");
        if (quantity.role == ColumnRole::None)
            throw CmlError(0,
                           "dataset \"height\" is no height: its " + std::string(attribute) + " is " + inQuotes(text));
    }
}

double numberOr(const Hdf5Dataset& dataset, const char* attribute, double otherwise)
{
    const std::vector<double> given = dataset.numberAttributes(attribute);
    return given.empty() ? otherwise : given.front();
}

Hdf5Dataset openDataset(const Hdf5Group& file, const std::string& name)
{
    if (file.has(name)) return openForeignDataset(file, name);
    throw CmlError(0, "has no dataset \"" + name + "\"; a profile needs x and height, a map x, y and height");
}

Dataset readDataset(const Hdf5Group& file, const std::string& name, double byKey)
{
    const Hdf5Dataset dataset = openDataset(file, name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    if (const auto kind = H5Tget_class(type); kind != H5T_FLOAT && kind != H5T_INTEGER)
        throw CmlError(0, "dataset \"" + name + "\" must hold numbers");
    Dataset data{dataset.shape(), {}, unitOf(dataset, name, byKey)};
    double points = 1.0;
    for (const hsize_t n : data.shape) points *= static_cast<double>(n);
    if (points > mostMapPoints)
        throw CmlError(0, "dataset \"" + name + "\" is " + shapeText(data.shape) + "; at most 64 million points fit");
    refuseQuantity(dataset, name);
    data.values = dataset.numbers();
    const auto hole = std::ranges::find_if(data.values, [](double v) { return !std::isfinite(v); });
    if (hole != data.values.end())
        throw CmlError(0, "dataset \"" + name + "\" holds no number at entry " +
                              std::to_string(hole - data.values.begin() + 1) +
                              "; a surface has no holes: all must be finite");
    refuseMarks(dataset, name, data.values);
    const double scale = numberOr(dataset, "scale_factor", 1.0), offset = numberOr(dataset, "add_offset", 0.0);
    for (double& v : data.values) v = (v * scale + offset) * data.unit;
    return data;
}

/// An axis and whether the file begins at its end.
struct Direction {
    MapAxis axis;
    bool descends = false;
};

Direction axisOf(Dataset data, const std::string& name)
{
    if (data.shape.size() != 1)
        throw CmlError(0, "dataset \"" + name + "\" must be a list, not " + shapeText(data.shape));
    const bool descends = !data.values.empty() && data.values.back() < data.values.front();
    if (descends) std::ranges::reverse(data.values);
    return {equalSteps(data.values, {}, name, data.unit), descends};
}

} // namespace

HeightMap readHeightMapHdf5(const std::filesystem::path& path, const ColumnUnits& key)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw CmlError(0, "does not exist");
    if (!std::filesystem::is_regular_file(path, error)) throw CmlError(0, "is not a regular file");
    const Hdf5Access access;
    try {
        const Hdf5Group file = openHdf5File(path);
        const std::vector<hsize_t> found = openDataset(file, "height").shape();
        const bool isMap = found.size() != 1;
        const ColumnUnits given = unitsOfKey(key, isMap ? 3 : 2);
        const auto unit = [&](std::size_t column) { return given.empty() ? 0.0 : given[column]; };
        const auto [x, turnedX] = axisOf(readDataset(file, "x", unit(0)), "x");
        MapAxis y{1, 0.0, x.step};
        bool turnedY = false;
        std::vector<hsize_t> shape{x.points};
        if (isMap) {
            const Direction across = axisOf(readDataset(file, "y", unit(1)), "y");
            y = across.axis;
            turnedY = across.descends;
            shape.insert(shape.begin(), y.points);
        }
        if (found != shape)
            throw CmlError(0, "dataset \"height\" is " + shapeText(found) + "; x and y ask for " + shapeText(shape) +
                                  " points (y before x)");
        Dataset height = readDataset(file, "height", unit(isMap ? 2 : 1));
        const auto row = [&height, points = x.points](std::size_t j) {
            return height.values.begin() + static_cast<std::ptrdiff_t>(j * points);
        };
        for (std::size_t j = 0; turnedX && j < y.points; ++j) std::reverse(row(j), row(j + 1));
        for (std::size_t j = 0; turnedY && j < y.points / 2; ++j)
            std::swap_ranges(row(j), row(j + 1), row(y.points - 1 - j));
        return builtMap(x, y, std::move(height.values));
    } catch (const Hdf5Error& problem) {
        throw CmlError(0, std::string("cannot be read as HDF5: ") + problem.what());
    }
}

} // namespace touchdown
