// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the slip models make of a gap that closes. An infinitely wide wedge, from 100 nm down to the disk, which it
// touches, in the case's air at the speed of its disk: where the gap closes nothing passes, so that dp/dx = 6 mu U/(Q
// h^2). Without a second-order term, first order and Fukui-Kaneko, the pressure grows as the gap falls, without end (Wu
// & Bogy 2003), and what a grid shows of it is the grid's. A term c Kn^2 in Q keeps Q h^2 above c (lambda0 p0/p)^2, so
// that a stretch x lowers 1/p by no more than 6 mu U x/(c lambda0^2 p0^2): the pressure stays bounded where the stretch
// on which that term leads is short against it, as with the angle taken here; on much flatter wedges it need not.
//
// With first order p goes with h^-s, s = mu U/(lambda0 p0 angle). The angle is ours: that for which s = 0.9, some
// hundredths, as an asperity's flank has it.
#pragma once

#include <functional>

namespace touchdown {

struct Case;
struct StudyReport;

/// Adds a chart, the table "closing_gap" and sentences for a case of model "film". False where `goOn`, asked for each
/// slip model, said so.
bool addClosingGap(const Case& c, StudyReport& picture, const std::function<bool()>& goOn = {});

} // namespace touchdown
