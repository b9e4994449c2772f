// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_fields.h"

#include <algorithm>
#include <array>

#include <hdf5_hl.h>

#include "core/results/results_series.h"

namespace touchdown {
namespace {

constexpr hsize_t mostChunkValues = 65536; // 512 KiB

using Extent = std::array<hsize_t, 3>; // time, y, x

std::string unitText(const std::string& unit) { return unit.empty() ? "1" : unit; }

/// Whole rows of one snapshot, so that a reader unpacks no other.
Extent chunkOf(hsize_t ny, hsize_t nx)
{
    const hsize_t columns = std::min(nx, mostChunkValues);
    return {1, std::clamp<hsize_t>(mostChunkValues / columns, 1, ny), columns};
}

Hdf5Handle createField(hid_t group, const std::string& name, hsize_t ny, hsize_t nx)
{
    const Extent none{0, ny, nx};
    const Extent most{H5S_UNLIMITED, ny, nx};
    const Extent chunk = chunkOf(ny, nx);
    const Hdf5Handle space(H5Screate_simple(3, none.data(), most.data()), H5Sclose);
    const Hdf5Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    checkHdf5(H5Pset_chunk(list, 3, chunk.data()));
    checkHdf5(H5Pset_shuffle(list));
    checkHdf5(H5Pset_deflate(list, resultsDeflateLevel));
    return {H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose};
}

std::vector<double> centres(const std::vector<double>& lines)
{
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) result.push_back(0.5 * (lines[i] + lines[i + 1]));
    return result;
}

Hdf5Handle createScale(hid_t group, const std::string& name, const std::vector<double>& lines, const char* longName)
{
    Hdf5Handle scale = writeHdf5Array(group, name, centres(lines));
    describeHdf5(scale, "m", longName);
    checkHdf5(H5DSset_scale(scale, name.c_str()));
    describeHdf5(writeHdf5Array(group, name + "_lines", lines), "m",
                 std::string(longName) + ", the lines between the cells");
    return scale;
}

Extent extentOf(hid_t dataset)
{
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    if (H5Sget_simple_extent_ndims(space) != 3) throw Hdf5Error("a field has not the dimensions time, y and x");
    Extent extent{};
    checkHdf5(H5Sget_simple_extent_dims(space, extent.data(), nullptr));
    return extent;
}

void copyMissingSnapshots(hid_t from, hid_t to)
{
    const Extent wanted = extentOf(from);
    const Extent present = extentOf(to);
    if (wanted[0] <= present[0]) return;
    checkHdf5(H5Dset_extent(to, wanted.data()));
    const Extent chunk = chunkOf(wanted[1], wanted[2]);
    std::vector<unsigned char> bytes;
    for (hsize_t time = present[0]; time < wanted[0]; ++time)
        for (hsize_t y = 0; y < wanted[1]; y += chunk[1])
            for (hsize_t x = 0; x < wanted[2]; x += chunk[2]) {
                const Extent offset{time, y, x};
                hsize_t size = 0;
                checkHdf5(H5Dget_chunk_storage_size(from, offset.data(), &size));
                bytes.resize(size);
                std::uint32_t filters = 0;
                checkHdf5(H5Dread_chunk(from, H5P_DEFAULT, offset.data(), &filters, bytes.data()));
                checkHdf5(H5Dwrite_chunk(to, H5P_DEFAULT, filters, offset.data(), size, bytes.data()));
            }
}

void appendSnapshot(hid_t dataset, const std::vector<double>& values)
{
    Extent extent = extentOf(dataset);
    const Extent begin{extent[0], 0, 0};
    const Extent count{1, extent[1], extent[2]};
    ++extent[0];
    checkHdf5(H5Dset_extent(dataset, extent.data()));
    const Hdf5Handle target(H5Dget_space(dataset), H5Sclose);
    checkHdf5(H5Sselect_hyperslab(target, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr));
    const Hdf5Handle source(H5Screate_simple(3, count.data(), nullptr), H5Sclose);
    checkHdf5(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, source, target, H5P_DEFAULT, values.data()));
}

std::vector<double> readSnapshot(hid_t dataset, const Extent& extent, hsize_t time)
{
    const Extent begin{time, 0, 0};
    const Extent count{1, extent[1], extent[2]};
    const Hdf5Handle source(H5Dget_space(dataset), H5Sclose);
    checkHdf5(H5Sselect_hyperslab(source, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr));
    const Hdf5Handle target(H5Screate_simple(3, count.data(), nullptr), H5Sclose);
    std::vector<double> values(extent[1] * extent[2]);
    checkHdf5(H5Dread(dataset, H5T_NATIVE_DOUBLE, target, source, H5P_DEFAULT, values.data()));
    return values;
}

