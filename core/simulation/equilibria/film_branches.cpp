// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_branches.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/simulation/equilibria/branch_trace.h"
#include "core/simulation/equilibria/parametric_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/touching_places.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

using Vector = Eigen::VectorXd;

constexpr double newton = 1e-5;      // last change of x and p; the error after it is smaller by its square [-]
constexpr double smallGrowth = 0.05; // of that on both sides of a crossing, at the crossing [-]
constexpr double looksShare = 0.1;   // of the work [-]
constexpr double sameMarks = 10.0 * branchesLocatedTo; // distance of two that are one [-]

class TracedFilm : public ParametricBalance {
public:
    using Law = ContactRegion;
    static constexpr ContinuationOptions options{.firstStep = 0.03,
                                                 .shortestStep = 1e-4,
                                                 .longestStep = 0.12,
                                                 .tolerance = newton,
                                                 .locatedTo = branchesLocatedTo,
                                                 .mostPoints = 400};
    static constexpr double onBranch = 0.03, alongParameter = 0.03; // [-]

    using ParametricBalance::ParametricBalance;

    std::optional<Vector> startAt(const BranchSeed<Law>& seed)
    {
        leave();
        const std::unique_ptr<FilmBalance> balance = balanceAt(seed.p);
        return balance ? std::optional(toScaled(seed.q, balance->unknowns())) : std::nullopt;
    }
    /// A static state was found on a grid of its own: only its place on this one tells whether it is known.
    bool refine(Vector& x, double p, Law law)
    {
        const ContinuationProblem problem{
            .linearise = [&](const Vector& at, double there, ContinuationProblem::Linearised& out) {
                return linearise(at, there, law, out);
            }};
        Vector solved = x;
        if (!solveAt(problem, solved, p, newton)) return false;
        x = solved;
        return true;
    }
    void turnBack(const Equilibrium& from) { followRatesOf(from); }
    static EquilibriumBranch branchUnder(Law law) { return {.contact = law}; }
    static double testOf(const Equilibrium& point)
    {
        return point.eigenvalues.empty() ? -1.0 : point.eigenvalues.front().real();
    }
    /// Where another oscillation takes the lead, or one is lost, the growth jumps and crosses nothing.
    template <class At>
    static bool isHopf(const Branch& branch, std::size_t point, const At& at)
    {
        const Equilibrium here = at(point);
        if (here.eigenvalues.empty() || point == 0 || point + 1 >= branch.points.size()) return false;
        const double most = std::max(std::abs(testOf(at(point - 1))), std::abs(testOf(at(point + 1))));
        return std::abs(testOf(here)) < smallGrowth * most;
    }
    std::optional<LawCrossing<Law>> cross(const Branch& branch, Law law)
    {
        if (branch.guard > 1) return {}; // the disk
        const BranchPoint& end = branch.points.back();
        const std::optional<Crossing> crossing = ParametricBalance::cross(end.x, end.p, law, branch.guard == 1);
        if (!crossing) return {};
        const FilmBalance::Beyond& beyond = crossing->beyond;
        return LawCrossing<Law>{beyond.name, beyond.jumps, beyond.kinks, {{end.p, crossing->q, beyond.region}}};
    }
    bool sameMark(const Equilibrium& a, const Equilibrium& b) const
    {
        return std::abs(a.spacing - b.spacing) < sameMarks * length() &&
               std::abs(a.parameter - b.parameter) < sameMarks * std::abs(parameter(1.0) - parameter(0.0));
    }
};

} // namespace

EquilibriumBranches traceFilmBranches(const CaseAt& caseAt, double from, double to, int looks,
                                      const std::function<bool(double)>& goOn)
{
    const std::optional<Case> first = caseAt(from);
    const TeamScope team(first ? filmThreads(*first) : 1);
    double share = 0.0;
    bool stopped = false;
    const std::function<bool()> ask = [&] { return !(stopped = stopped || (goOn && !goOn(share))); };
    TracedFilm film(caseAt, from, to, ask);
    BranchTrace<TracedFilm> trace(film, ask);
    EquilibriumBranches& result = trace.result;
    const std::vector<ParametricBalance::Look> all = film.look(std::max(looks, 2), result.problems);
    share = looksShare;
    const auto done = [&] { share += 0.5 * (1.0 - looksShare) / static_cast<double>(all.size()); };
    const auto placeOf = [&](const Attitude& a) {
        return Vector3(a.height + 0.5 * film.sliderLength() * a.pitch, a.pitch, a.roll);
    };
    const auto seekTouching = [&](const ParametricBalance::Look& look) {
        film.leave();
        const std::unique_ptr<FilmBalance> balance = film.balanceAt(look.p);
        if (!ask()) return;
        if (!balance || !balance->solve(placeOf(look.rest), ask)) {
            ++result.givenUp;
            return;
        }
        const TouchingPlaces places = touchingPlaces(*balance, look.rest, ask);
        if (places.givenUp > 0 && ask()) ++result.givenUp;
        for (const TouchingPlace& place : places.found)
            result.endsLost += trace.follow({look.p, place.q, place.region});
    };
    for (const ParametricBalance::Look& look : all) {
        if (look.flies && ask()) result.endsLost += trace.follow({look.p, placeOf(look.rest), ContactRegion::Apart});
        done();
    }
    for (const ParametricBalance::Look& look : all) {
        if (ask()) seekTouching(look);
        done();
    }
    result.stopped = !ask();
    result.resolved = film.resolved();
    return std::move(result);
}

} // namespace touchdown
