// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/spectrum_view.h"

#include <cmath>
#include <limits>
#include <memory>

#include <QLocale>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spectrum_view {

/// 0 to 500 kHz in steps of 1 kHz: a floor of 1e-24 with peaks of 1e-18 at 42 kHz and 1e-20 at 152 kHz, and some bad
/// values.
Spectrum sample()
{
    Spectrum spectrum;
    for (int i = 0; i <= 500; ++i) {
        spectrum.frequency.push_back(1e3 * i);
        spectrum.power.push_back(i == 42 ? 1e-18 : i == 152 ? 1e-20 : 1e-24);
    }
    spectrum.power[0] = 0.0;
    spectrum.power[7] = -1e-24;
    spectrum.power[9] = std::numeric_limits<double>::quiet_NaN();
    return spectrum;
}

class TestSpectrumView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void cleanup() { view_.reset(); }

    void beginsWithTheUsualOptions();
    void choicesAreRequested();
    void settingEmitsNothing();
    void badValuesStayAway();
    void peaksAreLabelledInKilohertz();
    void theHighestPeakHasRoomForItsLabel();
    void unitsFollowQuantityAndScaling();
    void logarithmicFrequency();
    void endsAboveTheLastPeak();
    void marksThePeaksOfTheSpectrumThatLeads();
    void otherUnitsClear();
    void spectraComeAndGo();
    void clicksSetBothCursorsAtPeaks();
    void controlFreesTheCursor();
    void keysMoveTheCursorByAPixel();
    void offersLinesOfTheCase();
    void controlsHaveNames();
    void noChoiceIsCut();

private:
    template <typename Widget>
    Widget* field(const QString& name) const
    {
        for (Widget* widget : view_->findChildren<Widget*>())
            if (widget->accessibleName() == name) return widget;
        return nullptr;
    }

    QPoint pixel(double frequency, int beside) const
    {
        const PlotWidget* plot = view_->plot();
        return {static_cast<int>(std::lround(plot->toPixel(frequency, 1e-22).x())) + beside,
                static_cast<int>(plot->plotArea().center().y())};
    }

    std::unique_ptr<SpectrumView> view_;
};

void TestSpectrumView::init()
{
    view_ = std::make_unique<SpectrumView>();
    view_->resize(760, 400);
    view_->setQuantities({{"flying_height", "m", "nm", "Flying height"}, {"pitch", "rad", "urad", "Pitch"}});
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void TestSpectrumView::beginsWithTheUsualOptions()
{
    const WelchOptions expected;
    QCOMPARE(view_->options().segment, expected.segment);
    QCOMPARE(view_->options().overlap, expected.overlap);
    QCOMPARE(view_->options().window, expected.window);
    QCOMPARE(view_->options().scaling, expected.scaling);
    QCOMPARE(view_->quantity(), QStringLiteral("flying_height"));
}

void TestSpectrumView::choicesAreRequested()
{
    QSignalSpy requested(view_.get(), &SpectrumView::requested);
    QTest::keyClick(field<QComboBox>("Quantity"), Qt::Key_Down);
    QCOMPARE(requested.count(), 1);
    QCOMPARE(requested.last()[0].toString(), QStringLiteral("pitch"));
    QTest::keyClick(field<QComboBox>("Segment"), Qt::Key_Down);
    QCOMPARE(requested.last()[1].value<WelchOptions>().segment, std::size_t(4096));
    QTest::keyClick(field<QComboBox>("Window"), Qt::Key_Down);
    QCOMPARE(requested.last()[1].value<WelchOptions>().window, SpectrumWindow::Hamming);
    QTest::keyClick(field<QSpinBox>("Overlap"), Qt::Key_Up); // by 5 %
    QCOMPARE(requested.last()[1].value<WelchOptions>().overlap, 0.55);
    QTest::keyClick(field<QComboBox>("Scaling"), Qt::Key_Down);
    QCOMPARE(requested.last()[1].value<WelchOptions>().scaling, SpectrumScaling::Amplitude);
    QCOMPARE(requested.count(), 5);
}

void TestSpectrumView::settingEmitsNothing()
{
    QSignalSpy requested(view_.get(), &SpectrumView::requested);
    WelchOptions options;
    options.segment = 3000; // none of the offered ones
    options.overlap = 0.75;
    options.window = SpectrumWindow::FlatTop;
    view_->setOptions(options);
    view_->setQuantity("pitch");
    view_->setQuantities({{"pitch", "rad", "urad", "Pitch"}});
    QCOMPARE(requested.count(), 0);
    QCOMPARE(view_->options().segment, std::size_t(3000));
    QCOMPARE(view_->options().overlap, 0.75);
    QCOMPARE(view_->options().window, SpectrumWindow::FlatTop);
    QCOMPARE(view_->quantity(), QStringLiteral("pitch")); // still there, still chosen
}

void TestSpectrumView::badValuesStayAway()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample());
    PlotWidget* plot = view_->plot();
    plot->refreshNow();
    QVERIFY(plot->yAxis().logarithmic());
    QCOMPARE(plot->curves()[0].data->size(), std::size_t(498)); // 501 without the zero, the negative one and the NaN
    QVERIFY(plot->yAxis().range().low > 1e-26 && plot->yAxis().range().low < 1e-24);
    QVERIFY(plot->yAxis().range().high > 1e-18);
    const auto paths = plot->curvePaths();
    QCOMPARE(paths.size(), std::size_t(1));
    for (const QPointF& point : paths[0]) QVERIFY(std::isfinite(point.y()) && point.y() > 0.0);
}

