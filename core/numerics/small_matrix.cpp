// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/small_matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace touchdown {

Vector3 solvePartialPivoting(const Matrix3& a, const Vector3& b) { return a.partialPivLu().solve(b); }

Vector3 solveFullPivoting(const Matrix3& a, const Vector3& b) { return a.fullPivLu().solve(b); }

double spectralRadius(const Matrix3& a) { return a.eigenvalues().cwiseAbs().maxCoeff(); }

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& a)
{
    return Eigen::EigenSolver<Eigen::MatrixXd>(a, false).eigenvalues();
}

Eigenpairs eigenpairsOf(const Eigen::MatrixXd& a)
{
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd solveComplex(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b)
{
    return a.partialPivLu().solve(b);
}

NullVectors nullVectorsOf(const Eigen::MatrixXcd& a)
{
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Index last = a.cols() - 1;
    return {svd.matrixV().col(last), svd.matrixU().col(last).adjoint()};
}

} // namespace touchdown
