// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kept distances and symmetries as rows of one list: the distances first, then the symmetries.
#pragma once

#include <string>
#include <vector>

#include <QTreeWidgetItem>

#include "core/case/case.h"
#include "core/physics/slider/surface_relations.h"

namespace touchdown {

/// Whether the list of parts reads the same for both: where corners are is shown in the table alone, unless a relation
/// may be broken.
bool sameRows(const AirBearingSurface& one, const AirBearingSurface& other);

std::size_t relationCount(const AirBearingSurface& surface);
/// The relation of a row that exists.
SurfacePart relationAt(const AirBearingSurface& surface, std::size_t row);
/// The row of a relation; the number of any other part.
std::size_t rowOf(const AirBearingSurface& surface, const SurfacePart& part);

/// The key of the number of a distance; a symmetry has none.
std::string relationKey(const AirBearingSurface& surface, std::size_t row);
/// What is kept, and what is wrong with it.
QString relationCaption(const Case& c, std::size_t row);
/// In the colour of a failure where something is wrong; `problems` are relationProblems() of the surface.
void fillRelation(QTreeWidgetItem& item, const AirBearingSurface& surface, std::size_t row,
                  const std::vector<SurfaceProblem>& problems);

} // namespace touchdown
