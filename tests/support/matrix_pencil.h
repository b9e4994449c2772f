// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frequency and damping of a motion that has been sampled.
#pragma once

#include <Eigen/Dense>

#include <complex>
#include <vector>

namespace touchdown::test {

/// Samples that are sums of c z^n: the z that oscillates and has the largest part in them. Each sample with the
/// `delays` that follow is a vector, and one matrix leads from each to the next (Hua & Sarkar 1990, matrix pencil).
/// What is smaller than `noise` against the largest is rounding.
inline std::complex<double> leadingFactor(const std::vector<Eigen::Vector3d>& samples, Eigen::Index delays,
                                          double noise = 1e-7)
{
    const Eigen::Index columns = static_cast<Eigen::Index>(samples.size()) - delays;
    Eigen::MatrixXd before(3 * delays, columns), after(3 * delays, columns);
    for (Eigen::Index k = 0; k < columns; ++k)
        for (Eigen::Index d = 0; d < delays; ++d) {
            before.block<3, 1>(3 * d, k) = samples[static_cast<std::size_t>(k + d)];
            after.block<3, 1>(3 * d, k) = samples[static_cast<std::size_t>(k + d + 1)];
        }
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(before, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd size = svd.singularValues();
    const Eigen::Index rank = (size.array() > noise * size[0]).count();
    const Eigen::MatrixXd U = svd.matrixU().leftCols(rank), V = svd.matrixV().leftCols(rank);
    const Eigen::EigenSolver<Eigen::MatrixXd> steps(U.transpose() * after * V *
                                                    size.head(rank).cwiseInverse().asDiagonal());
    const Eigen::VectorXcd parts =
        steps.eigenvectors().partialPivLu().solve((U.transpose() * before.col(0)).cast<std::complex<double>>());
    std::complex<double> leading = 0.0;
    double largest = 0.0;
    for (Eigen::Index k = 0; k < rank; ++k)
        if (steps.eigenvalues()[k].imag() > 0.0 && std::abs(parts[k]) > largest) {
            leading = steps.eigenvalues()[k];
            largest = std::abs(parts[k]);
        }
    return leading;
}

} // namespace touchdown::test
