// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a change of the attitude changes in a film at constant pressure, where the surface of the disk follows it, as
// under an elastic contact. Otherwise GasFilm and FilmLoads know these derivatives.
#pragma once

#include <array>
#include <vector>

namespace touchdown {

/// By height of the trailing edge [m], pitch, roll [rad]; padded, as GasFilm::attitudeColumns.
struct FilmSlopes {
    std::array<std::vector<double>, 3> flow;       // dR
    std::array<std::vector<double>, 3> storage;    // of these, by the storage per time
    std::array<std::array<double, 3>, 5> forces{}; // of load and shear, as FilmLoads::Derivatives::byAttitude
};

} // namespace touchdown
