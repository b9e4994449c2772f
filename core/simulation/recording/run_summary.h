// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run reports: batches of samples, events and fields while it runs, and a Summary at its end.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numerics/spectrum.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

struct FieldSnapshot;
struct RecordedFields;
struct RunCheckpoint;

enum class RunStatus : std::uint8_t { Completed, Cancelled, Diverged, Failed };
std::string_view name(RunStatus status);

/// How the motion ends: core/simulation/recording/motion_verdict.h.
enum class Motion : std::uint8_t { NotJudged, AtRest, Settles, Swings, Vibrates, Bounces, TooShort };
/// "bounces"; "not judged" of a pad that is moved.
std::string_view name(Motion motion);
/// The motion is sustained.
constexpr bool lasts(Motion motion)
{
    return motion == Motion::Swings || motion == Motion::Vibrates || motion == Motion::Bounces;
}

/// Whether the slider touches the disk during some time. Menisci that hold the pad count as contact.
enum class Touch : std::uint8_t { Never, AtTimes, Always };
/// "flying", "in and out of contact", "contact".
std::string_view name(Touch touch);

struct MotionVerdict {
    Motion motion = Motion::NotJudged;
    Touch touch = Touch::Never; // in the judged last part of the run
    bool forced = false;        // a sustained motion that the moving surface of the disk drives
    double swing = 0.0;         // of the minimum spacing there, peak to peak [m]
    double rms = 0.0;           // its standard deviation there [m]
    double frequency = 0.0;     // of the main motion [Hz]; 0 where there is none
    bool undersampled = false;  // it is faster than its samples show; so its frequency is not known
    std::string rule;           // that decided, with its figures
};
/// "bounces at 273 kHz", "vibrates in contact, forced by the disk (837 kHz, 0.099 nm rms)", "at rest".
std::string textOf(const MotionVerdict& verdict);

/// Why a run did not complete; the message states it for a person.
enum class RunFailure : std::uint8_t {
    None,
    Diverged,        // beyond all bounds
    NegativeEnergy,  // where springs.potential is "as-printed"
    Chattering,      // switches without end
    FrontSpringLost, // for good: outside the model
    RearSpringLost,
    Tunnelled,    // through the wall of an air spring
    NoStep,       // is short enough for what is asked
    NotConverged, // an implicit step, or film and slider
    Other
};
/// Without where, when and what to do about it: "the rear air spring is lost for good"; "" of None.
std::string_view name(RunFailure failure);

/// A switch: a spring lost or caught, the pad touching down or taking off.
struct RunEvent {
    double time = 0.0; // [s]
    std::string name;  // "touch-down", "rear spring lost"
    void pass(auto& stream) { stream(time, name); }
};

/// A report of the core during a run. Sent at least every 20 ms of wall time.
struct RunUpdate {
    double time = 0.0;                         // reached [s]
    double duration = 0.0;                     // of the whole run [s]
    const SampleBatch& samples;                // since the last update; may be empty
    const std::vector<RunEvent>& events;       // since the last update
    const std::vector<FieldSnapshot>& fields;  // since the last update; of recordedFields
    const RunCheckpoint* checkpoint = nullptr; // the state after all that was sent; null in most updates
};
/// Return false to stop the run; may block to pause it. Called on the thread of `run`.
using RunCallback = std::function<bool(const RunUpdate&)>;

/// `min` and `max` are those of the motion between the samples, too.
struct Statistics {
    double mean = 0.0, std = 0.0, min = 0.0, max = 0.0; // [unit of the quantity]
};
struct Extremes {
    double least = 0.0, most = 0.0; // [unit of the quantity]
};

/// What halving a fixed step changes.
struct StepCheck {
    double step = 0.0;         // the halved one [s]
    double flyingHeight = 0.0; // at the end, with that step [m]
    double pitch = 0.0;        // [rad]
    bool sameEndState = true;
    std::string message; // a sentence
};

/// What one reads off a run: "pull_off_force".
struct RunFigure {
    Quantity quantity;
    double value = 0.0;    // [unit of the quantity]; NaN: not known
    bool isCount = false;  // a whole number of things or events
    bool ofSolver = false; // how the solver worked, not what the slider did
};

struct Summary {
    RunStatus status = RunStatus::Completed;
    RunFailure failure = RunFailure::None;
    std::string message;  // why it ended, for a person
    double endTime = 0.0; // reached; of a failed run the time that its message names [s]
    long long steps = 0;  // accepted
    long long rejectedSteps = 0;
    long long evaluations = 0;  // of the right-hand side
    double solverSeconds = 0.0; // integration and dense output alone, of wall time
    double wallSeconds = 0.0;   // with samples, callback and statistics
    int threads = 1;            // that shared the loops of a film
    std::string model;
    std::string integrator;
    std::vector<std::pair<std::string, double>> final;    // quantity name -> value; only finite ones
    std::vector<std::pair<std::string, Statistics>> tail; // over the last 10 % of the duration
    std::vector<RunEvent> events;                         // the first 100 000
    /// Extremes over the whole run, between samples too: quantity name -> values.
    std::vector<std::pair<std::string, Extremes>> extremes;
    MotionVerdict verdict;
    bool bouncing() const { return verdict.motion == Motion::Bounces; }
    std::vector<Peak> peaks; // of the minimum spacing, largest first
    std::optional<StepCheck> stepCheck;
    std::vector<std::string> warnings;
    std::vector<RunFigure> figures;       // models film and contact; springs with their energy balance
    std::optional<CharacteristicFit> fit; // contact multi-asperity
};

/// The value of a quantity in `final`, `tail` or `extremes`; null where there is none.
template <class Value>
const Value* valueIn(const std::vector<std::pair<std::string, Value>>& list, std::string_view quantity)
{
    for (const auto& [name, value] : list)
        if (name == quantity) return &value;
    return nullptr;
}

template <class Value>
Value valueOr(const std::vector<std::pair<std::string, Value>>& list, std::string_view quantity, const Value& none)
{
    const Value* value = valueIn(list, quantity);
    return value ? *value : none;
}

/// Of a run that does not begin, for a reason in a sentence.
Summary refusedRun(std::string reason);

struct StaticSolution;

/// Which of the static states that are kept a run of a linear film may take.
enum class KeptStates : std::uint8_t {
    Own,     // that of its case
    Similar, // also that of a similar case (nearestLinearState), whose film is the same: a look at once, for one who
             // moves a value. What it finds depends on what was run before.
    None     // it finds its own, which a comparison of times needs
};

struct RunOptions {
    bool energyBalance =
        false; // springs: report the integrator's energy error as figure "energy_balance", as film runs do
    /// Film: a static state in hand. If it is that of the case, the run starts from it and does not solve for it again.
    std::shared_ptr<const StaticSolution> rest = nullptr;
    KeptStates kept = KeptStates::Own;
    /// Wall time between two checkpoints [s]; none: there are no checkpoints. Integrator `cvode` makes none.
    std::optional<double> checkpointEach{};
    /// The state from which the run continues; what was sent before is not sent again. Null: from its start.
    std::shared_ptr<const RunCheckpoint> from = nullptr;
};

} // namespace touchdown
