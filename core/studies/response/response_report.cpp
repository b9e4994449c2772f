// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr double coarse = 0.25; // step, in beats of the waves under both air springs [-]

using ResponseOrdinate = std::function<double(const ForcedMotion&)>;

ChartAxis frequencyAxis()
{
    const ParameterText text = frequencyText();
    return {text.label, text.unit, text.displayUnit};
}

/// "other 1".
std::string otherName(std::size_t number) { return "other " + std::to_string(number); }

/// Both ways and other motions; motions that have not settled are points of their own.
void addWays(ChartPanel& panel, const ResponseResult& result, const ResponseOrdinate& ordinate)
{
    for (const bool down : {false, true}) {
        const std::string way = down ? "down" : "up";
        ChartSeries settled{.name = way}, moving{.name = way + ", not settled", .line = ChartLine::None};
        for (const ResponsePoint& point : result.points) {
            if (point.down != down || !point.done || !point.motion.valid()) continue;
            ChartSeries& series = point.motion.settled() ? settled : moving;
            series.points.push_back({.x = point.motion.frequency, .y = ordinate(point.motion)});
        }
        for (ChartSeries* series : {&settled, &moving})
            if (!series->points.empty()) panel.series.push_back(std::move(*series));
    }
    for (std::size_t k = 0; k < result.others.size(); ++k) {
        ChartSeries series{.name = otherName(k + 1)};
        for (const ForcedMotion& motion : result.others[k].motions)
            series.points.push_back({.x = motion.frequency, .y = ordinate(motion)});
        panel.series.push_back(std::move(series));
    }
}

void addLinear(ChartPanel& panel, const ResponseTask& task, const ResponseResult& result,
               const ResponseOrdinate& ordinate)
{
    ChartSeries series{.name = "small motions", .line = ChartLine::Dashed, .markers = false, .quiet = true};
    for (std::size_t i = 0; i < result.linear.size(); ++i) {
        if (!result.linear[i]) continue;
        ForcedMotion motion;
        motion.harmonic = *result.linear[i];
        series.points.push_back({.x = task.frequencies[i], .y = ordinate(motion)});
    }
    if (!series.points.empty()) panel.series.push_back(std::move(series));
}

/// Where there are two states, between the jumps.
void addBands(ChartPanel& panel, const ResponseTask& task, const ResponseResult& result)
{
    for (const auto& [first, last] : twoStates(result)) {
        ChartBand band{.lower = task.frequencies[first], .upper = task.frequencies[last], .label = "two states"};
        if (first > 0)
            if (const ResponseJump* jump = jumpBetween(task, result, first, first - 1, true))
                band.lower = jump->frequency();
        if (last + 1 < task.frequencies.size())
            if (const ResponseJump* jump = jumpBetween(task, result, last, last + 1, false))
                band.upper = jump->frequency();
        panel.bands.push_back(band);
    }
}

StudyChart responseChart(const ResponseTask& task, const ResponseResult& result)
{
    const Quantity& quantity = task.quantity;
    ChartPanel amplitude{frequencyAxis(),
                         {"Amplitude of the " + readableName(quantity), quantity.unit, quantity.displayUnit}};
    ChartPanel phase{frequencyAxis(), {"Phase against the disk under " + task.under, "rad", "deg"}};
    const auto amplitudeOf = [](const ForcedMotion& motion) { return motion.amplitude(); };
    const auto phaseOf = [turn = phaseTurnOf(result)](const ForcedMotion& motion) { return turn.of(motion.harmonic); };
    for (ChartPanel* panel : {&amplitude, &phase}) {
        const ResponseOrdinate ordinate = panel == &amplitude ? ResponseOrdinate(amplitudeOf) : phaseOf;
        addLinear(*panel, task, result, ordinate);
        addWays(*panel, result, ordinate);
        addBands(*panel, task, result);
    }
    const std::string held = task.wavelength > 0.0
                                 ? "Waves of " + fewDigits(task.wavelength, "um", 4) + "; the speed of the disk changes"
                                 : "The speed of the disk is held; the length of its waves changes";
    return {"Forced motion over the frequency",
            held + ". Amplitude of the waves: " + fewDigits(task.amplitude, "nm", 4) + ". Points: first harmonic of " +
                uncapitalized(quantity.longName) +
                "; its phase is known except for full turns. Dashed: small motions about the static state.",
            {amplitude, phase}};
}

