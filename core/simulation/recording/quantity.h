// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run records: named columns with units, in batches.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

struct Quantity {
    std::string name;        // "flying_height"
    std::string unit;        // SI, "m"
    std::string displayUnit; // "nm"
    std::string longName;    // "Real contact force"
    bool operator==(const Quantity&) const = default;
};

/// A quantity with its value in a state, so that names and columns cannot disagree.
template <class State>
struct RecordedQuantity {
    Quantity quantity;
    double (*value)(const State&);
};

template <class State>
std::vector<Quantity> quantitiesOf(const std::vector<RecordedQuantity<State>>& rows)
{
    std::vector<Quantity> list;
    for (const auto& row : rows) list.push_back(row.quantity);
    return list;
}

template <class State>
void evaluate(const std::vector<RecordedQuantity<State>>& rows, const State& state, double* values)
{
    for (const auto& row : rows) *values++ = row.value(state);
}

/// Samples in the order of time; columns[i][k] is quantity i at time[k], in SI. Always finite.
struct SampleBatch {
    std::vector<double> time; // [s]
    std::vector<std::vector<double>> columns;

    std::size_t size() const { return time.size(); }
};

/// The column of a quantity; -1 if there is none.
inline int findQuantity(const std::vector<Quantity>& quantities, std::string_view name)
{
    for (std::size_t i = 0; i < quantities.size(); ++i)
        if (quantities[i].name == name) return static_cast<int>(i);
    return -1;
}

} // namespace touchdown
