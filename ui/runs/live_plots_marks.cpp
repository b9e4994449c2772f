// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of the plots beside the curves: events of the newest run and heights of its case.
#include "ui/runs/live_plots.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/simulation/run.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/cycle_areas.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr std::size_t mostMarks = 20000; // of events; the plot draws one for each pixel

} // namespace

void LivePlots::updateMarks()
{
    const RunRecord* run = runs_.newestShown();
    const std::optional<OnoYamane> law = run ? characteristic(run->value) : std::nullopt;
    std::vector<EventMark> marks;
    std::vector<ReferenceLine> spacing;
    std::vector<ReferenceLine> pitch;
    marksShown_ = 0;
    if (run) {
        marksShown_ = run->events.size();
        for (std::size_t i = 0; i < std::min(mostMarks, run->events.size()); ++i)
            marks.push_back({run->events[i].time, QString::fromStdString(run->events[i].name)});
        if (runs_.baseline() < 0) {
            const Case& c = run->value;
            const auto line = [](const char* symbol, double value) {
                return ReferenceLine{
                    value, QStringLiteral("%1 = %2").arg(QString::fromUtf8(symbol),
                                                         QString::fromStdString(formatQuantity(value, "nm")))};
            };
            if (c.model == ModelKind::Springs) spacing.push_back(line("d₁", c.springs.cutoff));
            if (law) {
                spacing.push_back(line("dₛ", law->touchDown));
                spacing.push_back(line("dₑ", law->takeOff));
            }
            if (c.model == ModelKind::Springs) pitch.push_back({c.springs.pitch, tr("static")});
        }
    }
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        entries_[s].plot->setEventMarks(marks);
        entries_[s].plot->setPointMarks(wordsOf(s));
    }
    PlotWidget* forces = plot(QStringLiteral("force_separation"));
    forces->setPointMarks(run ? eventPoints(*run) : std::vector<PointMark>());
    std::vector<ShadedArea> areas;
    if (law) areas = cycleAreas(*law);
    const bool hasLoop = run && run->finished() && run->value.model == ModelKind::Contact;
    if (hasLoop && contactLaw(run->value).recordsFit) {
        const MinMaxPyramid* separation = run->pyramid("minimum_spacing");
        const MinMaxPyramid* force = run->pyramid("net_contact_force");
        if (separation && force) areas = cycleAreas(*separation, *force);
    }
    forces->setShadedAreas(std::move(areas));
    // A slider falls from heights without contact forces.
    const double reach = run && run->value.model == ModelKind::Springs ? contactLaw(run->value).reach(run->value) : 0.0;
    forces->setMostX(reach > 0.0 ? std::optional(2.0 * reach) : std::nullopt);
    plot(QStringLiteral("spacing"))->setReferenceLines(spacing);
    plot(QStringLiteral("pitch"))->setReferenceLines(pitch);
}

void LivePlots::setWords(std::vector<Word> words)
{
    if (words_ == words) return;
    words_ = std::move(words);
    updateMarks();
}

/// At the first curve of the plot.
std::vector<PointMark> LivePlots::wordsOf(std::size_t s) const
{
    std::vector<PointMark> marks;
    const PlotSpec& spec = specs_[s];
    if (spec.across || spec.spectrogram || spec.curves.empty() || runs_.baseline() >= 0) return marks;
    for (const Word& word : words_) {
        const RunRecord* run = word.plot == entries_[s].name ? runs_.find(word.run) : nullptr;
        const MinMaxPyramid* curve = run && run->shown ? run->pyramid(spec.curves.front().quantity) : nullptr;
        if (const std::optional<double> y = curve ? curve->valueAt(word.at) : std::nullopt)
            marks.push_back({word.at, *y, word.text, RunsModel::style(*run)});
    }
    return marks;
}

/// Where each kind of event took place first: the snap into contact, the pull-off.
std::vector<PointMark> LivePlots::eventPoints(const RunRecord& run) const
{
    const MinMaxPyramid* separation = run.pyramid("minimum_spacing");
    const MinMaxPyramid* force = run.pyramid("net_contact_force");
    std::vector<PointMark> marks;
    std::set<std::string> named;
    for (std::size_t i = 0; separation && force && i < std::min(mostMarks, run.events.size()); ++i) {
        const RunEvent& event = run.events[i];
        const std::optional<double> x = separation->valueAt(event.time);
        const std::optional<double> y = force->valueAt(event.time);
        if (x && y && named.insert(event.name).second)
            marks.push_back({*x, *y, QString::fromStdString(event.name), {6, 0}});
    }
    return marks;
}

} // namespace touchdown
