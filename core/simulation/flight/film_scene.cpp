// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/case/disk_setup.h"
#include "core/formats/units.h"
#include "core/physics/film/film_energy.h"
#include "core/simulation/flight/film_run.h"
#include "core/simulation/small_motions/linear_state.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/high_disk.h"
#include "core/simulation/static_state/static_check.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/simulation/static_state/steady_near.h"
#include "core/work/state_stream.h"

namespace touchdown {

namespace {

constexpr double lowerForCells = 0.8;     // of the spacing at which the cells were last compared with the disk [-]
constexpr double leastForCells = 1e-9;    // below which they need no comparison [m]
constexpr double farthestFromRest = 1e-6; // no film is linear so far from its static state [m]

} // namespace

FilmScene::FilmScene(const Case& c)
    : recess(c.surface, c.slider.length, c.slider.width), spacing(c.surface, recess), case_(c), filmMaps_(filmMaps(c))
{}

FilmScene::~FilmScene() = default;

FilmScene::State FilmScene::fail(std::string reason)
{
    message = std::move(reason);
    return State::Failed;
}

SteadyResult FilmScene::findRest(const StaticSolution* known, const std::function<bool()>& goOn) const
{
    const Case still = attitudeCase(case_);
    const auto ask = [&](const SteadyProgress&) { return goOn(); };
    const bool fromRest = case_.initial.state == InitialState::Static || isLinear();
    // A start that is given needs the state of the film alone, where the suspension exerts its load.
    const bool fits = known && isRestOf(case_, known->solved, known->state) &&
                      (fromRest || !known->state.contact.acts()) && known->state.contact.state != "not found";
    if (!fits) return fromRest ? steadyWithContact(still, ask) : steady(still, ask);
    // Without its gaps it may come from a file, and is then solved again from near: at once, if the file is right.
    return known->state.gaps ? known->state : steadyNear(still, still, known->state, ask);
}

FilmScene::State FilmScene::prepare(const std::function<bool()>& goOn, const StaticSolution* known, KeptStates states)
{
    topography = diskTopography(case_, goOn);
    if (!goOn()) return State::Stopped;
    const std::shared_ptr<const LinearState> kept = !isLinear() || states == KeptStates::None ? nullptr
                                                    : states == KeptStates::Similar ? nearestLinearState(case_)
                                                                                    : knownLinearState(case_);
    SteadyResult rest = kept ? kept->rest : findRest(known, goOn);
    if (rest.status == SteadyStatus::Cancelled) return State::Stopped;
    const bool fromRest = case_.initial.state == InitialState::Static;
    if (isLinear() && rest.status != SteadyStatus::Converged)
        return fail("there is no static state about which the film is linear (film.motion): " + rest.message);
    if (fromRest && rest.status != SteadyStatus::Converged)
        return fail("there is no static state to start from (initial.state): " + rest.message);
    // Also where the film alone would balance below the plane of the disk.
    const bool balanced = rest.balanced();
    start = {case_.initial.nominalTrailingEdgeHeight, case_.initial.pitch, case_.initial.roll};
    if (!balanced)
        warnings.push_back(
            "no static state was found, so that the suspension is taken to exert its load at the initial attitude: " +
            rest.message);
    else if (std::string note = noteOnHeldRoll(case_, rest); !note.empty() && !rest.contact.acts())
        warnings.push_back(std::move(note));
    bool moved = false;
    bodyRest_ = balanced ? rest.suspensionRest.value_or(rest.attitude) : start;
    if (!makeParts(rest, goOn)) return State::Stopped;
    body.emplace(case_, bodyRest_);
    if (kept && !isStateOf(*kept, case_)) {
        body.emplace(bodyUnderLoad(case_, SliderBody(kept->solved, bodyRest_), kept->film.fit.at(0.0).real()));
        bodyRest_ = body->attitude(body->rest());
        if (!moveRest(kept->film, rest))
            return fail("with the film linear about the state of a similar case no state of rest was found");
        moved = true;
    }
    if (fromRest) {
        Vector3 q = body->coordinates(rest.attitude);
        q[0] += case_.initial.heightOffset;
        q[1] += case_.initial.pitchOffset;
        if (!body->holdsRoll()) q[2] += case_.initial.rollOffset;
        start = body->attitude(q);
    }

    if (moved && contact) contact->begin(case_.initial.branch, start);
    if (fromRest && rest.contact.acts()) {
        contact->begin(rest.contact.branch, start);
        contact->at(start, 0.0);
        startSurface.assign(level->gaps.pad.size(), 0.0);
        if (!disk->moves()) disk->at(0.0, startSurface);
        contact->deform(startSurface);
        level->film.setSurface(startSurface);
    }
    if (checkDisk() == State::Failed) return State::Failed;
    if (isLinear()) return makeLinear(kept, rest, goOn);
    if (balanced) {
        level->film.setAttitude(rest.attitude);
        restEnergy = FilmEnergy(level->film).at(level->pressure).stored;
    }
    const State state = solveStart(goOn);
    if (!balanced) restEnergy = FilmEnergy(level->film).at(level->pressure).stored;
    return state;
}

/// Newton's step against a force; zero for a held roll.
Vector3 FilmScene::stepOf(Matrix3 stiffness, Vector3 force) const
{
    if (body->holdsRoll()) {
        holdRoll(stiffness);
        force[2] = 0.0;
    }
    return solvePartialPivoting(stiffness, force);
}

bool FilmScene::moveRest(const LinearFilmModel& film, SteadyResult& rest)
{
    constexpr int mostSteps = 60;
    constexpr double longest = 1e-9, exact = 1e-16; // displacements of the corners [m]
    const Matrix3 still = film.fit.at(0.0).real(), springs = body->springs().asDiagonal();
    const ContactBranch branch = rest.contact.acts() ? rest.contact.branch : case_.initial.branch;
    Vector3 q = body->coordinates(rest.attitude);
    for (int k = 0; k < mostSteps; ++k) {
        rest.attitude = body->attitude(q);
        Vector3 force = film.force - still * (q - film.place) + body->suspension(q, Vector3::Zero());
        Matrix3 stiffness = still + springs;
        if (contact) {
            contact->begin(branch, rest.attitude);
            const SliderContactForces& touching = contact->at(rest.attitude, 0.0);
            if (!touching.problem.empty()) return false;
            force += touching.load();
            stiffness += contact->stiffness();
            rest.contact.contact = touching.contact;
            rest.contact.adhesion = touching.adhesion;
            rest.contact.branch = branch;
        }
        const Vector3 change = stepOf(stiffness, force);
        const double far = body->displacement(change);
        if (!(far < farthestFromRest)) return false;
        if (far <= exact) return true;
        q += std::min(1.0, longest / far) * change;
    }
    return false;
}

bool FilmScene::makeParts(const SteadyResult& rest, const std::function<bool()>& goOn)
{
    // Of a state that was not found the grid may be one of the coarser ones, or none.
    const std::array<int, 2> cells{case_.film.nodes[0] - 1, case_.film.nodes[1] - 1};
    const bool known = !rest.pressure.empty();
    const bool finest = known && rest.grid.nx() == cells[0] && rest.grid.ny() == cells[1];
    auto gaps = finest ? rest.gaps : std::make_shared<const FilmGaps>(recess, unadaptedGrid(case_, cells), goOn);
    if (!goOn() || !makeParts(std::move(gaps), goOn)) return false;
    if (finest)
        level->gaps.pad.pad<double>(rest.pressure, level->pressure);
    else if (known)
        level->gaps.pad.pad<double>(transfer(rest.grid, rest.pressure, level->film.ambient(), level->gaps.grid),
                                    level->pressure);
    return true;
}

bool FilmScene::makeParts(std::shared_ptr<const FilmGaps> gaps, const std::function<bool()>& goOn)
{
    level = std::make_unique<FilmLevel>(case_, std::move(gaps), spacing);
    disk.emplace(case_, topography, level->gaps.grid, level->gaps.pad);
    if (!goOn()) return false;
    contact = makeSliderContact(case_, spacing, topography, level->gaps.grid, level->gaps.pad, goOn);
    return goOn();
}

void FilmScene::pass(StateStream& stream)
{
    stream(warnings, bodyRest_, restEnergy, atCells_, lowestForCells_);
    if (!isLinear()) return;
    if (stream.reads()) linear = std::make_unique<LinearFilmModel>();
    stream(*linear);
}

void FilmScene::store(StateStream& stream)
{
    CellGrid grid = level->gaps.grid;
    pass(stream);
    stream(grid, *clearance);
}

FilmScene::State FilmScene::restore(StateStream& stream, const std::function<bool()>& goOn)
{
    CellGrid grid;
    pass(stream);
    stream(grid);
    if (grid.nx() != case_.film.nodes[0] - 1 || grid.ny() != case_.film.nodes[1] - 1) throw StateMisfit();
    topography = diskTopography(case_, goOn);
    if (!goOn()) return State::Stopped;
    body.emplace(case_, bodyRest_);
    auto gaps = std::make_shared<const FilmGaps>(recess, std::move(grid), goOn);
    if (!goOn() || !makeParts(std::move(gaps), goOn)) return State::Stopped;
    clearance.emplace(recess, spacing, topography, disk->velocity());
    stream(*clearance);
    lookAtCells(atCells_);
    return State::Ready;
}

void FilmScene::lookAtCells(const Attitude& attitude)
{
    atCells_ = attitude;
    diskOnCells = touchdown::diskOnCells(case_, topography, recess, level->gaps.grid, attitude);
}

void FilmScene::lookAtLower(const Attitude& attitude, double lowest)
{
    const double low = std::max(lowest, leastForCells);
    if (!(low < lowerForCells * lowestForCells_)) return;
    lookAtCells(attitude);
    lowestForCells_ = low;
}

FilmScene::State FilmScene::checkDisk()
{
    clearance.emplace(recess, spacing, topography, disk->velocity());
    lookAtCells(start);
    lowestForCells_ = spacing.at(start).spacing;
    if (case_.contact != noContact) return State::Ready;
    const DiskClearance::Place place = clearance->at(start, 0.0);
    return place.gap > 0.0 ? State::Ready : fail(diskReachesSlider(case_, place, 0.0) + "; " + startHigher());
}

bool FilmScene::isLinear() const { return case_.film.motion == FilmMotion::Linear; }

FilmScene::State FilmScene::makeLinear(std::shared_ptr<const LinearState> state, const SteadyResult& rest,
                                       const std::function<bool()>& goOn)
{
    try {
        if (!state || !answersDisk(*state, case_))
            state = makeLinearState(case_, rest, state ? &state->film : nullptr, goOn);
    } catch (const std::runtime_error& error) {
        return fail(error.what());
    }
    if (!state || !goOn()) return State::Stopped;
    linear = std::make_unique<LinearFilmModel>(state->film);
    linear->rest = body->coordinates(rest.attitude);
    if (case_.diskSurface.kind == DiskSurfaceKind::Rough)
        warnings.push_back("the linear film takes the disk as smooth: its roughness acts on the contact alone "
                           "(film.motion)");
    return State::Ready;
}

FilmScene::State FilmScene::solveStart(const std::function<bool()>& goOn)
{
    level->film.setAttitude(start);
    const auto monitor = [&](int, double) { return goOn(); };
    const FilmOptions options{.tolerance = case_.film.tolerance, .maximumIterations = case_.film.maximumIterations};
    FilmSolution film = level->flying.solveFilm(level->pressure, options, monitor);
    if (!film.converged && !film.cancelled) {
        std::ranges::fill(level->pressure, level->film.ambient());
        film = level->flying.solveFilm(level->pressure, options, monitor);
    }
    if (film.cancelled) return State::Stopped;
    if (film.converged) return State::Ready;
    const double lowest = spacing.at(start).spacing;
    return fail("the film was not solved at the initial attitude, where the minimum spacing is " +
                formatQuantity(std::round(lowest * 1e13) / 1e13, "nm") + "; " + startHigher() +
                (lowest > 0.0
                     ? " or allow more film.maximum_iterations"
                     : ": air that the rails shut in below the disk's mean plane may find no steady pressure"));
}

std::string FilmScene::startHigher() const
{
    return case_.initial.state == InitialState::Static ? "start higher (initial.height_offset)"
                                                       : "start higher (initial.nominal_trailing_edge_height)";
}

std::vector<FieldSnapshot> FilmScene::snapshots(double time, const Attitude& attitude, std::span<const double> p) const
{
    std::vector<FieldSnapshot> result;
    const CellGrid& grid = filmMaps_.grid;
    FieldSnapshot& film = result.emplace_back(FieldSnapshot{time, 0, std::vector<std::vector<double>>(2)});
    for (int j = 0; j < grid.ny(); ++j)
        for (int i = 0; i < grid.nx(); ++i) {
            const double x = grid.centreX(i), y = grid.centreY(j);
            film.values[0].push_back(recess.at(x, y) + level->gaps.lift(attitude, x, y));
        }
    film.values[1] = transfer(level->gaps.grid, level->gaps.pad.unpad<double>(p), level->film.ambient(), grid);
    if (contact) {
        FieldSnapshot& snapshot = result.emplace_back(FieldSnapshot{time, 1, {}});
        contact->observe(snapshot);
        if (snapshot.values.empty()) result.pop_back();
    }
    return result;
}

RecordedFields filmMaps(const Case& c)
{
    if (c.run.fieldSnapshots == 0 || c.film.motion == FilmMotion::Linear) return {};
    constexpr int mostCells = 128; // along each side
    RecordedFields maps;
    maps.grid = gradedGrid(c.surface, c.slider.length, c.slider.width, std::min(mostCells, c.film.nodes[0] - 1),
                           std::min(mostCells, c.film.nodes[1] - 1));
    maps.quantities = {{"gap", "m", "nm", "Gap to the mean plane of the disk"},
                       {"air_pressure", "Pa", "kPa", "Pressure of the air, absolute"}};
    return maps;
}

} // namespace touchdown
