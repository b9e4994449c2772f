// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eigenvalues of a real matrix by Eigen's QR algorithm, compiled once for all callers.
#pragma once

#include <Eigen/Core>

namespace touchdown {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

} // namespace touchdown
