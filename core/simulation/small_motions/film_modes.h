// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small motions of a slider on its film about the static state: the s for which (s^2 M + s C + K + Z(s)) q = 0 has a
// solution q = (height of the mass centre, pitch, roll), with M, C, K of slider and suspension and Z of the film; and
// what it answers to a wave of the disk's surface that runs through under it.
//
// For a trial s the film is written as Z = K_f + s C_f with real K_f, C_f; the eigenvalue of that quadratic problem
// next to s is the next trial. Where it stays, the equation holds exactly. The eigenvalue that stands for a mode
// already found is left out, else two trials may end at one mode.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <functional>
#include <memory>
#include <vector>

#include "core/physics/film/film_oscillation.h"
#include "core/simulation/static_state/disk_under_film.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// Neither copied nor moved: its parts point at each other.
class FilmModes {
public:
    using Complex = std::complex<double>;

    /// About a static state of the case; both must last.
    FilmModes(const Case& c, const SteadyResult& state);
    FilmModes(const FilmModes&) = delete;

    /// Asks within the solution of a linear system, too, whether to go on; where it says false what comes of it has no
    /// meaning.
    void ask(std::function<bool()> goOn) { oscillation_->ask(std::move(goOn)); }

    struct Film {
        Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero(); // K_f [N/m ...]
        Eigen::Matrix3d damping = Eigen::Matrix3d::Zero();   // C_f [N s/m ...]
    };
    /// About the mass centre; s must not be real.
    Film film(Complex s);

    struct Mode {
        Complex rate;           // s [1/s]
        Eigen::Vector3cd shape; // of q, in any scale
        Film film;              // Z(s) = K_f + s C_f there
    };
    /// By frequency; fewer than there are degrees of freedom where one does not oscillate or could not be followed.
    /// `goOn` is told how many are found, and ends the search by returning false. `tolerance`: of s [-].
    std::vector<Mode> find(const std::function<bool(std::size_t)>& goOn = {}, double tolerance = 1e-9);

    /// D(s) = s^2 M + s C + K + Z(s) [N/m ...] with what film(s) was.
    Eigen::Matrix3cd dynamic(Complex s, const Film& at) const;
    /// D'(s) with Z'(s) from another rate near to it; `near` is film(s).
    Eigen::Matrix3cd dynamicSlope(Complex s, const Film& near);
    /// Load and torques about the mass centre that a surface w e^(s t) under a slider at rest makes as e^(s t), w = w'
    /// + i w'': heights over the film's cells (padded) [m], whose effect is linear in them. Of the film alone, without
    /// contact. `present`, real, is what of s w was there when the film began, its pressure that of the flat disk; may
    /// be empty.
    Eigen::Vector3cd force(Complex s, std::span<const double> real, std::span<const double> imaginary,
                           std::span<const double> present = {});
    /// Displacements of the corners [m], and rotations that make them: what scales q.
    Eigen::Vector3d scale() const { return {1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width}; }
    const Eigen::Matrix3d& mass() const { return mass_; }

    /// Whether the film was solved at the last s.
    bool converged() const { return converged_; }
    const CellGrid& grid() const { return level_.gaps.grid; }
    const PaddedGrid& pad() const { return level_.gaps.pad; }
    const MinimumSpacing& spacing() const { return spacing_; }

private:
    static constexpr double perRate = 1e-6; // [s]

    struct Eigen6 {
        Eigen::VectorXcd values;
        Eigen::MatrixXcd vectors;
    };
    Eigen6 eigenvalues(const Film& film) const;
    static std::vector<Eigen::Index>::const_iterator nearest(const Eigen6& eigen,
                                                             const std::vector<Eigen::Index>& among, Complex s);
    static std::vector<Eigen::Index> unknown(const Eigen6& eigen, const std::vector<Mode>& known);
    bool follow(Mode& mode, const std::vector<Mode>& known, double tolerance);

    /// What the film's residual and its forces at constant pressure answer to a small change of the surface.
    struct SurfaceAnswer {
        std::vector<double> flow, storage; // dR [Pa m^3/s], d^2R/dperTime [Pa m^3]; padded
        Vector3 force{};                   // about the slider's centre [N], [N m]
    };
    SurfaceAnswer surfaceAnswer(std::span<const double> height);
    Vector3 forces();

    const Case& case_;
    const SteadyResult& state_;
    Recess recess_;
    MinimumSpacing spacing_;
    FilmLevel level_;
    std::unique_ptr<FilmOscillation> oscillation_;
    std::array<std::vector<double>, 3> byPressure_;
    std::array<std::array<double, 3>, 3> byAttitude_{};
    double shearArm_;
    Eigen::Matrix3d mass_, springs_, dampers_;
    bool converged_ = true;
};

} // namespace touchdown
