// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHBoxLayout>

namespace touchdown {

namespace {

/// A curve of steps.
struct SectionCurve {
    QString name;
    CurveStyle style;
    std::vector<double> x, y;
};

/// Places on the line through `at`, a coordinate of the point: both ends of each cell, the point, and equal parts.
std::vector<double> placesOnLine(const std::vector<double>& lines, double at)
{
    constexpr int parts = 8; // of a cell: a wall that is narrower than a cell is seen
    std::vector<double> places;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
        places.push_back(k == 0 ? lines[0] : std::nextafter(lines[k], lines[k + 1]));
        for (int part = 1; part <= parts; ++part)
            places.push_back(std::lerp(lines[k], lines[k + 1], static_cast<double>(part) / parts));
    }
    const auto next = std::ranges::lower_bound(places, at);
    if (next == places.end() || *next != at) places.insert(next, at);
    return places;
}

} // namespace

FieldSections::FieldSections(QWidget* parent) : QWidget(parent)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (Section& section : sections_) {
        section.plot = new PlotWidget(this);
        section.group = new PlotGroup(this);
        section.group->add(section.plot);
        section.plot->setCursorPinned(true);
        layout->addWidget(section.plot, 1);
    }
    alongX()->setTitle(tr("Along x"));
    alongY()->setTitle(tr("Along y"));
    connect(alongX(), &PlotWidget::cursorMoved, this, [this](int which, bool valid, double x) {
        if (valid) emit xChosen(which, x);
        if (!valid && which == 1) emit secondRemoved();
    });
    connect(alongY(), &PlotWidget::cursorMoved, this, [this](int which, bool valid, double y) {
        if (valid) emit yChosen(which, y);
        if (!valid && which == 1) emit secondRemoved();
    });
}

void FieldSections::show(const FieldMap& map, const FieldCursors& cursors)
{
    const auto& [point, second] = cursors;
    const auto cell = point ? map.cellAt(*point) : std::nullopt;
    if (!cell) {
        for (const Section& section : sections_) section.plot->clearCurves();
        return;
    }
    fill(0, map, *point);
    fill(1, map, *point);
    alongX()->setTitle(tr("Along x at y = %1").arg(map.placeText(point->y)));
    alongY()->setTitle(tr("Along y at x = %1").arg(map.placeText(point->x)));
    alongX()->setXLabel(map.axisLabel(QStringLiteral("x")));
    alongY()->setXLabel(map.axisLabel(QStringLiteral("y")));
    alongX()->setPlotCursor(0, point->x);
    alongY()->setPlotCursor(0, point->y);
    const CellGrid& grid = map.grid();
    const auto onLine = [&](const std::vector<double>& lines, double there, double here) {
        return map.atPoints().value ? there == here : cellIndex(lines, there) == cellIndex(lines, here);
    };
    const bool inRow = second && onLine(grid.y, second->y, point->y);
    const bool inColumn = second && onLine(grid.x, second->x, point->x);
    alongX()->setPlotCursor(1, inRow ? std::optional(second->x) : std::nullopt);
    alongY()->setPlotCursor(1, inColumn ? std::optional(second->y) : std::nullopt);
}

void FieldSections::setOthers(const QString& name, const CurveStyle& style, std::vector<OtherField> others)
{
    name_ = name;
    style_ = style;
    others_ = std::move(others);
}

void FieldSections::fill(int axis, const FieldMap& map, const SurfacePoint& point)
{
    Section& section = sections_[static_cast<std::size_t>(axis)];
    const FieldLook& look = map.look();
    std::vector<SectionCurve> curves;
    const auto add = [&](const QString& name, const CurveStyle& style, const CellGrid& grid, const auto& value,
                         const FieldAtPoints& atPoints) {
        const int i = cellIndex(grid.x, point.x), j = cellIndex(grid.y, point.y);
        if (i < 0 || j < 0) return;
        SectionCurve curve{name, style, {}, {}};
        const std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
        if (atPoints.value) {
            curve.x = placesOnLine(lines, axis == 0 ? point.x : point.y);
            for (const double at : curve.x)
                curve.y.push_back(*atPoints.at(axis == 0 ? SurfacePoint{at, point.y} : SurfacePoint{point.x, at}));
            curves.push_back(std::move(curve));
            return;
        }
        for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
            const auto other = static_cast<int>(k);
            const int cell = axis == 0 ? j * grid.nx() + other : other * grid.nx() + i;
            // The step to the next cell takes the smallest part of x: at one x there is one value.
            const double begin = k == 0 ? lines[0] : std::nextafter(lines[k], lines[k + 1]);
            curve.x.insert(curve.x.end(), {begin, lines[k + 1]});
            curve.y.insert(curve.y.end(), 2, value(static_cast<std::size_t>(cell)));
        }
        curves.push_back(std::move(curve));
    };
    for (const OtherField& other : others_)
        add(
            other.name, other.style, other.grid, [&other](std::size_t cell) { return other.values[cell]; },
            other.points);
    add(
        name_, style_, map.grid(), [&map](std::size_t cell) { return map.value(cell); }, map.atPoints());

    const AxisScale scale = look.scale.isLogarithmic() ? AxisScale::Logarithmic : AxisScale::Linear;
    section.plot->setYLabel({look.symbol, look.unit, look.factor, scale});
    section.plot->clearCurves();
    section.steps.clear();
    for (const SectionCurve& curve : curves) {
        auto& made = section.steps.emplace_back(std::make_unique<MinMaxPyramid>());
        made->append(curve.x, curve.y);
        const bool single = curves.size() == 1;
        section.plot->addCurve({.id = QStringLiteral("section %1").arg(section.steps.size()),
                                .name = single ? look.title : tr("%1, %2").arg(look.title, curve.name),
                                .style = curve.style,
                                .data = made.get(),
                                .inLegend = !single,
                                .legend = single ? QString() : curve.name});
    }
    section.group->dataChanged();
}

void FieldSections::setRange(const std::optional<PlotRange>& range)
{
    if (range == range_) return;
    range_ = range;
    for (const Section& section : sections_) section.plot->setView({section.plot->view().x, range_});
}

void FieldSections::fit()
{
    for (const Section& section : sections_) {
        section.group->fit();
        if (range_) section.plot->setView({section.plot->view().x, range_});
    }
}

} // namespace touchdown
