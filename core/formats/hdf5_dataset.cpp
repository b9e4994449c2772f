// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_dataset.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <hdf5_hl.h>

namespace touchdown {
namespace {

using Extent = std::vector<hsize_t>;

constexpr hssize_t mostAttributeNumbers = 1000;
constexpr std::size_t longestText = 1 << 24; // [byte]

Hdf5Handle createAttribute(hid_t object, const std::string& name, hid_t type)
{
    if (H5Aexists(object, name.c_str()) > 0) checkHdf5(H5Adelete(object, name.c_str()));
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    return {H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
}

/// Text of either kind that HDF5 knows, through `read(memory type, buffer)`.
template <typename Read>
std::string readText(hid_t type, hid_t space, Read read)
{
    if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return {};
    if (H5Tis_variable_str(type) > 0) {
        char* text = nullptr;
        const Hdf5Handle memory(H5Tcopy(type), H5Tclose);
        checkHdf5(read(memory, &text));
        std::string result = text ? text : "";
        H5free_memory(text);
        return result;
    }
    if (H5Tget_size(type) > longestText) throw Hdf5Error("a text is too long");
    std::string result(H5Tget_size(type), '\0');
    checkHdf5(read(type, result.data()));
    result.resize(std::min(result.size(), result.find('\0')));
    return result;
}

hsize_t product(const Extent& extent)
{
    return std::accumulate(extent.begin(), extent.end(), hsize_t{1}, std::multiplies<>());
}

/// `count` entries from `first` on, in the file.
Hdf5Handle selected(hid_t dataset, Extent count, hsize_t first)
{
    Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    Extent begin(count.size(), 0);
    begin.front() = first;
    checkHdf5(H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr));
    return space;
}

Hdf5Handle spaceOf(const Extent& extent)
{
    return {H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose};
}

void copyChunk(hid_t from, hid_t to, const Extent& offset, std::vector<unsigned char>& bytes)
{
    hsize_t size = 0;
    checkHdf5(H5Dget_chunk_storage_size(from, offset.data(), &size));
    bytes.resize(size);
    std::uint32_t filters = 0;
    checkHdf5(H5Dread_chunk(from, H5P_DEFAULT, offset.data(), &filters, bytes.data()));
    checkHdf5(H5Dwrite_chunk(to, H5P_DEFAULT, filters, offset.data(), size, bytes.data()));
}

} // namespace

Hdf5Handle hdf5TextType()
{
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    checkHdf5(H5Tset_size(type, H5T_VARIABLE));
    checkHdf5(H5Tset_cset(type, H5T_CSET_UTF8));
    return type;
}

void Hdf5Object::set(const std::string& name, std::string_view text) const
{
    const Hdf5Handle type = hdf5TextType();
    const std::string terminated(text);
    const char* pointer = terminated.c_str();
    checkHdf5(H5Awrite(createAttribute(*this, name, type), type, &pointer));
}

void Hdf5Object::set(const std::string& name, double value) const
{
    checkHdf5(H5Awrite(createAttribute(*this, name, H5T_IEEE_F64LE), H5T_NATIVE_DOUBLE, &value));
}

void Hdf5Object::set(const std::string& name, std::int64_t value) const
{
    checkHdf5(H5Awrite(createAttribute(*this, name, H5T_STD_I64LE), H5T_NATIVE_INT64, &value));
}

std::string Hdf5Object::attribute(const std::string& name) const
{
    if (H5Aexists(*this, name.c_str()) <= 0) return {};
    const Hdf5Handle attribute(H5Aopen(*this, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
    return readText(type, space, [&](hid_t memory, void* buffer) { return H5Aread(attribute, memory, buffer); });
}

double Hdf5Object::numberAttribute(const std::string& name) const
{
    const std::vector<double> values = numberAttributes(name);
    return values.size() == 1 ? values.front() : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> Hdf5Object::numberAttributes(const std::string& name) const
{
    if (H5Aexists(*this, name.c_str()) <= 0) return {};
    const Hdf5Handle attribute(H5Aopen(*this, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
    const H5T_class_t kind = H5Tget_class(type);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || count < 1) return {};
    if (count > mostAttributeNumbers) throw Hdf5Error("the attribute \"" + name + "\" is too long");
    std::vector<double> values(static_cast<std::size_t>(count));
    checkHdf5(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()));
    return values;
}

void Hdf5Dataset::describe(const std::string& unit, const std::string& longName) const
{
    set("unit", unit.empty() ? "1" : unit);
    set("long_name", longName);
}

void Hdf5Dataset::makeScale(const std::string& name) const { checkHdf5(H5DSset_scale(*this, name.c_str())); }

void Hdf5Dataset::attachScale(const Hdf5Dataset& scale, unsigned dimension) const
{
    checkHdf5(H5DSattach_scale(*this, scale, dimension));
}

std::vector<hsize_t> Hdf5Dataset::shape() const
{
    const Hdf5Handle space(H5Dget_space(*this), H5Sclose);
    Extent extent(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
    if (!extent.empty()) checkHdf5(H5Sget_simple_extent_dims(space, extent.data(), nullptr));
    return extent;
}

std::string Hdf5Dataset::text() const
{
    const Hdf5Handle type(H5Dget_type(*this), H5Tclose), space(H5Dget_space(*this), H5Sclose);
    return readText(type, space, [&](hid_t memory, void* buffer) {
        return H5Dread(*this, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
    });
}

bool Hdf5Dataset::holdsTexts() const { return H5Tget_class(Hdf5Handle(H5Dget_type(*this), H5Tclose)) == H5T_STRING; }

std::vector<std::string> Hdf5Dataset::texts() const
{
    const Hdf5Handle type(H5Dget_type(*this), H5Tclose), space(H5Dget_space(*this), H5Sclose);
    if (shape().size() != 1 || H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) <= 0)
        throw Hdf5Error("an array does not hold texts");
    checkStored();
    std::vector<char*> pointers(shape().front(), nullptr);
    if (pointers.empty()) return {};
    const Hdf5Handle memory = hdf5TextType();
    checkHdf5(H5Dread(*this, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()));
    std::vector<std::string> texts;
    for (const char* pointer : pointers) texts.emplace_back(pointer ? pointer : "");
    checkHdf5(H5Dvlen_reclaim(memory, space, H5P_DEFAULT, pointers.data()));
    return texts;
}

void Hdf5Dataset::checkStored() const
{
    constexpr hsize_t mostPacked = 1032; // what deflate makes of a byte, at most
    const Hdf5Handle type(H5Dget_type(*this), H5Tclose);
    if (product(shape()) / mostPacked * H5Tget_size(type) > storedBytes())
        throw Hdf5Error("an array holds fewer numbers than it says");
}

std::vector<double> Hdf5Dataset::numbers() const
{
    checkStored();
    std::vector<double> values(product(shape()));
    if (!values.empty()) checkHdf5(H5Dread(*this, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
}

std::vector<double> Hdf5Dataset::column() const
{
    if (shape().size() != 1) throw Hdf5Error("a column is not one-dimensional");
    return numbers();
}

std::vector<std::int64_t> Hdf5Dataset::integers() const
{
    if (shape().size() != 1) throw Hdf5Error("an array of integers is not one-dimensional");
    checkStored();
    std::vector<std::int64_t> values(shape().front());
    if (!values.empty()) checkHdf5(H5Dread(*this, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
}

void Hdf5Dataset::append(std::span<const double> values) const
{
    if (values.empty()) return;
    Extent extent = shape();
    Extent count = extent;
    count.front() = 1;
    count.front() = values.size() / product(count);
    const hsize_t before = extent.front();
    extent.front() += count.front();
    checkHdf5(H5Dset_extent(*this, extent.data()));
    const Hdf5Handle target = selected(*this, count, before);
    checkHdf5(H5Dwrite(*this, H5T_NATIVE_DOUBLE, spaceOf(count), target, H5P_DEFAULT, values.data()));
}

std::vector<double> Hdf5Dataset::entry(hsize_t index) const
{
    Extent count = shape();
    count.front() = 1;
    std::vector<double> values(product(count));
    const Hdf5Handle source = selected(*this, count, index);
    checkHdf5(H5Dread(*this, H5T_NATIVE_DOUBLE, spaceOf(count), source, H5P_DEFAULT, values.data()));
    return values;
}

void Hdf5Dataset::copyMissing(const Hdf5Dataset& from) const
{
    const Extent wanted = from.shape();
    const hsize_t present = length();
    if (wanted.front() <= present) return;
    checkHdf5(H5Dset_extent(*this, wanted.data()));
    const Hdf5Handle list(H5Dget_create_plist(*this), H5Pclose);
    Extent chunk(wanted.size());
    checkHdf5(H5Pget_chunk(list, static_cast<int>(chunk.size()), chunk.data()));
    Extent offset(wanted.size(), 0);
    offset.front() = present - present % chunk.front();
    std::vector<unsigned char> bytes;
    while (offset.front() < wanted.front()) {
        copyChunk(from, *this, offset, bytes);
        for (std::size_t d = offset.size(); d-- > 0;) { // the last dimension runs first
            offset[d] += chunk[d];
            if (d == 0 || offset[d] < wanted[d]) break;
            offset[d] = 0;
        }
    }
}

void checkFinite(std::span<const double> numbers, const std::string& name)
{
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
        throw Hdf5Error(name + " holds something that is not a number");
}

} // namespace touchdown
