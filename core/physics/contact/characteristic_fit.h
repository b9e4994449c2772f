// SPDX-License-Identifier: GPL-3.0-or-later
//
// The five parameters of the simplified characteristic (core/physics/contact/ono_yamane.h) that best describe the
// full multi-asperity model over one approach and retraction, and the quality of the fit:
//
//   d_s, d_e    where the menisci form and break: at the jump with the largest change of F_m, or, without a jump,
//               where F_m passes half its largest value
//   k_c, f_c0   least squares of F_cr over d <= d_s, both ways
//   f_m         so that a cycle takes the same work out of the slider as the model's loop; without hysteresis
//               (d_e = d_s) the largest adhesion
//   shape       the one whose F_cr and F_m fit best, by the mean square of their errors
//
// The characteristic describes the model if nowhere on the way, jumps included, the error of F_m exceeds a tenth of
// the largest adhesion, or the error of F_cr a tenth of the largest contact force.
#pragma once

#include "core/physics/contact/ono_yamane.h"

namespace touchdown {

class MultiAsperity;

/// From beyond the model's reach, or from `start` if that is farther, to `closest`, which is less [m].
CharacteristicFit fitCharacteristic(const MultiAsperity& model, double start, double closest,
                                    const OnoYamane& rest = {});

} // namespace touchdown
