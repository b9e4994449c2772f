// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/stability_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/newmark.h"
#include "core/numerics/runge_kutta.h"
#include "core/numerics/small_matrix.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

/// A step of an explicit Runge-Kutta method of y' = z y from 1, by the functions of the integrators themselves.
template <const auto& tableau, std::size_t stages>
double rungeKuttaGrowth(Complex z)
{
    using State = Eigen::Matrix<Complex, 1, 1>;
    const State y = State::Ones();
    std::array<State, stages> k;
    const auto derivative = [&](const State& at) { return State(z * at); };
    k[0] = derivative(y);
    evaluateStages<tableau>(y, 1.0, k, derivative);
    return std::abs((y + combine<TableauRow<tableau, &Tableau<stages>::b>, stages>(1.0, k))[0]);
}

/// q" = -w^2 q - 2 zeta w q', for Newmark's stepper.
struct Oscillator {
    using State = Eigen::Vector2d;
    struct Mode {};
    double w = 1.0, zeta = 0.0;

    State derivative(const State& y, Mode) const { return {y[1], -w * w * y[0] - 2.0 * zeta * w * y[1]}; }
    Eigen::Matrix<double, 1, 2> jacobian(const State&, Mode) const { return {-w * w, -2.0 * zeta * w}; }
    State scale() const { return {1.0, std::max(w, 1e-6)}; }
};

/// The spectral radius.
double largestRoot(const SmallMatrix& matrix)
{
    double square = 0.0;
    for (const Complex root : eigenvaluesOf(matrix)) square = std::max(square, std::norm(root));
    return std::sqrt(square);
}

/// One step of mass and film from (q, v, a, m1, m2, m3) with h = 1, to the same of the next time.
class CoupledStep {
public:
    using State = Eigen::Matrix<double, 6, 1>;

    CoupledStep(const CoupledRule& rule, double w, double zeta, double leak)
        : rule_(rule), w_(w), zeta_(zeta), leak_(leak * w), film_(backwardDifference(rule.film, 1.0, 1.0, 1.0, w))
    {}

    State operator()(const State& y) const
    {
        const double q0 = y[0], v0 = y[1], a0 = y[2];
        const double past = film_.share[0] * y[3] + film_.share[1] * y[4] + film_.share[2] * y[5];
        const auto filmAt = [&](double q) { return (past + leak_ * q) / (film_.perTime + leak_); };
        // The mass: a + 2 zeta w v + w^2 (q - m) = 0 with Newmark's q and v, for the film's m = m0 + m1 q.
        const auto move = [&](double m0, double m1) {
            const double q = q0 + v0 + (0.5 - rule_.beta) * a0, v = v0 + 0.5 * a0; // without the new acceleration
            const double stiffness = w_ * w_ * (1.0 - m1);
            return -(2.0 * zeta_ * w_ * v + stiffness * q - w_ * w_ * m0) / (1.0 + zeta_ * w_ + rule_.beta * stiffness);
        };
        double a = 0.0, q = q0, m = y[3];
        const auto place = [&] { return q0 + v0 + (0.5 - rule_.beta) * a0 + rule_.beta * a; };
        if (rule_.coupling == CouplingKind::InTurns) {
            for (int turn = 0; turn < rule_.turns; ++turn) {
                // Under the film's last force, w^2 (m - q) at the place where it was found.
                a = move(0.0, 1.0) + w_ * w_ * (m - q) / (1.0 + zeta_ * w_);
                q = place();
                m = filmAt(q);
            }
        } else {
            a = move(filmAt(0.0), leak_ / (film_.perTime + leak_));
            q = place();
            m = filmAt(q);
        }
        State next;
        next << q, v0 + 0.5 * (a0 + a), a, m, y[3], y[4];
        return next;
    }
    /// Contraction of the staggered iteration: the share of a displacement of the mass that returns with opposite sign.
    double contraction() const
    {
        return rule_.beta * w_ * w_ * (1.0 - leak_ / (film_.perTime + leak_)) / (1.0 + zeta_ * w_);
    }

private:
    const CoupledRule& rule_;
    double w_, zeta_, leak_;
    BackwardDifference film_;
};

/// Cells of the upper half of the plane, and where growth crosses 1 on their edges.
class Contour {
public:
    Contour(const Growth& growth, const PlaneWindow& window)
        : growth_(growth), window_(window), size_((window.right - window.left) / window.columns)
    {
        rows_ = std::max(1, static_cast<int>(std::ceil(window.height / size_)));
        inside_.resize(static_cast<std::size_t>((window.columns + 1) * (rows_ + 1)));
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i <= window.columns; ++i) inside_[at(i, j)] = isInside(corner(i, j));
    }

    std::vector<std::vector<Complex>> lines()
    {
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i < window_.columns; ++i) cross(i, j);
        join();
        mirror();
        return std::move(lines_);
    }

