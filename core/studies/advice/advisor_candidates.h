// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy of models for one film case: simpler models without a film in time, and the film in time without one or
// more of its parts.
//
//   static        at rest in the static state
//   contact rest  at rest in contact, by Ono and Yamane's characteristic (film_equilibria.h)
//   wave answer   the motion about the static state that the waves of the disk excite (linear_motion.h)
//   small motion  the same, with the air bearing modes that the start excites
//   springs       two lumped springs fitted to the film, with the contact's characteristic (spring_fit.h)
//   parts         the film in time without one of its parts: its own law (film.motion), a rough disk, contact,
//                 adhesion, roll; on fewer grid lines; with larger steps
//   sums          the film in time without several of these parts
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case.h"
#include "core/case_files/case_settings.h"

namespace touchdown {

struct AdvisorTask {
    Case start;
    double tolerance = 0.01;           // of the mean spacing [-]
    double spreadTolerance = 0.1;      // of the spread, or of `tolerance` times the mean spacing where that is more [-]
    double pilot = 0.3;                // smallest part of the run that the full model computes [-]
    bool confirm = false;              // run the full model and the advice to the end
    bool all = false;                  // also measure models that take too long to be advised
    double budget = 3600.0;            // wall time after which the study ends with the results it has [s]
    std::vector<std::string> models{}; // to try: "static", ...; empty: all. Sums are built from parts, which are tried
};

enum class CandidateKind : std::uint8_t { Full, Static, ContactRest, WaveAnswer, SmallMotion, Springs, Part, Sum };
inline std::string_view name(CandidateKind kind)
{
    constexpr std::array<std::string_view, 8> names{"full",         "static",  "contact-rest", "wave-answer",
                                                    "small-motion", "springs", "parts",        "sums"};
    static_assert(names.size() == static_cast<std::size_t>(CandidateKind::Sum) + 1);
    return names[static_cast<std::size_t>(kind)];
}

/// What can be left out of a film's run.
struct ModelPart {
    std::string name;      // "disk flat"
    std::string leavesOut; // "the disk's surface"
    std::vector<CaseSetting> settings;
    std::string family; // at most one part of a family is left out; grids are one family
};

struct Candidate {
    CandidateKind kind = CandidateKind::Full;
    std::string name;
    std::string leavesOut;
    std::vector<ModelPart> parts;
    Case c; // the case to run; of a model without a film in time the case of its film
    bool inTime() const { return kind == CandidateKind::Part || kind == CandidateKind::Sum; }
};

/// Models without a film in time, on the grid of the case and on coarser ones, and models without one part that the
/// case has. `roll`: of the static state, at which the roll is held where it is left out [rad].
std::vector<Candidate> candidatesOf(const AdvisorTask& task, double roll);
/// The film without all these parts. None with fewer than two parts, and where the case is not valid.
std::optional<Candidate> sumOf(const AdvisorTask& task, const std::vector<ModelPart>& parts);

} // namespace touchdown
