// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/physics/contact/strongest_pull.h"
#include "core/simulation/contact/contact_figures.h"
#include "core/simulation/contact/contact_model.h"
#include "core/simulation/contact/pad_way.h"
#include "core/simulation/recording/run_recorder.h"

namespace touchdown {

namespace {

constexpr double jumpResolution = 1e-12; // of the separation [m]
constexpr double smallestJump = 1e-3;    // against the largest force of the run so far [-]
constexpr double suddenChange = 1.5;     // of the force over a step, against the one before: worth a search [-]
constexpr double suddenOfCoarse = 4.0;   // of the run with cells twice as large, whose small jumps do not matter [-]
constexpr int mostJumpsInStep = 20;
constexpr int mostMisses = 4;
constexpr int shortSteps = 8;
constexpr double pullResolution = 2e-12; // of the separation of the strongest pull [m]
constexpr double worthRefining = 0.95;   // of the strongest pull so far, for a search between the samples [-]

/// Moves the pad from station to station, and records its states.
class ContactRun {
public:
    /// `coarser`: on cells twice as large, for the figures alone.
    ContactRun(const Case& c, const RunCallback& callback, const RunOptions& options, bool coarser = false)
        : case_(c),
          coarser_(coarser),
          rows_(contactRows(c)),
          recorder_(c, quantitiesOf(rows_), callback, options),
          figures_(c),
          from_(options.from)
    {}

    Summary run()
    {
        model_ = makeContactModel(
            case_, [this] { return lookAtClock(); }, coarser_);
        if (from_) recorder_.resume(*from_, [this](StateStream& stream) { pass(stream); });
        const std::vector<PadStation> stations = padStations(case_);
        while (station_ < stations.size() && lookAtClock() && visit(stations[station_])) {
            ++station_;
            if (recorder_.isCheckpointDue(time_)) sendCheckpoint();
        }
        if (!values_.empty()) recorder_.addLastSample(time_, values_, false);
        flush();
        Summary summary = recorder_.summary(end_, time_);
        summary.steps = steps_;
        summary.evaluations = iterations_;
        // The statistics of a long track take their time, and somebody who stops a run does not wait for them.
        const bool stopped = end_.status == RunStatus::Cancelled || coarser_;
        summary.fit = model_->fit();
        summary.figures = figures_.figures(stopped ? std::nullopt : model_->surfaceStatistics(), summary.fit);
        if (coarser_) return summary;
        std::ranges::copy(model_->remarks(), std::back_inserter(summary.warnings));
        if (end_.completed() && contactLaw(case_).recordsSurfaces) addDoubts(summary);
        if (startsInContact_) summary.warnings.push_back("the surfaces touch at approach.start already");
        if (end_.completed() && isTouching() && !startsInContact_)
            summary.warnings.push_back(
                "the surfaces still touch back at approach.start: a greater one shows where they part");
        if (widestBracket_ > jumpResolution)
            summary.warnings.push_back("not every jump could be located: the separation of one is known to " +
                                       formatQuantity(std::round(widestBracket_ * 1e13) / 1e13, "nm") + " only");
        if (summary.fit && !summary.fit->describes) summary.warnings.push_back(summary.fit->message);
        recorder_.setTimes(summary);
        return summary;
    }

private:
    /// The error of the grid: without adhesion from the state of the largest force on other cells, else from the whole
    /// way on cells twice as large.
    void addDoubts(Summary& summary)
    {
        const auto goOn = [this] { return lookAtClock(); };
        if (!model_->canJump()) {
            if (!(hardest_.contact > 0.0)) {
                hardest_.separation = case_.approach.closest;
                hardestTime_ = 0.5 * case_.run.duration;
            }
            closest_ = model_->move(hardest_.separation, hardestTime_);
            doubts_ = model_->doubts(goOn);
            addErrors(case_, doubts_, summary, hardest_.separation == case_.approach.closest);
            if (end_.status == RunStatus::Cancelled) return stoppedInDoubt(summary);
        }
        std::ranges::move(warningsOf(case_, doubts_, closest_.contact, closest_.adhesion),
                          std::back_inserter(summary.warnings));
        if (!model_->canJump()) return;
        if (!coversError(case_, doubts_)) return addUnknownErrors(summary); // whatever other cells would show
        const RunCallback callback = [&](const RunUpdate&) { return lookAtClock(); };
        const Summary other = ContactRun(withFewerSamples(case_), callback, {}, true).run();
        if (other.status == RunStatus::Completed)
            return addErrors(case_, doubts_, summary,
                             {other, closest_.adhesion, std::max(jumpResolution, widestBracket_), !isTouching()});
        addUnknownErrors(summary);
        if (other.status == RunStatus::Cancelled) return stoppedInDoubt(summary);
        summary.warnings.push_back("the error of the contact's grid is not known: with cells twice as large " +
                                   other.message);
    }

