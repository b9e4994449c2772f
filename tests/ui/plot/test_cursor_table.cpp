// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table over frequency, beside that over time; over time alone see test_plot_group.cpp.
#include "ui/plot/cursor_table.h"

#include <memory>

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLocale>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/plot/spectrum_view.h"

using namespace touchdown;

namespace test_cursor_table {

/// 0 to 500 kHz in steps of 1 kHz: a floor, and peaks at 42 kHz and 152 kHz [m^2/Hz].
Spectrum spectrum(double first, double second)
{
    Spectrum made;
    for (int i = 0; i <= 500; ++i) {
        made.frequency.push_back(1e3 * i);
        made.power.push_back(i == 42 ? first : i == 152 ? second : 1e-24);
    }
    return made;
}

class TestCursorTable : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void cleanup() { table_.reset(), view_.reset(), time_.reset(), plot_.reset(); }

    void showsTheGroupWhoseCursorMoved();
    void tabsAppearWithTwoKinds();
    void frequenciesAndRatios();
    void saysWhatTheRatioCompares();
    void saysPeakOnlyAtAPeak();
    void copiesFrequenciesAsATable();
    void copiesTimesAsATable();
    void theButtonNeedsACursor();
    void runsStandBelowTheirQuantity();
    void runsCanBeToldApartInANarrowTable();

private:
    QString cell(int row, int column) const { return table_->table()->item(row, column)->text(); }
    QString places(const QString& name) const
    {
        const auto* label = table_->findChild<QLabel*>(); // its name comes with the table
        return label->accessibleName() == name ? label->text().replace(QChar(0x00a0), u' ') : QString();
    }

    MinMaxPyramid spacing_;
    std::unique_ptr<PlotWidget> plot_;
    std::unique_ptr<PlotGroup> time_;
    std::unique_ptr<SpectrumView> view_;
    std::unique_ptr<CursorTable> table_;
};

void TestCursorTable::init()
{
    spacing_ = MinMaxPyramid();
    const double times[] = {0.0, 1e-3};
    const double values[] = {10e-9, 12e-9};
    spacing_.append(times, values);
    plot_ = std::make_unique<PlotWidget>();
    plot_->setTitle("Spacing");
    plot_->setXLabel({"Time", "ms", 1e-3, AxisScale::Linear});
    plot_->setYLabel({{}, "nm", 1e-9, AxisScale::Linear});
    plot_->addCurve({"1", "Run 1", {0, 0}, &spacing_});
    time_ = std::make_unique<PlotGroup>();
    time_->add(plot_.get());
    view_ = std::make_unique<SpectrumView>();
    view_->resize(760, 400);
    view_->setQuantities({{"flying_height", "m", "nm", "Flying height"}, {"pitch", "rad", "urad", "Pitch"}});
    table_ = std::make_unique<CursorTable>(time_.get());
    table_->add(view_->group());
    connect(view_.get(), &SpectrumView::curvesChanged, table_.get(), &CursorTable::scheduleUpdate);
    table_->show();
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    view_->setSpectrum("1", "Run 1", {0, 0}, spectrum(1e-18, 1e-20));
    view_->setSpectrum("2", "Run 2", {1, 0}, spectrum(4e-18, 8e-18));
}

void TestCursorTable::showsTheGroupWhoseCursorMoved()
{
    QCOMPARE(table_->shown(), time_.get());
    QCOMPARE(table_->table()->rowCount(), 0); // no names without numbers
    view_->group()->setCursor(0, 42e3);
    QCOMPARE(table_->shown(), view_->group());
    QTRY_COMPARE(table_->table()->rowCount(), 2);
    time_->setCursor(1, 0.5e-3);
    QCOMPARE(table_->shown(), time_.get());
    QTRY_COMPARE(cell(0, 0), QStringLiteral("Spacing [nm]"));
    QCOMPARE(table_->table()->rowCount(), 2); // the quantity, its run
    // The cursor follows the pointer through the spectrum and leaves with it: the pinned one over time is read again.
    view_->group()->setCursor(0, 50e3);
    QCOMPARE(table_->shown(), view_->group());
    view_->group()->setCursor(0, std::nullopt);
    QCOMPARE(table_->shown(), time_.get());
}

void TestCursorTable::tabsAppearWithTwoKinds()
{
    QTRY_VERIFY(table_->tabs()->isVisible());
    QCOMPARE(table_->tabs()->tabText(0), QStringLiteral("Time"));
    QCOMPARE(table_->tabs()->tabText(1), QStringLiteral("Frequency"));
    table_->tabs()->setCurrentIndex(1);
    QCOMPARE(table_->shown(), view_->group());
    view_->clear(); // nothing to read there
    QTRY_VERIFY(!table_->tabs()->isVisible());
    QCOMPARE(table_->shown(), time_.get());
}

