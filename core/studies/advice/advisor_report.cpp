// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/advisor_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/advice/advisor_study.h"

namespace touchdown {

namespace {

std::string nm(double length) { return fewDigits(length, "nm"); }
std::string times(double ratio) { return fewDigits(ratio, "") + " times"; }
/// What a model takes against the full one, which takes `ratio` times that.
std::string lessOrMore(double ratio) { return ratio >= 1.0 ? times(ratio) + " less" : times(1.0 / ratio) + " as much"; }
std::string saving(double ratio) { return ratio >= 1.0 ? "saves " + times(ratio) : "costs " + lessOrMore(ratio); }

/// The full model's end is known, and so how far the others are from it.
bool isJudged(const AdvisorResult& result) { return result.pilotTime > 0.0 && result.full.answers(); }

std::string wordFor(const CandidateOutcome& candidate)
{
    if (!candidate.problem.empty()) return "no answer";
    return candidate.givenUp ? "takes longer" : std::string(name(candidate.verdict));
}

/// "mean spacing 0.03 nm (0.1 nm allowed), spread ..." of an outcome.
std::string errorsText(const CandidateErrors& errors, const Allowance& allowed)
{
    return "mean spacing " + textOf(errors.claimedMean()) + " (" + nm(allowed.mean) + " allowed), spread " +
           textOf(errors.claimedSpread()) + " (" + nm(allowed.spread) + " allowed)";
}

/// "9.108 nm" or, where it is predicted, "8.98 +- 0.12 nm".
std::string predicted(double value, double uncertainty)
{
    if (uncertainty == 0.0) return fewDigits(value, "nm", 4);
    return fewDigits(value, "nm", 4) + (std::isfinite(uncertainty) ? " +- " + nm(uncertainty) : " (not known)");
}

std::string endText(const TailEstimate& end)
{
    return std::string(name(end.kind)) + ", mean spacing " + predicted(end.mean, end.meanUncertainty) + ", spread " +
           predicted(end.spread, end.spreadUncertainty) +
           (end.peakFrequency > 0.0 ? ", largest peak at " + fewDigits(end.peakFrequency, "kHz", 3) : "");
}

/// How far the full model was run.
std::string windowText(const AdvisorTask& task, const AdvisorResult& result)
{
    const std::string duration = fewDigitsOfTime(task.start.run.duration);
    return result.pilotWhole ? "over the whole run of " + duration
                             : "over the first " + fewDigitsOfTime(result.pilotTime) + " of " + duration;
}

/// What to do with the advice, on the command line and in the window.
std::string applyText(const CandidateOutcome& advice)
{
    const std::string itsCase = "Its case (--apply FILE, or Apply to the case) ";
    if (advice.found && advice.command == "steady") return itsCase + "has this answer as its static state.";
    if (advice.found && advice.model.kind == CandidateKind::ContactRest)
        return itsCase + "begins at this rest, over a flat disk, and a run stays there. That run checks the rest in a "
                         "film over a tenth of the duration, and takes about a tenth of the full model's time.";
    if (advice.found) return itsCase + "is to be run.";
    return "No case has this answer alone: its numbers stand in the table below, the modes of the film list those of "
           "the air bearing, and models = " +
           std::string(name(advice.model.kind)) + " tries this model alone.";
}

void tellAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    const bool all = result.missing.empty();
    if (result.pilotTime == 0.0) {
        report.findings.push_back(
            "There is no advice: the full model " +
            (result.full.answers() ? "was not run." : "gives no answer: " + result.full.problem + "."));
        return;
    }
    if (!result.full.answers()) {
        report.findings.push_back("There is no advice: the full model was run for " +
                                  fewDigitsOfTime(result.pilotTime) + " of " +
                                  fewDigitsOfTime(task.start.run.duration) +
                                  ". Its end predicted from that: " + endText(result.full.tail) + ".");
        return;
    }
    if (!result.advice) {
        const std::string tried =
            result.candidates.empty()
                ? "no other model was tried."
                : "none of the models that were tried is known to be within the tolerance and takes at most 1/" +
                      fewDigits(worthwhile, "") + " of the full model's time.";
        report.findings.push_back(result.advisesFull() ? "Advice: the full model; " + tried
                                  : all                ? "There is no advice: " + tried
                                                       : "So far there is no advice: " + tried);
    } else {
        const CandidateOutcome& advice = result.candidates[*result.advice];
        report.findings.push_back((all ? "Advice: " : "Advice so far: ") + advice.model.name + ". It leaves out " +
                                  advice.model.leavesOut + ", and takes " + fewDigitsOfTime(advice.seconds) +
                                  " of a processor instead of " + fewDigitsOfTime(result.full.seconds) + ": " +
                                  times(result.full.seconds / advice.seconds) + " less.");
        report.findings.push_back(
            "Claimed error over the last tenth of the run: " + errorsText(advice.errors, result.allowed) +
            "; measured against the full model " + windowText(task, result) +
            (result.pilotWhole ? "." : ", from which its end is predicted."));
    }
    report.findings.push_back("The full model's end" + std::string(result.pilotWhole ? ": " : ", predicted: ") +
                              endText(result.full.tail) + ".");
}

/// Behind the advice and its claim.
void tellConfirmed(const AdvisorResult& result, StudyReport& report)
{
    if (!result.fullEnd) return;
    const TailEstimate& full = result.full.tail;
    const TailEstimate& end = *result.fullEnd;
    if (!result.pilotWhole) {
        const bool came = std::abs(full.mean - end.mean) <= full.meanUncertainty + 0.5 * result.allowed.step &&
                          std::abs(full.spread - end.spread) <= full.spreadUncertainty + 0.5 * result.allowed.step &&
                          full.kind == end.kind;
        report.findings.push_back("The full model, run to its end: " + endText(end) +
                                  (came ? "; as predicted." : "; NOT as predicted."));
        if (!came) report.warnings.push_back("the end of the full model was predicted wrongly; use a longer pilot");
    }
    if (!result.found) return;
    const CandidateOutcome& advice = result.candidates[*result.advice];
    const CandidateErrors& found = *result.found;
    const Claim mean = advice.errors.claimedMean(), spread = advice.errors.claimedSpread();
    const bool meanCame = confirms(mean, found.mean), spreadCame = confirms(spread, found.spread);
    const bool came = found.sameEnd && found.samePeak && meanCame && spreadCame;
    const auto one = [](const Claim& claim, double error, bool held) {
        return nm(error) + " (claimed " + textOf(claim) + (held ? ")" : ": missed)");
    };
    report.findings.insert(
        report.findings.begin() + 2,
        std::string(came ? "Confirmed" : "NOT confirmed") +
            " by the full model to its end: error of the mean spacing " + one(mean, found.mean, meanCame) +
            ", of the spread " + one(spread, found.spread, spreadCame) +
            (found.samePeak ? "" : ", its largest peak elsewhere: missed") +
            (found.sameEnd ? "" : ", and it ends in another state: missed") + "; " +
            fewDigitsOfTime(result.adviceSeconds) + " instead of " + fewDigitsOfTime(result.fullSeconds) + ", " +
            lessOrMore(result.fullSeconds / result.adviceSeconds) + ".");
    if (!came)
        report.warnings.push_back(
            "the whole run of the full model does not confirm the claims of the pilot; use a longer pilot");
}

void tellCandidates(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    if (result.advice) {
        const CandidateOutcome& advice = result.candidates[*result.advice];
        if (!advice.remark.empty())
            report.findings.push_back("Remark on " + advice.model.name + ": " + advice.remark + ".");
        report.findings.push_back(applyText(advice));
    }
    if (task.start.contact != noContact && !result.contactActed)
        report.findings.push_back(
            "Only air acted on the slider in the pilot: contact can be left out there without an error.");
    std::size_t givenUp = 0;
    for (std::size_t k = 0; k < result.candidates.size(); ++k) {
        const CandidateOutcome& candidate = result.candidates[k];
        givenUp += candidate.givenUp;
        if (result.advice == k || candidate.givenUp) continue;
        std::string text = candidate.model.name + " (leaves out " + candidate.model.leavesOut + "): ";
        if (!candidate.answers())
            text += "no answer, " + candidate.problem;
        else if (candidate.verdict == Verdict::AnotherEnd)
            text += "wrong here, ends " + std::string(name(candidate.tail.kind)) + " at " +
                    fewDigits(candidate.tail.mean, "nm", 3);
        else
            text += (candidate.within()                       ? "within the tolerance, "
                     : candidate.verdict == Verdict::NotKnown ? "accuracy not known, "
                                                              : "not enough, ") +
                    errorsText(candidate.errors, result.allowed) +
                    (candidate.errors.samePeak ? "" : ", its largest peak elsewhere") + "; " +
                    saving(result.full.seconds / candidate.seconds);
        report.findings.push_back(text + ".");
    }
    const bool one = givenUp == 1;
    if (givenUp > 0)
        report.findings.push_back(counted(givenUp, "model") + " in time " + (one ? "was" : "were") +
                                  " stopped as soon as " + (one ? "it" : "they") +
                                  " had taken too long to be advised; all = true measures " + (one ? "it." : "them."));
}

void tellLimits(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    const Allowance& allowed = result.allowed;
    if (isJudged(result) && allowed.widened())
        report.findings.push_back("Allowed are " + nm(allowed.mean) + " of the mean and " + nm(allowed.spread) +
                                  " of the spread, where the tolerances alone "
                                  "would be " +
                                  nm(allowed.wantedMean) + " and " + nm(allowed.wantedSpread) +
                                  ", as one step may displace the slider by " + nm(0.5 * allowed.step) +
                                  " (run.step_error).");
    if (result.gridError > 0.0)
        report.findings.push_back("The grid of the full model has an error of about " + nm(result.gridError) +
                                  " in the static spacing; the errors above are relative to the full model.");
    if (isJudged(result) && result.gridError > allowed.mean)
        report.warnings.push_back(
            "the grid error of the full model is larger than the error allowed for a smaller model: about " +
            nm(result.gridError));
    if (!result.growthProblem.empty())
        report.warnings.push_back("the stability of small motions about the static state is not known (" +
                                  result.growthProblem + "); the full model was run to its end");
    if (result.growth > 0.0)
        report.warnings.push_back("an air bearing mode about the static state grows, by " +
                                  fewDigits(result.growth, "") +
                                  " e-folds over the run: small motions do not end in the static state");
    if (result.roughPasses)
        report.findings.push_back("A rough disk moves under the slider, so that no part of a run predicts "
                                  "the rest: the full model was run to its end.");
    const auto endsOtherwise = [](const CandidateOutcome& candidate) {
        return candidate.answers() && candidate.model.kind == CandidateKind::Part &&
               candidate.model.parts[0].family == "steps" && candidate.verdict == Verdict::AnotherEnd;
    };
    if (std::ranges::any_of(result.candidates, endsOtherwise))
        report.warnings.push_back(
            "with larger steps the scene ends in another state: it is close to the border between "
            "two states, and no model predicts its end reliably; study it by an ensemble of starts");
    if (!result.missing.empty())
        report.warnings.push_back((result.late ? "the budget of " + fewDigitsOfTime(task.budget) +
                                                     " was spent before these models were tried: "
                                               : "the study was stopped before these models were tried: ") +
                                  joined(result.missing));
    const bool confirmed = result.fullEnd && (!result.advice || result.found);
    if (task.confirm && !confirmed && isJudged(result) && (result.late || result.status == StudyStatus::Cancelled))
        report.warnings.push_back((result.late ? "the budget of " + fewDigitsOfTime(task.budget) + " was spent"
                                               : std::string("the study was stopped")) +
                                  " before the advice was confirmed");
    report.findings.push_back("The study took " + fewDigitsOfTime(result.studySeconds) + " of a processor" +
                              (result.full.seconds > 0.0 ? ", " + times(result.studySeconds / result.full.seconds) +
                                                               " what the full model takes."
                                                         : "."));
}

StudyChart chartOf(const AdvisorResult& result)
{
    StudyChart chart;
    chart.title = "Error against time, one point per model";
    chart.caption = "Each point is a model of this scene; the shaded part is within the tolerance, the ring is the "
                    "advice. Errors are those "
                    "over the last tenth of the run against the full model; where no more is known than that an error "
                    "is below a value, the point "
                    "is drawn there and named with \"<\". Hollow points end in another state. Time is that of one "
                    "processor for the whole run.";
    for (const bool spread : {false, true}) {
        ChartPanel panel;
        panel.x = {"Time of one processor", "s", "s", true};
        panel.y = {spread ? "Error of the spread" : "Error of the mean spacing", "m", "nm", true};
        ChartSeries reduced{.name = "without a film in time", .line = ChartLine::None};
        ChartSeries film{.name = "film without a part", .line = ChartLine::None};
        ChartSeries full{.name = "full model", .line = ChartLine::None};
        const auto add = [&](ChartSeries& series, const CandidateOutcome& candidate, bool chosen) {
            const Claim claim = spread ? candidate.errors.claimedSpread() : candidate.errors.claimedMean();
            if (!candidate.answers() || !std::isfinite(claim.value) || !(claim.value > 0.0)) return;
            series.points.push_back(
                {.x = std::max(candidate.seconds, 1e-6),
                 .y = claim.value,
                 .label = candidate.model.name + (claim.bound ? ", " + textOf(claim) : ""),
                 .kind = candidate.verdict == Verdict::AnotherEnd ? PointKind::WrongState : PointKind::Good,
                 .chosen = chosen,
                 .yError = claim.bound ? 0.0
                           : spread    ? candidate.errors.spreadUncertainty
                                       : candidate.errors.meanUncertainty});
        };
        for (std::size_t k = 0; k < result.candidates.size(); ++k) {
            const CandidateOutcome& candidate = result.candidates[k];
            add(candidate.model.inTime() ? film : reduced, candidate, result.advice == k);
        }
        add(full, result.full, result.advisesFull());
        panel.series = {reduced, film, full};
        panel.bands.push_back({.alongX = false,
                               .lower = -std::numeric_limits<double>::infinity(),
                               .upper = spread ? result.allowed.spread : result.allowed.mean,
                               .label = "tolerance"});
        chart.panels.push_back(std::move(panel));
    }
    return chart;
}

StudyTable tableOf(const AdvisorResult& result)
{
    StudyTable table{
        .name = "models",
        .columns = {{"model", "", "", "Model"},
                    {"verdict", "", "", "Verdict"},
                    {"end", "", "", "End"},
                    {"mean_claim", "", "", "Claimed error of the mean spacing"},
                    {"spread_claim", "", "", "Claimed error of the spread"},
                    {"time", "s", "s", "Time of one processor, whole run"},
                    {"saving", "", "", "Time of the full model over that"},
                    {"leaves_out", "", "", "Leaves out"},
                    {"mean_error", "m", "nm", "Error of the mean spacing, where it is known to half of it", true},
                    {"mean_error_below", "m", "nm", "Upper bound of that error, where no more is known", true},
                    {"spread_error", "m", "nm", "Error of the spread, where it is known to half of it", true},
                    {"spread_error_below", "m", "nm", "Upper bound of that error, where no more is known", true},
                    {"mean", "m", "nm", "Mean spacing", true},
                    {"spread", "m", "nm", "Standard deviation of the spacing", true},
                    {"peak_frequency", "Hz", "kHz", "Frequency of the largest peak", true},
                    {"peak_amplitude", "m", "nm", "Amplitude of the largest peak", true},
                    {"remark", "", "", "Remark", true}}};
    const auto positive = [](double value) { return known(value > 0.0, value); };
    const auto number = [](const Claim& claim, bool bound) {
        return known(claim.bound == bound && std::isfinite(claim.value), claim.value);
    };
    const bool judged = isJudged(result);
    const auto row = [&](const CandidateOutcome& candidate, const std::string& verdict) {
        std::vector<StudyValue>& cells = table.rows.emplace_back();
        if (!candidate.answers()) {
            cells = {candidate.model.name,
                     verdict,
                     {},
                     {},
                     {},
                     candidate.givenUp ? StudyValue() : positive(candidate.seconds),
                     {},
                     candidate.model.leavesOut};
            cells.resize(table.columns.size() - 1);
            cells.emplace_back(candidate.problem);
            return;
        }
        const Claim mean = candidate.errors.claimedMean(), spread = candidate.errors.claimedSpread();
        const auto ifJudged = [judged](StudyValue value) { return judged ? std::move(value) : StudyValue(); };
        cells = {candidate.model.name,
                 verdict,
                 std::string(name(candidate.tail.kind)),
                 ifJudged(textOf(mean)),
                 ifJudged(textOf(spread)),
                 positive(candidate.seconds),
                 ifJudged(positive(result.full.seconds / std::max(candidate.seconds, 1e-9))),
                 candidate.model.leavesOut,
                 ifJudged(number(mean, false)),
                 ifJudged(number(mean, true)),
                 ifJudged(number(spread, false)),
                 ifJudged(number(spread, true)),
                 candidate.tail.mean,
                 candidate.tail.spread,
                 positive(candidate.tail.peakFrequency),
                 positive(candidate.tail.peakAmplitude),
                 candidate.remark};
    };
    for (std::size_t k = 0; k < result.candidates.size(); ++k)
        row(result.candidates[k], result.advice == k ? "advised" : wordFor(result.candidates[k]));
    if (judged) row(result.full, result.advisesFull() ? "advised" : "reference");
    return table;
}

} // namespace

void reportAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    report.status = result.status;
    report.message = result.message;
    const bool judged = isJudged(result);
    if (!judged && result.candidates.empty() && result.pilotTime == 0.0) return;
    tellAdvice(task, result, report);
    if (judged) {
        tellConfirmed(result, report);
        tellCandidates(task, result, report);
    }
    tellLimits(task, result, report);
    if (judged) report.charts.push_back(chartOf(result));
    if (!result.candidates.empty() || judged) report.tables.push_back(tableOf(result));
    if (!judged) return;
    if (result.advice)
        report.found = result.candidates[*result.advice].found;
    else if (result.advisesFull())
        report.found = task.start;
}

} // namespace touchdown
