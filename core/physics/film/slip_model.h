// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slip models, with Q(Kn) in the symbols of core/physics/film/slip.h. Only for files that name one: a new model
// compiles these.
//
//   continuum            1
//   first order          1 + 6 a Kn                      Burgdorfer 1959
//   second order         1 + 6 Kn + 6 Kn^2               Hsia & Domoto 1983
//   1.5 order            1 + 6 a Kn + (8/3) Kn^2         Mitsuya 1993
//   Fukui-Kaneko         6 Q_P(D)/D                      Fukui & Kaneko 1988, 1990: kinetic values, or their fit
//   new first order      1 + 4 a Kn                      Wu & Bogy 2003
//   new second order     1 + 4 a Kn + 3 Kn^2             Wu & Bogy 2003
//   combination          Fukui-Kaneko above a gap of 0.3 nm, new second order below (Chen & Bogy, section 2); a hard
//                        switch, as there, or blended over a given width
#pragma once

#include <cstdint>

namespace touchdown {

enum class SlipModel : std::uint8_t {
    Continuum,
    FirstOrder,
    SecondOrder,
    OnePointFiveOrder,
    FukuiKaneko,    // from the kinetic values
    FukuiKanekoFit, // the published fit, with its jumps at D = 5 and 0.15
    NewFirstOrder,
    NewSecondOrder,
    Combination,
};

} // namespace touchdown