void createSet(hid_t file, const RecordedFields& fields)
{
    const Hdf5Handle group = createHdf5Group(file, fields.group);
    const Hdf5Handle time = createHdf5Series(group, "time");
    describeHdf5(time, "s", "Time of the snapshots");
    checkHdf5(H5DSset_scale(time, "time"));
    const Hdf5Handle x = createScale(group, "x", fields.grid.x, "Along the motion");
    const Hdf5Handle y = createScale(group, "y", fields.grid.y, "Across the motion");
    for (const Quantity& quantity : fields.quantities) {
        const Hdf5Handle dataset = createField(group, quantity.name, static_cast<hsize_t>(fields.grid.ny()),
                                               static_cast<hsize_t>(fields.grid.nx()));
        describeHdf5(dataset, unitText(quantity.unit), quantity.longName);
        writeHdf5Attribute(dataset, "display_unit", quantity.displayUnit);
        checkHdf5(H5DSattach_scale(dataset, time, 0));
        checkHdf5(H5DSattach_scale(dataset, y, 1));
        checkHdf5(H5DSattach_scale(dataset, x, 2));
    }
}

/// The groups of a file that hold fields, in the order in which they were created.
std::vector<std::string> fieldGroups(hid_t file)
{
    std::vector<std::string> groups;
    for (const std::string& name : namesInHdf5Group(openHdf5Group(file, "/")))
        if (name == "fields" || name.ends_with("_fields")) groups.push_back(name);
    return groups;
}

void readSet(hid_t file, const std::string& name, StoredFields& stored)
{
    const Hdf5Handle group = openHdf5Group(file, name);
    const std::vector<double> times = readSeries(openHdf5Dataset(group, "time"));
    RecordedFields fields;
    fields.group = name;
    fields.grid = {readSeries(openHdf5Dataset(group, "x_lines")), readSeries(openHdf5Dataset(group, "y_lines"))};
    if (fields.grid.x.size() < 2 || fields.grid.y.size() < 2) throw Hdf5Error("the grid of " + name + " has no cells");
    const std::size_t first = stored.snapshots.size();
    for (const double time : times) stored.snapshots.push_back({time, stored.sets.size(), {}});
    for (const std::string& member : namesInHdf5Group(group)) {
        if (member == "time" || member == "x" || member == "y" || member.ends_with("_lines")) continue;
        const Hdf5Handle dataset = openHdf5Dataset(group, member);
        const Extent extent = extentOf(dataset);
        if (extent[0] != times.size() || extent[1] != static_cast<hsize_t>(fields.grid.ny()) ||
            extent[2] != static_cast<hsize_t>(fields.grid.nx()))
            throw Hdf5Error(member + " does not fit the grid of " + name);
        // A damaged header may ask for more memory than there is.
        if (extent[0] * extent[1] * extent[2] / 1024 > H5Dget_storage_size(dataset))
            throw Hdf5Error(member + " holds fewer values than it says");
        Quantity quantity{member, readHdf5Attribute(dataset, "unit"), readHdf5Attribute(dataset, "display_unit"),
                          readHdf5Attribute(dataset, "long_name")};
        if (quantity.unit == "1") quantity.unit.clear();
        fields.quantities.push_back(std::move(quantity));
        for (hsize_t k = 0; k < extent[0]; ++k)
            stored.snapshots[first + k].values.push_back(readSnapshot(dataset, extent, k));
    }
    stored.sets.push_back(std::move(fields));
}

} // namespace

void createFields(hid_t file, const std::vector<RecordedFields>& sets)
{
    for (const RecordedFields& set : sets) createSet(file, set);
}

void appendFields(hid_t file, const std::vector<RecordedFields>& sets, std::span<const FieldSnapshot> snapshots)
{
    for (const FieldSnapshot& snapshot : snapshots) {
        const RecordedFields& set = sets[snapshot.set];
        const Hdf5Handle group = openHdf5Group(file, set.group);
        for (std::size_t i = 0; i < set.quantities.size(); ++i)
            appendSnapshot(openHdf5Dataset(group, set.quantities[i].name), snapshot.values[i]);
        appendToSeries(openHdf5Dataset(group, "time"), {snapshot.time});
    }
}

void copyMissingFields(hid_t from, hid_t to, const std::vector<RecordedFields>& sets)
{
    for (const RecordedFields& set : sets) {
        const Hdf5Handle source = openHdf5Group(from, set.group);
        const Hdf5Handle target = openHdf5Group(to, set.group);
        copyMissingChunks(openHdf5Dataset(source, "time"), openHdf5Dataset(target, "time"));
        for (const Quantity& quantity : set.quantities)
            copyMissingSnapshots(openHdf5Dataset(source, quantity.name), openHdf5Dataset(target, quantity.name));
    }
}

hsize_t storedFieldBytes(hid_t file, const std::vector<RecordedFields>& sets)
{
    hsize_t bytes = 0;
    for (const RecordedFields& set : sets) {
        const Hdf5Handle group = openHdf5Group(file, set.group);
        for (const Quantity& quantity : set.quantities)
            bytes += H5Dget_storage_size(openHdf5Dataset(group, quantity.name));
    }
    return bytes;
}

StoredFields readFields(hid_t file)
{
    StoredFields stored;
    for (const std::string& group : fieldGroups(file)) readSet(file, group, stored);
    std::ranges::stable_sort(stored.snapshots, {}, &FieldSnapshot::time);
    return stored;
}

} // namespace touchdown
