// SPDX-License-Identifier: GPL-3.0-or-later
//
// Branches of equilibria, each followed in both directions from a place where one was found, with its marks: the same
// for springs and film. A `Balance` is G(x, p) = 0, p in shares of its range, under one law of contact. It provides
//
//   Law                      the laws that hold along a branch; branchUnder(law) is an empty branch
//   options                  of the continuation (core/numerics/continuation.h)
//   onBranch, alongParameter distances in x and p up to which an equilibrium belongs to a known branch [-]
//   startAt(seed)            its x; none where the case is not valid
//   refine(x, p, law)        moves x onto G = 0 where the seed was found on another grid; false: x stays
//   linearise, distances     G with its derivatives; the distances from the ends of the law
//   describe(x, p, law)      the equilibrium there
//   testOf(equilibrium)      changes its sign at a Hopf point; isHopf() excludes other reasons
//   cross(branch, law)       what happens at the end of a law at which a branch ends
//   turnBack(equilibrium)    the branch is followed the other way from there
//   sameMark(a, b)           whether two marks are one
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/numerics/continuation.h"
#include "core/simulation/equilibria/equilibrium.h"

namespace touchdown {

template <class Law>
struct BranchSeed {
    double p; // in shares of its range
    Vector3 q;
    Law law;
};

/// The end of a branch where its law switches.
template <class Law>
struct LawCrossing {
    std::string name;                      // "touch-down"
    bool jumps;                            // the force
    bool kinks;                            // its slope
    std::optional<BranchSeed<Law>> next{}; // under the law beyond, where the branch is to be followed on
};

template <class Balance>
class BranchTrace {
public:
    using Vector = Eigen::VectorXd;
    using Law = typename Balance::Law;
    using Seed = BranchSeed<Law>;

    /// Both must last.
    BranchTrace(Balance& balance, const std::function<bool()>& goOn) : balance_(balance), goOn_(goOn) {}

    /// The branch through an equilibrium, and those into which it continues. Returns how many had no point.
    int follow(const Seed& first)
    {
        int lost = 0;
        std::deque<Seed> seeds{first};
        while (!seeds.empty() && goOn_()) {
            const Seed seed = seeds.front();
            seeds.pop_front();
            std::optional<Vector> x = balance_.startAt(seed);
            if (!x || isKnown(seed.law, *x, seed.p)) continue;
            if (balance_.refine(*x, seed.p, seed.law) && isKnown(seed.law, *x, seed.p)) continue;
            if (!followLaw(seed, *x, seeds)) ++lost;
        }
        return lost;
    }

    EquilibriumBranches result;

private:
    struct Traced {
        Law law;
        std::vector<std::pair<Vector, double>> places; // x, p
    };

    bool isKnown(const Law& law, const Vector& x, double p) const
    {
        for (const Traced& each : traced_) {
            if (!(each.law == law)) continue;
            for (std::size_t i = 0; i < each.places.size(); ++i) {
                const auto& [xa, pa] = each.places[i];
                const auto& [xb, pb] = each.places[std::min(i + 1, each.places.size() - 1)];
                const double share = pb != pa ? std::clamp((p - pa) / (pb - pa), 0.0, 1.0) : 0.0;
                if (std::abs(std::lerp(pa, pb, share) - p) < Balance::alongParameter &&
                    (x - xa - share * (xb - xa)).norm() < Balance::onBranch)
                    return true;
            }
        }
        return false;
    }

    /// False where it has no point.
    bool followLaw(const Seed& seed, const Vector& x, std::deque<Seed>& seeds)
    {
        const Law law = seed.law;
        ContinuationProblem problem;
        problem.linearise = [&](const Vector& at, double p, ContinuationProblem::Linearised& out) {
            return balance_.linearise(at, p, law, out);
        };
        problem.tests = [&](const Vector& at, double p) {
            return std::vector{balance_.testOf(balance_.describe(at, p, law))};
        };
        problem.guards = [&](const Vector& at, double p) { return balance_.distances(at, p, law); };
        const Branch back = followBranch(problem, x, seed.p, false, Balance::options, goOn_);
        const bool closed = back.end == BranchEnd::Closed;
        if (!back.points.empty())
            balance_.turnBack(balance_.describe(back.points.front().x, back.points.front().p, law));
        const Branch forth =
            closed || !goOn_() ? Branch{} : followBranch(problem, x, seed.p, true, Balance::options, goOn_);

        EquilibriumBranch branch = balance_.branchUnder(law);
        Traced traced{law, {}};
        const auto add = [&](const BranchPoint& point) {
            branch.points.push_back(balance_.describe(point.x, point.p, law));
            traced.places.emplace_back(point.x, point.p);
        };
        for (auto point = back.points.rbegin(); point != back.points.rend() && goOn_(); ++point) add(*point);
        for (std::size_t i = back.points.empty() ? 0 : 1; i < forth.points.size() && goOn_(); ++i) add(forth.points[i]);
        if (!goOn_()) return true;
        if (branch.points.empty()) return false;
        result.branches.push_back(std::move(branch));
        traced_.push_back(std::move(traced));
        addMarks(back, law, seeds);
        if (!closed) addMarks(forth, law, seeds);
        return true;
    }

    void addMarks(const Branch& branch, const Law& law, std::deque<Seed>& seeds)
    {
        const auto at = [&](std::size_t i) { return balance_.describe(branch.points[i].x, branch.points[i].p, law); };
        for (const BranchMark& mark : branch.marks) {
            if (mark.fold())
                add(EquilibriumMark::Fold, at(mark.point));
            else if (balance_.isHopf(branch, mark.point, at))
                add(EquilibriumMark::Hopf, at(mark.point));
        }
        if (branch.end == BranchEnd::Lost || branch.end == BranchEnd::TooLong) ++result.endsLost;
        if (branch.end != BranchEnd::Guard) return;
        const std::optional<LawCrossing<Law>> crossing = balance_.cross(branch, law);
        if (!crossing) return;
        if (crossing->jumps)
            add(EquilibriumMark::Switch, at(branch.points.size() - 1), crossing->name);
        else if (crossing->kinks)
            add(EquilibriumMark::Kink, at(branch.points.size() - 1), crossing->name);
        if (!crossing->jumps && crossing->next) seeds.push_back(*crossing->next);
    }

    void add(EquilibriumMark kind, const Equilibrium& at, std::string title = {})
    {
        // Two branches that meet at a kink both end there.
        const auto same = [&](const MarkedEquilibrium& mark) {
            return mark.kind == kind && balance_.sameMark(mark.at, at);
        };
        if (std::ranges::any_of(result.marks, same)) return;
        result.marks.push_back({kind, at, title.empty() ? std::string(name(kind)) : std::move(title)});
    }

    Balance& balance_;
    const std::function<bool()>& goOn_;
    std::vector<Traced> traced_;
};

} // namespace touchdown
