// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/film_balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

constexpr double sameForce = 1e-9; // on both sides of a switch, of the preload [-]
constexpr double sameSlope = 1e-9; // of the stiffness [-]

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
    auto gaps = std::make_shared<const FilmGaps>(recess, grid, goOn);
    if (!goOn()) return nullptr;
    return std::make_unique<FilmBalance>(c, MinimumSpacing(c.surface, recess), std::move(gaps), rest);
}

FilmBalance::FilmBalance(const Case& c, MinimumSpacing spacing, std::shared_ptr<const FilmGaps> gaps,
                         const Attitude& rest)
    : case_(overFlatDisk(c)),
      spacing_(std::move(spacing)),
      body_(case_, rest),
      load_(sliderLoad(case_)),
      level_(std::make_unique<FilmLevel>(case_, std::move(gaps), spacing_)),
      contact_(case_, spacing_),
      law_(case_.onoYamane)
{}

FilmBalance::~FilmBalance() = default;

void FilmBalance::startFrom(const FilmBalance& other)
{
    // The rings hold each one's own ambient pressure.
    const PaddedGrid& pad = level_->gaps.pad;
    std::vector<double> known = pad.unpad<double>(other.level_->pressure);
    const double share = level_->film.ambient() / other.level_->film.ambient();
    for (double& p : known) p *= share;
    pad.pad<double>(known, level_->pressure);
    level_->flying.startFrom(other.level_->flying);
}

bool FilmBalance::solve(const Vector3& q, const GoOn& goOn)
{
    q_ = q;
    filmStiffness_.reset();
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
    const bool apart = region == ContactRegion::Apart;
    Vector3 sum = apart ? SliderBody(case_, body_.attitude(q_)).load() : body_.suspension(q_, Vector3::Zero());
    sum += body_.filmForce(level_->loads.loadAndShear(level_->pressure)) + contactForce(region);
    if (body_.holdsRoll()) sum[2] = 0.0;
    return sum;
}

Matrix3 FilmBalance::contactStiffness(ContactRegion region)
{
    contactForce(region);
    return contact_.stiffness();
}

const Matrix3& FilmBalance::filmStiffness(const GoOn& goOn)
{
    if (filmStiffness_) return *filmStiffness_;
    filmStiffness_ = level_->flying.balanceStiffness(level_->pressure, goOn);
    // From the mass centre's height: the trailing edge's falls by half the length times the pitch.
    filmStiffness_->col(1) -= 0.5 * case_.slider.length * filmStiffness_->col(0);
    return *filmStiffness_;
}

Matrix3 FilmBalance::stiffness(ContactRegion region, const GoOn& goOn)
{
    if (region != ContactRegion::Apart) return stiffnessWithSprings(region, goOn);
    Matrix3 sum = filmStiffness(goOn);
    sum(1, 1) += load_.pitchStiffness;
    sum(2, 2) += load_.rollStiffness;
    return sum;
}

Matrix3 FilmBalance::stiffnessWithSprings(ContactRegion region, const GoOn& goOn)
{
    Matrix3 sum = filmStiffness(goOn) + contactStiffness(region);
    sum.diagonal() += body_.springs();
    return sum;
}

double FilmBalance::error(const Vector3& g) const
{
    return (std::abs(g[0]) + (std::abs(g[1]) + std::abs(g[2])) / case_.slider.length) / case_.suspension.preload;
}

Vector3 FilmBalance::newtonStep(const Matrix3& stiffness, const Vector3& g) const
{
    const Vector3 scale(1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width);
    Matrix3 scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
    Vector3 b = scale.asDiagonal() * g;
    if (body_.holdsRoll()) {
        scaled.row(2).setZero();
        scaled.col(2).setZero();
        scaled(2, 2) = 1.0;
        b[2] = 0.0;
    }
    return scale.asDiagonal() * solveFullPivoting(scaled, b);
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
    const Matrix3 slope = contact_.stiffness();
    Beyond result;
    result.name = contact_.cross(upper);
    result.region = contact_.region();
    const Vector3 there = contactForce(result.region);
    const Matrix3 slopeThere = contact_.stiffness();
    result.jumps = error(there - here) > sameForce;
    result.kinks = std::abs(slopeThere(0, 0) - slope(0, 0)) >
                   sameSlope * std::max(std::abs(slopeThere(0, 0)), std::abs(slope(0, 0)));
    return result;
}

} // namespace touchdown
