// SPDX-License-Identifier: GPL-3.0-or-later
//
// The study of a film over its grid, as its file writes it:
//
//   kind = "convergence"
//   case = "film_pico"
//   cases = ["another.toml"]        # further sliders, whose errors are summarized together; may be left out
//   fixed_attitude = true           # the net force at the initial attitude; false: the minimum spacing in flight
//   grids = ["49", "97", "193"]     # lines in each direction
//   reference = 385
//   established = true              # also the established program's manner
//
//   [[method]]                      # beside the case's own; default: power-law on a uniform grid
//   name = "upwind"
//   set = { "film.scheme" = "upwind" }
#pragma once

#include "core/studies/convergence/film_convergence.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

FilmConvergenceTask readFilmConvergence(StudyReader& reader);
StudyForm filmConvergenceForm(const Case& c);

} // namespace touchdown
