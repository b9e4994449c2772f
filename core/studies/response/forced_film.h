// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider on a film that is linear about the static state, over one wave of the disk (forced_motion.h); time is
// counted by the disk under the first point of interest, without one under the trailing edge's centre. With
// displacements u of the corners (q = q_0 + S u), their rates w, and z_k = |p_k| x_k of each pole of the film
// (film_fit.h):
//
//   u' = w,   M S w' = F(q_0) - (D + K + K_contact) S u - C S w - sum_k R_k S z_k/|p_k| + Re f e^(i omega t)
//   z_k' = p_k z_k + |p_k| u
//
// Within a region of Ono and Yamane's characteristic all is linear, y' = A y + b + Re g e^(i omega t), so that
//
//   y = Re Y e^(i omega t) - A^-1 b + V e^(L t) c,   A V = V L
//
// is exact at any time. The separation of the pad is that of its tangent at the static state. The contact does not see
// the waves, as in a run. The force f of the film's waves is found at the frequencies of a study and between them where
// these are far apart, and interpolated by polynomials of degree five.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/numerics/interval.h"
#include "core/numerics/small_matrix.h"
#include "core/simulation/recording/quantity.h"
#include "core/studies/response/forced_motion.h"

namespace touchdown {

/// The quantities of a run whose harmonic can be taken.
std::vector<Quantity> quantitiesOfForcedFilm(const Case& c);
/// Why a case of model "film" cannot be taken, in half a sentence; "" where it can.
std::string reasonAgainstForcedFilm(const Case& c);

/// What is the same at all frequencies. Constant once it is made.
class FilmUnderWaves {
public:
    /// `frequencies`: rising, at least one [Hz]; `beat`: between two at which as many waves more are under the slider
    /// [Hz]. `goOn` is told which share is done; false ends it, and the result is null. Throws std::runtime_error, a
    /// sentence.
    static std::shared_ptr<const FilmUnderWaves> make(const Case& c, const std::string& quantity, double amplitude,
                                                      std::span<const double> frequencies, double beat,
                                                      const std::function<bool(double share)>& goOn);

    /// A region of the contact with its law, all in the state's units.
    struct Region {
        ContactRegion name = ContactRegion::Apart;
        bool presses = false;              // real contact
        Interval interval;                 // of the separation [m]
        std::size_t below = 0, above = 0;  // regions beyond its ends
        Eigen::MatrixXd a;                 // A
        Eigen::VectorXd b, shift;          // b, -A^-1 b
        Eigen::VectorXcd rates;            // L [1/s]
        Eigen::MatrixXcd vectors, inverse; // V, V^-1
    };
    /// row . y + constant + Re(disk a e^(i omega t)), with the wave a sin(omega t).
    struct Reading {
        Eigen::RowVectorXd row;
        double constant = 0.0;
        std::complex<double> disk;
    };

    Eigen::Index positions() const { return positions_; }
    double amplitude() const { return amplitude_; } // of the wave [m]
    /// f, in rows of w' times rateUnit.
    Eigen::VectorXcd forceAt(double frequency) const;
    /// By which rates are multiplied in a state, so that its parts are alike in size [s].
    static constexpr double rateUnit = 1e-6;
    const std::vector<Region>& regions() const { return regions_; }
    /// Where this law, or the one that it is part of, stands in regions().
    std::size_t placeOf(ContactRegion region) const { return places_[static_cast<std::size_t>(region)]; }
    /// That of the static state.
    std::size_t atRest() const { return atRest_; }
    const Reading& separation() const { return separation_; }
    const Reading& quantity() const { return quantity_; }
    double restSpacing() const { return separation_.constant; } // [m]
    /// Against which a motion is small or large [m].
    double gap() const;
    double fastestRate() const { return fastest_; } // of an oscillation about the static state [1/s]
    double linearLimit() const { return limit_; }
    const ForcedState& start() const { return start_; }
    /// As if the slider had long stood at these positions.
    Eigen::VectorXd settledAt(const Eigen::VectorXd& positions, const Eigen::VectorXd& rates) const;

private:
    FilmUnderWaves() = default;
    struct Made;
    void setRegions(Made& made);
    /// False where it is stopped.
    bool setForces(Made& made, std::span<const double> frequencies, double beat,
                   const std::function<bool(double)>& goOn);
    Reading readingOf(const Made& made, const Vector3& slope, double constant) const;

    Eigen::Index positions_ = 0, size_ = 0;
    double amplitude_ = 0.0, fastest_ = 0.0, limit_ = 0.0;
    std::vector<std::complex<double>> poles_;
    std::vector<Region> regions_;
    std::array<std::size_t, 4> places_{};
    std::size_t atRest_ = 0;
    Reading separation_, quantity_;
    ForcedState start_;
    std::vector<double> nodes_;            // [Hz]
    std::vector<Eigen::VectorXcd> forces_; // at the nodes
};

class ForcedFilm final : public ForcedSlider {
public:
    ForcedFilm(std::shared_ptr<const FilmUnderWaves> film, double frequency);

    double frequency() const override { return frequency_; }
    double waveAmplitude() const override { return film_->amplitude(); }
    double stepError(bool rough) const override;
    Eigen::VectorXd units(const Eigen::VectorXd& swing) const override;
    Eigen::Index positions() const override { return film_->positions(); }
    ForcedState start() const override { return continued(film_->start()); }
    ForcedState moved(const Eigen::VectorXd& direction, double size) const override;
    ForcedState lowered(double distance) const override;
    ForcedState continued(const ForcedState& before) const override;
    ForcedPeriods run(const ForcedState& start, const ForcedRequest& request) const override;
    std::optional<std::complex<double>> linear() const override;

private:
    class Way;
    std::shared_ptr<const FilmUnderWaves> film_;
    double frequency_;                      // [Hz]
    Eigen::VectorXcd force_;                // g
    std::vector<Eigen::VectorXcd> answers_; // Y, by region
};

} // namespace touchdown
