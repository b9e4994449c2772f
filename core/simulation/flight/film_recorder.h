// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns the steps of a run of the film into samples at equal intervals, and tells of them. Within a step the slider
// moves along the polynomial of fifth degree through position, velocity and acceleration at its ends; forces and
// energies along parabolas.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/simulation/flight/coupled_step.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/simulation/recording/run_updates.h"

namespace touchdown {

/// A state of the run, at one end of a step.
struct FilmPoint {
    double time = 0.0; // [s]
    SliderMotion motion;
    Vector3 filmForce{};
    SliderContactForces contact;
    double filmEnergy = 0.0; // stored by the air, from that of the static state [J]
    double gained =
        0.0; // by slider, suspension, air and contact since the start: what the disk gave, less what was dissipated [J]
    double dt = 0.0; // of the step that led there [s]
};

/// Position and velocity at a share of the way from one point to the next.
SliderMotion between(const FilmPoint& from, const FilmPoint& to, double share);

class FilmRecorder {
public:
    /// All must last.
    FilmRecorder(const Case& c, const SliderBody& body, const Recess& recess, const MinimumSpacing& spacing,
                 const RunCallback& callback);

    void begin(const FilmPoint& start);
    /// A step from the last point to this one.
    void add(const FilmPoint& point);
    /// The forces at the last point have jumped to these.
    void jump(const FilmPoint& point) { earlier_ = last_ = point; }
    void addEvent(double time, std::string name) { updates_.addEvent(time, std::move(name)); }
    void addFields(FieldSnapshot snapshot) { updates_.addFields(std::move(snapshot)); }

    /// Tells where it is time to. False when somebody stopped the run.
    bool lookAtClock();
    void flush();
    bool stopped() const { return stopped_; }
    double secondsOutside() const { return updates_.secondsOutside(); }

    /// The largest difference so far between the change of the energy and what was gained, against the largest range of
    /// one of its parts [-].
    double energyImbalance() const;
    /// Sets final values (of the last point, or at the duration where that is beyond), tail, peaks, events.
    void finish(Summary& summary);

private:
    void record(const FilmPoint& to, double time);
    /// Sets values_, between the last point and `to`.
    void evaluate(const FilmPoint& to, double time);
    void addToEnergy(const FilmPoint& point);

    const Case& case_;
    const SliderBody& body_;
    const MinimumSpacing& spacing_;
    std::vector<Quantity> quantities_;
    RunStatistics statistics_;
    RunUpdates updates_;
    SurfacePoint headAt_; // where the flying height is taken [m]
    double headRecess_ = 0.0;
    FilmPoint last_, earlier_; // the same where forces have jumped
    long long samples_ = 0;
    std::array<double, 4> leastParts_{}, mostParts_{}; // of the energy: slider, suspension, air, contact [J]
    double firstEnergy_ = 0.0, mostMissing_ = 0.0;     // at the points [J]
    std::vector<double> values_;
    bool stopped_ = false;
};

} // namespace touchdown
