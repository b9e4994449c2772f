// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_equilibria.h"

#include <Eigen/LU>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "core/case/contact_kind.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

constexpr int mostIterations = 25;     // of Newton
constexpr int mostHalvings = 8;        // of one of its steps
constexpr double longestStep = 3e-9;   // of the slider's corners in one of its steps [m]
constexpr double apart = 1e-11;        // of two equilibria, at the slider's corners [m]
constexpr double rateTolerance = 1e-5; // of an eigenvalue [-]

class TouchingSearch {
public:
    TouchingSearch(FilmBalance& balance, const std::function<bool()>& goOn) : balance_(balance), goOn_(goOn) {}

    TouchingPlaces search(const std::vector<Attitude>& starts)
    {
        const std::vector<double> still = balance_.level().pressure;
        for (const Attitude& start : starts) {
            if (!goOn_()) break;
            balance_.level().pressure = still;
            if (!refine(balance_.body().coordinates(start))) ++result_.givenUp;
        }
        balance_.level().pressure = still;
        return std::move(result_);
    }

private:
    /// With the law of the take-off branch at q. False where the search gave up; true without an equilibrium near q.
    bool refine(Vector3 q)
    {
        if (!balance_.solve(q, goOn_)) return false;
        const auto region = [&] { return balance_.regionOn(ContactBranch::TakeOff); };
        Vector3 g = balance_.force(region());
        for (int k = 0; k < mostIterations; ++k) {
            if (!goOn_()) return false;
            if (balance_.error(g) <= balance_.setup().steady.loadTolerance) {
                if (region() != ContactRegion::Apart) add(q, region());
                return true;
            }
            const Vector3 change = balance_.newtonStep(balance_.stiffness(region(), goOn_), g);
            double share = std::min(1.0, longestStep / std::max(balance_.body().displacement(change), 1e-300));
            const std::vector<double> before = balance_.level().pressure;
            bool better = false, solved = false;
            for (int halving = 0; halving < mostHalvings && !better; ++halving, share *= 0.5) {
                const Vector3 tried = q + share * change;
                balance_.level().pressure = before;
                if (!balance_.solve(tried, goOn_)) {
                    if (!goOn_()) return false;
                    continue;
                }
                solved = true;
                const Vector3 there = balance_.force(region());
                better = balance_.error(there) < balance_.error(g);
                if (!better) continue;
                q = tried;
                g = there;
            }
            if (!better) return solved;
        }
        return false;
    }

    void add(const Vector3& q, ContactRegion region)
    {
        for (const TouchingPlace& other : result_.found)
            if (balance_.body().displacement(other.q - q) < apart) return;
        result_.found.push_back({q, balance_.lowest(region)});
    }

    FilmBalance& balance_;
    const std::function<bool()>& goOn_;
    TouchingPlaces result_;
};

} // namespace

SteadyResult staticStateOf(const Case& c, const std::function<bool()>& goOn)
{
    Case still = attitudeCase(c);
    still.diskSurface = {};
    return steady(still, [&](const SteadyProgress&) { return goOn(); });
}

TouchingPlaces touchingPlaces(FilmBalance& balance, const Attitude& rest, const std::vector<Attitude>& near,
                              const std::function<bool()>& goOn)
{
    const OnoYamane& law = balance.setup().onoYamane;
    const double spacing = balance.spacing(balance.body().coordinates(rest));
    std::vector<Attitude> starts = near;
    for (const double target : {law.touchDown, 0.5 * (law.touchDown + law.takeOff), 0.6 * law.touchDown}) {
        Attitude lowered = rest;
        lowered.height += target - spacing;
        starts.push_back(lowered);
    }
    return TouchingSearch(balance, goOn).search(starts);
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
    if (c.contact != ContactKind::OnoYamane)
        return "equilibria of a film are sought with contact \"ono-yamane\" alone; the contact of surfaces depends on "
               "how it was reached";
    return {};
}

FilmEquilibria filmEquilibria(const Case& c, const std::vector<Attitude>& near, const std::function<bool()>& goOn)
{
    FilmEquilibria result;
    const SteadyResult rest = staticStateOf(c, goOn);
    result.stopped = rest.status == SteadyStatus::Cancelled;
    if (result.stopped) return result;
    // Where the film alone would balance below the disk's mean plane, contact may carry the rest.
    const bool balanced = rest.balanced();
    if (!balanced) {
        result.problem = "there is no static state of the film: " + rest.message;
        return result;
    }
    const std::unique_ptr<FilmBalance> made = FilmBalance::make(c, rest.grid, rest.attitude, goOn);
    if (!made) return result.stopped = true, result;
    FilmBalance& balance = *made;
    balance.level().gaps.pad.pad<double>(rest.pressure, balance.level().pressure);
    result.resolved = resolvedFrequency(c, rest.grid);
    const auto add = [&](ContactRegion region) {
        const Equilibrium& at = result.found.emplace_back(describeEquilibrium(balance, region, {}, goOn));
        result.lost += at.lost;
        if (!goOn()) result.found.pop_back();
    };
    if (rest.status == SteadyStatus::Converged && rest.minimumSpacing > c.onoYamane.touchDown &&
        balance.solve(balance.body().coordinates(rest.attitude), goOn))
        add(ContactRegion::Apart);
    const TouchingPlaces touching = touchingPlaces(balance, rest.attitude, near, goOn);
    result.givenUp = touching.givenUp;
    for (const TouchingPlace& place : touching.found)
        if (balance.solve(place.q, goOn)) add(place.region);
    result.stopped = !goOn();
    return result;
}

} // namespace touchdown
