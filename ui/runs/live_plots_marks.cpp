// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of the plots beside the curves: events of the newest run and heights of its case.
#include "ui/runs/live_plots.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/formats/units.h"
#include "core/numerics/interval.h"
#include "core/simulation/run.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr std::size_t mostMarks = 2000; // more are closer than a pixel

using Outline = std::vector<std::pair<double, double>>;

/// The net force on the pad on the way up from d_s to d_e; on the way down there is none.
Outline forceOnTheWayUp(const OnoYamane& parameters)
{
    const OnoYamaneLaw law(parameters);
    Outline way;
    for (const ContactRegion region : {ContactRegion::Lifting, ContactRegion::Bridged}) {
        const Interval holds = law.interval(region);
        for (const double d : {holds.lower, holds.upper})
            if (holds.lower < holds.upper)
                way.emplace_back(d, law.contactForce(region, d) + law.adhesionForce(region, d));
    }
    return way;
}

/// The part of the area that encloses W in which the force pushes (sign 1: it creates energy) or pulls (-1: it takes
/// energy), and that energy [J].
std::pair<ShadedArea, double> cyclePart(const Outline& way, double sign)
{
    ShadedArea area;
    area.style.colour = sign > 0.0 ? 1 : 6; // ink, as the marks of events
    Outline& part = area.outline;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const auto [d, force] = way[i];
        if (i > 0 && way[i - 1].second * force < 0.0) { // it changes its sign
            const auto [before, forceBefore] = way[i - 1];
            part.emplace_back(before + forceBefore / (forceBefore - force) * (d - before), 0.0);
        }
        part.emplace_back(d, sign * std::max(0.0, sign * force));
    }
    double energy = 0.0;
    for (std::size_t i = 1; i < part.size(); ++i)
        energy += 0.5 * sign * (part[i].second + part[i - 1].second) * (part[i].first - part[i - 1].first);
    if (!part.empty()) {
        part.insert(part.begin(), {part.front().first, 0.0});
        part.emplace_back(part.back().first, 0.0);
    }
    return {std::move(area), energy};
}

/// The areas that enclose W: one area where the law only takes energy. A part that creates energy is a second area with
/// a colour and a name of its own.
std::vector<ShadedArea> cycleAreas(const OnoYamane& parameters)
{
    const Outline way = forceOnTheWayUp(parameters);
    auto [takes, taken] = cyclePart(way, -1.0);
    auto [creates, created] = cyclePart(way, 1.0);
    const auto energy = [](double value) { return QString::fromStdString(fewDigits(value, "pJ", 3)); };
    takes.label = QStringLiteral("W = %1").arg(trueMinus(energy(OnoYamaneLaw(parameters).cycleWork())));
    if (created <= 0.0) return {takes};
    creates.label = LivePlots::tr("creates %1").arg(energy(created));
    takes.label = LivePlots::tr("takes %1, %2").arg(energy(taken), takes.label);
    return {takes, creates};
}

} // namespace

void LivePlots::updateMarks()
{
    const RunRecord* run = runs_.newestShown();
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
            if (c.contact == ContactKind::OnoYamane) {
                spacing.push_back(line("dₛ", c.onoYamane.touchDown));
                spacing.push_back(line("dₑ", c.onoYamane.takeOff));
            }
            if (c.model == ModelKind::Springs) pitch.push_back({c.springs.pitch, tr("static")});
        }
    }
    for (const Entry& entry : entries_) entry.plot->setEventMarks(marks);
    PlotWidget* forces = plot(QStringLiteral("force_separation"));
    forces->setPointMarks(run ? eventPoints(*run) : std::vector<PointMark>());
    std::vector<ShadedArea> areas;
    if (run && run->value.contact == ContactKind::OnoYamane) areas = cycleAreas(run->value.onoYamane);
    forces->setShadedAreas(std::move(areas));
    // A slider falls from heights without contact forces.
    const bool falls = run && run->value.model == ModelKind::Springs && run->value.contact == ContactKind::OnoYamane;
    forces->setMostX(falls ? std::optional(2.0 * run->value.onoYamane.takeOff) : std::nullopt);
    plot(QStringLiteral("spacing"))->setReferenceLines(spacing);
    plot(QStringLiteral("pitch"))->setReferenceLines(pitch);
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
