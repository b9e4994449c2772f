// SPDX-License-Identifier: GPL-3.0-or-later
//
// A branch of solutions of F(x, p) = 0 followed by pseudo-arclength (Keller 1977): with y = (x, p) and the unit tangent
// t at y_0,
//
//   F(y) = 0,   t . (y - y_0) = s
//
// has a regular Jacobian at folds too, where dF/dx has none. Arclength counts x and p alike: give both in units in
// which they are of order one. Along the branch the signs of dp/ds (folds) and of test functions are watched, and each
// change is located on the branch itself. Two changes within one step are missed; `longestStep` bounds that.
#pragma once

#include <complex>
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
    Values
        tests{}; // whose changes of sign are of interest; asked at points of the branch, and where a change is located
    Values guards{}; // > 0 where the branch holds; it ends where one of them becomes zero
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
    int test = -1;         // which test changes its sign; -1: dp/ds does, a fold
    bool fold() const { return test < 0; }
};

enum class BranchEnd : std::uint8_t {
    Bound,      // p has reached `lower` or `upper`
    Guard,      // a guard has become zero
    Closed,     // the branch has come back to where it began
    NoSolution, // not even at its beginning
    Lost,       // no step leads on, however short: F is not defined there, or not smooth
    TooLong,    // mostPoints
    Stopped
};

struct Branch {
    std::vector<BranchPoint> points; // with those of the marks, and the end itself
    std::vector<BranchMark> marks;
    BranchEnd end = BranchEnd::NoSolution;
    int guard = -1; // which one ends it
};

/// Newton's method at a fixed p; false where it does not converge.
bool solveAt(const ContinuationProblem& problem, Eigen::VectorXd& x, double p, double tolerance);

/// From the solution next to (x, p), to where p first rises (`rising`) or falls. `goOn` may be empty.
Branch followBranch(const ContinuationProblem& problem, Eigen::VectorXd x, double p, bool rising,
                    const ContinuationOptions& options, const std::function<bool()>& goOn = {});

/// Zero where two eigenvalues of a real matrix sum to zero: the product of all sums of two of them, in units of the
/// largest magnitude (bialternate product; Guckenheimer, Myers & Sturmfels 1997). A complex pair that crosses the
/// imaginary axis changes its sign, and so do two real ones that pass opposite values (a neutral saddle):
/// isCrossingPair tells them apart.
double hopfTest(const Eigen::VectorXcd& eigenvalues);
/// Whether the two whose sum is next to zero are a complex pair.
bool isCrossingPair(const Eigen::VectorXcd& eigenvalues);

} // namespace touchdown
