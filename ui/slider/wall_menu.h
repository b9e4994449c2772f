// SPDX-License-Identifier: GPL-3.0-or-later
//
// A menu to choose the wall of an edge: each profile as a small picture.
#pragma once

#include <functional>
#include <optional>

#include <QMenu>

#include "core/physics/slider/surface_edit.h"

namespace touchdown {

/// Fills the menu with "none", the walls of the surface, of which `current` is marked, and "new wall…"; `choose` gets
/// the number of the wall, 0 for none, one more than there are for a new one.
void fillWallMenu(QMenu& menu, const AirBearingSurface& surface, std::optional<int> current,
                  const std::function<void(int)>& choose);

/// The wall that all these edges, and all edges of these rails, have; nothing where they differ or there are none.
std::optional<int> commonWall(const AirBearingSurface& surface, const PartSelection& parts);

/// With this wall on these parts. A number beyond the last is a new wall from the recess of the first rail to the base.
AirBearingSurface withChosenWall(AirBearingSurface surface, const PartSelection& parts, int wall);

} // namespace touchdown
