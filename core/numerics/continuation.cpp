// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/continuation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace touchdown {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr int mostIterations = 12;    // of Newton
constexpr double straightest = 0.995; // cosine between tangents at the ends of a step
constexpr int fewIterations = 4;      // after so few the step may grow
constexpr int mostLocations = 80;

/// x of A x = b by elimination with partial pivoting; not finite where A is singular. Eigen's decompositions of
/// matrices of any size take some 20 s to compile.
Vector solved(Matrix a, Vector b)
{
    const Eigen::Index n = b.size();
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::Index pivot = k;
        for (Eigen::Index i = k + 1; i < n; ++i)
            if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
        for (Eigen::Index j = k; j < n; ++j) std::swap(a(k, j), a(pivot, j));
        std::swap(b[k], b[pivot]);
        for (Eigen::Index i = k + 1; i < n; ++i) {
            const double factor = a(i, k) / a(k, k);
            for (Eigen::Index j = k + 1; j < n; ++j) a(i, j) -= factor * a(k, j);
            b[i] -= factor * b[k];
        }
    }
    for (Eigen::Index k = n; k-- > 0;) {
        for (Eigen::Index j = k + 1; j < n; ++j) b[k] -= a(k, j) * b[j];
        b[k] /= a(k, k);
    }
    return b;
}

class BranchFollower {
public:
    BranchFollower(const ContinuationProblem& problem, const ContinuationOptions& options)
        : problem_(problem), options_(options)
    {}

    Branch follow(Vector x, double p, bool rising, const std::function<bool()>& goOn)
    {
        Branch branch;
        if (!solveAt(problem_, x, p, options_.tolerance)) return branch;
        Vector up = Vector::Zero(x.size() + 1);
        up[x.size()] = rising ? 1.0 : -1.0;
        std::optional<BranchPoint> first = pointAt(joined(x, p), up);
        if (!first) return branch;
        setTests(*first);
        branch.points.push_back(*first);
        double step = options_.firstStep;
        while (branch.points.size() < options_.mostPoints) {
            if (goOn && !goOn()) return ended(branch, BranchEnd::Stopped);
            const BranchPoint from = branch.points.back();
            const std::optional<BranchPoint> next = stepFrom(from, step);
            if (!next || next->tangent.dot(from.tangent) < straightest) {
                step *= 0.5;
                if (step < options_.shortestStep) return ended(branch, BranchEnd::Lost);
                continue;
            }
            if (passes(*first, from, step) && branch.points.size() > 2) {
                branch.points.push_back(*first);
                return ended(branch, BranchEnd::Closed);
            }
            if (addStep(branch, from, *next, step)) return branch;
            if (iterations_ <= fewIterations) step = std::min(1.5 * step, options_.longestStep);
        }
        return ended(branch, BranchEnd::TooLong);
    }

private:
    struct Change {
        double s = 0.0; // arclength from the beginning of the step
        BranchPoint at;
        BranchMark mark;
        BranchEnd end = BranchEnd::Bound;
        int guard = -1;
    };
    using Function = std::function<double(const BranchPoint&)>;

    static Branch& ended(Branch& branch, BranchEnd end)
    {
        branch.end = end;
        return branch;
    }

    static Vector joined(const Vector& x, double p)
    {
        Vector y(x.size() + 1);
        y << x, p;
        return y;
    }

    /// The linearisation (dF/dx, dF/dp) with a last row.
    Matrix bordered(const Vector& lastRow) const
    {
        const Eigen::Index n = lastRow.size() - 1;
        Matrix system(n + 1, n + 1);
        system.topLeftCorner(n, n) = at_.byState;
        system.topRightCorner(n, 1) = at_.byParameter;
        system.bottomRows(1) = lastRow.transpose();
        return system;
    }

    /// The point at a solution; its tangent is the null vector of (dF/dx, dF/dp) that looks along `along`.
    std::optional<BranchPoint> pointAt(const Vector& y, const Vector& along)
    {
        const Eigen::Index n = y.size() - 1;
        BranchPoint point{.x = y.head(n), .p = y[n], .tangent = {}, .tests = {}};
        if (!problem_.linearise(point.x, point.p, at_)) return {};
        Vector right = Vector::Zero(n + 1);
        right[n] = 1.0;
        point.tangent = solved(bordered(along), right).normalized();
        if (!point.tangent.allFinite()) return {};
        return point;
    }

