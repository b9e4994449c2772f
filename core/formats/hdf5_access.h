// SPDX-License-Identifier: GPL-3.0-or-later
//
// HDF5 with owned identifiers, failures as exceptions with a readable cause, and one thread at a time:
// Debian's library is not thread-safe. Used by the results files only.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <hdf5.h>

namespace touchdown {

/// What the library could not do, in words that a person can act on ("No space left on device").
class Hdf5Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Hold one around every use: the library is ours alone, and prints no errors of its own meanwhile.
class Hdf5Access {
public:
    Hdf5Access();
    ~Hdf5Access();
    Hdf5Access(const Hdf5Access&) = delete;
    Hdf5Access& operator=(const Hdf5Access&) = delete;

private:
    std::unique_lock<std::mutex> lock_;
    H5E_auto2_t printer_ = nullptr;
    void* printerData_ = nullptr;
};

/// Owns an identifier.
class Hdf5Handle {
public:
    using Close = herr_t (*)(hid_t);
    Hdf5Handle() = default;
    /// Throws Hdf5Error when the library returned no identifier.
    Hdf5Handle(hid_t id, Close closer);
    ~Hdf5Handle();
    Hdf5Handle(Hdf5Handle&& other) noexcept;
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;

    operator hid_t() const { return id_; }
    /// Closes now; throws when what was still to be written could not be.
    void close();

private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

/// Throws Hdf5Error when the library reported a failure.
void checkHdf5(herr_t status);

/// The default access of a file, but closing it closes all that is in it, and a file system without locks is no
/// failure.
Hdf5Handle hdf5FileAccess();

Hdf5Handle createHdf5Group(hid_t parent, const std::string& name); // keeps the order of creation
Hdf5Handle openHdf5Group(hid_t parent, const std::string& name);
Hdf5Handle openHdf5Dataset(hid_t parent, const std::string& name);

/// UTF-8 of any length.
Hdf5Handle hdf5TextType();

void writeHdf5Attribute(hid_t object, const std::string& name, const std::string& value);
void writeHdf5Attribute(hid_t object, const std::string& name, double value);
void writeHdf5Attribute(hid_t object, const std::string& name, std::int64_t value);
/// "" if there is no such text.
std::string readHdf5Attribute(hid_t object, const std::string& name);

Hdf5Handle writeHdf5Scalar(hid_t parent, const std::string& name, const std::string& value);
Hdf5Handle writeHdf5Scalar(hid_t parent, const std::string& name, double value);
Hdf5Handle writeHdf5Scalar(hid_t parent, const std::string& name, std::int64_t value);
std::string readHdf5Text(hid_t parent, const std::string& name);

Hdf5Handle writeHdf5Array(hid_t parent, const std::string& name, std::span<const double> values);
Hdf5Handle writeHdf5Array(hid_t parent, const std::string& name, const std::vector<std::string>& values);

/// What is in a group, in the order of creation where that was kept.
std::vector<std::string> namesInHdf5Group(hid_t group);

/// Unit and name for a person, on every array.
void describeHdf5(hid_t dataset, const std::string& unit, const std::string& longName);

} // namespace touchdown
