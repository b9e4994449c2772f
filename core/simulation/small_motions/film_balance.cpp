// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/film_balance.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

namespace {

constexpr double sameForce = 1e-9; // on both sides of a switch, of the preload [-]
constexpr double sameSlope = 1e-9; // of the stiffness [-]

Eigen::Matrix3d toEigen(const Matrix3& m)
{
    Eigen::Matrix3d result;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) result(k, i) = m[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
    return result;
}

Case overFlatDisk(Case c)
{
    c.diskSurface = {};
    c.run.fieldSnapshots = 0;
    return c;
}

} // namespace

std::unique_ptr<FilmBalance> FilmBalance::make(const Case& c, const CellGrid& grid, const Attitude& rest,
                                               const GoOn& goOn)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    FilmGaps gaps(recess, grid, goOn);
    if (!goOn()) return nullptr;
    return std::unique_ptr<FilmBalance>(new FilmBalance(c, recess, std::move(gaps), rest));
}

FilmBalance::FilmBalance(const Case& c, const Recess& recess, FilmGaps gaps, const Attitude& rest)
    : case_(overFlatDisk(c)),
      spacing_(c.surface, recess),
      body_(case_, rest),
      load_(sliderLoad(case_)),
      level_(std::make_unique<FilmLevel>(case_, std::move(gaps), spacing_)),
      contact_(case_, spacing_),
      law_(case_.onoYamane)
{}

void FilmBalance::startFrom(const FilmBalance& other)
{
    // The rings hold each one's own ambient pressure.
    const PaddedGrid& pad = level_->gaps.pad;
    std::vector<double> known = pad.unpad<double>(other.level_->pressure);
    const double share = level_->film.ambient() / other.level_->film.ambient();
    for (double& p : known) p *= share;
    pad.pad<double>(known, level_->pressure);
}

bool FilmBalance::solve(const Vector3& q, const GoOn& goOn)
{
    q_ = q;
    level_->film.setAttitude(body_.attitude(q));
    const FilmOptions options{.tolerance = case_.film.tolerance, .maximumIterations = case_.film.maximumIterations};
    const FilmSolution film = level_->flying.solveFilm(level_->pressure, options, [&](int, double) { return goOn(); });
    return film.converged;
}

Vector3 FilmBalance::contactForce(ContactRegion region)
{
    contact_.setRegion(region);
    return contact_.at(body_.attitude(q_), 0.0).load();
}

double FilmBalance::netContactForce(ContactRegion region)
{
    contact_.setRegion(region);
    const SliderContactForces& forces = contact_.at(body_.attitude(q_), 0.0);
    return forces.contact + forces.adhesion;
}

Vector3 FilmBalance::force(ContactRegion region)
{
    const std::array<double, 5> film = level_->loads.loadAndShear(level_->pressure);
    const bool apart = region == ContactRegion::Apart;
    Vector3 sum = apart ? SliderBody(case_, body_.attitude(q_)).load() : body_.suspension(q_, {});
    const Vector3 touch = contactForce(region);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += film[k] + touch[k];
    sum[1] -= body_.shearArm() * film[3];
    sum[2] -= body_.shearArm() * film[4];
    if (body_.holdsRoll()) sum[2] = 0.0;
    return sum;
}

Eigen::Matrix3d FilmBalance::contactStiffness(ContactRegion region)
{
    contactForce(region);
    return toEigen(contact_.stiffness());
}

Eigen::Matrix3d FilmBalance::filmStiffness(const GoOn& goOn)
{
    Eigen::Matrix3d sum = toEigen(level_->flying.balanceStiffness(level_->pressure, goOn));
    // From the mass centre's height: the trailing edge's falls by half the length times the pitch.
    sum.col(1) -= 0.5 * case_.slider.length * sum.col(0);
    return sum;
}

Eigen::Matrix3d FilmBalance::stiffness(ContactRegion region, const GoOn& goOn)
{
    if (region != ContactRegion::Apart) return stiffnessWithSprings(region, goOn);
    Eigen::Matrix3d sum = filmStiffness(goOn);
    sum(1, 1) += load_.pitchStiffness;
    sum(2, 2) += load_.rollStiffness;
    return sum;
}

Eigen::Matrix3d FilmBalance::stiffnessWithSprings(ContactRegion region, const GoOn& goOn)
{
    Eigen::Matrix3d sum = filmStiffness(goOn) + contactStiffness(region);
    for (int i = 0; i < 3; ++i) sum(i, i) += body_.springs()[static_cast<std::size_t>(i)];
    return sum;
}

double FilmBalance::error(const Vector3& g) const
{
    return (std::abs(g[0]) + (std::abs(g[1]) + std::abs(g[2])) / case_.slider.length) / case_.suspension.preload;
}

Vector3 FilmBalance::newtonStep(const Eigen::Matrix3d& stiffness, const Vector3& g) const
{
    const Eigen::Vector3d scale(1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width);
    const Eigen::Index n = unknowns();
    const Eigen::MatrixXd scaled = (scale.asDiagonal() * stiffness * scale.asDiagonal()).topLeftCorner(n, n);
    const Eigen::VectorXd b = (scale.asDiagonal() * Eigen::Vector3d(g[0], g[1], g[2])).head(n);
    const Eigen::VectorXd x = scaled.fullPivLu().solve(b);
    Vector3 step{};
    for (Eigen::Index i = 0; i < n; ++i) step[static_cast<std::size_t>(i)] = scale[i] * x[i];
    return step;
}

Interval FilmBalance::interval(ContactRegion region)
{
    contact_.setRegion(region);
    return contact_.interval();
}

ContactRegion FilmBalance::lowest(ContactRegion region)
{
    contact_.setRegion(region);
    return contact_.region();
}

ContactRegion FilmBalance::regionOn(ContactBranch branch) const { return law_.region(branch, spacing(q_)); }

FilmBalance::Beyond FilmBalance::beyond(ContactRegion region, bool upper)
{
    const Vector3 here = contactForce(region);
    const Eigen::Matrix3d slope = toEigen(contact_.stiffness());
    Beyond result;
    result.name = contact_.cross(upper);
    result.region = contact_.region();
    const Vector3 there = contactForce(result.region);
    const Eigen::Matrix3d slopeThere = toEigen(contact_.stiffness());
    result.jumps = error({there[0] - here[0], there[1] - here[1], there[2] - here[2]}) > sameForce;
    result.kinks = std::abs(slopeThere(0, 0) - slope(0, 0)) >
                   sameSlope * std::max(std::abs(slopeThere(0, 0)), std::abs(slope(0, 0)));
    return result;
}

} // namespace touchdown
