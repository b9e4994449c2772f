// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motions of a study of forced motion: the way up and down, and motions that other starts reach.
//
// The first motion starts as the case says. It is followed from one frequency to the next (followed_motion.h). Where
// it ends, the slider is left to settle from its last state a little beyond the end. The motion that it reaches is
// followed back to the end, which gives the amplitudes on both sides there. They differ at a jump; at a period
// doubling, for example, they do not.
//
// A motion on which neither way comes by is found only from another start. These starts are spread over the
// frequencies. One in four is the static state at rest. Where there is a contact, another one is at rest with the pad
// at the height at which contact begins. The others are drawn about the static state: height, pitch and their rates in
// a drawn direction, with a size from the amplitude a of the waves to 30 a, or to twice the distance of the contact
// where that is more. Motions with a narrow range of starts or frequencies may still be missed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/studies/response/response_result.h"

namespace touchdown {

/// Both ways; `done` is called with each point, its place in ResponseResult::points and the small motions there.
using PointDone =
    std::function<void(std::size_t, const ResponsePoint&, const std::optional<std::complex<double>>& linear)>;
/// The jumps on both ways.
std::vector<ResponseJump> sweepBothWays(const ResponseTask& task, const PointDone& done);

/// The place of the frequency of a start, from 0 to task.starts - 1.
std::size_t placeOfStart(const ResponseTask& task, int start);
/// The motion that this start reaches.
ForcedMotion motionOfStart(const ResponseTask& task, int start);
enum class StartKind : std::uint8_t { AtRest, AtContact, Drawn };
StartKind kindOfStart(const ResponseTask& task, int start);
/// How many other motions are followed at most.
inline constexpr std::size_t mostOthers = 8;
/// Follows those of these motions that are on neither way, as far as they exist; adds them and their jumps.
void addOthers(const ResponseTask& task, const std::vector<ForcedMotion>& ofStarts, ResponseResult& result);

} // namespace touchdown
