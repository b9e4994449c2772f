// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/continuation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_continuation {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using Linearised = ContinuationProblem::Linearised;

VectorXd vector(std::initializer_list<double> values)
{
    VectorXd v(static_cast<Eigen::Index>(values.size()));
    std::ranges::copy(values, v.data());
    return v;
}

/// F = p - x^2: the normal form of a fold, at (0, 0).
ContinuationProblem fold()
{
    return {.linearise = [](const VectorXd& x, double p, Linearised& at) {
        at.residual = vector({p - x[0] * x[0]});
        at.byState = MatrixXd::Constant(1, 1, -2.0 * x[0]);
        at.byParameter = vector({1.0});
        return true;
    }};
}

/// F = x^2 + p^2 - 1.
ContinuationProblem circle()
{
    return {.linearise = [](const VectorXd& x, double p, Linearised& at) {
        at.residual = vector({x[0] * x[0] + p * p - 1.0});
        at.byState = MatrixXd::Constant(1, 1, 2.0 * x[0]);
        at.byParameter = vector({2.0 * p});
        return true;
    }};
}

/// The normal form of a Hopf point at p = 0, moved to (x, y) = (p, 2 p) so that the branch has a way to go, with a
/// third direction of its own: eigenvalues p +- i and -1.
MatrixXd hopfMatrix(double p)
{
    MatrixXd a = MatrixXd::Zero(3, 3);
    a << p, -1.0, 0.0, 1.0, p, 0.0, 0.0, 0.0, -1.0;
    return a;
}
ContinuationProblem hopf()
{
    ContinuationProblem problem;
    problem.linearise = [](const VectorXd& x, double p, Linearised& at) {
        const VectorXd from = x - vector({p, 2.0 * p, 0.0});
        at.byState = hopfMatrix(p);
        at.residual = at.byState * from;
        // d/dp of A(p) (x - c(p)), with dA/dp = diag(1, 1, 0)
        at.byParameter = vector({from[0], from[1], 0.0}) - at.byState * vector({1.0, 2.0, 0.0});
        return true;
    };
    problem.tests = [](const VectorXd&, double p) { return std::vector{hopfTest(hopfMatrix(p).eigenvalues())}; };
    return problem;
}

class TestContinuation : public QObject {
    Q_OBJECT

private slots:
    void followsAFoldToItsOtherSide()
    {
        const ContinuationOptions options{.lower = -1.0, .upper = 1.0};
        const Branch branch = followBranch(fold(), vector({1.0}), 1.0, false, options);
        QCOMPARE(branch.end, BranchEnd::Bound);
        QCOMPARE(branch.marks.size(), std::size_t(1));
        QVERIFY(branch.marks[0].fold());
        const BranchPoint& at = branch.points[branch.marks[0].point];
        // p = x^2: the point is located to 1e-12 in arclength, which is x here.
        QVERIFY2(std::abs(at.x[0]) < 1e-11, qPrintable(QString::number(at.x[0])));
        QVERIFY(std::abs(at.p) < 1e-15);
        QVERIFY(std::abs(branch.points.back().x[0] + 1.0) < 1e-10);
        QVERIFY(std::abs(branch.points.back().p - 1.0) < 1e-10);
        for (const BranchPoint& point : branch.points) QVERIFY(std::abs(point.p - point.x[0] * point.x[0]) < 1e-10);
    }

    void closesACircleWithTwoFolds()
    {
        const ContinuationOptions options{.lower = -2.0, .upper = 2.0, .longestStep = 0.05};
        const Branch branch = followBranch(circle(), vector({1.0}), 0.0, true, options);
        QCOMPARE(branch.end, BranchEnd::Closed);
        QCOMPARE(branch.marks.size(), std::size_t(2));
        QVERIFY(std::abs(branch.points[branch.marks[0].point].p - 1.0) < 1e-12);
        QVERIFY(std::abs(branch.points[branch.marks[1].point].p + 1.0) < 1e-12);
        // Once round: 2 pi / 0.05 = 126 steps, and the first few shorter ones.
        QVERIFY(branch.points.size() > 126 && branch.points.size() < 145);
        QCOMPARE(branch.points.front().x, branch.points.back().x);
    }

