// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycles_report.h"

#include <functional>

#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

bool isFilm(const CyclesTask& task) { return task.start.model == ModelKind::Film; }

using CycleOrdinate = std::function<double(const LimitCycle&)>;

/// Branches cut where their stability changes; each part reaches to the first point of the next.
void addBranches(ChartPanel& panel, const CyclesResult& result, const std::string& what, const CycleOrdinate& ordinate)
{
    for (const CycleBranch& branch : result.branches)
        for (std::size_t begin = 0; begin < branch.points.size();) {
            const bool stable = branch.points[begin].stable();
            ChartSeries series{.name = (stable ? "stable " : "unstable ") + what,
                               .line = stable ? ChartLine::Solid : ChartLine::Dashed,
                               .markers = false};
            std::size_t i = begin;
            for (; i < branch.points.size(); ++i) {
                const LimitCycle& point = branch.points[i];
                series.points.push_back({.x = point.value, .y = ordinate(point)});
                if (point.stable() != stable) break;
            }
            begin = i;
            panel.series.push_back(std::move(series));
        }
}

void addMarks(ChartPanel& panel, const CyclesResult& result, const CycleOrdinate& ordinate)
{
    for (const CycleMark kind :
         {CycleMark::Fold, CycleMark::PeriodDoubling, CycleMark::NeimarkSacker, CycleMark::Grazing, CycleMark::End}) {
        ChartSeries series{.name = std::string(name(kind)), .line = ChartLine::None};
        for (const CycleBranch& branch : result.branches)
            for (const MarkedCycle& mark : branch.marks)
                if (mark.kind == kind)
                    series.points.push_back({.x = mark.at.value, .y = ordinate(mark.at), .label = mark.remark});
        if (!series.points.empty()) panel.series.push_back(std::move(series));
    }
}

void addLongRuns(ChartPanel& panel, const CyclesResult& result,
                 const std::function<double(const BouncingRun&)>& ordinate)
{
    ChartSeries series{.name = "ends of long runs", .line = ChartLine::None};
    for (const BouncingRun& run : result.runs)
        if (run.cycle) series.points.push_back({.x = run.value, .y = ordinate(run)});
    if (!series.points.empty()) panel.series.push_back(std::move(series));
}

ChartAxis parameterAxis(const CyclesTask& task) { return {task.text.label, task.text.unit, task.text.displayUnit}; }

StudyChart cycleChart(const CyclesTask& task, const CyclesResult& result)
{
    ChartPanel amplitude{parameterAxis(task), {"Amplitude of the minimum spacing", "m", "nm"}};
    ChartPanel frequency{parameterAxis(task), {"Frequency", "Hz", "kHz"}};
    const auto amplitudeOf = [](const LimitCycle& cycle) { return cycle.amplitude(); };
    const auto frequencyOf = [](const LimitCycle& cycle) { return cycle.frequency(); };
    addBranches(amplitude, result, "cycles", amplitudeOf);
    addMarks(amplitude, result, amplitudeOf);
    addLongRuns(amplitude, result, [](const BouncingRun& run) { return run.amplitude(); });
    addBranches(frequency, result, "cycles", frequencyOf);
    addMarks(frequency, result, frequencyOf);
    addLongRuns(frequency, result, [](const BouncingRun& run) { return run.frequency; });
    return {"Cycles of sustained bouncing over " + uncapitalized(task.text.label),
            "Lines: cycles followed by continuation. Points: the last tenth of runs of " +
                fewDigitsOfTime(task.search.duration, 3) +
                " that end on a cycle. The amplitude is half the swing of the "
                "minimum spacing.",
            {amplitude, frequency}};
}

StudyChart energyChart(const CyclesTask& task, const CyclesResult& result)
{
    ChartPanel energy{parameterAxis(task), {"Energy given to the slider in one cycle", "J", "pJ"}};
    addBranches(energy, result, "cycles: contact", [](const LimitCycle& c) { return c.energies.contact; });
    addBranches(energy, result, "cycles: air", [](const LimitCycle& c) { return c.energies.air; });
    addBranches(energy, result, "cycles: suspension", [](const LimitCycle& c) { return c.energies.suspension; });
    addBranches(energy, result, "cycles: friction", [](const LimitCycle& c) { return c.energies.friction; });
    energy.bands.push_back({.alongX = false, .lower = 0.0, .upper = 0.0});
    return {"Energy of one cycle over " + uncapitalized(task.text.label),
            "By part; the parts of a cycle add up to zero. The contact gives -W at each touch-down from flight.",
            {energy}};
}

std::vector<StudyColumn> energyColumns(bool film)
{
    return {
        {"work", "J", "pJ", "W, which one loop of the contact law takes"},
        {"contact", "J", "pJ", "Energy that contact and adhesion give in one cycle"},
        {"air", "J", "pJ", film ? "Energy that the film gives" : "Energy that the dashpots of the air springs give"},
        {"suspension", "J", "pJ", "Energy that the dashpots of the suspension give"},
        {"friction", "J", "pJ", "Energy that friction gives"}};
}

void addEnergies(std::vector<StudyValue>& row, const LimitCycle& cycle)
{
    row.insert(row.end(), {cycle.cycleWork, cycle.energies.contact, cycle.energies.air, cycle.energies.suspension,
                           cycle.energies.friction});
}

