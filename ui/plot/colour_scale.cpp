// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <QFontMetricsF>
#include <QImage>
#include <QLocale>

#include "ui/plot/plot_frame.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

// Ten of the 256 published colours; a straight line between them stays within 3 of 255 of the rest.
constexpr std::array<QRgb, 10> viridis{0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e,
                                       0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c, 0xfde725};
constexpr std::array<QRgb, 8> mako{0x3a2c59, 0x40498e, 0x366a9f, 0x348aa6, 0x38aaac, 0x54c9ad, 0xa0dfb9, 0xdef5e5};

constexpr double barWidth = 16.0; // [px]
constexpr double indent = 8.0;    // of the bar from the left of its column [px]
constexpr int barSteps = 256;     // of colour along the bar

QColor between(std::span<const QRgb> anchors, double position)
{
    const double at = position * static_cast<double>(anchors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), anchors.size() - 2);
    const double part = at - static_cast<double>(below);
    const auto blend = [part](int from, int to) { return static_cast<int>(std::lround(from + part * (to - from))); };
    const QRgb a = anchors[below];
    const QRgb b = anchors[below + 1];
    return {blend(qRed(a), qRed(b)), blend(qGreen(a), qGreen(b)), blend(qBlue(a), qBlue(b))};
}

/// Oklab (L, chroma, hue) to sRGB: B. Ottosson, "A perceptual color space for image processing", 2020.
QColor oklch(double lightness, double chroma, double hue)
{
    const double a = chroma * std::cos(hue);
    const double b = chroma * std::sin(hue);
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    const auto channel = [](double linear) {
        const double c = std::clamp(linear, 0.0, 1.0);
        return static_cast<float>(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055);
    };
    return QColor::fromRgbF(channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                            channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                            channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

QColor diverging(double position, bool onDark)
{
    constexpr double blue = 255.0 * std::numbers::pi / 180.0;
    constexpr double orange = 52.0 * std::numbers::pi / 180.0;
    const double away = std::abs(2.0 * position - 1.0);
    const double centre = onDark ? 0.27 : 0.96;
    const double end = onDark ? 0.82 : 0.42;
    return oklch(centre + away * (end - centre), 0.125 * away, position < 0.5 ? blue : orange);
}

} // namespace

QColor mapColour(ColourMap map, double position)
{
    const double at = std::clamp(position, 0.0, 1.0);
    switch (map) {
    case ColourMap::Viridis: return between(viridis, at);
    case ColourMap::Mako: return between(mako, at);
    case ColourMap::DivergingOnLight: return diverging(at, false);
    case ColourMap::DivergingOnDark: return diverging(at, true);
    }
    return {};
}

ColourScale::ColourScale(Kind kind, ColourMap map, std::vector<double> knots)
    : kind_(kind), map_(map), knots_(std::move(knots))
{
    for (std::size_t i = 0; i < colours_.size(); ++i)
        colours_[i] = mapColour(map, static_cast<double>(i) / static_cast<double>(colours_.size() - 1)).rgb();
}

ColourScale ColourScale::linear(ColourMap map, double low, double high)
{
    // A field that is the same all over still has a scale.
    return {Kind::Linear, map, {low, high > low ? high : low + std::max(std::abs(low), 1e-30)}};
}

ColourScale ColourScale::logarithmic(ColourMap map, double low, double high)
{
    return {Kind::Logarithmic, map, {low, high > low ? high : 10.0 * low}};
}

ColourScale ColourScale::aboutZero(ColourMap map, double low, double high)
{
    // A side without values is given the other's width: its colours are not used, but the bar stays readable.
    const double width = std::max({-low, high, 1e-30});
    return {Kind::AboutZero, map, {low < 0.0 ? low : -width, 0.0, high > 0.0 ? high : width}};
}

ColourScale ColourScale::aboutZeroLogarithmic(ColourMap map, double low, double high, double near)
{
    ColourScale scale = aboutZero(map, low, high);
    scale.kind_ = Kind::AboutZeroLogarithmic;
    scale.near_ = near;
    return scale;
}

ColourScale ColourScale::throughLevels(ColourMap map, std::vector<double> levels)
{
    if (levels.size() == 1) levels.push_back(levels.front() + std::max(std::abs(levels.front()), 1e-30));
    return {Kind::Levels, map, std::move(levels)};
}

ColourScale ColourScale::reversed() const
{
    ColourScale scale = *this;
    std::ranges::reverse(scale.colours_);
    scale.reversed_ = !reversed_;
    return scale;
}

ColourScale ColourScale::onPaper() const
{
    if (map_ != ColourMap::DivergingOnDark) return *this;
    ColourScale scale(kind_, ColourMap::DivergingOnLight, knots_);
    scale.near_ = near_;
    return reversed_ ? scale.reversed() : scale;
}

double ColourScale::position(double value) const
{
    if (!(value > knots_.front())) return 0.0;
    if (value >= knots_.back()) return 1.0;
    if (isLogarithmic()) return std::log(value / knots_[0]) / std::log(knots_[1] / knots_[0]);
    if (kind_ == Kind::AboutZeroLogarithmic) {
        const double end = value < 0.0 ? knots_.front() : knots_.back();
        const double part = std::log1p(std::abs(value) / near_) / std::log1p(std::abs(end) / near_);
        return 0.5 + (value < 0.0 ? -0.5 : 0.5) * part;
    }
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(knots_, value) - knots_.begin());
    const double part = (value - knots_[above - 1]) / (knots_[above] - knots_[above - 1]);
    return (static_cast<double>(above - 1) + part) / static_cast<double>(knots_.size() - 1);
}

