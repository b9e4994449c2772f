// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_sections.h"

#include <cmath>

#include <QHBoxLayout>

#include "core/formats/units.h"
#include "ui/plot/plot_menu.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

FieldSections::FieldSections(QWidget* parent) : QWidget(parent), alongX_(makeSection()), alongY_(makeSection())
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(alongX_.plot, 1);
    layout->addWidget(alongY_.plot, 1);
    alongX_.plot->setTitle(tr("Along x"));
    alongY_.plot->setTitle(tr("Along y"));
    connect(alongX_.plot, &PlotWidget::cursorMoved, this, [this](int which, bool valid, double x) {
        if (which == 0 && valid) emit xChosen(x);
    });
    connect(alongY_.plot, &PlotWidget::cursorMoved, this, [this](int which, bool valid, double y) {
        if (which == 0 && valid) emit yChosen(y);
    });
}

FieldSections::~FieldSections() = default;

FieldSections::Section FieldSections::makeSection()
{
    Section section;
    section.plot = new PlotWidget(this);
    section.group = new PlotGroup(this);
    section.group->add(section.plot);
    section.plot->setCursorPinned(true);
    installPlotMenu(section.plot, section.group);
    return section;
}

void FieldSections::show(const FieldMap& map, const std::optional<SurfacePoint>& point)
{
    const auto cell = point ? map.cellAt(*point) : std::nullopt;
    if (!cell) {
        for (const Section* section : {&alongX_, &alongY_}) section->plot->clearCurves();
        return;
    }
    const auto nx = static_cast<std::size_t>(map.grid().nx());
    const std::size_t row = *cell / nx;
    const std::size_t column = *cell % nx;
    std::vector<double> alongX, alongY;
    for (std::size_t i = 0; i < nx; ++i) alongX.push_back(map.value(row * nx + i));
    for (std::size_t j = 0; j + 1 < map.grid().y.size(); ++j) alongY.push_back(map.value(j * nx + column));
    alongX_.plot->setTitle(tr("Along x at y = %1").arg(map.placeText(point->y)));
    alongY_.plot->setTitle(tr("Along y at x = %1").arg(map.placeText(point->x)));
    const auto labelled = [&map](PlotWidget* plot, const QString& name) {
        plot->setXLabel({name, unitText(map.lengthUnit()), unitFactor(map.lengthUnit()), AxisScale::Linear});
    };
    labelled(alongX_.plot, QStringLiteral("x"));
    labelled(alongY_.plot, QStringLiteral("y"));
    fill(alongX_, map.grid().x, alongX, map.look());
    fill(alongY_, map.grid().y, alongY, map.look());
    alongX_.plot->setPlotCursor(0, point->x);
    alongY_.plot->setPlotCursor(0, point->y);
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
    for (const Section* section : {&alongX_, &alongY_}) section->plot->setView({section->plot->view().x, range_});
}

void FieldSections::fit()
{
    for (const Section* section : {&alongX_, &alongY_}) {
        section->group->fit();
        if (range_) section->plot->setView({section->plot->view().x, range_});
    }
}

} // namespace touchdown
