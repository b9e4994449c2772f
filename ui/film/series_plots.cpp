// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_plots.h"

#include <algorithm>
#include <cmath>

#include <QVBoxLayout>

#include "core/formats/units.h"
#include "ui/film/series_points.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

struct Shown {
    const char* unit;
    double (*value)(const SteadyResult&);
    double (*error)(const SteadyResult&); // of the grid; NaN where it is not stated
};

const std::array<Shown, 5> shownQuantities{
    {{"nm", [](const SteadyResult& r) { return r.minimumSpacing; },
      [](const SteadyResult& r) { return r.discretisationError.minimumSpacing; }},
     {"nm", [](const SteadyResult& r) { return r.attitude.height; },
      [](const SteadyResult&) { return DiscretisationError::unknown; }},
     {"urad", [](const SteadyResult& r) { return r.attitude.pitch; },
      [](const SteadyResult& r) { return r.discretisationError.pitch; }},
     {"urad", [](const SteadyResult& r) { return r.attitude.roll; },
      [](const SteadyResult& r) { return r.discretisationError.roll; }},
     {"mN", [](const SteadyResult& r) { return r.forces.net; },
      [](const SteadyResult& r) { return r.discretisationError.load; }}}};

constexpr std::size_t heightPlot = 1, netForce = 4;
constexpr int dotted = 2;

} // namespace

SeriesPlots::SeriesPlots(QWidget* parent) : QWidget(parent), group_(new PlotGroup(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    const std::array titles{tr("Minimum spacing"), tr("Nominal trailing edge height"), tr("Pitch"), tr("Roll")};
    for (std::size_t i = 0; i < plots_.size(); ++i) {
        plots_[i] = new PlotWidget(this);
        plots_[i]->setXNumbersVisible(i + 1 == plots_.size());
        plots_[i]->setTitle(titles[i]);
        plots_[i]->setAccessibleName(tr("Plot over the series: %1").arg(titles[i]));
        plots_[i]->setCursorPinned(true);
        group_->add(plots_[i]);
        layout->addWidget(plots_[i], i + 1 == plots_.size() ? 5 : 4); // the lowest has the numbers
    }
    setHeld(false);
}

SeriesPlots::~SeriesPlots() { clear(); }

void SeriesPlots::setHeld(bool held)
{
    held_ = held;
    plots_[heightPlot]->setTitle(held ? tr("Net force") : tr("Nominal trailing edge height"));
    for (std::size_t i = 0; i < plots_.size(); ++i) {
        const char* unit = shownQuantities[held && i == heightPlot ? netForce : i].unit;
        plots_[i]->setYLabel({{}, unitText(unit), unitFactor(unit), AxisScale::Linear});
    }
}

void SeriesPlots::clear()
{
    for (PlotWidget* plot : plots_) {
        plot->clearCurves();
        plot->setShadedAreas({});
    }
    data_.clear();
}

void SeriesPlots::setStates(const std::vector<SteadySeriesPoint>& points, const std::vector<SeriesState>& states)
{
    clear();
    points_ = points;
    const Varied axis = axisOf(points);
    const Quantity quantity = quantityOf(axis);
    for (PlotWidget* plot : plots_)
        plot->setXLabel({QString::fromStdString(quantity.longName), unitText(quantity.displayUnit),
                         unitFactor(quantity.displayUnit), AxisScale::Linear});
    QStringList names, ofStates;
    for (const SteadySeriesPoint& point : points)
        if (const QString name = curveName(point, points); !names.contains(name)) names << name;
    for (const SeriesState& state : states) ofStates << curveName(state.point, points);
    for (int curve = 0; curve < names.size(); ++curve) {
        std::vector<const SeriesState*> own;
        for (std::size_t i = 0; i < states.size(); ++i)
            if (ofStates[static_cast<qsizetype>(i)] == names[curve]) own.push_back(&states[i]);
        std::ranges::stable_sort(own, {}, [axis](const SeriesState* state) { return valueOf(state->point, axis); });
        for (std::size_t plot = 0; plot < plots_.size(); ++plot) addCurve(plot, curve, names[curve], own);
    }
    group_->dataChanged();
}

void SeriesPlots::addCurve(std::size_t plot, int curve, const QString& name,
                           const std::vector<const SeriesState*>& states)
{
    const Shown& shown = shownQuantities[held_ && plot == heightPlot ? netForce : plot];
    const Varied axis = axisOf(points_);
    std::vector<ShadedArea> areas = plots_[plot]->shadedAreas();
    std::vector<double> x, y;
    std::vector<std::array<double, 3>> band; // x, value, error
    PlotCurve piece;
    piece.name = name;
    piece.style = {curve, 0};
    piece.dots = true;
    int pieces = 0;
    const auto endBand = [&] {
        piece.id = QStringLiteral("%1/%2").arg(curve).arg(++pieces);
        addBand(plots_[plot], piece, band, areas);
        band.clear();
    };
    const auto endPiece = [&] {
        endBand();
        piece.data = keep(x, y);
        if (!x.empty()) plots_[plot]->addCurve(piece);
        x.clear();
        y.clear();
    };
    for (const SeriesState* state : states) {
        if (state->result.status != SteadyStatus::Converged) {
            endPiece();
            continue;
        }
        x.push_back(valueOf(state->point, axis));
        y.push_back(shown.value(state->result));
        const double error = shown.error(state->result);
        if (std::isfinite(error))
            band.push_back({x.back(), y.back(), std::abs(error)});
        else
            endBand();
    }
    endPiece();
    plots_[plot]->setShadedAreas(std::move(areas));
}

/// Its borders are curves, so that the automatic range of the axis contains them. The legend names the band of a curve
/// that is alone.
void SeriesPlots::addBand(PlotWidget* plot, const PlotCurve& curve, const std::vector<std::array<double, 3>>& piece,
                          std::vector<ShadedArea>& areas)
{
    if (piece.empty()) return;
    ShadedArea area{{}, {}, curve.style};
    std::vector<double> x, upper, lower;
    for (const auto& [at, value, error] : piece) {
        x.push_back(at);
        upper.push_back(value + error);
        lower.push_back(value - error);
        area.outline.emplace_back(at, upper.back());
    }
    for (std::size_t i = piece.size(); i-- > 0;) area.outline.emplace_back(x[i], lower[i]);
    areas.push_back(std::move(area));
    PlotCurve border;
    border.name = (curve.name + tr(" ± estimated error of the grid")).trimmed();
    border.style = {curve.style.colour, dotted};
    border.inLegend = curve.name.isEmpty();
    for (const auto& [end, values] : {std::pair("/upper", &upper), std::pair("/lower", &lower)}) {
        border.id = curve.id + QLatin1String(end);
        border.data = keep(x, *values);
        plot->addCurve(border);
    }
}

const MinMaxPyramid* SeriesPlots::keep(const std::vector<double>& x, const std::vector<double>& y)
{
    data_.push_back(std::make_unique<MinMaxPyramid>());
    data_.back()->append(x, y);
    return data_.back().get();
}

void SeriesPlots::point(const SteadySeriesPoint& at)
{
    if (!points_.empty()) group_->setCursor(0, valueOf(at, axisOf(points_)));
}

} // namespace touchdown
