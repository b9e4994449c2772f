// SPDX-License-Identifier: GPL-3.0-or-later
//
// The defaults that differ from model to model, when a case changes its model: a film has three degrees of freedom and
// no contact law unless it is asked for, springs have two and the characteristic of Ono and Yamane.
#pragma once

#include <functional>

#include "core/case/parameters.h"

namespace touchdown {

/// Each parameter of `c` that still has the default of the model `before` takes that of the model of `c`, but for those
/// that are `stated`. Returns whether any changed.
bool takeModelDefaults(Case& c, ModelKind before, const std::function<bool(const Parameter&)>& stated);

} // namespace touchdown
