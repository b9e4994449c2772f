// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_group.h"

#include <algorithm>

namespace touchdown {
namespace {

constexpr unsigned deflateLevel = 2;
constexpr hsize_t mostChunkNumbers = 65536; // of an entry that is a matrix; 512 KiB
constexpr unsigned orderKept = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;

Hdf5Dataset createDataset(hid_t group, const std::string& name, hid_t type, hid_t space, hid_t list = H5P_DEFAULT)
{
    return {H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose};
}

Hdf5Dataset putScalar(hid_t group, const std::string& name, hid_t fileType, hid_t memoryType, const void* value)
{
    Hdf5Dataset dataset = createDataset(group, name, fileType, Hdf5Handle(H5Screate(H5S_SCALAR), H5Sclose));
    checkHdf5(H5Dwrite(dataset, memoryType, H5S_ALL, H5S_ALL, H5P_DEFAULT, value));
    return dataset;
}

Hdf5Dataset putArray(hid_t group, const std::string& name, hid_t type, hsize_t size, const void* values)
{
    Hdf5Dataset dataset = createDataset(group, name, type, Hdf5Handle(H5Screate_simple(1, &size, nullptr), H5Sclose));
    if (size > 0) checkHdf5(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    return dataset;
}

Hdf5Dataset createCompressed(hid_t group, const std::string& name, const std::vector<hsize_t>& size,
                             const std::vector<hsize_t>& most, const std::vector<hsize_t>& chunk)
{
    const int dimensions = static_cast<int>(size.size());
    const Hdf5Handle space(H5Screate_simple(dimensions, size.data(), most.data()), H5Sclose);
    const Hdf5Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    checkHdf5(H5Pset_chunk(list, dimensions, chunk.data()));
    checkHdf5(H5Pset_shuffle(list));
    checkHdf5(H5Pset_deflate(list, deflateLevel));
    return createDataset(group, name, H5T_IEEE_F64LE, space, list);
}

} // namespace

Hdf5Group Hdf5Group::create(const std::string& name) const
{
    const Hdf5Handle list(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    checkHdf5(H5Pset_link_creation_order(list, orderKept));
    return {H5Gcreate2(*this, name.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), H5Gclose};
}

Hdf5Group Hdf5Group::group(const std::string& name) const
{
    return {H5Gopen2(*this, name.c_str(), H5P_DEFAULT), H5Gclose};
}

Hdf5Dataset Hdf5Group::get(const std::string& name) const
{
    return {H5Dopen2(*this, name.c_str(), H5P_DEFAULT), H5Dclose};
}

bool Hdf5Group::has(const std::string& name) const { return H5Lexists(*this, name.c_str(), H5P_DEFAULT) > 0; }

void Hdf5Group::remove(const std::string& name) const { checkHdf5(H5Ldelete(*this, name.c_str(), H5P_DEFAULT)); }

std::vector<std::string> Hdf5Group::names() const
{
    const Hdf5Handle self(H5Gopen2(*this, ".", H5P_DEFAULT), H5Gclose); // a file has no such list
    const Hdf5Handle list(H5Gget_create_plist(self), H5Pclose);
    unsigned order = 0;
    checkHdf5(H5Pget_link_creation_order(list, &order));
    std::vector<std::string> result;
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
        static_cast<std::vector<std::string>*>(data)->push_back(name);
        return 0;
    };
    const H5_index_t index = (order & H5P_CRT_ORDER_TRACKED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
    checkHdf5(H5Literate(self, index, H5_ITER_INC, nullptr, collect, &result));
    return result;
}

Hdf5Dataset Hdf5Group::put(const std::string& name, double value) const
{
    return putScalar(*this, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

Hdf5Dataset Hdf5Group::put(const std::string& name, std::int64_t value) const
{
    return putScalar(*this, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

Hdf5Dataset Hdf5Group::put(const std::string& name, std::string_view text) const
{
    const Hdf5Handle type = hdf5TextType();
    const std::string terminated(text);
    const char* pointer = terminated.c_str();
    return putScalar(*this, name, type, type, &pointer);
}

Hdf5Dataset Hdf5Group::put(const std::string& name, std::span<const double> values) const
{
    return putArray(*this, name, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

Hdf5Dataset Hdf5Group::put(const std::string& name, const std::vector<std::int64_t>& values) const
{
    return putArray(*this, name, H5T_STD_I64LE, values.size(), values.data());
}

Hdf5Dataset Hdf5Group::put(const std::string& name, const std::vector<std::string>& texts) const
{
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    return putArray(*this, name, hdf5TextType(), pointers.size(), pointers.data());
}

Hdf5Dataset Hdf5Group::table(const std::string& name, hsize_t rows, hsize_t columns, const double* values,
                             const std::string& unit, const std::string& longName) const
{
    const std::vector<hsize_t> size{rows, columns};
    Hdf5Dataset dataset = createCompressed(*this, name, size, size, size);
    checkHdf5(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    dataset.describe(unit, longName);
    return dataset;
}

Hdf5Dataset Hdf5Group::growing(const std::string& name, const std::string& unit, const std::string& longName,
                               const std::vector<hsize_t>& entry) const
{
    std::vector<hsize_t> size{0}, most{H5S_UNLIMITED}, chunk{entry.empty() ? numbersPerChunk : 1};
    size.insert(size.end(), entry.begin(), entry.end());
    most.insert(most.end(), entry.begin(), entry.end());
    if (entry.size() == 2) {
        const hsize_t columns = std::min(entry[1], mostChunkNumbers);
        chunk.insert(chunk.end(), {std::clamp<hsize_t>(mostChunkNumbers / columns, 1, entry[0]), columns});
    }
    Hdf5Dataset dataset = createCompressed(*this, name, size, most, chunk);
    dataset.describe(unit, longName);
    return dataset;
}

} // namespace touchdown
