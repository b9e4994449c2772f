// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/film_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Eigenvalues>

#include "core/numerics/rational_fit.h"
#include "core/simulation/small_motions/small_motions.h"

namespace touchdown {

using Complex = FilmFit::Complex;

namespace {

constexpr int firstValues = 11; // evenly spread
constexpr int mostValues = 26;
constexpr int highestOrder = 24;
constexpr double goodFit = 1e-4;        // of the largest entry of Z [-]
constexpr double sameRate = 0.02;       // of a rate: values nearer to each other tell nothing new [-]
constexpr double leastWeighed = 1e-2;   // of the largest entry: smaller entries count as this [-]
constexpr double inMicroseconds = 1e-6; // [s]: makes entries of a companion matrix alike in size

/// Z in displacements of the corners [N/m].
ComplexMatrix3 scaledStiffness(const SmallMotions& motions, Complex s, const SmallMotions::Film& film)
{
    return motions.scale().asDiagonal() * (film.stiffness + s * film.damping) * motions.scale().asDiagonal();
}

class Fitting {
public:
    Fitting(SmallMotions& motions, bool& solved) : motions_(motions), solved_(solved) {}

    void take(double frequency) { add(frequency, {0.0, 2.0 * std::numbers::pi * frequency}); }

    /// The static stiffness, at so slow a motion that the film is steady.
    void takeStatic() { add(1.0, 0.0); }

    void add(double frequency, Complex s)
    {
        const Complex moving(0.0, 2.0 * std::numbers::pi * frequency);
        ComplexMatrix3 z = scaledStiffness(motions_, moving, motions_.film(moving));
        if (s == Complex()) z = z.real().cast<Complex>();
        solved_ = solved_ && motions_.converged();
        const double largest = z.cwiseAbs().maxCoeff();
        if (fit_) missed_ = std::max(missed_, (scaledAt(s) - z).cwiseAbs().maxCoeff() / largest);
        RationalSample& sample = samples_.emplace_back(RationalSample{.s = s, .values = {}, .weights = {}});
        for (Eigen::Index k = 0; k < 3; ++k)
            for (Eigen::Index m = 0; m < 3; ++m) {
                sample.values.push_back(z(k, m));
                sample.weights.push_back(1.0 / std::max(std::abs(z(k, m)), leastWeighed * largest));
            }
    }

    void fit()
    {
        const int most = 2 * static_cast<int>(samples_.size()) - 6;
        order_ = std::min(highestOrder, most - most % 2);
        fit_ = fitRationally(samples_, order_);
    }

    bool isNear(double frequency) const
    {
        return std::ranges::any_of(samples_, [&](const RationalSample& sample) {
            return std::abs(sample.s.imag() / (2.0 * std::numbers::pi * frequency) - 1.0) < sameRate;
        });
    }

    /// In the middle of the widest gap.
    double widestGap() const
    {
        std::vector<double> known;
        for (const RationalSample& sample : samples_)
            if (sample.s != Complex()) known.push_back(std::log(sample.s.imag()));
        std::ranges::sort(known);
        double at = known.front(), width = 0.0;
        for (std::size_t k = 1; k < known.size(); ++k)
            if (known[k] - known[k - 1] > width) {
                width = known[k] - known[k - 1];
                at = 0.5 * (known[k] + known[k - 1]);
            }
        return std::exp(at) / (2.0 * std::numbers::pi);
    }

    FilmFit result() const
    {
        FilmFit film;
        film.order = order_;
        film.values = static_cast<int>(samples_.size());
        film.error = missed_;
        const Vector3 back = motions_.scale().cwiseInverse();
        for (Eigen::Index k = 0; k < 3; ++k)
            for (Eigen::Index m = 0; m < 3; ++m) film.constant(k, m) = back[k] * back[m] * fit_->constants[entry(k, m)];
        for (std::size_t p = 0; p < fit_->poles.size(); ++p) {
            FilmFit::Pole& pole = film.poles.emplace_back(FilmFit::Pole{.rate = fit_->poles[p]});
            for (Eigen::Index k = 0; k < 3; ++k)
                for (Eigen::Index m = 0; m < 3; ++m)
                    pole.residue(k, m) = back[k] * back[m] * fit_->residues[p][entry(k, m)];
        }
        return film;
    }

    double missed() const { return missed_; }
    void forgetMissed() { missed_ = 0.0; }
    std::size_t values() const { return samples_.size(); }

private:
    static std::size_t entry(Eigen::Index k, Eigen::Index m) { return static_cast<std::size_t>(3 * k + m); }
    ComplexMatrix3 scaledAt(Complex s) const
    {
        ComplexMatrix3 z;
        for (Eigen::Index k = 0; k < 3; ++k)
            for (Eigen::Index m = 0; m < 3; ++m) z(k, m) = fit_->at(s, entry(k, m));
        return z;
    }

