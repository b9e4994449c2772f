// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_equilibria.h"

#include <Eigen/LU>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "core/case/contact_law.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/touching_places.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr double rateTolerance = 1e-5; // of an eigenvalue [-]

} // namespace

SteadyResult staticStateOf(const Case& c, const std::function<bool()>& goOn)
{
    Case still = attitudeCase(c);
    still.diskSurface = {};
    return steady(still, [&](const SteadyProgress&) { return goOn(); });
}

Equilibrium describeEquilibrium(FilmBalance& balance, ContactRegion region, std::span<const std::complex<double>> near,
                                const std::function<bool()>& goOn)
{
    Equilibrium at{.q = balance.place()};
    at.spacing = balance.spacing(balance.place());
    at.touching = region != ContactRegion::Apart;
    at.netContactForce = at.touching ? balance.netContactForce(region) : 0.0;
    SmallMotions motions(balance.level(), balance.body(), balance.contactStiffness(region));
    motions.ask(goOn);
    for (const SmallMotions::Mode& mode : motions.find(
             rateTolerance, [&](std::size_t) { return goOn(); }, near))
        at.eigenvalues.push_back(mode.rate);
    std::ranges::sort(at.eigenvalues, std::greater{}, [](std::complex<double> s) { return s.real(); });
    at.lost = static_cast<int>(balance.unknowns()) - static_cast<int>(at.eigenvalues.size());
    const Matrix3 still = balance.stiffnessWithSprings(region, goOn);
    const bool diverges =
        (balance.unknowns() == 3 ? still.determinant() : still(0, 0) * still(1, 1) - still(0, 1) * still(1, 0)) < 0.0;
    const bool grows = !at.eigenvalues.empty() && at.eigenvalues.front().real() > 0.0;
    at.stability = diverges ? Stability::Divergence : grows ? Stability::Flutter : Stability::Stable;
    return at;
}

std::string reasonForNoFilmEquilibria(const Case& c)
{
    if (c.model != ModelKind::Film) return "is no case of model \"film\"";
    if (!characteristic(c))
        return "equilibria of a film are sought with contact \"ono-yamane\" alone; the contact of surfaces depends on "
               "how it was reached";
    return {};
}

FilmEquilibria filmEquilibria(const Case& c, const std::function<bool()>& goOn)
{
    const TeamScope team(filmThreads(c));
    FilmEquilibria result;
    const SteadyResult rest = staticStateOf(c, goOn);
    result.stopped = rest.status == SteadyStatus::Cancelled;
    if (result.stopped) return result;
    // Where the film alone would balance below the disk's mean plane, contact may carry the rest.
    if (!rest.balanced()) {
        result.problem = "there is no static state of the film: " + rest.message;
        return result;
    }
    const std::unique_ptr<FilmBalance> made = FilmBalance::make(c, rest.grid, rest.gaps, rest.attitude, goOn);
    if (!made) return result.stopped = true, result;
    FilmBalance& balance = *made;
    balance.level().gaps.pad.pad<double>(rest.pressure, balance.level().pressure);
    const auto add = [&](ContactRegion region) {
        result.found.push_back(describeEquilibrium(balance, region, {}, goOn));
        if (!goOn()) result.found.pop_back();
    };
    if (rest.status == SteadyStatus::Converged && rest.minimumSpacing > characteristic(c)->touchDown &&
        balance.solve(balance.body().coordinates(rest.attitude), goOn))
        add(ContactRegion::Apart);
    const TouchingPlaces touching = touchingPlaces(balance, rest.attitude, goOn);
    for (const TouchingPlace& place : touching.found)
        if (balance.solve(place.q, goOn)) add(place.region);
    result.stopped = !goOn();
    return result;
}

} // namespace touchdown
