// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/contact_rest.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <utility>

#include "core/case/contact_law.h"
#include "core/formats/words.h"
#include "core/physics/contact/contact_grid_error.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/sensitivity.h"
#include "core/simulation/static_state/static_check.h"
#include "core/simulation/static_state/touching_places.h"
#include "core/work/team.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double sameState = 1e-10; // of two states, at the slider's corners [m]

/// Half of the lines, of which the first and the last stay.
std::vector<double> everySecond(const std::vector<double>& lines)
{
    std::vector<double> half;
    for (std::size_t i = 0; i < lines.size(); i += 2) half.push_back(lines[i]);
    return half;
}

std::string stateName(const Case& c, ContactRegion region, const SliderContactForces& forces)
{
    if (!characteristic(c)) {
        if (forces.contact == 0.0 && forces.adhesion == 0.0) return "flying";
        if (forces.contact > 0.0) return "in contact";
        return contactLaw(c).menisci ? "held by menisci" : "flying, attracted";
    }
    switch (region) {
    case ContactRegion::Apart: return "flying";
    case ContactRegion::Pressed: return "pressed";
    case ContactRegion::Lifting: return "pressed, on the way out";
    case ContactRegion::Bridged: return "held by menisci";
    }
    return {};
}

/// Whether a small motion against this stiffness grows without oscillating; rows by force.
bool divergesAt(const Matrix3& stiffness, const SliderBody& body, Eigen::Index unknowns)
{
    const Vector3 root = body.inertia().cwiseSqrt();
    const Matrix3 perMass = root.cwiseInverse().asDiagonal() * stiffness * root.cwiseInverse().asDiagonal();
    for (const std::complex<double> value : eigenvaluesOf(SmallMatrix(perMass.topLeftCorner(unknowns, unknowns))))
        if (value.imag() == 0.0 && value.real() < 0.0) return true;
    return false;
}

ContactAtRest notFound(std::string state = "not found")
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {.state = std::move(state),
            .contact = none,
            .adhesion = none,
            .friction = none,
            .pitchTorque = none,
            .rollTorque = none,
            .area = none,
            .peakPressure = none};
}

class ContactRestSearch {
public:
    ContactRestSearch(const Case& c, SteadyResult& result, const SteadyCallback& callback)
        : case_(c), result_(result), goOn_([this, &callback] {
              if (!stopped_ && callback && !callback(progressAbout(result_, "contact"))) stopped_ = true;
              return !stopped_;
          })
    {}

    void search()
    {
        const bool balanced = result_.balanced();
        rest_ = balanced ? result_.attitude
                         : Attitude{case_.initial.nominalTrailingEdgeHeight, case_.initial.pitch, case_.initial.roll};
        const std::array<int, 2> cells{case_.film.nodes[0] - 1, case_.film.nodes[1] - 1};
        const bool finest = balanced || (!result_.pressure.empty() && result_.grid.nx() == cells[0]);
        grid_ = finest ? result_.grid : unadaptedGrid(case_, cells);
        balance_ = balanceOn(case_, grid_, finest ? result_.gaps : nullptr);
        if (!balance_) return stop();
        FilmLevel& level = balance_->level();
        if (!result_.pressure.empty())
            level.gaps.pad.pad<double>(finest ? result_.pressure
                                              : transfer(result_.grid, result_.pressure, level.film.ambient(), grid_),
                                       level.pressure);
        const Vector3 q = balance_->body().coordinates(rest_);
        result_.contact = {.state = "flying"};
        const bool above = balanced && result_.status == SteadyStatus::Converged;
        const ContactRegion region = balance_->begin(ContactBranch::TouchDown, q);
        balance_->place(q, ContactBranch::TouchDown, region);
        const SliderContactForces fromAfar = balance_->contactForces(region);
        flies_ = above && fromAfar.contact == 0.0 && fromAfar.adhesion == 0.0;
        std::vector<TouchingPlace> found;
        const auto take = [&](TouchingPlaces places) {
            givenUp_ += places.givenUp;
            if (!places.problem.empty()) problem_ = std::move(places.problem);
            for (TouchingPlace& place : places.found)
                if (std::ranges::none_of(found, [&](const TouchingPlace& other) {
                        return balance_->body().displacement(other.q - place.q) < sameState;
                    }))
                    found.push_back(place);
        };
        const std::string below = balance_->contact().problemAt(rest_);
        // A law that acts in flight: the state that is reached from afar.
        if (above && !flies_) take(touchingPlaces(*balance_, {rest_}, ContactBranch::TouchDown, goOn_));
        // Those of surfaces that attract each other take long: only where they are asked for.
        const bool asked = !contactLaw(case_).recordsSurfaces || case_.initial.branch == ContactBranch::TakeOff;
        const bool mayHaveSeveral = makeSeparationLaw(case_) || (contactLaw(case_).adheres(case_) && asked);
        if (mayHaveSeveral || (found.empty() && !flies_)) take(touchingPlaces(*balance_, rest_, goOn_));
        // Pressed hard it lies flatter, and parked, without air, flat on its crown.
        for (const double share : {0.6, 0.3, 0.0})
            if (found.empty() && !flies_ && !stopped_ && below.empty())
                take(touchingPlaces(*balance_, {rest_.height, share * rest_.pitch, share * rest_.roll}, goOn_));
        if (stopped_) return stop();
        if (!below.empty() && found.empty()) problem_ = below;
        report(found);
    }

