// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_card.h"

#include <cmath>
#include <memory>

#include <QDockWidget>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "ui/case/case_files.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/runs/side_view.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_start_card {

class TestStartCard : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_start_card"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->resize(1280, 720);
        window_->show();
    }
    void cleanup() { window_.reset(); }

    void isForNewcomers()
    {
        QVERIFY(StartCard::wanted());
        QSettings().setValue("files/last", "fig12a");
        QVERIFY(!StartCard::wanted()); // not the first start
        QSettings().remove("files/last");
        window_->startCard().open();
        QVERIFY(!StartCard::wanted());
    }

    /// Also when it is closed early.
    void slowMotionEndsWithTheCard()
    {
        window_->greet();
        QVERIFY(window_->controller().pace() < 1.0);
        window_->startCard().close();
        QCOMPARE(window_->controller().pace(), RunController::fullSpeed);
        window_->greet();
        window_->actions().lesson->trigger(); // closes the card, too
        QVERIFY(!window_->startCard().isVisible());
        QVERIFY(window_->runView().stage()); // that of the lesson
        QCOMPARE(window_->controller().pace(), RunController::fullSpeed);
    }

    /// Who chooses a plot sees it.
    void choosingAPlotEndsTheStage()
    {
        window_->greet();
        QVERIFY(!window_->runView().plots()->plot("pitch")->isVisible());
        emit window_->actions().plots->triggered(window_->actions().plots->actions().front());
        QVERIFY(!window_->runView().stage());
        QTRY_VERIFY(window_->runView().plots()->plot("pitch")->isVisible());
    }

    /// The default case runs slowly where it bounces: the slider above its spacing, nothing else.
    void greetsWithTheDefaultCase()
    {
        window_->files().openNow("fig12a");
        window_->greet();
        QCOMPARE(window_->files().sample(), QString("fig10a"));
        QVERIFY(window_->startCard().isVisible());
        QVERIFY(window_->controller().pace() < 1.0);
        const RunView& view = window_->runView();
        QTRY_VERIFY(view.sideAbove()->isVisible() && view.sideAbove()->state());
        QVERIFY(view.plots()->plot("spacing")->isVisible());
        for (const char* hidden : {"pitch", "energy", "forces"}) QVERIFY(!view.plots()->plot(hidden)->isVisible());
        QVERIFY(!view.spectrum()->isVisible());
        QCOMPARE(view.plots()->plot("spacing")->xAxis().range(), (PlotRange{0.0, 0.3e-3}));
        // It goes on without the card, which takes its stage along.
        window_->startCard().close();
        QVERIFY(!view.sideAbove()->isVisible());
        QVERIFY(view.plots()->plot("energy")->isVisible() && view.spectrum()->isVisible());
        // The next run has the speed that the user chose.
        QSignalSpy ended(window_.get(), &MainWindow::calculationEnded);
        window_->startRun();
        QCOMPARE(window_->controller().pace(), RunController::fullSpeed);
        QVERIFY(ended.wait(20000));
    }

    /// The smallest usual screen, with a title bar.
    void fitsASmallScreen()
    {
        for (const bool greeted : {false, true}) {
            if (greeted) window_->greet();
            QCoreApplication::processEvents();
            const QSize least = window_->minimumSizeHint();
            QVERIFY2(least.width() <= 1280 && least.height() <= 700,
                     qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
        }
    }

    void slowPartEnds()
    {
        window_->greet();
        RunDelivery later;
        later.time = 0.31e-3;
        emit window_->controller().delivered(later);
        QCOMPARE(window_->controller().pace(), RunController::fullSpeed);
        QTRY_VERIFY_WITH_TIMEOUT(window_->runs().record(0).finished(), 30000);
    }

    void anotherCaseEndsIt()
    {
        window_->greet();
        window_->files().openNow("fig12a");
        QVERIFY(!window_->startCard().isVisible());
        QVERIFY(!window_->runView().stage());
    }

    void leadsOn()
    {
        window_->greet();
        window_->startCard().lesson()->click();
        QVERIFY(!window_->startCard().isVisible());
        QTRY_VERIFY(window_->findChild<QDockWidget*>("lesson"));
        window_->greet();
        window_->startCard().figures()->click();
        QVERIFY(!window_->startCard().isVisible());
        QTRY_VERIFY(window_->findChild<QDockWidget*>("demonstrations")->isVisible());
        QVERIFY(window_->findChild<QDockWidget*>("lesson")->isHidden());
    }

    /// Its numbers are those of its runs.
    void saysWhatHappens()
    {
        const QString text = window_->startCard().text();
        const auto runs = [](double flyingHeight) {
            Case c = openCase("fig10a").value;
            if (flyingHeight > 0.0) c.springs.flyingHeight = flyingHeight;
            return touchdown::run(c);
        };
        static const QRegularExpression numbers(
            "from (\\d+) nm.*ends at ([\\d.]+) nm and flies.*to (\\d+) nm and press F5.*in contact, at ([\\d.]+) nm",
            QRegularExpression::DotMatchesEverythingOption);
        const QRegularExpressionMatch said = numbers.match(text);
        QVERIFY2(said.hasMatch(), qPrintable(text));
        QCOMPARE(said.captured(1).toDouble() * 1e-9, openCase("fig10a").value.initial.flyingHeight);
        const auto last = [](const Summary& summary, std::string_view quantity) {
            for (const auto& [name, value] : summary.final)
                if (name == quantity) return value;
            qFatal("no such quantity");
        };
        const Summary flies = runs(0.0);
        QVERIFY(std::abs(last(flies, "flying_height") * 1e9 - said.captured(2).toDouble()) < 0.005);
        QCOMPARE(last(flies, "net_contact_force"), 0.0);
        const Summary stays = runs(said.captured(3).toDouble() * 1e-9);
        QVERIFY(std::abs(last(stays, "flying_height") * 1e9 - said.captured(4).toDouble()) < 0.005);
        QVERIFY(last(stays, "net_contact_force") != 0.0);
    }

private:
    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestStartCard)

} // namespace test_start_card

#include "test_start_card.moc"
