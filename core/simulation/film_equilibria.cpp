// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/film_equilibria.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/physics/film_oscillation.h"
#include "core/simulation/film_scene.h"
#include "core/simulation/ono_yamane_contact.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr int mostIterations = 25;     // of Newton
constexpr int mostHalvings = 8;        // of one of its steps
constexpr double longestStep = 3e-9;   // of the slider's corners in one of its steps [m]
constexpr double apart = 1e-11;        // of two equilibria, at the slider's corners [m]
constexpr int mostPasses = 30;         // for an eigenvalue
constexpr double eigenvalueTolerance = 1e-5; // of its last change [-]

Eigen::Matrix3d toEigen(const Matrix3& m)
{
    Eigen::Matrix3d result;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) result(k, i) = m[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
    return result;
}

/// The same from the mass centre's height: the trailing edge's falls by half the length times the pitch.
Eigen::Matrix3d aboutCentre(const Matrix3& stiffness, double length)
{
    Eigen::Matrix3d result = toEigen(stiffness);
    result.col(1) -= 0.5 * length * result.col(0);
    return result;
}

/// What the film, steady at its attitude, answers to motions exp(s t) about it, with the torques of its shear.
class FilmAnswer {
public:
    FilmAnswer(FilmLevel& level, double shearArm, double length, const std::function<bool()>& goOn) : length_(length)
    {
        std::vector<double> residual(level.pressure.size());
        level.film.linearise(level.pressure, residual);
        oscillation_.emplace(level.film, level.pressure);
        oscillation_->ask(goOn);
        GasFilm::ForceDerivatives forces;
        level.film.forceDerivatives(level.pressure, forces);
        for (std::size_t k = 0; k < 3; ++k) {
            byPressure_[k] = forces.byPressure[k];
            byAttitude_[k] = forces.byAttitude[k];
            if (k == 0) continue;
            for (std::size_t at = 0; at < byPressure_[k].size(); ++at) byPressure_[k][at] -= shearArm * forces.byPressure[k + 2][at];
            for (std::size_t m = 0; m < 3; ++m) byAttitude_[k][m] -= shearArm * forces.byAttitude[k + 2][m];
        }
    }

    /// Z(s) about the mass centre [N/m ...].
    Eigen::Matrix3cd at(Complex s)
    {
        converged_ = true;
        const ComplexMatrix3 z = oscillation_->stiffness(s, byPressure_, byAttitude_, converged_);
        Eigen::Matrix3cd result;
        for (int k = 0; k < 3; ++k)
            for (int m = 0; m < 3; ++m) result(k, m) = z[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)];
        result.col(1) -= 0.5 * length_ * result.col(0);
        return result;
    }
    /// Whether the film was solved at the last s.
    bool converged() const { return converged_; }

private:
    double length_; // [m]
    std::optional<FilmOscillation> oscillation_;
    std::array<std::vector<double>, 3> byPressure_;
    std::array<std::array<double, 3>, 3> byAttitude_{};
    bool converged_ = true;
};

class EquilibriumSearch {
public:
    EquilibriumSearch(const Case& c, const std::function<bool()>& goOn) : case_(c), goOn_(goOn), scene_(case_)
    {
        case_.initial.state = InitialState::Static;
        case_.initial.heightOffset = case_.initial.pitchOffset = case_.initial.rollOffset = 0.0;
        case_.diskSurface = {};
        case_.run.fieldSnapshots = 0;
        case_.initial.branch = ContactBranch::TakeOff;
    }

    FilmEquilibria search(const std::vector<Attitude>& near)
    {
        switch (scene_.prepare(goOn_)) {
        case FilmScene::State::Stopped: result_.stopped = true; return std::move(result_);
        case FilmScene::State::Failed: result_.problem = scene_.message(); return std::move(result_);
        case FilmScene::State::Ready: break;
        }
        body_ = &scene_.body();
        contact_.emplace(case_, scene_.spacing());
        const Attitude rest = scene_.start();
        const double spacing = scene_.spacing().at(rest).spacing;
        FilmLevel& level = scene_.level();
        if (spacing > case_.onoYamane.touchDown) {
            const Matrix3 film = level.flying.stiffness(level.pressure, goOn_);
            describe(body_->coordinates(rest), aboutCentre(film, case_.slider.length), Eigen::Matrix3d::Zero(), false);
        }
        // What a mode presses into the film is dragged along at half the disk's speed, in waves U/(2 f) long: of fewer than ten cells each
        // they take from its damping, or add to it (core/simulation/modes.cpp).
        constexpr double enough = 10.0;
        result_.resolved = 0.5 * case_.disk.speed * case_.disk.radius * level.gaps.grid.nx() / (enough * case_.slider.length);
        const std::vector<double> still = level.pressure;
        const OnoYamane& law = case_.onoYamane;
        std::vector<Attitude> starts = near;
        for (const double target : {law.touchDown, 0.5 * (law.touchDown + law.takeOff), 0.6 * law.touchDown}) {
            Attitude lowered = rest;
            lowered.height += target - spacing;
            starts.push_back(lowered);
        }
        for (const Attitude& start : starts) {
            if (result_.stopped || !goOn_()) break;
            level.pressure = still;
            if (!refine(body_->coordinates(start))) ++result_.givenUp;
        }
        result_.stopped = result_.stopped || !goOn_();
        return std::move(result_);
    }

private:
    /// Steady film at q; false where it is not solved.
    bool solveFilm(const Vector3& q)
    {
        FilmLevel& level = scene_.level();
        level.film.setAttitude(body_->attitude(q));
        const FilmOptions options{.tolerance = case_.film.tolerance, .maximumIterations = case_.film.maximumIterations};
        return level.flying.solveFilm(level.pressure, options, [this](int, double) { return goOn_(); }).converged;
    }