    void pass(StateStream& stream)
    {
        stream(*model_, figures_, station_, values_, started_, startsInContact_, away_, forces_, way_, hardest_,
               hardestTime_, closest_, doubts_, time_, largestForce_, widestBracket_, lastChange_, steps_, iterations_);
        StateStream::require(values_.empty() || values_.size() == recorder_.quantities().size());
    }

    /// The way of the pad is spread over the duration, so that no longer run continues from it.
    void sendCheckpoint()
    {
        if (!recorder_.sendCheckpoint(time_, false, [this](StateStream& stream) { pass(stream); })) stop();
    }

    /// The run itself is complete.
    static void stoppedInDoubt(Summary& summary)
    {
        summary.warnings.emplace_back("the error of the contact's grid is not known: its calculation was stopped");
    }

    /// False when the run ends here.
    bool visit(const PadStation& station)
    {
        const double d = padSeparation(case_, station.time);
        away_ = station.time > 0.5 * case_.run.duration;
        if (!go(station.time, d)) return fail(station.time);
        for (const ContactSwitch& passed : model_->way().switches)
            recorder_.addEvent(wayTime(passed.separation), passed.name);
        for (const PullPoint& pull : model_->way().pulls) figures_.addPull(pull.separation, pull.force);
        time_ = station.time;
        if (station.time == 0.0) startsInContact_ = isTouching();
        figures_.add(forces_, away_);
        if (!away_) way_.assign(1, {d, forces_.net()}); // at last the closest approach, where the way out begins
        if (forces_.contact > hardest_.contact) {
            hardest_ = forces_;
            hardestTime_ = station.time;
        }
        if (model_->canJump() && d == case_.approach.closest && !coarser_) {
            closest_ = forces_;
            doubts_ = model_->doubts({});
        }
        record(station);
        if (station.snapshot) {
            FieldSnapshot snapshot{station.time, 0, {}};
            model_->observe(snapshot);
            if (!snapshot.values.empty()) recorder_.addFields(std::move(snapshot));
        }
        if (recorder_.full()) flush();
        return lookAtClock();
    }

    /// Moves the pad; looks for jumps where the law may have jumped. False when a solution was not found.
    bool go(double time, double d)
    {
        const double from = forces_.separation, fromTime = time_;
        const double before = forces_.net();
        if (started_ && model_->canJump()) model_->remember();
        if (!move(d, time)) return false;
        started_ = true;
        if (steps_ == 1 || !model_->canJump()) return true;
        const double change = std::abs(forces_.net() - before);
        const bool sudden =
            change > (coarser_ ? suddenOfCoarse : suddenChange) * lastChange_ && change > smallestJump * largestForce_;
        lastChange_ = change;
        if (model_->mayHaveJumped() || sudden) return findJumps(from, fromTime, before, d, time);
        return followPull(d);
    }

