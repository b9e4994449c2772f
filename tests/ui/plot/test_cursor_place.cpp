// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_place.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include <QTest>

#include "tests/support/test_program.h"
#include "ui/plot/plot_group.h"

using namespace touchdown;

namespace test_cursor_place {

/// Powers at 0, 1, ..., 500 Hz: a floor of 1 that falls slowly, and Gaussian peaks, which are parabolas in the
/// logarithm: 1000 at 100.3 Hz, 100 at 104 Hz, 50 at 300 Hz; all three with a width of 1 Hz.
double power(int i)
{
    const auto gauss = [i](double height, double place) { return height * std::exp(-std::pow(i - place, 2)); };
    return (1.0 - 1e-3 * i) + gauss(1000.0, 100.3) + gauss(100.0, 104.0) + gauss(50.0, 300.0);
}

class TestCursorPlace : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { plot_.reset(), data_.reset(), other_.reset(); }

    void findsTheTopBetweenTheSamples();
    void reachIsInPixels();
    void theNearestOfTwoThatStandApart();
    void aLowPeakBesideAHighOneIsNone();
    void monotonousCurvesHaveNone();
    void theCurveThatLeadsDecides();
    void knowsACursorAtAPeak();
    void logarithmicAxis();
    void theNearestPointOfAPortrait();
    void aClickInAPortraitSetsTheCursors();

private:
    double pixels(double frequency) const { return plot_->toPixel(frequency, 1.0).x(); }
    double at(double pixel) const
    {
        const QRectF area = plot_->plotArea();
        return plot_->xAxis().valueAt((pixel - area.left()) / area.width());
    }

    std::unique_ptr<MinMaxPyramid> data_;
    std::unique_ptr<MinMaxPyramid> other_;
    std::unique_ptr<PlotWidget> plot_;
};

void TestCursorPlace::init()
{
    data_ = std::make_unique<MinMaxPyramid>();
    other_ = std::make_unique<MinMaxPyramid>();
    for (int i = 0; i <= 500; ++i) {
        const double time[] = {double(i)};
        const double values[] = {power(i)};
        const double falls[] = {std::exp(-0.01 * i)};
        data_->append(time, values);
        other_->append(time, falls);
    }
    plot_ = std::make_unique<PlotWidget>();
    plot_->resize(700, 300);
    plot_->addCurve({"1", "Run 1", {0, 0}, data_.get()});
    plot_->setView({PlotRange{0.0, 500.0}, std::nullopt}); // more than a pixel for each sample
}

void TestCursorPlace::findsTheTopBetweenTheSamples()
{
    const auto found = peakNear(*plot_, 101.0, 8.0);
    QVERIFY(found);
    // The floor of 1 below 1000 moves the top by less than 1e-3.
    QVERIFY2(std::abs(*found - 100.3) < 1e-3, qPrintable(QString::number(*found, 'g', 8)));
}

void TestCursorPlace::reachIsInPixels()
{
    const double top = *peakNear(*plot_, 300.0, 8.0);
    QVERIFY(std::abs(top - 300.0) < 0.01);
    QCOMPARE(peakNear(*plot_, at(pixels(top) + 7.5), 8.0), std::optional(top));
    QCOMPARE(peakNear(*plot_, at(pixels(top) - 7.5), 8.0), std::optional(top));
    QVERIFY(!peakNear(*plot_, at(pixels(top) + 8.5), 8.0));
    QVERIFY(!peakNear(*plot_, at(pixels(top) - 8.5), 8.0));
    plot_->setView({PlotRange{290.0, 310.0}, std::nullopt}); // a pixel is now much less
    QVERIFY(!peakNear(*plot_, top + 1.0, 8.0));
}