private:
    std::size_t at(int i, int j) const { return static_cast<std::size_t>(j * (window_.columns + 1) + i); }
    Complex corner(int i, int j) const { return {window_.left + i * size_, j * size_}; }
    bool isInside(Complex z) const { return growth_(z) <= 1.0 + 1e-12; }

    /// Between an inner and an outer corner.
    Complex crossing(Complex inner, Complex outer) const
    {
        for (int n = 0; n < 30; ++n) {
            const Complex middle = 0.5 * (inner + outer);
            (isInside(middle) ? inner : outer) = middle;
        }
        return 0.5 * (inner + outer);
    }
    void cross(int i, int j)
    {
        const std::array<std::array<int, 2>, 5> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i, j}}};
        std::vector<Complex> found;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [a, b] = std::pair(corners[k], corners[k + 1]);
            const bool first = inside_[at(a[0], a[1])], second = inside_[at(b[0], b[1])];
            if (first == second) continue;
            const Complex za = corner(a[0], a[1]), zb = corner(b[0], b[1]);
            found.push_back(first ? crossing(za, zb) : crossing(zb, za));
        }
        for (std::size_t k = 0; k + 1 < found.size(); k += 2) lines_.push_back({found[k], found[k + 1]});
    }
    bool meet(Complex a, Complex b) const { return std::abs(a - b) < 1e-7 * size_; }
    void join()
    {
        std::vector<std::vector<Complex>> joined;
        while (!lines_.empty()) {
            std::vector<Complex> line = std::move(lines_.back());
            lines_.pop_back();
            for (bool grown = true; grown;) {
                grown = false;
                for (std::size_t k = 0; k < lines_.size() && !grown; ++k) {
                    std::vector<Complex>& other = lines_[k];
                    if (meet(line.back(), other.back()) || meet(line.front(), other.front()))
                        std::reverse(other.begin(), other.end());
                    if (meet(line.back(), other.front()))
                        line.insert(line.end(), other.begin() + 1, other.end());
                    else if (meet(line.front(), other.back()))
                        line.insert(line.begin(), other.begin(), other.end() - 1);
                    else
                        continue;
                    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(k));
                    grown = true;
                }
            }
            joined.push_back(std::move(line));
        }
        lines_ = std::move(joined);
    }
    /// A line that ends on the real axis continues in the lower half; any other line has its mirror image there.
    void mirror()
    {
        const auto onAxis = [&](Complex z) { return std::abs(z.imag()) < 1e-7 * size_; };
        const std::size_t count = lines_.size();
        for (std::size_t k = 0; k < count; ++k) {
            std::vector<Complex> line = lines_[k], lower;
            if (onAxis(line.front()) && !onAxis(line.back())) std::reverse(line.begin(), line.end());
            for (const Complex z : line) lower.push_back(std::conj(z));
            if (onAxis(line.back())) {
                line.insert(line.end(), lower.rbegin() + 1, lower.rend());
                lines_[k] = std::move(line);
            } else {
                lines_.push_back(std::move(lower));
            }
        }
    }

    const Growth& growth_;
    const PlaneWindow& window_;
    double size_;
    int rows_ = 0;
    std::vector<char> inside_;
    std::vector<std::vector<Complex>> lines_;
};

} // namespace

double rk4Growth(Complex z) { return rungeKuttaGrowth<rk4Tableau, 4>(z); }

double dopri5Growth(Complex z) { return rungeKuttaGrowth<dopri5Tableau, 7>(z); }

double newmarkGrowth(double beta, double gamma, Complex z)
{
    const double w = std::abs(z);
    const Oscillator system{w, w > 0.0 ? -z.real() / w : 0.0};
    NewmarkStepper<Oscillator> stepper(system, {.beta = beta, .gamma = gamma});
    SmallMatrix matrix(2, 2);
    for (int k = 0; k < 2; ++k) {
        Eigen::Vector2d end;
        if (!stepper.step(Eigen::Vector2d::Unit(k), {}, 1.0, end)) return std::numeric_limits<double>::infinity();
        matrix.col(k) = end;
    }
    return largestRoot(matrix);
}

double backwardGrowth(BackwardRule rule, Complex z, double phase)
{
    const BackwardDifference d = backwardDifference(rule, 1.0, 1.0, 1.0, phase);
    // m = (share0 m1 + share1 m2 + share2 m3)/(perTime - z)
    const Complex weight = d.perTime - z;
    if (weight == 0.0) return std::numeric_limits<double>::infinity();
    // The complex matrix A + i B as the real one (A, -B; B, A): its eigenvalues and their conjugates.
    SmallMatrix matrix = SmallMatrix::Zero(6, 6);
    for (int k = 0; k < 3; ++k) {
        const Complex share = d.share[static_cast<std::size_t>(k)] / weight;
        matrix(0, k) = matrix(3, k + 3) = share.real();
        matrix(3, k) = share.imag();
        matrix(0, k + 3) = -share.imag();
    }
    matrix(1, 0) = matrix(2, 1) = matrix(4, 3) = matrix(5, 4) = 1.0;
    return largestRoot(matrix);
}

double coupledGrowth(const CoupledRule& rule, double w, double dampingRatio, double leak)
{
    const CoupledStep step(rule, w, dampingRatio, leak);
    if (rule.coupling == CouplingKind::Iterated && !(step.contraction() < 1.0))
        return std::numeric_limits<double>::infinity();
    SmallMatrix matrix(6, 6);
    for (int k = 0; k < 6; ++k) matrix.col(k) = step(CoupledStep::State::Unit(k));
    return largestRoot(matrix);
}

double largestStable(const std::function<bool(double)>& stable, double from, double to)
{
    if (!stable(from)) return 0.0;
    constexpr double factor = 1.02;
    double inner = from;
    while (inner < to) {
        double outer = std::min(factor * inner, to);
        if (stable(outer)) {
            inner = outer;
            continue;
        }
        for (int n = 0; n < 50; ++n) {
            const double middle = 0.5 * (inner + outer);
            (stable(middle) ? inner : outer) = middle;
        }
        return inner;
    }
    return to;
}

std::vector<std::vector<Complex>> stabilityBoundary(const Growth& growth, const PlaneWindow& window)
{
    return Contour(growth, window).lines();
}

} // namespace touchdown
