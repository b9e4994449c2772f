// SPDX-License-Identifier: GPL-3.0-or-later
//
// A group of an HDF5 file, or the file itself: what is put into it, with unit and name for a person, and what is read
// from it. A path may stand for a name: "summary/tail/pitch". Each function throws Hdf5Error. Hold a Hdf5Access around
// them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/hdf5_dataset.h"

namespace touchdown {

/// Of a growing column, which are compressed together: 64 KiB. A reader of a short window unpacks little, and half a
/// chunk, rewritten at a flush, costs little.
inline constexpr std::size_t numbersPerChunk = 8192;

class Hdf5Group : public Hdf5Object {
public:
    using Hdf5Object::Hdf5Object;

    Hdf5Group create(const std::string& name) const; // keeps the order of creation
    Hdf5Group group(const std::string& name) const;
    Hdf5Dataset get(const std::string& name) const;
    bool has(const std::string& name) const;
    void remove(const std::string& name) const;
    /// In the order of creation where that was kept.
    std::vector<std::string> names() const;

    Hdf5Dataset put(const std::string& name, double value) const;
    Hdf5Dataset put(const std::string& name, std::int64_t value) const;
    Hdf5Dataset put(const std::string& name, std::string_view text) const;
    Hdf5Dataset put(const std::string& name, std::span<const double> values) const;
    Hdf5Dataset put(const std::string& name, const std::vector<std::int64_t>& values) const;
    Hdf5Dataset put(const std::string& name, const std::vector<std::string>& texts) const;
    template <class Value>
    Hdf5Dataset put(const std::string& name, const Value& value, const std::string& unit,
                    const std::string& longName) const
    {
        Hdf5Dataset dataset = put(name, value);
        dataset.describe(unit, longName);
        return dataset;
    }
    /// rows x columns numbers, row by row; compressed in one piece.
    Hdf5Dataset table(const std::string& name, hsize_t rows, hsize_t columns, const double* values,
                      const std::string& unit, const std::string& longName) const;
    /// A growing array without entries. An entry is a number, or has the given shape; a chunk then holds whole rows of
    /// one entry.
    Hdf5Dataset growing(const std::string& name, const std::string& unit, const std::string& longName,
                        const std::vector<hsize_t>& entry = {}) const;
};

} // namespace touchdown
