// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_series.h"

#include <cstdint>

namespace touchdown {
namespace {

// 64 KiB a column: a reader that wants a short window unpacks little, and half a chunk, rewritten at a flush, costs
// little.
constexpr hsize_t chunkSamples = 8192;

} // namespace

Hdf5Handle createHdf5Series(hid_t group, const std::string& name)
{
    const hsize_t none = 0;
    const hsize_t unlimited = H5S_UNLIMITED;
    const Hdf5Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
    const Hdf5Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    checkHdf5(H5Pset_chunk(list, 1, &chunkSamples));
    checkHdf5(H5Pset_shuffle(list));
    checkHdf5(H5Pset_deflate(list, resultsDeflateLevel));
    return {H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose};
}

hsize_t seriesLength(hid_t dataset)
{
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    hsize_t n = 0;
    if (H5Sget_simple_extent_ndims(space) != 1) throw Hdf5Error("a time series is not one-dimensional");
    checkHdf5(H5Sget_simple_extent_dims(space, &n, nullptr));
    return n;
}

void copyMissingChunks(hid_t from, hid_t to)
{
    const hsize_t wanted = seriesLength(from);
    const hsize_t present = seriesLength(to);
    if (wanted <= present) return;
    checkHdf5(H5Dset_extent(to, &wanted));
    std::vector<unsigned char> bytes;
    for (hsize_t offset = present - present % chunkSamples; offset < wanted; offset += chunkSamples) {
        hsize_t size = 0;
        checkHdf5(H5Dget_chunk_storage_size(from, &offset, &size));
        bytes.resize(size);
        std::uint32_t filters = 0;
        checkHdf5(H5Dread_chunk(from, H5P_DEFAULT, &offset, &filters, bytes.data()));
        checkHdf5(H5Dwrite_chunk(to, H5P_DEFAULT, filters, &offset, size, bytes.data()));
    }
}

void appendToSeries(hid_t dataset, const std::vector<double>& values)
{
    const hsize_t before = seriesLength(dataset);
    const hsize_t count = values.size();
    const hsize_t after = before + count;
    checkHdf5(H5Dset_extent(dataset, &after));
    const Hdf5Handle target(H5Dget_space(dataset), H5Sclose);
    checkHdf5(H5Sselect_hyperslab(target, H5S_SELECT_SET, &before, nullptr, &count, nullptr));
    const Hdf5Handle source(H5Screate_simple(1, &count, nullptr), H5Sclose);
    checkHdf5(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, source, target, H5P_DEFAULT, values.data()));
}

std::vector<double> readSeries(hid_t dataset)
{
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    if (H5Sget_simple_extent_ndims(space) != 1) throw Hdf5Error("a time series is not one-dimensional");
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    // A damaged header may ask for more memory than there is; compressed samples take at least a bit or so each.
    if (n < 0 || static_cast<hsize_t>(n) / 1024 > H5Dget_storage_size(dataset))
        throw Hdf5Error("a time series holds fewer samples than it says");
    std::vector<double> values(static_cast<std::size_t>(n));
    if (n > 0) checkHdf5(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
}

} // namespace touchdown