QRgb ColourScale::colourAt(double position) const
{
    return colours_[static_cast<std::size_t>(std::lround(position * static_cast<double>(colours_.size() - 1)))];
}

std::vector<ScaleTick> ColourScale::linearTicks(double from, double to, double factor, int most) const
{
    PlotAxis axis;
    axis.label = {{}, {}, factor, isLogarithmic() ? AxisScale::Logarithmic : AxisScale::Linear};
    axis.setRange({from, to});
    std::vector<ScaleTick> list;
    for (const AxisTick& tick : axis.ticks(std::max(2, most)))
        if (tick.major && tick.value >= from && tick.value <= to) list.push_back({position(tick.value), tick.text});
    return list;
}

/// Powers of ten of the unit from `near` to `end`, which is on either side of zero.
std::vector<ScaleTick> ColourScale::decadeTicks(double end, double factor) const
{
    std::vector<ScaleTick> list;
    const double sign = end < 0.0 ? -1.0 : 1.0;
    double power = std::pow(10.0, std::ceil(std::log10(near_ / factor) - 1e-9));
    for (; power * factor <= std::abs(end); power *= 10.0)
        list.push_back({position(sign * power * factor),
                        typeset(sign * power, std::max(0, static_cast<int>(-std::floor(std::log10(power) + 1e-9))))});
    return list;
}

std::vector<ScaleTick> ColourScale::ticks(double factor, int most) const
{
    std::vector<ScaleTick> list;
    const auto add = [&list](std::vector<ScaleTick> more) { list.insert(list.end(), more.begin(), more.end()); };
    switch (kind_) {
    case Kind::Linear:
    case Kind::Logarithmic: add(linearTicks(low(), high(), factor, most)); break;
    case Kind::AboutZero:
        add(linearTicks(0.0, high(), factor, most / 2));
        // The numbers of the upper half begin with the zero that both share.
        add(linearTicks(low(), -1e-9 * (high() - low()), factor, most / 2));
        break;
    case Kind::AboutZeroLogarithmic:
        list.push_back({0.5, QStringLiteral("0")});
        add(decadeTicks(high(), factor));
        add(decadeTicks(low(), factor));
        break;
    case Kind::Levels:
        for (const double level : knots_) list.push_back({position(level), QLocale().toString(level / factor, 'g', 4)});
        break;
    }
    return list;
}

double colourBarWidth(const QFont& font, const std::vector<ScaleTick>& ticks)
{
    const QFontMetricsF metrics(plotNumberFont(font));
    double widest = metrics.horizontalAdvance(QStringLiteral("00000"));
    for (const ScaleTick& tick : ticks) widest = std::max(widest, metrics.horizontalAdvance(tick.text));
    return std::ceil(indent + barWidth + PlotFrame::tickLength + 4.0 + widest);
}

int colourBarRoom(const QFont& font, double height)
{
    return static_cast<int>(height / (2.5 * QFontMetricsF(plotNumberFont(font)).height()));
}

void paintColourBar(QPainter& painter, const QRectF& column, const QFont& font, const PlotTheme& theme,
                    const ColourScale& scale, const std::vector<ScaleTick>& ticks, const QString& title, bool downwards)
{
    const QFont numberFont = plotNumberFont(font);
    const double height = QFontMetricsF(numberFont).height();
    const double top = column.top() + (title.isEmpty() ? 0.0 : height + 6.0);
    const QRectF bar(column.left() + indent, top + 0.5, barWidth, column.bottom() - top - 1.0);

    QImage colours(1, barSteps, QImage::Format_RGB32);
    for (int i = 0; i < barSteps; ++i) {
        const double position = (i + 0.5) / barSteps;
        colours.setPixel(0, i, scale.colourAt(downwards ? position : 1.0 - position));
    }
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(bar, colours);
    painter.setPen(QPen(theme.axis, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);

    painter.setFont(numberFont);
    painter.setPen(theme.mutedText);
    if (!title.isEmpty())
        painter.drawText(QRectF(column.left() + 2.0, column.top(), column.width(), height),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, title);
    for (const ScaleTick& tick : ticks) {
        const double y =
            downwards ? bar.top() + tick.position * bar.height() : bar.bottom() - tick.position * bar.height();
        painter.setPen(QPen(theme.axis, 1.0));
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + PlotFrame::tickLength, y));
        painter.setPen(theme.mutedText);
        // The numbers at the ends stay beside the bar.
        const double text = std::clamp(y, bar.top() + height / 2.0 - 2.0, bar.bottom() - height / 2.0 + 2.0);
        painter.drawText(QRectF(bar.right() + PlotFrame::tickLength + 4.0, text - height / 2.0, 200.0, height),
                         Qt::AlignLeft | Qt::AlignVCenter, tick.text);
    }
    painter.restore();
}

} // namespace touchdown
