// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_inspection.h"

#include <algorithm>
#include <vector>

namespace touchdown {

namespace {

constexpr double largestChunk = 1 << 26; // of an array that is smaller [byte]
constexpr int deepestGroup = 8;
constexpr std::size_t mostMembers = 10'000; // of a file

[[noreturn]] void refuse(const std::string& name, const std::string& why)
{
    throw Hdf5Error("\"" + name + "\" " + why);
}

void checkLink(hid_t group, const std::string& name)
{
    H5L_info_t link{};
    checkHdf5(H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT));
    if (link.type == H5L_TYPE_HARD) return;
    refuse(name, "is a link to another place or file; only what lies in the file itself is read");
}

/// Bytes of `size` numbers.
double bytesOf(const std::vector<hsize_t>& size, double each)
{
    for (const hsize_t n : size) each *= static_cast<double>(n);
    return each;
}

void checkPieces(hid_t list, const std::string& name, std::size_t dimensions, double each, double whole)
{
    constexpr H5Z_filter_t known[] = {H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE, H5Z_FILTER_FLETCHER32};
    std::vector<hsize_t> chunk(dimensions);
    checkHdf5(H5Pget_chunk(list, static_cast<int>(chunk.size()), chunk.data()));
    if (bytesOf(chunk, each) > std::max(largestChunk, whole))
        refuse(name, "is stored in pieces that are larger than the array itself");
    for (int i = 0; i < H5Pget_nfilters(list); ++i) {
        unsigned flags = 0, settings = 0;
        std::size_t none = 0;
        const H5Z_filter_t filter =
            H5Pget_filter2(list, static_cast<unsigned>(i), &flags, &none, nullptr, 0, nullptr, &settings);
        if (std::ranges::find(known, filter) == std::end(known))
            refuse(name, "is stored with the filter " + std::to_string(filter) +
                             "; only gzip (deflate), shuffle and fletcher32 are read");
    }
}

/// Returns its bytes in memory, as numbers of 8.
double checkDataset(const Hdf5Dataset& dataset, const std::string& name)
{
    const Hdf5Handle list(H5Dget_create_plist(dataset), H5Pclose), type(H5Dget_type(dataset), H5Tclose);
    const H5D_layout_t layout = H5Pget_layout(list);
    if (layout == H5D_VIRTUAL) refuse(name, "is virtual: its numbers lie in other files, which are not read");
    if (layout < 0) refuse(name, "has no known layout");
    if (H5Pget_external_count(list) != 0) refuse(name, "has its numbers in another file, which is not read");
    const std::vector<hsize_t> shape = dataset.shape();
    const auto each = static_cast<double>(H5Tget_size(type));
    if (layout == H5D_CHUNKED) checkPieces(list, name, shape.size(), each, bytesOf(shape, each));
    return bytesOf(shape, std::max(each, 8.0));
}

class Inspection {
public:
    explicit Inspection(std::uintmax_t mostBytes) : mostBytes_(static_cast<double>(mostBytes)) {}

    void check(const Hdf5Group& group, int depth)
    {
        if (depth > deepestGroup) throw Hdf5Error("groups lie in groups without end");
        for (const std::string& name : group.names()) {
            if (++members_ > mostMembers) throw Hdf5Error("it has more than 10000 groups and arrays");
            checkLink(group, name);
            Hdf5Group member(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
            const H5I_type_t kind = H5Iget_type(member);
            if (kind == H5I_GROUP) check(member, depth + 1);
            if (kind == H5I_DATASET) {
                const Hdf5Dataset dataset = group.get(name);
                bytes_ += checkDataset(dataset, name);
                dataset.checkStored();
            }
            if (bytes_ > mostBytes_) throw Hdf5Error("its arrays are larger than a file of its size can hold");
        }
    }

private:
    double mostBytes_;
    double bytes_ = 0.0;
    std::size_t members_ = 0;
};

} // namespace

Hdf5Dataset openForeignDataset(const Hdf5Group& group, const std::string& name)
{
    checkLink(group, name);
    Hdf5Dataset dataset = group.get(name);
    checkDataset(dataset, name);
    return dataset;
}

void inspectHdf5File(const Hdf5Group& file, std::uintmax_t mostBytes) { Inspection(mostBytes).check(file, 0); }

} // namespace touchdown