    /// The point of the branch at arclength s from `from`, counted along its tangent.
    std::optional<BranchPoint> stepFrom(const BranchPoint& from, double s)
    {
        const Eigen::Index n = from.x.size();
        const Vector begin = joined(from.x, from.p);
        Vector y = begin + s * from.tangent;
        Vector right(n + 1);
        for (iterations_ = 1; iterations_ <= mostIterations; ++iterations_) {
            if (!problem_.linearise(y.head(n), y[n], at_)) return {};
            right << at_.residual, from.tangent.dot(y - begin) - s;
            const Vector change = solved(bordered(from.tangent), right);
            if (!change.allFinite()) return {};
            y -= change;
            if (change.norm() <= options_.tolerance) return pointAt(y, from.tangent);
        }
        return {};
    }

    /// Whether the first point of the branch lies within the step.
    static bool passes(const BranchPoint& first, const BranchPoint& from, double step)
    {
        const Vector way = joined(first.x, first.p) - joined(from.x, from.p);
        const double along = way.dot(from.tangent);
        return along > 0.0 && along <= step && (way - along * from.tangent).norm() < 0.1 * step &&
               first.tangent.dot(from.tangent) > 0.9;
    }

    /// Where a function changes its sign within a step, by the Illinois method with bisections. The sign at the result
    /// is that before the change, so that the end of a branch lies where the branch is valid.
    Change locate(const BranchPoint& from, const BranchPoint& next, double step, const Function& f)
    {
        const bool positive = f(from) > 0.0;
        double low = 0.0, high = step, fLow = f(from), fHigh = f(next);
        Change change{.s = 0.0, .at = from, .mark = {}};
        for (int k = 0; k < mostLocations && high - low > options_.locatedTo && fLow != 0.0; ++k) {
            double s = low + (high - low) * fLow / (fLow - fHigh);
            if (k % 3 == 2 || !(s > low && s < high)) s = 0.5 * (low + high);
            // Near one end, a little further in, so that the bracket shrinks from the other end.
            s = std::clamp(s, low + 0.5 * options_.locatedTo, high - 0.5 * options_.locatedTo);
            const std::optional<BranchPoint> point = stepFrom(from, s);
            if (!point) break;
            const double value = f(*point);
            if ((value > 0.0) == positive && value != 0.0) {
                low = s;
                fLow = value;
                fHigh *= k % 3 == 1 ? 0.5 : 1.0;
                change.s = s;
                change.at = *point;
            } else {
                high = s;
                fHigh = value;
                fLow *= k % 3 == 1 ? 0.5 : 1.0;
                if (value == 0.0) {
                    change.s = s;
                    change.at = *point;
                    break;
                }
            }
        }
        return change;
    }

    void setTests(BranchPoint& point) const
    {
        if (problem_.tests) point.tests = problem_.tests(point.x, point.p);
    }

    /// Moves a point near a bound of p to the bound.
    void moveToBound(Change& change)
    {
        const double p = change.at.p;
        const double bound =
            std::abs(p - options_.lower) < std::abs(p - options_.upper) ? options_.lower : options_.upper;
        Vector x = change.at.x;
        if (!(change.s > 0.0) || !solveAt(problem_, x, bound, options_.tolerance)) return;
        if ((x - change.at.x).norm() > 100.0 * options_.locatedTo)
            return; // near a fold there may be no solution at the bound, or only another one
        if (const std::optional<BranchPoint> there = pointAt(joined(x, bound), change.at.tangent)) change.at = *there;
    }

