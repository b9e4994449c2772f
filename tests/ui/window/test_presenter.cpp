// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/presenter.h"

#include <map>
#include <utility>
#include <vector>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMenuBar>
#include <QPointer>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/case/case_files.h"
#include "ui/guides/guides.h"
#include "ui/guides/lesson_pane.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_presenter {

class TestPresenter : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_presenter"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->restoreArrangement();
        QCoreApplication::processEvents(); // it keeps the size that it had then
        window_->resize(1280, 720);
        window_->show();
        window_->files().openNow("fig10a");
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup()
    {
        window_.reset();
        applyTheme(Theme::System);
    }

    void showsThePageAlone()
    {
        present(true);
        QVERIFY(window_->isFullScreen());
        for (const QDockWidget* dock : docks()) QVERIFY2(!dock->isVisible(), qPrintable(dock->objectName()));
        QVERIFY(!window_->menuBar()->isVisible() && !window_->statusBar()->isVisible());
        QVERIFY(!window_->actions().toolBar->isVisible() && window_->presenter().bar()->isVisible());
        QVERIFY(QApplication::font().pointSize() > systemPointSize());
        QVERIFY(window_->presenter().bar()->findChild<QLabel*>()->width() > 100);
        QVERIFY(window_->runView().isVisible());
        QVERIFY(!window_->actions().findParameter->isEnabled()); // its text would go elsewhere
        // Nothing comes back with another page.
        window_->setPage(MainWindow::Page::Studies);
        for (const QDockWidget* dock : docks()) QVERIFY(!dock->isVisible());
    }

    /// Whatever was shown, at the size that it had.
    void givesEverySizeBack_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<bool>("lesson");
        QTest::addColumn<QString>("closed");
        QTest::newRow("as it opens") << 0 << false << QString();
        QTest::newRow("large text") << 2 << false << QString();
        QTest::newRow("with the lesson") << 0 << true << QString();
        QTest::newRow("another page meanwhile") << 0 << false << QStringLiteral("page");
        QTest::newRow("a pane closed") << 0 << false << QStringLiteral("values");
    }
    void givesEverySizeBack()
    {
        QFETCH(const int, points);
        QFETCH(const bool, lesson);
        QFETCH(const QString, closed);
        for (QAction* size : window_->actions().fontSize->actions())
            if (size->data().toInt() == points) size->trigger();
        if (lesson) window_->actions().lesson->trigger();
        const bool leavesPage = closed == QLatin1String("page");
        if (!closed.isEmpty() && !leavesPage) window_->findChild<QDockWidget*>(closed)->close();
        for (int i = 0; i < 5; ++i) QCoreApplication::processEvents(); // what follows a new font
        const std::map<QString, QRect> before = places();
        const QSize size = window_->size();
        const int font = QApplication::font().pointSize();
        present(true);
        if (leavesPage) window_->setPage(MainWindow::Page::Studies);
        QTest::keyClick(window_.get(), Qt::Key_Escape);
        QVERIFY(!window_->presenter().on());
        if (leavesPage) {
            QTRY_VERIFY(window_->findChild<QDockWidget*>("study")->isVisible());
            QVERIFY(!window_->findChild<QDockWidget*>("runs")->isVisible());
            window_->setPage(MainWindow::Page::Run);
        }
        QTRY_COMPARE(window_->size(), size);
        QCOMPARE(QApplication::font().pointSize(), font);
        if (!leavesPage) QTRY_VERIFY2(places() == before, qPrintable(difference(before, places())));
        QVERIFY(window_->menuBar()->isVisible() && !window_->presenter().bar()->isVisible());
        QVERIFY(window_->guides().staged() == lesson);
    }

    /// Every widget has its font again, and each that is shown its place.
    void givesEveryWidgetBack_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("large screen") << QSize(1600, 1000);
        QTest::newRow("small screen") << QSize(1280, 720);
    }
    void givesEveryWidgetBack()
    {
        QFETCH(const QSize, size);
        window_->resize(size);
        for (int i = 0; i < 5; ++i) QCoreApplication::processEvents(); // what follows a new size
        const Looks before = looks();
        QVERIFY(before.size() > 300);
        present(true);
        QVERIFY(!changes(before).isEmpty());
        present(false);
        QTRY_VERIFY2(changes(before).isEmpty(), qPrintable(changes(before)));
    }

    /// With the largest text, too, the window asks for no more width than the screen has.
    void fitsTheScreen()
    {
        const QSize screen = window_->screen()->availableSize();
        for (QAction* size : window_->actions().fontSize->actions()) {
            size->trigger();
            for (const MainWindow::Page page : {MainWindow::Page::Studies, MainWindow::Page::Run}) {
                window_->setPage(page);
                QTRY_VERIFY2(window_->minimumSizeHint().width() <= screen.width() &&
                                 window_->minimumSizeHint().height() <= screen.height(),
                             qPrintable(QStringLiteral("%1 x %2")
                                            .arg(window_->minimumSizeHint().width())
                                            .arg(window_->minimumSizeHint().height())));
            }
        }
    }

    /// Nor does it open larger than the screen, at its first start and at the next one.
    void opensWithinTheScreen()
    {
        for (const QSize& last : {QSize(), QSize(3000, 2000)}) {
            if (last.isValid()) {
                window_->resize(last);
                window_->close();
            }
            window_ = std::make_unique<MainWindow>();
            window_->restoreArrangement();
            window_->show();
            for (int i = 0; i < 5; ++i) QCoreApplication::processEvents(); // what follows a new font
            const QSize screen = window_->screen()->availableSize();
            QVERIFY2(window_->width() <= screen.width() && window_->height() <= screen.height(),
                     qPrintable(QStringLiteral("%1 x %2").arg(window_->width()).arg(window_->height())));
        }
    }

    void goesThroughTheSteps()
    {
        window_->actions().lesson->trigger();
        const LessonPane* pane = window_->guides().pane(LessonPane::Kind::Lesson);
        present(true);
        QVERIFY(window_->guides().staged()); // without its pane
        QVERIFY(caption().contains("A slider flies"));
        QTest::keyClick(window_.get(), Qt::Key_PageDown);
        QCOMPARE(pane->step(), std::size_t(1));
        QVERIFY(caption().contains("Two states of rest"));
        QTest::keyClick(window_.get(), Qt::Key_PageUp);
        QTest::keyClick(window_.get(), Qt::Key_PageUp); // the first step stays
        QCOMPARE(pane->step(), std::size_t(0));
        QSignalSpy ended(window_.get(), &MainWindow::calculationEnded);
        QTest::keyClick(window_.get(), Qt::Key_F5);
        QVERIFY(!ended.isEmpty() || ended.wait(30000));
        QCOMPARE(window_->runs().count(), 1);
        QTest::keyClick(window_.get(), Qt::Key_F11);
        QVERIFY(!window_->presenter().on() && window_->actions().findParameter->isEnabled());
        QTRY_VERIFY(window_->findChild<QDockWidget*>("lesson")->isVisible());
        // Page Down is for the reader again.
        QTest::keyClick(window_.get(), Qt::Key_PageDown);
        QCOMPARE(pane->step(), std::size_t(0));
    }

    void namesTheCaseWithoutALesson()
    {
        present(true);
        QVERIFY(caption().contains("Fig. 10 (a)"));
        QVERIFY(!window_->presenter().next()->isVisible());
        window_->files().openNow("fig12a");
        QVERIFY(caption().contains("Fig. 12 (a)"));
        // A guide that opens now shows itself on the page only.
        window_->actions().demonstrations->trigger();
        QVERIFY(caption().contains("Fig. 2"));
        QVERIFY(window_->presenter().next()->isVisible());
        for (const QDockWidget* dock : docks()) QVERIFY(!dock->isVisible());
        present(false);
        auto* pane = window_->findChild<QDockWidget*>("demonstrations");
        QTRY_VERIFY(pane->isVisible());
        QVERIFY(window_->tabifiedDockWidgets(pane).contains(window_->findChild<QDockWidget*>("about")));
    }

    /// Its pane is then as where it was opened without the presenter: font of the title and height.
    void guideOpenedMeanwhileLooksAsAlways()
    {
        const auto heights = [this] {
            std::map<QString, int> all;
            for (const char* name : {"demonstrations", "runs"})
                all[name] = window_->findChild<QDockWidget*>(name)->height();
            return all;
        };
        window_->actions().demonstrations->trigger();
        QCoreApplication::processEvents();
        const std::map<QString, int> expected = heights();
        const QFont font = window_->findChild<QDockWidget*>("demonstrations")->font();
        window_.reset();
        init();
        present(true);
        window_->actions().demonstrations->trigger();
        present(false);
        QTRY_VERIFY(window_->findChild<QDockWidget*>("demonstrations")->isVisible());
        QCOMPARE(window_->findChild<QDockWidget*>("demonstrations")->font().pointSize(), font.pointSize());
        QTRY_COMPARE(heights(), expected);
    }

    /// A guide that another one replaced in the presenter is closed, as it is without it.
    void oneGuideIsOpen()
    {
        window_->actions().lesson->trigger();
        present(true);
        window_->actions().demonstrations->trigger();
        present(false);
        QTRY_VERIFY(window_->findChild<QDockWidget*>("demonstrations")->isVisible());
        QVERIFY(window_->findChild<QDockWidget*>("lesson")->isHidden());
        QCOMPARE(window_->guides().shown(), window_->guides().pane(LessonPane::Kind::Demonstrations));
    }

    /// Where the window is low and the user left the panes in their column.
    void lowWindowsMakeRoomForAGuide_data()
    {
        QTest::addColumn<int>("height");
        QTest::addColumn<bool>("moved");
        QTest::addColumn<bool>("shared");
        QTest::newRow("low") << 720 << false << true;
        QTest::newRow("high") << 940 << false << false;
        QTest::newRow("moved by the user") << 720 << true << false;
    }
    void lowWindowsMakeRoomForAGuide()
    {
        QFETCH(const int, height);
        QFETCH(const bool, moved);
        QFETCH(const bool, shared);
        window_->resize(1280, height);
        QDockWidget *runs = window_->findChild<QDockWidget*>("runs"),
                    *values = window_->findChild<QDockWidget*>("values");
        if (moved) window_->addDockWidget(Qt::BottomDockWidgetArea, values);
        window_->actions().lesson->trigger();
        QCOMPARE(window_->tabifiedDockWidgets(runs).contains(values), shared);
        if (!shared) return;
        window_->addDockWidget(Qt::RightDockWidgetArea, values); // the user wants it otherwise
        window_->actions().demonstrations->trigger();
        QVERIFY(!window_->tabifiedDockWidgets(runs).contains(values));
    }

    /// From step to step, for springs and a film, the pane of the lesson stays as wide as it is, also where the last
    /// step was shown by the presenter.
    void paneOfTheLessonKeepsItsWidth()
    {
        window_->resize(1500, 940);
        window_->actions().lesson->trigger();
        QCoreApplication::processEvents();
        LessonPane* pane = window_->guides().pane(LessonPane::Kind::Lesson);
        const auto* dock = window_->findChild<QDockWidget*>("lesson");
        const int width = dock->width();
        const auto leastOfBoxes = [this] {
            std::vector<QSize> sizes;
            for (const QComboBox* box : window_->runView().spectrum()->findChildren<QComboBox*>())
                sizes.push_back(box->minimumSizeHint());
            return sizes;
        };
        const std::vector<QSize> least = leastOfBoxes();
        QVERIFY(!least.empty());
        for (const bool presented : {false, true}) {
            pane->go(0);
            window_->files().openNow("fig10a");
            QTRY_COMPARE(dock->width(), width);
            if (presented) present(true);
            pane->go(5);
            window_->files().openNow("fig02_case_2_moving");
            QCoreApplication::processEvents();
            if (presented) {
                QVERIFY(leastOfBoxes() != least); // with the large font
                present(false);
            }
            QTRY_COMPARE(dock->width(), width);
            QCOMPARE(leastOfBoxes(), least);
        }
    }

    /// A window that is closed in a lecture opens as it was before.
    void closesAsItWas()
    {
        present(true);
        window_->close();
        QVERIFY(!window_->presenter().on());
        window_ = std::make_unique<MainWindow>();
        window_->restoreArrangement();
        window_->show();
        QVERIFY(!window_->isFullScreen() && window_->actions().toolBar->isVisible());
        QVERIFY(!window_->presenter().bar()->isVisible());
        QVERIFY(window_->findChild<QDockWidget*>("parameters")->isVisible());
    }

