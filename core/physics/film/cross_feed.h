// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where along a path the flow across it enters or leaves. The complete flux scheme needs the change of the flow along a
// path, and knows the net flow across of whole cells. In a cell with an edge or a wall that flow is not spread evenly:
// it takes the deep side, where rarefied air is conducted as h^2 (the molecules' mean free path longer than the gap).
// So each piece of a path gets its part of the cell's in proportion to h^2, at most four times the even one. Evenly
// spread, it starves the shallow side of slanted walls: errors of several per cent with opposite signs along x and y.
#pragma once

namespace touchdown {

struct FilmGaps;

/// Sets lead and feed of all pieces of paths.
void setCrossFeed(FilmGaps& gaps);

} // namespace touchdown
