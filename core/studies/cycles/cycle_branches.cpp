// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycle_branches.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <Eigen/LU>

#include "core/numerics/continuation.h"

namespace touchdown {

using Eigen::MatrixXd, Eigen::VectorXd;
using Multipliers = std::vector<std::complex<double>>;

namespace {

constexpr double parameterStep = 3e-6; // of the derivative by the parameter, of its range [-]
constexpr double longestReturn = 8.0;  // limit of a return, in periods of the cycle before
constexpr int mostPieces = 12;         // of one direction, between grazings
constexpr double atBound = 1e-4;       // distance from the end of the range that counts as reached [-]
constexpr std::array beyond{1e-6, 1e-5, 1e-4, 1e-3, 3e-3}; // arclengths at which a cycle is sought past a grazing
constexpr double farthestBeyond = 30.0; // distance of that cycle from the extrapolation, in such arclengths
constexpr double leastBeyond = 1e-3;    // or so far
constexpr double nearestRepeat = 1e-4;  // distance at which a cycle has met one with fewer crossings, in units of x
constexpr double alikeCycles = 2e-3;    // difference of periods and spacings of one cycle [-]
constexpr double chordError = 0.1;      // of a branch between two points, of the way between them [-]
constexpr const char* tooLarge = "the motion becomes too large for a linear film (film.linear_limit)";
enum CycleTest { DoublingTest, NeimarkSackerTest };
enum CycleGuard { SwitchGuard, RepeatGuard, ModelGuard };

const ContinuationOptions cycleContinuation{.lower = 0.0,
                                            .upper = 1.0,
                                            .firstStep = 0.002,
                                            .shortestStep = 1e-6,
                                            .longestStep = 0.03,
                                            .tolerance = 1e-10,
                                            .locatedTo = 1e-7,
                                            .mostPoints = 600};

/// Zero where a complex pair crosses the unit circle: the product of m_i m_j - 1 over all pairs. Two real multipliers
/// with the product 1 change its sign as well.
double neimarkSackerTest(const Multipliers& m)
{
    std::complex<double> product = 1.0;
    for (std::size_t i = 0; i < m.size(); ++i)
        for (std::size_t j = i + 1; j < m.size(); ++j) product *= m[i] * m[j] - 1.0;
    return product.real();
}

/// Whether the pair whose product is nearest to 1 is complex.
bool isPairOnCircle(const Multipliers& m)
{
    double least = std::numeric_limits<double>::infinity();
    bool complex = false;
    for (std::size_t i = 0; i < m.size(); ++i)
        for (std::size_t j = i + 1; j < m.size(); ++j) {
            const double distance = std::abs(m[i] * m[j] - 1.0);
            if (distance >= least) continue;
            least = distance;
            complex = m[i].imag() != 0.0;
        }
    return complex;
}

/// A part of a branch with one set of switches.
class CyclePiece {
public:
    CyclePiece(const CycleTrace& trace, int crossings, double limit)
        : trace_(trace), crossings_(crossings), limit_(limit)
    {
        problem_.linearise = [this](const VectorXd& x, double p, ContinuationProblem::Linearised& at) {
            return linearise(x, p, at);
        };
        problem_.tests = [this](const VectorXd& x, double p) -> std::vector<double> {
            const Return& at = returnOf(x, p);
            halves_ = halvesOf(at, x);
            return {(at.derivative + MatrixXd::Identity(x.size(), x.size())).determinant(),
                    neimarkSackerTest(multipliersOf(at.derivative))};
        };
        problem_.guards = [this](const VectorXd& x, double p) -> std::vector<double> {
            const Return& at = returnOf(x, p);
            return {at.switches == switches_ ? 1.0 : -1.0, distanceOfHalves(at, x), at.tooFar ? -1.0 : 1.0};
        };
    }
    CyclePiece(const CyclePiece&) = delete;

    bool solve(VectorXd& x, double p) { return solveAt(problem_, x, p, cycleContinuation.tolerance); }
    const Return& at(const VectorXd& x, double p) { return returnOf(x, p); }
    Branch follow(const VectorXd& x, double p, bool rising)
    {
        switches_ = returnOf(x, p).switches;
        return followBranch(problem_, x, p, rising, cycleContinuation, trace_.goOn);
    }
    int crossings() const { return crossings_; }
    double limit() const { return limit_; }

private:
    /// Where the branch is asked for several things at one point, it is integrated once.
    const Return& returnOf(const VectorXd& x, double p)
    {
        if (p == lastP_ && x == lastX_) return last_;
        lastX_ = x;
        lastP_ = p;
        last_ = {};
        if (const auto slider = trace_.sliderAt(trace_.value(std::clamp(p, 0.0, 1.0))))
            last_ = slider->apply(x, {.crossings = crossings_, .limit = limit_, .derivative = true});
        return last_;
    }

