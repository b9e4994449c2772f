// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_table.h"
#include "ui/plot/plot_group.h"

#include <cmath>
#include <memory>

#include <QClipboard>
#include <QGuiApplication>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"

using namespace touchdown;

namespace test_plot_group {

void turnWheel(PlotWidget& plot, double x, int notches)
{
    const QPointF at(plot.toPixel(x, 0.0).x(), plot.plotArea().center().y());
    QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&plot, &event);
}

class TestPlotGroup : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void cleanup();

    void zoomingOneZoomsAll();
    void heightIsEachPlotsOwn();
    void followsTheWholeRun();
    void zoomingFreezes();
    void historyBackAndForth();
    void wheelNotchesAreOneStep();
    void historyRestoresHeightOfAnotherPlot();
    void cursorRunsThroughAll();
    void readingsAtTheCursors();
    void tableShowsDifferences();
    void aPlotMayGo();
    void phasePortraitKeepsItsAxes();
    void beginsWithAFirstRange();
    void followsUntilTheFirstRangeIsReached();
    void everythingUntilANewRunBegins();
    void labelsOfLinesKeepAxesAligned();

private:
    /// Samples up to 1 ms at a time: spacing = 10 nm + t * 1 um/s, pitch = 100 urad - t * 10 mrad/s.
    void run(int milliseconds);
    /// As by a box drawn in the upper plot.
    void zoomTo(const PlotRange& range);

    MinMaxPyramid spacing_;
    MinMaxPyramid pitch_;
    std::unique_ptr<PlotGroup> group_;
    std::unique_ptr<PlotWidget> upper_;
    std::unique_ptr<PlotWidget> lower_;
};

void TestPlotGroup::init()
{
    spacing_ = MinMaxPyramid();
    pitch_ = MinMaxPyramid();
    group_ = std::make_unique<PlotGroup>();
    const auto make = [this](const QString& title, const AxisLabel& label, const MinMaxPyramid& data) {
        auto plot = std::make_unique<PlotWidget>();
        plot->resize(600, 200);
        plot->setTitle(title);
        plot->setXLabel({"Time", "ms", 1e-3, AxisScale::Linear});
        plot->setYLabel(label);
        plot->addCurve({title.toLower(), title, {0, 0}, &data});
        group_->add(plot.get());
        plot->show();
        return plot;
    };
    run(1);
    upper_ = make("Spacing", {"Spacing", "nm", 1e-9, AxisScale::Linear}, spacing_);
    lower_ = make("Pitch", {"Pitch", "urad", 1e-6, AxisScale::Linear}, pitch_);
    QVERIFY(QTest::qWaitForWindowExposed(lower_.get()));
    group_->dataChanged();
    group_->forgetHistory();
}

void TestPlotGroup::cleanup()
{
    upper_.reset();
    lower_.reset();
    group_.reset();
}

void TestPlotGroup::run(int milliseconds)
{
    const double start = spacing_.empty() ? 0.0 : spacing_.lastTime();
    for (int i = spacing_.empty() ? 0 : 1; i <= 1000 * milliseconds; ++i) {
        const double t = start + 1e-6 * i;
        spacing_.append(std::vector{t}, std::vector{10e-9 + 1e-6 * t});
        pitch_.append(std::vector{t}, std::vector{100e-6 - 1e-2 * t});
    }
    if (group_) group_->dataChanged();
}

void TestPlotGroup::zoomTo(const PlotRange& range)
{
    upper_->setView({range, upper_->view().y});
    emit upper_->viewChanged(upper_->view(), PlotWidget::Gesture::Box);
}

void TestPlotGroup::zoomingOneZoomsAll()
{
    turnWheel(*lower_, 5e-4, 2);
    const PlotRange range = lower_->xAxis().range();
    QVERIFY(std::abs(range.width() - 1e-3 / 1.5625) < 1e-9); // 1.25 squared
    QCOMPARE(upper_->xAxis().range(), range);
    // Equal margins: one time stands above the other.
    QCOMPARE(upper_->toPixel(5e-4, 0.0).x(), lower_->toPixel(5e-4, 0.0).x());
}

