// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace touchdown {

namespace {

constexpr PlotRange nearArea{-0.5, 1.5};
constexpr double wideCurve = 2.0;     // [px]
constexpr qsizetype mostAtOnce = 32;  // points of a line that are drawn in one go
constexpr double longestWide = 50.0;  // a longer line is one pixel wide: ten times as fast [widths of the plot area]
constexpr double longestDashed = 8.0; // a longer line is drawn solid [widths of the plot area]

/// Inside the band low <= coordinate <= high the line stays what it is; what lies outside moves onto the border of
/// the band.
std::vector<QPointF> cutToBand(const std::vector<QPointF>& path, const PlotRange& band, double (*coordinate)(QPointF),
                               QPointF (*with)(QPointF, double))
{
    std::vector<QPointF> cut;
    cut.reserve(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double here = coordinate(path[i]);
        if (i > 0) {
            const double before = coordinate(path[i - 1]);
            const auto cross = [&](double border) {
                if ((before < border) == (here < border)) return;
                const double part = (border - before) / (here - before);
                cut.push_back(with(path[i - 1] + part * (path[i] - path[i - 1]), border));
            };
            cross(before < here ? band.low : band.high);
            cross(before < here ? band.high : band.low);
        }
        cut.push_back(with(path[i], std::clamp(here, band.low, band.high)));
    }
    return cut;
}

std::vector<QPointF> cutNearArea(const std::vector<QPointF>& path)
{
    const auto outside = [](const QPointF& p) { return !nearArea.contains(p.x()) || !nearArea.contains(p.y()); };
    if (std::ranges::none_of(path, outside)) return path;
    const auto inX = cutToBand(
        path, nearArea, [](QPointF p) { return p.x(); }, [](QPointF p, double x) { return QPointF(x, p.y()); });
    return cutToBand(
        inX, nearArea, [](QPointF p) { return p.y(); }, [](QPointF p, double y) { return QPointF(p.x(), y); });
}

/// The part [first, second] of the segment a to b within 0 <= x, y <= 1 (Liang and Barsky 1984); first > second if
/// none.
std::pair<double, double> partInside(const QPointF& a, const QPointF& b)
{
    double first = 0.0;
    double second = 1.0;
    const auto border = [&](double start, double step) { // 0 <= start + part * step
        if (step == 0.0) {
            if (start < 0.0) first = 2.0;
        } else if (step > 0.0) {
            first = std::max(first, -start / step);
        } else {
            second = std::min(second, -start / step);
        }
    };
    border(a.x(), b.x() - a.x());
    border(1.0 - a.x(), a.x() - b.x());
    border(a.y(), b.y() - a.y());
    border(1.0 - a.y(), a.y() - b.y());
    return {first, second};
}

/// Where the line runs up and down within a pixel, each pair begins with the value nearer to where the line is: the
/// same ink with half the length to draw. Nothing moves by more than half a pixel.
void shortenFolds(std::vector<QPointF>& path, double pixel)
{
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        QPointF& first = path[i];
        QPointF& second = path[i + 1];
        if (second.x() - first.x() > 0.5 * pixel) continue;
        const double from = path[i - 1].y();
        if (std::abs(second.y() - from) < std::abs(first.y() - from)) std::swap(first.ry(), second.ry());
        ++i;
    }
}

constexpr QPointF liftedPen{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

bool isLifted(const QPointF& point) { return std::isnan(point.x()); }

/// The pixels of the area through which lines have passed.
class CoveredPixels {
public:
    CoveredPixels(const QSizeF& pixels, std::size_t mostFollowed)
        : width_(std::max(1, static_cast<int>(std::ceil(pixels.width())))),
          height_(std::max(1, static_cast<int>(std::ceil(pixels.height())))),
          left_(mostFollowed),
          covered_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0)
    {}

    /// Passes from `a` to `b`, both inside the area (0 to 1); whether a pixel there is new.
    bool cover(const QPointF& a, const QPointF& b)
    {
        const QPointF from(a.x() * width_, a.y() * height_);
        const QPointF step = QPointF(b.x() * width_, b.y() * height_) - from;
        const double length = std::ceil(std::max(std::abs(step.x()), std::abs(step.y())));
        const std::size_t count = left_ > 0 ? std::max<std::size_t>(1, static_cast<std::size_t>(length)) : 1;
        const auto pixel = [&](std::size_t k) -> std::uint8_t& {
            const QPointF at = from + static_cast<double>(k) / static_cast<double>(count) * step;
            const int column = std::clamp(static_cast<int>(at.x()), 0, width_ - 1);
            const int row = std::clamp(static_cast<int>(at.y()), 0, height_ - 1);
            return covered_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                            static_cast<std::size_t>(column)];
        };
        std::size_t k = 0;
        while (k <= count && pixel(k) != 0) ++k;
        const bool isNew = k <= count;
        for (; k <= count; ++k) pixel(k) = 1;
        left_ -= std::min(left_, count);
        return isNew;
    }

