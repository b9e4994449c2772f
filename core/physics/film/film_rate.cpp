// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_rate.h"

#include <algorithm>
#include <cmath>

#include "core/physics/film/gas_film.h"

namespace touchdown {

double fastestFilmRate(const GasFilm& film)
{
    const PaddedGrid& pad = film.pad();
    double rate = 0.0;
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double volume = film.volumes()[at];
            if (!(volume > 0.0)) continue;
            double own = 0.0, others = 0.0;
            for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
                const FilmFaces& faces = film.faces()[axis];
                const std::size_t beyond = at + pad.step(static_cast<int>(axis));
                const int place = axis == 0 ? i : j, last = (axis == 0 ? pad.nx : pad.ny) - 1;
                own += faces.lower[beyond] - faces.upper[at];
                if (place > 0) others += std::abs(faces.lower[at]);
                if (place < last) others += std::abs(faces.upper[beyond]);
            }
            rate = std::max(rate, (std::abs(own) + others) / volume);
        }
    return rate;
}

} // namespace touchdown
