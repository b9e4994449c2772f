// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state of a slider on its air film: pressure at a fixed attitude, or the attitude at which film and
// suspension balance, with forces, stiffness matrix, sensitivities and an estimate of the discretisation error.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/static_state/steady_result.h"

namespace touchdown {

/// Reported about at every grid level and iteration.
struct SteadyProgress {
    std::string stage; // "grid 97 x 97"
    int iteration = 0;
    double residual = 0.0;  // [-]
    double loadError = 0.0; // [-]
    Attitude attitude;
};
/// A later stage of a calculation, about a state that was found.
inline SteadyProgress progressAbout(const SteadyResult& state, std::string stage)
{
    return {std::move(stage), 0, state.residual, state.loadError, state.attitude};
}
/// Return false to stop.
using SteadyCallback = std::function<bool(const SteadyProgress&)>;

/// Solves a valid case with model "film" for its static state. Never throws for numerics: see SteadyResult::status.
/// Without grid and pressure where none can exist: static_check.h.
SteadyResult steady(const Case& c, const SteadyCallback& callback = {});

/// How many static states `steady` was asked for since the program began. A test compares two counts.
long long staticSolutions();

/// The case for its balanced attitude alone: no fixed one, no stiffness, sensitivities or other equilibria.
Case attitudeCase(const Case& c);

/// One combination of a series of radii (with skews), speeds and altitudes.
struct SteadySeriesPoint {
    double radius, skew, speed;     // [m], [rad], [rad/s]
    std::optional<double> altitude; // [m]
};
/// All combinations that the case lists: altitudes outermost, then speeds, then radii. One entry if it lists none.
std::vector<SteadySeriesPoint> seriesOf(const Case& c);
/// The case as it is, with empty lists: one state at disk.radius, disk.skew, disk.speed and the air as given.
Case withoutSeries(Case c);
/// The case at one of them, with empty lists.
Case caseAt(const Case& c, const SteadySeriesPoint& point);

/// An air bearing mode about the static state.
struct AirBearingMode {
    double frequency = 0.0;    // [Hz]
    double dampingRatio = 0.0; // [-]
    /// Estimated distances from infinitely many cells (small_motions/mode_errors.h), as magnitudes; NaN: not known.
    double frequencyError = DiscretisationError::unknown; // [Hz]
    double dampingError = DiscretisationError::unknown;   // of the damping ratio [-]
    /// Amplitudes (real, imaginary) of mass centre height [m], pitch, roll [rad]; largest motion of the corners 1.
    std::array<std::array<double, 2>, 3> shape{};
    std::string kind; // the motion that leads: "vertical", "pitch", "roll"
};
/// Response of the film to an oscillation, with the torques of its shear.
struct DynamicStiffness {
    double frequency = 0.0; // [Hz]
    Matrix3 stiffness;      // real part, about the mass centre [N/m ...]
    Matrix3 damping;        // imaginary part over omega [N s/m ...]
};
struct ModesResult {
    SteadyResult steady;
    std::vector<AirBearingMode> modes;       // by frequency
    std::vector<DynamicStiffness> stiffness; // over frequency
    SteadyStatus status = SteadyStatus::Failed;
    std::string message;
};
ModesResult modes(const Case& c, const SteadyCallback& callback = {});

} // namespace touchdown
