// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/film_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "core/physics/film_energy.h"
#include "core/simulation/disk_setup.h"
#include "core/simulation/film_recorder.h"
#include "core/simulation/film_setup.h"
#include "core/simulation/steady.h"
#include "core/simulation/units.h"

namespace touchdown {

namespace {

constexpr double firstStep = 2e-9;      // [s]
constexpr double shortestStep = 1e-14;  // [s]
constexpr double longestShare = 0.01;   // of the run, for a step
// A longer step needs a new linearisation, so it must be worth it, and not only for a moment of an oscillation.
constexpr double worthGrowing = 1.6, worthGrowingAtOnce = 4.0;
constexpr int patience = 16;            // steps
constexpr double mostGrowth = 2.0;      // BDF2 is stable up to 1 + sqrt 2 (Grigorieff 1983)
constexpr double longestPhase = 0.7;    // omega dt: of longer steps BDF2 would damp a motion more than the film does
constexpr double safety = 0.9;          // of a step against the longest whose error is allowed
constexpr double worstFactor = 0.75;    // below which a step is tried again
constexpr double positionShare = 5e-3;  // of a step's error, for what is left of its iteration
constexpr double filmShare = 0.1;       // and for what is left of the film, as what its force would displace a slider by
constexpr double typicalScale = 10e-9;  // over which a film's force changes by the load [m]
constexpr double switchShare = 0.05;    // of a step's error, to which a switch's separation is located [-]
constexpr int mostTries = 12;           // for one switch
constexpr int mostSwitches = 64;        // within chatterTime
constexpr double chatterTime = 1e-7;    // [s]
constexpr double farthest = 1e-4;       // from which no slider comes back [m]

double wallClock()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string timeText(double t) { return formatQuantity(std::round(t * 1e10) / 1e10, "us"); }

/// The case whose static state gives a run its grid, and its suspension the place where it exerts its load.
Case staticCase(const Case& c)
{
    Case result = c;
    result.steady.fixedAttitude = result.steady.stiffness = result.steady.sensitivities = result.steady.allEquilibria = false;
    return result;
}

class FilmRun {
public:
    FilmRun(const Case& c, const RunCallback& callback)
        : case_(c), callback_(callback), recess_(c.surface, c.slider.length, c.slider.width), spacing_(c.surface, recess_),
          topography_(diskTopography(c))
    {
    }

    Summary run()
    {
        const double begin = wallClock();
        Summary summary;
        lastCall_ = begin;
        if (prepare()) advance();
        if (recorder_) {
            recorder_->flush();
            if (recorder_->stopped() && status_ == RunStatus::Completed) stop();
            recorder_->finish(summary);
        }
        summary.status = status_;
        summary.message = message_;
        summary.steps = steps_;
        summary.rejectedSteps = rejected_;
        summary.evaluations = filmIterations_;
        summary.warnings = warnings_;
        if (contact_)
            for (std::string& remark : contact_->remarks()) summary.warnings.push_back(std::move(remark));
        if (stepper_) addCost(summary);
        summary.wallSeconds = wallClock() - begin;
        summary.solverSeconds = summary.wallSeconds - (recorder_ ? recorder_->secondsOutside() : 0.0);
        return summary;
    }

private:
    void addCost(Summary& summary) const
    {
        const CoupledCost& cost = stepper_->cost();
        const auto add = [&](const char* name, const char* unit, const char* longName, double value) {
            summary.figures.push_back({{name, unit, unit, longName}, value});
        };
        add("film_time", "s", "Wall time of the film's steps", cost.filmSeconds);
        add("response_time", "s", "Wall time of the film's responses to the attitude", cost.responseSeconds);
        add("force_time", "s", "Wall time of the film's forces", cost.forceSeconds);
        add("contact_time", "s", "Wall time of the contact", cost.contactSeconds);
        add("disk_time", "s", "Wall time of the disk's surface under the film", cost.diskSeconds);
        add("film_solves", "1", "Attitudes at which the film was solved", static_cast<double>(cost.filmSolves));
        add("linearisations", "1", "Linearisations of the film", static_cast<double>(cost.linearisations));
        add("contact_solves", "1", "Attitudes at which the contact was asked", static_cast<double>(cost.contactSolves));
        add("contact_skipped", "1", "Attitudes at which no contact was in reach", static_cast<double>(cost.contactSkipped));
        add("energy_balance", "1", "Energy that the books miss, against the largest change of a part", recorder_->energyImbalance());
    }

