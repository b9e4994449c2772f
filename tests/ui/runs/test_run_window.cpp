// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_window.h"

#include <cmath>
#include <memory>

#include <QTest>

#include "core/case/parameters.h"
#include "core/simulation/run.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"
#include "ui/plot/cursor_table.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"

using namespace touchdown;

namespace test_run_window {

class TestRunWindow : public QObject {
    Q_OBJECT

private slots:
    void theTableReadsTimeAndFrequency();
    void theWorkerFindsTheFieldsOfARun();
    void aMissingDiskFileEndsTheRun();
};

/// A pad with the air bearing surface of a slider, whose parts that can touch are sought over the surface of the disk.
Case sliderPad()
{
    Case c = defaultsOf(ModelKind::Contact);
    c.pad.shape = PadShape::Slider;
    c.surface = test::smallSlider().surface;
    c.slider = test::smallSlider().slider;
    c.elastic.cell = 20e-6;
    c.run.fieldSnapshots = 3;
    return c;
}

/// 4 ms, sampled every 1 us, of a sine of 62.5 kHz, a multiple of the bins' distance.
void TestRunWindow::theTableReadsTimeAndFrequency()
{
    QWidget page;
    RunWindow window(&page);
    page.resize(1200, 900);
    window.view()->resize(900, 900);
    window.values()->setGeometry(900, 0, 300, 900);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    Case c;
    c.run.duration = 4e-3;
    c.run.sampleInterval = 1e-6;
    auto run =
        std::make_unique<RunRecord>(1, c, "", std::vector<Quantity>{{"minimum_spacing", "m", "nm", "Minimum spacing"}});
    SampleBatch batch;
    batch.columns.resize(1);
    for (int k = 0; k < 4000; ++k) {
        batch.time.push_back(1e-6 * k);
        batch.columns[0].push_back(1e-9 * std::sin(2.0 * M_PI * 62.5e3 * 1e-6 * k));
    }
    run->append(batch, {});
    window.runs().add(std::move(run));
    window.runs().finish(1, Summary{});
    window.view()->spectrum()->runFinished(1);

    QTRY_VERIFY(window.values()->tabs()->isVisible());
    SpectrumView* spectrum = window.view()->spectrum()->view();
    QTRY_VERIFY(!spectrum->plot()->curves().empty());
    PlotWidget* plot = spectrum->plot();
    plot->refreshNow();
    const QPoint beside(static_cast<int>(std::lround(plot->toPixel(62.5e3, 1.0).x())) + 4,
                        static_cast<int>(plot->plotArea().center().y()));
    QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, beside);
    QCOMPARE(window.values()->shown(), spectrum->group());
    QVERIFY(std::abs(*spectrum->group()->cursor(0) - 62.5e3) < 50.0); // a tenth of the distance of two bins
    window.view()->plots()->group()->setCursor(0, 1e-3);
    QCOMPARE(window.values()->shown(), window.view()->plots()->group());
}

/// The search may take seconds: the window lists the run at once and learns later which fields it records, once.
void TestRunWindow::theWorkerFindsTheFieldsOfARun()
{
    QWidget page;
    RunWindow window(&page);
    const Case c = sliderPad();
    int found = 0;
    connect(&window.controller(), &RunController::delivered, this, [&](const RunDelivery& delivery) {
        if (delivery.sets) ++found;
        QVERIFY(found == 1);
    });
    window.start({c, std::string(), {}});
    QVERIFY(window.runUnderWay()->fields.empty());
    QTRY_VERIFY_WITH_TIMEOUT(!window.runUnderWay(), 30000);
    const RunRecord& run = window.runs().record(0);
    QCOMPARE(run.summary->status, RunStatus::Completed);
    const std::vector<RecordedFields> sets = recordedFields(c);
    QCOMPARE(sets.size(), std::size_t{1});
    QCOMPARE(run.fields.size(), sets.size());
    QCOMPARE(run.fields[0].fields.grid.cells(), sets[0].grid.cells());
    QVERIFY(run.fields[0].snapshots.size() >= 3);
}

/// The window checked the file when it was opened.
void TestRunWindow::aMissingDiskFileEndsTheRun()
{
    QWidget page;
    RunWindow window(&page);
    Case c = sliderPad();
    c.diskSurface.kind = DiskSurfaceKind::File;
    c.diskSurface.file = "removed.txt";
    window.start({c, std::string(), {}});
    QTRY_VERIFY_WITH_TIMEOUT(!window.runUnderWay(), 30000);
    const Summary& summary = *window.runs().record(0).summary;
    QCOMPARE(summary.status, RunStatus::Failed);
    QVERIFY(summary.message.find("removed.txt") != std::string::npos);
}

TOUCHDOWN_TEST(TestRunWindow)

} // namespace test_run_window

#include "test_run_window.moc"
