// SPDX-License-Identifier: GPL-3.0-or-later
//
// A static film computed as the established program computes it (its published source, CMLAir), in code of its own, so
// that its errors can be compared with those of gas_film.h. It also checks that film: it shares no face, no gap and no
// quadrature with it, only slip, recess and linear algebra.
//
// Pressures are defined on nodes at the crossings of lines, those on the outline are p0; faces stand halfway between
// lines. A face depends on the recess on its own line only, not on the recess before or behind it:
//
//   conductance  K = width <h^3 p Q>/(12 mu length), the mean of two gaps, one over the deepest and one over the
//                shallowest recess on the face, weighted so that their mean is the mean recess; p the mean of the two
//                nodes
//   convection   c = (U/2) width h, h over the mean recess, U at the face
//   both         F = c (p1 + p2)/2 - E(K, c) (p2 - p1), Patankar's power law
//   load         each node's pressure above ambient times its control volume (reported in gram-force of 9.81 mN), and
//                its torques about the slider's centre
//
// The scheme is consistent, but of first order: no face resolves an edge between two nodes, which may lie half a
// spacing nearer or farther.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/numerics/cell_grid.h"
#include "core/physics/film/gas_film.h"
#include "core/physics/slider/attitude.h"
#include "core/physics/slider/recess.h"

namespace touchdown {

/// How the recess along a face enters its conductance.
enum class FaceGaps : std::uint8_t {
    TwoOfSamples, // deepest and shallowest of 10 samples on faces across x, 20 across y: the established program
    Two,          // deepest and shallowest of the whole face
    All,          // each its share
};

struct NodeFilmResult {
    double load = 0.0;                          // [N]
    double pitchTorque = 0.0, rollTorque = 0.0; // positive nose up and inner edge up [N m]
    double residual = 0.0; // sum of the control volumes' |net outflow|, against the flow through the film [-]
    bool converged = false;
};

class NodeFilm {
public:
    /// `nodes`: the lines whose crossings they are. The setting's scheme is the power law, else the exponential one
    /// counts.
    NodeFilm(const Recess& recess, const FilmSetting& setting, const CellGrid& nodes, FaceGaps gaps);
    ~NodeFilm();

    /// From the pressures of the last solution, at first from ambient pressure. `goOn` is asked at each iteration;
    /// where it returns false, or where Newton's method does not converge, the result is not converged and its load
    /// has no meaning.
    NodeFilmResult solve(const Attitude& attitude, const std::function<bool()>& goOn = {});

private:
    class Solver;
    std::unique_ptr<Solver> solver_;
};

} // namespace touchdown