    /// From the state in contact that the result is. False where none is found there.
    bool searchNear()
    {
        rest_ = result_.suspensionRest.value_or(result_.attitude);
        grid_ = result_.grid;
        balance_ = balanceOn(case_, grid_, result_.gaps);
        if (!balance_) return stop(), true;
        FilmLevel& level = balance_->level();
        level.gaps.pad.pad<double>(result_.pressure, level.pressure);
        const TouchingPlaces near = touchingPlaces(*balance_, {result_.attitude}, result_.contact.branch, goOn_);
        if (stopped_) return stop(), true;
        const std::optional<Found> found = near.found.empty() ? std::nullopt : look(near.found.front());
        if (!found) return false;
        result_.contactStates.clear();
        take(*found, false);
        return true;
    }

private:
    std::unique_ptr<FilmBalance> balanceOn(const Case& c, const CellGrid& grid, std::shared_ptr<const FilmGaps> gaps)
    {
        return FilmBalance::make(c, grid, std::move(gaps), rest_, goOn_);
    }

    void stop()
    {
        result_.status = SteadyStatus::Cancelled;
        result_.message = "cancelled while contact was sought";
        result_.contact = notFound("not known");
    }

    struct Found {
        TouchingPlace place;
        RestingState state;
    };

    /// Solves film and contact at a place.
    std::optional<Found> look(const TouchingPlace& place)
    {
        if (!balance_->settle(place.q, place.branch, goOn_)) return std::nullopt;
        const Attitude attitude = balance_->body().attitude(place.q);
        if (std::string problem = balance_->contact().problemAt(attitude); !problem.empty()) {
            problem_ = std::move(problem);
            return std::nullopt;
        }
        Found found{place, {attitude, balance_->spacing(place.q), {}}};
        const SliderContactForces forces = balance_->contactForces(place.region);
        const Matrix3 still = balance_->stiffnessWithSprings(place.region, goOn_);
        found.state.contact = {.state = stateName(case_, place.region, forces),
                               .contact = forces.contact,
                               .adhesion = forces.adhesion,
                               .friction = forces.friction,
                               .pitchTorque = forces.pitchTorque,
                               .rollTorque = forces.rollTorque,
                               .area = forces.area,
                               .peakPressure = forces.peakPressure,
                               .diverges = divergesAt(still, balance_->body(), balance_->unknowns()),
                               .region = place.region,
                               .branch = place.branch};
        return found;
    }

