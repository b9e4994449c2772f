// SPDX-License-Identifier: GPL-3.0-or-later
//
// Multigrid for linear convection and diffusion on cells, with alternating-direction line sweeps (Brandt 1977;
// Wesseling 1992): the preconditioner of the film's linear systems. Two cells along each axis make one of the next
// coarser level. The conductance of a coarse face is that of the fine paths it replaces, in series along and in
// parallel across. Its convection is the sum over the fine faces. The exponential scheme combines the two, so coarse
// levels are monotone at any Peclet number.
//
// Unknowns may be complex (films that oscillate); then the diagonal is complex too. Numbers are stored in single
// precision, which is enough for a preconditioner and halves the memory traffic; a power of two keeps the operator
// within its range.
//
// A cycle may also end, on the finest level, with a sweep of an operator of nine points, as that of the complete flux
// scheme. The operator of the faces alone leaves out how the flow along one axis depends on that along the other; with
// it about three times as many cycles are needed. Coarser levels know the faces alone.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "core/numerics/padded_grid.h"

namespace touchdown {

/// Flow through a face: F = c (v1 + v2)/2 - E (v2 - v1); padded arrays by face [any one unit].
struct FaceOperator {
    std::span<const double> diffusion;  // K = E without convection, >= 0
    std::span<const double> effective;  // E >= |c|/2
    std::span<const double> convection; // c
};

/// An operator on a cell and its eight neighbours: out = (sum - those beside) v + beside v_beside; padded arrays.
struct NinePoints {
    std::array<std::span<const float>, 8> beside; // from south west to north east, row by row
    std::span<const float> sum;                   // of the nine
};

/// Types in which multigrid stores numbers, and those of them that are always real.
template <typename T>
struct MultigridNumbers {
    using Number = float;
    using Real = float;
};
template <>
struct MultigridNumbers<std::complex<double>> {
    using Number = std::complex<float>;
    using Real = float;
};

template <typename T>
class Multigrid {
public:
    /// Allocates for grids of this size.
    explicit Multigrid(const PaddedGrid& pad);

    /// The operator: flows through faces, plus `diagonal` per cell (padded; may be empty for none).
    void setOperator(const std::array<FaceOperator, 2>& faces, std::span<const T> diagonal);
    /// Until the next setOperator, which is to be called before and sets the scale, precondition() ends with a sweep of
    /// this operator, or of its transpose, plus `diagonal`, plus `rate` times another operator where there is one. The
    /// first call allocates.
    void setFinest(const NinePoints& points, std::span<const T> diagonal, bool transposed = false,
                   const NinePoints& stored = {}, T rate = {});

    /// Until the next setOperator: the factors of solveFactors() and halfCycle(), which need them, with which full
    /// cycles on more than one level begin, too. `faces` and `diagonal`, not empty, are those of setOperator, which is
    /// to be called before; the faces pass on some of what cells store, `flows` do not. The first call allocates.
    void setFactors(const std::array<FaceOperator, 2>& faces, const std::array<FaceOperator, 2>& flows,
                    std::span<const T> diagonal);

    /// Allocates what setFinest() and setFactors() need; else their first call does.
    void reserve()
    {
        reserveNine();
        reserveFactors();
    }

    /// v = approximately A^-1 b by one V cycle from zero; padded, zero rings.
    void precondition(std::span<const T> b, std::span<T> v);
    /// v = approximately A^-1 b by factors: with A = D + X + Y, D what the cells store, or what flows out of them where
    /// that is more, X along x, Y along y, v = (D + Y)^-1 D (D + X)^-1 b (Beam & Warming 1976). Good where D dominates;
    /// a third of the work of a sweep. v has zero rings.
    void solveFactors(std::span<const T> b, std::span<T> v);
    /// v = approximately A^-1 b by these factors, then by the coarser levels.
    void halfCycle(std::span<const T> b, std::span<T> v);

private:
    using Number = typename MultigridNumbers<T>::Number;
    using Real = typename MultigridNumbers<T>::Real;

    struct Level {
        PaddedGrid pad;
        std::vector<Real> west, east, south, north; // of the stencil, <= 0
        std::vector<Number> centre;
        std::array<std::vector<Number>, 2> pivot; // 1/pivot of the lines along x, along y
        std::vector<Number> value, right;
    };
    /// The operator from which a level's stencil is computed; of the finest level, the caller's.
    struct Source {
        std::array<FaceOperator, 2> faces;
        std::span<const T> mass; // extra diagonal; may be empty
    };
    struct CoarseSource {
        std::array<std::vector<double>, 2> diffusion, effective, convection;
        std::vector<T> mass;
    };

    void setStencil(Level& level, const Source& source);
    /// Of the lines along x, along y; factored, they may lie where the centres were.
    using Centres = std::array<std::span<const Number>, 2>;
    template <typename Beside>
    static void factor(const PaddedGrid& pad, const std::vector<Beside>& west, const std::vector<Beside>& east,
                       const std::vector<Beside>& south, const std::vector<Beside>& north, const Centres& centre,
                       std::array<std::vector<Number>, 2>& pivot);
    static void coarsen(const PaddedGrid& from, const Source& fine, const PaddedGrid& to, CoarseSource& coarse);
    /// b, scaled as the operator, into the finest level.
    void take(std::span<const T> b);
    void give(std::span<T> v) const;
    /// Work space of a thread.
    Number* rowsOf(int thread);
    /// Least number of lines of a block; all of them where there is not as much work space as threads.
    int least(int count, int lines) const;
    template <typename Solve>
    void forLines(const PaddedGrid& pad, int colour, const Solve& solve);
    void solveByFactors();
    void sweepX(Level& level, int colour);
    void sweepY(Level& level, int colour);
    void sweep(Level& level);
    /// The coefficients of the eight neighbours, from a cell on.
    std::array<const Number*, 8> besideAt(std::size_t at) const;
    void reserveNine();
    void reserveFactors();
    void sweepNineX(int colour);
    void sweepNineY(int colour);
    void restrictResidual(const Level& fine, Level& coarse);
    void prolong(const Level& coarse, Level& fine);
    void cycle(std::size_t l);

    std::vector<Level> levels_;
    std::vector<CoarseSource> sources_; // of the levels but the finest
    struct Factors {
        std::vector<Number> south, north;         // of the lines along y, times 1/pivot
        std::vector<Number> centre;               // D, times 1/pivot
        std::array<std::vector<Number>, 2> pivot; // 1/pivot of the lines along x, along y
    };
    Factors factors_;
    /// The operator of nine points, scaled.
    struct Nine {
        std::array<std::vector<Number>, 8> beside;
        std::vector<Number> centre;
        std::array<std::vector<Number>, 2> pivot; // 1/pivot of the lines along x, along y
        std::array<std::vector<double>, 2> own;   // of a row, of both operators, by thread
    };
    Nine nine_;
    bool hasNine_ = false, hasFactors_ = false;
    double scale_ = 1.0; // of the operator
    std::vector<T> noMass_;
    int threads_ = 1;
    std::vector<Number> rows_; // work space: a few rows with rings, by thread
};

} // namespace touchdown