private:
    int width_, height_;
    std::size_t left_; // pixels to be followed
    std::vector<std::uint8_t> covered_;
};

} // namespace

std::vector<QPointF> timePath(const MinMaxPyramid& data, const PlotAxis& x, const PlotAxis& y, int pixels, bool* waits)
{
    std::vector<QPointF> path = data.thinned(x.range().low, x.range().high, pixels, x.label.scale, waits);
    for (QPointF& point : path) point = {x.position(point.x()), y.position(point.y())};
    if (path.size() > static_cast<std::size_t>(pixels)) shortenFolds(path, 1.0 / pixels);
    return cutNearArea(path);
}

std::vector<QPointF> phasePath(const MinMaxPyramid& xData, const MinMaxPyramid& yData, const PlotRange& window,
                               const PlotAxis& x, const PlotAxis& y, const QSizeF& pixels, bool* waits,
                               std::size_t mostWhole)
{
    constexpr double apart = 0.7; // [px]

    const auto [begin, end] = yData.samplesWithin(window.low, window.high);
    if (waits != nullptr) {
        const bool times = yData.times()->column().atHand(begin, end);
        const bool up = yData.values().atHand(begin, end), across = xData.values().atHand(begin, end);
        if (!times || !up || !across) {
            *waits = true;
            return {};
        }
    }
    std::vector<QPointF> path;
    QPointF last(-1e9, -1e9);
    for (std::size_t i = begin; i < end; ++i) {
        const double time = yData.time(i);
        const bool together = i < xData.size() && xData.time(i) == time;
        const std::optional<double> across = together ? xData.value(i) : xData.valueAt(time);
        if (!across) continue;
        const QPointF point(x.position(*across), y.position(yData.value(i)));
        const double dx = (point.x() - last.x()) * pixels.width();
        const double dy = (point.y() - last.y()) * pixels.height();
        if (dx * dx + dy * dy < apart * apart) continue;
        path.push_back(point);
        last = point;
    }
    path = cutNearArea(path);
    return path.size() > mostWhole ? withoutCovered(path, pixels) : path;
}

std::vector<QPointF> withoutCovered(const std::vector<QPointF>& path, const QSizeF& pixels, std::size_t mostFollowed)
{
    CoveredPixels covered(pixels, mostFollowed);
    std::vector<QPointF> kept;
    bool follows = false;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto [first, second] = partInside(path[i - 1], path[i]);
        const QPointF step = path[i] - path[i - 1];
        if (first > second || !covered.cover(path[i - 1] + first * step, path[i - 1] + second * step)) {
            follows = false;
            continue;
        }
        if (!follows) {
            if (!kept.empty()) kept.push_back(liftedPen);
            kept.push_back(path[i - 1]);
        }
        kept.push_back(path[i]);
        follows = true;
    }
    return kept;
}

std::vector<QPolygonF> insideArea(const std::vector<QPointF>& path)
{
    std::vector<QPolygonF> pieces;
    bool continues = false;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const bool lifted = isLifted(path[i - 1]) || isLifted(path[i]);
        const auto [first, second] = lifted ? std::pair(1.0, 0.0) : partInside(path[i - 1], path[i]);
        if (first > second) {
            continues = false;
            continue;
        }
        const QPointF step = path[i] - path[i - 1];
        if (!continues || first > 0.0) pieces.emplace_back().append(path[i - 1] + first * step);
        pieces.back().append(path[i - 1] + second * step);
        continues = second >= 1.0;
    }
    return pieces;
}

std::vector<PathArrow> pathArrows(const std::vector<QPointF>& path, const QSizeF& pixels)
{
    // Uneven, so that the heads of a way there and those of the same way back do not meet.
    static constexpr double places[] = {0.08, 0.24, 0.40, 0.54, 0.70, 0.86};
    const double length = pathLength(path, pixels);
    std::vector<PathArrow> arrows;
    if (length < 60.0 || length > longestDashed * pixels.width()) return arrows;
    double walked = 0.0;
    std::size_t next = 0;
    for (std::size_t i = 1; i < path.size() && next < std::size(places); ++i) {
        const QPointF step = path[i] - path[i - 1];
        const QPointF inPixels(step.x() * pixels.width(), step.y() * pixels.height());
        const double stride = std::hypot(inPixels.x(), inPixels.y());
        for (; next < std::size(places) && stride > 0.0 && walked + stride >= places[next] * length; ++next) {
            const QPointF tip = path[i - 1] + (places[next] * length - walked) / stride * step;
            if (QRectF(0.0, 0.0, 1.0, 1.0).contains(tip)) arrows.push_back({tip, inPixels / stride});
        }
        walked += stride;
    }
    return arrows;
}

