// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that contradict each other in model "contact" and in the contact under a film.
#pragma once

#include "core/case/parameters.h"

#include <vector>

namespace touchdown {

/// Cells of the patch, without the conditions from the surface of the disk.
void checkPatch(const Case& c, std::vector<CaseProblem>& problems);

void checkContact(const Case& c, std::vector<CaseProblem>& problems);

/// Contact and disk of a slider that flies.
void checkFilmContact(const Case& c, std::vector<CaseProblem>& problems);

/// The surface of the disk alone.
void checkDiskSurface(const DiskSurface& surface, std::vector<CaseProblem>& problems);
/// The same under a slider that flies, where it may move with the disk.
void checkMovingDisk(const Case& c, std::vector<CaseProblem>& problems);

/// d_e >= d_s, wherever the simplified characteristic is used.
void checkCharacteristic(const Case& c, std::vector<CaseProblem>& problems);
/// W < 0 (core/physics/contact/ono_yamane.h).
void warnOfCreatedEnergy(const OnoYamane& parameters, std::vector<CaseProblem>& warnings);

} // namespace touchdown
