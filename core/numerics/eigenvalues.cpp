// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace touchdown {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix)
{
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

} // namespace touchdown
