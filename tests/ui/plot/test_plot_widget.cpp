// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_widget.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <QLocale>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/test_program.h"
#include "ui/plot/plot_painter.h"
#include "ui/plot/plot_path.h"

using namespace touchdown;

namespace test_plot_widget {

/// 0 to 1 ms, a sine of 10 periods between 2 and 12 nm.
void fill(MinMaxPyramid& data, double middle = 7e-9)
{
    std::vector<double> times;
    std::vector<double> values;
    for (int i = 0; i <= 10000; ++i) {
        times.push_back(1e-7 * i);
        values.push_back(middle + 5e-9 * std::sin(2.0 * std::numbers::pi * 1e4 * times.back()));
    }
    data.append(times, values);
}

/// How many pixels of `area` are near to `colour`.
int ink(const QImage& image, const QRectF& area, const QColor& colour)
{
    int count = 0;
    const QRect pixels = area.toAlignedRect().intersected(image.rect());
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x) {
            const QColor c = image.pixelColor(x, y);
            const int apart = std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                              std::abs(c.blue() - colour.blue());
            count += apart < 90 ? 1 : 0;
        }
    return count;
}

void turnWheel(QWidget& widget, const QPointF& at, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&widget, &event);
}

/// QTest::mouseMove carries no pressed button, and is lost on the offscreen platform.
void movePointer(QWidget& widget, const QPointF& at, Qt::MouseButtons pressed = Qt::NoButton)
{
    QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, pressed, Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &event);
}

void drag(QWidget& widget, Qt::MouseButton button, const QPointF& from, const QPointF& to)
{
    QTest::mousePress(&widget, button, Qt::NoModifier, from.toPoint());
    movePointer(widget, 0.5 * (from + to), button);
    movePointer(widget, to, button);
    QTest::mouseRelease(&widget, button, Qt::NoModifier, to.toPoint());
}

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

class TestPlotWidget : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void cleanup();

    void fitsItsData();
    void inkWhereTheCurveIs_data();
    void inkWhereTheCurveIs();
    void textIsDrawn();
    void hiddenCurveLeavesNoInk();
    void addingACurveLosesNothing();
    void hiddenPlotComputesNothing();
    void manyChangesMakeOneRefresh();
    void plotAreaStandsStill();
    void wheelZoomsAboutThePointer_data();
    void wheelZoomsAboutThePointer();
    void boxZooms();
    void flatBoxZoomsOneAxis();
    void dragMoves();
    void doubleClickFits();
    void keys();
    void cursors();
    void escapeTakesCursorsAway();
    void logarithmicHeightWithZeros();
    void referenceLineAndMarks();
    void allCurvesCanDecideTheRange();
    void followsThePalette();
    void rangesFollowTheCurveThatLeads();
    void aRangeGrowsInHalvesOfTheWay();
    void theLegendNamesTheNewestFirst();
    void theLegendIsUnderThePointer();
    void oneCurveIsWideBesidePaleOnes();

private:
    MinMaxPyramid data_;
    std::unique_ptr<PlotWidget> plot_;
};

void TestPlotWidget::init()
{
    data_ = MinMaxPyramid();
    fill(data_);
    plot_ = std::make_unique<PlotWidget>();
    plot_->resize(700, 300);
    plot_->setTitle("Minimum spacing");
    plot_->setXLabel({"Time", "ms", 1e-3, AxisScale::Linear});
    plot_->setYLabel({"Spacing", "nm", 1e-9, AxisScale::Linear});
    plot_->addCurve({"run", "Run 1", {0, 0}, &data_});
    plot_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plot_.get()));
    plot_->refreshNow();
}

void TestPlotWidget::cleanup() { plot_.reset(); }

void TestPlotWidget::fitsItsData()
{
    QCOMPARE(plot_->xAxis().range(), (PlotRange{0.0, 1e-3}));
    const PlotRange y = plot_->yAxis().range();
    QVERIFY(y.low < 2e-9 && y.low > 0.0);
    QVERIFY(y.high > 12e-9 && y.high < 14e-9);
}

