// SPDX-License-Identifier: GPL-3.0-or-later
//
// The small slider held by menisci alone, for tests of its branches of equilibria.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "core/case/contact_kind.h"
#include "core/simulation/equilibria/film_branches.h"
#include "core/simulation/equilibria/film_equilibria.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/touching_places.h"
#include "tests/support/small_slider.h"

namespace touchdown::test {

inline const std::function<bool()> always = [] { return true; };

/// The small slider without roll on a grid that is the same at every attitude.
inline Case smallCase()
{
    Case c = smallSlider(33);
    c.degreesOfFreedom = 2;
    c.film.grid = GridKind::Graded;
    c.steady.stiffness = false;
    c.contact = ContactKind::OnoYamane;
    return c;
}

inline const MarkedEquilibrium* markOf(const EquilibriumBranches& all, EquilibriumMark kind)
{
    const auto found = std::ranges::find(all.marks, kind, &MarkedEquilibrium::kind);
    return found == all.marks.end() ? nullptr : &*found;
}

/// Menisci from 6 nm to 1 nm below the static spacing, without asperities: nothing but them acts in contact.
inline Case withMenisci(double spacing, TakeOffShape shape)
{
    Case c = smallCase();
    c.onoYamane = {.meniscusForce = 1e-3,
                   .contactStiffness = 0.0,
                   .initialContactForce = 0.0,
                   .touchDown = spacing - 6e-9,
                   .takeOff = spacing - 1e-9,
                   .friction = 0.0,
                   .takeOffShape = shape};
    return c;
}

/// Where the film holds the slider against a constant force of menisci [m], above d_s; by a search at this force alone.
inline std::optional<double> spacingUnder(double force, double spacing, const SteadyResult& rest)
{
    Case c = withMenisci(spacing, TakeOffShape::Constant);
    c.onoYamane.meniscusForce = force;
    c.onoYamane.takeOff = spacing + 1e-9;
    const std::unique_ptr<FilmBalance> made = FilmBalance::make(c, rest.grid, rest.gaps, rest.attitude, always);
    FilmBalance& balance = *made;
    balance.level().gaps.pad.pad<double>(rest.pressure, balance.level().pressure);
    const TouchingPlaces places = touchingPlaces(balance, rest.attitude, always);
    for (const TouchingPlace& place : places.found)
        if (balance.spacing(place.q) > c.onoYamane.touchDown) return balance.spacing(place.q);
    return std::nullopt;
}

} // namespace touchdown::test