private:
    void present(bool on)
    {
        window_->actions().presenter->setChecked(on);
        QCoreApplication::processEvents();
        QCOMPARE(window_->presenter().on(), on);
    }
    QString caption() { return window_->presenter().bar()->findChild<QLabel*>()->text(); }
    QList<QDockWidget*> docks() { return window_->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly); }
    std::map<QString, QRect> places()
    {
        std::map<QString, QRect> all;
        for (const QDockWidget* dock : docks())
            if (dock->isVisible() && !dock->visibleRegion().isEmpty()) all[dock->objectName()] = dock->geometry();
        all["page"] = window_->centralWidget()->geometry();
        return all;
    }
    /// The font of a widget and, if it is shown, its place.
    static QString look(const QWidget& widget)
    {
        QString text;
        QDebug debug(&text);
        debug << widget.metaObject()->className() << widget.accessibleName() << widget.font().toString();
        if (widget.isVisible()) debug << widget.geometry();
        return text;
    }
    using Looks = std::vector<std::pair<QPointer<QWidget>, QString>>;
    Looks looks()
    {
        Looks all;
        for (QWidget* widget : window_->findChildren<QWidget*>()) all.emplace_back(widget, look(*widget));
        return all;
    }
    /// Since then. A hidden helper of Qt may have gone.
    static QString changes(const Looks& before)
    {
        QStringList lines;
        for (const auto& [widget, then] : before)
            if (widget ? look(*widget) != then : then.contains(QLatin1String("QRect")))
                lines << then + QStringLiteral(" -> ") + (widget ? look(*widget) : QString());
        return lines.join(u'\n');
    }
    static QString difference(const std::map<QString, QRect>& before, const std::map<QString, QRect>& after)
    {
        QString text;
        QDebug debug(&text);
        for (const auto& [name, place] : before) {
            const auto found = after.find(name);
            debug << name << place << (found == after.end() ? QRect() : found->second);
        }
        return text;
    }

    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestPresenter)

} // namespace test_presenter

#include "test_presenter.moc"