void TestPlotWidget::inkWhereTheCurveIs_data()
{
    QTest::addColumn<int>("colour");
    QTest::addColumn<int>("dash");
    for (int i = 0; i < 7; ++i) QTest::addRow("colour %d", i) << i << 0;
    QTest::addRow("dashed") << 0 << 1;
}

// The crest of the first period stands at 0.025 ms and 12 nm. At 0.05 ms the sine is back in the middle: the upper
// and lower quarter of that column are empty.
void TestPlotWidget::inkWhereTheCurveIs()
{
    QFETCH(int, colour);
    QFETCH(int, dash);
    plot_->addCurve({"run", "Run 1", {colour, dash}, &data_});
    plot_->setView({PlotRange{0.0, 1e-4}, PlotRange{0.0, 14e-9}});
    plot_->refreshNow();
    const QImage image = plot_->grab().toImage();
    const QColor expected = plot_->theme().colour({colour, dash});
    const auto near = [&](double x, double y, double reach) {
        const QPointF at = plot_->toPixel(x, y);
        return QRectF(at.x() - reach, at.y() - reach, 2.0 * reach, 2.0 * reach);
    };
    QVERIFY(ink(image, near(0.25e-4, 12e-9, 8.0), expected) >= 8);
    QVERIFY(ink(image, near(0.75e-4, 2e-9, 8.0), expected) >= 8);
    QCOMPARE(ink(image, near(0.5e-4, 12e-9, 8.0), expected), 0);
    QCOMPARE(ink(image, near(0.5e-4, 2e-9, 8.0), expected), 0);
}

// No font would leave boxes or nothing: the row of the title must hold as much dark ink as the text has, and its left
// half more than an empty title.
void TestPlotWidget::textIsDrawn()
{
    const QRectF header(plot_->plotArea().left(), 0.0, 150.0, plot_->plotArea().top() - 2.0);
    const QColor text = plot_->theme().text;
    const int with = ink(plot_->grab().toImage(), header, text);
    plot_->setTitle("i");
    const int little = ink(plot_->grab().toImage(), header, text);
    plot_->setTitle("");
    const int without = ink(plot_->grab().toImage(), header, text);
    QCOMPARE(without, 0);
    QVERIFY(little > 3);
    QVERIFY(with > 8 * little); // 14 letters, each with more ink than an i; boxes would all have the same
}

void TestPlotWidget::hiddenCurveLeavesNoInk()
{
    const QColor colour = plot_->theme().colour({0, 0});
    QVERIFY(ink(plot_->grab().toImage(), plot_->plotArea(), colour) > 500);
    plot_->setCurveVisible("run", false);
    plot_->refreshNow();
    QCOMPARE(ink(plot_->grab().toImage(), plot_->plotArea(), colour), 0);
    plot_->setCurveVisible("run", true);
    plot_->refreshNow();
    QVERIFY(ink(plot_->grab().toImage(), plot_->plotArea(), colour) > 500);
}

void TestPlotWidget::addingACurveLosesNothing()
{
    MinMaxPyramid other;
    fill(other, 20e-9);
    plot_->setView({PlotRange{2e-4, 4e-4}, PlotRange{0.0, 30e-9}});
    plot_->setPlotCursor(0, 3e-4);
    plot_->addCurve({"other", "Run 2", {1, 1}, &other});
    plot_->refreshNow();
    QCOMPARE(plot_->curves().size(), std::size_t(2));
    QCOMPARE(plot_->curves()[0].id, QStringLiteral("run"));
    QCOMPARE(plot_->view(), (PlotView{PlotRange{2e-4, 4e-4}, PlotRange{0.0, 30e-9}}));
    QCOMPARE(plot_->plotCursor(0), std::optional(3e-4));
    const QImage image = plot_->grab().toImage();
    QVERIFY(ink(image, plot_->plotArea(), plot_->theme().colour({0, 0})) > 300);
    QVERIFY(ink(image, plot_->plotArea(), plot_->theme().colour({1, 1})) > 100);
    plot_->addCurve({"other", "Run 2 again", {2, 0}, &other});
    QCOMPARE(plot_->curves().size(), std::size_t(2));
    QCOMPARE(plot_->curves()[1].name, QStringLiteral("Run 2 again"));
    plot_->clearCurves();
}

