// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/paper_curves.h"

#include <algorithm>
#include <iterator>

namespace touchdown {

namespace {

constexpr int dashesOnPaper = 4; // of curvePen()
constexpr int coloursOnPaper = 7, inksOnPaper = 2;

/// The style on paper of curves that look alike on the screen.
struct Given {
    QString name;
    CurveStyle screen, paper;
};

CurveStyle blackStyle(std::size_t count)
{
    const auto number = static_cast<int>(count);
    return {number / dashesOnPaper % inksOnPaper, number % dashesOnPaper};
}

/// That of the screen, with another dash if it is taken.
CurveStyle freeStyle(const CurveStyle& screen, const std::vector<Given>& given)
{
    const auto taken = [&given](const CurveStyle& style) {
        return std::ranges::find(given, style, &Given::paper) != given.end();
    };
    CurveStyle style{screen.colour % coloursOnPaper, screen.dash % dashesOnPaper};
    for (int dash = 0; dash < dashesOnPaper && taken(style); ++dash) style.dash = dash;
    return style;
}

} // namespace

PlotTheme paperTheme(PaperColours colours)
{
    PlotTheme theme = lightPlotTheme();
    theme.axis = theme.text = theme.mutedText = Qt::black;
    if (colours == PaperColours::Black) theme.curves = {QColor(Qt::black), QColor("#808080")};
    return theme;
}

std::vector<PlotCurve> paperCurves(const std::vector<PlotCurve>& curves, PaperColours colours)
{
    std::vector<PlotCurve> printed;
    std::ranges::copy_if(curves, std::back_inserter(printed), [](const PlotCurve& curve) {
        return curve.visible && curve.data != nullptr && !curve.data->empty();
    });
    // Runs differ in the name, quantities of one run in the legend alone.
    const bool runs = std::ranges::any_of(printed, [](const PlotCurve& curve) { return curve.pale; });
    std::vector<Given> given;
    for (PlotCurve& curve : printed) {
        curve.pale = false;
        curve.inLegend = curve.inLegend || runs;
        if (runs) curve.legend.clear();
        const auto same = std::ranges::find_if(given, [&curve](const Given& other) {
            return other.name == curve.name && other.screen == curve.style; // both borders of a band
        });
        if (same != given.end()) {
            curve.style = same->paper;
            continue;
        }
        const CurveStyle paper =
            colours == PaperColours::Black ? blackStyle(given.size()) : freeStyle(curve.style, given);
        given.push_back({curve.name, curve.style, paper});
        curve.style = paper;
    }
    return printed;
}

std::size_t distinctPaperCurves(PaperColours colours)
{
    return static_cast<std::size_t>(dashesOnPaper * (colours == PaperColours::Black ? inksOnPaper : coloursOnPaper));
}

} // namespace touchdown
