// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider over a flat disk, under Ono and Yamane's contact, and its return map, whose fixed points are cycles of
// sustained bouncing.
//
// The section is the touch-down height: the separation d of the pad crosses d_s downwards, from any region of the
// contact law. A state on the section has one coordinate less than any state; x has them in units of order one. P(x) is
// the n-th next crossing. A cycle with n crossings is P(x) = x. Its Floquet multipliers are the eigenvalues of dP/dx;
// the cycle is stable where all are inside the unit circle.
//
//   Phi' = A(t) Phi                          along a step, A = df/dy
//   S = I + (f+ - f-) g^T/(g . f-)           at a switch with the normal g (Aizerman & Gantmakher 1958)
//   dP/dx = C (I - f- g^T/(g . f-)) Phi B    at the section; B and C take x to y and y to x
//
// (Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth Mechanical Systems, 2004, chapter 7.) At a grazing
// g . f- = 0 and the map is not smooth. Cycles that never cross d_s downwards are not found.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/springs/spring_model.h"
#include "core/work/parallel.h"

namespace touchdown {

/// A switch along a cycle.
struct CycleSwitch {
    int guard = 0; // SpringModel::Guard
    SpringModel::Mode before, after;
    bool operator==(const CycleSwitch&) const = default;
    /// Whether it is a crossing of the section.
    bool crosses() const
    {
        return guard == SpringModel::Pad && after.contact == ContactRegion::Pressed &&
               before.contact != ContactRegion::Pressed;
    }
};

/// Energy that the slider receives along a cycle, by part [J].
struct CycleEnergies {
    double air = 0.0;        // dashpots of the air springs
    double suspension = 0.0; // its dashpots
    double contact = 0.0;    // contact and adhesion: -W at each touch-down from flight
    double friction = 0.0;
    /// Zero for a cycle.
    double sum() const { return air + suspension + contact + friction; }
    double largest() const;
};

/// The smallest and the largest value of a length along a cycle [m].
struct SwingOf {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
    void add(double value);
};

struct ReturnRequest {
    int crossings = 1;         // n
    double limit = 1e-3;       // within which the slider must come back [s]
    bool derivative = false;   // dP/dx
    bool measurements = false; // energies and swings
    double tolerance = 1e-11;  // local error of a step, in units of SpringModel::scale [-]
};

struct Return {
    bool returned = false;
    Eigen::VectorXd x; // P(x)
    double time = 0.0; // until then [s]
    Eigen::MatrixXd derivative;
    std::vector<CycleSwitch> switches;   // the last one is the crossing itself
    std::vector<Eigen::VectorXd> passed; // x at each crossing
    /// Distance from x of the nearest crossing after which a cycle would repeat itself; infinite for n = 1 [-].
    double repeats(const Eigen::VectorXd& from) const;
    CycleEnergies energies;
    SwingOf separation, minimumSpacing; // d; the smallest spacing of the slider
    double modelError = 0.0;            // of a linear film and its separation, of the motion, as estimated [-]
    bool tooFar = false;                // that error is above film.linear_limit
};

/// Watches a long motion.
class BouncingWatch {
public:
    virtual ~BouncingWatch() = default;
    virtual void begin(double minimumSpacing, ContactRegion region) = 0;
    /// After a step to time `to`; the minimum spacing at times within it [m]. False stops.
    virtual bool step(double to, const std::function<double(double time)>& spacingAt) = 0;
    /// `x`: on the section, where it is crossed; else null.
    virtual void event(double time, const CycleSwitch& of, const Eigen::VectorXd* x) = 0;
};

inline constexpr double judgedShare = 0.1; // of a long motion, at its end [-]

struct LongMotion {
    std::string problem{};   // why it ended before, in a sentence without a full stop; "" where it did not
    double modelError = 0.0; // as of Return, without the separation's, in the judged share [-]
    bool tooFar = false;
};

class BouncingSlider {
public:
    virtual ~BouncingSlider() = default;

    virtual Return apply(const Eigen::VectorXd& x, const ReturnRequest& request) const = 0;
    /// Over `duration` [s] from the start of the case, or from a state on the section. `tolerance` as of a request.
    virtual LongMotion run(const std::optional<Eigen::VectorXd>& from, double duration, double tolerance,
                           BouncingWatch& watch) const = 0;
    virtual double startHeight() const = 0;    // flying height there [m]
    virtual double shortestPeriod() const = 0; // of the motions about the static state and in contact [s]
    virtual double cycleWork() const = 0;      // W of the contact law [J]
    /// "touch-down", "rear spring lost", ...
    virtual std::string nameOf(const CycleSwitch& of) const = 0;
};

/// The slider of a case that differs from one in the values of a few keys, at its k-th start: as the case says, then at
/// a tenth, a hundredth, ... of that height above d_e, at rest. Throws std::runtime_error, a sentence.
/// `goOn`: false stops, and the result is null.
using SliderOf = std::function<std::shared_ptr<const BouncingSlider>(const Case& c, int start, const GoOn& goOn)>;

} // namespace touchdown
