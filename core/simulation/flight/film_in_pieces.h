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
//
// Contact, load, suspension and mass may be those of another case than that of the static state: the slider then moves
// about another place, on the same film.
#pragma once

#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/numerics/interval.h"
#include "core/numerics/small_matrix.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/physics/slider/air_bearing_surface.h"
#include "core/physics/slider/minimum_spacing.h"

namespace touchdown {

class FilmScene;
class SliderBody;
struct FilmFit;
struct Case;

class FilmInPieces {
public:
    /// The case over a flat disk, at rest, with a linear film: whose scene is to be prepared.
    static Case stillCase(Case c);
    /// Of a scene that is ready, and the case with which it was prepared. Throws std::runtime_error, a sentence.
    FilmInPieces(const FilmScene& scene, const Case& still) : FilmInPieces(scene, still, still, nullptr) {}
    /// The same for a case with the same film apart from contact and load (sameFilmApart). `known`: of the scene;
    /// whose solved parts are taken where they are equal.
    FilmInPieces(const FilmScene& scene, const Case& still, const Case& c, const FilmInPieces* known);

    /// On the corners, at the separation of the static state, and its slope by the separation [N], [N/m].
    struct Force {
        Eigen::VectorXd atRest, slope;
    };
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
        Force contact, friction;           // contact and adhesion; friction
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
    /// Where it stands in regions(); without contact all are one.
    std::size_t placeOf(ContactRegion region) const
    {
        return regions_.size() > 1 ? static_cast<std::size_t>(region) : 0;
    }
    /// That of the static state.
    std::size_t atRest() const { return atRest_; }
    const Reading& separation() const { return separation_; }
    /// Of slope . (q - q_0) + constant.
    Reading reading(const Vector3& slope, double constant) const;
    const Reading& flyingHeight() const { return flyingHeight_; }
    /// Of the first point of interest, or of the trailing edge's centre where there is none [m].
    static SurfacePoint pointOf(const Case& c);
    const Vector3& place() const { return place_; } // q_0
    const Vector3& scale() const { return scale_; } // S
    /// By which a force is multiplied for its part of w' [m/s^2 per N, N m].
    const Vector3& toRate() const { return toRate_; }
    double restSpacing() const { return separation_.constant; } // [m]
    /// Against which a motion is small or large [m].
    double gap() const;
    double fastestRate() const { return fastest_; } // of an oscillation about the static state [1/s]
    /// Of the slider's vibrations about the static state with a damping ratio below 0.2, rising [Hz].
    std::vector<double> frequencies() const;
    /// With these positions of a state.
    Attitude attitude(const Eigen::VectorXd& positions) const;
    const MinimumSpacing& minimumSpacing() const { return *minimumSpacing_; }
    /// Forces of film and suspension on the corners, by the state; without what is constant [N].
    const Eigen::MatrixXd& filmForce() const { return filmForce_; }
    const Eigen::MatrixXd& suspensionForce() const { return suspensionForce_; }
    /// Positions and rates at the start of a case [m], [m/s].
    std::pair<Eigen::VectorXd, Eigen::VectorXd> startOf(const Case& c) const;
    /// The region of a state that has come from another one.
    std::size_t regionFrom(std::size_t before, const Eigen::VectorXd& y) const;
    /// As if the slider had long stood at these positions.
    Eigen::VectorXd settledAt(const Eigen::VectorXd& positions, const Eigen::VectorXd& rates) const;

private:
    /// The first of so many regions that moves by this matrix; null: none.
    const Region* find(const Eigen::MatrixXd& a, std::size_t count = 4) const;
    Eigen::MatrixXd scaled(const Matrix3& matrix) const;
    void setFlight(const FilmFit& fit, const SliderBody& body);
    Region& add(ContactRegion name, const Matrix3& stiffness, const Vector3& force, const FilmInPieces* known);
    /// `more`: force of the suspension at q_0 beyond that of the static state's case [N], [N m].
    void setRegions(const FilmScene& scene, const Case& still, const Case& c, const Vector3& more,
                    const FilmInPieces* known);

    Eigen::Index positions_ = 0, size_ = 0;
    Vector3 place_ = Vector3::Zero(), scale_ = Vector3::Zero(), toRate_ = Vector3::Zero();
    std::vector<std::complex<double>> poles_;
    std::vector<Region> regions_;
    std::size_t atRest_ = 0;
    double fastest_ = 0.0;
    SurfacePoint nearest_;                   // where the slider is nearest at rest, and the pad bears
    Vector3 bySeparation_ = Vector3::Zero(); // d(separation)/dq
    Reading separation_, flyingHeight_;
    std::shared_ptr<const MinimumSpacing> minimumSpacing_;
    double length_ = 0.0;    // of the slider [m]
    Eigen::MatrixXd flight_; // A without contact
    Eigen::MatrixXd filmForce_, suspensionForce_;
};

} // namespace touchdown
