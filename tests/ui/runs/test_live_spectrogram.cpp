// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spectrogram of a run of our own, whose frequency rises.
#include "ui/runs/live_spectrogram.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <QBuffer>
#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_live_spectrogram {

const QString name = QStringLiteral("spectrogram");

/// 100 to 305 kHz in 8.2 ms, sampled every 1 us; the pitch stands still.
double frequencyAt(double t) { return 100e3 + 25e6 * t; }

std::unique_ptr<RunRecord> risingRun(int number, int samples = 8192)
{
    const Case c = openCase("fig10a").value;
    const std::vector<Quantity> quantities = recordedQuantities(c);
    auto run = std::make_unique<RunRecord>(number, c, "", quantities);
    SampleBatch batch;
    batch.columns.assign(quantities.size(), std::vector<double>(static_cast<std::size_t>(samples), 0.0));
    auto& spacing = batch.columns[static_cast<std::size_t>(findQuantity(quantities, "minimum_spacing"))];
    for (int i = 0; i < samples; ++i) {
        const double t = 1e-6 * i;
        batch.time.push_back(t);
        spacing[static_cast<std::size_t>(i)] = 1e-9 * std::sin(2.0 * std::numbers::pi * (100e3 * t + 12.5e6 * t * t));
    }
    run->append(batch, {});
    return run;
}

class TestLiveSpectrogram : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void isBrightWhereTheFrequencyIs();
    void saysItsResolutions();
    void aHiddenPlotGivesItBack();
    void theWindowIsChosen();
    void followsTheNewestRun();
    void anotherQuantityTakesItsPlace();
    void writesItsNumbers();
    void theSettingsKeepQuantityAndWindow();
    void aLongRunHasOne();
    void nothingOfAnotherQuantityIsShown();
    void growsWithItsRun();

private:
    Quantity quantity(const char* wanted) const
    {
        const std::vector<Quantity> all = plots_->quantities();
        return all[static_cast<std::size_t>(findQuantity(all, wanted))];
    }
    PlotWidget* plot() const { return plots_->plot(name); }

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<LivePlots> plots_;
};

void TestLiveSpectrogram::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestLiveSpectrogram::init()
{
    plots_.reset();
    runs_ = std::make_unique<RunsModel>();
    plots_ = std::make_unique<LivePlots>(*runs_);
    plots_->resize(900, 1000);
    plots_->setCase(openCase("fig10a").value);
    runs_->add(risingRun(1));
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
    plots_->entry(name).wanted->trigger();
    QTRY_VERIFY(plots_->spectrogram()->shown()); // it comes by itself
}

/// The picture has a bright ridge at the frequency of each time, 40 dB or more above what is 60 kHz beside it.
void TestLiveSpectrogram::isBrightWhereTheFrequencyIs()
{
    QVERIFY(plot()->isVisible() && plot()->backdrop());
    plot()->refreshNow();
    QCOMPARE(plot()->xAxis().range(), plots_->plot(QStringLiteral("spacing"))->xAxis().range());
    QVERIFY(plot()->yAxis().range().high > 300e3 && plot()->yAxis().range().high < 500e3);
    const QImage image = plot()->grab().toImage();
    const auto light = [&](double t, double f) {
        return image.pixelColor(plot()->toPixel(t, f).toPoint()).lightness();
    };
    for (const double t : {1e-3, 3e-3, 5e-3, 7e-3})
        for (const double beside : {-60e3, 60e3})
            QVERIFY2(light(t, frequencyAt(t)) > light(t, frequencyAt(t) + beside) + 40, qPrintable(QString::number(t)));
}

/// A thirty-second of 8192 samples is 256: 256 us and 1.5/256 us = 5.859 kHz.
void TestLiveSpectrogram::saysItsResolutions()
{
    QCOMPARE(plots_->spectrogram()->shown()->window, std::size_t(256));
    QCOMPARE(plot()->toolTip(), QStringLiteral("Resolution: 256.0\u00a0µs, 5.859\u00a0kHz"));
    QCOMPARE(plot()->title(),
             QStringLiteral("Spectrogram of run 1: Minimum spacing of pad and pressure centres above the disk"));
    QCOMPARE(spectrogramWindow(100), std::size_t(64));
    QCOMPARE(spectrogramWindow(1'000'000), std::size_t(4096));
}

/// Shown again, it has one.
void TestLiveSpectrogram::aHiddenPlotGivesItBack()
{
    plots_->entry(name).wanted->trigger();
    QVERIFY(!plot()->isVisible());
    QVERIFY(!plots_->spectrogram()->shown() && !plot()->backdrop());
    plots_->entry(name).wanted->trigger();
    QTRY_VERIFY(plots_->spectrogram()->shown() && plot()->backdrop());
}

void TestLiveSpectrogram::theWindowIsChosen()
{
    QMenu* window = plot()->actions()[1]->menu();
    emit window->aboutToShow();
    QVERIFY(window->actions()[0]->isChecked()); // automatic
    for (QAction* action : window->actions())
        if (action->text() == QStringLiteral("512 samples")) action->trigger();
    QTRY_VERIFY(plots_->spectrogram()->shown() && plots_->spectrogram()->shown()->window == 512);
}

