// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider on a film that is linear about the static state, over one wave of the disk (forced_motion.h); time is
// counted by the disk under the first point of interest, without one under the trailing edge's centre. Its equations in
// pieces and their exact solution: core/simulation/flight/motion_in_pieces.h, driven by the force f of the film's
// waves. The contact does not see the waves, as in a run. f is found at the frequencies of a study and between them
// where these are far apart, and interpolated by polynomials of degree five.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/simulation/flight/motion_in_pieces.h"
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

    /// One of the film, and the disk's part: Re(disk a e^(i omega t)) with the wave a sin(omega t).
    struct Reading {
        FilmInPieces::Reading film;
        std::complex<double> disk;
    };

    const FilmInPieces& pieces() const { return *pieces_; }
    double amplitude() const { return amplitude_; } // of the wave [m]
    /// f, in rows of w' times FilmInPieces::rateUnit.
    Eigen::VectorXcd forceAt(double frequency) const;
    const Reading& quantity() const { return quantity_; }
    double linearLimit() const { return limit_; }
    const ForcedState& start() const { return start_; }

private:
    FilmUnderWaves() = default;
    struct Made;
    /// False where it is stopped.
    bool setForces(Made& made, std::span<const double> frequencies, double beat,
                   const std::function<bool(double)>& goOn);

    std::unique_ptr<const FilmInPieces> pieces_;
    double amplitude_ = 0.0, limit_ = 0.0;
    Reading quantity_;
    ForcedState start_;
    std::vector<double> nodes_;            // [Hz]
    std::vector<Eigen::VectorXcd> forces_; // at the nodes
};

class ForcedFilm final : public ForcedSlider {
public:
    ForcedFilm(std::shared_ptr<const FilmUnderWaves> film, double frequency);
    ForcedFilm(const ForcedFilm&) = delete;

    double frequency() const override { return frequency_; }
    double waveAmplitude() const override { return film_->amplitude(); }
    double stepError(bool rough) const override;
    Eigen::VectorXd units(const Eigen::VectorXd& swing) const override;
    Eigen::Index positions() const override { return film_->pieces().positions(); }
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
    std::vector<Eigen::VectorXcd> answers_; // of driving_
    Driving driving_;
};

} // namespace touchdown
