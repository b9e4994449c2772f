// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/height_map_hdf5.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/formats/cml_text.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/height_map_builder.h"
#include "core/formats/quotation.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

struct Dataset {
    std::vector<hsize_t> shape;
    std::vector<double> values; // [m]
};

std::string shapeText(const std::vector<hsize_t>& shape)
{
    std::string text;
    for (const hsize_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
    return text.empty() ? "a single number" : text;
}

double unitOf(const Hdf5Dataset& dataset, const std::string& name)
{
    const std::string unit = dataset.attribute("unit");
    if (unit.empty()) return 1.0;
    if (const auto factor = lengthUnit(unit)) return *factor;
    throw CmlError(0, "the unit of dataset \"" + name + "\" must be a length, as \"nm\", not " + inQuotes(unit));
}

Dataset readDataset(const Hdf5Group& file, const std::string& name)
{
    if (!file.has(name))
        throw CmlError(0, "has no dataset \"" + name + "\"; a profile needs x and height, a map x, y and height");
    const Hdf5Dataset dataset = file.get(name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    if (const auto kind = H5Tget_class(type); kind != H5T_FLOAT && kind != H5T_INTEGER)
        throw CmlError(0, "dataset \"" + name + "\" must hold numbers");
    Dataset data{dataset.shape(), {}};
    double points = 1.0;
    for (const hsize_t n : data.shape) points *= static_cast<double>(n);
    if (points > mostMapPoints)
        throw CmlError(0, "dataset \"" + name + "\" is " + shapeText(data.shape) + "; at most 64 million points fit");
    const double unit = unitOf(dataset, name);
    data.values = dataset.numbers();
    const auto hole = std::ranges::find_if(data.values, [](double v) { return !std::isfinite(v); });
    if (hole != data.values.end())
        throw CmlError(0, "dataset \"" + name + "\" holds no number at entry " +
                              std::to_string(hole - data.values.begin() + 1) +
                              "; a map has no holes: all must be finite");
    for (double& v : data.values) v *= unit;
    return data;
}

MapAxis axisOf(const Dataset& data, const std::string& name)
{
    if (data.shape.size() != 1)
        throw CmlError(0, "dataset \"" + name + "\" must be a list, not " + shapeText(data.shape));
    return equalSteps(data.values, {}, name);
}

} // namespace

HeightMap readHeightMapHdf5(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw CmlError(0, "does not exist");
    if (!std::filesystem::is_regular_file(path, error)) throw CmlError(0, "is not a regular file");
    const Hdf5Access access;
    try {
        const Hdf5Group file = openHdf5File(path);
        Dataset height = readDataset(file, "height");
        const MapAxis x = axisOf(readDataset(file, "x"), "x");
        MapAxis y{1, 0.0, x.step};
        std::vector<hsize_t> shape{x.points};
        if (height.shape.size() != 1) {
            y = axisOf(readDataset(file, "y"), "y");
            shape.insert(shape.begin(), y.points);
        }
        if (height.shape != shape)
            throw CmlError(0, "dataset \"height\" is " + shapeText(height.shape) + "; x and y ask for " +
                                  shapeText(shape) + " points (y before x)");
        return builtMap(x, y, std::move(height.values));
    } catch (const Hdf5Error& problem) {
        throw CmlError(0, std::string("cannot be read as HDF5: ") + problem.what());
    }
}

} // namespace touchdown