    /// Static state, initial state, film. False when the run ends here.
    bool prepare()
    {
        const SteadyResult rest = steady(staticCase(case_), [this](const SteadyProgress&) { return goOn(); });
        if (rest.status == SteadyStatus::Cancelled) return stop();
        const bool balanced = rest.status == SteadyStatus::Converged || rest.status == SteadyStatus::Failed;
        if (case_.initial.state == InitialState::Static && rest.status != SteadyStatus::Converged)
            return fail(RunStatus::Failed, "there is no static flying state to start from (initial.state): " + rest.message);
        Attitude attitude{case_.initial.nominalTrailingEdgeHeight, case_.initial.pitch, case_.initial.roll};
        if (!balanced)
            warnings_.push_back("no static state was found, so that the suspension is taken to exert its load at the initial attitude: " +
                                rest.message);
        body_.emplace(case_, balanced ? rest.attitude : attitude);
        if (case_.initial.state == InitialState::Static) {
            Vector3 q = body_->coordinates(rest.attitude);
            q[0] += case_.initial.heightOffset;
            q[1] += case_.initial.pitchOffset;
            if (!body_->holdsRoll()) q[2] += case_.initial.rollOffset;
            attitude = body_->attitude(q);
        }

        level_ = std::make_unique<FilmLevel>(case_, recess_, spacing_, rest.grid);
        level_->gaps.pad.pad<double>(rest.pressure, level_->pressure);
        disk_.emplace(case_, topography_, level_->gaps.grid, level_->gaps.pad);
        contact_ = makeSliderContact(case_, spacing_, topography_, level_->gaps.grid, level_->gaps.pad, [this] { return goOn(); });
        energy_.emplace(level_->film);
        level_->film.setAttitude(balanced ? rest.attitude : attitude);
        restEnergy_ = energy_->at(level_->pressure).stored;
        level_->film.setAttitude(attitude);
        const auto monitor = [this](int, double) { return goOn(); };
        const FilmOptions options{.tolerance = case_.film.tolerance, .maximumIterations = case_.film.maximumIterations};
        FilmSolution film = level_->flying.solveFilm(level_->pressure, options, monitor);
        if (!film.converged && !film.cancelled) {
            std::ranges::fill(level_->pressure, level_->film.ambient());
            film = level_->flying.solveFilm(level_->pressure, options, monitor);
        }
        if (film.cancelled) return stop();
        if (!film.converged)
            return fail(RunStatus::Failed, "the film was not solved at the initial attitude (minimum spacing " +
                                               formatQuantity(std::round(spacing_.at(attitude).spacing * 1e13) / 1e13, "nm") + ")");

        CoupledStepOptions stepping;
        stepping.coupling = case_.film.coupling;
        stepping.tolerance = positionShare * case_.run.stepError;
        stepping.film.tolerance = std::max(1e-9, filmShare * case_.run.stepError / typicalScale * case_.suspension.preload /
                                                     (level_->film.ambient() * case_.slider.length * case_.slider.width));
        stepper_.emplace(level_->film, *body_, contact_.get(), &*disk_, stepping);
        const Vector3 q = body_->coordinates(attitude);
        stepper_->start(level_->pressure,
                        {q, {case_.initial.verticalVelocity, case_.initial.pitchVelocity,
                             body_->holdsRoll() ? 0.0 : case_.initial.rollVelocity}, {}},
                        0.0);
        if (!stepper_->contactForces().problem.empty())
            return fail(RunStatus::Failed, "no contact state was found at the start: " + stepper_->contactForces().problem);
        recorder_.emplace(case_, *body_, recess_, spacing_, callback_);
        point_ = pointNow(0.0);
        point_.filmEnergy = energy_->at(stepper_->pressure()).stored - restEnergy_;
        recorder_->begin(point_);
        takeFields();
        return true;
    }

    void advance()
    {
        const double duration = case_.run.duration;
        wanted_ = fixed() ? case_.run.step : firstStep;
        while (stepper_->time() < duration) {
            if (!recorder_->lookAtClock()) {
                stop();
                return;
            }
            if (!advanceOnce()) return;
        }
    }

    double switchWidth() const { return switchShare * case_.run.stepError; }
    bool fixed() const { return case_.run.steps == StepControl::Fixed; }