    bool findJumps(double from, double fromTime, double before, double d, double time)
    {
        const auto timeAt = [&](double separation) {
            return from == d ? time : fromTime + (time - fromTime) * (separation - from) / (d - from);
        };
        bool good = true;
        const TracedContact contact{[&](double separation) {
                                        good = move(separation, timeAt(separation)) && good;
                                        return forces_.net();
                                    },
                                    [&] { model_->remember(); },
                                    [&] { model_->recall(); },
                                    [&] { return model_->mayHaveJumped(); },
                                    [&] { model_->remember(1); },
                                    [&] { model_->recall(1); }};
        const double change = std::abs(forces_.net() - before);
        model_->recall();
        double at = from, force = before;
        int misses = 0;
        for (int i = 0; i < mostJumpsInStep && at != d; ++i) {
            const double smallest = smallestJump * largestForce_;
            ContactJump jump = coarser_ ? locateJump(contact, at, force, d, jumpResolution, smallest)
                                        : locateFirstJump(contact, at, force, d, jumpResolution, smallest);
            if (!good) return false;
            if (jump.found) {
                if (!measure(jump)) return false;
                takeJump(jump, timeAt);
            } else if (++misses > mostMisses)
                break;
            // Just before the end of a branch a long step falls over, and a short one does not: then the search ends on
            // this side of it, and continues from there.
            at = jump.after;
            force = contact.force(at);
            model_->remember();
            const double ahead = std::abs(contact.force(d) - force);
            if (!good) return false;
            if (jump.found ? !model_->mayHaveJumped() : ahead < 0.5 * change) return followPull(d); // it is at d
            model_->recall();
        }
        return goInShortSteps(at, force, d, change, timeAt);
    }

    /// The rest of a way with a suspected jump that was not located: short steps distinguish it from a steep way.
    bool goInShortSteps(double at, double force, double d, double change, const std::function<double(double)>& timeAt)
    {
        double energy = forces_.energy;
        if (at != d) {
            if (!move(at, timeAt(at))) return false;
            energy = forces_.energy;
        }
        for (int i = 1; i <= shortSteps; ++i) {
            const double next = i == shortSteps ? d : at + (d - at) / (shortSteps + 1 - i);
            if (!move(next, timeAt(next))) return false;
            if (model_->mayHaveJumped() && std::abs(forces_.net() - force) > 0.5 * change)
                takeJump({true, at, next, force, forces_.net(), energy, forces_.energy}, timeAt);
            else if (!followPull(next))
                return false;
            at = next;
            force = forces_.net();
            energy = forces_.energy;
        }
        return true;
    }

    void takeJump(const ContactJump& jump, const std::function<double(double)>& timeAt)
    {
        recorder_.addEvent(timeAt(0.5 * (jump.before + jump.after)), jump.after < jump.before ? "snap-in" : "pull-off");
        figures_.addJump(jump);
        if (away_) way_.assign(1, {jump.after, jump.forceAfter});
        widestBracket_ = std::max(widestBracket_, std::abs(jump.after - jump.before));
    }

    /// The energies of a located jump, and the strongest pull on the way to it. The contact is in the remembered state
    /// before it, to which it returns.
    bool measure(ContactJump& jump)
    {
        if (!move(jump.after, wayTime(jump.after))) return false;
        jump.forceAfter = forces_.net();
        jump.energyAfter = forces_.energy;
        model_->recall();
        if (!move(jump.before, wayTime(jump.before))) return false;
        jump.energyBefore = forces_.energy;
        const bool good = !away_ || way_.empty() || refinePull(way_.front(), {jump.before, jump.forceBefore});
        model_->recall();
        return good;
    }

    /// After a smooth move on the way out: the strongest pull between the samples, once it is passed.
    bool followPull(double d)
    {
        if (!away_) return true;
        const PullPoint now{d, forces_.net()};
        bool good = true;
        if (way_.size() == 2 && way_[1].force <= way_[0].force && way_[1].force < now.force) {
            const ContactForces here = forces_;
            model_->remember();
            good = refinePull(way_[0], now);
            model_->recall();
            forces_ = here;
        }
        if (way_.size() == 2) way_.erase(way_.begin());
        way_.push_back(now);
        return good;
    }

