// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulation/matrix_pencil.h"

#include <Eigen/Dense>

namespace touchdown::test {

std::complex<double> leadingFactor(const std::vector<Eigen::Vector3d>& samples, Eigen::Index delays, double noise)
{
    const Eigen::Index columns = static_cast<Eigen::Index>(samples.size()) - delays;
    Eigen::MatrixXd before(3 * delays, columns), after(3 * delays, columns);
    for (Eigen::Index k = 0; k < columns; ++k)
        for (Eigen::Index d = 0; d < delays; ++d) {
            before.block<3, 1>(3 * d, k) = samples[static_cast<std::size_t>(k + d)];
            after.block<3, 1>(3 * d, k) = samples[static_cast<std::size_t>(k + d + 1)];
        }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(before, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd size = svd.singularValues();
    const Eigen::Index rank = (size.array() > noise * size[0]).count();
    const Eigen::MatrixXd U = svd.matrixU().leftCols(rank), V = svd.matrixV().leftCols(rank);
    const Eigen::EigenSolver<Eigen::MatrixXd> steps(U.transpose() * after * V *
                                                    size.head(rank).cwiseInverse().asDiagonal());
    const Eigen::VectorXcd parts =
        steps.eigenvectors().partialPivLu().solve((U.transpose() * before.col(0)).cast<std::complex<double>>());
    std::complex<double> leading = 0.0;
    double largest = 0.0;
    const double slowest = 2.0 * M_PI / static_cast<double>(samples.size());
    for (Eigen::Index k = 0; k < rank; ++k)
        if (std::arg(steps.eigenvalues()[k]) > slowest && std::abs(parts[k]) > largest) {
            leading = steps.eigenvalues()[k];
            largest = std::abs(parts[k]);
        }
    return leading;
}

} // namespace touchdown::test
