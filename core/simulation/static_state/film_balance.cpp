// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/film_balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/case/contact_law.h"
#include "core/case/disk_setup.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_result.h"

namespace touchdown {

namespace {

constexpr double sameForce = 1e-9; // on both sides of a switch, of the preload [-]
constexpr double sameSlope = 1e-9; // of the stiffness [-]

/// With the part of the disk's surface that is still, for a contact that sees it, and contact solved in full.
Case overStillDisk(Case c, FilmBalance::Contact contact)
{
    const bool sees = contact == FilmBalance::Contact::Acts && contactLaw(c).seesDisk;
    if (c.diskSurface.motion != SurfaceMotion::Still || !sees) c.diskSurface = {};
    c.run.fieldSnapshots = 0;
    c.elastic.tolerance *= 1e-4; // under a film it is looser: see elastic_patch.h
    return c;
}

} // namespace

std::unique_ptr<FilmBalance> FilmBalance::make(const Case& c, const CellGrid& grid,
                                               std::shared_ptr<const FilmGaps> gaps, const Attitude& rest,
                                               const GoOn& goOn, Contact contact)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    if (!gaps) gaps = std::make_shared<const FilmGaps>(recess, grid, goOn);
    if (goOn && !goOn()) return nullptr;
    auto balance =
        std::make_unique<FilmBalance>(c, MinimumSpacing(c.surface, recess), std::move(gaps), rest, goOn, contact);
    return !goOn || goOn() ? std::move(balance) : nullptr;
}

std::unique_ptr<FilmBalance> FilmBalance::at(const Case& c, const SteadyResult& state, const GoOn& goOn)
{
    const Contact contact = state.contact.acts() ? Contact::Acts : Contact::Out;
    auto balance = make(c, state.grid, state.gaps, state.suspensionRest.value_or(state.attitude), goOn, contact);
    if (!balance) return nullptr;
    FilmLevel& level = *balance->level_;
    level.gaps.pad.pad<double>(state.pressure, level.pressure);
    const Vector3 q = balance->body_.coordinates(state.attitude);
    if (contact == Contact::Out)
        balance->moveTo(q), level.film.setAttitude(state.attitude);
    else if (!balance->settle(
                 q, state.contact.branch, goOn ? goOn : [] { return true; }))
        return nullptr;
    return balance;
}

FilmBalance::FilmBalance(const Case& c, MinimumSpacing spacing, std::shared_ptr<const FilmGaps> gaps,
                         const Attitude& rest, const GoOn& goOn, Contact contact)
    : case_(overStillDisk(c, contact)),
      spacing_(std::move(spacing)),
      body_(case_, rest),
      load_(sliderLoad(case_)),
      level_(std::make_unique<FilmLevel>(case_, std::move(gaps), spacing_)),
      topography_(diskTopography(case_, goOn)),
      disk_(case_, topography_, level_->gaps.grid, level_->gaps.pad),
      surface_(level_->gaps.pad.size(), 0.0)
{
    if (contact == Contact::Out) return;
    contact_ = makeSliderContact(case_, spacing_, topography_, level_->gaps.grid, level_->gaps.pad, goOn);
    contact_->begin(ContactBranch::TouchDown, rest);
    if (auto* pad = dynamic_cast<PadContact*>(contact_.get())) law_ = pad->characteristic();
}

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

/// The contact is at the attitude.
void FilmBalance::setSurface(const Attitude& attitude)
{
    if (contact_ && !law_) {
        disk_.at(0.0, surface_);
        const bool deformed = contact_->deform(surface_);
        level_->film.setSurface(deformed || !disk_.flat() ? std::span<const double>(surface_)
                                                          : std::span<const double>());
    }
    level_->film.setAttitude(attitude);
}

void FilmBalance::moveTo(const Vector3& q)
{
    q_ = q;
    slopes_.reset();
    filmStiffness_.reset();
}

bool FilmBalance::solve(const Vector3& q, const GoOn& goOn)
{
    moveTo(q);
    const Attitude attitude = body_.attitude(q);
    if (contact_ && !law_ && !contact_->at(attitude, 0.0).problem.empty()) return false;
    setSurface(attitude);
    const FilmOptions options{.tolerance = case_.film.tolerance, .maximumIterations = case_.film.maximumIterations};
    const FilmSolution film = level_->flying.solveFilm(level_->pressure, options, [&](int, double) { return goOn(); });
    residual_ = film.residual;
    return film.converged;
}

std::optional<ContactRegion> FilmBalance::settle(const Vector3& q, ContactBranch branch, const GoOn& goOn)
{
    const ContactRegion region = begin(branch, q);
    if (!solve(q, goOn) || !contactForces(region).problem.empty()) return std::nullopt;
    return region;
}

void FilmBalance::setRegion(ContactRegion region)
{
    if (law_) law_->setRegion(region);
}

const SliderContactForces& FilmBalance::contactForces(ContactRegion region)
{
    static const SliderContactForces none;
    setRegion(region);
    return contact_ ? contact_->at(body_.attitude(q_), 0.0) : none;
}

ContactRegion FilmBalance::begin(ContactBranch branch, const Vector3& q)
{
    if (!contact_) return ContactRegion::Apart;
    contact_->begin(branch, body_.attitude(q));
    return law_ ? law_->region() : ContactRegion::Pressed;
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
    if (!contact_) return Matrix3::Zero();
    contactForces(region);
    if (!contact_->deforms()) return contact_->stiffness();
    followElastic();
    return elasticStiffness_;
}