    void report(const std::vector<TouchingPlace>& places)
    {
        std::vector<Found> states;
        for (const TouchingPlace& place : places)
            if (std::optional<Found> found = look(place))
                if (!flies_ || found->state.contact.acts()) states.push_back(std::move(*found));
        if (stopped_) return stop();
        // The one that a slider comes to: stable ones first, then those in contact where they are asked for, then the
        // highest.
        const bool inContact = case_.initial.branch == ContactBranch::TakeOff;
        std::ranges::stable_sort(states, [inContact](const Found& a, const Found& b) {
            const RestingState &x = a.state, &y = b.state;
            if (x.contact.diverges != y.contact.diverges) return y.contact.diverges;
            const bool touchesX = x.contact.contact > 0.0, touchesY = y.contact.contact > 0.0;
            if (inContact && touchesX != touchesY) return touchesX;
            return x.minimumSpacing > y.minimumSpacing;
        });
        const bool preferred = inContact && !states.empty() && !states.front().state.contact.diverges;
        const bool touches = (!flies_ || preferred) && !states.empty();
        if (touches && flies_)
            result_.contactStates.push_back({result_.attitude, result_.minimumSpacing, result_.contact});
        if (touches) take(states.front());
        for (std::size_t i = touches ? 1 : 0; i < states.size(); ++i) result_.contactStates.push_back(states[i].state);
        if (!flies_ && states.empty()) {
            result_.contact = notFound();
            result_.status = result_.status == SteadyStatus::Converged ? SteadyStatus::NotConverged : result_.status;
            result_.note(problem_.empty() ? "no state in contact was found from the attitudes that were tried"
                                          : uncapitalized(problem_));
            if (givenUp_ > 0)
                result_.message += " (" + counted(static_cast<std::size_t>(givenUp_), "attempt") + " came to no end)";
        }
    }

    /// Makes it the state of the result. `inFull`: with the error of the grid.
    void take(const Found& found, bool inFull = true)
    {
        const ContactAtRest& contact = found.state.contact;
        if (!balance_->settle(found.place.q, found.place.branch, goOn_)) return stop(); // it was solved before
        FilmLevel& level = balance_->level();
        SteadyResult& r = result_;
        r.suspensionRest = rest_;
        const bool wasFound = r.balanced();
        const Vector3 ofForces = errorOfForces();
        r.status = SteadyStatus::Converged;
        r.message.clear();
        r.contact = contact;
        setState(r, case_, level, balance_->spacings(), found.state.attitude);
        r.residual = balance_->residual();
        r.loadError = balance_->error(balance_->force(found.place.region));
        r.stiffness.reset();
        if (case_.steady.stiffness) r.stiffness = level.flying.stiffness(level.pressure);
        r.contactStiffness = balance_->contactStiffness(found.place.region);
        r.sensitivities.clear();
        if (case_.steady.sensitivities) r.sensitivities = sensitivities(case_, *balance_, contact);
        r.otherEquilibria.clear();
        r.discretisationError = inFull ? errorOf(found, ofForces) : DiscretisationError{};
        if (!wasFound)
            r.note("the film alone has no static state, so that the suspension is taken to exert its load at the "
                   "initial attitude");
        r.note(noteOnHeldRoll(case_, r));
        for (const std::string& remark : balance_->contact().remarks()) r.note(remark);
        if (contact.diverges) r.note("the state is unstable: a small motion grows");
        if (case_.diskSurface.kind != DiskSurfaceKind::Flat && case_.diskSurface.motion == SurfaceMotion::Moving)
            r.note("the contact is that of the disk's mean plane; a run shows what its moving surface adds");
        if (stopped_) stop();
    }

    /// By which the grid may miss force and torques of the film, as far as the state of the film alone tells.
    Vector3 errorOfForces()
    {
        const DiscretisationError& e = result_.discretisationError;
        if (!result_.balanced() || std::isnan(e.load)) return Vector3::Zero();
        FilmLevel& level = balance_->level();
        const Matrix3 film = result_.stiffness ? *result_.stiffness : level.flying.roughStiffness(level.pressure);
        return {e.load, std::abs(film(1, 1)) * e.pitch, std::abs(film(2, 2)) * e.roll};
    }

    /// Half of the difference from the state on half of the film's lines, and of an elastic contact that from cells
    /// twice as large; at least what an error of the film's forces moves the slider against film, contact and
    /// suspension.
    DiscretisationError errorOf(const Found& found, const Vector3& ofForces)
    {
        DiscretisationError error;
        if (grid_.nx() % 2 == 0 && grid_.ny() % 2 == 0)
            error = differenceFrom(found, case_, {everySecond(grid_.x), everySecond(grid_.y)}, nullptr, 0.5);
        if (contactLaw(case_).recordsSurfaces) {
            if (edgesHangOnCells(case_)) return {}; // the remark says so
            Case coarse = case_;
            coarse.elastic.cell *= 2.0;
            const DiscretisationError cells =
                differenceFrom(found, coarse, grid_, balance_->level().film.sharedGaps(), moreThanCoarse);
            error.minimumSpacing += cells.minimumSpacing;
            error.pitch += cells.pitch;
            error.roll += cells.roll;
            error.load += cells.load;
        }
        Matrix3 stiffness = balance_->stiffnessWithSprings(found.place.region, goOn_);
        if (balance_->body().holdsRoll()) holdRoll(stiffness);
        const auto moved = [&](const Vector3& direction) {
            const Vector3 byForces = solvePartialPivoting(stiffness.transpose(), direction).cwiseAbs();
            return byForces.head(balance_->unknowns()).dot(ofForces.head(balance_->unknowns()));
        };
        const SurfacePoint at = result_.minimumAt;
        const Vector3 spacing(1.0, 0.5 * case_.slider.length - at.x, 0.5 * case_.slider.width - at.y);
        error.minimumSpacing = std::max(error.minimumSpacing, moved(spacing));
        error.pitch = std::max(error.pitch, moved({0.0, 1.0, 0.0}));
        error.roll = std::max(error.roll, moved({0.0, 0.0, 1.0}));
        error.load = std::max(error.load, ofForces[0]);
        return error;
    }