StudyTable cycleTable(const CyclesTask& task, const CyclesResult& result)
{
    StudyTable table{.name = "cycles"};
    table.columns = {{"branch", "", "", "Branch"},
                     {"value", task.text.unit, task.text.displayUnit, task.text.label},
                     {"period", "s", "us", "Period"},
                     {"frequency", "Hz", "kHz", "Frequency"},
                     {"amplitude", "m", "nm", "Amplitude, half the swing of the minimum spacing"},
                     {"separation_min", "m", "nm", "Smallest separation d of the pad"},
                     {"separation_max", "m", "nm", "Largest separation d of the pad"},
                     {"touch_downs", "", "", "Touch-downs in one cycle"},
                     {"stable", "", "", "Stable"},
                     {"multiplier", "", "",
                      isFilm(task) ? "Largest magnitude of a Floquet multiplier, also of slow parts of the film"
                                   : "Largest magnitude of a Floquet multiplier"}};
    for (StudyColumn& column : energyColumns(isFilm(task))) table.columns.push_back(std::move(column));
    table.columns.push_back({"residual", "", "", "Residual of the energy balance, of its largest part"});
    if (isFilm(task))
        table.columns.push_back(
            {"linear_error", "", "", "Estimated error of the linear film and of the nearest point, of the motion"});
    for (std::size_t k = 0; k < result.branches.size(); ++k)
        for (const LimitCycle& point : result.branches[k].points) {
            std::vector<StudyValue> row{double(k + 1),
                                        point.value,
                                        point.period,
                                        point.frequency(),
                                        point.amplitude(),
                                        point.separation.least,
                                        point.separation.most,
                                        double(point.touchDowns),
                                        std::string(point.stable() ? "yes" : "no"),
                                        point.largestMultiplier()};
            addEnergies(row, point);
            row.emplace_back(point.residual());
            if (isFilm(task)) row.emplace_back(point.modelError);
            table.rows.push_back(std::move(row));
        }
    return table;
}

StudyTable specialTable(const CyclesTask& task, const CyclesResult& result)
{
    StudyTable table{.name = "special_points"};
    table.columns = {{"branch", "", "", "Branch"},
                     {"kind", "", "", "Kind"},
                     {"remark", "", "", "Switch that is lost or appears, or why the branch ends"},
                     {"ends", "", "", "The branch ends here"},
                     {"value", task.text.unit, task.text.displayUnit, task.text.label},
                     {"frequency", "Hz", "kHz", "Frequency"},
                     {"amplitude", "m", "nm", "Amplitude, half the swing of the minimum spacing"}};
    for (StudyColumn& column : energyColumns(isFilm(task))) table.columns.push_back(std::move(column));
    for (std::size_t k = 0; k < result.branches.size(); ++k)
        for (const MarkedCycle& mark : result.branches[k].marks) {
            std::vector<StudyValue> row{
                double(k + 1), std::string(name(mark.kind)), mark.remark,        std::string(mark.ends ? "yes" : "no"),
                mark.at.value, mark.at.frequency(),          mark.at.amplitude()};
            addEnergies(row, mark.at);
            table.rows.push_back(std::move(row));
        }
    return table;
}

StudyTable longRunTable(const CyclesTask& task, const CyclesResult& result)
{
    StudyTable table{.name = "runs"};
    table.columns = {{"value", task.text.unit, task.text.displayUnit, task.text.label},
                     {"height", "m", "nm", "Flying height at the start"},
                     {"end", "", "", "End of the run"},
                     {"frequency", "Hz", "kHz", "Frequency at the end"},
                     {"amplitude", "m", "nm", "Amplitude at the end, half the swing of the minimum spacing"},
                     {"remark", "", "", "Remark"}};
    for (const BouncingRun& run : result.runs) {
        const bool bounces = run.end == BouncingEnd::Bounces || run.cycle;
        table.rows.push_back({run.value, run.height, std::string(name(run.end)),
                              known(bounces && run.frequency > 0.0, run.frequency), known(bounces, run.amplitude()),
                              run.problem});
    }
    return table;
}

} // namespace

StudyReport cyclesReport(const CyclesTask& task, const CyclesResult& result)
{
    StudyReport report;
    // While the study is under way, runs are missing.
    if (result.runs.size() == task.values.size() * std::size_t(task.starts))
        report.findings = cyclesFindings(task, result);
    if (!result.branches.empty()) report.charts = {cycleChart(task, result), energyChart(task, result)};
    report.tables = {cycleTable(task, result), specialTable(task, result), longRunTable(task, result)};
    if (const std::vector<ValueRange> ranges = creatingRanges(task); !ranges.empty())
        report.warnings.push_back("W is negative for " + uncapitalized(task.text.label) + " " +
                                  text(ranges, task.text) + creatingLaw);
    std::size_t cycles = 0, driven = 0;
    for (const CycleBranch& branch : result.branches)
        for (const LimitCycle& cycle : branch.points) {
            ++cycles;
            driven += cycle.energies.air > 0.0;
        }
    if (isFilm(task) && driven > 0)
        report.warnings.push_back("on " + std::to_string(driven) + " of " + counted(cycles, "cycle") +
                                  " the film gives energy: it does not damp each vibration of the slider on this grid; "
                                  "see the modes of the case, and take more film.nodes");
    for (const BouncingRun& run : result.runs)
        if (run.end == BouncingEnd::Failed) {
            report.warnings.push_back("one run or more failed: " + run.problem);
            break;
        }
    return report;
}

} // namespace touchdown