    /// On a smooth way between two points; each try starts from the remembered state.
    bool refinePull(PullPoint from, PullPoint to)
    {
        if (std::min(from.force, to.force) > -worthRefining * figures_.strongestPull()) return true;
        bool good = true;
        const TracedContact contact{[&](double separation) {
                                        good = move(separation, wayTime(separation)) && good;
                                        return forces_.net();
                                    },
                                    {},
                                    [&] { model_->recall(); }};
        const PullPoint strongest = strongestPull(contact, from.separation, to.separation, pullResolution);
        if (good) figures_.addPull(strongest.separation, strongest.force);
        return good;
    }

    double wayTime(double separation) const
    {
        return away_ ? retractionTime(case_, separation) : approachTime(case_, separation);
    }

    bool move(double d, double time)
    {
        forces_ = model_->move(d, time);
        ++steps_;
        if (end_.completed()) iterations_ += forces_.iterations; // one that was stopped counts none
        largestForce_ = std::max({largestForce_, forces_.contact, -forces_.adhesion});
        return forces_.problem.empty();
    }

    /// Contact of surfaces; the summits of a statistical surface have no end.
    bool isTouching() const { return contactLaw(case_).recordsSurfaces && forces_.contact > 0.0; }

    /// A force may jump between two stations.
    void record(const PadStation& station)
    {
        values_.resize(recorder_.quantities().size());
        contactValues(case_, rows_, forces_, values_.data());
        if (station.sample)
            recorder_.addSample(station.time, values_, false);
        else
            recorder_.addPoint(station.time, values_, false);
    }

    /// Within a long solution, too. False when somebody stopped the run.
    bool lookAtClock()
    {
        if (recorder_.silent()) flush();
        recorder_.askForCheckpoint();
        return end_.completed();
    }

    bool fail(double time)
    {
        if (!end_.completed()) return false; // stopped within the solution
        end_ = {RunStatus::Failed, RunFailure::NotConverged,
                "no contact state was found at a separation of " +
                    formatQuantity(std::round(padSeparation(case_, time) * 1e13) / 1e13, "nm") + " after " +
                    fewDigitsOfTime(time_, 4) + ": " + forces_.problem + "; the samples end with the last good state"};
        return false;
    }

    void flush()
    {
        if (!recorder_.send(time_)) stop();
    }
    void stop()
    {
        if (end_.completed())
            end_ = {RunStatus::Cancelled, RunFailure::None, "stopped at " + fewDigitsOfTime(time_, 4)};
    }

    const Case& case_;
    bool coarser_;
    ContactRows rows_;
    RunRecorder recorder_;
    ContactFigures figures_;
    std::shared_ptr<const RunCheckpoint> from_; // null: the run begins
    std::unique_ptr<ContactModel> model_;
    std::size_t station_ = 0;    // the next one
    std::vector<double> values_; // of the newest station; empty without one
    bool started_ = false, startsInContact_ = false;
    bool away_ = false; // on the way out
    ContactForces forces_;
    std::vector<PullPoint> way_; // out, the last two since a jump
    ContactForces hardest_;      // of the largest contact force
    double hardestTime_ = 0.0;   // [s]
    ContactForces closest_;      // to which the doubts belong
    ContactDoubts doubts_;
    double time_ = 0.0;          // of the last good state [s]
    double largestForce_ = 0.0;  // so far [N]
    double widestBracket_ = 0.0; // of a jump [m]
    double lastChange_ = 0.0;    // of the net force over the last step [N]
    long long steps_ = 0, iterations_ = 0;
    RunEnd end_;
};

} // namespace

Summary runContact(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    return ContactRun(c, callback, options).run();
}

} // namespace touchdown
