// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>

#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/numerics/events.h"
#include "core/physics/disk/disk_passage.h"
#include "core/simulation/flight/coupled_step.h"
#include "core/simulation/flight/damping_doubt.h"
#include "core/simulation/flight/film_energy_balance.h"
#include "core/simulation/flight/film_figures.h"
#include "core/simulation/flight/film_on_cells.h"
#include "core/simulation/flight/film_recorder.h"
#include "core/simulation/flight/film_scene.h"
#include "core/simulation/flight/law_switch.h"
#include "core/simulation/flight/linear_film.h"
#include "core/simulation/flight/step_length.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/high_disk.h"

namespace touchdown {

namespace {

constexpr double firstStep = 2e-9;     // [s]
constexpr double shortestStep = 1e-14; // [s]
constexpr double jumpStep = 1e-11;     // so short a step whose error is too large leads over a jump of the forces [s]
constexpr double longestShare = 0.01;  // of the run, for a step
constexpr double switchShare = 0.05;   // of a step's error, to which a switch's separation is located [-]
constexpr double mostToEnd = 4.0;      // equal steps at the end of the run
constexpr double stretch = 0.999;      // of the way to the end that a step covers, which is lengthened to reach it [-]
constexpr double shareAfterSwitch = 0.5; // of the longest step, for the first one with a new law [-]
constexpr double chatterSpan = 1e-7;     // within which many switches are chattering [s]
constexpr int mostTries = 12;            // for one switch
constexpr double farthest = 1e-4;        // from which no slider comes back [m]
constexpr double looksEach = 4.0;        // of the finest passage: a quarter of a wave, two cells of a map

std::string timeText(double t) { return fewDigitsOfTime(t, 4); }

class FilmRun {
public:
    FilmRun(const Case& c, const RunCallback& callback, const RunOptions& options)
        : case_(c),
          run_(c, filmQuantities(c), callback, options),
          from_(options.from),
          scene_(c),
          length_(c.run.steps == StepControl::Fixed ? c.run.step : firstStep,
                  c.run.steps == StepControl::Fixed ? 0.0 : c.run.stepError)
    {}

    /// `known`: a static state in hand; null: none.
    Summary run(const StaticSolution* known, KeptStates kept)
    {
        if (from_ ? resume() : prepare(known, kept)) advance();
        if (recorder_) {
            recorder_->end();
            if (!run_.send(reached()) && end_.completed()) stop();
        }
        Summary summary = recorder_ ? recorder_->summary(end_) : run_.summary(end_, reached());
        summary.steps = steps_;
        summary.rejectedSteps = rejected_;
        summary.evaluations = filmIterations_;
        const auto warn = [&](std::vector<std::string> list) {
            std::ranges::move(list, std::back_inserter(summary.warnings));
        };
        warn(scene_.warnings);
        if (film_) troubles_.closings = film_->closings();
        addStepWarnings(summary, troubles_, linear_ ? FilmCoupling::Monolithic : case_.film.coupling);
        if (scene_.level)
            warn(doubtsOnDamping(case_, summary.peaks, resolvedFrequency(case_, scene_.level->gaps.grid), unfitted_,
                                 summary.endTime));
        if (steps_ > 0)
            warn(doubtsOnDisk(scene_.diskOnCells, case_.run.steps == StepControl::Fixed ? case_.run.step : 0.0));
        if (!unseenDisk_.empty()) summary.warnings.push_back(std::move(unseenDisk_));
        if (contact_) warn(contact_->remarks());
        if (contact_ && recorder_ && end_.status != RunStatus::Cancelled) addDoubts(summary);
        if (recorder_) {
            addCost(summary, stepper_->cost());
            addStepErrors(summary, worst_, recorder_->energyImbalance());
            if (linear_) addLinearErrors(summary, *linear_);
        }
        run_.setTimes(summary);
        return summary;
    }

private:
    void addDoubts(Summary& summary)
    {
        const SliderContact::Doubts doubts = contact_->doubts([this] { return goOn(); });
        std::ranges::move(warningsOf(case_, doubts.of, doubts.contact, doubts.adhesion),
                          std::back_inserter(summary.warnings));
        if (doubts.of.grid) addGridError(summary, *doubts.of.grid, coversError(case_, doubts.of)); // else no contact
    }

