// SPDX-License-Identifier: GPL-3.0-or-later
//
// Response of the film within a time step to a small change of the attitude: with J dp = -dR/dq dq its pressure changes
// by -X dq, X = J^-1 dR/dq, and its forces by -S dq, S = -dF/dq + dF/dp X. Both only guide an iteration, so they are
// kept while the length of the step is about the same, for some 200 steps, until steps converge more slowly.
//
// Where slider and disk touch, the disk gives way with the slider, so that the gap hardly changes: the air there counts
// as if it stayed as it is. Air of a few tenths of a nanometre that the slider compresses alone would be stiffer than
// the contact by a factor of up to 300, which no step between those of the contact itself could follow.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/physics/film/film_faces.h"
#include "core/physics/film/film_loads.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

class FilmLinearSolver;
class SliderContact;

class FilmResponse {
public:
    static constexpr double tolerance = 0.03; // of X [-]
    static constexpr int oldest = 200;        // steps

    /// All must last; the loads are those of the film.
    FilmResponse(const GasFilm& film, FilmLoads& loads, const SliderBody& body);

    bool known() const { return perTime_ > 0.0; }
    void forget();
    /// For the film's storage as it is, after so many steps.
    bool isOld() const;
    /// A step has been accepted.
    void age() { ++age_; }
    /// Steps converge more slowly.
    void outdate() { age_ = oldest + 1; }
    void pass(auto& stream)
    {
        stream(stiffness_, perTime_, age_);
        for (std::vector<double>& response : responses_) stream.fixed(response);
    }
    /// Renews the response at pressures p (padded) with the linear systems of a pressure near p; returns the number of
    /// preconditioned iterations. `contact`: null, or where the surfaces touch now. If `goOn`, asked at each iteration,
    /// returns false nothing is known.
    int renew(std::span<const double> p, FilmLinearSolver& linear, const SliderContact* contact,
              const std::function<bool()>& goOn = {});

    /// S about the mass centre, shear contained [N/m, N/rad; N m/m, N m/rad]; zero as long as nothing is known.
    const Matrix3& stiffness() const { return stiffness_; }
    /// change = -X dq (padded) [Pa]; returns its possible error, as root mean square against ambient [-].
    double follow(const Vector3& dq, std::span<double> change) const;

private:
    const GasFilm& film_;
    FilmLoads& loads_;
    const SliderBody& body_;
    std::array<std::vector<double>, 3> columns_, responses_; // dR/dq, X
    FilmLoads::Derivatives forces_;
    AttitudeWork attitudeWork_;
    Matrix3 stiffness_ = Matrix3::Zero();
    double perTime_ = 0.0; // of the film's storage for these; zero: none yet [1/s]
    int age_ = 0;          // in accepted steps
};

} // namespace touchdown
