// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_window.h"

#include <cmath>
#include <memory>

#include <QTest>

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
};

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

TOUCHDOWN_TEST(TestRunWindow)

} // namespace test_run_window

#include "test_run_window.moc"