    /// False when the run ends here.
    bool prepare(const StaticSolution* known, KeptStates kept)
    {
        switch (scene_.prepare([this] { return goOn(); }, known, kept)) {
        case FilmScene::State::Stopped: return stop();
        case FilmScene::State::Failed: return fail(RunFailure::Other, scene_.message);
        case FilmScene::State::Ready: break;
        }
        makeStepper();
        if (!goOn()) return stop();
        SliderMotion motion;
        motion.q = body_->coordinates(scene_.start);
        motion.v = {case_.initial.verticalVelocity, case_.initial.pitchVelocity,
                    body_->holdsRoll() ? 0.0 : case_.initial.rollVelocity};
        stepper_->start(motion, 0.0);
        if (run_.stopped()) return stop();
        if (const std::string& problem = stepper_->contactForces().problem; !problem.empty())
            return fail(RunFailure::Other, "no contact state was found at the start: " + problem);
        if (!stepper_->filmForce().allFinite() || !stepper_->contactForces().load().allFinite())
            return fail(RunFailure::Other, "the forces at the start are no numbers; start higher "
                                           "(initial.nominal_trailing_edge_height) or on a smoother disk");
        makeRecorder();
        point_ = pointNow(0.0);
        balance_->begin(point_);
        recorder_->begin(point_);
        takeFields();
        return lookAtDisk(scene_.start);
    }

    /// False when the run ends here.
    bool resume()
    {
        bool ready = false;
        point_.time = from_->time;
        run_.resume(*from_, [&](StateStream& stream) {
            ready = scene_.restore(stream, [this] { return goOn(); }) == FilmScene::State::Ready;
            if (!ready) return stream.skip();
            makeStepper();
            makeRecorder();
            pass(stream);
        });
        return ready || stop();
    }

    void pass(StateStream& stream)
    {
        stream(*spacing_, *stepper_, *balance_, *recorder_, length_, point_, switched_, troubles_, worst_, snapshots_,
               switches_, unseenDisk_, steps_, rejected_, filmIterations_, unfitted_, nearShare_);
        if (contact_) stream(*contact_);
    }

    void sendCheckpoint()
    {
        // Maps are spread over the duration, and so are steps that a share of it limits.
        const bool extends = (linear_ || case_.run.fieldSnapshots == 0) && !nearShare_;
        const bool goesOn = run_.sendCheckpoint(reached(), extends, [this](StateStream& stream) {
            scene_.store(stream);
            pass(stream);
        });
        if (!goesOn) stop();
    }

    void makeStepper()
    {
        contact_ = scene_.contact.get();
        body_ = &*scene_.body;
        FilmLevel& level = *scene_.level;
        CoupledStepOptions stepping = steppingOf(case_, level.film);
        stepping.goOn = [this] { return goOn(); };
        if (scene_.linear) {
            film_ = linear_ = std::make_shared<LinearFilm>(*scene_.linear);
            if (contact_) contact_->moveLittle(linear_->smallMotion());
        } else
            film_ = cells_ = std::make_shared<FilmOnCells>(level.film, *body_, contact_, &*scene_.disk, stepping.film,
                                                           level.pressure);
        stepper_.emplace(*film_, *body_, contact_, stepping);
    }

    void makeRecorder()
    {
        balance_.emplace(*film_, *body_, scene_.restEnergy);
        spacing_.emplace(scene_.spacing, linear_ ? linear_->smallMotion() : 0.0);
        recorder_.emplace(case_, *body_, scene_.recess, *spacing_, &*scene_.clearance,
                          looksEach * finestPassage(case_.diskSurface, scene_.topography, scene_.disk->velocity()),
                          run_);
        run_.moveOver(surfaceRecurrence(case_.diskSurface, scene_.topography, scene_.disk->velocity(),
                                        {0.0, case_.slider.width, case_.slider.length}));
    }

    void advance()
    {
        const double duration = case_.run.duration;
        while (stepper_->time() < duration) {
            if (!goOn()) {
                stop();
                return;
            }
            if (!advanceOnce()) return;
            if (run_.isCheckpointDue(point_.time)) sendCheckpoint();
        }
    }

    double switchWidth() const { return switchShare * case_.run.stepError; }

    /// No longer than the fastest motion and a moving surface allow.
    double longestStep() const
    {
        double longest = std::min(longestShare * case_.run.duration, scene_.diskOnCells.longestStep);
        if (const double rate = stepper_->fastestRate(); rate > 0.0)
            longest = std::min(longest, StepLength::longestPhase / rate);
        if (contact_ && stepper_->contactInReach()) longest = std::min(longest, contact_->longestStep());
        return longest;
    }

    /// The last step ends with the run, and so does its last map. The few before it are as long, so that they stay
    /// fitted.
    double towardsEnd(double dt) const
    {
        constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon(); // lest a sliver is left
        const double left = (1.0 + rounding) * case_.run.duration - stepper_->time();
        const double steps = std::ceil(stretch * left / dt);
        return steps > (length_.fixed() ? 1.0 : mostToEnd) || left < jumpStep ? dt : left / steps;
    }

