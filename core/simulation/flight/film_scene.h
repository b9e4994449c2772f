// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a run of the film: surface, disk, film on its grid, body, contact and start. The static state gives the
// grid, and the place where the suspension exerts its load. It is solved once, or not at all where it is in hand.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/physics/slider/disk_clearance.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/contact/slider_contact.h"
#include "core/simulation/recording/run_summary.h"
#include "core/simulation/static_state/disk_on_cells.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

class StateStream;
struct FilmLevel;
struct FilmGaps;
struct LinearFilmModel;
struct LinearState;
struct StaticSolution;
struct SteadyResult;

/// Neither copied nor moved: its parts point at each other. Most parts exist only after prepare() returned Ready.
class FilmScene {
public:
    /// `c` is valid, of the model "film", and must last.
    explicit FilmScene(const Case& c);
    FilmScene(const FilmScene&) = delete;
    ~FilmScene();

    enum class State : std::uint8_t { Ready, Stopped, Failed };
    /// Surface of the disk, static state, initial attitude, film there. `goOn`: false stops, and must remain false.
    /// `known`: a static state in hand, which is used if it is that of the case; null: none. `kept`: see RunOptions.
    State prepare(const std::function<bool()>& goOn, const StaticSolution* known = nullptr,
                  KeptStates kept = KeptStates::Own);
    /// In place of prepare(), which was Ready for the run that is continued. `level->pressure` is not that of the
    /// start.
    State restore(StateStream& stream, const std::function<bool()>& goOn);
    /// What restore() reads.
    void store(StateStream& stream);
    /// Sets diskOnCells again where this attitude, with its minimum spacing [m], is much lower than the last one.
    void lookAtLower(const Attitude& attitude, double lowest);
    /// Snapshots of filmMaps() and of the contact, at pressures p (padded), of a case that records them.
    std::vector<FieldSnapshot> snapshots(double time, const Attitude& attitude, std::span<const double> p) const;

    std::string message; // why it failed
    std::vector<std::string> warnings;
    Recess recess;
    MinimumSpacing spacing;
    DiskTopography topography;
    std::optional<DiskClearance> clearance; // of slider and topography
    DiskOnCells diskOnCells;                // at the lowest attitude that was looked at
    std::optional<SliderBody> body;
    std::unique_ptr<FilmLevel> level; // its pressure: at the start
    std::optional<DiskUnderFilm> disk;
    std::unique_ptr<SliderContact> contact;  // null: only air acts
    std::unique_ptr<LinearFilmModel> linear; // null: the film is solved on its cells
    Attitude start;
    std::vector<double> startSurface; // of a start in contact: the disk under the film, deformed; padded [m]
    double restEnergy = 0.0; // stored by the air in the static state, or at the start if there is none; of a linear
                             // film zero [J]

private:
    State fail(std::string reason);
    void lookAtCells(const Attitude& attitude);
    SteadyResult findRest(const StaticSolution* known, const std::function<bool()>& goOn) const;
    /// Film, disk, contact on these gaps. False: stopped.
    bool makeParts(std::shared_ptr<const FilmGaps> gaps, const std::function<bool()>& goOn);
    /// Film, disk, contact on the static state's grid. False: stopped.
    bool makeParts(const SteadyResult& rest, const std::function<bool()>& goOn);
    void pass(StateStream& stream);
    bool isLinear() const;
    Vector3 stepOf(Matrix3 stiffness, Vector3 force) const;
    /// Moves a state of rest of a similar case to that of this one, with the film linear about it; false: not found.
    bool moveRest(const LinearFilmModel& film, SteadyResult& rest);
    /// Where no law of contact acts the disk must not reach the slider at the start.
    State checkDisk();
    State makeLinear(std::shared_ptr<const LinearState> state, const SteadyResult& rest,
                     const std::function<bool()>& goOn);
    State solveStart(const std::function<bool()>& goOn);
    /// "start higher (initial.height_offset)"
    std::string startHigher() const;

    const Case& case_;
    RecordedFields filmMaps_;
    Attitude bodyRest_;           // where the suspension exerts its load
    Attitude atCells_;            // of diskOnCells
    double lowestForCells_ = 0.0; // the spacing there [m]
};

} // namespace touchdown
