// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps_view.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/simulation/units.h"
#include "ui/quantity_format.h"
#include "ui/theme.h"

namespace touchdown {

namespace {

constexpr double nearAmbient = 1e3; // a pressure that a logarithmic scale does not tell from ambient [Pa]

const std::vector<const char*>& unitsOf(MapsView::Quantity quantity)
{
    static const std::vector<const char*> pressures{"kPa", "atm", "MPa"};
    static const std::vector<const char*> lengths{"nm", "um"};
    return quantity == MapsView::Quantity::Pressure ? pressures : lengths;
}

} // namespace

MapsView::MapsView(QWidget* parent)
    : QWidget(parent),
      controls_(new QWidget(this)),
      unit_(new QComboBox(controls_)),
      logarithmic_(new QCheckBox(tr("&Log"), controls_)),
      map_(new FieldMap(this)),
      sections_(new FieldSections(this))
{
    buildControls();
    auto* split = new QSplitter(Qt::Vertical, this);
    split->addWidget(map_);
    split->addWidget(sections_);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 1);
    split->setSizes({520, 220});
    split->setCollapsible(0, false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(controls_);
    layout->addWidget(split, 1);
    map_->setAccessibleDescription(map_->accessibleDescription()
                                   + tr(" Shift and arrow keys move the sections by a cell, Escape lets them follow the pointer."));

    connect(map_, &SliderPlan::pointed, this, [this](const std::optional<SurfacePoint>& point) {
        if (point && !pinned_ && !map_->empty()) setSectionPoint(*point, false);
    });
    connect(map_, &SliderPlan::chosen, this, [this](const SurfacePoint& point) { setSectionPoint(point, true); });
    connect(sections_, &FieldSections::xChosen, this, [this](double x) {
        if (sectionPoint_) setSectionPoint({x, sectionPoint_->y}, true);
    });
    connect(sections_, &FieldSections::yChosen, this, [this](double y) {
        if (sectionPoint_) setSectionPoint({sectionPoint_->x, y}, true);
    });
    showQuantity();
}

void MapsView::buildControls()
{
    auto* layout = new QHBoxLayout(controls_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(logarithmic_);
    layout->addWidget(unit_);
    unit_->setAccessibleName(tr("Unit"));
    unit_->setToolTip(tr("Unit of the map and its sections"));
    logarithmic_->setToolTip(tr("Logarithmic scale: shows what is weak beside what is strong"));
    connect(unit_, &QComboBox::currentIndexChanged, this, &MapsView::showField);
    connect(logarithmic_, &QCheckBox::toggled, this, [this](bool on) {
        (quantity_ == Quantity::Gap ? logarithmicGap_ : logarithmicPressure_) = on;
        showField();
    });
}

void MapsView::setResult(const SteadyResult& result, const SliderCase& slider, double skew, double ambient)
{
    result_ = result;
    ambient_ = ambient;
    map_->setSlider(slider.length, slider.width);
    map_->setSkew(skew);
    const bool inside = sectionPoint_ && map_->onSlider(*sectionPoint_);
    if (!pinned_ || !inside) {
        sectionPoint_ = nearestTheDisk();
        pinned_ = false;
    }
    showField();
}

/// The middle of the cell with the smallest gap: the point of minimum spacing itself lies on the border of a rail.
std::optional<SurfacePoint> MapsView::nearestTheDisk() const
{
    if (result_.gap.empty()) return std::nullopt;
    const auto cell = static_cast<int>(std::ranges::min_element(result_.gap) - result_.gap.begin());
    return SurfacePoint{result_.grid.centreX(cell % result_.grid.nx()), result_.grid.centreY(cell / result_.grid.nx())};
}

void MapsView::clear()
{
    result_ = {};
    sectionPoint_.reset();
    pinned_ = false;
    showField();
}

void MapsView::setQuantity(Quantity quantity)
{
    quantity_ = quantity;
    showQuantity();
}

void MapsView::fit()
{
    map_->fit();
    sections_->fit();
}

void MapsView::showQuantity()
{
    {
        const QSignalBlocker quiet(unit_);
        unit_->clear();
        for (const char* unit : unitsOf(quantity_)) unit_->addItem(unitText(unit), QString::fromLatin1(unit));
    }
    {
        const QSignalBlocker quiet(logarithmic_);
        logarithmic_->setChecked(quantity_ == Quantity::Gap ? logarithmicGap_ : logarithmicPressure_);
    }
    logarithmic_->setVisible(quantity_ != Quantity::Recess); // on the pads it is zero
    showField();
}

void MapsView::showField()
{
    std::vector<double> values;
    switch (quantity_) {
    case Quantity::Pressure:
        values = result_.pressure;
        for (double& value : values) value -= ambient_;
        break;
    case Quantity::Gap: values = result_.gap; break;
    case Quantity::Recess: values = result_.recess; break;
    }
    map_->setLook(look(values));
    map_->setField(result_.grid, std::move(values));
    map_->setSectionPoint(sectionPoint_);
    sections_->show(*map_, sectionPoint_);
}

FieldLook MapsView::look(const std::vector<double>& values) const
{
    FieldLook look;
    const std::string unit = unit_->currentData().toString().toStdString();
    look.unit = unitText(unit);
    look.factor = unitFactor(unit);
    double low = 0.0;
    double high = 1.0;
    if (!values.empty()) {
        const auto [least, most] = std::ranges::minmax_element(values);
        low = *least;
        high = *most;
    }
    const ColourMap diverging = isDark(palette()) ? ColourMap::DivergingOnDark : ColourMap::DivergingOnLight;
    switch (quantity_) {
    case Quantity::Pressure:
        look.title = tr("Pressure above ambient");
        look.scale = logarithmicPressure_ ? ColourScale::aboutZeroLogarithmic(diverging, low, high, nearAmbient)
                                          : ColourScale::aboutZero(diverging, low, high);
        break;
    case Quantity::Gap:
        look.title = tr("Gap");
        // Bright is near the disk, as in the recess. In contact there is no logarithm.
        look.scale = logarithmicGap_ && low > 0.0 ? ColourScale::logarithmic(ColourMap::Viridis, low, high).reversed()
                                                            : ColourScale::linear(ColourMap::Viridis, low, high).reversed();
        break;
    case Quantity::Recess:
        look.title = tr("Recess");
        look.scale = ColourScale::linear(ColourMap::Mako, low, high).reversed();
        break;
    }
    return look;
}

void MapsView::setSectionPoint(const SurfacePoint& point, bool pinned)
{
    pinned_ = pinned;
    sectionPoint_ = point;
    map_->setSectionPoint(point);
    sections_->show(*map_, point);
}

void MapsView::moveSection(int cellsX, int cellsY)
{
    if (!sectionPoint_ || map_->empty()) return;
    const auto cell = map_->cellAt(*sectionPoint_);
    if (!cell) return;
    const CellGrid& grid = map_->grid();
    const int i = std::clamp(static_cast<int>(*cell % static_cast<std::size_t>(grid.nx())) + cellsX, 0, grid.nx() - 1);
    const int j = std::clamp(static_cast<int>(*cell / static_cast<std::size_t>(grid.nx())) + cellsY, 0, grid.ny() - 1);
    setSectionPoint({grid.centreX(i), grid.centreY(j)}, true);
}

void MapsView::keyPressEvent(QKeyEvent* event)
{
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    switch (event->key()) {
    case Qt::Key_Escape: pinned_ = false; return;
    case Qt::Key_Left: if (shift) return moveSection(-1, 0); break;
    case Qt::Key_Right: if (shift) return moveSection(1, 0); break;
    case Qt::Key_Up: if (shift) return moveSection(0, 1); break;
    case Qt::Key_Down: if (shift) return moveSection(0, -1); break;
    default: break;
    }
    QWidget::keyPressEvent(event);
}

void MapsView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showField();
}

} // namespace touchdown
