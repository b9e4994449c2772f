// SPDX-License-Identifier: GPL-3.0-or-later
//
// A static state of a slider: attitude, forces, fields, and what is known of its errors and of other states.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/small_matrix.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/physics/film/film_forces.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

struct FilmGaps;

enum class SteadyStatus : std::uint8_t { Converged, NotConverged, Cancelled, Failed };
std::string_view name(SteadyStatus status);

/// Derivatives of the attitude by one parameter.
struct Sensitivity {
    std::string parameter;       // key, "abs.crown"
    std::string unit;            // SI, of the parameter
    double height = 0.0;         // d/dparameter [m/unit]
    double pitch = 0.0;          // [rad/unit]
    double roll = 0.0;           // [rad/unit]
    double minimumSpacing = 0.0; // [m/unit]
};

/// Estimated distance from the limit of infinitely many cells, each as a magnitude. NaN: not known, as where no coarser
/// grid has a solution to compare with.
struct DiscretisationError {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    double minimumSpacing = unknown; // [m]
    double pitch = unknown;          // [rad]
    double roll = unknown;           // [rad]
    double load = unknown;           // [N]
};

/// The contact of a slider at rest; zeros in flight.
struct ContactAtRest {
    /// "flying", "pressed", "held by menisci", "in contact"; "not found", "not known" (stopped): its numbers
    /// are NaN; "": none was sought.
    std::string state;
    double contact = 0.0;      // >= 0 [N]
    double adhesion = 0.0;     // <= 0 [N]
    double friction = 0.0;     // in the disk's direction [N]
    double pitchTorque = 0.0;  // of the three about the mass centre, nose up [N m]
    double rollTorque = 0.0;   // inner edge up [N m]
    double area = 0.0;         // real area of contact [m^2]; zero where the law has none
    double peakPressure = 0.0; // of contact [Pa]
    bool diverges = false;     // a small motion grows without oscillating
    // How the state is found again: the region of Ono and Yamane's law, or the branch on which another was reached.
    ContactRegion region = ContactRegion::Apart;
    ContactBranch branch = ContactBranch::TouchDown;
    bool acts() const { return std::abs(contact) + std::abs(adhesion) > 0.0; }
};
/// One of the static states of a slider with a contact.
struct RestingState {
    Attitude attitude;
    double minimumSpacing = 0.0; // [m]
    ContactAtRest contact;
};

struct SteadyResult {
    SteadyStatus status = SteadyStatus::Failed;
    std::string message; // a sentence, when not converged or worth saying
    int iterations = 0;  // Newton steps or cycles on the finest grid
    int solves = 0;      // linear solves on all grids
    double wallSeconds = 0.0;
    double residual = 0.0;  // as FilmCase::tolerance measures it [-]
    double loadError = 0.0; // as SteadyCase::loadTolerance measures it [-]
    Attitude attitude;
    double minimumSpacing = 0.0; // [m]
    SurfacePoint minimumAt;      // [m]
    FilmForces forces;
    double shearPitchTorque = 0.0; // of the air's shear, with the arm of SteadyCase [N m]
    double shearRollTorque = 0.0;  // [N m]
    /// Rows: force [N], pitch torque, roll torque [N m]; columns: d/dheight [1/m], d/dpitch, d/droll [1/rad]. Of the
    /// film, about the slider's centre, with the trailing edge height as the first coordinate; positive: restoring.
    std::optional<Matrix3> stiffness;
    std::vector<Sensitivity> sensitivities;
    DiscretisationError discretisationError;
    std::size_t unresolvedRidges = 0;    // edges with a ridge narrower than a cell (edge_ridges.h)
    std::vector<double> interestSpacing; // at the surface's points of interest [m]
    std::vector<Attitude> otherEquilibria;
    ContactAtRest contact;                   // of steadyWithContact; no state without a law of contact
    std::vector<RestingState> contactStates; // the other static states of that law
    /// Of the contact, about the mass centre; rows and columns as those of q (slider_body.h); positive: restoring.
    std::optional<Matrix3> contactStiffness;
    std::optional<Attitude> suspensionRest; // where the suspension exerts its load; empty: at the attitude
    CellGrid grid;
    std::vector<double> pressure; // absolute, per cell [Pa]
    std::vector<double> gap;      // mean over each cell [m]
    std::vector<double> recess;   // mean over each cell [m]
    /// Of the case's slider on the grid; null: not kept, as in a state from a file. They take more memory than the
    /// fields.
    std::shared_ptr<const FilmGaps> gaps;

    /// Adds a sentence to the message; none where it is empty.
    void note(const std::string& sentence);
    /// Keeps the numbers, and the grid: many states need much memory.
    void dropFields();

    /// Whether film and suspension balance at the attitude, be it above the disk's mean plane or below ("failed").
    bool balanced() const
    {
        return status == SteadyStatus::Converged || (status == SteadyStatus::Failed && !pressure.empty());
    }
};

} // namespace touchdown