void TestPlotWidget::hiddenPlotComputesNothing()
{
    const auto later = [this] { data_.append(std::vector{data_.lastTime() + 1e-3}, std::vector{7e-9}); };
    plot_->hide();
    const PlotRange before = plot_->xAxis().range();
    PlotWidget visible;
    visible.addCurve({"run", "Run 1", {0, 0}, &data_});
    visible.show();
    QVERIFY(QTest::qWaitForWindowExposed(&visible));
    later();
    plot_->dataChanged();
    visible.dataChanged();
    QTRY_COMPARE(visible.xAxis().range().high, data_.lastTime()); // by then the hidden one would have had its turn
    QCOMPARE(plot_->xAxis().range(), before);
    plot_->show(); // the data that came meanwhile are drawn now
    QTRY_COMPARE(plot_->xAxis().range().high, data_.lastTime());
}

void TestPlotWidget::manyChangesMakeOneRefresh()
{
    const long long before = plot_->refreshes();
    for (int i = 0; i < 1000; ++i) plot_->dataChanged();
    QCOMPARE(plot_->refreshes(), before); // none at once
    QTRY_COMPARE(plot_->refreshes(), before + 1);
}

void TestPlotWidget::plotAreaStandsStill()
{
    const QRectF before = plot_->plotArea();
    PlotWidget other;
    other.resize(700, 150);
    other.setYLabel({"Energy", "nJ", 1e-9, AxisScale::Linear});
    QCOMPARE(other.plotArea().left(), before.left());
    QCOMPARE(other.plotArea().right(), before.right());
    data_.append(std::vector{2e-3}, std::vector{-123.456e-6});
    plot_->refreshNow();
    QCOMPARE(plot_->plotArea(), before);
}

void TestPlotWidget::wheelZoomsAboutThePointer_data()
{
    QTest::addColumn<int>("notches");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<bool>("zoomsX");
    QTest::addColumn<bool>("zoomsY");
    QTest::addRow("in, x") << 1 << int(Qt::NoModifier) << true << false;
    QTest::addRow("out, x") << -1 << int(Qt::NoModifier) << true << false;
    QTest::addRow("in, y with Ctrl") << 1 << int(Qt::ControlModifier) << false << true;
    QTest::addRow("in, both with Shift") << 2 << int(Qt::ShiftModifier) << true << true;
}

// One notch divides the range by 1.25 and leaves the value under the pointer where it is.
void TestPlotWidget::wheelZoomsAboutThePointer()
{
    QFETCH(int, notches);
    QFETCH(int, modifiers);
    QFETCH(bool, zoomsX);
    QFETCH(bool, zoomsY);
    const PlotRange x = plot_->xAxis().range();
    const PlotRange y = plot_->yAxis().range();
    const double atX = 3e-4;
    const double atY = 6e-9;
    const QPointF pointer = plot_->toPixel(atX, atY);
    QSignalSpy changed(plot_.get(), &PlotWidget::viewChanged);
    turnWheel(*plot_, pointer, notches, Qt::KeyboardModifiers(modifiers));
    QCOMPARE(changed.count(), 1);
    const double factor = std::pow(1.25, -notches);
    QVERIFY(close(plot_->xAxis().range().width() / x.width(), zoomsX ? factor : 1.0, 1e-12));
    QVERIFY(close(plot_->yAxis().range().width() / y.width(), zoomsY ? factor : 1.0,
                  1e-2)); // may round where it is automatic
    QCOMPARE(plot_->view().x.has_value(), zoomsX);
    QCOMPARE(plot_->view().y.has_value(), zoomsY);
    QVERIFY(close(plot_->toPixel(atX, atY).x(), pointer.x(), 1e-6));
    if (zoomsY) QVERIFY(close(plot_->toPixel(atX, atY).y(), pointer.y(), 1e-6));
}