QPen penThereAndBack(const std::vector<QPointF>& path, const QSizeF& pixels, QPen pen)
{
    QList<qreal> dashes = pen.dashPattern();
    if (path.empty() || dashes.isEmpty()) return pen;
    const auto turn = std::ranges::max_element(
        path, {}, [&path](const QPointF& point) { return std::abs(point.x() - path.front().x()); });
    const double walked = pathLength({path.begin(), turn + 1}, pixels) / pen.widthF();
    const double half = 0.5 * pathLength(path, pixels) / pen.widthF();
    // A pattern that is even about the middle of a dash is even about the turning point, and half the length, when both
    // lie in the middle of a dash or of a gap: the latter by a slight change of its period.
    const double period = std::accumulate(dashes.begin(), dashes.end(), 0.0);
    const double count = std::round(std::abs(half - walked) / (0.5 * period));
    const double scale = count > 0.0 ? std::abs(half - walked) / (0.5 * period * count) : 1.0;
    for (qreal& dash : dashes) dash *= scale;
    pen.setDashPattern(dashes);
    const double offset = 0.5 * dashes.front() - std::fmod(walked, scale * period);
    pen.setDashOffset(offset < 0.0 ? offset + scale * period : offset);
    return pen;
}

QPen pathPen(const PlotCurve& curve, const std::vector<QPointF>& path, const QSizeF& pixels, const PlotTheme& theme,
             bool wide)
{
    if (curve.pale) return palePen(curve.style, theme);
    const double length = pathLength(path, pixels);
    const bool dashed = length < longestDashed * pixels.width();
    QPen pen = curvePen(curve.style, theme, dashed);
    if (wide) pen.setWidthF(wideCurve);
    if (curve.xData != nullptr && length > longestWide * pixels.width()) pen.setWidthF(1.0);
    return curve.xData != nullptr ? penThereAndBack(path, pixels, pen) : pen;
}

std::vector<QPointF> withoutStraightPoints(const std::vector<QPointF>& path, const QSizeF& pixels)
{
    // From each point that is kept, all slopes that pass every later point within the tolerance.
    const double tolerance = 0.1 / std::max(1.0, pixels.height());
    std::vector<QPointF> kept;
    if (path.empty()) return kept;
    kept.push_back(path.front());
    double low = -HUGE_VAL, high = HUGE_VAL;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto slope = [&](double above) { // to the point, from the last one kept
            return (path[i].y() + above - kept.back().y()) / (path[i].x() - kept.back().x());
        };
        const bool along = path[i].x() > kept.back().x() && slope(0.0) >= low && slope(0.0) <= high;
        if (!along) {
            if (i > 1 && kept.back() != path[i - 1]) kept.push_back(path[i - 1]);
            low = -HUGE_VAL;
            high = HUGE_VAL;
        }
        if (path[i].x() > kept.back().x()) {
            low = std::max(low, slope(-tolerance));
            high = std::min(high, slope(tolerance));
        } else {
            kept.push_back(path[i]);
            low = -HUGE_VAL;
            high = HUGE_VAL;
        }
    }
    if (kept.back() != path.back()) kept.push_back(path.back());
    return kept;
}

void drawPath(QPainter& painter, const std::vector<QPointF>& path, const QRectF& area)
{
    for (QPolygonF piece : insideArea(path)) {
        for (QPointF& point : piece)
            point = {area.left() + point.x() * area.width(), area.bottom() - point.y() * area.height()};
        // A line that crosses itself costs by the square of its length; dashes need the whole of it.
        const qsizetype most = painter.pen().style() == Qt::SolidLine ? mostAtOnce : piece.size();
        for (qsizetype first = 0; first + 1 < piece.size(); first += most - 1)
            painter.drawPolyline(piece.constData() + first, static_cast<int>(std::min(most, piece.size() - first)));
    }
}

void drawArrows(QPainter& painter, const std::vector<QPointF>& path, const QRectF& area, const QColor& colour)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (const PathArrow& arrow : pathArrows(path, area.size())) {
        const QPointF along(arrow.along.x(), -arrow.along.y());
        const QPointF side(-along.y(), along.x());
        const QPointF tip(area.left() + arrow.tip.x() * area.width() + 4.5 * along.x(),
                          area.bottom() - arrow.tip.y() * area.height() + 4.5 * along.y());
        painter.drawPolygon(QPolygonF({tip, tip - 9.0 * along + 4.0 * side, tip - 9.0 * along - 4.0 * side}));
    }
    painter.setBrush(Qt::NoBrush);
}

double pathLength(const std::vector<QPointF>& path, const QSizeF& pixels)
{
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (isLifted(path[i - 1]) || isLifted(path[i])) continue;
        const QPointF step = path[i] - path[i - 1];
        length += std::hypot(step.x() * pixels.width(), step.y() * pixels.height());
    }
    return length;
}

} // namespace touchdown
