// SPDX-License-Identifier: GPL-3.0-or-later
//
// The laws of adhesion of core/physics/contact/adhesion.h. Only for files that name one.
#pragma once

#include <cstdint>

namespace touchdown {

enum class AdhesionKind : std::uint8_t { None, LennardJones, VanDerWaals };

} // namespace touchdown
