// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_sections.h"

#include <cmath>

#include <QHBoxLayout>

namespace touchdown {

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
        if (which == 0 && valid) emit xChosen(x);
    });
    connect(alongY(), &PlotWidget::cursorMoved, this, [this](int which, bool valid, double y) {
        if (which == 0 && valid) emit yChosen(y);
    });
}

void FieldSections::show(const FieldMap& map, const std::optional<SurfacePoint>& point)
{
    const auto cell = point ? map.cellAt(*point) : std::nullopt;
    if (!cell) {
        for (const Section& section : sections_) section.plot->clearCurves();
        return;
    }
    const auto nx = static_cast<std::size_t>(map.grid().nx());
    const std::size_t row = *cell / nx;
    const std::size_t column = *cell % nx;
    std::vector<double> values;
    for (std::size_t i = 0; i < nx; ++i) values.push_back(map.value(row * nx + i));
    fill(sections_[0], map.grid().x, values, map.look());
    values.clear();
    for (std::size_t j = 0; j + 1 < map.grid().y.size(); ++j) values.push_back(map.value(j * nx + column));
    fill(sections_[1], map.grid().y, values, map.look());
    alongX()->setTitle(tr("Along x at y = %1").arg(map.placeText(point->y)));
    alongY()->setTitle(tr("Along y at x = %1").arg(map.placeText(point->x)));
    alongX()->setXLabel(map.axisLabel(QStringLiteral("x")));
    alongY()->setXLabel(map.axisLabel(QStringLiteral("y")));
    alongX()->setPlotCursor(0, point->x);
    alongY()->setPlotCursor(0, point->y);
}

void FieldSections::fill(Section& section, const std::vector<double>& lines, const std::vector<double>& values,
                         const FieldLook& look)
{
    std::vector<double> borders, steps;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // The step to the next cell takes the smallest part of x: at one x there is one value.
        const double begin = i == 0 ? lines[0] : std::nextafter(lines[i], lines[i + 1]);
        borders.insert(borders.end(), {begin, lines[i + 1]});
        steps.insert(steps.end(), {values[i], values[i]});
    }
    auto made = std::make_unique<MinMaxPyramid>();
    made->append(borders, steps);
    const AxisScale scale = look.scale.isLogarithmic() ? AxisScale::Logarithmic : AxisScale::Linear;
    section.plot->setYLabel({{}, look.unit, look.factor, scale});
    section.plot->addCurve({QStringLiteral("section"), {}, {0, 0}, made.get(), nullptr, true});
    section.steps = std::move(made); // the curve points to the new data by now
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