    bool linearise(const VectorXd& x, double p, ContinuationProblem::Linearised& at)
    {
        if (trace_.reached) trace_.reached(std::clamp(p, 0.0, 1.0));
        const Return& here = returnOf(x, p);
        if (!here.returned || !here.derivative.allFinite()) return false;
        at.byState = here.derivative - MatrixXd::Identity(x.size(), x.size());
        // Central, or one-sided at the ends of the range, beyond which the map is extrapolated: the case ends there.
        const double inside = std::clamp(p, 0.0, 1.0);
        const double before = std::max(0.0, inside - parameterStep), after = std::min(1.0, inside + parameterStep);
        const std::optional<VectorXd> low = reached(x, before), high = reached(x, after);
        if (!low || !high) return false;
        at.byParameter = (*high - *low) / (after - before);
        at.residual = here.x + (p - inside) * at.byParameter - x;
        return true;
    }

    /// The way between the two states of a cycle with an even number of crossings that are half of it apart.
    static VectorXd halvesOf(const Return& at, const VectorXd& x)
    {
        if (at.passed.size() % 2 != 0 || at.passed.empty()) return VectorXd::Zero(x.size());
        return at.passed[at.passed.size() / 2 - 1] - x;
    }

    /// It becomes zero where the cycle meets one of half its period, and beyond, the halves are exchanged: the branch
    /// would be followed back.
    double distanceOfHalves(const Return& at, const VectorXd& x) const
    {
        if (at.passed.size() % 2 != 0 || at.passed.empty()) return 1.0;
        const VectorXd halves = halvesOf(at, x);
        return halves_.size() > 0 && halves.dot(halves_) < 0.0 ? -halves.norm() : halves.norm();
    }

    std::optional<VectorXd> reached(const VectorXd& x, double p) const
    {
        const auto slider = trace_.sliderAt(trace_.value(p));
        if (!slider) return {};
        const Return there = slider->apply(x, {.crossings = crossings_, .limit = limit_});
        if (!there.returned) return {};
        return there.x;
    }

    const CycleTrace& trace_;
    int crossings_;
    double limit_; // [s]
    ContinuationProblem problem_;
    std::vector<CycleSwitch> switches_;
    VectorXd halves_; // at the last point of the branch; empty before
    VectorXd lastX_;
    double lastP_ = std::numeric_limits<double>::quiet_NaN();
    Return last_;
};

/// One direction of a branch, from its start on.
class CycleFollower {
public:
    CycleFollower(const CycleTrace& trace, const LimitCycle& start) : trace_(trace), start_(start) {}

    CycleBranch follow(bool rising)
    {
        VectorXd x = start_.x;
        double p = trace_.share(start_.value), period = start_.period;
        int crossings = start_.crossings;
        for (int k = 0; k < mostPieces; ++k) {
            CyclePiece piece(trace_, crossings, longestReturn * period);
            const Branch found = piece.follow(x, p, rising);
            const bool known = add(found, piece);
            if (!known && !branch_.points.empty()) end(CycleMark::End, tooLarge);
            if (!known) return std::move(branch_);
            closed_ = found.end == BranchEnd::Closed;
            if (branch_.points.empty() || found.points.empty() || found.end == BranchEnd::Stopped ||
                found.end == BranchEnd::Bound || closed_)
                return std::move(branch_);
            const BranchPoint& last = found.points.back();
            if (std::min(std::abs(last.p), std::abs(1.0 - last.p)) < atBound) return std::move(branch_);
            if (found.end == BranchEnd::TooLong) {
                end(CycleMark::End, "more points than are followed");
                return std::move(branch_);
            }
            if (found.end == BranchEnd::Guard && found.guard == RepeatGuard) {
                end(CycleMark::PeriodDoubling, "meets the cycle of half the period");
                return std::move(branch_);
            }
            if (found.end == BranchEnd::Guard && found.guard == ModelGuard) {
                end(CycleMark::End, tooLarge);
                return std::move(branch_);
            }
            const std::string change = changeBeyond(last, piece);
            if (change.empty()) {
                end(CycleMark::End, "no step of the continuation is short enough");
                return std::move(branch_);
            }
            end(CycleMark::Grazing, change);
            period = branch_.points.back().period;
            if (!jump(last, piece, x, p, crossings)) return std::move(branch_);
            branch_.marks.back().ends = false;
            rising = last.tangent[last.x.size()] > 0.0;
        }
        end(CycleMark::End, "more grazings than are followed");
        return std::move(branch_);
    }
    bool closed() const { return closed_; }

private:
    /// False where the branch leaves its model.
    bool add(const Branch& found, const CyclePiece& piece)
    {
        for (std::size_t i = 0; i < found.points.size(); ++i) {
            const BranchPoint& point = found.points[i];
            const double value = trace_.value(point.p);
            const auto slider = trace_.sliderAt(value);
            if (!slider) continue;
            const LimitCycle cycle = figuresOf(*slider, value, point.x, piece.crossings(), piece.limit());
            if (!(cycle.period > 0.0)) continue;
            if (cycle.tooFar) return false;
            const auto mark =
                std::ranges::find_if(found.marks, [&](const BranchMark& each) { return each.point == i; });
            branch_.points.push_back(cycle);
            if (mark == found.marks.end()) continue;
            if (mark->test == NeimarkSackerTest && !isPairOnCircle(cycle.multipliers)) continue;
            const CycleMark kind = mark->fold()                      ? CycleMark::Fold
                                   : mark->test == NeimarkSackerTest ? CycleMark::NeimarkSacker
                                                                     : CycleMark::PeriodDoubling;
            branch_.marks.push_back({kind, cycle, {}, false, branch_.points.size() - 1});
        }
        return true;
    }