    SmallMotions& motions_;
    bool& solved_;
    std::vector<RationalSample> samples_;
    std::optional<RationalFit> fit_;
    int order_ = 0;
    double missed_ = 0.0; // by the fit, of the values taken since
};

} // namespace

ComplexMatrix3 FilmFit::at(Complex s) const
{
    ComplexMatrix3 z = constant;
    for (const Pole& pole : poles) {
        z += pole.residue / (s - pole.rate);
        if (pole.rate.imag() != 0.0) z += pole.residue.conjugate() / (s - std::conj(pole.rate));
    }
    return z;
}

bool FilmFit::isFinite() const
{
    return constant.allFinite() && std::ranges::all_of(poles, [](const Pole& pole) {
               return pole.residue.allFinite() && (pole.residue / pole.rate).allFinite();
           });
}

std::vector<Complex> ratesOver(const FilmFit& film, const SmallMotions& motions)
{
    const Eigen::Index n = motions.unknowns();
    Eigen::Index size = 2 * n;
    for (const FilmFit::Pole& pole : film.poles) size += pole.rate.imag() == 0.0 ? n : 2 * n;
    // (q, v, x): in displacements of the corners and microseconds.
    const Vector3 scale = motions.scale(), toMass = (motions.mass().cwiseProduct(scale)).cwiseInverse();
    const auto scaled = [&](const Matrix3& matrix) {
        return (inMicroseconds * inMicroseconds *
                (toMass.asDiagonal() * matrix * scale.asDiagonal()).topLeftCorner(n, n))
            .eval();
    };
    const SmallMotions::Film none;
    const Matrix3 springs = motions.dynamic(0.0, none).real();
    const Matrix3 dampers =
        (motions.dynamic(1.0, none) - motions.dynamic(0.0, none)).real() - Matrix3(motions.mass().asDiagonal());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    a.block(0, n, n, n).setIdentity();
    a.block(n, 0, n, n) = -scaled(springs + film.constant);
    a.block(n, n, n, n) = -scaled(dampers) / inMicroseconds;
    Eigen::Index at = 2 * n;
    for (const FilmFit::Pole& pole : film.poles) {
        const double re = inMicroseconds * pole.rate.real(), im = inMicroseconds * pole.rate.imag();
        const auto unit = Eigen::MatrixXd::Identity(n, n);
        a.block(at, at, n, n) = re * unit;
        a.block(at, 0, n, n) = unit;
        a.block(n, at, n, n) = -scaled(pole.residue.real()) * inMicroseconds;
        if (pole.rate.imag() != 0.0) { // 2 Re(R x), x = x' + i x''
            a.block(n, at, n, n) *= 2.0;
            a.block(n, at + n, n, n) = scaled(pole.residue.imag()) * (2.0 * inMicroseconds);
            a.block(at, at + n, n, n) = -im * unit;
            a.block(at + n, at, n, n) = im * unit;
            a.block(at + n, at + n, n, n) = re * unit;
            at += n;
        }
        at += n;
    }
    std::vector<Complex> rates;
    const Eigen::EigenSolver<Eigen::MatrixXd> eigen(a, false);
    for (Eigen::Index k = 0; k < size; ++k)
        if (const Complex s = eigen.eigenvalues()[k] / inMicroseconds; s.imag() > 0.0) rates.push_back(s);
    std::ranges::sort(rates, {}, [](const Complex s) { return s.imag(); });
    return rates;
}

FilmFit fitFilm(SmallMotions& motions, bool& solved, const std::function<bool()>& goOn)
{
    Fitting fitting(motions, solved);
    const auto asked = [&] { return !goOn || goOn(); };
    if (asked()) fitting.takeStatic();
    for (int k = 0; k < firstValues && asked(); ++k)
        fitting.take(lowestFitted * std::pow(highestFitted / lowestFitted, static_cast<double>(k) / (firstValues - 1)));
    if (!asked()) return {};
    fitting.fit();
    while (fitting.values() < mostValues && asked()) {
        fitting.forgetMissed();
        // The film's own roots decay faster than the slider's motions.
        std::vector<Complex> rates = ratesOver(fitting.result(), motions);
        std::ranges::sort(rates, {}, [](const Complex s) { return -s.real() / std::abs(s); });
        rates.resize(std::min(rates.size(), static_cast<std::size_t>(motions.unknowns())));
        for (const Complex s : rates) {
            const double frequency = s.imag() / (2.0 * std::numbers::pi);
            if (frequency < lowestFitted || frequency > highestFitted) continue;
            if (!fitting.isNear(frequency) && fitting.values() < mostValues && asked()) fitting.take(frequency);
        }
        if (fitting.values() < mostValues && asked()) fitting.take(fitting.widestGap());
        fitting.fit();
        if (fitting.missed() < goodFit) break;
    }
    return fitting.result();
}

} // namespace touchdown
