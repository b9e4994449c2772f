// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ladder of models for one scene of a film: what can be left out of it, and the models that stand for it without a
// film in time.
//
//   static        it has come to rest in its static state; nothing moves
//   contact rest  it has come to rest in contact, by Ono and Yamane's characteristic (film_equilibria.h)
//   wave answer   about the static state, the motion that the waves of the disk keep up (linear_motion.h)
//   small motion  that and the modes that the start sets going
//   springs       two lumped springs fitted to the film, with the contact's characteristic (spring_fit.h)
//   parts         the film in time without one of its parts: a rough disk, contact, adhesion, roll; on fewer grid
//   lines, with
//                 looser steps
//   sums          the film without several of them
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/runs/measured_run.h"

namespace touchdown {

struct AdvisorTask {
    Case start;
    double tolerance = 0.01; // of the mean spacing [-]
    double spreadTolerance =
        0.1;                // of the spread, or of that much of the mean spacing times `tolerance` where it is less [-]
    double pilot = 0.3;     // least part of the run that the full model is given [-]
    bool confirm = false;   // take full model and advice to the end
    bool all = false;       // measure models, too, that take too long to be the advice
    double budget = 3600.0; // wall time after which the study ends with what it knows [s]
    std::vector<std::string>
        models; // to be tried: "static", ...; empty: all. Sums are built from parts, and have them tried, too
};

enum class RungKind : std::uint8_t { Full, Static, ContactRest, WaveAnswer, SmallMotion, Springs, Part, Sum };
std::string_view name(RungKind kind);

/// What can be left out of a film's run.
struct LadderPart {
    std::string name;      // "disk flat"
    std::string leavesOut; // "the disk's surface"
    std::vector<CaseSetting> settings;
    std::string family; // of several of one family, as of grids, one is left out
};

struct Rung {
    RungKind kind = RungKind::Full;
    std::string name;
    std::string leavesOut;
    std::vector<LadderPart> parts;
    Case c; // that is run; of those without a film in time: whose film is
};

/// Models without a film in time, on the scene's grid and on coarser ones, and those without one part, as far as the
/// scene has it. `roll`: of the static state, in which a roll that is left out is held [rad].
std::vector<Rung> ladderOf(const AdvisorTask& task, double roll);
/// The film without all these parts, one of a family at most. None where they are fewer than two, or that is no valid
/// case.
std::optional<Rung> sumOf(const AdvisorTask& task, const std::vector<LadderPart>& parts);

} // namespace touchdown
