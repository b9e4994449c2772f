// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_access.h"

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
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
        if (text == std::generic_category().message(EWOULDBLOCK)) text = "another program has it open";
    }
    return text.empty() ? "unknown failure of the HDF5 library" : text;
}

} // namespace

Hdf5Access::Hdf5Access() : lock_(library())
{
    // Without its own clean-up at exit: a file that could not be written (disk full) would be tried once more there.
    // And no filters from elsewhere: a file names them, and the library would run them.
    static const bool once = [] {
        H5dont_atexit();
        H5PLset_loading_state(0);
        return true;
    }();
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

} // namespace touchdown
