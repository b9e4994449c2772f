// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_access.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace touchdown {
namespace {

std::mutex& library()
{
    static std::mutex mutex;
    return mutex;
}

// The library's innermost message; of a failed system call the system's own words.
std::string lastError()
{
    std::string text;
    const auto first = [](unsigned n, const H5E_error2_t* error, void* data) -> herr_t {
        if (n == 0 && error->desc) *static_cast<std::string*>(data) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first, &text);
    constexpr std::string_view marker = "error message = '";
    if (const auto at = text.find(marker); at != std::string::npos) {
        const auto begin = at + marker.size();
        text = text.substr(begin, text.find('\'', begin) - begin);
    }
    return text.empty() ? "unknown failure of the HDF5 library" : text;
}

Hdf5Handle scalarSpace() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

Hdf5Handle createAttribute(hid_t object, const std::string& name, hid_t type)
{
    // Written again by a later flush, it takes the new value.
    if (H5Aexists(object, name.c_str()) > 0) checkHdf5(H5Adelete(object, name.c_str()));
    return {H5Acreate2(object, name.c_str(), type, scalarSpace(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
}

Hdf5Handle writeScalar(hid_t parent, const std::string& name, hid_t fileType, hid_t memoryType, const void* value)
{
    Hdf5Handle dataset(H5Dcreate2(parent, name.c_str(), fileType, scalarSpace(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose);
    checkHdf5(H5Dwrite(dataset, memoryType, H5S_ALL, H5S_ALL, H5P_DEFAULT, value));
    return dataset;
}

Hdf5Handle writeArray(hid_t parent, const std::string& name, hid_t type, std::size_t size, const void* values)
{
    const hsize_t length = size;
    const Hdf5Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
    Hdf5Handle dataset(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    if (size > 0) checkHdf5(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    return dataset;
}

// Text of either kind that HDF5 knows, through `read(memory type, buffer)`.
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
    std::string result(H5Tget_size(type), '\0');
    checkHdf5(read(type, result.data()));
    result.resize(std::min(result.size(), result.find('\0')));
    return result;
}

} // namespace

Hdf5Access::Hdf5Access() : lock_(library())
{
    // Without its own clean-up at exit: a file that could not be written (disk full) would be tried once more there.
    static const herr_t once = H5dont_atexit();
    static_cast<void>(once);
    H5Eget_auto2(H5E_DEFAULT, &printer_, &printerData_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Access::~Hdf5Access() { H5Eset_auto2(H5E_DEFAULT, printer_, printerData_); }

Hdf5Handle::Hdf5Handle(hid_t id, Close closer) : id_(id), close_(closer)
{
    if (id < 0) throw Hdf5Error(lastError());
}

Hdf5Handle::~Hdf5Handle()
{
    if (id_ >= 0) close_(id_);
}

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_)
{}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
}

void Hdf5Handle::close()
{
    if (id_ >= 0) checkHdf5(close_(std::exchange(id_, H5I_INVALID_HID)));
}

void checkHdf5(herr_t status)
{
    if (status < 0) throw Hdf5Error(lastError());
}

Hdf5Handle hdf5FileAccess()
{
    Hdf5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    checkHdf5(H5Pset_fclose_degree(list, H5F_CLOSE_STRONG));
    checkHdf5(H5Pset_file_locking(list, true, true));
    return list;
}

Hdf5Handle createHdf5Group(hid_t parent, const std::string& name)
{
    const Hdf5Handle list(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    checkHdf5(H5Pset_link_creation_order(list, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), H5Gclose};
}

Hdf5Handle openHdf5Group(hid_t parent, const std::string& name)
{
    return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose};
}

Hdf5Handle openHdf5Dataset(hid_t parent, const std::string& name)
{
    return {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose};
}

Hdf5Handle hdf5TextType()
{
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    checkHdf5(H5Tset_size(type, H5T_VARIABLE));
    checkHdf5(H5Tset_cset(type, H5T_CSET_UTF8));
    return type;
}

void writeHdf5Attribute(hid_t object, const std::string& name, const std::string& value)
{
    const Hdf5Handle type = hdf5TextType();
    const char* text = value.c_str();
    checkHdf5(H5Awrite(createAttribute(object, name, type), type, &text));
}

void writeHdf5Attribute(hid_t object, const std::string& name, double value)
{
    checkHdf5(H5Awrite(createAttribute(object, name, H5T_IEEE_F64LE), H5T_NATIVE_DOUBLE, &value));
}

void writeHdf5Attribute(hid_t object, const std::string& name, std::int64_t value)
{
    checkHdf5(H5Awrite(createAttribute(object, name, H5T_STD_I64LE), H5T_NATIVE_INT64, &value));
}

std::string readHdf5Attribute(hid_t object, const std::string& name)
{
    if (H5Aexists(object, name.c_str()) <= 0) return {};
    const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    return readText(type, space, [&](hid_t memory, void* buffer) { return H5Aread(attribute, memory, buffer); });
}

Hdf5Handle writeHdf5Scalar(hid_t parent, const std::string& name, const std::string& value)
{
    const Hdf5Handle type = hdf5TextType();
    const char* text = value.c_str();
    return writeScalar(parent, name, type, type, &text);
}

Hdf5Handle writeHdf5Scalar(hid_t parent, const std::string& name, double value)
{
    return writeScalar(parent, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

Hdf5Handle writeHdf5Scalar(hid_t parent, const std::string& name, std::int64_t value)
{
    return writeScalar(parent, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

std::string readHdf5Text(hid_t parent, const std::string& name)
{
    const Hdf5Handle dataset = openHdf5Dataset(parent, name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    return readText(type, space, [&](hid_t memory, void* buffer) {
        return H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
    });
}

Hdf5Handle writeHdf5Array(hid_t parent, const std::string& name, std::span<const double> values)
{
    return writeArray(parent, name, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

Hdf5Handle writeHdf5Array(hid_t parent, const std::string& name, const std::vector<std::string>& values)
{
    std::vector<const char*> texts;
    texts.reserve(values.size());
    for (const std::string& value : values) texts.push_back(value.c_str());
    return writeArray(parent, name, hdf5TextType(), texts.size(), texts.data());
}

std::vector<std::string> namesInHdf5Group(hid_t group)
{
    const Hdf5Handle list(H5Gget_create_plist(group), H5Pclose);
    unsigned order = 0;
    checkHdf5(H5Pget_link_creation_order(list, &order));
    std::vector<std::string> result;
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
        static_cast<std::vector<std::string>*>(data)->push_back(name);
        return 0;
    };
    const H5_index_t index = (order & H5P_CRT_ORDER_TRACKED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
    checkHdf5(H5Literate(group, index, H5_ITER_INC, nullptr, collect, &result));
    return result;
}

void describeHdf5(hid_t dataset, const std::string& unit, const std::string& longName)
{
    writeHdf5Attribute(dataset, "unit", unit);
    writeHdf5Attribute(dataset, "long_name", longName);
}

} // namespace touchdown
