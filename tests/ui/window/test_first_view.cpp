// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plots of the default case begin with the part of the run in which it bounces.
#include <memory>

#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_first_view {

class TestFirstView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_first_view"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->resize(1400, 900);
        window_->show();
        window_->files().openNow(QStringLiteral("fig10a"));
    }
    void cleanup() { window_.reset(); }
    void theDefaultCaseBeginsWithItsFirstPart()
    {
        PlotGroup* plots = window_->runView().plots()->group();
        const PlotWidget* spacing = window_->runView().plots()->plot(QStringLiteral("spacing"));
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
        runToEnd();
        const PlotWidget* spectrum = window_->runView().spectrum()->view()->plot();
        QTRY_COMPARE(spectrum->xAxis().range(), (PlotRange{0.0, 600e3}));
        edit("ono_yamane.take_off", QStringLiteral("8"));
        runToEnd();
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
        // Everything, if wanted; and so for the next run.
        plots->fit();
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 2e-3}));
        runToEnd();
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 2e-3}));
        // Another case comes to rest as early; another duration is shown whole.
        window_->files().openNow(QStringLiteral("fig11a"));
        runToEnd();
        QVERIFY(spacing->xAxis().range().high < 0.2e-3);
        window_->files().openNow(QStringLiteral("fig10a"));
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
        edit("run.duration", QStringLiteral("1 ms"));
        runToEnd();
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 1e-3}));
    }
    /// A run whose events end early is shown up to a little behind them; later runs, and what was chosen, stay.
    void aRunThatComesToRestEarly()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mine.toml"));
        QCOMPARE(window_->files().write(file), QString());
        window_->files().openNow(file);
        PlotGroup* plots = window_->runView().plots()->group();
        const PlotWidget* spacing = window_->runView().plots()->plot(QStringLiteral("spacing"));
        runToEnd();
        const double last = window_->runs().record(0).events.back().time;
        QVERIFY(last < 0.04 * 2e-3);
        QCOMPARE(spacing->xAxis().range().low, 0.0);
        QVERIFY(spacing->xAxis().range().high >= last && spacing->xAxis().range().high < 0.2 * 2e-3);
        plots->fit();
        runToEnd();
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 2e-3}));
        edit("run.duration", QStringLiteral("0.1 ms")); // most of it has events
        runToEnd();
        QCOMPARE(spacing->xAxis().range(), (PlotRange{0.0, 0.1e-3}));
    }
    /// Empty plots say what to do, in the first of them, until there is a run.
    void emptyPlotsSayWhatToDo()
    {
        const auto hint = [this] {
            for (QLabel* label : window_->runView().plots()->findChildren<QLabel*>())
                if (label->isVisible() && label->text().startsWith(QStringLiteral("F5 runs"))) return label;
            return static_cast<QLabel*>(nullptr);
        };
        const PlotWidget* first = window_->runView().plots()->plot(QStringLiteral("spacing"));
        QVERIFY(first->width() > 300);
        QTRY_VERIFY(hint() && hint()->mapTo(window_.get(), QPoint()) == first->mapTo(window_.get(), QPoint()) &&
                    hint()->size() == first->size());
        runToEnd();
        QVERIFY(!hint());
    }

private:
    void edit(const char* key, const QString& text) { window_->edits().enter(*findParameter(key), text); }
    void runToEnd()
    {
        const QSignalSpy finished(&window_->controller(), &RunController::finished);
        window_->startRun();
        if (!QTest::qWaitFor([&] { return finished.count() == 1; }, 60'000)) qFatal("the run does not end");
    }

    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestFirstView)

} // namespace test_first_view

#include "test_first_view.moc"
