// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a design study shall change and reach, as TOML:
//
//   [[parameter]]
//   key = "abs.rail[3].width"       # see core/studies/runs/design_key.h; keys = [...] change by the same amount
//   start = "0.5 mm"                # default: the value of the case
//   minimum = "0.2 mm"
//   maximum = "0.9 mm"
//
//   [[target]]
//   quantity = "minimum_spacing"    # of core/simulation/static_state/steady_quantities.h
//   value = "3.2 nm"
//   tolerance = "0.01 nm"
//
//   [search]
//   iterations = 30
//   difference = 0.01
//
// Without any parameter and target the preload is searched with which the slider flies at its initial height; where the
// attitude is held, the height at which the film carries the preload.
#pragma once

#include "core/studies/design/design.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

inline constexpr std::size_t mostParameters = 20;
inline constexpr std::size_t mostTargets = 20;

/// Adds what is wrong to the reader's problems; of use only where there is none.
DesignTask readDesignTask(StudyReader& reader);

} // namespace touchdown
