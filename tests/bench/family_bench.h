// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors, stated errors and times of static films over a family of sliders drawn at random
// (tests/support/random_slider.h), by the study `convergence`: the net force at a fixed attitude, then the minimum
// spacing in flight. References are extrapolated from the finest grid and two coarser ones. The errors are reported for
// all sliders, for those with ridges narrower than a cell of the default grid (core/physics/slider/edge_ridges.h), and
// for those without.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

/// KEY=VALUE of the program, with their defaults: sliders=10, seed=1 (of the first one; the others follow),
/// grids=97,193,385, reference=1537 (its finest grid), jobs=1 (references at a time), attitude=both (or fixed, flying),
/// ridges=any (with, without: draws until there are so many of them), methods=all (or ours), each=no (yes: a line for
/// each run), write= (a folder: writes the sliders and two files of studies there, and computes nothing). Returns an
/// exit code.
int benchmarkFamily(const std::vector<std::string>& settings);

} // namespace touchdown
