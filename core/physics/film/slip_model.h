// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slip models of core/physics/film/slip.h. Only for files that name one: a new model compiles these.
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