/// By central differences: an elastic contact knows its stiffness roughly, and deforms the disk under the film.
void FilmBalance::followElastic()
{
    if (slopes_) return;
    constexpr double step = 5e-12; // at the slider's corners [m]
    constexpr double rate = 1e6;   // of storage [1/s]
    GasFilm& film = level_->film;
    const std::vector<double>& p = level_->pressure;
    const Attitude at = body_.attitude(q_);
    const std::size_t size = p.size();
    std::vector<double> history(size), plain(size), stored(size);
    for (std::size_t i = 0; i < size; ++i) history[i] = rate * film.volumes()[i] * p[i];
    FilmSlopes& slopes = slopes_.emplace();
    Matrix3 byAttitude = Matrix3::Zero(); // of the contact
    for (std::size_t m = 0; m < 3; ++m) {
        slopes.flow[m].assign(size, 0.0);
        slopes.storage[m].assign(size, 0.0);
        const double way = m == 0 ? step : 2.0 * step / (m == 1 ? case_.slider.length : case_.slider.width);
        for (const double sign : {1.0, -1.0}) {
            const double per = sign / (2.0 * way);
            Attitude moved = at;
            (m == 0 ? moved.height : m == 1 ? moved.pitch : moved.roll) += sign * way;
            byAttitude.col(static_cast<Eigen::Index>(m)) -= per * contact_->at(moved, 0.0).load();
            setSurface(moved);
            film.setStorage(0.0, {});
            film.residual(p, plain);
            film.setStorage(rate, history);
            film.residual(p, stored);
            film.setStorage(0.0, {});
            for (std::size_t i = 0; i < size; ++i) {
                slopes.flow[m][i] += per * plain[i];
                slopes.storage[m][i] += per * (stored[i] - plain[i]) / rate;
            }
            const std::array<double, 5> forces = level_->loads.loadAndShear(p);
            for (std::size_t k = 0; k < 5; ++k) slopes.forces[k][m] += per * forces[k];
        }
    }
    // From the mass centre's height: the trailing edge's falls by half the length times the pitch.
    byAttitude.col(1) -= 0.5 * case_.slider.length * byAttitude.col(0);
    elasticStiffness_ = byAttitude;
    contact_->at(at, 0.0);
    setSurface(at);
}

const FilmSlopes* FilmBalance::filmSlopes()
{
    if (!contact_ || !contact_->deforms()) return nullptr;
    followElastic();
    return &*slopes_;
}

const Matrix3& FilmBalance::filmStiffness(const GoOn& goOn)
{
    if (filmStiffness_) return *filmStiffness_;
    level_->flying.setSlopes(filmSlopes());
    filmStiffness_ = level_->flying.balanceStiffness(level_->pressure, goOn);
    level_->flying.setSlopes(nullptr);
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

void FilmBalance::place(const Vector3& q, ContactBranch branch, ContactRegion region)
{
    moveTo(q);
    begin(branch, q);
    contactForces(region);
    setSurface(body_.attitude(q));
}

FlyingAttitude::Adjoint FilmBalance::adjoint(ContactRegion region)
{
    // Of contact and springs about q, by the attitude, beside what the film's balance knows; rows by force.
    Matrix3 beside = Matrix3::Zero();
    if (region != ContactRegion::Apart) {
        beside = contactStiffness(region);
        beside.diagonal() += body_.springs();
        // At a fixed height of the trailing edge the mass centre rises by half the length times the pitch.
        beside.col(1) += 0.5 * case_.slider.length * beside.col(0);
        beside(1, 1) -= load_.pitchStiffness;
        beside(2, 2) -= load_.rollStiffness;
        if (body_.holdsRoll()) beside.row(2).setZero();
    }
    level_->flying.setSlopes(filmSlopes());
    FlyingAttitude::Adjoint adjoint = level_->flying.adjoint(level_->pressure, beside);
    level_->flying.setSlopes(nullptr);
    return adjoint;
}

double FilmBalance::error(const Vector3& g) const { return level_->flying.loadError(g); }

Vector3 FilmBalance::newtonStep(const Matrix3& stiffness, const Vector3& g) const
{
    const Vector3 scale(1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width);
    Matrix3 scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
    Vector3 b = scale.asDiagonal() * g;
    if (body_.holdsRoll()) {
        holdRoll(scaled);
        b[2] = 0.0;
    }
    return scale.asDiagonal() * solveFullPivoting(scaled, b);
}

Interval FilmBalance::interval(ContactRegion region)
{
    setRegion(region);
    return contact_->interval();
}

ContactRegion FilmBalance::lowest(ContactRegion region)
{
    setRegion(region);
    return law_ ? law_->region() : region;
}

FilmBalance::Beyond FilmBalance::beyond(ContactRegion region, bool upper)
{
    const Vector3 here = contactForce(region);
    const Matrix3 slope = contact_->stiffness();
    Beyond result;
    result.name = contact_->cross(upper);
    result.region = law_ ? law_->region() : region;
    const Vector3 there = contactForce(result.region);
    const Matrix3 slopeThere = contact_->stiffness();
    result.jumps = error(there - here) > sameForce;
    result.kinks = std::abs(slopeThere(0, 0) - slope(0, 0)) >
                   sameSlope * std::max(std::abs(slopeThere(0, 0)), std::abs(slope(0, 0)));
    return result;
}

} // namespace touchdown
