// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advisor_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/studies/few_digits.h"

namespace touchdown {

namespace {

std::string nm(double length) { return fewDigits(length, "nm"); }
std::string times(double ratio) { return fewDigits(ratio, "") + " times"; }
/// What a model takes against the full one, which takes `ratio` times that.
std::string lessOrMore(double ratio) { return ratio >= 1.0 ? times(ratio) + " less" : times(1.0 / ratio) + " as much"; }
std::string saving(double ratio) { return ratio >= 1.0 ? "saves " + times(ratio) : "costs " + lessOrMore(ratio); }
std::string readableTime(double seconds) { return fewDigitsOfTime(seconds); }

std::string verdictOf(const RungOutcome& rung)
{
    if (!rung.valid()) return "no answer";
    if (!rung.errors.sameEnd) return "another end";
    if (rung.within) return "within";
    return rung.errors.samePeak ? "too far" : "another peak";
}

/// "mean spacing 0.03 nm (0.1 nm allowed), spread ..." of an outcome.
std::string errorsText(const RungErrors& errors, const AdvisorTask& task, const AdvisorResult& result)
{
    const auto one = [](double error, double resolution) { return (error < resolution ? "below " : "") + nm(std::max(error, resolution)); };
    return "mean spacing " + one(errors.mean, errors.meanResolution) + " (" + nm(result.allowedMean(task)) + " allowed), spread " +
           one(errors.spread, errors.spreadResolution) + " (" + nm(result.allowedSpread(task)) + " allowed)";
}

void tellAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    const double duration = task.start.run.duration;
    const TailEstimate& full = result.full.tail;
    const bool whole = result.pilotTime >= duration - 0.5 * result.full.samples.interval;
    const std::string window = whole ? "over the whole run of " + readableTime(duration)
                                     : "over the first " + readableTime(result.pilotTime) + " of " + readableTime(duration);
    if (!result.advice && result.status != StudyStatus::Completed) {
        report.findings.push_back("There is no advice: not all models were tried.");
    } else if (!result.advice) {
        report.findings.push_back("The scene needs the full model: no cheaper one is within the tolerance.");
    } else {
        const RungOutcome& advice = result.rungs[*result.advice];
        report.findings.push_back("Advice: " + advice.rung.name + ". It leaves out " + advice.rung.leavesOut + ", and takes " +
                                  readableTime(advice.seconds) + " of a processor instead of " + readableTime(result.full.seconds) + ": " +
                                  times(result.full.seconds / advice.seconds) + " less.");
        report.findings.push_back("Claimed error over the last tenth of the run: " + errorsText(advice.errors, task, result) +
                                  "; measured against the full model " + window + (whole ? "." : ", from which its end is foretold."));
        if (!advice.remark.empty()) report.findings.push_back("Of " + advice.rung.name + ": " + advice.remark + ".");
    }
    report.findings.push_back("The full model's end: " + std::string(name(full.kind)) + ", mean spacing " + fewDigits(full.mean, "nm", 4) +
                              ", spread " + fewDigits(full.spread, "nm", 3) +
                              (full.peakFrequency > 0.0 ? ", largest peak at " + fewDigits(full.peakFrequency, "kHz", 3) : "") +
                              (whole ? "." : ", foretold to " + nm(full.meanUncertainty) + " and " + nm(full.spreadUncertainty) + "."));
}

void tellRungs(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    const bool contact = task.start.contact != ContactKind::None;
    if (contact && !result.contactActed)
        report.findings.push_back("Nothing but air acted on the slider in the pilot: contact can be left out there without any error.");
    for (std::size_t k = 0; k < result.rungs.size(); ++k) {
        const RungOutcome& rung = result.rungs[k];
        if (result.advice == k) continue;
        std::string text = rung.rung.name + " (leaves out " + rung.rung.leavesOut + "): ";
        if (!rung.valid()) text += "no answer, " + rung.problem;
        else if (!rung.errors.sameEnd)
            text += "wrong here, it ends " + std::string(name(rung.tail.kind)) + " at " + fewDigits(rung.tail.mean, "nm", 3);
        else
            text += (rung.within ? "within the tolerance, " : "not enough, ") + errorsText(rung.errors, task, result) +
                    (rung.errors.samePeak ? "" : ", its largest peak elsewhere") + "; " + saving(result.full.seconds / rung.seconds);
        report.findings.push_back(text + ".");
    }
}

void tellConfirmed(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    if (!result.fullEnd || !result.advice) return;
    const RungOutcome& advice = result.rungs[*result.advice];
    const RungErrors& found = result.found;
    const RungErrors& claimed = advice.errors;
    const bool came = found.sameEnd && confirms(claimed.claimedMean(), found.mean, claimed.meanResolution, result.allowedMean(task)) &&
                      confirms(claimed.claimedSpread(), found.spread, claimed.spreadResolution, result.allowedSpread(task));
    report.findings.insert(report.findings.begin() + 2,
                           std::string(came ? "Confirmed" : "Not confirmed") + " by the full model to its end: error of the mean spacing " +
                               nm(found.mean) + ", of the spread " + nm(found.spread) + (found.sameEnd ? "" : ", and it ends otherwise") +
                               "; " + readableTime(result.adviceSeconds) + " instead of " + readableTime(result.fullSeconds) + ", " +
                               lessOrMore(result.fullSeconds / result.adviceSeconds) + ".");
    if (!came) report.warnings.push_back("the full model's whole run does not confirm what the pilot claims; give a longer pilot");
}

void tellLimits(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    if (result.gridError > 0.0)
        report.findings.push_back("The full model's own grid errs by about " + nm(result.gridError) +
                                  " in the static spacing; errors above are against that model.");
    if (result.gridError > result.allowedMean(task))
        report.warnings.push_back("the full model's own grid errs by more than is allowed of a smaller model: about " + nm(result.gridError));
    if (!result.growthProblem.empty())
        report.warnings.push_back("whether small motions about a static state grow is not known (" + result.growthProblem +
                                  "), so that the full model was run to its end");
    if (result.growth > 0.0)
        report.warnings.push_back("a mode of the film about the static state grows, by " + fewDigits(result.growth, "") +
                                  " e-folds over the run: small motions do not end there");
    const auto endsOtherwise = [](const RungOutcome& rung) {
        return rung.valid() && rung.rung.kind == RungKind::Part && rung.rung.parts[0].family == "steps" && !rung.errors.sameEnd;
    };
    if (std::ranges::any_of(result.rungs, endsOtherwise))
        report.warnings.push_back("with looser steps the scene ends in another state: it lies near the border between two, and its end hangs on "
                                  "what no model knows; study it by an ensemble of starts");
    const RungErrors& own = result.full.errors;
    if (own.meanResolution > result.allowedMean(task) || own.spreadResolution > result.allowedSpread(task))
        report.warnings.push_back("the run's end is not known well enough to judge by the tolerance: the motion has not settled");
    report.findings.push_back("The study took " + readableTime(result.studySeconds) + " of a processor, " +
                              times(result.studySeconds / result.full.seconds) + " what the full model takes.");
}

StudyChart chartOf(const AdvisorTask& task, const AdvisorResult& result)
{
    StudyChart chart;
    chart.title = "Error against time, one point per model";
    chart.caption = "Each point is a model of this scene; the shaded part is within the tolerance, the ring is the advice. Errors are those "
                    "over the last tenth of the run against the full model, drawn at what the pilot can tell where they are less; hollow points "
                    "end in another state. Time is that of one processor for the whole run.";
    for (const bool spread : {false, true}) {
        ChartPanel panel;
        panel.x = {"Time of one processor", "s", "s", true};
        panel.y = {spread ? "Error of the spread" : "Error of the mean spacing", "m", "nm", true};
        ChartSeries reduced{.name = "without a film in time", .points = {}, .line = ChartLine::None};
        ChartSeries film{.name = "film without a part", .points = {}, .line = ChartLine::None};
        ChartSeries full{.name = "full model", .points = {}, .line = ChartLine::None};
        const auto point = [&](const RungOutcome& rung, bool chosen) {
            return ChartPoint{.x = std::max(rung.seconds, 1e-6), .y = spread ? rung.errors.claimedSpread() : rung.errors.claimedMean(),
                              .label = rung.rung.name, .kind = rung.errors.sameEnd ? PointKind::Good : PointKind::WrongState, .chosen = chosen};
        };
        for (std::size_t k = 0; k < result.rungs.size(); ++k) {
            const RungOutcome& rung = result.rungs[k];
            const bool inTime = rung.rung.kind == RungKind::Part || rung.rung.kind == RungKind::Sum;
            if (rung.valid()) (inTime ? film : reduced).points.push_back(point(rung, result.advice == k));
        }
        full.points.push_back(point(result.full, !result.advice));
        panel.series = {reduced, film, full};
        panel.bands.push_back({.alongX = false, .lower = -std::numeric_limits<double>::infinity(),
                               .upper = spread ? result.allowedSpread(task) : result.allowedMean(task), .label = "tolerance"});
        chart.panels.push_back(std::move(panel));
    }
    return chart;
}

StudyTable tableOf(const AdvisorResult& result)
{
    StudyTable table{.name = "models", .columns = {{"model", "", "", "Model"}, {"leaves_out", "", "", "Leaves out"}, {"verdict", "", "", "Verdict"},
        {"end", "", "", "End"}, {"mean_error", "m", "nm", "Claimed error of the mean spacing"},
        {"spread_error", "m", "nm", "Claimed error of the spread"}, {"mean", "m", "nm", "Mean spacing"},
        {"spread", "m", "nm", "Standard deviation of the spacing"}, {"peak_frequency", "Hz", "kHz", "Frequency of the largest peak"},
        {"peak_amplitude", "m", "nm", "Amplitude of the largest peak"}, {"time", "s", "s", "Time of one processor, whole run"},
        {"saving", "", "", "Time of the full model over that"}, {"remark", "", "", "Remark"}}, .rows = {}};
    const auto known = [](double value) { return value > 0.0 ? StudyValue(value) : StudyValue(); };
    const auto row = [&](const RungOutcome& rung, const std::string& verdict) {
        if (!rung.valid()) {
            table.rows.push_back({rung.rung.name, rung.rung.leavesOut, verdict, {}, {}, {}, {}, {}, {}, {}, rung.seconds, {}, rung.problem});
            return;
        }
        table.rows.push_back({rung.rung.name, rung.rung.leavesOut, verdict, std::string(name(rung.tail.kind)), rung.errors.claimedMean(),
                              rung.errors.claimedSpread(), rung.tail.mean, rung.tail.spread, known(rung.tail.peakFrequency),
                              known(rung.tail.peakAmplitude), rung.seconds, known(result.full.seconds / std::max(rung.seconds, 1e-9)),
                              rung.remark});
    };
    for (std::size_t k = 0; k < result.rungs.size(); ++k)
        row(result.rungs[k], result.advice == k ? "advised" : verdictOf(result.rungs[k]));
    row(result.full, result.advice ? "reference" : "advised");
    return table;
}

} // namespace

bool confirms(double claimed, double found, double resolution, double allowed)
{
    const double small = std::max(resolution, 0.1 * allowed);
    if (found <= small && claimed <= small) return true;
    return found <= 2.0 * claimed && claimed <= 2.0 * found;
}

void reportAdvice(const AdvisorTask& task, const AdvisorResult& result, StudyReport& report)
{
    report.status = result.status;
    report.message = result.message;
    if (result.status == StudyStatus::Failed || result.full.samples.spacing.empty()) return;
    tellAdvice(task, result, report);
    tellConfirmed(task, result, report);
    tellRungs(task, result, report);
    tellLimits(task, result, report);
    report.charts.push_back(chartOf(task, result));
    report.tables.push_back(tableOf(result));
    if (result.advice) report.found = result.rungs[*result.advice].found;
    else if (result.status == StudyStatus::Completed) report.found = task.start;
}

} // namespace touchdown
