// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider on a film that is linear about a static state over a flat disk, without contact or under Ono and Yamane's,
// which is linear in pieces. With displacements u of the corners (q = q_0 + S u), their rates w, and z_k = |p_k| x_k of
// each pole of the film (film_fit.h):
//
//   u' = w,   M S w' = F(q_0) - (D + K + K_contact) S u - C S w - sum_k R_k S z_k/|p_k|
//   z_k' = p_k z_k + |p_k| u
//
// Within a region of the contact all is linear, y' = A y + b. The separation of the pad is that of its tangent at the
// static state: the bearing place stays as it is there.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include <Eigen/Core>

#include "core/numerics/interval.h"
#include "core/numerics/small_matrix.h"
#include "core/physics/contact/ono_yamane.h"

namespace touchdown {

class FilmScene;
struct Case;

class FilmInPieces {
public:
    /// The case over a flat disk, at rest, with a linear film: whose scene is to be prepared.
    static Case stillCase(Case c);
    /// Of a scene that is ready, and the case with which it was prepared. Throws std::runtime_error, a sentence.
    FilmInPieces(const FilmScene& scene, const Case& still);

    /// A region of the contact with its law, all in the state's units.
    struct Region {
        ContactRegion name = ContactRegion::Apart;
        bool presses = false;              // real contact
        Interval interval;                 // of the separation [m]
        std::size_t below = 0, above = 0;  // regions beyond its ends
        Eigen::MatrixXd a;                 // A
        Eigen::VectorXd b, shift;          // b, -A^-1 b
        Eigen::VectorXcd rates;            // L of A V = V L [1/s]
        Eigen::MatrixXcd vectors, inverse; // V, V^-1
    };
    /// row . y + constant
    struct Reading {
        Eigen::RowVectorXd row;
        double constant = 0.0;
    };

    Eigen::Index positions() const { return positions_; }
    Eigen::Index size() const { return size_; } // of a state
    /// By which rates are multiplied in a state, so that its parts are alike in size [s].
    static constexpr double rateUnit = 1e-6;
    const std::vector<Region>& regions() const { return regions_; }
    /// Where this law, or the one that it is part of, stands in regions().
    std::size_t placeOf(ContactRegion region) const { return places_[static_cast<std::size_t>(region)]; }
    /// That of the static state.
    std::size_t atRest() const { return atRest_; }
    const Reading& separation() const { return separation_; }
    /// Of slope . (q - q_0) + constant.
    Reading reading(const Vector3& slope, double constant) const;
    const Vector3& place() const { return place_; } // q_0
    const Vector3& scale() const { return scale_; } // S
    /// By which a force is multiplied for its part of w' [m/s^2 per N, N m].
    const Vector3& toRate() const { return toRate_; }
    double restSpacing() const { return separation_.constant; } // [m]
    /// Against which a motion is small or large [m].
    double gap() const;
    double fastestRate() const { return fastest_; } // of an oscillation about the static state [1/s]
    /// As if the slider had long stood at these positions.
    Eigen::VectorXd settledAt(const Eigen::VectorXd& positions, const Eigen::VectorXd& rates) const;

private:
    Eigen::Index positions_ = 0, size_ = 0;
    Vector3 place_ = Vector3::Zero(), scale_ = Vector3::Zero(), toRate_ = Vector3::Zero();
    std::vector<std::complex<double>> poles_;
    std::vector<Region> regions_;
    std::array<std::size_t, 4> places_{};
    std::size_t atRest_ = 0;
    double fastest_ = 0.0;
    Reading separation_;
};

} // namespace touchdown