/// Run 1 falls from 1 to 0.01 nm^2/Hz: -20 dB. Run 2 doubles from 4 to 8: 10 lg 2 = +3.0 dB.
void TestCursorTable::frequenciesAndRatios()
{
    view_->group()->setCursor(0, 42e3);
    QTRY_COMPARE(table_->table()->rowCount(), 2);
    QVERIFY(table_->table()->isColumnHidden(4)); // no ratio with one cursor
    view_->group()->setCursor(1, 152e3);
    QTRY_COMPARE(places("Frequencies of the cursors"),
                 QStringLiteral("f₁ = 42.00 kHz (peak)    f₂ = 152.0 kHz (peak)    Δf = 110.0 kHz    "
                                "densities [nm²/Hz], dB: 10 log₁₀ of 2 / 1"));
    QCOMPARE(table_->table()->horizontalHeaderItem(0)->text(), QStringLiteral("Run"));
    QVERIFY(table_->table()->horizontalHeaderItem(4)->text().contains("dB"));
    QCOMPARE(cell(0, 0), QStringLiteral("Run 1"));
    QCOMPARE(cell(0, 1).toDouble(), 1.0);
    QCOMPARE(cell(0, 2).toDouble(), 0.01);
    QCOMPARE(cell(0, 3), QChar(0x2212) + QStringLiteral("0.990"));
    QCOMPARE(cell(0, 4), QChar(0x2212) + QStringLiteral("20.0"));
    QCOMPARE(cell(1, 3).toDouble(), 4.0);
    QCOMPARE(cell(1, 4), QStringLiteral("+3.0"));
    QVERIFY(!table_->table()->isColumnHidden(4));
    // Between two bins the value is that of the nearer one, not on a line: 42.4 kHz is at the peak, 42.6 kHz is not.
    view_->group()->setCursor(0, 42.4e3);
    QTRY_COMPARE(cell(1, 1).toDouble(), 4.0);
    view_->group()->setCursor(0, 42.6e3);
    QTRY_COMPARE(cell(1, 1), QStringLiteral("1.00·10⁻⁶"));
    time_->setCursor(0, 0.5e-3);
    time_->setCursor(1, 1e-3);
    QTRY_COMPARE(cell(0, 0), QStringLiteral("Spacing [nm]"));
    QCOMPARE(cell(1, 0), QStringLiteral("Run 1"));
    QVERIFY(table_->table()->isColumnHidden(4));
    QVERIFY(places("Times of the cursors").startsWith(QStringLiteral("t₁ = 0.500 ms")));
}

void TestCursorTable::saysWhatTheRatioCompares()
{
    WelchOptions options;
    options.scaling = SpectrumScaling::Amplitude;
    view_->setOptions(options);
    view_->group()->setCursor(0, 42e3);
    view_->group()->setCursor(1, 152e3);
    QTRY_VERIFY(places("Frequencies of the cursors")
                    .endsWith(QStringLiteral("squared amplitudes [nm²], dB: 10 log₁₀ of 2 / 1")));
    QVERIFY(table_->asText().contains(QStringLiteral("10 log10 of the squared amplitudes")));
}

void TestCursorTable::saysPeakOnlyAtAPeak()
{
    view_->group()->setCursor(0, 42.5e3);
    view_->group()->setCursor(1, 10e3);
    QTRY_VERIFY(places("Frequencies of the cursors").contains(QStringLiteral("Δf = −32.50 kHz")));
    QVERIFY(!places("Frequencies of the cursors").contains("peak"));
}

void TestCursorTable::copiesFrequenciesAsATable()
{
    view_->group()->setCursor(0, 42e3);
    view_->group()->setCursor(1, 152.25e3);
    auto* copy = namedWidget<QToolButton>(*table_, "Copy the table of the values at the cursors");
    QTRY_VERIFY(copy->isEnabled());
    QTest::mouseClick(copy, Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Run\tAt 1 (peak)\tAt 2\t2 - 1\t2 / 1 [dB, 10 log10 of the densities]\n"
                            "Frequency [kHz]\t42\t152.25\t110.25\t\n"
                            "Run 1 [nm²/Hz]\t1\t0.01\t-0.99\t-20\n"
                            "Run 2 [nm²/Hz]\t4\t8\t4\t3.0103\n"));
}

