// SPDX-License-Identifier: GPL-3.0-or-later
//
// What has a label in a plot: shaded areas, reference lines and point marks.
#include "ui/plot/plot_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <QFontMetricsF>

namespace touchdown {

namespace {

/// Labels that touch each other.
struct Block {
    double sum = 0.0; // of their wanted places, each as if it were the first label of the row
    std::size_t count = 0;
    double mean() const { return sum / static_cast<double>(count); }
};

/// Those that have room together, by their numbers.
std::vector<std::size_t> withRoom(const std::vector<WantedPlace>& wanted, double room)
{
    std::vector<std::size_t> kept(wanted.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = i;
    double used = 0.0;
    for (const WantedPlace& each : wanted) used += each.size;
    while (used > room && !kept.empty()) {
        std::size_t nearest = kept.size() - 1; // to the one before it
        for (std::size_t k = 1; k < kept.size(); ++k) {
            const auto distance = [&](std::size_t i) { return wanted[kept[i]].at - wanted[kept[i - 1]].at; };
            if (nearest == 0 || distance(k) < distance(nearest)) nearest = k;
        }
        used -= wanted[kept[nearest]].size;
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(nearest));
    }
    return kept;
}

} // namespace

std::vector<std::optional<double>> labelPlaces(const std::vector<WantedPlace>& wanted, double low, double high)
{
    const std::vector<std::size_t> kept = withRoom(wanted, high - low);
    std::vector<double> before; // from the beginning of the row to the centre of a label, if all touch each other
    double used = 0.0;
    std::vector<Block> blocks;
    for (const std::size_t i : kept) {
        before.push_back(used + wanted[i].size / 2.0);
        used += wanted[i].size;
        blocks.push_back({wanted[i].at - before.back(), 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
            blocks[blocks.size() - 2].sum += blocks.back().sum;
            blocks[blocks.size() - 2].count += blocks.back().count;
            blocks.pop_back();
        }
    }
    std::vector<std::optional<double>> places(wanted.size());
    std::size_t k = 0;
    for (const Block& block : blocks)
        for (std::size_t each = 0; each < block.count; ++each, ++k)
            places[kept[k]] = before[k] + std::clamp(block.mean(), low, std::max(low, high - used));
    return places;
}

bool PlotPainter::isSeen(const ReferenceLine& line) const
{
    return (line.upright ? x_ : y_).range().contains(line.value);
}

void PlotPainter::paintReferenceLines(QPainter& painter) const
{
    QPen pen(theme_.referenceLine, 1.0);
    pen.setDashPattern({4.0, 4.0});
    painter.setPen(pen);
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (!isSeen(line)) continue;
        const double y = alignedPixel(frame_.up(y_.position(line.value)));
        const double x = alignedPixel(frame_.across(x_.position(line.value)));
        if (line.upright)
            painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
        else
            painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
}

/// Level lines have them at the right from top to bottom, upright ones above from left to right.
std::vector<PlotLabel> PlotPainter::labelsOfLines(bool upright) const
{
    struct Labelled {
        double at; // [px]
        const ReferenceLine* line;
    };
    std::vector<Labelled> lines;
    for (const ReferenceLine& line : plot_.referenceLines())
        if (line.upright == upright && !line.label.isEmpty() && isSeen(line))
            lines.push_back(
                {upright ? frame_.across(x_.position(line.value)) : frame_.up(y_.position(line.value)), &line});
    std::ranges::stable_sort(lines, {}, &Labelled::at);

    const double room = upright ? width_ - PlotFrame::gap : width_ - area_.right() - PlotFrame::leader - 2.0;
    const QFontMetricsF usual(frame_.numberFont);
    double needed = 0.0; // of the widest at the right, of all above
    for (const auto& [at, line] : lines) {
        const double width = usual.horizontalAdvance(line->label) + aroundLabel;
        needed = upright ? needed + width + PlotFrame::gap : std::max(needed, width);
    }
    QFont font = frame_.numberFont;
    if (needed > room && !paper_)
        font.setPixelSize(static_cast<int>(font.pixelSize() * std::max(PlotFrame::leastTitle, room / needed)));
    const QFontMetricsF metrics(font);
    const double height = metrics.height();
    std::vector<PlotLabel> labels;
    std::vector<WantedPlace> wanted;
    for (const auto& [at, line] : lines) {
        const QString text = metrics.elidedText(line->label, Qt::ElideMiddle, room - aroundLabel);
        const QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + aroundLabel, height);
        labels.push_back({box, text, theme_.mutedText, false, font, line->label});
        wanted.push_back({at, upright ? box.width() + PlotFrame::gap : height});
    }
    const auto places =
        upright ? labelPlaces(wanted, PlotFrame::gap, width_) : labelPlaces(wanted, area_.top(), area_.bottom());
    std::vector<PlotLabel> placed;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!places[i]) continue;
        PlotLabel& label = placed.emplace_back(labels[i]);
        if (upright)
            label.box.moveCenter({*places[i], area_.top() - PlotFrame::leader - height / 2.0});
        else
            label.box.moveTopLeft({area_.right() + PlotFrame::leader, *places[i] - height / 2.0});
        if (std::abs(*places[i] - wanted[i].at) <= 1.0) continue;
        label.leader = upright ? QLineF(wanted[i].at, area_.top(), *places[i], label.box.bottom())
                               : QLineF(area_.right(), wanted[i].at, label.box.left(), *places[i]);
    }
    return placed;
}

