// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/rational_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace touchdown {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double startDamping = 0.3; // of the starting poles: -Re/|Im| [-]
constexpr double leastRelaxed = 1e-8;
constexpr double leastDecay = 1e-12; // of a pole: -Re/|p| [-]
constexpr double beyond = 10.0;      // times the range of the samples, in which poles stay [-]

/// Real basis functions of the poles at s: of a pair 1/(s - p) + 1/(s - p*) and i/(s - p) - i/(s - p*).
void basisAt(Complex s, std::span<const Complex> poles, std::vector<Complex>& basis)
{
    const Complex i(0.0, 1.0);
    basis.clear();
    for (const Complex p : poles) {
        const Complex one = 1.0 / (s - p);
        if (p.imag() == 0.0) {
            basis.push_back(one);
        } else {
            const Complex other = 1.0 / (s - std::conj(p));
            basis.push_back(one + other);
            basis.push_back(i * (one - other));
        }
    }
}

Index orderOf(std::span<const Complex> poles)
{
    return static_cast<Index>(poles.size()) +
           std::ranges::count_if(poles, [](const Complex p) { return p.imag() != 0.0; });
}

void setRows(MatrixXd& matrix, Index row, Index column, Complex value)
{
    matrix(row, column) = value.real();
    matrix(row + 1, column) = value.imag();
}

/// The zeros of d + sum c_k phi_k(s): the next poles, reflected into the left half plane, with magnitudes between two;
/// none where they are not found.
std::vector<Complex> zerosOf(std::span<const Complex> poles, const VectorXd& c, double d, double slowest,
                             double fastest)
{
    const Index n = orderOf(poles);
    MatrixXd a = MatrixXd::Zero(n, n);
    VectorXd b(n);
    Index k = 0;
    for (const Complex p : poles) {
        if (p.imag() == 0.0) {
            a(k, k) = p.real();
            b[k++] = 1.0;
        } else {
            a(k, k) = a(k + 1, k + 1) = p.real();
            a(k, k + 1) = p.imag();
            a(k + 1, k) = -p.imag();
            b[k++] = 2.0;
            b[k++] = 0.0;
        }
    }
    a -= b * c.transpose() / d;
    const Eigen::EigenSolver<MatrixXd> eigen(a, false);
    std::vector<Complex> zeros;
    for (Index m = 0; m < n; ++m) {
        const Complex zero = eigen.eigenvalues()[m];
        if (!std::isfinite(zero.real()) || !std::isfinite(zero.imag())) return {};
        if (zero.imag() < 0.0) continue;
        // One far beyond the samples tells nothing; at zero it would have no static value.
        const double size = std::abs(zero), within = std::clamp(size, slowest, fastest);
        const Complex p = size > 0.0 ? within / size * zero : Complex(within);
        zeros.emplace_back(-std::max(std::abs(p.real()), leastDecay * within), p.imag());
    }
    std::ranges::sort(zeros, {}, [](const Complex p) { return std::abs(p); });
    return zeros;
}

/// One step of the iteration; s in units of `unit`.
std::vector<Complex> movedPoles(std::span<const RationalSample> samples, std::span<const Complex> poles, double unit,
                                double ratio)
{
    const Index n = orderOf(poles), rows = 2 * static_cast<Index>(samples.size()), own = n + 1, columns = 2 * own;
    const std::size_t functions = samples.front().values.size();
    const Index left = std::min(rows, columns) - own; // rows that an elimination of the function's own unknowns leaves
    MatrixXd all = MatrixXd::Zero(static_cast<Index>(functions) * left + 1, own), one(rows, columns);
    std::vector<std::vector<Complex>> basis(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) basisAt(samples[i].s / unit, poles, basis[i]);
    double squares = 0.0;
    for (std::size_t e = 0; e < functions; ++e) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double w = samples[i].weights[e];
            const Complex f = samples[i].values[e];
            const Index row = 2 * static_cast<Index>(i);
            for (Index k = 0; k < n; ++k) {
                const Complex phi = basis[i][static_cast<std::size_t>(k)];
                setRows(one, row, k, w * phi);
                setRows(one, row, own + k, -w * f * phi);
            }
            setRows(one, row, n, w);
            setRows(one, row, own + n, -w * f);
            squares += std::norm(w * f);
        }
        const Eigen::HouseholderQR<MatrixXd> qr(one);
        const MatrixXd r = qr.matrixQR().topRows(own + left).triangularView<Eigen::Upper>();
        all.middleRows(static_cast<Index>(e) * left, left) = r.block(own, own, left, own);
    }
    // Relaxed: not the constant is one, but the mean of the real part over the samples.
    const double weight = std::sqrt(squares) / static_cast<double>(samples.size());
    const Index last = all.rows() - 1;
    for (const std::vector<Complex>& phi : basis)
        for (Index k = 0; k < n; ++k) all(last, k) += weight * phi[static_cast<std::size_t>(k)].real();
    all(last, n) = weight * static_cast<double>(samples.size());
    VectorXd right = VectorXd::Zero(all.rows()), scale(own);
    right[last] = weight * static_cast<double>(samples.size());
    for (Index k = 0; k < own; ++k) {
        const double norm = all.col(k).norm();
        scale[k] = norm > 0.0 ? 1.0 / norm : 1.0;
        all.col(k) *= scale[k];
    }
    const VectorXd x = all.colPivHouseholderQr().solve(right).cwiseProduct(scale);
    double d = x[n];
    if (std::abs(d) < leastRelaxed) d = std::copysign(leastRelaxed, d);
    return zerosOf(poles, x.head(n), d, 1.0 / (std::sqrt(ratio) * beyond), std::sqrt(ratio) * beyond);
}

