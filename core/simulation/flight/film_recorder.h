// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns the steps of a run of the film into samples at equal intervals, and one at its end. Within a step the slider
// moves along a polynomial (film_point.h); forces and energies along parabolas. Four points of each step find the
// extremes between samples.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"
#include "core/physics/slider/disk_clearance.h"
#include "core/simulation/flight/film_point.h"
#include "core/simulation/recording/run_recorder.h"

namespace touchdown {

class NearbySpacing;
class Recess;
struct Case;

/// A state as it is recorded: forces in N, energies in J.
struct FilmSample {
    double flyingHeight = 0.0, spacing = 0.0; // above the mean plane [m]
    double gap = 0.0, diskHeight = 0.0;       // above the actual disk; its height under the flying height [m]
    Attitude attitude;
    SliderMotion motion;
    double airForce = 0.0, kinetic = 0.0, suspension = 0.0, film = 0.0, gained = 0.0, dt = 0.0;
    double contact = 0.0, adhesion = 0.0, friction = 0.0, stored = 0.0;
    double area = 0.0, peakPressure = 0.0; // of contact [m^2], [Pa]
};
using FilmQuantity = RecordedQuantity<FilmSample>;
std::vector<FilmQuantity> filmRows(const Case& c);
/// Of each point of interest behind the first, over a disk that is not flat: flying height above the disk, its height.
std::vector<Quantity> furtherPoints(const Case& c);

class FilmRecorder {
public:
    /// All must last. `clearance` may be null over a flat disk. Where the disk may reach the slider, the gap is sought
    /// at least once every `lookInterval` [s].
    FilmRecorder(const Case& c, const SliderBody& body, const Recess& recess, NearbySpacing& spacing,
                 DiskClearance* clearance, double lookInterval, RunRecorder& run);

    void begin(const FilmPoint& start);
    /// A step from the last point to this one.
    void add(const FilmPoint& point);
    /// The forces at the last point have jumped to these.
    void jump(const FilmPoint& point);
    /// The last sample of a run that has ended at the last point, before its duration.
    void end()
    {
        if (last_.time < case_.run.duration) recordEnd(last_);
    }

    /// Where and when the disk was first found to reach the slider.
    struct Reached {
        DiskClearance::Place place;
        double time; // [s]
    };
    const std::optional<Reached>& reached() const { return reached_; }

    /// All but the clearance, written or read.
    void pass(StateStream& stream)
    {
        stream(last_, earlier_, samples_, reached_, leastParts_, mostParts_, firstEnergy_, mostMissing_);
        StateStream::require(samples_ >= 0);
    }

    /// The largest difference of change and gain of the energy, against the largest range of one of its parts [-].
    double energyImbalance() const;
    Summary summary(const RunEnd& end) const;

private:
    struct Point {
        SurfacePoint at;     // [m]
        double recess = 0.0; // [m]
    };
    void record(const FilmPoint& to, double time);
    void recordEnd(const FilmPoint& to);
    /// Sets values_, between the last point and `to`. `seek`: the minimum gap; else it is not known (NaN).
    void evaluate(const FilmPoint& to, double time, bool seek = true);
    double heightOf(const Point& point, const Attitude& attitude) const; // above the mean plane [m]
    void addToEnergy(const FilmPoint& point);

    const Case& case_;
    const SliderBody& body_;
    NearbySpacing& spacing_;
    DiskClearance* clearance_; // null: the disk is flat
    double lookInterval_;      // [s]
    RunRecorder& run_;
    std::vector<FilmQuantity> rows_;
    std::vector<Point> points_; // of interest; the flying height is taken at the first
    std::optional<Reached> reached_;
    FilmPoint last_, earlier_; // the same where forces have jumped
    long long samples_ = 0;
    std::array<double, 4> leastParts_{}, mostParts_{}; // of the energy: slider, suspension, air, contact [J]
    double firstEnergy_ = 0.0, mostMissing_ = 0.0;     // at the points [J]
    std::vector<double> values_;
};

} // namespace touchdown
