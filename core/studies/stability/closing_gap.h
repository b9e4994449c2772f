// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pressure in a gap that closes, by slip model. An infinitely wide wedge, from 100 nm down to the disk, which it
// touches, in the case's air at the speed of its disk. Nothing flows out where the gap closes, so that dp/dx = 6 mu
// U/(Q h^2). Without a second-order term (first order, Fukui-Kaneko) the pressure grows without bound as the gap falls
// (Wu & Bogy 2003), and a result on a grid depends on the grid. A term c Kn^2 in Q keeps Q h^2 above c (lambda0
// p0/p)^2, so that over a length x 1/p falls by no more than 6 mu U x/(c lambda0^2 p0^2). The pressure stays bounded
// where the length on which that term dominates is short against this, as with the angle chosen here; on much flatter
// wedges it may not.
//
// With first order p goes with h^-s, s = mu U/(lambda0 p0 angle). Chosen: the angle with s = 0.9, some hundredths, as
// on the flank of an asperity.
#pragma once

#include <functional>

namespace touchdown {

struct Case;
struct StudyReport;

/// Adds a chart, the table "closing_gap" and sentences for a case of model "film". False where `goOn`, asked for each
/// slip model, said so.
bool addClosingGap(const Case& c, StudyReport& picture, const std::function<bool()>& goOn = {});

} // namespace touchdown
