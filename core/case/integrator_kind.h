// SPDX-License-Identifier: GPL-3.0-or-later
//
// The integrators of the spring model. Only for files that name one: a new integrator compiles these.
#pragma once

#include <cstdint>

namespace touchdown {

enum class IntegratorKind : std::uint8_t { Rk4, Rk4Events, Newmark, Dopri5, Cvode };

/// The others choose their steps by the error.
constexpr bool hasFixedStep(IntegratorKind kind)
{
    return kind != IntegratorKind::Dopri5 && kind != IntegratorKind::Cvode;
}

} // namespace touchdown