void TestSpectrumView::peaksAreLabelledInKilohertz()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42.3e3, 1e-9}, {152.4e3, 1e-10}, {9e9, 1.0}});
    const auto& marks = view_->plot()->pointMarks();
    QCOMPARE(marks.size(), std::size_t(2)); // the third lies beyond the spectrum
    QCOMPARE(marks[0].label, QStringLiteral("42.30 kHz"));
    QCOMPARE(marks[0].y, 1e-18); // on the top of the line
    QCOMPARE(marks[1].label, QStringLiteral("152.4 kHz"));
    QCOMPARE(marks[1].y, 1e-20);
}

/// The curve reaches almost to the plot's upper edge: what stands above it there would be cut off.
void TestSpectrumView::theHighestPeakHasRoomForItsLabel()
{
    PlotWidget* plot = view_->plot();
    for (const int height : {160, 200, 300, 600}) {
        view_->resize(700, height);
        view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42.3e3, 1e-9}});
        plot->refreshNow();
        const QImage labelled = plot->grab().toImage();
        std::vector<PointMark> marks = plot->pointMarks();
        marks[0].label.clear();
        plot->setPointMarks(std::move(marks));
        QVERIFY2(plot->grab().toImage() != labelled, qPrintable(QStringLiteral("%1 px").arg(height)));
    }
}

void TestSpectrumView::unitsFollowQuantityAndScaling()
{
    QCOMPARE(view_->plot()->yAxis().text(), QStringLiteral("Density [nm\u00b2/Hz]"));
    QVERIFY(std::abs(view_->plot()->yAxis().label.factor - 1e-18) < 1e-30);
    WelchOptions options;
    options.scaling = SpectrumScaling::Amplitude;
    view_->setOptions(options);
    view_->setQuantity("pitch");
    QCOMPARE(view_->plot()->yAxis().text(), QStringLiteral("Power [\u00b5rad\u00b2]"));
    QVERIFY(view_->plot()->title().contains("Pitch"));
}

void TestSpectrumView::logarithmicFrequency()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample());
    QTest::mouseClick(view_->findChild<QCheckBox*>(), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    PlotWidget* plot = view_->plot();
    plot->refreshNow();
    QVERIFY(plot->xAxis().logarithmic());
    QCOMPARE(plot->xAxis().range().low, 1e3); // the first frequency above zero
    QCOMPARE(plot->xAxis().range().high, 500e3);
    QVERIFY(plot->curvePaths()[0].size() > 100);
}

void TestSpectrumView::endsAboveTheLastPeak()
{
    PlotWidget* plot = view_->plot();
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42.3e3, 1e-9}, {152.4e3, 1e-10}});
    QCOMPARE(plot->xAxis().range(), (PlotRange{0.0, 200e3})); // 1.25 * 152.4 kHz, rounded up
    QTest::keyClick(plot, Qt::Key_Home);
    QCOMPARE(plot->xAxis().range(), (PlotRange{1e3, 500e3})); // from the first sample with power on
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42.3e3, 1e-9}, {152.4e3, 1e-10}});
    QCOMPARE(plot->xAxis().range(), (PlotRange{1e3, 500e3})); // as the user wanted
    view_->group()->followNewest();
    QCOMPARE(plot->xAxis().range(), (PlotRange{0.0, 200e3}));
    // While its run goes on, a peak that is not found for a moment does not make the axis shorter.
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42.3e3, 1e-9}});
    QCOMPARE(plot->xAxis().range(), (PlotRange{0.0, 200e3}));
    view_->setSpectrum("1", "Run 1", {0, 0}, sample());
    QCOMPARE(plot->xAxis().range(), (PlotRange{0.0, 200e3}));
    view_->updateCurves([](PlotCurve& curve) { curve.still = true; });
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42.3e3, 1e-9}});
    QCOMPARE(plot->xAxis().range(), (PlotRange{0.0, 60e3}));
    // A faint peak has its mark, and does not widen the axis: 49 and 51 dB below the highest.
    for (const auto& [power, end] : {std::pair{1.2e-23, 400e3}, std::pair{0.8e-23, 200e3}}) {
        Spectrum faint = sample();
        faint.power[300] = power;
        view_->setSpectrum("1", "Run 1", {0, 0}, faint, {{42.3e3, 1e-9}, {152.4e3, 1e-10}, {300e3, 1e-12}});
        QCOMPARE(plot->xAxis().range(), (PlotRange{0.0, end}));
        QCOMPARE(plot->pointMarks().size(), std::size_t(3));
    }
    view_->setSpectrum("1", "Run 1", {0, 0}, sample()); // no peak: all of it
    QCOMPARE(plot->xAxis().range(), (PlotRange{1e3, 500e3}));
}

