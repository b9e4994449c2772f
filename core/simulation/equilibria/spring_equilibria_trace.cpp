// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/spring_equilibria.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/continuation.h"

namespace touchdown {

namespace {

using Mode = SpringModel::Mode;
using Point = Eigen::Vector2d;
using Vector = Eigen::VectorXd;

constexpr double difference = 1e-4;     // of p, for dF/dp, in shares of its range
constexpr double onSpringBranch = 0.01; // distance of an equilibrium from its branch, in model scales [-]
constexpr double sameForce = 1e-7;      // of forces on both sides of a switch, in model scales [-]
constexpr double sameSlope = 1e-9;      // of their slopes [-]
constexpr double realCrossing = 1e-7; // by which a real part changes across a Hopf point, of the largest eigenvalue [-]

Eigen::Map<const Eigen::VectorXcd> asVector(const std::vector<std::complex<double>>& values)
{
    return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// Follows branches over p in shares of its range: 0 at `from`, 1 at `to`.
class EquilibriaTrace {
public:
    EquilibriaTrace(const CaseAt& caseAt, double from, double to, const std::function<bool(double)>& goOn)
        : caseAt_(caseAt), from_(from), to_(to), goOn_(goOn)
    {}

    EquilibriumBranches trace(int looks)
    {
        if (!setScales(looks)) return std::move(result_);
        for (int k = 0; k < looks && !result_.stopped; ++k) {
            const double p = double(k) / (looks - 1);
            share_ = p;
            const std::optional<SpringModel> model = modelAt(p);
            if (!model) continue;
            for (const FoundEquilibrium& found : springEquilibria(*model)) {
                if (!goOn()) break;
                if (!isKnown(found, p)) addBranch(found, p);
            }
            if (!goOn()) break;
        }
        return std::move(result_);
    }

private:
    bool goOn()
    {
        if (!result_.stopped && goOn_ && !goOn_(share_)) result_.stopped = true;
        return !result_.stopped;
    }

    double parameter(double p) const { return std::lerp(from_, to_, p); }

    std::optional<SpringModel> modelAt(double p) const
    {
        const std::optional<Case> c = caseAt_(parameter(p));
        if (!c) return std::nullopt;
        return SpringModel(*c);
    }

    /// Those of the model in the middle of the range, or of the first one that is valid.
    bool setScales(int looks)
    {
        std::optional<SpringModel> model = modelAt(0.5);
        for (int k = 0; k < looks && !model; ++k) model = modelAt(double(k) / (looks - 1));
        if (!model) return false;
        const SpringModel::State s = model->scale();
        scale_ = s.head<2>();
        forceScale_ = s.tail<2>() * (s[2] / s[0]);
        return true;
    }

    Point toPlace(const Vector& x) const { return Point(x[0] * scale_[0], x[1] * scale_[1]); }
    Vector toScaled(const Point& q) const { return q.cwiseQuotient(scale_); }
    Point force(const SpringModel& model, const Point& q, Mode mode) const
    {
        return model.derivative({q[0], q[1], 0.0, 0.0}, mode).tail<2>().cwiseQuotient(forceScale_);
    }
    Eigen::Matrix2d slope(const SpringModel& model, const Point& q, Mode mode) const
    {
        const Eigen::Matrix2d stiffness = model.jacobian({q[0], q[1], 0.0, 0.0}, mode).leftCols<2>();
        return forceScale_.cwiseInverse().asDiagonal() * stiffness * scale_.asDiagonal();
    }

    /// Beyond the ends of the range, where the case need not be valid, F continues along its slope.
    bool linearise(const Vector& x, double p, Mode mode, ContinuationProblem::Linearised& at) const
    {
        const double inside = std::clamp(p, 0.0, 1.0);
        const double low = std::max(0.0, inside - difference), high = std::min(1.0, inside + difference);
        const std::optional<SpringModel> here = modelAt(inside), below = modelAt(low), above = modelAt(high);
        if (!here || !below || !above) return false;
        const Point q = toPlace(x);
        at.byParameter = (force(*above, q, mode) - force(*below, q, mode)) / (high - low);
        at.residual = force(*here, q, mode) + at.byParameter * (p - inside);
        at.byState = slope(*here, q, mode);
        return at.residual.allFinite() && at.byState.allFinite() && at.byParameter.allFinite();
    }

    struct GuardEnd {
        int guard;
        bool upper;
    };
    std::vector<GuardEnd> guardEnds(const SpringModel& model, Mode mode) const
    {
        std::vector<GuardEnd> ends;
        for (int guard = 0; guard < SpringModel::guardCount; ++guard) {
            const Interval holds = model.interval(guard, mode);
            if (std::isfinite(holds.lower)) ends.push_back({guard, false});
            if (std::isfinite(holds.upper)) ends.push_back({guard, true});
        }
        return ends;
    }
    std::vector<double> distances(const Vector& x, double p, Mode mode) const
    {
        std::vector<double> list;
        const std::optional<SpringModel> model = modelAt(std::clamp(p, 0.0, 1.0));
        if (!model) return list;
        const SpringModel::Guards guards = model->guards(toPlace(x));
        for (const GuardEnd& end : guardEnds(*model, mode)) {
            const Interval holds = model->interval(end.guard, mode);
            list.push_back((end.upper ? holds.upper - guards[end.guard] : guards[end.guard] - holds.lower) / scale_[0]);
        }
        list.push_back(guards.minCoeff() / scale_[0] + deepest);
        return list;
    }

    Equilibrium equilibrium(const Vector& x, double p, Mode mode) const
    {
        const Point q = toPlace(x);
        Equilibrium at{.parameter = parameter(p), .q = {q[0], q[1], 0.0}};
        const std::optional<SpringModel> model = modelAt(std::clamp(p, 0.0, 1.0));
        if (!model) return at;
        at.spacing = model->guards(q)[SpringModel::Pad];
        at.touching = mode.contact != ContactRegion::Apart;
        at.eigenvalues = eigenvaluesAt(*model, q, mode);
        at.stability = stabilityOf(at.eigenvalues);
        return at;
    }

    bool isKnown(const FoundEquilibrium& found, double p) const
    {
        const double value = parameter(p);
        const double slack = 1e-9 * std::abs(to_ - from_);
        for (const EquilibriumBranch& branch : result_.branches) {
            if (Mode{branch.frontSpring, branch.rearSpring, branch.contact} != found.mode) continue;
            for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
                const Equilibrium &a = branch.points[i], &b = branch.points[i + 1];
                const double least = std::min(a.parameter, b.parameter), most = std::max(a.parameter, b.parameter);
                if (value < least - slack || value > most + slack) continue;
                const double share =
                    most > least ? std::clamp((value - a.parameter) / (b.parameter - a.parameter), 0.0, 1.0) : 0.5;
                const Point between = (a.q + share * (b.q - a.q)).head<2>();
                if ((found.q - between).cwiseQuotient(scale_).norm() < onSpringBranch) return true;
            }
        }
        return false;
    }

    void addBranch(const FoundEquilibrium& found, double p)
    {
        const Mode mode = found.mode;
        ContinuationProblem problem;
        problem.linearise = [this, mode](const Vector& x, double at, ContinuationProblem::Linearised& out) {
            return linearise(x, at, mode, out);
        };
        problem.tests = [this, mode](const Vector& x, double at) {
            return std::vector{hopfTest(asVector(equilibrium(x, at, mode).eigenvalues))};
        };
        problem.guards = [this, mode](const Vector& x, double at) { return distances(x, at, mode); };
        const ContinuationOptions options;
        const auto ask = [this] { return goOn(); };
        const Branch back = followBranch(problem, toScaled(found.q), p, false, options, ask);
        const bool closed = back.end == BranchEnd::Closed;
        const Branch forth = closed ? Branch{} : followBranch(problem, toScaled(found.q), p, true, options, ask);

        EquilibriumBranch branch{mode.contact, mode.frontSpring, mode.rearSpring};
        for (auto point = back.points.rbegin(); point != back.points.rend(); ++point)
            branch.points.push_back(equilibrium(point->x, point->p, mode));
        for (std::size_t i = back.points.empty() ? 0 : 1; i < forth.points.size(); ++i)
            branch.points.push_back(equilibrium(forth.points[i].x, forth.points[i].p, mode));
        if (branch.points.empty()) return;
        result_.branches.push_back(std::move(branch));
        addMarks(back, mode);
        if (!closed) addMarks(forth, mode);
    }

    void addMarks(const Branch& branch, Mode mode)
    {
        for (const BranchMark& mark : branch.marks) {
            const BranchPoint& at = branch.points[mark.point];
            const Equilibrium here = equilibrium(at.x, at.p, mode);
            if (mark.fold())
                add(EquilibriumMark::Fold, here);
            else if (isHopf(branch, mark, mode))
                add(EquilibriumMark::Hopf, here);
        }
        if (branch.end == BranchEnd::Lost || branch.end == BranchEnd::TooLong) ++result_.endsLost;
        if (branch.end == BranchEnd::Guard) addSwitch(branch, mode);
    }

    /// Without damping every pair stands on the axis, and rounding alone changes the test's sign.
    bool isHopf(const Branch& branch, const BranchMark& mark, Mode mode) const
    {
        const auto eigenvalues = [&](std::size_t i) {
            return equilibrium(branch.points[i].x, branch.points[i].p, mode).eigenvalues;
        };
        const std::vector<std::complex<double>> values = eigenvalues(mark.point);
        if (!isCrossingPair(asVector(values))) return false;
        const auto pairs = [&](std::size_t i) { // real parts of the pair that is nearest to the one that crosses
            const std::vector<std::complex<double>> all = eigenvalues(i);
            std::complex<double> crossing = values[0];
            for (const auto& value : values)
                if (value.imag() != 0.0 && std::abs(value.real()) < std::abs(crossing.real())) crossing = value;
            return std::ranges::min(all, {}, [&](const auto& value) { return std::abs(value - crossing); }).real();
        };
        double largest = 0.0;
        for (const auto& value : values) largest = std::max(largest, std::abs(value));
        const std::size_t next = std::min(mark.point + 1, branch.points.size() - 1);
        return std::abs(pairs(next) - pairs(mark.point - 1)) > realCrossing * largest;
    }

    void addSwitch(const Branch& branch, Mode mode)
    {
        const BranchPoint& last = branch.points.back();
        const std::optional<SpringModel> model = modelAt(std::clamp(last.p, 0.0, 1.0));
        if (!model) return;
        const std::vector<GuardEnd> ends = guardEnds(*model, mode);
        if (static_cast<std::size_t>(branch.guard) >= ends.size()) return; // too deep
        const GuardEnd end = ends[static_cast<std::size_t>(branch.guard)];
        const Mode beyond = model->beyond(mode, end.guard, end.upper);
        const Point q = toPlace(last.x);
        const Equilibrium here = equilibrium(last.x, last.p, mode);
        const bool jumps = (force(*model, q, beyond) - force(*model, q, mode)).norm() > sameForce;
        const Eigen::Matrix2d before = slope(*model, q, mode), after = slope(*model, q, beyond);
        if (jumps)
            add(EquilibriumMark::Switch, here, model->eventName(end.guard, mode, beyond));
        else if ((after - before).norm() > sameSlope * before.norm())
            add(EquilibriumMark::Kink, here, model->eventName(end.guard, mode, beyond));
    }

    void add(EquilibriumMark kind, const Equilibrium& at, std::string title = {})
    {
        // Two branches that meet at a kink both end there.
        const auto same = [&](const MarkedEquilibrium& mark) {
            return mark.kind == kind && (mark.at.q - at.q).head<2>().cwiseQuotient(scale_).norm() < 1e-6 &&
                   std::abs(mark.at.parameter - at.parameter) < 1e-6 * std::abs(to_ - from_);
        };
        if (std::ranges::any_of(result_.marks, same)) return;
        result_.marks.push_back({kind, at, title.empty() ? std::string(name(kind)) : std::move(title)});
    }

    const CaseAt& caseAt_;
    double from_, to_;
    const std::function<bool(double)>& goOn_;
    Point scale_{1.0, 1.0}, forceScale_{1.0, 1.0};
    double share_ = 0.0;
    EquilibriumBranches result_;
};

} // namespace

EquilibriumBranches traceSpringEquilibria(const CaseAt& caseAt, double from, double to, int looks,
                                          const std::function<bool(double)>& goOn)
{
    return EquilibriaTrace(caseAt, from, to, goOn).trace(std::max(looks, 2));
}

} // namespace touchdown
