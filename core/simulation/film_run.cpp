// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/film_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

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
constexpr double worthGrowing = 1.6;    // a longer step needs a new linearisation
constexpr double mostGrowth = 2.0;      // BDF2 is stable up to 1 + sqrt 2 (Grigorieff 1983)
constexpr double safety = 0.9;          // of a step against the longest whose error is allowed
constexpr double switchWidth = 1e-13;   // to which a switch's separation is located [m]
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
        summary.wallSeconds = wallClock() - begin;
        summary.solverSeconds = summary.wallSeconds - (recorder_ ? recorder_->secondsOutside() : 0.0);
        return summary;
    }

private:
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

        const double tolerance = 1e-3 * case_.run.stepError;
        CoupledStepOptions stepping;
        stepping.coupling = case_.film.coupling;
        stepping.tolerance = tolerance;
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

    bool fixed() const { return case_.run.steps == StepControl::Fixed; }

    double nextLength() const
    {
        double dt = wanted_;
        if (point_.dt > 0.0) dt = std::min(dt, mostGrowth * point_.dt);
        if (fixed()) return dt;
        dt = std::min(dt, longestShare * case_.run.duration);
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
            if (!fixed() && factor < safety) {
                ++rejected_;
                dt *= std::max(factor, 0.25);
                wanted_ = dt;
                if (dt < shortestStep) return giveUp(result);
                continue;
            }
            if (const std::optional<double> length = wayToSwitch(dt)) return goToSwitch(*length);
            if (!fixed()) {
                if (factor < 1.0) wanted_ = factor * dt;
                else if (factor > worthGrowing) wanted_ = std::max(wanted_, std::min(mostGrowth, factor) * dt);
            }
            return takeStep(dt);
        }
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
        point_ = pointNow(dt);
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
            if (k == looks && beyond(outside) <= switchWidth) return dt;
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
            if (std::abs(miss) <= switchWidth || k == mostTries || rate == 0.0) break;
            const double next = dt - miss / rate;
            if (!(next > 0.1 * dt) || next > 3.0 * dt) break;
            dt = next;
        }
        if (!takeStep(dt)) return false;
        recorder_->addEvent(point_.time, contact_->cross(upper));
        stepper_->restartAcceleration();
        point_ = pointNow(dt);
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
                .contact = stepper_->contactForces(), .dt = dt};
    }

    void takeFields() {}

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
    FilmPoint point_;        // the last accepted one
    double wanted_ = 0.0;    // length of the next step, where nothing else limits it [s]
    std::vector<double> switchTimes_;
    std::vector<std::string> warnings_;
    long long steps_ = 0, rejected_ = 0, filmIterations_ = 0;
    RunStatus status_ = RunStatus::Completed;
    std::string message_;
    double lastCall_ = 0.0;  // wall clock [s]
};

} // namespace

RecordedFields filmMaps(const Case&) { return {}; }

Summary runFilm(const Case& c, const RunCallback& callback) { return FilmRun(c, callback).run(); }

} // namespace touchdown
