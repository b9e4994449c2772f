// SPDX-License-Identifier: GPL-3.0-or-later
//
// The springs over one wave of the disk (forced_motion.h); time is counted by the disk under the contact pad. The
// integral of a harmonic is taken over each step with five Gauss points of its dense output; steps end on the switches
// of the laws, so that its error is the one of the integrator.
#pragma once

#include <algorithm>

#include "core/simulation/springs/disk_under_springs.h"
#include "core/studies/response/forced_motion.h"

namespace touchdown {

class ForcedSprings final : public ForcedSlider {
public:
    /// A valid case of model "springs" over one moving wave; `quantity` is the name of one of its quantities.
    ForcedSprings(const Case& c, const std::string& quantity);

    double frequency() const override { return 1.0 / period_; }
    double waveAmplitude() const override { return waveAmplitude_; }
    double stepError(bool rough = false) const override
    {
        return std::max(toleranceOf(rough) * model_.scale()[0], roundOffOfHeight(model_));
    }
    Eigen::VectorXd units(const Eigen::VectorXd& swing) const override;
    Eigen::Index positions() const override { return 2; }
    /// Of a height near the static state [m].
    static double roundOffOfHeight(const SpringModel& model);
    const SpringModel& model() const { return model_; }
    ForcedState start() const override;
    ForcedState moved(const Eigen::VectorXd& direction, double size) const override;
    ForcedState lowered(double distance) const override;
    ForcedState continued(const ForcedState& before) const override;
    ForcedPeriods run(const ForcedState& start, const ForcedRequest& request) const override;
    std::optional<std::complex<double>> linear() const override;

private:
    static constexpr double roughTimes = 1e3; // error of a rough step [-]

    double toleranceOf(bool rough) const { return (rough ? roughTimes : 1.0) * tolerance_; }
    SpringModel::Under underAt(double time) const { return disk_.at(begin_ + time); }

    DiskUnderSprings disk_;
    SpringModel model_;
    std::size_t quantity_, minimumSpacing_; // places in the list of quantities
    std::size_t quantities_;                // their number
    double waveAmplitude_;                  // a [m]
    double period_;                         // T [s]
    double begin_;                          // at which time of the case t is 0 [s]
    double tolerance_;                      // local error of a step, in units of SpringModel::scale [-]
    bool hasFront_, hasRear_;               // air springs with a stiffness
};

/// The case over one wave of this amplitude [m] and frequency [Hz] alone, which moves. Its length follows from the
/// speed of the disk; where `wavelength` [m] is not 0, that is the length and the speed follows.
Case caseOverWave(Case c, double amplitude, double frequency, double wavelength);
/// The speed with which the disk moves from the leading to the trailing edge [m/s].
double speedAlong(const Case& c);

} // namespace touchdown
