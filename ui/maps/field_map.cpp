// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QTextStream>

#include "core/formats/units.h"
#include "ui/plot/plot_frame.h"
#include "ui/slider/attitude_sections.h"
#include "ui/slider/plan_marks.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

QString fieldText(double value, const FieldLook& look) { return fieldNumber(value, look) + QChar(0x00A0) + look.unit; }

QString fieldNumber(double value, const FieldLook& look)
{
    const double shown = value / look.factor;
    const double size = std::abs(shown);
    int decimals = size > 0.0 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 3) : 0;
    if (look.error > 0.0) decimals = std::min(decimals, decimalsOfError(look.error / look.factor));
    return typeset(shown, decimals);
}

std::optional<double> FieldAtPoints::at(const SurfacePoint& point) const
{
    constexpr double same = 1e-9; // [m]
    if (least && std::hypot(point.x - least->at.x, point.y - least->at.y) < same) return least->value;
    return value ? std::optional(value(point)) : std::nullopt;
}

FieldAtPoints gapAtPoints(const Case& c, const Recess& recess, const Attitude& attitude,
                          const MinimumSpacing::Place& least)
{
    const double length = c.slider.length, middle = 0.5 * c.slider.width;
    return {[=, a = attitude](const SurfacePoint& p) { // core/physics/slider/attitude.h
                return recess.at(p.x, p.y) + a.height + a.pitch * (length - p.x) - a.roll * (p.y - middle);
            },
            FieldAtPoints::Least{least.at, least.spacing}};
}

GapInTime::GapInTime(const Case& c)
    : case_(c), recess_(c.surface, c.slider.length, c.slider.width), spacing_(c.surface, recess_)
{}

FieldAtPoints GapInTime::at(double minimumSpacing, double pitch, double roll) const
{
    const MinimumSpacing::Place place = spacing_.at({0.0, pitch, roll});
    return gapAtPoints(case_, recess_, {minimumSpacing - place.spacing, pitch, roll}, {minimumSpacing, place.at});
}

void FieldMap::setField(const CellGrid& grid, std::vector<double> values, FieldAtPoints points)
{
    values_ = std::move(values);
    points_ = std::move(points);
    // Where many cells are at the limit, as without contact, none of them is a place to mark.
    const auto only = [this](auto extreme) -> std::optional<std::size_t> {
        if (extreme == values_.end() || std::ranges::count(values_, *extreme) != 1) return std::nullopt;
        return static_cast<std::size_t>(extreme - values_.begin());
    };
    smallest_ = only(std::ranges::min_element(values_));
    largest_ = only(std::ranges::max_element(values_));
    setGrid(grid);
}

void FieldMap::setLook(const FieldLook& look)
{
    look_ = look;
    forgetLayout();
    setTitle(look.title + look.remark);
    if (isFitted()) fit(); // the numbers of the bar may need another width
    update();
}

std::optional<std::size_t> FieldMap::cellAt(const SurfacePoint& point) const
{
    const int i = cellIndex(grid().x, point.x);
    const int j = cellIndex(grid().y, point.y);
    if (values_.empty() || i < 0 || j < 0) return std::nullopt;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid().nx()) + static_cast<std::size_t>(i);
}

std::optional<double> FieldMap::valueAt(const SurfacePoint& point) const
{
    const auto cell = cellAt(point);
    if (!cell) return std::nullopt;
    return points_.at(point).value_or(value(*cell));
}

SurfacePoint FieldMap::centre(std::size_t cell) const
{
    const auto nx = static_cast<std::size_t>(grid().nx());
    return {grid().centreX(static_cast<int>(cell % nx)), grid().centreY(static_cast<int>(cell / nx))};
}

void FieldMap::setRails(std::vector<Rail> rails)
{
    rails_ = std::move(rails);
    update();
}

void FieldMap::setCursors(const std::optional<SurfacePoint>& first, const std::optional<SurfacePoint>& second)
{
    first_ = first;
    second_ = second;
    update();
}

QStringList FieldMap::readingAt(const SurfacePoint& point) const
{
    const auto value = valueAt(point);
    return value ? QStringList{fieldText(*value, look_)} : QStringList();
}

std::vector<ScaleTick> FieldMap::keyTicks() const
{
    return look_.scale.ticks(look_.factor, colourBarRoom(font(), std::max(100.0, height() - 90.0)));
}

double FieldMap::keyWidth() const { return colourBarWidth(font(), keyTicks()) + 4.0; }

void FieldMap::paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme)
{
    if (!empty()) paintColourBar(painter, column, font(), theme, look_.scale, keyTicks(), look_.unit);
}