void TestSpectrumView::marksThePeaksOfTheSpectrumThatLeads()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42e3, 1e-9}});
    view_->setSpectrum("2", "Run 2", {1, 0}, sample(), {{152e3, 1e-10}});
    view_->updateCurves([](PlotCurve& curve) {
        curve.still = true; // the runs have ended
        curve.leads = curve.id == "1";
    });
    QCOMPARE(view_->plot()->pointMarks().size(), std::size_t(1));
    QCOMPARE(view_->plot()->pointMarks()[0].label, QStringLiteral("42.00 kHz"));
    QCOMPARE(view_->plot()->xAxis().range(), (PlotRange{0.0, 60e3}));
    view_->updateCurves([](PlotCurve& curve) { curve.leads = curve.id == "2"; });
    QCOMPARE(view_->plot()->pointMarks()[0].label, QStringLiteral("152.0 kHz"));
    QCOMPARE(view_->plot()->xAxis().range(), (PlotRange{0.0, 200e3}));
}

void TestSpectrumView::otherUnitsClear()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample());
    QTest::keyClick(field<QComboBox>("Window"), Qt::Key_Down);
    QCOMPARE(view_->plot()->curves().size(), std::size_t(1)); // the same unit: stays until the new one comes
    QTest::keyClick(field<QComboBox>("Quantity"), Qt::Key_Down);
    QVERIFY(view_->plot()->curves().empty());
}

void TestSpectrumView::spectraComeAndGo()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42e3, 1.0}});
    view_->setSpectrum("2", "Run 2", {1, 1}, sample(), {{152e3, 1.0}});
    view_->setSpectrum("1", "Run 1 anew", {0, 0}, sample());
    QCOMPARE(view_->plot()->curves().size(), std::size_t(2));
    QCOMPARE(view_->plot()->curves()[0].name, QStringLiteral("Run 1 anew"));
    QCOMPARE(view_->plot()->pointMarks().size(), std::size_t(1));
    view_->removeSpectrum("2");
    QCOMPARE(view_->plot()->curves().size(), std::size_t(1));
    QVERIFY(view_->plot()->pointMarks().empty());
    view_->clear();
    QVERIFY(view_->plot()->curves().empty());
    view_->setSpectrum("3", "Empty", {0, 0}, Spectrum{});
    view_->plot()->refreshNow();
    QVERIFY(view_->plot()->curvePaths()[0].empty());
}

/// Within 8 pixels; a cursor farther away stays where it was set.
void TestSpectrumView::clicksSetBothCursorsAtPeaks()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42e3, 1e-9}, {152e3, 1e-10}});
    PlotWidget* plot = view_->plot();
    plot->refreshNow();
    QTest::mouseMove(plot, pixel(42e3, -5));
    QTRY_COMPARE(view_->group()->cursor(0), std::optional(42e3)); // it follows the pointer
    QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, pixel(42e3, 6));
    QTest::mouseClick(plot, Qt::LeftButton, Qt::ShiftModifier, pixel(152e3, -6));
    QCOMPARE(view_->group()->cursor(0), std::optional(42e3));
    QCOMPARE(view_->group()->cursor(1), std::optional(152e3));
    QVERIFY(plot->cursorPinned());
    QTest::mouseClick(plot, Qt::LeftButton, Qt::ShiftModifier, pixel(152e3, -10));
    QVERIFY(*view_->group()->cursor(1) < 151e3);
    QTest::keyClick(plot, Qt::Key_Escape);
    QVERIFY(!view_->group()->hasCursors());
}

