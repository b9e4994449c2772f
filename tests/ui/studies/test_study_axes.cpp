// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_axes.h"

#include <cmath>
#include <limits>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_study.h"

using namespace touchdown;

namespace test_study_axes {

ChartPanel linear(std::vector<ChartPoint> points)
{
    return {{"x", "", "", false}, {"y", "m", "nm", false}, {{"a", std::move(points)}}, {}, {}, false};
}

class TestStudyAxes : public QObject {
    Q_OBJECT

private slots:
    void showsAllPoints();
    void showsErrorBars();
    void equalValuesAreALevelLine();
    void showsBandsThatAreNear();
    void anInfiniteBandMovesNothing();
    void edgesOfCells();
    void mapsFillTheirPanel();
    void equalScales();
    void nothingToShow();
};

void TestStudyAxes::showsAllPoints()
{
    const StudyChart chart = samplePrecisionChart();
    for (const ChartPanel& panel : chart.panels) {
        const PanelAxes axes = panelAxes(panel);
        QVERIFY(axes.x.logarithmic() && axes.y.logarithmic());
        for (const ChartSeries& series : panel.series)
            for (const ChartPoint& point : series.points)
                QVERIFY(axes.x.range().contains(point.x) && axes.y.range().contains(point.y));
    }
    QCOMPARE(panelAxes(chart.panels[0]).x.label.unit, QStringLiteral("ms"));
    QCOMPARE(panelAxes(chart.panels[0]).x.label.factor, 1e-3);
}

void TestStudyAxes::showsErrorBars()
{
    ChartPanel panel = linear({{0.0, 1.0}, {1.0, 2.0}});
    panel.series[0].points[1].yError = 5.0;
    const PlotRange range = panelAxes(panel).y.range();
    QVERIFY(range.contains(-3.0) && range.contains(7.0));
}

/// Equal results, with and without rounding errors: the numbers at the axis tell them from others.
void TestStudyAxes::equalValuesAreALevelLine()
{
    for (const double value : {0.5, -3.0, 1.0, 2e5, 1e-4, 0.0})
        for (const double error : {0.0, 1e-13, 1e-8, 5e-7}) {
            const PanelAxes axes = panelAxes(linear({{0.0, value}, {1.0, value * (1.0 + error)}, {2.0, value}}));
            const PlotRange range = axes.y.range();
            QVERIFY(range.contains(value) && range.width() > 0.15 * std::abs(value));
            QVERIFY2(axes.y.text().contains(u'\u2212') == false, qPrintable(axes.y.text())); // no offset
            for (const AxisTick& tick : axes.y.ticks(5)) QVERIFY(!tick.major || tick.value == 0.0 || tick.text != "0");
        }
}

/// Points fill 1 to 2. A band that ends at 2.4 is 0.4 of their width away and comes in, one at 200 would push them
/// together.
void TestStudyAxes::showsBandsThatAreNear()
{
    ChartPanel panel = linear({{0.0, 1.0}, {1.0, 2.0}});
    panel.bands = {{false, 2.2, 2.4, "near"}, {false, 100.0, 200.0, "far"}};
    const PlotRange range = panelAxes(panel).y.range();
    QVERIFY(range.contains(2.4) && !range.contains(100.0));
    // Level points count as 0.9 to 1.1 of their value: the edges of a band around them are seen.
    ChartPanel level = linear({{0.0, 0.5}, {1.0, 0.5}});
    level.bands = {{false, 0.42, 0.58, "around"}};
    const PlotRange around = panelAxes(level).y.range();
    QVERIFY(around.low < 0.42 && around.high > 0.58);
}

void TestStudyAxes::anInfiniteBandMovesNothing()
{
    ChartPanel panel = linear({{0.0, 1.0}, {1.0, 2.0}});
    const PanelRange before = panelAxes(panel).range();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    panel.bands = {{false, -infinite, 1.5, "below"}, {true, 0.5, infinite, "right"}};
    QCOMPARE(panelAxes(panel).range(), before);
}

/// Half way between the middles, at the ends as far beyond them: 1, 2, 4 gives 0.5, 1.5, 3, 5; in the logarithm
/// sqrt(1/2) of 2^0.5 steps.
void TestStudyAxes::edgesOfCells()
{
    QCOMPARE(cellEdges({1.0, 2.0, 4.0}, false), (std::vector<double>{0.5, 1.5, 3.0, 5.0}));
    const std::vector<double> edges = cellEdges({1.0, 2.0, 4.0}, true);
    const std::vector<double> expected{std::sqrt(0.5), std::sqrt(2.0), std::sqrt(8.0), std::sqrt(32.0)};
    for (std::size_t i = 0; i < 4; ++i) QVERIFY(std::abs(edges[i] / expected[i] - 1.0) < 1e-12);
    QCOMPARE(cellEdges({4.0}, true), (std::vector<double>{2.0, 8.0}));
    QCOMPARE(cellEdges({0.0}, false), (std::vector<double>{-0.5, 0.5}));
    QVERIFY(cellEdges({}, true).empty());
}

void TestStudyAxes::mapsFillTheirPanel()
{
    const ChartPanel panel = sampleMapChart().panels[0];
    const PanelAxes axes = panelAxes(panel);
    QCOMPARE(axes.x.range().low, cellEdges(panel.map->x, true).front());
    QCOMPARE(axes.y.range().high, cellEdges(panel.map->y, true).back());
}

void TestStudyAxes::equalScales()
{
    PanelAxes axes = panelAxes(sampleRegionChart().panels[0]);
    const PanelRange before = axes.range();
    equaliseScales(axes, {800.0, 400.0});
    const PanelRange after = axes.range();
    QVERIFY(std::abs(after.x.width() / 800.0 - after.y.width() / 400.0) < 1e-12);
    QVERIFY(after.x.width() >= before.x.width() * (1.0 - 1e-12) && after.y.width() >= before.y.width() * (1.0 - 1e-12));
}

void TestStudyAxes::nothingToShow()
{
    const PanelAxes axes = panelAxes({{"x", "", "", true}, {"y", "", "", false}, {}, {}, {}, false});
    QVERIFY(axes.x.range().low > 0.0 && axes.x.range().width() > 0.0 && axes.y.range().width() > 0.0);
}

TOUCHDOWN_TEST(TestStudyAxes)

} // namespace test_study_axes

#include "test_study_axes.moc"
