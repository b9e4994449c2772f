// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_peak.h"

#include <cmath>
#include <memory>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_cursor_peak {

/// Powers at 0, 1, ..., 500 Hz: a floor of 1 that falls slowly, and Gaussian peaks, which are parabolas in the
/// logarithm: 1000 at 100.3 Hz, 100 at 104 Hz, 50 at 300 Hz; all three with a width of 1 Hz.
double power(int i)
{
    const auto gauss = [i](double height, double place) { return height * std::exp(-std::pow(i - place, 2)); };
    return (1.0 - 1e-3 * i) + gauss(1000.0, 100.3) + gauss(100.0, 104.0) + gauss(50.0, 300.0);
}

class TestCursorPeak : public QObject {
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

void TestCursorPeak::init()
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

void TestCursorPeak::findsTheTopBetweenTheSamples()
{
    const auto found = peakNear(*plot_, 101.0, 8.0);
    QVERIFY(found);
    // The floor of 1 below 1000 moves the top by less than 1e-3.
    QVERIFY2(std::abs(*found - 100.3) < 1e-3, qPrintable(QString::number(*found, 'g', 8)));
}

void TestCursorPeak::reachIsInPixels()
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
void TestCursorPeak::theNearestOfTwoThatStandApart()
{
    plot_->setView({PlotRange{90.0, 115.0}, std::nullopt});
    QVERIFY(std::abs(*peakNear(*plot_, 100.5, 8.0) - 100.3) < 1e-3);
    QVERIFY(std::abs(*peakNear(*plot_, 103.9, 8.0) - 104.0) < 0.1); // the other's flank moves it a little
    QVERIFY(!peakNear(*plot_, 102.2, 8.0));
}

/// Zoomed out, the lower peak is within the reach of the higher one: only that stands out, whichever is nearer.
void TestCursorPeak::aLowPeakBesideAHighOneIsNone()
{
    QVERIFY(std::abs(pixels(104.0) - pixels(100.3)) < 8.0);
    QVERIFY(std::abs(*peakNear(*plot_, 104.0, 8.0) - 100.3) < 1e-3);
}

void TestCursorPeak::monotonousCurvesHaveNone()
{
    QVERIFY(!peakNear(*plot_, 200.0, 8.0));
    QVERIFY(!peakNear(*plot_, 0.0, 8.0));
    QVERIFY(!peakNear(*plot_, 500.0, 8.0));
    plot_->clearCurves();
    QVERIFY(!peakNear(*plot_, 100.3, 8.0));
    QVERIFY(!isAtPeak(*plot_, 100.3));
}

void TestCursorPeak::theCurveThatLeadsDecides()
{
    plot_->addCurve({"2", "Run 2", {1, 0}, other_.get()});
    QVERIFY(!peakNear(*plot_, 100.3, 8.0)); // of two that lead, the newest
    plot_->updateCurves([](PlotCurve& curve) { curve.leads = curve.id == "1"; });
    QVERIFY(peakNear(*plot_, 100.3, 8.0));
    plot_->setCurveVisible("1", false);
    QVERIFY(!peakNear(*plot_, 100.3, 8.0));
}

void TestCursorPeak::knowsACursorAtAPeak()
{
    const double top = *peakNear(*plot_, 101.0, 8.0);
    QVERIFY(isAtPeak(*plot_, top));
    QVERIFY(!isAtPeak(*plot_, top + 1e-3));
    QVERIFY(!isAtPeak(*plot_, 200.0));
    plot_->setView({PlotRange{0.0, 5000.0}, std::nullopt});
    QVERIFY(isAtPeak(*plot_, top)); // whatever the zoom
}

void TestCursorPeak::logarithmicAxis()
{
    plot_->setXLabel({"Frequency", "Hz", 1.0, AxisScale::Logarithmic});
    plot_->setView({PlotRange{10.0, 500.0}, std::nullopt});
    const double top = *peakNear(*plot_, 299.0, 8.0);
    QVERIFY(std::abs(top - 300.0) < 0.01);
    QCOMPARE(peakNear(*plot_, at(pixels(top) - 7.5), 8.0), std::optional(top));
    QVERIFY(!peakNear(*plot_, at(pixels(top) - 8.5), 8.0));
}

TOUCHDOWN_TEST(TestCursorPeak)

} // namespace test_cursor_peak

#include "test_cursor_peak.moc"
