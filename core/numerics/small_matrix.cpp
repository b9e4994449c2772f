// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/small_matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace touchdown {

Vector3 solvePartialPivoting(const Matrix3& a, const Vector3& b) { return a.partialPivLu().solve(b); }

Vector3 solveFullPivoting(const Matrix3& a, const Vector3& b) { return a.fullPivLu().solve(b); }

double spectralRadius(const SmallMatrix& a) { return eigenvaluesOf(a).cwiseAbs().maxCoeff(); }

SmallComplexVector eigenvaluesOf(const SmallMatrix& a)
{
    return Eigen::EigenSolver<SmallMatrix>(a, false).eigenvalues();
}

Eigenpairs eigenpairsOf(const SmallMatrix& a)
{
    const Eigen::EigenSolver<SmallMatrix> solver(a);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

ComplexMatrix3 adjugate(const ComplexMatrix3& a)
{
    ComplexMatrix3 result;
    for (int k = 0; k < 3; ++k)
        for (int m = 0; m < 3; ++m) {
            const int r0 = (m + 1) % 3, r1 = (m + 2) % 3, c0 = (k + 1) % 3, c1 = (k + 2) % 3;
            result(k, m) = a(r0, c0) * a(r1, c1) - a(r0, c1) * a(r1, c0);
        }
    return result;
}

} // namespace touchdown