void TestPlotGroup::heightIsEachPlotsOwn()
{
    QTest::keyClick(upper_.get(), Qt::Key_Plus, Qt::ControlModifier);
    QVERIFY(upper_->view().y.has_value());
    QVERIFY(!lower_->view().y.has_value());
    QCOMPARE(group_->follow(), PlotGroup::Follow::WholeRun); // time was not touched
}

void TestPlotGroup::followsTheWholeRun()
{
    QCOMPARE(lower_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    run(2);
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    QVERIFY(spacing_.lastTime() > 2.9e-3);
}

void TestPlotGroup::zoomingFreezes()
{
    QSignalSpy follow(group_.get(), &PlotGroup::followChanged);
    turnWheel(*upper_, 5e-4, 1);
    QCOMPARE(group_->follow(), PlotGroup::Follow::Frozen);
    QCOMPARE(follow.count(), 1);
    const PlotRange frozen = upper_->xAxis().range();
    run(1);
    QCOMPARE(upper_->xAxis().range(), frozen);
    QTest::keyClick(upper_.get(), Qt::Key_Home); // follows again
    QCOMPARE(group_->follow(), PlotGroup::Follow::WholeRun);
    QCOMPARE(lower_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
}

void TestPlotGroup::historyBackAndForth()
{
    const PlotRange first{1e-4, 4e-4};
    const PlotRange second{2e-4, 3e-4};
    QVERIFY(!group_->canGoBack());
    zoomTo(first);
    zoomTo(second);
    QTest::keyClick(lower_.get(), Qt::Key_Backspace);
    QCOMPARE(upper_->xAxis().range(), first);
    group_->goBack();
    QCOMPARE(group_->follow(), PlotGroup::Follow::WholeRun);
    QVERIFY(!group_->canGoBack());
    group_->goForward();
    QTest::keyClick(upper_.get(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(lower_->xAxis().range(), second);
    QVERIFY(!group_->canGoForward());
    group_->goBack();
    zoomTo({5e-4, 6e-4}); // a new step cuts what lay ahead
    QVERIFY(!group_->canGoForward());
    group_->goBack();
    QCOMPARE(upper_->xAxis().range(), first);
}

void TestPlotGroup::wheelNotchesAreOneStep()
{
    for (int i = 0; i < 5; ++i) turnWheel(*upper_, 5e-4, 1);
    QVERIFY(upper_->xAxis().range().width() < 4e-4);
    group_->goBack();
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    QVERIFY(!group_->canGoBack());
}

void TestPlotGroup::historyRestoresHeightOfAnotherPlot()
{
    lower_->setView({lower_->view().x, PlotRange{9e-5, 1e-4}});
    group_->forgetHistory();
    QTest::keyClick(lower_.get(), Qt::Key_Up);
    QVERIFY(lower_->view().y->low > 9.05e-5);
    turnWheel(*upper_, 5e-4, 1);
    group_->goBack();
    group_->goBack();
    QCOMPARE(lower_->view().y, std::optional(PlotRange{9e-5, 1e-4}));
}

void TestPlotGroup::cursorRunsThroughAll()
{
    QSignalSpy moved(group_.get(), &PlotGroup::cursorMoved);
    const QPoint at(upper_->toPixel(3e-4, 0.0).toPoint().x(), upper_->plotArea().center().toPoint().y());
    QTest::mouseClick(upper_.get(), Qt::LeftButton, Qt::NoModifier, at);
    QCOMPARE(moved.count(), 1);
    QVERIFY(group_->cursor(0).has_value());
    QCOMPARE(lower_->plotCursor(0), group_->cursor(0));
    QVERIFY(std::abs(*group_->cursor(0) - 3e-4) < 2e-6); // a pixel
    QVERIFY(lower_->cursorPinned());
    QTest::keyClick(lower_.get(), Qt::Key_Escape);
    QVERIFY(!upper_->plotCursor(0).has_value());
    QVERIFY(!upper_->cursorPinned());
}

void TestPlotGroup::readingsAtTheCursors()
{
    group_->setCursor(0, 2e-4);
    group_->setCursor(1, 7e-4);
    const auto readings = group_->readings();
    QCOMPARE(readings.size(), std::size_t(2));
    QCOMPARE(readings[0].name, QStringLiteral("Spacing"));
    QVERIFY(std::abs(*readings[0].first - 10.2e-9) < 1e-15); // 10 nm + 0.2 ms * 1 um/s
    QVERIFY(std::abs(*readings[0].second - 10.7e-9) < 1e-15);
    QVERIFY(std::abs(*readings[1].first - 98e-6) < 1e-12); // 100 urad - 0.2 ms * 10 mrad/s
    group_->setCursor(1, 99.0);                            // beyond the data
    QVERIFY(!group_->readings()[0].second.has_value());
    upper_->setCurveVisible("spacing", false);
    QCOMPARE(group_->readings().size(), std::size_t(1));
}

void TestPlotGroup::tableShowsDifferences()
{
    CursorTable table(group_.get());
    table.show();
    const auto* times = namedWidget<QLabel>(table, QStringLiteral("Times of the cursors"));
    group_->setCursor(0, 2e-4);
    group_->setCursor(1, 7e-4);
    // 1 / 0.5 ms = 2 kHz, with a space that does not break.
    QTRY_VERIFY2(times->text().simplified().contains("= 2.000 kHz"), qPrintable(times->text()));
    QVERIFY(times->text().simplified().contains("= 0.500 ms"));
    QCOMPARE(table.table()->rowCount(), 2);
    QCOMPARE(table.table()->item(0, 0)->text(), QStringLiteral("Spacing [nm]"));
    QCOMPARE(table.table()->item(0, 1)->text().toDouble(), 10.2);
    QCOMPARE(table.table()->item(0, 3)->text().toDouble(), 0.5);
    QVERIFY(table.table()->item(1, 3)->text().startsWith(QChar(0x2212))); // pitch falls by 5 urad
    QFont large = table.font();
    large.setPointSize(2 * large.pointSize());
    table.setFont(large);
    QTRY_VERIFY(table.table()->rowHeight(0) >= QFontMetrics(large).height());
    QTest::keyClick(table.table(), Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
    QCOMPARE(lines.size(), 6); // header, times, frequency, two rows, the end
    QCOMPARE(lines[4].split('\t')[3].toDouble(), -5.0);
}

void TestPlotGroup::aPlotMayGo()
{
    lower_.reset();
    QCOMPARE(group_->plots().size(), std::size_t(1));
    zoomTo({1e-4, 2e-4});
    group_->setCursor(0, 1.5e-4);
    QCOMPARE(upper_->xAxis().range(), (PlotRange{1e-4, 2e-4}));
    group_->goBack();
    group_->remove(upper_.get());
    turnWheel(*upper_, 5e-4, 1); // no longer of this group
    QCOMPARE(group_->follow(), PlotGroup::Follow::WholeRun);
    QVERIFY(group_->readings().empty());
}

void TestPlotGroup::phasePortraitKeepsItsAxes()
{
    PlotWidget phase;
    phase.resize(300, 300);
    phase.setXLabel({"Pitch", "urad", 1e-6, AxisScale::Linear});
    phase.addCurve({"p", "Run 1", {0, 0}, &spacing_, &pitch_});
    group_->add(&phase);
    phase.show();
    QVERIFY(QTest::qWaitForWindowExposed(&phase));
    phase.refreshNow();
    QVERIFY(phase.xAxis().range().contains(90e-6) && phase.xAxis().range().contains(100e-6)); // pitch, not time
    zoomTo({2e-4, 3e-4}); // 97 to 98 urad within that time
    phase.refreshNow();
    QVERIFY(phase.xAxis().range().low > 96e-6 && phase.xAxis().range().high < 99e-6);
    const PlotRange time = upper_->xAxis().range();
    QTest::keyClick(&phase, Qt::Key_Plus);
    QCOMPARE(upper_->xAxis().range(), time); // zooming pitch does not zoom time
    QVERIFY(phase.view().x.has_value());
    group_->goBack();
    QVERIFY(!phase.view().x.has_value());
}

void TestPlotGroup::beginsWithAFirstRange()
{
    run(1); // 2 ms
    group_->setFirstRange(PlotRange{0.0, 0.3e-3});
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
    QCOMPARE(group_->follow(), PlotGroup::Follow::WholeRun);
    run(1);
    QCOMPARE(lower_->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
    group_->fit(); // everything
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    group_->goBack();
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
    group_->goForward();
    group_->followNewest(); // the user wanted the whole run: so is the next one
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    // A zoom of the user stays.
    zoomTo({1e-4, 4e-4});
    group_->setFirstRange(PlotRange{0.0, 0.3e-3});
    group_->followNewest();
    QCOMPARE(lower_->xAxis().range(), (PlotRange{1e-4, 4e-4}));
}

/// A range that begins later than the data end would be empty: all of them are shown until they reach it.
void TestPlotGroup::followsUntilTheFirstRangeIsReached()
{
    const double now = spacing_.lastTime();
    const PlotRange wanted{now + 1.5e-3, now + 4e-3};
    group_->setFirstRange(wanted);
    run(1);
    QVERIFY(spacing_.lastTime() < wanted.low);
    QCOMPARE(upper_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    run(2);
    QVERIFY(spacing_.lastTime() > wanted.low);
    QCOMPARE(upper_->xAxis().range(), wanted);
}

void TestPlotGroup::everythingUntilANewRunBegins()
{
    MinMaxPyramid earlier;
    earlier.append(std::vector{0.0, 5e-3}, std::vector{1e-6, 1e-6});
    PlotCurve curve{"earlier", "Earlier", {1, 0}, &earlier};
    curve.leads = false;
    curve.pale = true;
    upper_->addCurve(curve);
    group_->dataChanged();
    QCOMPARE(lower_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    QTest::keyClick(upper_.get(), Qt::Key_Home);
    QCOMPARE(lower_->xAxis().range(), (PlotRange{0.0, 5e-3}));
    upper_->refreshNow();
    QVERIFY(upper_->yAxis().range().high >= 1e-6);
    group_->followNewest();
    QCOMPARE(lower_->xAxis().range(), (PlotRange{0.0, spacing_.lastTime()}));
    upper_->refreshNow();
    QVERIFY(upper_->yAxis().range().high < 1e-7);
    upper_->removeCurve("earlier");
}

/// Labels of one plot take their room from all plots over time, as long as it is shown.
void TestPlotGroup::labelsOfLinesKeepAxesAligned()
{
    const QRectF before = lower_->plotArea();
    upper_->setReferenceLines({{11e-9, QStringLiteral("take-off height"), false}});
    QVERIFY(upper_->plotArea().right() < before.right() - 20.0);
    QCOMPARE(lower_->plotArea().right(), upper_->plotArea().right());
    PlotWidget late; // than the labels
    late.resize(upper_->size());
    group_->add(&late);
    QCOMPARE(late.plotArea().right(), upper_->plotArea().right());
    group_->remove(&late);
    QCOMPARE(late.plotArea().right(), before.right());
    upper_->hide();
    QCOMPARE(lower_->plotArea(), before);
    upper_->show();
    QCOMPARE(lower_->plotArea().right(), upper_->plotArea().right());
    upper_->setReferenceLines({});
    QCOMPARE(lower_->plotArea(), before);
}

TOUCHDOWN_TEST(TestPlotGroup)

} // namespace test_plot_group

#include "test_plot_group.moc"