    /// The first end within a step.
    std::optional<Change> endWithin(const BranchPoint& from, const BranchPoint& next, double step)
    {
        std::optional<Change> first;
        const auto watch = [&](const Function& f, BranchEnd end, int guard) {
            if (f(next) > 0.0) return;
            Change change = f(from) > 0.0 ? locate(from, next, step, f) : Change{.s = 0.0, .at = from, .mark = {}};
            change.end = end;
            change.guard = guard;
            if (end == BranchEnd::Bound) moveToBound(change);
            if (!first || change.s < first->s) first = std::move(change);
        };
        watch([this](const BranchPoint& at) { return options_.upper - at.p; }, BranchEnd::Bound, -1);
        watch([this](const BranchPoint& at) { return at.p - options_.lower; }, BranchEnd::Bound, -1);
        const std::size_t guards = problem_.guards ? problem_.guards(from.x, from.p).size() : 0;
        for (std::size_t k = 0; k < guards; ++k)
            watch([this, k](const BranchPoint& at) { return problem_.guards(at.x, at.p)[k]; }, BranchEnd::Guard,
                  static_cast<int>(k));
        return first;
    }

    /// Adds the marks within a step and its end. True where the branch ends within the step.
    bool addStep(Branch& branch, const BranchPoint& from, BranchPoint next, double step)
    {
        const std::optional<Change> end = endWithin(from, next, step);
        if (end) {
            branch.guard = end->guard;
            branch.end = end->end;
            if (!(end->s > 0.0)) return true;
            next = end->at;
            step = end->s;
        }
        setTests(next);
        std::vector<Change> changes;
        const auto watch = [&](const Function& f, int test) {
            const double before = f(from), after = f(next);
            // A branch may begin on a zero.
            if (before == 0.0 || (before > 0.0) == (after > 0.0)) return;
            Change& change = changes.emplace_back(locate(from, next, step, f));
            change.mark.test = test;
        };
        watch([](const BranchPoint& at) { return at.tangent[at.x.size()]; }, -1);
        for (std::size_t k = 0; k < from.tests.size(); ++k)
            watch([this,
                   k](const BranchPoint& at) { return at.tests.empty() ? problem_.tests(at.x, at.p)[k] : at.tests[k]; },
                  static_cast<int>(k));
        std::ranges::stable_sort(changes, {}, &Change::s);
        for (Change& change : changes) {
            branch.points.push_back(std::move(change.at));
            change.mark.point = branch.points.size() - 1;
            branch.marks.push_back(change.mark);
        }
        branch.points.push_back(std::move(next));
        return end.has_value();
    }

    const ContinuationProblem& problem_;
    const ContinuationOptions& options_;
    ContinuationProblem::Linearised at_;
    int iterations_ = 0; // of the last step
};

} // namespace

bool solveAt(const ContinuationProblem& problem, Vector& x, double p, double tolerance)
{
    ContinuationProblem::Linearised at;
    for (int k = 0; k < 2 * mostIterations; ++k) {
        if (!problem.linearise(x, p, at)) return false;
        const Vector change = solved(at.byState, at.residual);
        if (!change.allFinite()) return false;
        x -= change;
        if (change.norm() <= tolerance) return true;
    }
    return false;
}

Branch followBranch(const ContinuationProblem& problem, Vector x, double p, bool rising,
                    const ContinuationOptions& options, const std::function<bool()>& goOn)
{
    return BranchFollower(problem, options).follow(std::move(x), p, rising, goOn);
}

double hopfTest(const Eigen::VectorXcd& eigenvalues)
{
    const double scale = eigenvalues.cwiseAbs().maxCoeff();
    std::complex<double> product = 1.0;
    for (Eigen::Index i = 0; i < eigenvalues.size(); ++i)
        for (Eigen::Index j = i + 1; j < eigenvalues.size(); ++j) product *= (eigenvalues[i] + eigenvalues[j]) / scale;
    return product.real();
}

bool isCrossingPair(const Eigen::VectorXcd& eigenvalues)
{
    double least = std::numeric_limits<double>::infinity();
    bool complex = false;
    for (Eigen::Index i = 0; i < eigenvalues.size(); ++i)
        for (Eigen::Index j = i + 1; j < eigenvalues.size(); ++j) {
            const double sum = std::abs(eigenvalues[i] + eigenvalues[j]);
            if (sum >= least) continue;
            least = sum;
            complex = eigenvalues[i].imag() != 0.0;
        }
    return complex;
}

} // namespace touchdown
