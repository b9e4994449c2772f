// SPDX-License-Identifier: GPL-3.0-or-later
//
// A branch of solutions of F(x, p) = 0 followed by pseudo-arclength (Keller 1977): with y = (x, p) and the unit tangent
// t at y_0,
//
//   F(y) = 0,   t . (y - y_0) = s
//
// has a regular Jacobian also at folds, where dF/dx is singular. Arclength counts x and p alike: both must be given in
// units in which they are of order one. Changes of the sign of dp/ds (folds) and of test functions are located on the
// branch. Two changes within one step (at most `longestStep`) are missed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace touchdown {

struct ContinuationProblem {
    struct Linearised {
        Eigen::VectorXd residual;    // F, as long as x
        Eigen::MatrixXd byState;     // dF/dx
        Eigen::VectorXd byParameter; // dF/dp
    };
    using Values = std::function<std::vector<double>(const Eigen::VectorXd& x, double p)>;

    /// False where F is not defined.
    std::function<bool(const Eigen::VectorXd& x, double p, Linearised& at)> linearise;
    Values tests{};  // their changes of sign are located; evaluated at points of the branch and for each location
    Values guards{}; // > 0 where the branch is valid; it ends where one of them becomes zero
};

struct ContinuationOptions {
    double lower = 0.0, upper = 1.0;                                  // of p
    double firstStep = 0.01, shortestStep = 1e-7, longestStep = 0.03; // arclength
    double tolerance = 1e-11;                                         // of Newton's last change of y
    double locatedTo = 1e-12;                                         // of marks and ends, arclength
    std::size_t mostPoints = 5000;
};

struct BranchPoint {
    Eigen::VectorXd x;
    double p = 0.0;
    Eigen::VectorXd tangent;   // of (x, p), of length 1, in the direction in which the branch is followed
    std::vector<double> tests; // not at marks
};

struct BranchMark {
    std::size_t point = 0; // of the branch
    int test = -1;         // the test that changes its sign; -1: dp/ds, a fold
    bool fold() const { return test < 0; }
};

enum class BranchEnd : std::uint8_t {
    Bound,      // p has reached `lower` or `upper`
    Guard,      // a guard has become zero
    Closed,     // the branch has returned to its first point
    NoSolution, // not even at its beginning
    Lost,       // no step is short enough: F is not defined there, or not smooth
    TooLong,    // mostPoints
    Stopped
};

struct Branch {
    std::vector<BranchPoint> points; // with the marks and the end
    std::vector<BranchMark> marks;
    BranchEnd end = BranchEnd::NoSolution;
    int guard = -1; // the one that ends it
};

/// Newton's method at a fixed p; false where it does not converge.
bool solveAt(const ContinuationProblem& problem, Eigen::VectorXd& x, double p, double tolerance);

/// Starts at the solution near (x, p), in the direction in which p rises (`rising`) or falls. `goOn` may be empty.
Branch followBranch(const ContinuationProblem& problem, Eigen::VectorXd x, double p, bool rising,
                    const ContinuationOptions& options, const std::function<bool()>& goOn = {});

/// Zero where two eigenvalues of a real matrix sum to zero: the product of all sums of two of them, in units of the
/// largest magnitude (bialternate product; Guckenheimer, Myers & Sturmfels 1997). A complex pair that crosses the
/// imaginary axis changes its sign, and so do two real ones that pass opposite values (a neutral saddle);
/// isCrossingPair distinguishes the two.
double hopfTest(const Eigen::VectorXcd& eigenvalues);
/// Whether the two eigenvalues with the smallest sum are a complex pair.
bool isCrossingPair(const Eigen::VectorXcd& eigenvalues);

} // namespace touchdown