void TestPlotWidget::boxZooms()
{
    const QPointF from = plot_->toPixel(2e-4, 4e-9).toPoint();
    const QPointF to = plot_->toPixel(6e-4, 10e-9).toPoint();
    drag(*plot_, Qt::LeftButton, from, to);
    // The mouse counts whole pixels: some 600 px for 1 ms, 240 px for 13 nm.
    QVERIFY(close(plot_->xAxis().range().low, 2e-4, 2e-6));
    QVERIFY(close(plot_->xAxis().range().high, 6e-4, 2e-6));
    QVERIFY(close(plot_->yAxis().range().low, 4e-9, 0.1e-9));
    QVERIFY(close(plot_->yAxis().range().high, 10e-9, 0.1e-9));
    QVERIFY(!plot_->plotCursor(0).has_value()); // a box is no click
}

void TestPlotWidget::flatBoxZoomsOneAxis()
{
    const QPointF from = plot_->toPixel(2e-4, 7e-9).toPoint();
    drag(*plot_, Qt::LeftButton, from, from + QPointF(200.0, 3.0));
    QVERIFY(plot_->view().x.has_value());
    QVERIFY(!plot_->view().y.has_value());
}

void TestPlotWidget::dragMoves()
{
    plot_->setView({PlotRange{2e-4, 6e-4}, std::nullopt});
    plot_->refreshNow();
    const double before = plot_->xAxis().range().low;
    const double pixel = plot_->xAxis().range().width() / plot_->plotArea().width();
    const QPointF from = plot_->plotArea().center();
    drag(*plot_, Qt::MiddleButton, from, from - QPointF(60.0, 0.0));
    QVERIFY(close(plot_->xAxis().range().low, before + 60.0 * pixel, 1.1 * pixel));
    QVERIFY(close(plot_->xAxis().range().width(), 4e-4, 1e-12));
    QVERIFY(!plot_->view().y.has_value());
    QSignalSpy menu(plot_.get(), &PlotWidget::menuRequested);
    drag(*plot_, Qt::RightButton, from, from + QPointF(60.0, 40.0));
    QVERIFY(close(plot_->xAxis().range().low, before, 2.2 * pixel));
    QVERIFY(plot_->view().y.has_value());
    QCOMPARE(menu.count(), 0);
    QTest::mouseClick(plot_.get(), Qt::RightButton, Qt::NoModifier, from.toPoint());
    QCOMPARE(menu.count(), 1);
}

void TestPlotWidget::doubleClickFits()
{
    plot_->setView({PlotRange{2e-4, 3e-4}, PlotRange{6e-9, 7e-9}});
    plot_->refreshNow();
    QSignalSpy changed(plot_.get(), &PlotWidget::viewChanged);
    const QPoint middle = plot_->plotArea().center().toPoint();
    QTest::mouseClick(plot_.get(), Qt::LeftButton, Qt::NoModifier, middle);
    QTest::mouseDClick(plot_.get(), Qt::LeftButton, Qt::NoModifier, middle);
    QCOMPARE(plot_->view(), PlotView());
    QCOMPARE(plot_->xAxis().range(), (PlotRange{0.0, 1e-3}));
    QVERIFY(!plot_->cursorPinned());
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][1].value<PlotWidget::Gesture>(), PlotWidget::Gesture::Fit);
}