/// Only where the slider touches the disk, or a motion is not that of the forcing's period.
std::optional<StudyChart> contactChart(const ResponseResult& result)
{
    const auto isPlain = [](const ResponsePoint& point) {
        return !point.done || !point.motion.valid() ||
               (point.motion.contactShare == 0.0 && point.motion.touchDowns == 0.0 && point.motion.period == 1);
    };
    if (std::ranges::all_of(result.points, isPlain)) return {};
    ChartPanel spacing{frequencyAxis(), {"Minimum spacing", "m", "nm"}};
    addWays(spacing, result, [](const ForcedMotion& motion) { return motion.leastSpacing; });
    StudyChart chart{"Contact and period of the motion",
                     "The smallest value along the motion of the smallest spacing of pad and pressure centres; the "
                     "number of touch-downs in one period of the forcing; and after how many of these periods the "
                     "motion repeats (0: it has not settled). A number that is the same everywhere is left out.",
                     {spacing}};
    const auto add = [&](const char* label, const ResponseOrdinate& ordinate) {
        ChartPanel panel{frequencyAxis(), {label, "", ""}};
        addWays(panel, result, ordinate);
        std::vector<double> values;
        for (const ChartSeries& series : panel.series)
            for (const ChartPoint& point : series.points) values.push_back(point.y);
        if (std::ranges::adjacent_find(values, std::ranges::not_equal_to()) != values.end())
            chart.panels.push_back(std::move(panel));
    };
    add("Touch-downs per period", [](const ForcedMotion& motion) { return motion.touchDowns; });
    add("Period of the motion", [](const ForcedMotion& motion) { return double(motion.period); });
    return chart;
}

StudyTable pointTable(const ResponseTask& task, const ResponseResult& result)
{
    const Quantity& q = task.quantity;
    StudyTable table{.name = "points"};
    table.columns = {{"way", "", "", "Way"},
                     {"frequency", "Hz", "kHz", "Frequency of the forcing"},
                     {"settled", "", "", "Settled"},
                     {"amplitude", q.unit, q.displayUnit, "Amplitude of the first harmonic of the " + readableName(q)},
                     {"phase", "rad", "deg", "Phase against the disk under " + task.under},
                     {"linear_amplitude", q.unit, q.displayUnit, "Amplitude of small motions"},
                     {"linear_phase", "rad", "deg", "Phase of small motions", true},
                     {"least", q.unit, q.displayUnit, "Least value of the " + readableName(q), true},
                     {"most", q.unit, q.displayUnit, "Largest value of the " + readableName(q), true},
                     {"minimum_spacing", "m", "nm", "Smallest minimum spacing"},
                     {"touch_downs", "", "", "Touch-downs in one period of the forcing"},
                     {"contact_share", "", "%", "Share of the time in contact"},
                     {"period", "", "", "Period of the motion, in periods of the forcing"},
                     {"multiplier", "", "", "Largest magnitude of a multiplier over that period", true},
                     {"remark", "", "", "Remark"}};
    const std::size_t count = task.frequencies.size();
    const PhaseTurn turn = phaseTurnOf(result);
    const auto add = [&](const std::string& way, const ForcedMotion& motion, std::size_t place, bool anew) {
        const bool valid = motion.valid();
        ForcedMotion small;
        const std::optional<std::complex<double>>& linear = result.linear[place];
        small.harmonic = linear.value_or(0.0);
        std::string remark = valid ? "" : motion.problem;
        if (anew) remark += std::string(remark.empty() ? "" : "; ") + "began as the case says";
        table.rows.push_back({way, motion.frequency,
                              std::string(!valid             ? "failed"
                                          : motion.settled() ? "yes"
                                                             : "no"),
                              known(valid, motion.amplitude()), known(valid, turn.of(motion.harmonic)),
                              known(linear.has_value(), small.amplitude()),
                              known(linear.has_value(), turn.of(small.harmonic)), known(valid, motion.least),
                              known(valid, motion.most), known(valid, motion.leastSpacing),
                              known(valid, motion.touchDowns), known(valid, motion.contactShare),
                              known(motion.settled(), double(motion.period)), known(motion.multiplier), remark});
    };
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const ResponsePoint& point = result.points[i];
        if (point.done) add(point.down ? "down" : "up", point.motion, point.down ? 2 * count - 1 - i : i, point.anew);
    }
    for (std::size_t k = 0; k < result.others.size(); ++k)
        for (std::size_t i = 0; i < result.others[k].motions.size(); ++i)
            add(otherName(k + 1), result.others[k].motions[i], result.others[k].first + i, false);
    return table;
}