    /// Sum of all forces at q, with the film as it was solved there.
    Vector3 forces(const Vector3& q)
    {
        FilmLevel& level = scene_.level();
        const std::array<double, 3> load = level.film.load(level.pressure);
        const std::array<double, 2> shear = level.film.shear(level.pressure);
        const Vector3 touch = contact_->at(body_->attitude(q), 0.0).load();
        Vector3 sum = body_->suspension(q, {});
        for (std::size_t k = 0; k < 3; ++k) sum[k] += load[k] + touch[k];
        sum[1] -= body_->shearArm() * shear[0];
        sum[2] -= body_->shearArm() * shear[1];
        if (body_->holdsRoll()) sum[2] = 0.0;
        return sum;
    }
    double error(const Vector3& g) const
    {
        return (std::abs(g[0]) + (std::abs(g[1]) + std::abs(g[2])) / case_.slider.length) / case_.suspension.preload;
    }

    /// False where nothing was learned; a residual that no step makes smaller tells that there is none near.
    bool refine(Vector3 q)
    {
        FilmLevel& level = scene_.level();
        if (!solveFilm(q)) return false;
        Vector3 g = forces(q);
        for (int k = 0; k < mostIterations; ++k) {
            if (!goOn_()) return false;
            const Eigen::Matrix3d film = aboutCentre(level.flying.stiffness(level.pressure, goOn_), case_.slider.length);
            contact_->at(body_->attitude(q), 0.0);
            const Eigen::Matrix3d touch = toEigen(contact_->stiffness());
            if (error(g) <= case_.steady.loadTolerance) {
                if (contact_->region() != ContactRegion::Apart) describe(q, film, touch, true);
                return true;
            }
            const Vector3 change = newtonStep(film + touch, g);
            double share = std::min(1.0, longestStep / std::max(body_->displacement(change), 1e-300));
            const std::vector<double> before = level.pressure;
            bool better = false, solved = false;
            for (int halving = 0; halving < mostHalvings && !better; ++halving, share *= 0.5) {
                Vector3 tried = q;
                for (std::size_t i = 0; i < 3; ++i) tried[i] += share * change[i];
                level.pressure = before;
                if (!solveFilm(tried)) {
                    if (!goOn_()) return false;
                    continue;
                }
                solved = true;
                const Vector3 there = forces(tried);
                better = error(there) < error(g);
                if (!better) continue;
                q = tried;
                g = there;
            }
            if (!better) return solved;
        }
        return false;
    }

    Vector3 newtonStep(const Eigen::Matrix3d& stiffness, const Vector3& g) const
    {
        Eigen::Matrix3d k = stiffness;
        for (int i = 0; i < 3; ++i) k(i, i) += body_->springs()[static_cast<std::size_t>(i)];
        const Eigen::Vector3d scale(1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width);
        const Eigen::Index n = body_->holdsRoll() ? 2 : 3;
        const Eigen::MatrixXd scaled = (scale.asDiagonal() * k * scale.asDiagonal()).topLeftCorner(n, n);
        const Eigen::VectorXd b = (scale.asDiagonal() * Eigen::Vector3d(g[0], g[1], g[2])).head(n);
        const Eigen::VectorXd x = scaled.fullPivLu().solve(b);
        Vector3 step{};
        for (Eigen::Index i = 0; i < n; ++i) step[static_cast<std::size_t>(i)] = scale[i] * x[i];
        return step;
    }

    void describe(const Vector3& q, const Eigen::Matrix3d& film, const Eigen::Matrix3d& touch, bool touching)
    {
        FilmEquilibrium at;
        at.attitude = body_->attitude(q);
        at.spacing = scene_.spacing().at(at.attitude).spacing;
        at.touching = touching;
        for (const FilmEquilibrium& other : result_.found) {
            const Vector3 there = body_->coordinates(other.attitude);
            if (other.touching == touching && body_->displacement({there[0] - q[0], there[1] - q[1], there[2] - q[2]}) < apart) return;
        }
        if (touching) {
            const SliderContactForces& forces = contact_->at(at.attitude, 0.0);
            at.netContactForce = forces.contact + forces.adhesion;
        }
        const Eigen::Index n = body_->holdsRoll() ? 2 : 3;
        Eigen::Matrix3d still = film + touch;
        for (int i = 0; i < 3; ++i) still(i, i) += body_->springs()[static_cast<std::size_t>(i)];
        findEigenvalues(at, touch, n);
        if (!goOn_()) return;
        const bool diverges = still.topLeftCorner(n, n).determinant() < 0.0;
        const bool grows = !at.eigenvalues.empty() && at.eigenvalues.front().real() > 0.0;
        at.stability = diverges ? Stability::Divergence : grows ? Stability::Flutter : Stability::Stable;
        result_.found.push_back(std::move(at));
    }

