// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors and matrices of few rows, as of the slider's height, pitch and roll; and their decompositions, which are slow
// to compile, in one place. Mind that Vector3 v{} has no defined value: write Vector3::Zero().
#pragma once

#include <complex>

#include <Eigen/Core>

namespace touchdown {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using ComplexVector3 = Eigen::Vector3cd;
using ComplexMatrix3 = Eigen::Matrix3cd;

/// x of A x = b by elimination with partial pivoting; without allocation.
Vector3 solvePartialPivoting(const Matrix3& a, const Vector3& b);
/// The same with complete pivoting, also for a nearly singular matrix.
Vector3 solveFullPivoting(const Matrix3& a, const Vector3& b);
/// Square; without allocation. The caller sees to it that there are at most 8 rows (assert).
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;
using SmallComplexMatrix = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;
using SmallComplexVector = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, 0, 8, 1>;

/// The largest magnitude of an eigenvalue; without allocation.
double spectralRadius(const SmallMatrix& a);
SmallComplexVector eigenvaluesOf(const SmallMatrix& a);
struct Eigenpairs {
    SmallComplexVector values;
    SmallComplexMatrix vectors; // columns
};
Eigenpairs eigenpairsOf(const SmallMatrix& a);

/// adj(A) with A adj(A) = det(A) I. Where A is singular of rank 2, its columns are x of A x = 0 and its rows y^T of
/// y^T A = 0.
ComplexMatrix3 adjugate(const ComplexMatrix3& a);

} // namespace touchdown