    double nextLength() const
    {
        double dt = wanted_;
        if (point_.dt > 0.0) dt = std::min(dt, mostGrowth * point_.dt);
        if (fixed()) return dt;
        dt = std::min(dt, longestShare * case_.run.duration);
        if (const double rate = stepper_->fastestRate(); rate > 0.0) dt = std::min(dt, longestPhase / rate);
        if (contact_ && stepper_->contactInReach()) dt = std::min(dt, contact_->longestStep());
        return dt;
    }

    /// One accepted step, however many tries it takes. False when the run ends here.
    bool advanceOnce()
    {
        double dt = nextLength();
        while (true) {
            const CoupledStepResult result = tryStep(dt);
            if (recorder_->stopped()) return stop();
            if (!result.converged()) {
                ++rejected_;
                dt *= 0.5;
                wanted_ = std::min(wanted_, dt);
                if (dt < shortestStep) return giveUp(result);
                continue;
            }
            const double factor = safety * std::cbrt(case_.run.stepError / std::max(result.timeError, 1e-300));
            if (!fixed() && factor < worstFactor) {
                ++rejected_;
                dt *= std::max(factor, 0.25);
                wanted_ = dt;
                sinceLimit_ = 0;
                if (dt < shortestStep) return giveUp(result);
                continue;
            }
            if (const std::optional<double> length = wayToSwitch(dt)) return goToSwitch(*length);
            if (!fixed()) setWanted(dt, factor);
            return takeStep(dt);
        }
    }

    /// After a step whose length may be changed by the factor.
    void setWanted(double dt, double factor)
    {
        if (factor < 1.0) wanted_ = factor * dt;
        sinceLimit_ = factor < worthGrowing ? 0 : sinceLimit_ + 1;
        if (factor < worthGrowingAtOnce && sinceLimit_ < patience) return;
        wanted_ = std::max(wanted_, std::min(mostGrowth, factor) * dt);
        sinceLimit_ = 0;
    }

    CoupledStepResult tryStep(double dt)
    {
        const CoupledStepResult result = stepper_->step(dt);
        filmIterations_ += result.filmIterations;
        recorder_->lookAtClock();
        return result;
    }

    bool takeStep(double dt)
    {
        stepper_->accept();
        ++steps_;
        const FilmPoint before = point_;
        point_ = pointNow(dt);
        takeEnergy(before);
        recorder_->add(point_);
        takeFields();
        const Attitude attitude = body_->attitude(point_.motion.q);
        if (contact_)
            if (const std::string problem = contact_->problemAt(attitude); !problem.empty())
                return fail(RunStatus::Failed, problem + " at " + timeText(point_.time));
        if (spacing_.at(attitude).spacing > farthest)
            return fail(RunStatus::Diverged, "the slider left the disk: at " + timeText(point_.time) + " it is " +
                                                 formatQuantity(std::round(spacing_.at(attitude).spacing * 1e9) / 1e9, "um") +
                                                 " above it");
        return true;
    }

    /// How much of the tried step there is to the first switch of the contact's law [s]; none: it holds to the end.
    std::optional<double> wayToSwitch(double dt) const
    {
        if (!contact_) return std::nullopt;
        const Interval holds = contact_->interval();
        if (!std::isfinite(holds.lower) && !std::isfinite(holds.upper)) return std::nullopt;
        FilmPoint end = point_;
        end.time += dt;
        end.motion = stepper_->tried();
        const auto beyond = [&](double share) {
            const double d = contact_->separation(body_->attitude(between(point_, end, share).q));
            return std::max(d - holds.upper, holds.lower - d);
        };
        constexpr int looks = 8; // within a step, so that a short visit is not missed
        double inside = 0.0;
        for (int k = 1; k <= looks; ++k) {
            double outside = double(k) / looks;
            if (!(beyond(outside) > 0.0)) {
                inside = outside;
                continue;
            }
            // Just crossed: what is left of it by rounding is no way back.
            if (k == looks && beyond(outside) <= switchWidth()) return dt;
            for (int n = 0; n < 60; ++n) {
                const double middle = 0.5 * (inside + outside);
                (beyond(middle) > 0.0 ? outside : inside) = middle;
            }
            return outside * dt;
        }
        return std::nullopt;
    }

