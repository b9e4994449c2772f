// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider on a linear film that bounces (bouncing_slider.h), exactly within each region of the contact
// (core/simulation/flight/motion_in_pieces.h). The film stays linear about the static state of one case, while contact,
// load, suspension and mass may change; displacements count from there. The error that is stated is that of the linear
// film, as estimated, and with measurements also the largest difference between the separation and the minimum spacing
// along the cycle, of half the swing.
//
// x is the state without the corner that the separation depends on most.
#pragma once

#include <memory>

#include "core/simulation/flight/motion_in_pieces.h"
#include "core/studies/cycles/bouncing_slider.h"

namespace touchdown {

/// Why a case of model "film" cannot be taken, in half a sentence; "" where it can.
std::string reasonAgainstBouncingFilm(const Case& c);

class BouncingFilm final : public BouncingSlider {
public:
    /// `units` of a state, of unitsOf() one of the films.
    BouncingFilm(std::shared_ptr<const FilmInPieces> film, const Case& c, int start, Eigen::VectorXd units);
    static Eigen::VectorXd unitsOf(const FilmInPieces& film);

    Return apply(const Eigen::VectorXd& x, const ReturnRequest& request) const override;
    LongMotion run(const std::optional<Eigen::VectorXd>& from, double duration, double tolerance,
                   BouncingWatch& watch) const override;
    double startHeight() const override;
    double shortestPeriod() const override { return shortestPeriod_; }
    double cycleWork() const override { return cycleWork_; }
    std::string nameOf(const CycleSwitch& of) const override;

    /// x of a state on the section.
    Eigen::VectorXd coordinates(const Eigen::VectorXd& y) const;
    /// The state on the section.
    Eigen::VectorXd state(const Eigen::VectorXd& x) const;

private:
    class Way;

    std::shared_ptr<const FilmInPieces> film_;
    Eigen::VectorXd units_;       // of y
    Eigen::Index held_ = 0;       // the corner that x leaves out
    double touchDown_, limit_;    // d_s [m]; film.linear_limit
    double cycleWork_;            // [J]
    double shortestPeriod_ = 0.0; // [s]
    Eigen::VectorXd start_;       // y
    std::size_t startRegion_ = 0;
};

/// The sliders of a study, whose film is made with the first of them.
SliderOf filmsLike(const Case& c);

} // namespace touchdown
