// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a hysteresis study has seen: its runs and its equilibria.
#pragma once

#include <complex>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/equilibria/equilibrium.h"
#include "core/studies/hysteresis/held_steps.h"
#include "core/studies/runs/value_ranges.h"

namespace touchdown {

/// An equilibrium at a value of the parameter.
struct StudiedEquilibrium {
    double value = 0.0;   // [unit of the parameter]
    double spacing = 0.0; // [m]
    double pitch = 0.0;   // [rad]
    Stability stability = Stability::Stable;
    std::vector<std::complex<double>> eigenvalues; // by falling real part [1/s]
    int lost = 0;                                  // oscillations that were not followed
    bool edge = false; // a fold or Hopf point, at which the stability changes and its own means nothing
    /// None where no motion was followed.
    std::optional<double> growth() const
    {
        return eigenvalues.empty() ? std::nullopt : std::optional(eigenvalues.front().real());
    }
    /// What grows without oscillating is no oscillation, and not lost.
    bool followed() const { return lost <= (stability == Stability::Divergence ? 1 : 0); }
    /// Nothing grows of the oscillations that were followed, but not every one was.
    bool incomplete() const { return !edge && (!followed() || eigenvalues.empty()) && stability != Stability::Flutter; }
};

/// Equilibria of one smooth law, in their order along its branch.
struct EquilibriumLine {
    bool flying = true;   // without contact
    bool outside = false; // of what the model means: with a spring lost, or the pad below the mean plane of the disk
    std::vector<StudiedEquilibrium> points;
    bool frontLost = false, rearLost = false; // springs
    std::string state() const;                // "flying", "in contact, rear spring lost"
};

struct StudiedMark {
    EquilibriumMark kind = EquilibriumMark::Fold;
    std::string name; // "fold", "touch-down"
    StudiedEquilibrium at;
    bool outside = false;
};

struct HysteresisResult {
    std::vector<HeldStep> steps; // there, then back
    bool traced = false;         // whether equilibria were sought
    std::vector<EquilibriumLine> lines;
    std::vector<StudiedMark> marks;
    double resolved = std::numeric_limits<double>::infinity(); // frequency up to which a film's grid knows whether a
                                                               // motion grows [Hz]
    bool unsought = false; // somewhere the search for equilibria did not come to its end
    std::vector<std::string> warnings;
    /// An oscillation grows at a frequency at which the grid does not know.
    bool doubtful(const StudiedEquilibrium& at) const;
};

/// Lines and marks of the spring model.
void addSpringEquilibria(const EquilibriumBranches& found, HysteresisResult& result);
/// Those of the film.
void addFilmEquilibria(const EquilibriumBranches& found, HysteresisResult& result);

/// In contact, at every sample or at some.
bool touches(const EndState& end);

/// By the verdict on its motion.
bool bounces(const EndState& end);

/// A change of the end's kind between neighbouring values of one way.
struct Transition {
    bool down = false;                // touch-down; else take-off
    bool back = false;                // on the way back
    double before = 0.0, after = 0.0; // the values [unit of the parameter]
    double left = 0.0, reached = 0.0; // mean spacings there [m]
    double middle() const { return 0.5 * (before + after); }
};
std::vector<Transition> transitionsOf(const std::vector<HeldStep>& steps);

/// Has an end in or out of contact and still moves there.
bool stillMoves(const HeldStep& step);
/// Whether there is no step but failed ones.
bool allFailed(const std::vector<HeldStep>& steps);

/// Values at which the two ways end in different states, and the area between the ways.
struct LoopOf {
    std::vector<double> values;                        // [unit of the parameter], rising
    std::vector<std::pair<EndState, EndState>> ends{}; // there and back, at each of these
    std::size_t moving = 0;                            // of these: still moving on one way or both
    std::size_t known = 0;                             // values that have a valid end on both ways
    double area = 0.0;                                 // between the mean spacings of both ways [m unit]
    bool whole = true;                                 // every value has a valid end on both ways
};
LoopOf loopOf(const std::vector<HeldStep>& steps);

/// Spacings of all equilibria at a value, between the points of the lines.
struct EquilibriumAt {
    double spacing = 0.0; // [m]
    Stability stability = Stability::Stable;
    bool outside = false;
    bool incomplete = false; // its stability is not known
    bool flying = false;     // without contact
};
std::vector<EquilibriumAt> equilibriaAt(const std::vector<EquilibriumLine>& lines, double value);

/// Where points of lines within the model have a property: neighbours along a line are one range, which reaches to a
/// fold or Hopf point next to it.
std::vector<ValueRange> rangesAlong(const std::vector<EquilibriumLine>& lines,
                                    const std::function<bool(const StudiedEquilibrium&)>& isSo);

/// Where more than one equilibrium is stable or neutral, interpolated between the points of the lines.
std::vector<ValueRange> coexistence(const std::vector<EquilibriumLine>& lines);

} // namespace touchdown