    /// Ends a step where the contact's law switches, found by secants, and takes the law that holds beyond.
    bool goToSwitch(double length)
    {
        const Interval holds = contact_->interval();
        double dt = length;
        bool upper = false;
        for (int k = 0;; ++k) {
            const CoupledStepResult result = tryStep(dt);
            if (recorder_->stopped()) return stop();
            if (!result.converged()) {
                ++rejected_;
                dt *= 0.5;
                if (dt < shortestStep) return giveUp(result);
                wanted_ = std::min(wanted_, dt);
                return takeShorter(dt);
            }
            const SliderMotion& motion = stepper_->tried();
            const double d = contact_->separation(body_->attitude(motion.q));
            const double before = contact_->separation(body_->attitude(point_.motion.q));
            upper = std::abs(d - holds.upper) < std::abs(d - holds.lower);
            const double miss = d - (upper ? holds.upper : holds.lower);
            // The rate, along the way from the step's beginning where it has no other sense.
            const double ahead = contact_->separation(body_->attitude(moved(motion, 1e-3 * dt)));
            double rate = (ahead - d) / (1e-3 * dt);
            if (!(rate * (upper ? 1.0 : -1.0) > 0.0)) rate = (d - before) / dt;
            if (std::abs(miss) <= switchWidth() || k == mostTries || rate == 0.0) break;
            const double next = dt - miss / rate;
            if (!(next > 0.1 * dt) || next > 3.0 * dt) break;
            dt = next;
        }
        if (!takeStep(dt)) return false;
        recorder_->addEvent(point_.time, contact_->cross(upper));
        stepper_->restartAcceleration();
        const double storedBefore = point_.contact.storedEnergy;
        point_ = pointNow(dt);
        // What the law that now holds has stored comes with it.
        point_.gained += point_.contact.storedEnergy - storedBefore;
        recorder_->jump(point_);
        switchTimes_.push_back(point_.time);
        if (switchTimes_.size() > mostSwitches) {
            const double since = switchTimes_[switchTimes_.size() - 1 - mostSwitches];
            if (point_.time - since < chatterTime)
                return fail(RunStatus::Failed, "chattering at " + timeText(point_.time) + ": more than " + std::to_string(mostSwitches) +
                                                   " switches of the contact's law within " + formatQuantity(chatterTime, "us"));
        }
        return true;
    }

    bool takeShorter(double dt)
    {
        const CoupledStepResult result = tryStep(dt);
        if (recorder_->stopped()) return stop();
        if (!result.converged()) return giveUp(result);
        return takeStep(dt);
    }

    Vector3 moved(const SliderMotion& motion, double dt) const
    {
        Vector3 q = motion.q;
        for (std::size_t k = 0; k < 3; ++k) q[k] += dt * (motion.v[k] + 0.5 * dt * motion.a[k]);
        return q;
    }

    FilmPoint pointNow(double dt) const
    {
        return {.time = stepper_->time(), .motion = stepper_->motion(), .filmForce = stepper_->filmForce(),
                .contact = stepper_->contactForces(), .filmEnergy = point_.filmEnergy, .gained = point_.gained, .dt = dt};
    }

    /// By flows through the air, by the disk's surface that rises and falls under it, by shear, friction and dampers, and by what
    /// contact and adhesion do without storing it.
    void takeEnergy(const FilmPoint& before)
    {
        const FilmEnergyState air = energy_->at(stepper_->pressure());
        const double dt = point_.time - before.time, flows = air.input - air.dissipation;
        point_.filmEnergy = air.stored - restEnergy_;
        double gained = 0.5 * dt * (filmPower_ + flows) + stepper_->surfaceWork() +
                        point_.contact.storedEnergy - before.contact.storedEnergy;
        const Vector3 contact = point_.contact.load(), contactBefore = before.contact.load();
        const Vector3 shear = stepper_->shearTorques();
        for (std::size_t k = 0; k < 3; ++k) {
            const double way = point_.motion.q[k] - before.motion.q[k];
            const double damping = body_->dampers()[k] * 0.5 * (before.motion.v[k] + point_.motion.v[k]);
            gained += (0.5 * (contactBefore[k] + contact[k] + shearBefore_[k] + shear[k]) - damping) * way;
        }
        filmPower_ = flows;
        shearBefore_ = shear;
        point_.gained = before.gained + gained;
    }

