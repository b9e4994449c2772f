// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/touching_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/case/contact_law.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

constexpr int mostSteps = 120;             // in all
constexpr int mostNewtonSteps = 25;        // of Newton, those that are not shortened to the longest
constexpr int mostOutside = 3;             // steps in a row that end where no contact is modelled
constexpr int mostStepHalvings = 8;        // of one of its steps
constexpr double longestNewtonStep = 3e-9; // of the slider's corners in one of its steps [m]
constexpr double samePlace = 1e-11;        // of two places, at the slider's corners [m]

class TouchingSearch {
public:
    TouchingSearch(FilmBalance& balance, ContactBranch branch, const std::function<bool()>& goOn)
        : balance_(balance), branch_(branch), goOn_(goOn)
    {}

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
    /// With the law of the branch at q. False where the search gave up; true without an equilibrium near q.
    bool refine(Vector3 q)
    {
        std::optional<ContactRegion> region = balance_.settle(q, branch_, goOn_);
        if (!region) return false;
        Vector3 g = balance_.force(*region);
        for (int k = 0, all = 0, outside = 0; k < mostNewtonSteps && all < mostSteps; ++all) {
            if (!goOn_()) return false;
            std::string problem = balance_.contact().problemAt(balance_.body().attitude(q));
            outside = problem.empty() ? 0 : outside + 1;
            if (outside == mostOutside) {
                result_.problem = std::move(problem);
                return true;
            }
            if (balance_.error(g) <= balance_.setup().steady.loadTolerance) {
                if (*region != ContactRegion::Apart) add(q, *region);
                return true;
            }
            const Vector3 change = balance_.newtonStep(balance_.stiffness(*region, goOn_), g);
            double share = std::min(1.0, longestNewtonStep / std::max(balance_.body().displacement(change), 1e-300));
            if (share == 1.0) ++k;
            const std::vector<double> before = balance_.level().pressure;
            bool better = false, solved = false;
            for (int halving = 0; halving < mostStepHalvings && !better; ++halving, share *= 0.5) {
                const Vector3 tried = q + share * change;
                balance_.level().pressure = before;
                const std::optional<ContactRegion> there = balance_.settle(tried, branch_, goOn_);
                if (!there) {
                    if (!goOn_()) return false;
                    continue;
                }
                solved = true;
                const Vector3 force = balance_.force(*there);
                better = balance_.error(force) < balance_.error(g);
                if (!better) continue;
                q = tried;
                g = force;
                region = there;
            }
            if (!better) return solved;
        }
        return false;
    }

    void add(const Vector3& q, ContactRegion region)
    {
        for (const TouchingPlace& other : result_.found)
            if (balance_.body().displacement(other.q - q) < samePlace) return;
        result_.found.push_back({q, balance_.lowest(region), branch_});
    }

    FilmBalance& balance_;
    ContactBranch branch_;
    const std::function<bool()>& goOn_;
    TouchingPlaces result_;
};

/// `rest` set down to where the contact alone carries these shares of the load, as far as it does.
std::vector<Attitude> startsByForce(FilmBalance& balance, const Attitude& rest, const std::function<bool()>& goOn)
{
    constexpr double first = 1e-9, located = 1e-10; // of the way below the contact's reach [m]
    constexpr double inside = 100e-9;               // the disk, at most [m]
    const double deepest = std::max(balance.reach(), 0.0) + inside;
    const double load = std::max(std::abs(balance.body().load()[0]), 1e-6);
    const double reached = balance.spacing(balance.body().coordinates(rest)) - balance.reach();
    std::vector<Attitude> starts;
    for (const double share : {0.03, 0.5}) {
        Attitude lowered = rest;
        const auto carries = [&](double depth) {
            lowered.height = rest.height - reached - depth;
            return balance.contact().at(lowered, 0.0).load()[0] >= share * load;
        };
        double above = 0.0, below = first;
        while (goOn() && below < deepest && !carries(below)) above = std::exchange(below, 2.0 * below);
        while (goOn() && below - above > located) {
            const double middle = 0.5 * (above + below);
            (carries(middle) ? below : above) = middle;
        }
        if (carries(below)) starts.push_back(lowered);
    }
    return starts;
}

} // namespace

TouchingPlaces touchingPlaces(FilmBalance& balance, const std::vector<Attitude>& starts, ContactBranch branch,
                              const std::function<bool()>& goOn)
{
    return TouchingSearch(balance, branch, goOn).search(starts);
}

TouchingPlaces touchingPlaces(FilmBalance& balance, const Attitude& rest, const std::function<bool()>& goOn)
{
    std::vector<Attitude> starts;
    if (const auto law = characteristic(balance.setup())) {
        const double spacing = balance.spacing(balance.body().coordinates(rest));
        for (const double target : {law->touchDown, 0.5 * (law->touchDown + law->takeOff), 0.6 * law->touchDown}) {
            Attitude lowered = rest;
            lowered.height += target - spacing;
            starts.push_back(lowered);
        }
    } else {
        starts = startsByForce(balance, rest, goOn);
    }
    return touchingPlaces(balance, starts, ContactBranch::TakeOff, goOn);
}

} // namespace touchdown