std::size_t PlotPainter::labelsWithoutRoom() const
{
    const std::vector<PlotLabel> shown = labels();
    const auto whole = std::ranges::count_if(
        shown, [](const PlotLabel& each) { return !each.line.isEmpty() && each.text == each.line; });
    const auto wanted = std::ranges::count_if(
        plot_.referenceLines(), [this](const ReferenceLine& line) { return !line.label.isEmpty() && isSeen(line); });
    return static_cast<std::size_t>(wanted - whole);
}

/// The marks whose point is inside the area; QRectF contains what is not finite, too.
std::vector<PlotPainter::PlacedMark> PlotPainter::placeMarks() const
{
    std::vector<PlacedMark> placed;
    for (const PointMark& mark : plot_.pointMarks()) {
        const QPointF at(frame_.across(x_.position(mark.x)), frame_.up(y_.position(mark.y)));
        if (std::isfinite(at.x()) && std::isfinite(at.y()) && area_.contains(at))
            placed.push_back({&mark, at - QPointF(0.0, 3.0)});
    }
    return placed;
}

std::vector<QRectF> PlotPainter::pointers() const
{
    std::vector<QRectF> boxes;
    for (const auto& [mark, tip] : placeMarks()) boxes.emplace_back(tip - QPointF(4.0, 6.0), QSizeF(8.0, 6.0));
    return boxes;
}

std::vector<PlotLabel> PlotPainter::labels() const
{
    std::vector<PlotLabel> labels;
    std::vector<QRectF> taken = pointers();
    const QFontMetricsF metrics(frame_.numberFont);
    const auto sizeOf = [&](const QString& text) {
        return QSizeF(metrics.horizontalAdvance(text) + aroundLabel, metrics.height());
    };
    const auto meets = [&taken](const QRectF& box) {
        return std::ranges::find_if(taken, [&box](const QRectF& other) { return other.intersects(box); });
    };
    const auto add = [&](const QRectF& box, const QString& text, const QColor& colour, bool behind = false) {
        taken.push_back(box);
        labels.push_back({box, text, colour, behind, frame_.numberFont});
    };

    for (const ShadedArea& shaded : plot_.shadedAreas()) {
        if (shaded.label.isEmpty()) continue;
        QRectF box(QPointF(), sizeOf(shaded.label));
        const QPointF centre = outlineOf(shaded).boundingRect().center();
        for (const double higher : {0.0, box.height(), -box.height()}) {
            box.moveCenter(centre - QPointF(0.0, higher));
            if (!area_.contains(box) || meets(box) != taken.end()) continue;
            add(box, shaded.label, theme_.text, true);
            break;
        }
    }
    for (const auto& [mark, tip] : placeMarks()) {
        const QSizeF size = sizeOf(mark->label);
        // The highest point may have no room above it: its label stands beside it, below the plot's upper edge.
        const double beside = std::max(tip.y() - size.height(), area_.top());
        const QPointF corners[] = {tip - QPointF(size.width() / 2.0, 7.0 + size.height()),
                                   {tip.x() + 6.0, beside},
                                   {tip.x() - 6.0 - size.width(), beside}};
        for (const QPointF& corner : corners) {
            const QRectF box(corner, size);
            if (!area_.contains(box) || meets(box) != taken.end()) continue;
            add(box, mark->label, theme_.text);
            break; // without room anywhere the marker stands alone
        }
    }
    for (const bool upright : {false, true})
        for (const PlotLabel& label : labelsOfLines(upright)) labels.push_back(label);
    return labels;
}

void PlotPainter::paintPointers(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (const auto& [mark, tip] : placeMarks()) {
        painter.setBrush(theme_.colour(mark->style));
        painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4.0, -6.0), tip + QPointF(4.0, -6.0)}));
    }
    painter.setBrush(Qt::NoBrush);
}

void PlotPainter::paintLabels(QPainter& painter, bool behind) const
{
    QColor paper = theme_.plotArea;
    paper.setAlphaF(0.75F);
    for (const auto& [box, text, colour, isBehind, font, line, leader] : labels()) {
        if (isBehind != behind) continue;
        if (line.isEmpty()) painter.fillRect(box, paper);
        painter.setPen(QPen(theme_.referenceLine, 1.0));
        if (!leader.isNull()) painter.drawLine(leader);
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

} // namespace touchdown
