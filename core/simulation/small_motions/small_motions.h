// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small motions q exp(s t) of a slider about an attitude at which its film is steady, q = (height of the mass centre,
// pitch, roll):
//
//   (s^2 M + s C + K + K_contact + Z(s)) q = 0
//
// M, C, K of slider and suspension, Z of the film with the torques of its shear. For a trial s the film is written as
// Z = K_f + s C_f with real K_f, C_f. With g(s) the eigenvalue of that quadratic problem nearest to s, g(s) = s is
// solved by secants. The eigenvalue nearest to each known mode is excluded, so that no two trials end at one mode. A
// held roll is no unknown.
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/numerics/small_matrix.h"

namespace touchdown {

class FilmOscillation;
class SliderBody;
struct Case;
struct CellGrid;
struct FilmLevel;
struct FilmSlopes;

class SmallMotions {
public:
    using Complex = std::complex<double>;

    /// The level's film is steady; level and body must last. `contact`: its stiffness about the mass centre. `slopes`:
    /// where the disk's surface follows the attitude.
    SmallMotions(FilmLevel& level, const SliderBody& body, const Matrix3& contact = Matrix3::Zero(),
                 const FilmSlopes* slopes = nullptr);
    ~SmallMotions();

    /// Also asked within the solution of a linear system; if it returns false the results are invalid.
    void ask(std::function<bool()> goOn);

    struct Film {
        Matrix3 stiffness = Matrix3::Zero(); // K_f [N/m ...]
        Matrix3 damping = Matrix3::Zero();   // C_f [N s/m ...]
    };
    /// About the mass centre; s must not be real.
    Film film(Complex s);

    struct Mode {
        Complex rate;         // s [1/s]
        ComplexVector3 shape; // of q, in any scale
        Film film{};          // Z(s) = K_f + s C_f there
    };
    /// Modes with a positive frequency, sorted by it; fewer than unknowns where one does not oscillate or was lost.
    /// `tolerance`: of s [-]. `goOn` receives the number found; false ends the search. `near`: rates of a nearby state.
    std::vector<Mode> find(double tolerance, const std::function<bool(std::size_t)>& goOn = {},
                           std::span<const Complex> near = {});

    /// D(s) = s^2 M + s C + K + K_contact + Z(s) [N/m ...]; `at` is film(s).
    ComplexMatrix3 dynamic(Complex s, const Film& at) const;
    /// D'(s) with Z'(s) from another rate near to it; `near` is film(s).
    ComplexMatrix3 dynamicSlope(Complex s, const Film& near);
    /// Load and torques of the film about the mass centre, times e^(s t), in response to a surface w e^(s t), w = w' +
    /// i w'', under a slider at rest; linear in w. Heights over the film's cells (padded) [m]. `present`, real, is the
    /// part of s w at the start, with the pressure of the flat disk; may be empty.
    ComplexVector3 force(Complex s, std::span<const double> real, std::span<const double> imaginary,
                         std::span<const double> present = {});

    /// Displacements of the corners [m], and rotations that make them: the scale of q.
    Vector3 scale() const;
    const Vector3& mass() const;
    /// Two without roll.
    Eigen::Index unknowns() const;
    /// Whether the film was solved at the last s.
    bool converged() const { return converged_; }

private:
    std::vector<Mode> trials(const Film& film, const std::vector<Mode>& known) const;
    bool follow(Mode& mode, const std::vector<Mode>& known, double tolerance);

    /// Derivatives of the film's residual and of its forces at constant pressure by a small change of the surface.
    struct SurfaceAnswer {
        std::vector<double> flow, storage; // dR [Pa m^3/s], d^2R/dperTime [Pa m^3]; padded
        Vector3 force = Vector3::Zero();   // about the slider's centre [N], [N m]
    };
    SurfaceAnswer surfaceAnswer(std::span<const double> height);

    FilmLevel& level_;
    const SliderBody& body_;
    Matrix3 contact_;
    std::unique_ptr<FilmOscillation> oscillation_;
    std::array<std::vector<double>, 3> byPressure_;
    Matrix3 byAttitude_;
    bool converged_ = true;
};

} // namespace touchdown
