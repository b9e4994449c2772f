// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_branches.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "core/simulation/equilibria/film_equilibria.h"
#include "core/simulation/equilibria/parametric_balance.h"

namespace touchdown {

namespace {

using Vector = Eigen::VectorXd;

constexpr double newton = 1e-5;      // last change of x and p; the error after it is smaller by its square [-]
constexpr double onBranch = 0.03;    // distance of an equilibrium from a branch to which it belongs [-]
constexpr double smallGrowth = 0.05; // of that on both sides of a crossing, at the crossing [-]
constexpr double looksShare = 0.1;   // of the work [-]

class BranchTrace {
public:
    BranchTrace(const CaseAt& caseAt, double from, double to, const std::function<bool(double)>& told)
        : told_(told), goOn_([this] { return ask(); }), balance_(caseAt, from, to, goOn_), from_(from), to_(to)
    {}

    EquilibriumBranches trace(int looks)
    {
        const std::vector<ParametricBalance::Look> all = balance_.look(looks, result_.problems);
        share_ = looksShare;
        const auto done = [&] { share_ += 0.5 * (1.0 - looksShare) / static_cast<double>(all.size()); };
        for (const ParametricBalance::Look& look : all) {
            if (look.flies && ask()) follow({look.p, placeOf(look.rest), ContactRegion::Apart});
            done();
        }
        for (const ParametricBalance::Look& look : all) {
            if (ask()) seekTouching(look);
            done();
        }
        result_.stopped = !ask();
        result_.resolved = balance_.resolved();
        return std::move(result_);
    }

private:
    struct Seed {
        double p;
        Vector3 q;
        ContactRegion region;
    };
    struct Traced {
        ContactRegion region;
        std::vector<std::pair<Vector, double>> places; // x, p
    };

    bool ask()
    {
        if (!result_.stopped && told_ && !told_(share_)) result_.stopped = true;
        return !result_.stopped;
    }

    Vector3 placeOf(const Attitude& a) const
    {
        return {a.height + 0.5 * balance_.sliderLength() * a.pitch, a.pitch, a.roll};
    }

    void seekTouching(const ParametricBalance::Look& look)
    {
        balance_.leave();
        const std::unique_ptr<FilmBalance> balance = balance_.balanceAt(look.p);
        if (!ask()) return;
        if (!balance || !balance->solve(placeOf(look.rest), goOn_)) {
            ++result_.givenUp;
            return;
        }
        const TouchingPlaces places = touchingPlaces(*balance, look.rest, {}, goOn_);
        if (places.givenUp > 0 && ask()) ++result_.givenUp;
        for (const TouchingPlace& place : places.found) follow({look.p, place.q, place.region});
    }

    /// The branch through an equilibrium, and those into which it continues at kinks.
    void follow(const Seed& first)
    {
        std::deque<Seed> seeds{first};
        while (!seeds.empty() && ask()) {
            const Seed seed = seeds.front();
            seeds.pop_front();
            balance_.leave();
            const std::unique_ptr<FilmBalance> balance = balance_.balanceAt(seed.p);
            if (!balance) continue;
            const Vector x = balance_.toScaled(seed.q, balance->unknowns());
            if (!isKnown(seed.region, x, seed.p)) followLaw(seed, x, seeds);
        }
    }

    bool isKnown(ContactRegion region, const Vector& x, double p) const
    {
        for (const Traced& each : traced_) {
            if (each.region != region) continue;
            for (std::size_t i = 0; i < each.places.size(); ++i) {
                const auto& [xa, pa] = each.places[i];
                const auto& [xb, pb] = each.places[std::min(i + 1, each.places.size() - 1)];
                const double share = pb != pa ? std::clamp((p - pa) / (pb - pa), 0.0, 1.0) : 0.0;
                if (std::abs(std::lerp(pa, pb, share) - p) < onBranch && (x - xa - share * (xb - xa)).norm() < onBranch)
                    return true;
            }
        }
        return false;
    }