    /// Maps at equal intervals, of the step that ends next.
    void takeFields()
    {
        const int count = case_.run.fieldSnapshots;
        if (count == 0 || stepper_->time() < (count > 1 ? snapshots_ * case_.run.duration / (count - 1) : 0.0)) return;
        while (snapshots_ < count && stepper_->time() >= snapshots_ * case_.run.duration / std::max(1, count - 1)) ++snapshots_;
        if (const RecordedFields maps = filmMaps(case_); !maps.empty()) {
            FieldSnapshot snapshot{stepper_->time(), 0, {}};
            const Attitude attitude = body_->attitude(stepper_->motion().q);
            std::vector<double> gap;
            for (int j = 0; j < maps.grid.ny(); ++j)
                for (int i = 0; i < maps.grid.nx(); ++i) {
                    const double x = maps.grid.centreX(i), y = maps.grid.centreY(j);
                    gap.push_back(recess_.at(x, y) + level_->gaps.lift(attitude, x, y));
                }
            snapshot.values.push_back(std::move(gap));
            snapshot.values.push_back(transfer(level_->gaps.grid, level_->gaps.pad.unpad<double>(stepper_->pressure()),
                                               level_->film.ambient(), maps.grid));
            recorder_->addFields(std::move(snapshot));
        }
        if (contact_ && !sliderContactFields(case_).empty()) {
            FieldSnapshot snapshot{stepper_->time(), 1, {}};
            contact_->observe(snapshot);
            if (!snapshot.values.empty()) recorder_->addFields(std::move(snapshot));
        }
    }

    bool giveUp(const CoupledStepResult& result)
    {
        std::string why;
        switch (result.failure) {
        case CoupledFailure::None: why = "its error stays above run.step_error"; break;
        case CoupledFailure::Film: why = "the film does not converge"; break;
        case CoupledFailure::Contact: why = stepper_->contactForces().problem; break;
        case CoupledFailure::Iteration: why = "film and slider do not come to agree"; break;
        case CoupledFailure::NotFinite: why = "the forces are no numbers"; break;
        }
        const Attitude last = body_->attitude(point_.motion.q);
        return fail(RunStatus::Failed, "no step is short enough at " + timeText(point_.time) + ": " + why + "; the samples end with the last good state, minimum spacing " +
                                           formatQuantity(std::round(spacing_.at(last).spacing * 1e13) / 1e13, "nm"));
    }

    bool fail(RunStatus status, std::string message)
    {
        status_ = status;
        message_ = std::move(message);
        return false;
    }

    bool stop() { return fail(RunStatus::Cancelled, "stopped at " + timeText(recorder_ ? point_.time : 0.0)); }

    /// Asked where there is nothing to tell yet, and within long solutions.
    bool goOn()
    {
        if (recorder_) return recorder_->lookAtClock();
        if (wallClock() - lastCall_ < 0.015) return true;
        SampleBatch none;
        none.columns.resize(filmQuantities(case_).size());
        const bool on = !callback_ || callback_({0.0, case_.run.duration, none, {}, {}});
        lastCall_ = wallClock();
        return on;
    }

    const Case& case_;
    const RunCallback& callback_;
    Recess recess_;
    MinimumSpacing spacing_;
    DiskTopography topography_;
    std::optional<SliderBody> body_;
    std::unique_ptr<FilmLevel> level_;
    std::optional<DiskUnderFilm> disk_;
    std::unique_ptr<SliderContact> contact_;
    std::optional<CoupledStepper> stepper_;
    std::optional<FilmRecorder> recorder_;
    std::optional<FilmEnergy> energy_;
    FilmPoint point_;        // the last accepted one
    double restEnergy_ = 0.0; // of the air in the static state [J]
    double filmPower_ = 0.0; // what flows bring the air there, in all [W]
    Vector3 shearBefore_{};  // torques there [N m]
    int snapshots_ = 0;      // taken
    int sinceLimit_ = 0;     // steps since one could not have been longer
    double wanted_ = 0.0;    // length of the next step, where nothing else limits it [s]
    std::vector<double> switchTimes_;
    std::vector<std::string> warnings_;
    long long steps_ = 0, rejected_ = 0, filmIterations_ = 0;
    RunStatus status_ = RunStatus::Completed;
    std::string message_;
    double lastCall_ = 0.0;  // wall clock [s]
};

} // namespace

RecordedFields filmMaps(const Case& c)
{
    if (c.run.fieldSnapshots == 0) return {};
    constexpr int mostCells = 128; // along each side
    RecordedFields maps;
    maps.grid = gradedGrid(c.surface, c.slider.length, c.slider.width, std::min(mostCells, c.film.nodes[0] - 1),
                           std::min(mostCells, c.film.nodes[1] - 1));
    maps.quantities = {{"gap", "m", "nm", "Gap to the mean plane of the disk"}, {"air_pressure", "Pa", "kPa", "Pressure of the air"}};
    return maps;
}

Summary runFilm(const Case& c, const RunCallback& callback) { return FilmRun(c, callback).run(); }

} // namespace touchdown
