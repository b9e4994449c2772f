// SPDX-License-Identifier: GPL-3.0-or-later
//
// Free oscillations of sliders in time against the modes of the same grid, as CSV. Each mode below 1 MHz is begun with
// its shape and velocity about the static state, and the run's frequency and damping ratio are those of the sum of
// exponentials that fits its samples best. What differs is due to the steps in time: film, slider and iteration.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

/// Names of sample cases, of files or of folders of CML files; and settings: `drawn=N` adds sliders drawn at random,
/// `seed=N` the first of them; `amplitude=` of the corner that moves most [nm]; `step_errors=A,B,...` run.step_error,
/// as parts of its value in the case; all others change the cases. Without any name: film_pico, film_femto,
/// film_fig4_pico. Returns an exit code.
int benchmarkDamping(const std::vector<std::string>& casesAndSettings);

} // namespace touchdown