    /// One accepted step, however many tries it takes. False when the run ends here.
    bool advanceOnce()
    {
        double dt = length_.next(point_.dt, (switched_ ? shareAfterSwitch : 1.0) * longestStep(), switched_);
        if (!length_.fixed() && dt >= shareAfterSwitch * longestShare * case_.run.duration) nearShare_ = true;
        dt = towardsEnd(dt);
        switched_ = false;
        while (true) {
            const CoupledStepResult result = tryStep(dt);
            if (run_.stopped()) return stop();
            const bool jumps = dt < jumpStep && result.converged() && length_.isTooLong(result.timeError);
            troubles_.jumps += jumps;
            if (!result.converged() || (length_.isTooLong(result.timeError) && !jumps)) {
                ++rejected_;
                if (length_.fixed() && troubles_.cuts++ == 0)
                    troubles_.firstCut = reasonOf(result) + " at " + timeText(point_.time);
                dt = result.converged() ? length_.shortened(dt, result.timeError) : length_.halved(dt);
                if (dt < shortestStep) return giveUp(result);
                continue;
            }
            if (const std::optional<double> way = wayToSwitchOf(dt)) return goToSwitch(*way);
            length_.accepted(dt, result.timeError);
            return takeStep(dt);
        }
    }

    CoupledStepResult tryStep(double dt)
    {
        const CoupledStepResult result = tried_ = stepper_->step(dt);
        filmIterations_ += result.filmIterations;
        goOn();
        return result;
    }

    bool takeStep(double dt)
    {
        stepper_->accept();
        ++steps_;
        if (!film_->isFitted()) ++unfitted_.count, unfitted_.time += dt;
        worst_.add(tried_);
        const FilmPoint before = point_;
        point_ = pointNow(dt);
        balance_->add(before, point_);
        recorder_->add(point_);
        takeFields();
        const Attitude attitude = body_->attitude(point_.motion.q);
        if (contact_)
            if (const std::string problem = contact_->problemAt(attitude); !problem.empty())
                return fail(RunFailure::Other, problem + " at " + timeText(point_.time));
        if (!lookAtDisk(attitude)) return false;
        if (linear_ && linear_->isTooFar(case_.film.linearLimit))
            return fail(RunFailure::Other,
                        tooFarFromRest(*linear_, case_.film.linearLimit) + " at " + timeText(point_.time));
        if (const double spacing = spacing_->at(attitude); spacing > farthest)
            return fail(RunFailure::Diverged, "the slider left the disk: at " + timeText(point_.time) + " it is " +
                                                  formatQuantity(std::round(spacing * 1e9) / 1e9, "um") + " above it");
        return true;
    }

    /// False where the disk reaches the slider and no law of contact acts.
    bool lookAtDisk(const Attitude& attitude)
    {
        const double spacing = spacing_->at(attitude);
        scene_.lookAtLower(attitude, spacing);
        if (scene_.topography.flat() && case_.contact == noContact && spacing <= 0.0)
            return fail(RunFailure::Other,
                        diskReachesSlider(case_, scene_.clearance->at(attitude, point_.time), point_.time));
        const std::optional<FilmRecorder::Reached>& reached = recorder_->reached();
        if (!reached || !unseenDisk_.empty()) return true;
        std::string message = diskReachesSlider(case_, reached->place, reached->time);
        if (case_.contact == noContact) return fail(RunFailure::Other, std::move(message));
        if (!contactLaw(case_).seesDisk) unseenDisk_ = std::move(message);
        return true;
    }

    std::optional<double> wayToSwitchOf(double dt) const
    {
        if (!contact_) return std::nullopt;
        FilmPoint end = point_;
        end.time += dt;
        end.dt = dt;
        end.motion = stepper_->tried();
        return wayToSwitch(*contact_, *body_, point_, end, switchWidth(), shortestStep);
    }