    void end(CycleMark kind, const std::string& remark)
    {
        branch_.marks.push_back({kind, branch_.points.back(), remark, true, branch_.points.size() - 1});
    }

    /// The switches that appear or are lost just beyond the end of a piece; "" where they stay the same.
    std::string changeBeyond(const BranchPoint& last, CyclePiece& piece) const
    {
        const std::vector<CycleSwitch>& before = branch_.points.back().switches;
        for (const double s : beyond) {
            const VectorXd x = last.x + s * last.tangent.head(last.x.size());
            const double p = last.p + s * last.tangent[last.x.size()];
            const auto slider = trace_.sliderAt(trace_.value(p));
            if (!slider) continue;
            Return there = slider->apply(x, {.crossings = piece.crossings(), .limit = piece.limit()});
            if (!there.returned) { // flies away or is caught: later switches have no meaning
                there.switches.resize(std::min(there.switches.size(), before.size()));
                const std::string lost = firstDifference(*slider, before, there.switches);
                return lost.empty() ? "the slider does not come back" : lost;
            }
            if (there.switches == before) continue;
            return firstDifference(*slider, before, there.switches);
        }
        return {};
    }

    /// The cycle beyond a grazing, with another set of switches.
    bool jump(const BranchPoint& last, const CyclePiece& before, VectorXd& x, double& p, int& crossings) const
    {
        const std::vector<CycleSwitch> switches = branch_.points.back().switches;
        for (const double s : beyond)
            for (const int more : {0, 1, -1}) {
                const int n = before.crossings() + more;
                const double there = last.p + s * last.tangent[last.x.size()];
                if (n < 1 || there < 0.0 || there > 1.0) continue;
                CyclePiece piece(trace_, n, before.limit());
                const VectorXd guess = last.x + s * last.tangent.head(last.x.size());
                VectorXd y = guess;
                if (!piece.solve(y, there) || piece.at(y, there).switches == switches) continue;
                if (piece.at(y, there).repeats(y) < nearestRepeat) continue;
                if ((y - guess).norm() > std::max(farthestBeyond * s, leastBeyond)) continue;
                x = y;
                p = there;
                crossings = n;
                return true;
            }
        return false;
    }

    const CycleTrace& trace_;
    const LimitCycle& start_;
    CycleBranch branch_;
    bool closed_ = false;
};

} // namespace

CycleBranch traceCycle(const CycleTrace& trace, const LimitCycle& start)
{
    CycleFollower rising(trace, start);
    CycleBranch up = rising.follow(true);
    if (rising.closed()) return up;
    CycleBranch down = CycleFollower(trace, start).follow(false);
    // The way down backwards, then the way up without the start.
    CycleBranch branch;
    const std::size_t count = down.points.size();
    branch.points.assign(down.points.rbegin(), down.points.rend());
    for (auto mark = down.marks.rbegin(); mark != down.marks.rend(); ++mark) {
        mark->point = count - 1 - mark->point;
        branch.marks.push_back(std::move(*mark));
    }
    const std::size_t skipped = count > 0 && !up.points.empty() ? 1 : 0;
    branch.points.insert(branch.points.end(), up.points.begin() + std::ptrdiff_t(skipped), up.points.end());
    for (MarkedCycle& mark : up.marks) {
        mark.point += count - skipped;
        branch.marks.push_back(std::move(mark));
    }
    return branch;
}

bool liesOn(const CycleBranch& branch, const LimitCycle& cycle)
{
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
        const LimitCycle &a = branch.points[i - 1], &b = branch.points[i];
        if (std::min(a.value, b.value) > cycle.value || std::max(a.value, b.value) < cycle.value) continue;
        const double share = a.value == b.value ? 0.0 : (cycle.value - a.value) / (b.value - a.value);
        const auto between = [&](double first, double second, double own) {
            const double chord = std::lerp(first, second, share);
            return std::abs(chord - own) <=
                   alikeCycles * std::max(std::abs(chord), std::abs(own)) + chordError * std::abs(second - first);
        };
        if (between(a.period, b.period, cycle.period) && between(a.amplitude(), b.amplitude(), cycle.amplitude()) &&
            between(a.separation.most, b.separation.most, cycle.separation.most))
            return true;
    }
    return false;
}

} // namespace touchdown
