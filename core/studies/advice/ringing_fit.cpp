// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/ringing_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr int improvements = 6;
constexpr std::size_t mostSamples = 1000; // that are fitted: more tell nothing of rates far below theirs
constexpr double fewestPeriods = 1.5;     // of the slowest motion
constexpr double largestChange = 0.2;     // of a rate, in one improvement [-]
constexpr double slowest = 0.3;           // decay over the samples [-]
constexpr double worthImproving = 0.02;   // of the largest amplitude: rates of smaller motions stay [-]

} // namespace

double RingingFit::at(double time) const
{
    double sum = constant;
    for (std::size_t k = 0; k < rates.size(); ++k) sum += (amplitudes[k] * std::exp(rates[k] * time)).real();
    return sum;
}

std::optional<RingingFit> fitRinging(std::span<const double> samples, double interval,
                                     const std::vector<RingingRate>& rates)
{
    const std::size_t stride = std::max<std::size_t>(1, samples.size() / mostSamples),
                      count = samples.empty() ? 0 : (samples.size() - 1) / stride + 1;
    if (count < 8 * (rates.size() + 1)) return {};
    const double span = interval * static_cast<double>(samples.size());
    RingingFit fit;
    for (const RingingRate& rate : rates) {
        if (rate.rate.imag() != 0.0 && std::abs(rate.rate.imag()) * span < 2.0 * std::numbers::pi * fewestPeriods)
            return {};
        fit.rates.push_back(rate.rate);
    }
    const auto rows = static_cast<Eigen::Index>(count);
    Eigen::VectorXd right(rows);
    for (Eigen::Index row = 0; row < rows; ++row)
        right[row] = samples[static_cast<std::size_t>(row) * stride] - samples[0];

    for (int pass = 0; pass <= improvements; ++pass) {
        const bool improves = pass < improvements;
        const auto known = static_cast<Eigen::Index>(fit.rates.size()),
                   perRate = static_cast<Eigen::Index>(improves ? 4 : 2);
        Eigen::MatrixXd matrix(rows, 1 + perRate * known);
        matrix.setZero();
        matrix.col(0).setOnes();
        for (Eigen::Index row = 0; row < rows; ++row) {
            const double t = interval * static_cast<double>(static_cast<std::size_t>(row) * stride);
            for (Eigen::Index k = 0; k < known; ++k) {
                const Complex e = std::exp(fit.rates[static_cast<std::size_t>(k)] * t);
                const Eigen::Index column = 1 + perRate * k;
                matrix(row, column) = e.real();
                matrix(row, column + 1) = -e.imag(); // zero of one that creeps: the decomposition leaves it out
                if (!improves || rates[static_cast<std::size_t>(k)].fixed) continue;
                matrix(row, column + 2) = t / span * e.real();
                matrix(row, column + 3) = -t / span * e.imag();
            }
        }
        const Eigen::VectorXd x = matrix.colPivHouseholderQr().solve(right);
        fit.constant = samples[0] + x[0];
        fit.amplitudes.clear();
        double largest = 0.0;
        for (Eigen::Index k = 0; k < known; ++k) {
            fit.amplitudes.emplace_back(x[1 + perRate * k], x[2 + perRate * k]);
            largest = std::max(largest, std::abs(fit.amplitudes.back()));
        }
        if (!improves) {
            fit.left = (matrix * x - right).norm() / std::sqrt(static_cast<double>(rows));
            break;
        }
        for (Eigen::Index k = 0; k < known; ++k) {
            const auto at = static_cast<std::size_t>(k);
            if (rates[at].fixed || std::abs(fit.amplitudes[at]) <= worthImproving * largest) continue;
            const Complex change = Complex(x[3 + perRate * k], x[4 + perRate * k]) / (span * fit.amplitudes[at]);
            const double most = largestChange * std::abs(fit.rates[at]);
            fit.rates[at] += std::abs(change) > most ? change * (most / std::abs(change)) : change;
            // A part that creeps slower than that cannot be distinguished from a constant, and counts as one.
            if (rates[at].rate.imag() == 0.0) fit.rates[at] = std::min(fit.rates[at].real(), -slowest / span);
        }
    }
    if (!std::isfinite(fit.constant) || !std::isfinite(fit.left)) return {};
    return fit;
}

} // namespace touchdown
