// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_legend.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QFontMetricsF>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/plot/plot_frame.h"

using namespace touchdown;

namespace test_plot_legend {

std::vector<PlotCurve> drawnCurves(std::mt19937& generator, const MinMaxPyramid& data)
{
    std::vector<PlotCurve> curves;
    const int count = std::uniform_int_distribution(1, 12)(generator);
    for (int i = 0; i < count; ++i) {
        const int length = std::uniform_int_distribution(1, 60)(generator);
        curves.push_back(
            {QString::number(i), QStringLiteral("%1 ").arg(i) + QString(length, u'n'), {i % 7, i / 7}, &data});
    }
    return curves;
}

class TestPlotLegend : public QObject {
    Q_OBJECT

private slots:
    void rowOfTheScreenStaysInside();
    void cutsOnlyWhatHasNoRoom();
    void rowsOnPaperNameEveryCurve();
    void plotThatStandsAloneNeedsNone();

private:
    QFont font_;
    MinMaxPyramid data_;
};

void TestPlotLegend::rowOfTheScreenStaysInside()
{
    std::mt19937 generator(3);
    for (int draw = 0; draw < 200; ++draw) {
        const auto curves = drawnCurves(generator, data_);
        const QRectF row(60.0, 6.0, std::uniform_real_distribution(40.0, 900.0)(generator), 15.0);
        const Legend legend = legendInRow(curves, {}, row, font_);
        QCOMPARE(legend.entries.size() + legend.more, curves.size());
        for (const LegendEntry& entry : legend.entries) QVERIFY(entry.box.left() >= row.left() - 1.0);
    }
}

/// Names that fit together stand whole. Where they do not, the longest are cut, to one length.
void TestPlotLegend::cutsOnlyWhatHasNoRoom()
{
    std::mt19937 generator(5);
    const QFontMetricsF metrics(font_);
    int whole = 0, cut = 0;
    for (int draw = 0; draw < 300; ++draw) {
        auto curves = drawnCurves(generator, data_);
        curves.resize(std::min<std::size_t>(curves.size(), 4));
        const QRectF row(60.0, 6.0, std::uniform_real_distribution(600.0, 1600.0)(generator), 15.0);
        double needed = 0.0;
        for (const PlotCurve& curve : curves)
            needed += std::ceil(metrics.horizontalAdvance(curve.name)) + Legend::sample + 3.0 * PlotFrame::gap;
        const Legend legend = legendInRow(curves, {}, row, font_);
        double longestWhole = 0.0, shortestCut = 1e9;
        for (const LegendEntry& entry : legend.entries) {
            const double length = metrics.horizontalAdvance(entry.text);
            if (entry.text == entry.curve->name)
                longestWhole = std::max(longestWhole, length);
            else
                shortestCut = std::min(shortestCut, length);
        }
        // The last name needs the room of "+1".
        if (needed + metrics.horizontalAdvance("+00") <= row.width()) {
            ++whole;
            QCOMPARE(legend.more, std::size_t(0));
            QCOMPARE(shortestCut, 1e9);
        } else if (shortestCut < 1e9) {
            ++cut;
            QVERIFY(longestWhole <= shortestCut + metrics.horizontalAdvance("n…"));
        }
    }
    QVERIFY(whole > 50 && cut > 50);
}

void TestPlotLegend::rowsOnPaperNameEveryCurve()
{
    std::mt19937 generator(4);
    for (int draw = 0; draw < 200; ++draw) {
        const auto curves = drawnCurves(generator, data_);
        const double width = std::uniform_real_distribution(90.0, 700.0)(generator);
        const Legend legend = legendInRows(curves, {}, {60.0, 6.0}, width, font_);
        QCOMPARE(legend.entries.size(), curves.size());
        QCOMPARE(legend.more, std::size_t(0));
        for (std::size_t i = 0; i < legend.entries.size(); ++i) {
            const LegendEntry& entry = legend.entries[i];
            QCOMPARE(entry.text, entry.curve->name); // not shortened
            QVERIFY(entry.box.left() >= 60.0 && entry.box.right() <= 60.0 + width + 1e-9);
            QVERIFY(entry.box.bottom() <= 6.0 + legend.height + 1e-9);
            for (std::size_t k = 0; k < i; ++k) QVERIFY(!entry.box.intersects(legend.entries[k].box));
        }
    }
}

void TestPlotLegend::plotThatStandsAloneNeedsNone()
{
    const std::vector<PlotCurve> one{{"run", "Pitch", {0, 0}, &data_}};
    QVERIFY(legendInRows(one, "Pitch", {}, 200.0, font_).entries.empty());
    QCOMPARE(legendInRows(one, "Pitch", {}, 200.0, font_).height, 0.0);
    QCOMPARE(legendInRow(one, "Roll", {0.0, 0.0, 200.0, 15.0}, font_).entries.size(), std::size_t(1));
}

TOUCHDOWN_TEST(TestPlotLegend)

} // namespace test_plot_legend

#include "test_plot_legend.moc"