void TestLiveSpectrogram::followsTheNewestRun()
{
    runs_->add(risingRun(2, 2048));
    QTRY_VERIFY(plots_->spectrogram()->shown() && plots_->spectrogram()->shown()->window == 64);
    runs_->remove(1);
    QTRY_VERIFY(plots_->spectrogram()->shown() && plots_->spectrogram()->shown()->window == 256);
    runs_->remove(0);
    QTRY_VERIFY(!plots_->spectrogram()->shown());
    QVERIFY(!plot()->backdrop());
}

void TestLiveSpectrogram::anotherQuantityTakesItsPlace()
{
    QCOMPARE(plots_->addCurve(name, quantity("pitch")), QString());
    QTRY_VERIFY(plot()->title().startsWith(QStringLiteral("Spectrogram of run 1: Pitch")));
    QCOMPARE(plots_->spec(name).curves.size(), std::size_t(1));
    QCOMPARE(plot()->yAxis().label.unit, QStringLiteral("kHz"));
    QTRY_VERIFY(plots_->spectrogram()->shown());
    QVERIFY(!plot()->grab().toImage().isNull()); // a signal that stands still has no power, and no picture breaks
}

void TestLiveSpectrogram::writesItsNumbers()
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    plot()->backdrop()->writeData(buffer);
    const QList<QByteArray> lines = buffer.data().trimmed().split('\n');
    const Spectrogram& shown = *plots_->spectrogram()->shown();
    QCOMPARE(lines.size(), static_cast<qsizetype>(shown.columns) + 1);
    QVERIFY(lines[0].contains("[dB re 1 nm²/Hz]"));
    QCOMPARE(lines[1].split(',').size(), static_cast<qsizetype>(shown.frequency.size()) + 1);
    // The middle of each window, from the begin of the run at 0.
    for (const qsizetype c : {qsizetype(0), lines.size() - 2})
        QVERIFY(std::abs(lines[c + 1].split(',')[0].toDouble() - shown.firstCentre - double(c) * shown.step) < 1e-9);
    // In dB re 1 nm²/Hz.
    const double expected = 10.0 * std::log10(shown.at(0, 13) / 1e-18);
    QVERIFY(std::abs(lines[1].split(',')[14].toDouble() - expected) < 0.006);
}

void TestLiveSpectrogram::theSettingsKeepQuantityAndWindow()
{
    plots_->addCurve(name, quantity("height"));
    plots_->spectrogram()->setWindow(512);
    LivePlots other(*runs_);
    other.restore(plots_->arrangement());
    QCOMPARE(other.spectrogram()->window(), std::size_t(512));
    QVERIFY(other.spec(name).has("height"));
}

/// Of every sample: that of the whole signal at once. The end of the run, between two samples, is none of it, though it
/// would complete a column.
void TestLiveSpectrogram::aLongRunHasOne()
{
    constexpr int samples = (3 << 20) - 1;
    const std::vector<Quantity> one{{"minimum_spacing", "m", "nm", "Minimum spacing"}};
    auto run = std::make_unique<RunRecord>(2, openCase("fig10a").value, "", one);
    SampleBatch batch;
    batch.columns.resize(1);
    for (int i = 0; i < samples; ++i) {
        batch.time.push_back(1e-9 * i);
        batch.columns[0].push_back(1e-9 * std::sin(0.1 * i + 1e-8 * i * static_cast<double>(i)));
    }
    run->append(batch, {});
    run->append({{1e-9 * (samples - 0.4)}, {{5e-9}}}, {});
    runs_->add(std::move(run));
    QTRY_VERIFY(plots_->spectrogram()->shown() && plots_->spectrogram()->shown()->window == 4096);
    const Spectrogram& shown = *plots_->spectrogram()->shown();
    const Spectrogram expected = spectrogram(batch.columns[0], batch.time[1], 4096, LiveSpectrogram::mostColumns);
    QCOMPARE(shown.columns, expected.columns);
    QVERIFY(shown.density == expected.density);
}

void TestLiveSpectrogram::nothingOfAnotherQuantityIsShown()
{
    plots_->addCurve(name, quantity("pitch"));
    plots_->spectrogram()->updateNow();
    QVERIFY(!plots_->spectrogram()->shown() && !plot()->backdrop());
    QCOMPARE(plot()->title(), QStringLiteral("Spectrogram of run 1: Pitch, being computed"));
    plots_->addCurve(name, quantity("minimum_spacing"));
    plots_->spectrogram()->updateNow(); // the one of the pitch is not waited for
    QTRY_VERIFY(plots_->spectrogram()->shown());
    QVERIFY(plots_->spectrogram()->shown()->at(10, 30) > 0.0); // the pitch stands still
    QVERIFY(plot()->title().startsWith(QStringLiteral("Spectrogram of run 1: Minimum spacing")));
}

/// The picture stays until the next one comes.
void TestLiveSpectrogram::growsWithItsRun()
{
    const std::size_t before = plots_->spectrogram()->shown()->columns;
    SampleBatch more;
    more.columns.assign(runs_->record(0).quantities.size(), {});
    for (int i = 0; i < 4096; ++i) {
        more.time.push_back(1e-6 * (8192 + i));
        for (std::vector<double>& column : more.columns) column.push_back(1e-9 * (i % 5));
    }
    runs_->append(1, more, {});
    plots_->dataArrived(1);
    QVERIFY(plots_->spectrogram()->shown() && plot()->backdrop());
    QTRY_COMPARE(plots_->spectrogram()->shown()->columns, before + before / 2 + 1); // of 63, each of 128 samples
}

TOUCHDOWN_TEST(TestLiveSpectrogram)

} // namespace test_live_spectrogram

#include "test_live_spectrogram.moc"
