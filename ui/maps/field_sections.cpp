// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_sections.h"

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
    const bool inRow = second && cellIndex(grid.y, second->y) == cellIndex(grid.y, point->y);
    const bool inColumn = second && cellIndex(grid.x, second->x) == cellIndex(grid.x, point->x);
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
    const auto add = [&](const QString& name, const CurveStyle& style, const CellGrid& grid, const auto& value) {
        const int i = cellIndex(grid.x, point.x), j = cellIndex(grid.y, point.y);
        if (i < 0 || j < 0) return;
        SectionCurve curve{name, style, {}, {}};
        const std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
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
        add(other.name, other.style, other.grid, [&other](std::size_t cell) { return other.values[cell]; });
    add(name_, style_, map.grid(), [&map](std::size_t cell) { return map.value(cell); });

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