    /// As for the modes of the static state (core/simulation/film_modes.h), with the contact's stiffness.
    void findEigenvalues(FilmEquilibrium& at, const Eigen::Matrix3d& touch, Eigen::Index n)
    {
        FilmLevel& level = scene_.level();
        FilmAnswer film(level, body_->shearArm(), case_.slider.length, goOn_);
        std::vector<Complex> known;
        for (const double frequency : {1e5, 3e5, 1e6}) { // [Hz]
            if (!goOn_()) return;
            if (known.size() == static_cast<std::size_t>(n)) break;
            const std::vector<Complex> trials = others(trial(film, {0.0, 2.0 * std::numbers::pi * frequency}, touch, n), known);
            for (const Complex start : trials) {
                Complex s = start;
                if (!goOn_() || known.size() == static_cast<std::size_t>(n)) break;
                if (follow(film, s, touch, n, known)) known.push_back(s);
            }
        }
        at.lost = static_cast<int>(n) - static_cast<int>(known.size());
        result_.lost += at.lost;
        std::ranges::sort(known, [](Complex a, Complex b) { return a.real() > b.real(); });
        at.eigenvalues = std::move(known);
    }

    bool follow(FilmAnswer& film, Complex& s, const Eigen::Matrix3d& touch, Eigen::Index n, const std::vector<Complex>& known)
    {
        for (int pass = 0; pass < mostPasses && goOn_(); ++pass) {
            const std::vector<Complex> left = others(trial(film, s, touch, n), known);
            if (!film.converged() || left.empty()) return false;
            const Complex next = *std::ranges::min_element(left, {}, [&](Complex each) { return std::abs(each - s); });
            const double change = std::abs(next - s);
            s = next;
            if (change <= eigenvalueTolerance * std::abs(s)) return true;
        }
        return false;
    }

    /// The oscillations that there would be if the film answered at all rates as at s.
    std::vector<Complex> trial(FilmAnswer& film, Complex s, const Eigen::Matrix3d& touch, Eigen::Index n) const
    {
        constexpr double perRate = 1e-6; // [s]
        const Eigen::Matrix3cd answer = film.at(s);
        Eigen::Matrix3d damping = answer.imag() / s.imag();
        Eigen::Matrix3d stiffness = answer.real() - s.real() * damping + touch;
        Eigen::Matrix3d toMass = Eigen::Matrix3d::Zero();
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            stiffness(i, i) += body_->springs()[k];
            damping(i, i) += body_->dampers()[k];
            toMass(i, i) = 1.0 / body_->inertia()[k];
        }
        const Eigen::Vector3d scale(1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width);
        const Eigen::Matrix3d K = scale.asDiagonal().inverse() * (toMass * stiffness) * scale.asDiagonal();
        const Eigen::Matrix3d C = scale.asDiagonal().inverse() * (toMass * damping) * scale.asDiagonal();
        Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
        companion.topRightCorner(n, n).setIdentity();
        companion.bottomLeftCorner(n, n) = -K.topLeftCorner(n, n) * (perRate * perRate);
        companion.bottomRightCorner(n, n) = -C.topLeftCorner(n, n) * perRate;
        const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(companion, false).eigenvalues() / perRate;
        std::vector<Complex> list;
        for (const Complex value : values)
            if (value.imag() > 1e-6 * std::abs(value)) list.push_back(value);
        std::ranges::sort(list, {}, [](Complex value) { return value.imag(); });
        return list;
    }
    /// Without the nearest to each of the known ones.
    static std::vector<Complex> others(std::vector<Complex> list, const std::vector<Complex>& known)
    {
        for (const Complex mode : known) {
            const auto same = std::ranges::min_element(list, {}, [&](Complex each) { return std::abs(each - mode); });
            if (same != list.end()) list.erase(same);
        }
        return list;
    }

    Case case_;
    const std::function<bool()>& goOn_;
    FilmScene scene_;
    const SliderBody* body_ = nullptr;
    std::optional<OnoYamaneContact> contact_;
    FilmEquilibria result_;
};

} // namespace

std::string reasonForNoFilmEquilibria(const Case& c)
{
    if (c.model != ModelKind::Film) return "is no case of model \"film\"";
    if (c.contact != ContactKind::OnoYamane)
        return "equilibria of a film are sought with contact \"ono-yamane\" alone; the contact of surfaces depends on how it was reached";
    return {};
}

FilmEquilibria filmEquilibria(const Case& c, const std::vector<Attitude>& near, const std::function<bool()>& goOn)
{
    return EquilibriumSearch(c, goOn).search(near);
}

} // namespace touchdown
