// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film_rate.h"

#include <cmath>

namespace touchdown {

double fastestFilmRate(const GasFilm& film)
{
    constexpr int mostIterations = 1000;
    constexpr double settled = 1e-6; // change of the rate in one iteration, against it
    const PaddedGrid& pad = film.pad();
    std::vector<double> v(pad.size(), 0.0), image(pad.size(), 0.0);
    FaceFlows<double> work;
    work.resize(pad.size());
    // Neighbours with opposite signs, as what diffuses fastest has; and a little of everything.
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) v[pad.at(i, j)] = ((i + j) % 2 == 0 ? 1.0 : -1.0) + 0.1 * std::sin(1.0 + i + 3.0 * j);
    double rate = 0.0;
    for (int n = 0; n < mostIterations; ++n) {
        film.applyJacobian<double>(v, image, work, 0.0);
        double before = 0.0, after = 0.0;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j);
                const double volume = film.volumes()[at];
                const double next = volume > 0.0 ? image[at] / volume : 0.0;
                before += v[at] * v[at];
                after += next * next;
                v[at] = next;
            }
        if (!(after > 0.0) || !(before > 0.0)) return 0.0;
        const double last = rate;
        rate = std::sqrt(after / before);
        const double scale = 1.0 / std::sqrt(after);
        for (double& each : v) each *= scale;
        if (n > 20 && std::abs(rate - last) < settled * rate) break;
    }
    return rate;
}

} // namespace touchdown
