// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that are tied in pairs by equations a = b + c or a = -b + c. They are kept as trees: each number is its root,
// or minus its root, plus an offset (union by size). So a system of n equations is solved in n log n steps without
// rounding of a matrix, and an equation that contradicts those before it is found at once.
#pragma once

#include <optional>
#include <vector>

namespace touchdown {

class TiedNumbers {
public:
    explicit TiedNumbers(std::size_t count);

    /// number = sign * other + offset, with a sign of 1 or -1. An equation that contradicts those before it by more
    /// than `reach` is not taken; the return value is by how much, else 0.
    double tie(std::size_t number, double sign, std::size_t other, double offset);
    double fix(std::size_t number, double value);
    /// Nothing where the equations leave it free.
    std::optional<double> value(std::size_t number) const;

    static constexpr double reach = 3e-15; // below it numbers are the same [m]

private:
    struct Link {
        std::size_t parent = 0, size = 1;
        double sign = 1.0, offset = 0.0; // number = sign * parent + offset
        std::optional<double> value;     // of a root
    };
    struct Root {
        std::size_t at;
        double sign, offset;
    };
    Root rootOf(std::size_t number) const;
    double fixRoot(std::size_t root, double value);

    std::vector<Link> links_;
};

} // namespace touchdown