    /// `near`: the seed's place.
    void followLaw(const Seed& seed, const Vector& near, std::deque<Seed>& seeds)
    {
        const ContactRegion region = seed.region;
        ContinuationProblem problem;
        problem.linearise = [this, region](const Vector& x, double p, ContinuationProblem::Linearised& at) {
            return balance_.linearise(x, p, region, at);
        };
        problem.tests = [this, region](const Vector& x, double p) {
            return std::vector{growthOf(balance_.describe(x, p, region))};
        };
        problem.guards = [this, region](const Vector& x, double p) { return balance_.distances(x, p, region); };
        const ContinuationOptions options{.firstStep = 0.03,
                                          .shortestStep = 1e-4,
                                          .longestStep = 0.12,
                                          .tolerance = newton,
                                          .locatedTo = branchesLocatedTo,
                                          .mostPoints = 400};
        // A static state was found on a grid of its own: only its place on this one tells whether it is known.
        Vector first = near;
        const bool solved = solveAt(problem, first, seed.p, newton);
        if (solved && isKnown(region, first, seed.p)) return;
        if (!solved) first = near;
        const Branch back = followBranch(problem, first, seed.p, false, options, goOn_);
        const bool closed = back.end == BranchEnd::Closed;
        if (!back.points.empty())
            balance_.followRatesOf(balance_.describe(back.points.front().x, back.points.front().p, region));
        const Branch forth = closed || !ask() ? Branch{} : followBranch(problem, first, seed.p, true, options, goOn_);

        EquilibriumBranch branch{.contact = region};
        Traced traced{region, {}};
        const auto add = [&](const BranchPoint& point) {
            branch.points.push_back(balance_.describe(point.x, point.p, region));
            traced.places.emplace_back(point.x, point.p);
        };
        for (auto point = back.points.rbegin(); point != back.points.rend() && ask(); ++point) add(*point);
        for (std::size_t i = back.points.empty() ? 0 : 1; i < forth.points.size() && ask(); ++i) add(forth.points[i]);
        if (!ask()) return;
        if (branch.points.empty()) {
            ++result_.endsLost;
            return;
        }
        result_.branches.push_back(std::move(branch));
        traced_.push_back(std::move(traced));
        addMarks(back, region, seeds);
        if (!closed) addMarks(forth, region, seeds);
    }

    static double growthOf(const Equilibrium& point)
    {
        return point.eigenvalues.empty() ? -1.0 : point.eigenvalues.front().real();
    }

    void addMarks(const Branch& branch, ContactRegion region, std::deque<Seed>& seeds)
    {
        for (const BranchMark& mark : branch.marks) {
            const auto at = [&](std::size_t i) {
                return balance_.describe(branch.points[i].x, branch.points[i].p, region);
            };
            const Equilibrium here = at(mark.point);
            if (mark.fold())
                add(EquilibriumMark::Fold, here);
            else if (!here.eigenvalues.empty() && mark.point > 0 && mark.point + 1 < branch.points.size()) {
                // Where another oscillation takes the lead, or one is lost, the growth jumps and crosses nothing.
                const double most =
                    std::max(std::abs(growthOf(at(mark.point - 1))), std::abs(growthOf(at(mark.point + 1))));
                if (std::abs(growthOf(here)) < smallGrowth * most) add(EquilibriumMark::Hopf, here);
            }
        }
        if (branch.end == BranchEnd::Lost || branch.end == BranchEnd::TooLong) ++result_.endsLost;
        if (branch.end == BranchEnd::Guard && branch.guard < 2) addSwitch(branch, region, seeds);
    }

    void addSwitch(const Branch& branch, ContactRegion region, std::deque<Seed>& seeds)
    {
        const BranchPoint& end = branch.points.back();
        const std::optional<ParametricBalance::Crossing> crossing =
            balance_.cross(end.x, end.p, region, branch.guard == 1);
        if (!crossing) return;
        const FilmBalance::Beyond& beyond = crossing->beyond;
        const Equilibrium here = balance_.describe(end.x, end.p, region);
        if (beyond.jumps)
            add(EquilibriumMark::Switch, here, beyond.name);
        else if (beyond.kinks)
            add(EquilibriumMark::Kink, here, beyond.name);
        if (!beyond.jumps) seeds.push_back({end.p, crossing->q, beyond.region});
    }

    void add(EquilibriumMark kind, const Equilibrium& at, std::string title = {})
    {
        // Two branches that meet at a kink both end there.
        const auto same = [&](const MarkedEquilibrium& mark) {
            return mark.kind == kind &&
                   std::abs(mark.at.spacing - at.spacing) < 10.0 * branchesLocatedTo * balance_.length() &&
                   std::abs(mark.at.parameter - at.parameter) < 10.0 * branchesLocatedTo * std::abs(to_ - from_);
        };
        if (std::ranges::any_of(result_.marks, same)) return;
        result_.marks.push_back({kind, at, title.empty() ? std::string(name(kind)) : std::move(title)});
    }

    const std::function<bool(double)>& told_;
    const std::function<bool()> goOn_;
    ParametricBalance balance_;
    double from_, to_;
    double share_ = 0.0;
    std::vector<Traced> traced_;
    EquilibriumBranches result_;
};

} // namespace

EquilibriumBranches traceFilmBranches(const CaseAt& caseAt, double from, double to, int looks,
                                      const std::function<bool(double)>& goOn)
{
    return BranchTrace(caseAt, from, to, goOn).trace(std::max(looks, 2));
}

} // namespace touchdown
