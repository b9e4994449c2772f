// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spring model as a slider that bounces (bouncing_slider.h). A state on the section has three coordinates,
//
//   x = (theta, d', theta'),   z = d_s + d_h theta,   z' = d' + d_h theta',
//
// in units of SpringModel::scale of one case.
#pragma once

#include "core/numerics/small_matrix.h"
#include "core/numerics/switched_system.h"
#include "core/studies/cycles/bouncing_slider.h"

namespace touchdown {

/// Units of x: [rad], [m/s], [rad/s].
Vector3 sectionUnits(const Case& c);

/// The k-th start of a case (SliderOf), at the static pitch.
Case caseOfStart(const Case& c, int k);

class BouncingSprings final : public BouncingSlider {
public:
    /// The case is valid and has Ono and Yamane's contact.
    BouncingSprings(const Case& c, const Vector3& units);

    Return apply(const Eigen::VectorXd& x, const ReturnRequest& request) const override;
    LongMotion run(const std::optional<Eigen::VectorXd>& from, double duration, double tolerance,
                   BouncingWatch& watch) const override;
    double startHeight() const override { return startHeight_; }
    double shortestPeriod() const override { return model_.shortestPeriod(); }
    double cycleWork() const override { return cycleWork_; }
    std::string nameOf(const CycleSwitch& of) const override { return model_.eventName(of.guard, of.before, of.after); }

    const SpringModel& model() const { return model_; }
    /// x of a state on the section.
    Vector3 coordinates(const SpringModel::State& y) const;
    /// The state on the section.
    SpringModel::State state(const Vector3& x) const;

private:
    Start<SpringModel> start(const Vector3& x) const { return {state(x), modeAt(state(x))}; }
    SpringModel::Mode modeAt(const SpringModel::State& y) const;

    SpringModel model_;
    Vector3 units_;
    double startHeight_, cycleWork_;  // [m], [J]
    double touchDown_, padDistance_;  // d_s, d_h [m]
    double frontCutoff_, rearCutoff_; // below which a spring does not carry [m]
};

} // namespace touchdown
