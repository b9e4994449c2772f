// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a file holds: objects with attributes, and arrays of numbers or texts. A growing array is float64, chunked,
// unlimited in its first dimension, shuffled and deflated. Each function throws Hdf5Error. Hold a Hdf5Access around
// them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/hdf5_access.h"

namespace touchdown {

/// UTF-8 of any length.
Hdf5Handle hdf5TextType();

/// An object with attributes. An attribute that is set again takes the new value.
class Hdf5Object : public Hdf5Handle {
public:
    using Hdf5Handle::Hdf5Handle;

    void set(const std::string& name, std::string_view text) const;
    void set(const std::string& name, double value) const;
    void set(const std::string& name, std::int64_t value) const;
    /// "" if there is no such text.
    std::string attribute(const std::string& name) const;
    /// NaN if there is no such number.
    double numberAttribute(const std::string& name) const;
    /// All numbers of an attribute; empty if there are none.
    std::vector<double> numberAttributes(const std::string& name) const;
};

class Hdf5Dataset : public Hdf5Object {
public:
    using Hdf5Object::Hdf5Object;

    /// Unit ("1" for an empty one) and name for a person.
    void describe(const std::string& unit, const std::string& longName) const;
    /// Makes this array the scale of a dimension.
    void makeScale(const std::string& name) const;
    void attachScale(const Hdf5Dataset& scale, unsigned dimension) const;

    std::vector<hsize_t> shape() const;
    std::string text() const;
    bool holdsTexts() const;
    /// The texts of an array with one dimension.
    std::vector<std::string> texts() const;
    /// Throws where a damaged header claims more numbers than are stored.
    void checkStored() const;
    /// All numbers, row by row, checked.
    std::vector<double> numbers() const;
    /// The numbers of an array with one dimension.
    std::vector<double> column() const;
    std::vector<std::int64_t> integers() const;

    /// Entries of a growing array: numbers of a column, or matrices.
    hsize_t length() const { return shape().front(); }
    void append(std::span<const double> values) const; // whole entries
    std::vector<double> entry(hsize_t index) const;
    /// Brings the array to the length of `from`, whose beginning it holds. Compressed chunks are copied as they are.
    void copyMissing(const Hdf5Dataset& from) const;
    /// Bytes in the file, compressed.
    hsize_t storedBytes() const { return H5Dget_storage_size(*this); }
};

/// Throws Hdf5Error where one of the numbers is NaN or infinite; `name` is theirs.
void checkFinite(std::span<const double> numbers, const std::string& name);

} // namespace touchdown