/// Zoomed in, 100.3 and 104 Hz are far more than two reaches apart; in the middle there is none.
void TestCursorPlace::theNearestOfTwoThatStandApart()
{
    plot_->setView({PlotRange{90.0, 115.0}, std::nullopt});
    QVERIFY(std::abs(*peakNear(*plot_, 100.5, 8.0) - 100.3) < 1e-3);
    QVERIFY(std::abs(*peakNear(*plot_, 103.9, 8.0) - 104.0) < 0.1); // the other's flank moves it a little
    QVERIFY(!peakNear(*plot_, 102.2, 8.0));
}

/// Zoomed out, the lower peak is within the reach of the higher one: only that stands out, whichever is nearer.
void TestCursorPlace::aLowPeakBesideAHighOneIsNone()
{
    QVERIFY(std::abs(pixels(104.0) - pixels(100.3)) < 8.0);
    QVERIFY(std::abs(*peakNear(*plot_, 104.0, 8.0) - 100.3) < 1e-3);
}

void TestCursorPlace::monotonousCurvesHaveNone()
{
    QVERIFY(!peakNear(*plot_, 200.0, 8.0));
    QVERIFY(!peakNear(*plot_, 0.0, 8.0));
    QVERIFY(!peakNear(*plot_, 500.0, 8.0));
    plot_->clearCurves();
    QVERIFY(!peakNear(*plot_, 100.3, 8.0));
    QVERIFY(!isAtPeak(*plot_, 100.3));
}

void TestCursorPlace::theCurveThatLeadsDecides()
{
    plot_->addCurve({"2", "Run 2", {1, 0}, other_.get()});
    QVERIFY(!peakNear(*plot_, 100.3, 8.0)); // of two that lead, the newest
    plot_->updateCurves([](PlotCurve& curve) { curve.leads = curve.id == "1"; });
    QVERIFY(peakNear(*plot_, 100.3, 8.0));
    plot_->setCurveVisible("1", false);
    QVERIFY(!peakNear(*plot_, 100.3, 8.0));
}

void TestCursorPlace::knowsACursorAtAPeak()
{
    const double top = *peakNear(*plot_, 101.0, 8.0);
    QVERIFY(isAtPeak(*plot_, top));
    QVERIFY(!isAtPeak(*plot_, top + 1e-3));
    QVERIFY(!isAtPeak(*plot_, 200.0));
    plot_->setView({PlotRange{0.0, 5000.0}, std::nullopt});
    QVERIFY(isAtPeak(*plot_, top)); // whatever the zoom
}

void TestCursorPlace::logarithmicAxis()
{
    plot_->setXLabel({"Frequency", "Hz", 1.0, AxisScale::Logarithmic});
    plot_->setView({PlotRange{10.0, 500.0}, std::nullopt});
    const double top = *peakNear(*plot_, 299.0, 8.0);
    QVERIFY(std::abs(top - 300.0) < 0.01);
    QCOMPARE(peakNear(*plot_, at(pixels(top) - 7.5), 8.0), std::optional(top));
    QVERIFY(!peakNear(*plot_, at(pixels(top) - 8.5), 8.0));
}