    /// A share of the difference from the state on another grid; NaN where that has no such state.
    DiscretisationError differenceFrom(const Found& found, const Case& c, const CellGrid& grid,
                                       const std::shared_ptr<const FilmGaps>& gaps, double share)
    {
        DiscretisationError error;
        const std::unique_ptr<FilmBalance> other = balanceOn(c, grid, gaps);
        if (!other) return error;
        FilmLevel& level = other->level();
        const FilmLevel& fine = balance_->level();
        level.gaps.pad.pad<double>(
            transfer(grid_, fine.gaps.pad.unpad<double>(fine.pressure), fine.film.ambient(), grid), level.pressure);
        const TouchingPlaces places = touchingPlaces(*other, {found.state.attitude}, found.place.branch, goOn_);
        if (places.found.empty() || !other->settle(places.found.front().q, found.place.branch, goOn_)) return error;
        const Vector3 q = places.found.front().q;
        const Attitude there = other->body().attitude(q);
        error.minimumSpacing = share * std::abs(other->spacing(q) - found.state.minimumSpacing);
        error.pitch = share * std::abs(there.pitch - found.state.attitude.pitch);
        error.roll = share * std::abs(there.roll - found.state.attitude.roll);
        error.load = share * std::abs(level.loads.forces(level.pressure).net - result_.forces.net);
        return error;
    }

    const Case& case_;
    SteadyResult& result_;
    std::function<bool()> goOn_;
    bool stopped_ = false, flies_ = false;
    Attitude rest_;
    CellGrid grid_;
    std::unique_ptr<FilmBalance> balance_;
    int givenUp_ = 0;     // attempts
    std::string problem_; // of a state that was not taken
};

} // namespace

bool seesStillDisk(const Case& c)
{
    return c.diskSurface.kind != DiskSurfaceKind::Flat && c.diskSurface.motion == SurfaceMotion::Still &&
           contactLaw(c).seesDisk;
}

bool actsInFlight(const Case& c, const SteadyResult& state, const std::function<bool()>& goOn)
{
    const std::unique_ptr<FilmBalance> balance = FilmBalance::make(c, state.grid, state.gaps, state.attitude, goOn);
    if (!balance) return false;
    const Vector3 q = balance->body().coordinates(state.attitude);
    const ContactRegion region = balance->begin(ContactBranch::TouchDown, q);
    balance->place(q, ContactBranch::TouchDown, region);
    return balance->contactForces(region).load() != Vector3::Zero();
}

std::optional<SteadyResult> touchingNear(const Case& c, const SteadyResult& from, const SteadyCallback& callback)
{
    const TeamScope team(staticThreads(c));
    SteadyResult result = from;
    Case near = c;
    near.steady.stiffness = near.steady.sensitivities = false;
    ContactRestSearch search(near, result, callback);
    if (!search.searchNear()) return std::nullopt;
    return result;
}

SteadyResult steadyWithContact(const Case& c, const SteadyCallback& callback)
{
    const double start = wallClock();
    const TeamScope team(staticThreads(c));
    SteadyResult result = steady(c, callback);
    if (c.contact == noContact || c.steady.fixedAttitude) return result;
    result.contact = notFound("not known");
    if (result.status == SteadyStatus::Cancelled) return result;
    ContactRestSearch(c, result, callback).search();
    result.wallSeconds = wallClock() - start;
    return result;
}

} // namespace touchdown
