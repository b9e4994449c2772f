// SPDX-License-Identifier: GPL-3.0-or-later
//
// What follows a choice that was made by hand. The defaults that differ from model to model, when a case changes its
// model: a film has three degrees of freedom and no contact law unless it is asked for, springs have two and the
// characteristic of Ono and Yamane. And where a film starts, and what an uneven disk needs at least.
#pragma once

#include <functional>

#include "core/case/parameters.h"

namespace touchdown {

/// Each parameter of `c` that still has the default of the model `before` takes that of the model of `c`, but for those
/// that are `stated`. Returns whether any changed.
bool takeModelDefaults(Case& c, ModelKind before, const std::function<bool(const Parameter&)>& stated);

/// A case that has become a film, with the attitude that a case starts with by default, starts at its static one: the
/// former may lie in the disk. Returns whether it did.
bool takeFilmStart(Case& c);

/// A disk that has become uneven gets a first wave or a first bump where it has none, so that it can run: a wave of
/// 0.5 nm and 100 um, a smooth bump of 5 nm and 10 um. Returns whether it did.
bool takeFirstUnevenness(Case& c);

} // namespace touchdown