void TestPlotWidget::keys()
{
    plot_->setView({PlotRange{2e-4, 4e-4}, std::nullopt});
    QTest::keyClick(plot_.get(), Qt::Key_Right); // a tenth of the width
    QVERIFY(close(plot_->xAxis().range().low, 2.2e-4, 1e-12));
    QTest::keyClick(plot_.get(), Qt::Key_Plus); // about the middle, 3.2e-4: 2e-4 / 1.25 wide
    QVERIFY(close(plot_->xAxis().range().low, 2.4e-4, 1e-12));
    QVERIFY(close(plot_->xAxis().range().high, 4.0e-4, 1e-12));
    QTest::keyClick(plot_.get(), Qt::Key_Home);
    QCOMPARE(plot_->view(), PlotView());
    QSignalSpy history(plot_.get(), &PlotWidget::historyRequested);
    QTest::keyClick(plot_.get(), Qt::Key_Backspace);
    QTest::keyClick(plot_.get(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(history.count(), 2);
    QCOMPARE(history[0][0].toInt(), -1);
    QCOMPARE(history[1][0].toInt(), 1);
    QTest::keyClick(plot_.get(), Qt::Key_L);
    QVERIFY(plot_->yAxis().logarithmic());
}

void TestPlotWidget::cursors()
{
    QSignalSpy moved(plot_.get(), &PlotWidget::cursorMoved);
    const double pixel = 1e-3 / plot_->plotArea().width();
    movePointer(*plot_, plot_->toPixel(3e-4, 7e-9)); // follows the pointer
    QVERIFY(plot_->plotCursor(0).has_value());
    QVERIFY(close(*plot_->plotCursor(0), 3e-4, pixel));
    QTest::mouseClick(plot_.get(), Qt::LeftButton, Qt::NoModifier, plot_->toPixel(4e-4, 7e-9).toPoint());
    QVERIFY(plot_->cursorPinned());
    movePointer(*plot_, plot_->toPixel(8e-4, 7e-9)); // stays where it was pinned
    QVERIFY(close(*plot_->plotCursor(0), 4e-4, pixel));
    QTest::mouseClick(plot_.get(), Qt::LeftButton, Qt::ShiftModifier, plot_->toPixel(6e-4, 7e-9).toPoint());
    QVERIFY(close(*plot_->plotCursor(1), 6e-4, pixel));
    QVERIFY(close(*plot_->plotCursor(0), 4e-4, pixel));
    QVERIFY(moved.count() >= 3);
    QCOMPARE(moved.last()[0].toInt(), 1);
    drag(*plot_, Qt::LeftButton, plot_->toPixel(*plot_->plotCursor(1), 7e-9),
         plot_->toPixel(7e-4, 7e-9)); // taken by its line
    QVERIFY(close(*plot_->plotCursor(1), 7e-4, 1.5 * pixel));
    QCOMPARE(plot_->view(), PlotView());

    // A line from top to bottom in the colour of cursors.
    const QImage image = plot_->grab().toImage();
    const QPointF at = plot_->toPixel(*plot_->plotCursor(0), 7e-9);
    const QRectF column(at.x() - 2.0, plot_->plotArea().top(), 4.0, plot_->plotArea().height());
    QVERIFY(ink(image, column, plot_->theme().cursor) > 0.8 * plot_->plotArea().height());
}

void TestPlotWidget::escapeTakesCursorsAway()
{
    QTest::mouseClick(plot_.get(), Qt::LeftButton, Qt::NoModifier, plot_->toPixel(4e-4, 7e-9).toPoint());
    QTest::mouseClick(plot_.get(), Qt::LeftButton, Qt::ShiftModifier, plot_->toPixel(6e-4, 7e-9).toPoint());
    QTest::keyClick(plot_.get(), Qt::Key_Escape);
    QVERIFY(!plot_->plotCursor(0).has_value());
    QVERIFY(!plot_->plotCursor(1).has_value());
    QVERIFY(!plot_->cursorPinned());
}

void TestPlotWidget::logarithmicHeightWithZeros()
{
    MinMaxPyramid energy;
    energy.append(std::vector{0.0, 2e-4, 4e-4, 6e-4, 1e-3}, std::vector{0.0, 1e-12, 0.0, 1e-9, 1e-10});
    plot_->clearCurves();
    plot_->addCurve({"e", "Energy", {1, 0}, &energy});
    plot_->setYScale(AxisScale::Logarithmic);
    plot_->refreshNow();
    QVERIFY(plot_->yAxis().range().low > 0.0);
    for (const auto& path : plot_->curvePaths())
        for (const QPointF& point : path) QVERIFY(std::isfinite(point.x()) && std::isfinite(point.y()));
    const QImage image = plot_->grab().toImage();
    const QPointF peak = plot_->toPixel(6e-4, 1e-9);
    QVERIFY(ink(image, QRectF(peak - QPointF(6, 6), QSizeF(12, 12)), plot_->theme().colour({1, 0})) >= 6);
    plot_->clearCurves();
}

void TestPlotWidget::referenceLineAndMarks()
{
    plot_->setView({PlotRange{0.0, 1e-3}, PlotRange{0.0, 30e-9}});
    plot_->setReferenceLines({{25e-9, "d_s = 25 nm"}, {99e-9, "outside"}});
    plot_->setEventMarks({{5e-4, "touch-down"}});
    plot_->refreshNow();
    const QImage image = plot_->grab().toImage();
    const QRectF area = plot_->plotArea();
    const QPointF line = plot_->toPixel(5e-4, 25e-9);
    const QRectF row(area.left() + 2.0, line.y() - 1.0, area.width() - 4.0, 2.0);
    QVERIFY(ink(image, row, plot_->theme().referenceLine) > 0.3 * area.width()); // dashed: half of the row
    QVERIFY(area.right() < plot_->width() - 40.0);                               // the margin of the label
    const QRectF label(area.right() + 1.0, line.y() - 8.0, plot_->width() - area.right() - 1.0, 16.0);
    QVERIFY(ink(image, label, plot_->theme().mutedText) > 20);
    const QRectF tick(line.x() - 2.0, area.top(), 4.0, 5.0);
    QVERIFY(ink(image, tick, plot_->theme().referenceLine) >= 3);
}

/// The range follows the curve that leads, or all where all are compared.
void TestPlotWidget::allCurvesCanDecideTheRange()
{
    MinMaxPyramid high, low;
    for (int i = 0; i < 10; ++i) {
        high.append(std::vector{i * 1e-4}, std::vector{9e-9});
        low.append(std::vector{i * 1e-4}, std::vector{1e-9 + 1e-11 * i});
    }
    plot_->clearCurves();
    PlotCurve first{"high", "High", {1, 0}, &high}, second{"low", "Low", {2, 0}, &low};
    first.leads = false;
    plot_->addCurve(first);
    plot_->addCurve(second);
    plot_->setView({});
    plot_->refreshNow();
    QVERIFY(plot_->yAxis().range().high < 5e-9);
    plot_->setAllDecide(true);
    plot_->refreshNow();
    QVERIFY(plot_->yAxis().range().contains(9e-9) && plot_->yAxis().range().contains(1e-9));
    plot_->setAllDecide(false);
    plot_->refreshNow();
    QVERIFY(plot_->yAxis().range().high < 5e-9);
    plot_->clearCurves();
}

void TestPlotWidget::followsThePalette()
{
    QPalette dark;
    dark.setColor(QPalette::Base, QColor("#1d2024"));
    dark.setColor(QPalette::Text, QColor("#eef1f4"));
    plot_->setPalette(dark);
    plot_->refreshNow();
    const QImage image = plot_->grab().toImage();
    QCOMPARE(image.pixelColor(2, 2), QColor("#1d2024"));
    QVERIFY(ink(image, plot_->plotArea(), plotTheme(dark).curves[0]) > 500);
}

void TestPlotWidget::rangesFollowTheCurveThatLeads()
{
    MinMaxPyramid far;
    far.append(std::vector{0.0, 4e-3}, std::vector{4000e-9, 0.0});
    PlotCurve pale{"far", "Far", {1, 0}, &far};
    pale.pale = true;
    pale.leads = false;
    plot_->addCurve(pale);
    plot_->refreshNow();
    QCOMPARE(plot_->xAxis().range(), (PlotRange{0.0, 1e-3}));
    QVERIFY(plot_->yAxis().range().high < 14e-9);
    plot_->setEverything(true);
    plot_->refreshNow();
    QCOMPARE(plot_->xAxis().range(), (PlotRange{0.0, 4e-3}));
    QVERIFY(plot_->yAxis().range().high >= 4000e-9);
    // A new run without a sample changes nothing yet.
    plot_->setEverything(false);
    plot_->refreshNow();
    MinMaxPyramid none;
    plot_->updateCurves([](PlotCurve& curve) { curve.leads = false; });
    plot_->addCurve({"new", "New", {2, 0}, &none});
    plot_->refreshNow();
    QCOMPARE(plot_->xAxis().range(), (PlotRange{0.0, 1e-3}));
    QVERIFY(plot_->yAxis().range().high < 14e-9);
}

void TestPlotWidget::aRangeGrowsInHalvesOfTheWay()
{
    MinMaxPyramid growing;
    PlotCurve curve{"run", "Run 1", {0, 0}, &growing};
    curve.end = 2e-3;
    plot_->addCurve(curve);
    growing.append(std::vector{0.0, 0.3e-3}, std::vector{1e-9, 2e-9});
    QCOMPARE(plot_->dataRangeX()->high, 0.5e-3);
    growing.append(std::vector{0.6e-3}, std::vector{1e-9});
    QCOMPARE(plot_->dataRangeX()->high, 1e-3);
    growing.append(std::vector{1.9e-3}, std::vector{1e-9});
    QCOMPARE(plot_->dataRangeX()->high, 2e-3);
    plot_->updateCurves([](PlotCurve& each) { each.end.reset(); });
    QCOMPARE(plot_->dataRangeX()->high, 1.9e-3);
}

void TestPlotWidget::theLegendNamesTheNewestFirst()
{
    plot_->addCurve({"second", "Run 2", {1, 0}, &data_});
    plot_->addCurve({"third", "Run 3", {2, 0}, &data_});
    const auto raise = [this](const QString& id) {
        plot_->updateCurves([&id](PlotCurve& curve) {
            curve.pale = curve.id != id;
            curve.leads = curve.id == "third";
        });
    };
    const auto names = [this] {
        QStringList list;
        for (const LegendEntry& entry : PlotPainter(*plot_, plot_->theme()).legend().entries) list << entry.text;
        return list;
    };
    raise("third");
    QCOMPARE(names(), (QStringList{"Run 3", "Run 2", "Run 1"}));
    raise("first"); // the entry under the pointer keeps its place
    QCOMPARE(names(), (QStringList{"Run 3", "Run 2", "Run 1"}));
    // Without room the oldest are left out.
    plot_->resize(300, 300);
    const Legend narrow = PlotPainter(*plot_, plot_->theme()).legend();
    QVERIFY(narrow.more > 0 && narrow.entries.size() + narrow.more == 3);
}

void TestPlotWidget::theLegendIsUnderThePointer()
{
    plot_->addCurve({"second", "Run 2", {1, 0}, &data_});
    QSignalSpy hovered(plot_.get(), &PlotWidget::legendHovered);
    const Legend legend = PlotPainter(*plot_, plot_->theme()).legend();
    movePointer(*plot_, legend.entries[1].box.center());
    QCOMPARE(hovered.count(), 1);
    QCOMPARE(hovered.last()[0].toString(), legend.entries[1].curve->id);
    movePointer(*plot_, legend.entries[0].box.center());
    QCOMPARE(hovered.last()[0].toString(), legend.entries[0].curve->id);
    movePointer(*plot_, plot_->plotArea().center());
    QCOMPARE(hovered.count(), 3);
    QCOMPARE(hovered.last()[0].toString(), QString());
}

void TestPlotWidget::oneCurveIsWideBesidePaleOnes()
{
    PlotCurve curve{"second", "Run 2", {1, 0}, &data_};
    curve.pale = true;
    const std::vector<QPointF> path{{0.0, 0.0}, {1.0, 1.0}};
    const QSizeF size(600.0, 200.0);
    const PlotTheme theme = lightPlotTheme();
    QCOMPARE(pathPen(curve, path, size, theme).color(), theme.paleColour({1, 0}));
    curve.pale = false;
    QVERIFY(pathPen(curve, path, size, theme, true).widthF() > pathPen(curve, path, size, theme).widthF());
}

TOUCHDOWN_TEST(TestPlotWidget)

} // namespace test_plot_widget

#include "test_plot_widget.moc"