void TestCursorTable::copiesTimesAsATable()
{
    time_->setCursor(0, 0.5e-3);
    QTRY_COMPARE(table_->asText(), QStringLiteral("Quantity\tAt 1\tAt 2\t2 - 1\n"
                                                  "Time [ms]\t0.5\t\t\n"
                                                  "Spacing: Run 1 [nm]\t11\t\t\n"));
    time_->setCursor(1, 0.25e-3);
    QCOMPARE(table_->asText(), QStringLiteral("Quantity\tAt 1\tAt 2\t2 - 1\n"
                                              "Time [ms]\t0.5\t0.25\t-0.25\n"
                                              "1/(2 - 1) [kHz]\t\t\t4\n"
                                              "Spacing: Run 1 [nm]\t11\t10.5\t-0.5\n"));
}

void TestCursorTable::theButtonNeedsACursor()
{
    const auto* copy = namedWidget<QToolButton>(*table_, "Copy the table of the values at the cursors");
    QVERIFY(!copy->isEnabled());
    view_->group()->setCursor(1, 42e3);
    QTRY_VERIFY(copy->isEnabled());
    view_->group()->setCursor(1, std::nullopt);
    QTRY_VERIFY(!copy->isEnabled());
}

/// Two runs of one quantity, and of two in one plot: a heading for each quantity, the newest run first.
void TestCursorTable::runsStandBelowTheirQuantity()
{
    const auto curveOf = [this](int run, const QString& quantity) {
        PlotCurve curve{QStringLiteral("run %1/%2").arg(run).arg(quantity), "", {run, 0}, &spacing_};
        curve.run = run;
        curve.runName = QStringLiteral("FH %1 nm").arg(10 + run);
        curve.legend = quantity;
        curve.name = quantity.isEmpty() ? curve.runName : quantity + ", " + curve.runName;
        return curve;
    };
    plot_->setCurves({curveOf(1, ""), curveOf(2, "")});
    PlotWidget energy;
    energy.setTitle("Energy");
    energy.setYLabel({{}, "pJ", 1e-12, AxisScale::Linear});
    energy.setCurves({curveOf(1, "Kinetic"), curveOf(1, "Total"), curveOf(2, "Kinetic"), curveOf(2, "Total")});
    time_->add(&energy);
    time_->setCursor(0, 0.5e-3);
    QTRY_COMPARE(table_->table()->rowCount(), 9);
    const QStringList expected{"Spacing [nm]",         "2  FH 12 nm", "1  FH 11 nm",
                               "Energy: Kinetic [pJ]", "2  FH 12 nm", "1  FH 11 nm",
                               "Energy: Total [pJ]",   "2  FH 12 nm", "1  FH 11 nm"};
    for (int row = 0; row < 9; ++row) {
        QCOMPARE(cell(row, 0), expected[row]);
        QCOMPARE(table_->table()->columnSpan(row, 0) > 1, row % 3 == 0);
    }
    QVERIFY(table_->asText().contains("Energy: Total, FH 12 nm [pJ]")); // the quantity in each row
    time_->remove(&energy);
    plot_->setCurves({{"run 1/spacing", "Spacing", {0, 0}, &spacing_}}); // one run: no heading
    table_->scheduleUpdate();
    QTRY_COMPARE(table_->table()->rowCount(), 1);
    QCOMPARE(cell(0, 0), QStringLiteral("Spacing [nm]"));
    QCOMPARE(table_->table()->columnSpan(0, 0), 1);
}

/// At the default width with two cursors each value has its room, and each name room for what tells it apart.
void TestCursorTable::runsCanBeToldApartInANarrowTable()
{
    std::vector<PlotCurve> curves;
    for (int run = 1; run <= 12; ++run) {
        PlotCurve curve{QStringLiteral("run %1").arg(run), QStringLiteral("FH %1 nm").arg(run), {run, 0}, &spacing_};
        curve.run = run;
        curve.runName = curve.name;
        curves.push_back(curve);
    }
    plot_->setCurves(curves);
    table_->resize(340, 500);
    time_->setCursor(0, 0.25e-3);
    time_->setCursor(1, 0.5e-3);
    table_->scheduleUpdate();
    QTRY_COMPARE(table_->table()->rowCount(), 13);
    const QFontMetrics metrics(table_->table()->font());
    const auto fits = [&](int row, int column, int around) {
        return metrics.horizontalAdvance(cell(row, column)) + around <= table_->table()->columnWidth(column);
    };
    QTRY_VERIFY(fits(1, 3, 4));
    for (int row = 1; row < 13; ++row) {
        QVERIFY(fits(row, 0, 22 + 12)); // with the sample of the line
        for (const int column : {1, 2, 3}) QVERIFY(!cell(row, column).isEmpty() && fits(row, column, 4));
    }
}

TOUCHDOWN_TEST(TestCursorTable)

} // namespace test_cursor_table

#include "test_cursor_table.moc"
