// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_theme.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <QApplication>

#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double widest = 4.0; // times the usual width of a line

QColor mixed(const QColor& a, const QColor& b, double part)
{
    const auto blend = [part](int from, int to) { return static_cast<int>(from + part * (to - from)); };
    return {blend(a.red(), b.red()), blend(a.green(), b.green()), blend(a.blue(), b.blue())};
}

PlotTheme themeFrom(const QColor& paper, const QColor& ink, const QColor& highlight)
{
    static const QList<QColor> onLight{"#0068b0", "#c95300", "#008a63", "#b3528a", "#a87400", "#3d93c9", "#3a3f45"};
    static const QList<QColor> onDark{"#4ea6e6", "#f0813f", "#2ec297", "#e08fbe", "#e9b03a", "#9ad4f7", "#e4e7ea"};
    const bool dark = paper.lightness() < 128;
    PlotTheme theme;
    theme.background = paper;
    theme.plotArea = paper;
    theme.grid = mixed(paper, ink, dark ? 0.13 : 0.10);
    theme.axis = mixed(paper, ink, 0.45);
    theme.text = mixed(paper, ink, 0.92);
    theme.mutedText = mixed(paper, ink, 0.68);
    theme.referenceLine = mixed(paper, ink, 0.58);
    theme.cursor = mixed(paper, ink, 0.72);
    theme.selection = highlight;
    theme.curves = dark ? onDark : onLight;
    return theme;
}

} // namespace

QColor PlotTheme::paleColour(const CurveStyle& style) const
{
    const QColor full = colour(style);
    // Each line of a table and of a legend asks, at each new run; contrast() takes powers.
    static thread_local std::map<std::pair<QRgb, QRgb>, QColor> known;
    const auto [entry, isNew] = known.try_emplace({plotArea.rgb(), full.rgb()}, full);
    for (double part = 0.42; isNew && entry->second == full && part < 1.0; part += 0.02)
        if (const QColor pale = mixed(plotArea, full, part); contrast(pale, plotArea) >= 3.0) entry->second = pale;
    return entry->second;
}

PlotTheme lightPlotTheme() { return themeFrom(QColor("#ffffff"), QColor("#14181c"), QColor("#2f7fd0")); }

PlotTheme plotTheme(const QPalette& palette)
{
    PlotTheme theme =
        themeFrom(palette.color(QPalette::Base), palette.color(QPalette::Text), palette.color(QPalette::Highlight));
    theme.width = std::clamp(QApplication::font().pointSizeF() / systemPointSize(), 1.0, widest);
    return theme;
}

QPen curvePen(const CurveStyle& style, const PlotTheme& theme, bool dashed)
{
    static const std::array<QList<qreal>, 4> dashes{{{}, {5.0, 3.0}, {1.2, 2.2}, {6.0, 2.5, 1.2, 2.5}}};
    QPen pen(theme.colour(style), 1.5 * theme.width);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(Qt::SquareCap); // Qt fills a single line with round ends some ten times slower
    const auto& dash = dashes[static_cast<std::size_t>(style.dash) % dashes.size()];
    if (dashed && !dash.isEmpty()) {
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern(dash);
    }
    return pen;
}

QPen palePen(const CurveStyle& style, const PlotTheme& theme)
{
    QPen pen(theme.paleColour(style), theme.width);
    pen.setJoinStyle(Qt::BevelJoin); // the cheapest, and none can be seen on a thin line
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

} // namespace touchdown