    /// Ends a step where the contact's law switches, found by secants, and takes the law that holds beyond. It ends
    /// beyond the switch by no more than its width, so that the next step begins where its law holds.
    bool goToSwitch(double length)
    {
        double dt = length;
        SwitchAim aim;
        for (int k = 0;; ++k) {
            const CoupledStepResult result = tryStep(dt);
            if (run_.stopped()) return stop();
            if (!result.converged()) {
                ++rejected_;
                return length_.halved(dt) < shortestStep ? giveUp(result) : true;
            }
            aim = aimAtSwitch(*contact_, *body_, point_.motion, stepper_->tried(), dt, switchWidth());
            if (std::abs(aim.miss) <= 0.5 * switchWidth() || k == mostTries || aim.rate == 0.0) break;
            const double next = dt - aim.miss / aim.rate;
            if (!(next > 0.1 * dt) || next > 2.0 * length) break;
            dt = next;
        }
        if (!takeStep(dt)) return false;
        // The way that was looked at is not quite that of the shorter step.
        if (!aim.reached) return true;
        run_.addEvent(point_.time, contact_->cross(aim.upper));
        stepper_->restartAcceleration();
        switched_ = true;
        const double storedBefore = point_.contact.storedEnergy;
        point_ = pointNow(dt);
        // What the law that now holds has stored comes with it.
        point_.gained += point_.contact.storedEnergy - storedBefore;
        recorder_->jump(point_);
        if (switches_.tooMany(point_.time, chatterSpan))
            return fail(RunFailure::Chattering,
                        "chattering at " + timeText(point_.time) + ": more than " + std::to_string(ChatterWatch::most) +
                            " switches of the contact's law within " + formatQuantity(chatterSpan, "us"));
        return true;
    }

    FilmPoint pointNow(double dt) const
    {
        return {.time = stepper_->time(),
                .motion = stepper_->motion(),
                .filmForce = stepper_->filmForce(),
                .contact = stepper_->contactForces(),
                .filmEnergy = point_.filmEnergy,
                .gained = point_.gained,
                .dt = dt};
    }

    /// Maps at equal intervals, of the step that ends next; the last one at the end of the run.
    void takeFields()
    {
        const int count = cells_ ? case_.run.fieldSnapshots : 0;
        const double interval = case_.run.duration / std::max(1, count - 1), time = reached(),
                     due = time + 1e-9 * interval;
        if (snapshots_ == count || due < snapshots_ * interval) return;
        while (snapshots_ < count && due >= snapshots_ * interval) ++snapshots_;
        for (FieldSnapshot& snapshot : scene_.snapshots(time, body_->attitude(point_.motion.q), cells_->pressure()))
            run_.addFields(std::move(snapshot));
    }

    std::string reasonOf(const CoupledStepResult& result) const
    {
        return touchdown::reasonOf(result, stepper_->contactForces().problem);
    }

    bool giveUp(const CoupledStepResult& result)
    {
        const Attitude last = body_->attitude(point_.motion.q);
        const bool noLaw = case_.contact == noContact && !scene_.topography.flat();
        const std::string disk = noLaw ? nearestDisk(scene_.clearance->at(last, point_.time)) : std::string();
        return fail(result.failure == CoupledFailure::None ? RunFailure::NoStep : RunFailure::NotConverged,
                    noStepIsShortEnough(timeText(point_.time), reasonOf(result), disk, spacing_->at(last)));
    }

    bool end(RunStatus status, RunFailure failure, std::string message)
    {
        end_ = {status, failure, std::move(message)};
        return false;
    }
    bool fail(RunFailure failure, std::string message)
    {
        return end(failure == RunFailure::Diverged ? RunStatus::Diverged : RunStatus::Failed, failure,
                   std::move(message));
    }
    bool stop() { return end(RunStatus::Cancelled, RunFailure::None, "stopped at " + timeText(point_.time)); }

    double reached() const { return std::min(point_.time, case_.run.duration); } // [s]
    /// Asked within long solutions, too; false once somebody has stopped the run.
    bool goOn()
    {
        run_.askForCheckpoint();
        return run_.lookAtClock(reached());
    }

    const Case& case_;
    RunRecorder run_;
    std::shared_ptr<const RunCheckpoint> from_; // null: the run begins
    FilmScene scene_;
    const SliderBody* body_ = nullptr;
    SliderContact* contact_ = nullptr;
    std::shared_ptr<FilmInTime> film_;
    std::shared_ptr<FilmOnCells> cells_; // film_, or null
    std::shared_ptr<LinearFilm> linear_; // film_, or null
    std::optional<CoupledStepper> stepper_;
    std::optional<NearbySpacing> spacing_;
    std::optional<FilmRecorder> recorder_;
    std::optional<FilmEnergyBalance> balance_;
    StepLength length_;
    FilmPoint point_;       // the last accepted one
    bool switched_ = false; // the contact's law, at the last accepted point
    StepTroubles troubles_;
    CoupledStepResult tried_;
    StepErrors worst_;  // of accepted steps
    int snapshots_ = 0; // taken
    ChatterWatch switches_;
    std::string unseenDisk_; // where its surface first reached the slider under a law that does not see it
    long long steps_ = 0, rejected_ = 0, filmIterations_ = 0;
    UnfittedSteps unfitted_;
    bool nearShare_ = false; // a step may have been limited by a share of the duration
    RunEnd end_;
};

} // namespace

Summary runFilm(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    return FilmRun(c, callback, options).run(options.rest.get(), options.kept);
}

} // namespace touchdown