StudyTable jumpTable(const ResponseTask& task, const ResponseResult& result)
{
    const Quantity& q = task.quantity;
    StudyTable table{.name = "jumps"};
    table.columns = {{"way", "", "", "Way"},
                     {"frequency", "Hz", "kHz", "Frequency of the jump"},
                     {"uncertainty", "Hz", "kHz", "Uncertainty of that frequency"},
                     {"before", q.unit, q.displayUnit, "Amplitude before it"},
                     {"after", q.unit, q.displayUnit, "Amplitude after it"},
                     {"period_before", "", "", "Period before it, in periods of the forcing (0: not settled)"},
                     {"period_after", "", "", "Period after it"},
                     {"other", "", "", "Number of the other motion that ends; 0: of the way", true}};
    for (const ResponseJump& jump : result.jumps)
        table.rows.push_back({std::string(jump.down ? "down" : "up"), jump.frequency(), jump.uncertainty(),
                              jump.before.amplitude(), jump.after.amplitude(), double(jump.before.period),
                              double(jump.after.period), double(jump.other)});
    return table;
}

} // namespace

StudyReport responseReport(const ResponseTask& task, const ResponseResult& result)
{
    StudyReport report;
    report.findings = responseFindings(task, result);
    report.charts = {responseChart(task, result)};
    if (std::optional<StudyChart> contact = contactChart(result)) report.charts.push_back(std::move(*contact));
    report.tables = {pointTable(task, result), jumpTable(task, result)};
    const double step = (task.frequencies.back() - task.frequencies.front()) / double(task.frequencies.size() - 1);
    if (task.beat > 0.0 && step > coarse * task.beat)
        report.warnings.push_back("The frequencies are " + fewDigits(step, "kHz") +
                                  " apart. With the speed held, the waves under " + task.ends + " are in phase each " +
                                  fewDigits(task.beat, "kHz", 3) +
                                  ": maxima and minima of the amplitude between the points are not shown.");
    if (!task.outside.empty()) {
        std::vector<std::string> outside;
        for (const double each : task.outside) outside.push_back(fewDigits(each, "kHz", 3));
        report.warnings.push_back("The slider also vibrates outside the range, about its static state, at " +
                                  joined(outside) + ": wider from and to include that.");
    }
    std::size_t failed = 0;
    const ResponsePoint* first = nullptr;
    for (const ResponsePoint& point : result.points)
        if (point.done && !point.motion.valid()) {
            if (first == nullptr) first = &point;
            ++failed;
        }
    if (first != nullptr)
        report.warnings.push_back(counted(failed, "motion") + " failed, the first at " +
                                  frequencyText().of(first->motion.frequency) + ": " + first->motion.problem + ".");
    return report;
}

} // namespace touchdown
