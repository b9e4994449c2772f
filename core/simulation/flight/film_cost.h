// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of a film run took, as figures of its summary.
#pragma once

namespace touchdown {

struct CoupledCost;
struct Summary;

void addFigures(const CoupledCost& cost, Summary& summary);

} // namespace touchdown
