// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frequencies and damping ratios of a free motion that has been sampled.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace touchdown::test {

/// Samples of three lengths and the sum of exponentials exp(s t) that is nearest to them, with a constant and decays
/// without oscillation at fixed rates, with which air leaves the pockets after the start. The rates of the oscillations
/// are found by Gauss and Newton's method, the amplitudes by least squares for each set of rates (variable projection:
/// Golub & Pereyra 1973).
class ExponentialFit {
public:
    using Complex = std::complex<double>;

    /// Times [s]; by row and column, each time's lengths.
    ExponentialFit(Eigen::VectorXd time, Eigen::MatrixXd samples) : time_(std::move(time)), samples_(std::move(samples))
    {
        samples_.rowwise() -= samples_.colwise().mean();
        samples_ /= samples_.norm();
    }

    /// Rates near these [1/s].
    std::vector<Complex> rates(std::vector<Complex> s) const
    {
        Eigen::VectorXd rest = residual(s);
        double damping = 1e-6;
        for (int pass = 0; pass < 60 && damping < 1e6; ++pass) {
            const auto count = static_cast<Eigen::Index>(2 * s.size());
            Eigen::MatrixXd slopes(rest.size(), count);
            for (Eigen::Index k = 0; k < count; ++k) slopes.col(k) = (residual(moved(s, k, 1e-6)) - rest) / 1e-6;
            Eigen::MatrixXd normal = slopes.transpose() * slopes;
            normal.diagonal() *= 1.0 + damping;
            const Eigen::VectorXd change = -normal.ldlt().solve(slopes.transpose() * rest);
            std::vector<Complex> next = s;
            for (Eigen::Index k = 0; k < count; ++k) next = moved(next, k, change[k], s);
            const Eigen::VectorXd nextRest = residual(next);
            if (nextRest.norm() < rest.norm()) {
                const bool done = change.norm() < 1e-9;
                s = next;
                rest = nextRest;
                damping *= 0.1;
                if (done) break;
            } else {
                if (change.norm() < 1e-9) break;
                damping = std::max(10.0 * damping, 1e-6);
            }
        }
        return s;
    }
    /// Size of what they leave, of the motion's.
    double left(const std::vector<Complex>& s) const { return residual(s).norm(); }

private:
    static constexpr std::array settling{7e3, 2e4, 5e4, 1.3e5}; // [1/s]

    /// Part k of the rates, real and imaginary in turn, moved by a share of the magnitude.
    static std::vector<Complex> moved(std::vector<Complex> s, Eigen::Index k, double share,
                                      const std::vector<Complex>& of = {})
    {
        Complex& rate = s[static_cast<std::size_t>(k / 2)];
        const double by = share * std::abs(of.empty() ? rate : of[static_cast<std::size_t>(k / 2)]);
        rate += k % 2 == 0 ? Complex(by, 0.0) : Complex(0.0, by);
        return s;
    }

    Eigen::VectorXd residual(const std::vector<Complex>& s) const
    {
        const auto slow = static_cast<Eigen::Index>(2 * s.size());
        Eigen::MatrixXd basis(time_.size(), slow + 1 + static_cast<Eigen::Index>(settling.size()));
        for (Eigen::Index n = 0; n < time_.size(); ++n) {
            for (std::size_t k = 0; k < s.size(); ++k) {
                const Complex value = std::exp(s[k] * (time_[n] - time_[0]));
                basis(n, static_cast<Eigen::Index>(2 * k)) = value.real();
                basis(n, static_cast<Eigen::Index>(2 * k + 1)) = value.imag();
            }
            basis(n, slow) = 1.0;
            for (std::size_t k = 0; k < settling.size(); ++k)
                basis(n, slow + 1 + static_cast<Eigen::Index>(k)) = std::exp(-settling[k] * (time_[n] - time_[0]));
        }
        const Eigen::MatrixXd rest = samples_ - basis * basis.colPivHouseholderQr().solve(samples_);
        return Eigen::Map<const Eigen::VectorXd>(rest.data(), rest.size());
    }

    Eigen::VectorXd time_;
    Eigen::MatrixXd samples_;
};

} // namespace touchdown::test
