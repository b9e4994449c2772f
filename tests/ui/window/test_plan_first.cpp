// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plan of a slider has room in a small window and with large letters, and nothing that is said moves it.
#include <map>

#include <QApplication>
#include <QScreen>
#include <QStatusBar>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/surface_page.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/run_view.h"
#include "ui/style/message_strip.h"

using namespace touchdown;

namespace test_plan_first {

/// The slider of the plan on the screen [px].
QRectF sliderOn(const SurfaceEditor& plan)
{
    return QRectF(plan.toPixel({0.0, plan.area().bottom()}), plan.toPixel({plan.area().right(), 0.0}));
}

class TestPlanFirst : public QObject {
    Q_OBJECT

private:
    static void open(MainWindow& window, const QSize& size)
    {
        window.resize(size);
        window.show();
        window.files().openNow(QStringLiteral("film_femto"));
        window.actions().surface->trigger();
        QCoreApplication::processEvents();
    }

private slots:
    void cleanup() { QApplication::setFont(font_); }
    void thePlanHasHalfOfTheWindow_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("letters");
        QTest::newRow("laptop") << QSize(1280, 690) << 1.0;
        QTest::newRow("large letters") << QSize(1600, 960) << 1.5;
        QTest::newRow("desktop") << QSize(1600, 960) << 1.0;
    }
    void thePlanHasHalfOfTheWindow()
    {
        QFETCH(const QSize, size);
        QFETCH(const double, letters);
        QFont large = font_;
        large.setPointSizeF(letters * font_.pointSizeF());
        QApplication::setFont(large);
        MainWindow window;
        open(window, size);
        const SurfaceEditor& plan = *window.film().view()->shape()->editor();
        QTRY_VERIFY2(2 * plan.width() >= size.width(), qPrintable(QString::number(plan.width())));
        QVERIFY2(sliderOn(plan).width() >= 400.0, qPrintable(QString::number(sliderOn(plan).width())));
        QVERIFY(plan.rect().contains(sliderOn(plan).toAlignedRect()));
        QCOMPARE(window.size(), size);
    }
    /// Messages of all lengths, with and without buttons, before and after a solution.
    void messagesDoNotMoveThePlan()
    {
        MainWindow window;
        open(window, {1280, 690});
        const SurfaceEditor& plan = *window.film().view()->shape()->editor();
        const QRectF slider = sliderOn(plan);
        const auto place = [&] { return QRect(plan.mapTo(&window, QPoint(0, 0)), plan.size()); };
        const QRect before = place();
        const QSize least = window.minimumSizeHint();
        MessageStrip& messages = window.messages();
        messages.show(MessageStrip::Kind::Failure, QString(900, QLatin1Char('w')).replace(50, 1, QLatin1Char('\n')),
                      QStringLiteral("Show it"));
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
        QCOMPARE(window.minimumSizeHint(), least);
        messages.showWhole(true);
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
        messages.clear();
        window.film().view()->shape()->showObstacle(QString(300, QLatin1Char('w')));
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
        emit window.files().fileChanged(QStringLiteral("The file was changed."), true);
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
        QCOMPARE(sliderOn(plan), slider);
    }
    void everyPageFits_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<double>("letters");
        for (const char* sample : {"fig10a", "film_pico"}) {
            QTest::addRow("%s, laptop", sample) << sample << QSize(1280, 720) << 1.0;
            QTest::addRow("%s, large letters", sample) << sample << QSize(1600, 1000) << 1.5;
        }
    }
    /// Of a case of springs and of one of a film, beside a long message. Nor does the window grow from page to page.
    void everyPageFits()
    {
        QFETCH(const QString, sample);
        QFETCH(const QSize, screen);
        QFETCH(const double, letters);
        const QSize most = screen - QSize(0, 40); // without the frame
        QFont large = font_;
        large.setPointSizeF(letters * font_.pointSizeF());
        QApplication::setFont(large);
        MainWindow window;
        window.resize(most);
        window.show();
        window.files().openNow(sample);
        const auto check = [&](const QString& page) {
            window.messages().show(MessageStrip::Kind::Failure, QString(900, QLatin1Char('w')),
                                   QStringLiteral("Show it"));
            for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
            const QSize least = window.minimumSizeHint();
            QVERIFY2(least.width() <= most.width() && least.height() <= most.height(),
                     qPrintable(QStringLiteral("%1: %2 x %3").arg(page).arg(least.width()).arg(least.height())));
            QVERIFY2(window.size() == most, qPrintable(page));
            QCOMPARE(window.statusBar()->geometry().bottom(), most.height() - 1);
            // No plot is lower than it can be read; what has no room is scrolled to.
            for (const PlotWidget* plot : window.runView().findChildren<PlotWidget*>())
                if (plot->isVisible()) QVERIFY2(plot->height() >= plot->minimumSizeHint().height(), qPrintable(page));
        };
        const auto* tabs = window.findChild<QTabBar*>("pages");
        for (int i = 0; i < tabs->count(); ++i) {
            if (!tabs->isTabVisible(i)) continue;
            window.setPage(static_cast<MainWindow::Page>(i));
            check(tabs->tabText(i));
        }
        for (const RunView::Page page :
             {RunView::Page::Plots, RunView::Page::Side, RunView::Page::Maps, RunView::Page::Disk}) {
            window.setPage(MainWindow::Page::Run);
            window.runView().setPage(page);
            check(QStringLiteral("view %1 of the runs").arg(static_cast<int>(page)));
        }
        if (sample == QLatin1String("fig10a")) return;
        window.setPage(MainWindow::Page::StaticState);
        for (int page = 0; page <= static_cast<int>(FilmView::Page::Series); ++page) {
            window.film().view()->setPage(static_cast<FilmView::Page>(page));
            check(QStringLiteral("view %1 of the static state").arg(page));
        }
    }
    /// A place that a larger screen had is not kept beyond this one.
    void comesBackOntoTheScreen()
    {
        const QRect screen = QApplication::primaryScreen()->availableGeometry();
        for (const QPoint far : {QPoint(60, 40), QPoint(screen.width() - 100, screen.height() - 60)}) {
            {
                MainWindow window;
                window.beginSession(false);
                window.resize(700, 600);
                window.show();
                window.move(far);
                window.close();
            }
            MainWindow window;
            window.restoreArrangement();
            window.show();
            const QRect place = window.geometry();
            QVERIFY(place.left() >= screen.left() && place.top() >= screen.top());
            QVERIFY(place.right() <= screen.right() || place.left() == screen.left());
            QVERIFY(place.bottom() <= screen.bottom() || place.top() < 60); // below its title
        }
    }
    /// A message leaves with its tab; one about the case stays.
    void aMessageLeavesWithItsTab()
    {
        MainWindow window;
        open(window, {1280, 690});
        MessageStrip& messages = window.messages();
        messages.show(MessageStrip::Kind::Warning, QStringLiteral("Of the surface."));
        window.film().view()->setPage(FilmView::Page::Gap);
        QVERIFY(messages.isHidden());
        window.setPage(MainWindow::Page::Run);
        messages.show(MessageStrip::Kind::Warning, QStringLiteral("Of the plots."));
        window.runView().setPage(RunView::Page::Side);
        QVERIFY(messages.isHidden());
        window.edits().enter(*findParameter("disk.speed"), QStringLiteral("nonsense"));
        QCOMPARE(messages.kind(), MessageStrip::Kind::Failure);
        window.runView().setPage(RunView::Page::Plots);
        QVERIFY(!messages.isHidden());
        window.setPage(MainWindow::Page::StaticState);
        QVERIFY(!messages.isHidden());
    }
    /// The page alone has the whole width; the panes come back as they were.
    void thePageAlone()
    {
        MainWindow window;
        open(window, {1280, 690});
        const SurfaceEditor& plan = *window.film().view()->shape()->editor();
        const auto geometry = [&] {
            std::map<QString, QRect> all{{{}, QRect(plan.mapTo(&window, QPoint(0, 0)), plan.size())}};
            for (const QDockWidget* dock : window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
                all[dock->objectName()] = dock->isVisible() ? dock->geometry() : QRect();
            return all;
        };
        QCoreApplication::processEvents();
        const std::map<QString, QRect> before = geometry();
        window.actions().alone->trigger();
        QCoreApplication::processEvents();
        QVERIFY(plan.width() > window.width() - 20);
        window.actions().alone->trigger();
        QTRY_COMPARE(geometry(), before);
    }
    /// What is wanted while the page is alone brings the panes back, and stays.
    void aPaneOpenedMeanwhileStays()
    {
        MainWindow window;
        open(window, {1400, 900});
        const auto pane = [&](const char* name) { return window.findChild<QDockWidget*>(QString::fromLatin1(name)); };
        window.actions().lesson->trigger();
        QTRY_VERIFY(pane("lesson") && pane("lesson")->isVisible());
        window.actions().surface->trigger(); // the lesson shows the page of runs
        pane("solutions")->close();
        pane("shape")->close();
        QAction* alone = window.actions().alone;
        alone->trigger();
        QVERIFY(!pane("lesson")->isVisible() && !pane("parameters")->isVisible());
        emit window.film().view()->shape()->panelWanted();
        QVERIFY(!alone->isChecked());
        QTRY_VERIFY(pane("lesson")->isVisible() && pane("parameters")->isVisible());
        QVERIFY(!pane("shape")->isHidden());
        QVERIFY(pane("solutions")->isHidden());
        alone->trigger();
        alone->trigger();
        QTRY_VERIFY(pane("lesson")->isVisible());
        QVERIFY(!pane("shape")->isHidden());
        QVERIFY(pane("solutions")->isHidden());
    }

private:
    const QFont font_ = QApplication::font();
};

TOUCHDOWN_TEST(TestPlanFirst)

} // namespace test_plan_first

#include "test_plan_first.moc"
