// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plan of a slider has room in a small window and with large letters, and nothing that is said moves it.
#include <map>

#include <QApplication>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/surface_page.h"
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
