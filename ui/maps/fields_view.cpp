// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/fields_view.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/formats/units.h"
#include "ui/maps/field_cursor_table.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int leastSections = 130; // [px]: room for the title of the upright axis

} // namespace

FieldsView::FieldsView(QWidget* parent)
    : QWidget(parent),
      controls_(new QWidget(this)),
      unit_(new QComboBox(controls_)),
      logarithmic_(new QCheckBox(tr("&Log"), controls_)),
      map_(new FieldMap(this)),
      sections_(new FieldSections(this)),
      table_(new FieldCursorTable(this))
{
    auto* row = new QHBoxLayout(controls_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(logarithmic_);
    row->addWidget(unit_);
    unit_->setAccessibleName(tr("Unit"));
    unit_->setToolTip(tr("Unit of the map and its sections"));
    logarithmic_->setToolTip(tr("Logarithmic scale: shows small values beside large ones"));
    connect(unit_, &QComboBox::currentIndexChanged, this, &FieldsView::showField);
    connect(logarithmic_, &QCheckBox::toggled, this, [this](bool on) {
        logarithms_[static_cast<std::size_t>(field_)] = on;
        showField();
    });

    auto* split = new QSplitter(Qt::Vertical, this);
    split->addWidget(map_);
    auto* below = new QWidget(split);
    auto* sectionsAndTable = new QVBoxLayout(below);
    sectionsAndTable->setContentsMargins(0, 0, 0, 0);
    sectionsAndTable->setSpacing(0);
    sectionsAndTable->addWidget(sections_, 1);
    sections_->setMinimumHeight(leastSections);
    sectionsAndTable->addWidget(table_);
    split->addWidget(below);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 1);
    split->setSizes({520, 220});
    split->setCollapsible(0, false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(controls_);
    layout->addWidget(split, 1);
    map_->setAccessibleDescription(
        map_->accessibleDescription() +
        tr(" Shift and arrow keys move the sections by a cell, with Ctrl cursor 2. Escape lets the sections follow the "
           "pointer."));

    connect(map_, &SliderPlan::pointed, this, [this](const std::optional<SurfacePoint>& point) {
        if (point && !pinned_ && !map_->empty()) setSectionPoint(*point, false);
    });
    connect(map_, &SliderPlan::chosen, this, [this](const SurfacePoint& point) { setSectionPoint(point, true); });
    connect(map_, &SliderPlan::secondChosen, this, &FieldsView::setSecondPoint);
    const auto move = [this](int which, const SurfacePoint& to) {
        which == 0 ? setSectionPoint(to, true) : setSecondPoint(to);
    };
    connect(sections_, &FieldSections::xChosen, this, [this, move](int which, double x) {
        if (sectionPoint_) move(which, {x, sectionPoint_->y});
    });
    connect(sections_, &FieldSections::yChosen, this, [this, move](int which, double y) {
        if (sectionPoint_) move(which, {sectionPoint_->x, y});
    });
    connect(sections_, &FieldSections::secondRemoved, this, [this] { setSecondPoint(std::nullopt); });
}

void FieldsView::setKinds(std::vector<MapKind> kinds)
{
    kinds_ = std::move(kinds);
    logarithms_.clear();
    for (const MapKind& kind : kinds_) logarithms_.push_back(kind.logarithm == MapKind::Logarithm::AtFirst);
    field_ = std::clamp(field_, 0, std::max(0, static_cast<int>(kinds_.size()) - 1));
    fields_.clear();
    showKind();
}

void FieldsView::setFields(const CellGrid& grid, std::vector<std::vector<double>> fields, std::vector<PlotRange> ranges,
                           std::vector<FieldAtPoints> points)
{
    grid_ = grid;
    fields_ = std::move(fields);
    ranges_ = std::move(ranges);
    points_ = std::move(points);
    showField();
}

void FieldsView::setOthers(const QString& name, const CurveStyle& style, std::vector<OtherFields> others)
{
    name_ = name;
    style_ = style;
    others_ = std::move(others);
}

void FieldsView::setField(int kind)
{
    field_ = kind;
    showKind();
}

void FieldsView::fit()
{
    map_->fit();
    sections_->fit();
}

void FieldsView::showKind()
{
    if (kinds_.empty()) return;
    const auto chosen = static_cast<std::size_t>(field_);
    const MapKind& kind = kinds_[chosen];
    {
        const QSignalBlocker quietUnit(unit_), quietLogarithmic(logarithmic_);
        unit_->clear();
        for (const std::string& unit : kind.units) unit_->addItem(unitText(unit), QString::fromStdString(unit));
        logarithmic_->setChecked(logarithms_[chosen]);
    }
    unit_->setVisible(unit_->count() > 1); // a single unit is shown at the bar
    logarithmic_->setVisible(kind.logarithm != MapKind::Logarithm::None);
    showField();
}

void FieldsView::showField()
{
    if (kinds_.empty()) return;
    const auto chosen = static_cast<std::size_t>(field_);
    std::vector<double> values = chosen < fields_.size() ? fields_[chosen] : std::vector<double>();
    const bool fixed = chosen < ranges_.size();
    PlotRange range = fixed ? ranges_[chosen] : PlotRange();
    if (!fixed && !values.empty()) {
        const auto [low, high] = std::ranges::minmax(values);
        range = {low, high};
    }
    FieldLook shown = look(kinds_[chosen], logarithms_[chosen], range.low, range.high);
    if (fixed && !values.empty()) {
        const auto [low, high] = std::ranges::minmax(values);
        if (high > range.high) shown.remark += tr(", beyond the scale up to %1").arg(fieldText(high, shown));
        if (low < range.low) shown.remark += tr(", beyond the scale down to %1").arg(fieldText(low, shown));
    }
    const FieldAtPoints points = chosen < points_.size() && !values.empty() ? points_[chosen] : FieldAtPoints();
    shown.error = points.error;
    map_->setLook(shown);
    map_->setField(grid_, std::move(values), points);
    std::vector<OtherField> others;
    for (const OtherFields& other : others_)
        if (chosen < other.fields.size() && !other.fields[chosen].empty())
            others.push_back({other.name, other.style, other.grid, other.fields[chosen],
                              chosen < other.points.size() ? other.points[chosen] : FieldAtPoints()});
    shownOthers_ = others;
    sections_->setOthers(name_, style_, std::move(others));
    sections_->setRange(
        fixed ? std::optional(autoscaled(range, {0.0, 0.0},
                                         shown.scale.isLogarithmic() ? AxisScale::Logarithmic : AxisScale::Linear,
                                         shown.factor))
              : std::nullopt);
    showCursors();
}

void FieldsView::showCursors()
{
    if (secondPoint_ && (!map_->onSlider(*secondPoint_) || !sectionPoint_)) secondPoint_.reset();
    map_->setCursors(sectionPoint_, secondPoint_);
    sections_->show(*map_, {sectionPoint_, secondPoint_});
    table_->show(*map_, {sectionPoint_, secondPoint_}, name_, shownOthers_);
}

FieldLook FieldsView::look(const MapKind& kind, bool logarithmic, double low, double high) const
{
    FieldLook look;
    const std::string unit = unit_->currentData().toString().toStdString();
    look.title = kind.title;
    look.symbol = kind.symbol;
    look.unit = unitText(unit);
    look.factor = unitFactor(unit);
    const ColourMap diverging = isDark(palette()) ? ColourMap::DivergingOnDark : ColourMap::DivergingOnLight;
    const auto sequential = [&](bool brightLow) {
        // Where a value is zero there is no logarithm.
        const ColourScale scale = logarithmic && low > 0.0 ? ColourScale::logarithmic(ColourMap::Viridis, low, high)
                                                           : ColourScale::linear(ColourMap::Viridis, low, high);
        return brightLow ? scale.reversed() : scale;
    };
    switch (kind.colours) {
    case MapKind::Colours::BrightHigh: look.scale = sequential(false); break;
    case MapKind::Colours::BrightLow: look.scale = sequential(true); break;
    case MapKind::Colours::Recess: look.scale = ColourScale::linear(ColourMap::Mako, low, high).reversed(); break;
    case MapKind::Colours::Signed:
        if (!kind.aboutZero && !logarithmic && (low >= 0.0 || high <= 0.0))
            look.scale = sequential(high <= 0.0 && low < 0.0);
        else
            look.scale = logarithmic ? ColourScale::aboutZeroLogarithmic(diverging, low, high, kind.near)
                                     : ColourScale::aboutZero(diverging, low, high);
        break;
    }
    return look;
}

void FieldsView::proposeSectionPoint(const std::optional<SurfacePoint>& point)
{
    const bool inside = sectionPoint_ && map_->onSlider(*sectionPoint_);
    if (pinned_ && inside && point) return;
    sectionPoint_ = point;
    pinned_ = false;
}

void FieldsView::setSectionPoint(const SurfacePoint& point, bool pinned)
{
    pinned_ = pinned;
    sectionPoint_ = point;
    showCursors();
}

void FieldsView::setSecondPoint(const std::optional<SurfacePoint>& point)
{
    secondPoint_ = point;
    showCursors();
}

void FieldsView::moveCursor(bool second, int cellsX, int cellsY)
{
    const std::optional<SurfacePoint>& from = second ? secondPoint_ : sectionPoint_;
    if (!from || map_->empty()) return;
    const auto cell = map_->cellAt(*from);
    if (!cell) return;
    const CellGrid& grid = map_->grid();
    const int i = std::clamp(static_cast<int>(*cell % static_cast<std::size_t>(grid.nx())) + cellsX, 0, grid.nx() - 1);
    const int j = std::clamp(static_cast<int>(*cell / static_cast<std::size_t>(grid.nx())) + cellsY, 0, grid.ny() - 1);
    const SurfacePoint to{grid.centreX(i), grid.centreY(j)};
    second ? setSecondPoint(to) : setSectionPoint(to, true);
}

void FieldsView::keyPressEvent(QKeyEvent* event)
{
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool second = event->modifiers().testFlag(Qt::ControlModifier);
    if (event->key() == Qt::Key_Escape) {
        pinned_ = false;
        setSecondPoint(std::nullopt);
    } else if (shift && event->key() == Qt::Key_Left)
        moveCursor(second, -1, 0);
    else if (shift && event->key() == Qt::Key_Right)
        moveCursor(second, 1, 0);
    else if (shift && event->key() == Qt::Key_Up)
        moveCursor(second, 0, 1);
    else if (shift && event->key() == Qt::Key_Down)
        moveCursor(second, 0, -1);
    else
        QWidget::keyPressEvent(event);
}

void FieldsView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showField();
}

} // namespace touchdown