/// Against all points of all lines, of drawn curves: some are loops about the place, most are elsewhere.
void TestCursorPlace::theNearestPointOfAPortrait()
{
    std::mt19937 generator(5);
    const auto drawn = [&generator](double low, double high) {
        return std::uniform_real_distribution(low, high)(generator);
    };
    for (int draw = 0; draw < 60; ++draw) {
        MinMaxPyramid x, y(x.times());
        const int samples = std::uniform_int_distribution(2, 3000)(generator);
        const double turns = drawn(0.0, 0.4), noise = draw % 3 == 0 ? 0.3 : 0.0;
        for (int k = 0; k < samples; ++k) {
            const double radius = 1.0 + 1e-3 * k;
            x.append(std::vector{0.5 * k}, std::vector{radius * std::cos(turns * k) + noise * drawn(-1.0, 1.0)});
            y.append(std::vector{0.5 * k}, std::vector{radius * std::sin(turns * k) + noise * drawn(-1.0, 1.0)});
        }
        PlotWidget plot;
        plot.resize(500, 400);
        plot.setPhasePortrait(true);
        plot.addCurve({"1", "Run 1", {0, 0}, &y, &x});
        plot.setView({PlotRange{-3.0, 3.0}, PlotRange{-3.0, 3.0}});
        const PlotRange window{draw % 2 == 0 ? -1.0 : 0.1 * samples, 0.4 * samples};
        plot.setTimeWindow(window);
        const QPointF aim = plot.toPixel(drawn(-3.0, 3.0), drawn(-3.0, 3.0));
        double nearest = HUGE_VAL;
        const auto [begin, end] = x.samplesWithin(window.low, window.high);
        for (std::size_t k = begin; k < end; ++k) {
            const QPointF to = plot.toPixel(x.value(k), y.value(k));
            const QPointF from = k > begin ? plot.toPixel(x.value(k - 1), y.value(k - 1)) : to;
            for (int part = 0; part <= 20; ++part) {
                const QPointF apart = from + part / 20.0 * (to - from) - aim;
                nearest = std::min(nearest, std::hypot(apart.x(), apart.y()));
            }
        }
        const std::optional<double> found = phaseTimeNear(plot, aim);
        QCOMPARE(found.has_value(), begin < end);
        if (!found) continue;
        QVERIFY(*found >= window.low && *found <= window.high);
        const QPointF apart = plot.toPixel(*x.valueAt(*found), *y.valueAt(*found)) - aim;
        QVERIFY2(std::hypot(apart.x(), apart.y()) <= std::max(0.5, nearest) + 1e-6,
                 qPrintable(QStringLiteral("%1: %2 px").arg(draw).arg(std::hypot(apart.x(), apart.y()))));
    }
}

/// Half a circle in 1 s: where y = x there is a quarter of it. The plot over time beside it has the same cursors.
void TestCursorPlace::aClickInAPortraitSetsTheCursors()
{
    MinMaxPyramid x, y(x.times());
    for (int k = 0; k <= 1000; ++k) {
        const double angle = std::numbers::pi * k / 1000.0;
        x.append(std::vector{1e-3 * k}, std::vector{std::cos(angle)});
        y.append(std::vector{1e-3 * k}, std::vector{std::sin(angle)});
    }
    PlotWidget portrait, overTime;
    portrait.resize(400, 400);
    portrait.setPhasePortrait(true);
    portrait.addCurve({"1", "Run 1", {0, 0}, &y, &x});
    overTime.addCurve({"1", "Run 1", {0, 0}, &y});
    PlotGroup group;
    group.add(&overTime);
    group.add(&portrait);
    portrait.setView({PlotRange{-1.5, 1.5}, PlotRange{-1.5, 1.5}});
    const auto click = [&](double part, Qt::KeyboardModifiers held) {
        const double angle = std::numbers::pi * part;
        const QPointF at = portrait.toPixel(std::cos(angle), std::sin(angle));
        QTest::mouseClick(&portrait, Qt::LeftButton, held, at.toPoint());
    };
    click(0.25, Qt::NoModifier);
    click(0.8, Qt::ShiftModifier);
    QVERIFY(group.cursor(0) && std::abs(*group.cursor(0) - 0.25) < 0.005);
    QVERIFY(group.cursor(1) && std::abs(*group.cursor(1) - 0.8) < 0.005);
    QCOMPARE(overTime.plotCursor(0), group.cursor(0));
    QVERIFY(overTime.cursorPinned());
    // The cursors of the plot over time have marks in the portrait.
    const QImage before = portrait.grab().toImage();
    group.setCursor(0, 0.5);
    const QPoint mark = portrait.toPixel(0.0, 1.0).toPoint();
    QVERIFY(portrait.grab().toImage().pixel(mark + QPoint(0, 3)) != before.pixel(mark + QPoint(0, 3)));
    group.remove(&portrait);
    group.remove(&overTime);
}

TOUCHDOWN_TEST(TestCursorPlace)

} // namespace test_cursor_place

#include "test_cursor_place.moc"
