// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the law of a slider's contact switches within a step. The law in force holds for an interval of the separation
// d. A step that leaves it is repeated with a length at which d is within a given width beyond the switch, found by
// secants.
#pragma once

#include <optional>

#include "core/simulation/flight/film_point.h"

namespace touchdown {

class SliderContact;

/// Time from `begin` to the first switch before `end`, at least `shortest` [s]; none: the law holds to the end.
/// Switches are located within `width` [m].
std::optional<double> wayToSwitch(const SliderContact& contact, const SliderBody& body, const FilmPoint& begin,
                                  const FilmPoint& end, double width, double shortest);

/// A tried end of a step, seen from the switch that is nearest to it.
struct SwitchAim {
    bool upper = false; // of the two ends of the law's interval
    bool reached = false;
    double miss = 0.0; // separation less the wanted one, half of the width beyond the switch [m]
    double rate = 0.0; // of the separation, by the step's length; 0 where nothing moves [m/s]
};
SwitchAim aimAtSwitch(const SliderContact& contact, const SliderBody& body, const SliderMotion& begin,
                      const SliderMotion& tried, double dt, double width);

} // namespace touchdown
