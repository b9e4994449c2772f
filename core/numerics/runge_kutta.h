// SPDX-License-Identifier: GPL-3.0-or-later
//
// Explicit Runge-Kutta methods as rows of their tableaux (autonomous systems, so without the nodes c).
//
//   rk4      classical, order 4 (Kutta 1901)            dopri5   order 5(4), seven stages, first same as last,
//     0                                                          dense output of order 4 (Dormand & Prince 1980;
//     1/2  1/2                                                   Hairer, Norsett & Wanner, Solving ODEs I, II.5, II.6)
//     1/2   0   1/2
//      1    0    0    1
//          1/6  1/3  1/3  1/6
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace touchdown {

template <std::size_t stages>
struct Tableau {
    std::array<std::array<double, stages>, stages> a{}; // [-]
    std::array<double, stages> b{};                     // weights of the result [-]
    std::array<double, stages> e{};                     // b minus the weights of the embedded result [-]
    std::array<double, stages> d{};                     // of the last term of the dense output [-]
};

inline constexpr Tableau<4> rk4Tableau{
    .a = {{{0, 0, 0, 0}, {1.0 / 2, 0, 0, 0}, {0, 1.0 / 2, 0, 0}, {0, 0, 1.0, 0}}},
    .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6},
};

inline constexpr Tableau<7> dopri5Tableau{
    .a = {{{0, 0, 0, 0, 0, 0, 0},
           {1.0 / 5, 0, 0, 0, 0, 0, 0},
           {3.0 / 40, 9.0 / 40, 0, 0, 0, 0, 0},
           {44.0 / 45, -56.0 / 15, 32.0 / 9, 0, 0, 0, 0},
           {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729, 0, 0, 0},
           {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656, 0, 0},
           {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0}}},
    .b = {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0},
    .e = {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40},
    .d = {-12715105075.0 / 11282082432.0, 0, 87487479700.0 / 32700410799.0, -10690763975.0 / 1880347072.0,
          701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0, 69997945.0 / 29380423.0},
};

/// Weights as constants of the program: a row of a tableau's a, or its b, e or d.
template <const auto& tableau, std::size_t row>
struct StageRow {
    static constexpr double at(std::size_t j) { return tableau.a[row][j]; }
};
template <const auto& tableau, auto member>
struct TableauRow {
    static constexpr double at(std::size_t j) { return (tableau.*member)[j]; }
};

/// h sum_j weight_j k[j] over the first `count` stages. The compiler leaves out the zeros, and h weight_j does not wait
/// for k[j].
template <class Of, std::size_t count, class State, std::size_t stages>
inline State combine(double h, const std::array<State, stages>& k)
{
    return [&]<std::size_t... j>(std::index_sequence<j...>)
    {
        State sum = State::Zero();
        (
            [&] {
                constexpr double weight = Of::at(j);
                if constexpr (weight != 0.0) sum += (h * weight) * k[j];
            }(),
            ...);
        return sum;
    }
    (std::make_index_sequence<count>{});
}

/// Stages 1 to last of a step of length h from y; k[0] must hold the derivative at y.
template <const auto& tableau, class State, std::size_t stages, class Derivative>
inline void evaluateStages(const State& y, double h, std::array<State, stages>& k, Derivative&& derivative)
{
    [&]<std::size_t... i>(std::index_sequence<i...>)
    {
        ((k[i + 1] = derivative(State(y + combine<StageRow<tableau, i + 1>, i + 1>(h, k)))), ...);
    }
    (std::make_index_sequence<stages - 1>{});
}

} // namespace touchdown