RationalFit withResidues(std::span<const RationalSample> samples, std::span<const Complex> poles, double unit,
                         bool constant)
{
    const Index n = orderOf(poles), rows = 2 * static_cast<Index>(samples.size()), unknowns = constant ? n + 1 : n;
    const std::size_t functions = samples.front().values.size();
    RationalFit fit;
    for (const Complex p : poles) fit.poles.push_back(unit * p);
    fit.residues.assign(poles.size(), std::vector<Complex>(functions));
    fit.constants.resize(functions);
    MatrixXd a(rows, unknowns);
    VectorXd b(rows), scale(unknowns);
    std::vector<Complex> basis;
    for (std::size_t e = 0; e < functions; ++e) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double w = samples[i].weights[e];
            const Index row = 2 * static_cast<Index>(i);
            basisAt(samples[i].s / unit, poles, basis);
            for (Index k = 0; k < n; ++k) setRows(a, row, k, w * basis[static_cast<std::size_t>(k)]);
            if (constant) setRows(a, row, n, w);
            b[row] = w * samples[i].values[e].real();
            b[row + 1] = w * samples[i].values[e].imag();
        }
        for (Index k = 0; k < unknowns; ++k) {
            const double norm = a.col(k).norm();
            scale[k] = norm > 0.0 ? 1.0 / norm : 1.0;
            a.col(k) *= scale[k];
        }
        const VectorXd x = a.colPivHouseholderQr().solve(b).cwiseProduct(scale);
        Index k = 0;
        for (std::size_t p = 0; p < poles.size(); ++p) {
            const double real = x[k++];
            fit.residues[p][e] = unit * (poles[p].imag() == 0.0 ? Complex(real) : Complex(real, x[k++]));
        }
        fit.constants[e] = constant ? x[n] : 0.0;
    }
    return fit;
}

} // namespace

Complex RationalFit::at(Complex s, std::size_t function) const
{
    Complex sum = constants[function];
    for (std::size_t k = 0; k < poles.size(); ++k) {
        const Complex r = residues[k][function];
        sum += r / (s - poles[k]);
        if (poles[k].imag() != 0.0) sum += std::conj(r) / (s - std::conj(poles[k]));
    }
    return sum;
}

RationalFit fitResidues(std::span<const RationalSample> samples, std::span<const Complex> poles, bool constant)
{
    double unit = 0.0;
    for (const Complex p : poles) unit = std::max(unit, std::abs(p));
    std::vector<Complex> scaled;
    for (const Complex p : poles) scaled.push_back(p / unit);
    return withResidues(samples, scaled, unit, constant);
}

RationalFit fitRationally(std::span<const RationalSample> samples, int order, int iterations)
{
    if (order < 2 || order % 2 != 0 || order + 2 > 2 * static_cast<int>(samples.size()))
        throw std::invalid_argument("too few samples for a rational function of this order");
    double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
    for (const RationalSample& sample : samples) {
        fastest = std::max(fastest, std::abs(sample.s));
        if (sample.s != Complex()) slowest = std::min(slowest, std::abs(sample.s));
    }
    const double unit = std::sqrt(slowest * fastest), ratio = fastest / slowest;
    std::vector<Complex> poles;
    for (int k = 0; k < order / 2; ++k) {
        const double at = slowest / unit * std::pow(ratio, (k + 0.5) / (0.5 * order));
        poles.emplace_back(-startDamping * at, at);
    }
    for (int k = 0; k < iterations; ++k) {
        std::vector<Complex> moved = movedPoles(samples, poles, unit, ratio);
        if (orderOf(moved) != order) break; // the zeros were not found
        poles = std::move(moved);
    }
    return withResidues(samples, poles, unit, true);
}

} // namespace touchdown
