// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film of a run, linear about a static state: the rational function of film_fit.h in time. Each pole's state obeys
// x_k' = p_k x_k + u, u the displacement of q from the static state. Within a step u is the cubic through position,
// velocity and acceleration at its beginning and the position at its end, for which x_k is exact.
//
// Energy: the film stores what its static answer would store, -F_0 u + u K u/2, K the symmetric part of Z(0). The power
// of its force beyond that answer is gained or lost.
//
// How far the film is from linear is estimated from the size of the motion: the displacement of the slider's corners
// from where it rests against the minimum spacing of the static state. The neglected terms are of second order, so that
// their share of the motion is in proportion to sqrt(integral size^4/integral size^2); waves of the disk count in the
// first integral. In contact the spacing is small, and so is the motion for which the film counts as linear. The disk
// stays deformed as it is in the static state.
#pragma once

#include <vector>

#include "core/simulation/flight/film_in_time.h"
#include "core/simulation/small_motions/linear_state.h"

namespace touchdown {

/// Error of the displacement against the displacement, by sqrt(integral size^4/integral size^2); holds for 19 of 20
/// drawn motions (tests/bench/README.md) [-].
inline constexpr double linearErrorPerSize = 2.1;
inline constexpr double leastLinearGap = 0.3e-9; // as which a smaller spacing counts [m]

class LinearFilm final : public FilmInTime {
public:
    explicit LinearFilm(LinearFilmModel model);

    void start(const SliderMotion& motion, double time) override;
    void setDisk(double time, bool touched) override;
    FilmStepResult step(double dt, const SliderMotion& from, const Vector3& q, double rate) override;
    Vector3 force() override { return atCubic_ - stiffness_ * cubic_ + disk_; }
    const Matrix3& stiffness() const override { return stiffness_; }
    double stiffnessError() const override { return 0.0; }
    bool isResponseKnown() const override { return true; }
    bool isResponseOld() const override { return false; }
    int renewResponse(bool /*touched*/, const std::function<bool()>& /*goOn*/) override { return 0; }
    void outdateResponse() override {}
    double follow(const Vector3& q, const Vector3& change) override;
    double allowed() const override { return 1.0; }
    std::array<double, 3> timeErrorLoad() const override { return {}; }
    bool accept(const SliderMotion& to) override;
    bool isFitted() const override { return true; }
    double ambientForce() const override { return model_.ambientForce; }
    Vector3 shearTorques() const override { return Vector3::Zero(); }
    FilmEnergyState energy() override;
    double surfaceWork() override { return 0.0; }
    void pass(StateStream& stream) override;

    /// Root mean square error of the corners' displacement so far, against that displacement, as estimated [-].
    double linearityError() const;
    /// Whether that error is above a limit; until the longest wave has passed without what the waves add to it.
    bool isTooFar(double limit) const;
    /// A displacement that motions for which the film is linear seldom exceed [m].
    double smallMotion() const;
    /// The largest size of the motion so far [-].
    double largestSize() const { return largestSize_; }
    const FilmFit& fit() const { return model_.fit; }
    double transientError() const { return model_.transientError; }

private:
    /// Of one pole over a step: e^(p dt), and the integrals of e^(p (dt - t)) (t/dt)^j, j = 0..3 [s].
    struct Weights {
        std::complex<double> decay;
        std::array<std::complex<double>, 4> integrals;
    };
    void setWeights(double dt);
    void lookAtMotion(double dt);
    double errorBy(double fourths) const;

    LinearFilmModel model_;
    Matrix3 staticStiffness_;                        // K [N/m ...]
    std::vector<ComplexVector3> states_, predicted_; // x_k; the same at the end of the step, without its cubic part
    SliderMotion accepted_;                          // displacement u and its rates
    Vector3 forceNow_ = Vector3::Zero();             // of the accepted state
    Vector3 disk_ = Vector3::Zero();                 // the force by the disk's waves, as set
    double largestSize_ = 0.0;                       // of the motion [-]
    // Integrals of size^2, size^4, (size^2 + waves^2)^2 over the time so far [s].
    double squares_ = 0.0, own_ = 0.0, fourths_ = 0.0, time_ = 0.0;
    // Of the step that is tried.
    double dt_ = 0.0; // of the weights; zero: none [s]
    std::vector<Weights> weights_;
    Matrix3 stiffness_ = Matrix3::Zero();
    Vector3 quadratic_ = Vector3::Zero(); // u at its end, but for the cubic part
    Vector3 cubic_ = Vector3::Zero();     // that part
    Vector3 atCubic_ = Vector3::Zero();   // the force without it
    bool started_ = false;                // with the weights and the accepted state as they are
};

} // namespace touchdown