    void findsAHopfPoint()
    {
        const ContinuationOptions options{.lower = -1.0, .upper = 0.7};
        const Branch branch = followBranch(hopf(), vector({-1.0, -2.0, 0.0}), -1.0, true, options);
        QCOMPARE(branch.end, BranchEnd::Bound);
        QCOMPARE(branch.marks.size(), std::size_t(1));
        QCOMPARE(branch.marks[0].test, 0);
        const BranchPoint& at = branch.points[branch.marks[0].point];
        QVERIFY(std::abs(at.p) < 1e-11);
        QVERIFY(std::abs(at.x[1] - 2.0 * at.p) < 1e-11);
        QVERIFY(isCrossingPair(hopfMatrix(at.p).eigenvalues()));
        QVERIFY(std::abs(branch.points.back().p - 0.7) < 1e-11);
    }

    void tellsANeutralSaddleFromAHopfPoint()
    {
        // Eigenvalues 1 and -1 sum to zero without any crossing.
        const Eigen::VectorXcd saddle = vector({1.0, -1.0, -5.0});
        QCOMPARE(hopfTest(saddle), 0.0);
        QVERIFY(!isCrossingPair(saddle));
    }

    void testOfEigenvaluesHasItsValue()
    {
        // -1 +- 2i and -3: sums -2, -4 + 2i, -4 - 2i, in units of 3: -2 (16 + 4)/27.
        Eigen::VectorXcd eigenvalues(3);
        eigenvalues << std::complex(-1.0, 2.0), std::complex(-1.0, -2.0), std::complex(-3.0, 0.0);
        QVERIFY(std::abs(hopfTest(eigenvalues) + 40.0 / 27.0) < 1e-14);
    }

    void endsWhereAGuardBecomesZero()
    {
        // On p = x^2 from x = 1 downwards, x > 0.3 ends at p = 0.09, before the fold.
        ContinuationProblem problem = fold();
        problem.guards = [](const VectorXd& x, double) { return std::vector{2.0 - x[0], x[0] - 0.3}; };
        const Branch branch = followBranch(problem, vector({1.0}), 1.0, false, {.lower = -1.0, .upper = 1.5});
        QCOMPARE(branch.end, BranchEnd::Guard);
        QCOMPARE(branch.guard, 1);
        QVERIFY(branch.marks.empty());
        QVERIFY(branch.points.back().x[0] >= 0.3);
        QVERIFY(std::abs(branch.points.back().p - 0.09) < 1e-11);
    }

    void saysWhereThereIsNoSolution()
    {
        QCOMPARE(followBranch(fold(), vector({1.0}), -1.0, true, {}).end, BranchEnd::NoSolution);
    }

    void saysWhereTheFunctionEnds()
    {
        ContinuationProblem problem = fold();
        problem.linearise = [inner = problem.linearise](const VectorXd& x, double p, Linearised& at) {
            return p > 0.25 && inner(x, p, at);
        };
        const Branch branch = followBranch(problem, vector({1.0}), 1.0, false, {.lower = -1.0, .upper = 1.5});
        QCOMPARE(branch.end, BranchEnd::Lost);
        QVERIFY(branch.points.back().p > 0.25 && branch.points.back().p < 0.2501);
    }

    void stopsWhenAsked()
    {
        int left = 5;
        const Branch branch =
            followBranch(fold(), vector({1.0}), 1.0, false, {.lower = -1.0, .upper = 1.5}, [&] { return left-- > 0; });
        QCOMPARE(branch.end, BranchEnd::Stopped);
        QCOMPARE(branch.points.size(), std::size_t(6));
    }
};

TOUCHDOWN_TEST(TestContinuation)

} // namespace test_continuation

#include "test_continuation.moc"