void FieldMap::paintContent(QPainter& painter, const PlotTheme& theme)
{
    if (empty()) return;
    paintCells(painter, *this, values_, look_.scale);
    paintGrid(painter);
    paintRails(painter, theme);
    paintCursors(painter, theme);
    paintExtremes(painter, theme);
}

/// The lines of the sections, and with cursor 2 the way to it and the number of each.
void FieldMap::paintCursors(QPainter& painter, const PlotTheme& theme) const
{
    if (!first_) return;
    const QPointF at = toPixel(*first_);
    const QPointF low = toPixel({area().left(), area().top()});
    const QPointF high = toPixel({area().right(), area().bottom()});
    QPen way(theme.text, 1.0, Qt::DashLine);
    for (const QPen& pen : {QPen(theme.background, 2.4), QPen(theme.text, 1.0)}) {
        painter.setPen(pen);
        painter.drawLine(QPointF(low.x(), at.y()), QPointF(high.x(), at.y()));
        painter.drawLine(QPointF(at.x(), low.y()), QPointF(at.x(), high.y()));
        if (!second_) continue;
        const QPointF there = toPixel(*second_);
        painter.setPen(pen.widthF() > 1.0 ? pen : way);
        painter.drawLine(at, there);
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(there, 5.0, 5.0);
    }
    if (!second_) return;
    painter.setFont(plotNumberFont(font()));
    const double side = QFontMetricsF(painter.font()).height();
    for (const auto& [point, number] : {std::pair(at, 1), std::pair(toPixel(*second_), 2)}) {
        const QRectF tag(point + QPointF(5.0, -5.0 - side), QSizeF(side, side));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.cursor);
        painter.drawRoundedRect(tag, 3.0, 3.0);
        painter.setPen(theme.background);
        painter.drawText(tag, Qt::AlignCenter, QString::number(number));
    }
    painter.setBrush(Qt::NoBrush);
}

/// Light over dark, so that they are seen on every colour.
void FieldMap::paintRails(QPainter& painter, const PlotTheme& theme) const
{
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(theme.text, 1.6), QPen(theme.background, 0.8)}) {
        painter.setPen(pen);
        for (const Rail& rail : rails_) {
            QPolygonF outline;
            for (const RailPoint& point : rail.points) outline << toPixel({point.x, point.y});
            painter.drawPolygon(outline);
        }
    }
}

std::function<void(QIODevice&)> FieldMap::dataWriter() const
{
    if (empty()) return {};
    return [this](QIODevice& device) {
        QTextStream out(&device);
        out << "x [m],y [m],\"" << look_.title << " [" << look_.unit << "]\"\n";
        for (std::size_t cell = 0; cell < values_.size(); ++cell) {
            const SurfacePoint at = centre(cell);
            out << QString::fromStdString(formatNumber(at.x)) << ',' << QString::fromStdString(formatNumber(at.y))
                << ',' << QString::fromStdString(formatNumber(values_[cell] / look_.factor)) << '\n';
        }
    };
}

void FieldMap::paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours)
{
    const auto first = std::exchange(first_, {}), second = std::exchange(second_, {});
    const ColourScale scale = std::exchange(look_.scale, look_.scale.onPaper());
    SliderPlan::paintOnPaper(painter, size, font, colours);
    look_.scale = scale;
    first_ = first;
    second_ = second;
}

std::vector<PlanMark> FieldMap::extremes() const
{
    std::vector<PlanMark> marks;
    const auto add = [&](const SurfacePoint& at, PlanMark::Kind kind, double value) {
        marks.push_back({toPixel(at), kind, fieldText(value, look_)});
    };
    if (points_.least)
        add(points_.least->at, PlanMark::Kind::Minimum, points_.least->value);
    else if (smallest_)
        add(centre(*smallest_), PlanMark::Kind::Minimum, values_[*smallest_]);
    if (largest_) add(centre(*largest_), PlanMark::Kind::Maximum, values_[*largest_]);
    return marks;
}

QStringList FieldMap::marks() const
{
    QStringList numbers;
    for (const PlanMark& mark : extremes()) numbers << mark.text;
    return numbers;
}

void FieldMap::paintExtremes(QPainter& painter, const PlotTheme& theme) const
{
    const std::vector<PlanMark> marks = extremes();
    if (marks.empty()) return;
    painter.setFont(plotNumberFont(font()));
    TakenRoom taken;
    paintPlanMarks(painter, marks, theme, taken);
}

} // namespace touchdown
