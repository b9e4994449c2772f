// SPDX-License-Identifier: GPL-3.0-or-later
//
// HDF5 with owned identifiers, failures as exceptions with a readable cause, and one thread at a time:
// Debian's library is not thread-safe.
#pragma once

#include <mutex>
#include <stdexcept>

#include <hdf5.h>

namespace touchdown {

/// What the library could not do, in words that a person can act on ("No space left on device").
class Hdf5Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Hold one around every use: it locks the library, which prints no errors of its own meanwhile.
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

} // namespace touchdown
