// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/paper_curves.h"

#include <algorithm>
#include <iterator>

#include <QRegularExpression>

namespace touchdown {

namespace {

constexpr int dashesOnPaper = 4; // of curvePen()
constexpr int coloursOnPaper = 7, inksOnPaper = 2;

/// The run for a curve that stands for it, "run 3/pitch" without a name of its quantity; else the curve.
PaperStyle unstyled(const PlotCurve& curve)
{
    static const QRegularExpression run(QStringLiteral("^run \\d+(?=/|$)"));
    const QRegularExpressionMatch found = run.match(curve.id);
    const bool isRun = curve.legend.isEmpty() && found.hasMatch();
    return {isRun ? found.captured() : curve.name, isRun, curve.style, {}};
}

bool isSame(const PaperStyle& a, const PaperStyle& b)
{
    return a.name == b.name && a.run == b.run && a.screen == b.screen; // also both borders of a band
}

bool isTaken(const std::vector<PaperStyle>& styles, const CurveStyle& paper)
{
    return std::ranges::find(styles, paper, &PaperStyle::paper) != styles.end();
}

/// In the order in which they are given: black ones, or those of the colour on the screen.
std::vector<CurveStyle> offered(const CurveStyle& screen, PaperColours colours)
{
    std::vector<CurveStyle> all;
    if (colours == PaperColours::Coloured) all.push_back({screen.colour % coloursOnPaper, screen.dash % dashesOnPaper});
    for (int ink = 0; colours == PaperColours::Black && ink < inksOnPaper; ++ink)
        for (int dash = 0; dash < dashesOnPaper; ++dash) all.push_back({ink, dash});
    for (int dash = 0; colours == PaperColours::Coloured && dash < dashesOnPaper; ++dash)
        all.push_back({screen.colour % coloursOnPaper, dash});
    return all;
}

/// One that no other curve of the panel has; of a run one that no other run of the figure has, if there is one.
CurveStyle freeStyle(const PaperStyle& wanted, PaperColours colours, const std::vector<PaperStyle>& panel,
                     const std::vector<PaperStyle>& figure)
{
    const std::vector<CurveStyle> all = offered(wanted.screen, colours);
    const auto isOtherRun = [&wanted](const PaperStyle& other) { return wanted.run && other.run; };
    std::vector<PaperStyle> runs;
    std::ranges::copy_if(figure, std::back_inserter(runs), isOtherRun);
    for (const CurveStyle& style : all)
        if (!isTaken(panel, style) && !isTaken(runs, style)) return style;
    for (const CurveStyle& style : all)
        if (!isTaken(panel, style)) return style;
    return all[panel.size() % all.size()];
}

} // namespace

PlotTheme paperTheme(PaperColours colours)
{
    PlotTheme theme = lightPlotTheme();
    theme.axis = theme.text = theme.mutedText = Qt::black;
    if (colours == PaperColours::Black) theme.curves = {QColor(Qt::black), QColor("#808080")};
    return theme;
}

std::vector<PlotCurve> paperCurves(const std::vector<PlotCurve>& curves, PaperColours colours,
                                   std::vector<PaperStyle>& styles)
{
    std::vector<PlotCurve> printed;
    std::ranges::copy_if(curves, std::back_inserter(printed), [](const PlotCurve& curve) {
        return curve.visible && curve.data != nullptr && !curve.data->empty();
    });
    // Runs differ in the name, quantities of one run in the legend alone.
    const bool runs = std::ranges::any_of(printed, [](const PlotCurve& curve) { return curve.pale; });
    std::vector<PaperStyle> panel;
    const auto known = [](const std::vector<PaperStyle>& list, const PaperStyle& wanted) {
        return std::ranges::find_if(list, [&wanted](const PaperStyle& each) { return isSame(each, wanted); });
    };
    for (const PlotCurve& curve : printed) { // what stood in a panel before, first
        const PaperStyle wanted = unstyled(curve);
        const auto before = known(styles, wanted);
        if (before != styles.end() && known(panel, wanted) == panel.end() && !isTaken(panel, before->paper))
            panel.push_back(*before);
    }
    for (PlotCurve& curve : printed) {
        curve.pale = false;
        curve.inLegend = curve.inLegend || runs;
        PaperStyle wanted = unstyled(curve);
        if (runs) curve.legend.clear();
        if (known(panel, wanted) == panel.end()) {
            wanted.paper = freeStyle(wanted, colours, panel, styles);
            panel.push_back(wanted);
            if (known(styles, wanted) == styles.end()) styles.push_back(wanted);
        }
        curve.style = known(panel, wanted)->paper;
    }
    return printed;
}

std::vector<PlotCurve> paperCurves(const std::vector<PlotCurve>& curves, PaperColours colours)
{
    std::vector<PaperStyle> styles;
    return paperCurves(curves, colours, styles);
}

std::size_t distinctPaperCurves(PaperColours colours)
{
    return static_cast<std::size_t>(dashesOnPaper * (colours == PaperColours::Black ? inksOnPaper : coloursOnPaper));
}

} // namespace touchdown
