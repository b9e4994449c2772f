// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_plots.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_series_plots {

std::vector<SteadySeriesPoint> radii(const std::vector<double>& values, double speed = 500.0)
{
    std::vector<SteadySeriesPoint> points;
    for (const double radius : values) points.push_back({radius, 0.0, speed, {}});
    return points;
}

/// Spacing of a millionth of the radius, with an error of 1 nm.
SeriesState state(const SteadySeriesPoint& point)
{
    SeriesState made{point, {}};
    made.result.status = SteadyStatus::Converged;
    made.result.minimumSpacing = 1e-6 * point.radius;
    made.result.forces.net = point.radius;
    made.result.discretisationError.minimumSpacing = 1e-9;
    return made;
}

std::vector<SeriesState> statesOf(const std::vector<SteadySeriesPoint>& points)
{
    std::vector<SeriesState> states;
    for (const SteadySeriesPoint& point : points) states.push_back(state(point));
    return states;
}

/// Curves of states, without the borders of their errors.
std::vector<PlotCurve> dotted(const PlotWidget& plot)
{
    std::vector<PlotCurve> found;
    for (const PlotCurve& curve : plot.curves())
        if (curve.dots) found.push_back(curve);
    return found;
}

class TestSeriesPlots : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }
    void init()
    {
        plots_ = std::make_unique<SeriesPlots>();
        plots_->resize(700, 500);
    }
    void drawsTheStates();
    void theErrorIsABand();
    void noLinePassesAFailedState();
    void sortsByTheAxis();
    void aCurveForEachOfTheOtherList();
    void heldShowsTheForce();
    void pointsAtAState();
    void dotsAreDrawn();
    /// It does not follow the pointer: a state that is chosen stays marked.
    void theCursorStays();

private:
    PlotWidget& spacing() const { return *plots_->plots()[0]; }
    std::unique_ptr<SeriesPlots> plots_;
};

void TestSeriesPlots::theCursorStays()
{
    const auto points = radii({20e-3, 25e-3, 30e-3});
    plots_->setStates(points, statesOf(points));
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
    spacing().setPlotCursor(0, 25e-3);
    for (const double share : {0.3, 0.8}) QTest::mouseMove(&spacing(), QPoint(int(share * 700.0), 60));
    QCOMPARE(*spacing().plotCursor(0), 25e-3);
}

void TestSeriesPlots::drawsTheStates()
{
    const auto points = radii({20e-3, 25e-3, 30e-3});
    plots_->setStates(points, statesOf(points));
    const auto curves = dotted(spacing());
    QCOMPARE(curves.size(), std::size_t(1));
    QCOMPARE(curves[0].data->size(), std::size_t(3));
    QCOMPARE(curves[0].data->time(1), 25e-3);
    QCOMPARE(curves[0].data->value(1), 25e-9);
    for (const PlotWidget* plot : plots_->plots()) {
        QCOMPARE(plot->xAxis().label.unit, QStringLiteral("mm"));
        QCOMPARE(plot->xAxis().range(), plots_->plots()[0]->xAxis().range()); // one axis
    }
    QVERIFY(!plots_->plots()[0]->xNumbersVisible());
    QVERIFY(plots_->plots()[3]->xNumbersVisible());
}

void TestSeriesPlots::theErrorIsABand()
{
    const auto points = radii({20e-3, 30e-3});
    std::vector<SeriesState> states = statesOf(points);
    plots_->setStates(points, states);
    QCOMPARE(spacing().shadedAreas().size(), std::size_t(1));
    const auto& outline = spacing().shadedAreas()[0].outline;
    QCOMPARE(outline.size(), std::size_t(4));
    QCOMPARE(outline[0].second, 20e-9 + 1e-9);
    QCOMPARE(outline[2].second, 30e-9 - 1e-9);
    spacing().refreshNow();
    QVERIFY(spacing().yAxis().range().contains(19e-9) && spacing().yAxis().range().contains(31e-9));
    // Where no coarser grid had a solution the error is not known.
    for (SeriesState& each : states) each.result.discretisationError = {};
    plots_->setStates(points, states);
    QVERIFY(spacing().shadedAreas().empty());
    QCOMPARE(spacing().curves().size(), std::size_t(1));
}

void TestSeriesPlots::noLinePassesAFailedState()
{
    const auto points = radii({20e-3, 22e-3, 24e-3, 26e-3, 28e-3});
    std::vector<SeriesState> states = statesOf(points);
    states[2].result.status = SteadyStatus::Failed;
    states[2].result.minimumSpacing = -5e-9;
    plots_->setStates(points, states);
    const auto curves = dotted(spacing());
    QCOMPARE(curves.size(), std::size_t(2));
    QCOMPARE(curves[0].data->lastTime(), 22e-3);
    QCOMPARE(curves[1].data->firstTime(), 26e-3);
    QCOMPARE(curves[0].style, curves[1].style);
    QCOMPARE(spacing().shadedAreas().size(), std::size_t(2));
}

void TestSeriesPlots::sortsByTheAxis()
{
    const auto points = radii({30e-3, 20e-3, 25e-3});
    plots_->setStates(points, statesOf(points));
    QCOMPARE(dotted(spacing())[0].data->size(), std::size_t(3));
    QCOMPARE(dotted(spacing())[0].data->firstTime(), 20e-3);
}

void TestSeriesPlots::aCurveForEachOfTheOtherList()
{
    auto points = radii({20e-3, 30e-3}, 500.0);
    const auto faster = radii({20e-3, 30e-3}, 700.0);
    points.insert(points.end(), faster.begin(), faster.end());
    plots_->setStates(points, statesOf(points));
    const auto curves = dotted(spacing());
    QCOMPARE(curves.size(), std::size_t(2));
    QVERIFY(curves[0].name != curves[1].name);
    QVERIFY(curves[0].style != curves[1].style);
    // In the legend are the curves alone.
    for (const PlotCurve& curve : spacing().curves()) QCOMPARE(curve.inLegend, curve.dots);
}

void TestSeriesPlots::heldShowsTheForce()
{
    const auto points = radii({20e-3, 30e-3});
    plots_->setHeld(true);
    plots_->setStates(points, statesOf(points));
    QCOMPARE(plots_->plots()[1]->title(), QStringLiteral("Net force"));
    QCOMPARE(dotted(*plots_->plots()[1])[0].data->value(0), 20e-3);
    plots_->setHeld(false);
    plots_->setStates(points, statesOf(points));
    QCOMPARE(dotted(*plots_->plots()[1])[0].data->value(0), 0.0);
}

void TestSeriesPlots::pointsAtAState()
{
    const auto points = radii({20e-3, 30e-3});
    plots_->setStates(points, statesOf(points));
    plots_->point(points[1]);
    for (const PlotWidget* plot : plots_->plots()) QCOMPARE(*plot->plotCursor(0), 30e-3);
}

/// Lines alone would leave a single state invisible.
void TestSeriesPlots::dotsAreDrawn()
{
    const auto points = radii({20e-3, 25e-3, 30e-3});
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
    plots_->setStates(points, statesOf({points[1]}));
    for (PlotWidget* plot : plots_->plots()) plot->setView({PlotRange{20e-3, 30e-3}, PlotRange{0.0, 50e-9}});
    const QImage image = spacing().grab().toImage();
    const QPoint at = spacing().toPixel(25e-3, 25e-9).toPoint();
    QCOMPARE(image.pixelColor(at), lightPlotTheme().curves[0]);
}

TOUCHDOWN_TEST(TestSeriesPlots)

} // namespace test_series_plots

#include "test_series_plots.moc"
