// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/spring_equilibria.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/equilibria/branch_trace.h"

namespace touchdown {

namespace {

using Mode = SpringModel::Mode;
using Point = Eigen::Vector2d;
using Vector = Eigen::VectorXd;

constexpr double difference = 1e-4;      // of p, for dF/dp, in shares of its range
constexpr double sameSpringMarks = 1e-6; // distance of two that are one, in model scales and in the range of p [-]
constexpr double sameForce = 1e-7;       // of forces on both sides of a switch, in model scales [-]
constexpr double sameSlope = 1e-9;       // of their slopes [-]
constexpr double realCrossing = 1e-7; // by which a real part changes across a Hopf point, of the largest eigenvalue [-]

Eigen::Map<const Eigen::VectorXcd> asVector(const std::vector<std::complex<double>>& values)
{
    return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// The springs' balance over p in shares of its range: 0 at `from`, 1 at `to`. x: z and theta in model scales.
class TracedSprings {
public:
    using Law = Mode;
    static constexpr ContinuationOptions options{};
    static constexpr double onBranch = 0.01, alongParameter = 1e-9; // [-]

    TracedSprings(const CaseAt& caseAt, double from, double to) : caseAt_(caseAt), from_(from), to_(to) {}

    double parameter(double p) const { return std::lerp(from_, to_, p); }

    std::optional<SpringModel> modelAt(double p) const
    {
        const std::optional<Case> c = caseAt_(parameter(p));
        if (!c) return std::nullopt;
        return SpringModel(*c);
    }

    /// Scales are those of the model in the middle of the range, or of the first one that is valid.
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

    std::optional<Vector> startAt(const BranchSeed<Mode>& seed) const
    {
        return Vector(seed.q.head<2>().cwiseQuotient(scale_));
    }
    bool refine(const Vector&, double, Mode) const { return false; }
    void turnBack(const Equilibrium&) const {}
    static EquilibriumBranch branchUnder(Mode mode) { return {mode.contact, mode.frontSpring, mode.rearSpring}; }
    static double testOf(const Equilibrium& at) { return hopfTest(asVector(at.eigenvalues)); }
    bool sameMark(const Equilibrium& a, const Equilibrium& b) const
    {
        return (a.q - b.q).head<2>().cwiseQuotient(scale_).norm() < sameSpringMarks &&
               std::abs(a.parameter - b.parameter) < sameSpringMarks * std::abs(to_ - from_);
    }

    Point toPlace(const Vector& x) const { return Point(x[0] * scale_[0], x[1] * scale_[1]); }
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

    Equilibrium describe(const Vector& x, double p, Mode mode) const
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

    /// Without damping every pair stands on the axis, and rounding alone changes the test's sign.
    template <class At>
    bool isHopf(const Branch& branch, std::size_t point, const At& at) const
    {
        const std::vector<std::complex<double>> values = at(point).eigenvalues;
        if (!isCrossingPair(asVector(values))) return false;
        const auto pairs = [&](std::size_t i) { // real parts of the pair that is nearest to the one that crosses
            const std::vector<std::complex<double>> all = at(i).eigenvalues;
            std::complex<double> crossing = values[0];
            for (const auto& value : values)
                if (value.imag() != 0.0 && std::abs(value.real()) < std::abs(crossing.real())) crossing = value;
            return std::ranges::min(all, {}, [&](const auto& value) { return std::abs(value - crossing); }).real();
        };
        double largest = 0.0;
        for (const auto& value : values) largest = std::max(largest, std::abs(value));
        const std::size_t next = std::min(point + 1, branch.points.size() - 1);
        return std::abs(pairs(next) - pairs(point - 1)) > realCrossing * largest;
    }

    /// Beyond it the equilibria are found by themselves.
    std::optional<LawCrossing<Mode>> cross(const Branch& branch, Mode mode) const
    {
        const BranchPoint& last = branch.points.back();
        const std::optional<SpringModel> model = modelAt(std::clamp(last.p, 0.0, 1.0));
        if (!model) return {};
        const std::vector<GuardEnd> ends = guardEnds(*model, mode);
        if (static_cast<std::size_t>(branch.guard) >= ends.size()) return {}; // too deep
        const GuardEnd end = ends[static_cast<std::size_t>(branch.guard)];
        const Mode beyond = model->beyond(mode, end.guard, end.upper);
        const Point q = toPlace(last.x);
        const Eigen::Matrix2d before = slope(*model, q, mode), after = slope(*model, q, beyond);
        return LawCrossing<Mode>{.name = model->eventName(end.guard, mode, beyond),
                                 .jumps = (force(*model, q, beyond) - force(*model, q, mode)).norm() > sameForce,
                                 .kinks = (after - before).norm() > sameSlope * before.norm()};
    }

private:
    const CaseAt& caseAt_;
    double from_, to_;
    Point scale_{1.0, 1.0}, forceScale_{1.0, 1.0};
};

} // namespace

EquilibriumBranches traceSpringEquilibria(const CaseAt& caseAt, double from, double to, int looks,
                                          const std::function<bool(double)>& goOn)
{
    looks = std::max(looks, 2);
    double share = 0.0;
    bool stopped = false;
    const std::function<bool()> ask = [&] { return !(stopped = stopped || (goOn && !goOn(share))); };
    TracedSprings springs(caseAt, from, to);
    BranchTrace<TracedSprings> trace(springs, ask);
    if (!springs.setScales(looks)) return {};
    for (int k = 0; k < looks && ask(); ++k) {
        share = double(k) / (looks - 1);
        const std::optional<SpringModel> model = springs.modelAt(share);
        if (!model) continue;
        for (const FoundEquilibrium& found : springEquilibria(*model))
            trace.follow({share, {found.q[0], found.q[1], 0.0}, found.mode});
    }
    trace.result.stopped = stopped;
    return std::move(trace.result);
}

} // namespace touchdown