void TestSpectrumView::controlFreesTheCursor()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42e3, 1e-9}, {152e3, 1e-10}});
    PlotWidget* plot = view_->plot();
    plot->refreshNow();
    QTest::mouseClick(plot, Qt::LeftButton, Qt::ControlModifier, pixel(42e3, 6));
    QTest::mouseClick(plot, Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier, pixel(152e3, -6));
    for (const auto& [which, peak] : {std::pair(0, 42e3), std::pair(1, 152e3)}) {
        const double away = plot->toPixel(*view_->group()->cursor(which), 1e-22).x() - plot->toPixel(peak, 1e-22).x();
        QVERIFY(std::abs(away - (which == 0 ? 6.0 : -6.0)) <= 1.0);
    }
}

void TestSpectrumView::keysMoveTheCursorByAPixel()
{
    view_->setSpectrum("1", "Run 1", {0, 0}, sample(), {{42e3, 1e-9}, {152e3, 1e-10}});
    PlotWidget* plot = view_->plot();
    plot->refreshNow();
    view_->group()->setCursor(0, 42e3);
    const double pixelWidth = plot->xAxis().range().width() / plot->plotArea().width();
    QTest::keyClick(plot, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(std::abs(*view_->group()->cursor(0) - 42e3 - pixelWidth) < 1e-3); // no peak holds it
    QTest::keyClick(plot, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(*view_->group()->cursor(0) - 42e3) < 1e-3);
}

void TestSpectrumView::offersLinesOfTheCase()
{
    PlotWidget* plot = view_->plot();
    view_->setSpectrum("1", "Run 1", {0, 0}, sample());
    QVERIFY(plot->actions().isEmpty()); // no case
    view_->setReferences({{FrequencyKind::Mode, 98.3e3, "mode 1"},
                          {FrequencyKind::Mode, 201e3, "mode 2"},
                          {FrequencyKind::Contact, 281.25e3, "contact"}});
    QCOMPARE(plot->actions(),
             (QList<QAction*>{view_->linesWanted(FrequencyKind::Mode), view_->linesWanted(FrequencyKind::Contact)}));
    QVERIFY(plot->referenceLines().empty()); // only on request
    view_->linesWanted(FrequencyKind::Mode)->trigger();
    QCOMPARE(plot->referenceLines().size(), std::size_t(2));
    QCOMPARE(plot->referenceLines()[0].label, QStringLiteral("mode 1 98.30\u00a0kHz"));
    QVERIFY(plot->referenceLines()[0].upright);
    view_->linesWanted(FrequencyKind::Contact)->trigger();
    QCOMPARE(plot->referenceLines().size(), std::size_t(3));
    QCOMPARE(plot->referenceLines()[2].value, 281.25e3);
    plot->refreshNow();
    const QImage with = plot->grab().toImage();
    view_->setReferences({{FrequencyKind::Wave, 50e3, "wave"}}); // another case: the choice stays
    QVERIFY(plot->referenceLines().empty());
    QCOMPARE(plot->actions(), QList<QAction*>{view_->linesWanted(FrequencyKind::Wave)});
    view_->linesWanted(FrequencyKind::Wave)->setChecked(false);
    plot->setReferenceLines({{-1.0, QStringLiteral("none"), true}}); // the labels need as much room as before
    const QImage without = plot->grab().toImage();
    // Each line changes a column of pixels, half of them as it is dashed.
    for (const double frequency : {98.3e3, 201e3, 281.25e3}) {
        const QRectF area = plot->plotArea();
        const double ratio = with.devicePixelRatio();
        const int column = static_cast<int>(ratio * std::floor(plot->toPixel(frequency, 1e-22).x()));
        int changed = 0;
        for (int y = static_cast<int>(ratio * area.top()); y < static_cast<int>(ratio * area.bottom()); ++y)
            changed += with.pixel(column, y) != without.pixel(column, y);
        QVERIFY(changed > 0.3 * ratio * area.height());
    }
}

void TestSpectrumView::controlsHaveNames()
{
    for (QWidget* widget : view_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (widget->focusPolicy() == Qt::NoFocus) continue;
        const auto* button = qobject_cast<QAbstractButton*>(widget);
        QVERIFY2(!widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()),
                 widget->metaObject()->className());
    }
}

/// The quantity has a line of its own in a narrow place.
void TestSpectrumView::noChoiceIsCut()
{
    for (const int width : {560, 1000}) {
        view_->resize(width, 400);
        for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
        for (const auto* box : view_->findChildren<QSpinBox*>()) QVERIFY(box->width() >= box->sizeHint().width());
        for (const auto* box : view_->findChildren<QComboBox*>()) QVERIFY(box->width() >= box->sizeHint().width());
    }
}

TOUCHDOWN_TEST(TestSpectrumView)

} // namespace test_spectrum_view

#include "test_spectrum_view.moc"
