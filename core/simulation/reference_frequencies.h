// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frequencies that a case has before any run, to compare with the peaks of its spectra:
//
//   mode      springs: small motions about the static state without contact, f = Im s/(2 pi) with the eigenvalues s of
//             the motion (simulation/equilibria/spring_equilibria.h); lowest first
//   contact   Ono and Yamane's law. Springs: the highest such f with the law of a pressed pad, the air springs as at
//             the static state; the mass at the pad is then that of slider and pitch, with friction. A film:
//             sqrt(k_c/M)/(2 pi)
//   wave      waves of a disk that moves under the slider, f = |U cos b + V sin b|/l, with the velocity (U, V) of the
//   disk
//             under the slider's centre, in the order of the case
//
// The modes of a film need a solution: simulation/static_state/steady.h, modes(). Overdamped motions have none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchdown {

struct Case;

enum class FrequencyKind : std::uint8_t { Mode, Contact, Wave };

struct ReferenceFrequency {
    FrequencyKind kind = FrequencyKind::Mode;
    double frequency = 0.0; // [Hz], > 0
    std::string name;       // "mode 1", "contact", "wave", or "wave 2" of several
    bool operator==(const ReferenceFrequency&) const = default;
};

/// `c` must be valid. Empty for a pad, whose motion is given.
std::vector<ReferenceFrequency> referenceFrequencies(const Case& c);

} // namespace touchdown
