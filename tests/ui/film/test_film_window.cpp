// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_window.h"

#include <atomic>
#include <memory>
#include <thread>

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>

#include "core/simulation/static_state/film_setup.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/sample_slider.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/film_view.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/film/series_setup.h"
#include "ui/film/surface_page.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/maps/fields_view.h"
#include "ui/plot/plot_export.h"
#include "ui/slider/attitude_table.h"
#include "ui/slider/surface_view.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_film_window {

using Page = FilmView::Page;
using State = SteadyController::State;

class TestFilmWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void showsTheSurfaceBeforeASolution();
    void offersToSolveWhereThereIsNoResult();
    void showsTheResultEverywhere();
    void solvesAtTheGivenAttitude();
    void anEditMakesTheResultStale();
    void anEditBackMakesItFresh();
    void whatDoesNotMatterDoesNotMakeItStale();
    void anEditWhileSolvingIsNoticed();
    void stoppedKeepsTheLastResult();
    void notConvergedIsShownAllTheSame();
    void drawingIsCalm();
    void anotherCaseForgetsTheResult();
    void reportsProgress();
    void tabsChooseTheField();
    void modesAndSeriesHaveTheirPages();
    void oneActionStopsModesAndSeries();
    void theGridIsOnBoth();
    void copiesTheTables();
    void exportsThePage();
    void ambientPressureOfTheAir();

private:
    QString attitudeText() const { return film_->attitude()->findChild<QTextBrowser*>()->toPlainText(); }
    QCheckBox* gridShown() const { return namedWidget<QCheckBox>(*film_->view(), QStringLiteral("Grid")); }
    void solve(bool given = false)
    {
        QSignalSpy solved(film_, &FilmWindow::solved);
        film_->solve(case_, given);
        QTRY_COMPARE(solved.count(), 1);
    }

    std::unique_ptr<QWidget> window_;
    QAction* action_ = nullptr;
    FilmWindow* film_ = nullptr;
    Case case_;
    std::atomic<bool> fixed_ = false;   // what the solver was asked for
    std::atomic<int> searches_ = 0;     // begun
    std::atomic<bool> waiting_ = false; // the solver goes on until it is stopped
    SteadyStatus status_ = SteadyStatus::Converged;
};

void TestFilmWindow::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestFilmWindow::init()
{
    case_ = sampleFilmCase();
    fixed_ = false;
    waiting_ = false;
    searches_ = 0;
    status_ = SteadyStatus::Converged;
    window_ = std::make_unique<QWidget>();
    action_ = new QAction(QStringLiteral("Solve"), window_.get());
    film_ = new FilmWindow(
        [this](const Case& c, const SteadyCallback& callback) {
            fixed_ = c.steady.fixedAttitude;
            ++searches_;
            int iteration = 0;
            while (callback({"grid 97 x 97", ++iteration, 2e-5, 1e-3, {9e-9, 95e-6, 0.0}}) && waiting_)
                std::this_thread::yield();
            if (waiting_) {
                SteadyResult stopped;
                stopped.status = SteadyStatus::Cancelled;
                return stopped;
            }
            SteadyResult result = sampleResult(c);
            result.status = status_;
            return result;
        },
        action_, window_.get());
    film_->view()->resize(900, 700);
    film_->open(case_);
    window_->resize(900, 700);
    window_->show();
}

void TestFilmWindow::cleanup() { window_.reset(); }

void TestFilmWindow::showsTheSurfaceBeforeASolution()
{
    QCOMPARE(film_->view()->page(), Page::Surface);
    QVERIFY(film_->view()->surface()->isVisible());
    QCOMPARE(film_->view()->surface()->surface(), case_.surface);
    QVERIFY(!gridShown()->isEnabled());
    QVERIFY(film_->attitude()->sections().empty());
}

void TestFilmWindow::offersToSolveWhereThereIsNoResult()
{
    film_->view()->setPage(Page::Gap);
    QVERIFY(!film_->view()->maps()->isVisible());
    QSignalSpy asked(action_, &QAction::triggered);
    QToolButton* button = nullptr;
    for (QToolButton* candidate : film_->view()->findChildren<QToolButton*>())
        if (candidate->defaultAction() == action_) button = candidate;
    QVERIFY(button && button->isVisible());
    button->click();
    QCOMPARE(asked.count(), 1);
}

void TestFilmWindow::showsTheResultEverywhere()
{
    solve();
    const SteadyResult& result = *film_->result();
    QCOMPARE(film_->view()->surface()->minimumSpacingAt()->x, result.minimumAt.x);
    QCOMPARE(film_->view()->surface()->grid().nx(), 48);
    QVERIFY(attitudeText().contains(QStringLiteral("Minimum spacing")));
    film_->view()->setPage(Page::Pressure);
    QVERIFY(film_->view()->maps()->isVisible());
    QCOMPARE(film_->view()->maps()->map()->value(3), result.pressure[3] - 101325.0);
    QVERIFY(!film_->stale());
    QVERIFY(!fixed_);
}

void TestFilmWindow::solvesAtTheGivenAttitude()
{
    solve(true);
    QVERIFY(fixed_);
    QVERIFY(!film_->stale()); // the case itself does not say so
}

void TestFilmWindow::anEditMakesTheResultStale()
{
    solve();
    case_.surface.rails[1].recess[0] = 5e-9;
    film_->edit(case_);
    QVERIFY(film_->stale());
    QVERIFY(!film_->view()->surface()->minimumSpacingAt()); // of another surface
    QVERIFY(attitudeText().startsWith(QStringLiteral("The parameters have changed since.")));
    solve();
    QVERIFY(!film_->stale());
    QVERIFY(film_->view()->surface()->minimumSpacingAt());
}

void TestFilmWindow::anEditBackMakesItFresh()
{
    solve();
    const double before = case_.suspension.preload;
    case_.suspension.preload = 2.0 * before;
    film_->edit(case_);
    QVERIFY(film_->stale());
    case_.suspension.preload = before;
    film_->edit(case_);
    QVERIFY(!film_->stale());
}

void TestFilmWindow::whatDoesNotMatterDoesNotMakeItStale()
{
    solve();
    case_.title = "Another name";
    film_->edit(case_);
    QVERIFY(!film_->stale());
}

void TestFilmWindow::anEditWhileSolvingIsNoticed()
{
    QSignalSpy solved(film_, &FilmWindow::solved);
    film_->solve(case_, false);
    case_.disk.speed *= 1.1;
    film_->edit(case_);
    QTRY_COMPARE(solved.count(), 1);
    QVERIFY(film_->stale());
}

void TestFilmWindow::stoppedKeepsTheLastResult()
{
    solve();
    const double before = film_->result()->minimumSpacing;
    waiting_ = true;
    QSignalSpy solved(film_, &FilmWindow::solved);
    film_->solve(case_, false);
    film_->controller().stop();
    QTRY_COMPARE(solved.count(), 1);
    QCOMPARE(film_->result()->status, SteadyStatus::Converged);
    QCOMPARE(film_->result()->minimumSpacing, before);
    QVERIFY(film_->progress()->findChild<QLabel*>()->text() == QStringLiteral("Stopped"));
}

void TestFilmWindow::notConvergedIsShownAllTheSame()
{
    status_ = SteadyStatus::NotConverged;
    solve();
    QCOMPARE(film_->result()->status, SteadyStatus::NotConverged);
    QVERIFY(attitudeText().contains(QStringLiteral("not converged")));
    QVERIFY(!film_->view()->maps()->map()->empty());
}

/// Rails that do not surround the place of the load are not solved by themselves. Of those that do, a search that
/// finds no state is told above the plan and remembered, but not listed; one that was asked for is listed. A wall that
/// no edge has changes nothing.
void TestFilmWindow::drawingIsCalm()
{
    SurfacePage* shape = film_->view()->shape();
    const auto draw = [&](const AirBearingSurface& surface) {
        case_.surface = surface;
        emit shape->edited(surface, QStringLiteral("draw"), 0);
        film_->edit(case_);
    };
    const auto says = [&](const char* words) { return shape->flightText().contains(QLatin1String(words)); };
    const double length = case_.slider.length, width = case_.slider.width;
    const auto bar = [&](double from, double to) {
        return Rail{RailKind::Step, {{from, 0.1 * width}, {to, 0.1 * width}, {to, 0.9 * width}, {from, 0.9 * width}}};
    };
    AirBearingSurface front;
    front.rails = {bar(0.1 * length, 0.3 * length)};
    AirBearingSurface both = front;
    both.rails.push_back(bar(0.8 * length, 0.9 * length));
    status_ = SteadyStatus::NotConverged;

    draw(front);
    QTRY_VERIFY2(says("do not surround"), qPrintable(shape->flightText()));
    QCOMPARE(searches_, 0);
    draw(both);
    QTRY_VERIFY2(says("It does not fly so"), qPrintable(shape->flightText()));
    QCOMPARE(searches_, 1);
    draw(front);
    QTRY_VERIFY(says("do not surround"));
    draw(both);
    QTRY_VERIFY(says("It does not fly so"));
    QCOMPARE(searches_, 1);
    QCOMPARE(film_->solutions().count(), 0);
    solve();
    QCOMPARE(film_->solutions().count(), 1);

    status_ = SteadyStatus::Converged;
    AirBearingSurface third = both;
    third.rails.push_back(bar(0.5 * length, 0.6 * length));
    draw(third);
    QTRY_COMPARE(film_->solutions().count(), 2);
    QVERIFY(!film_->stale());
    third.walls.push_back({{0.0, 4e-6}, {0.0, 2e-6}});
    draw(third);
    QVERIFY(!film_->stale());
    third.rails.back().points.front().wall = 1;
    draw(third);
    QVERIFY(film_->stale());
    QTRY_COMPARE(film_->solutions().count(), 3);
    QCOMPARE(searches_, 4);
}

void TestFilmWindow::anotherCaseForgetsTheResult()
{
    solve();
    case_.slider.length = 1.2e-3;
    film_->open(case_);
    QVERIFY(!film_->result());
    QVERIFY(film_->attitude()->sections().empty());
    QVERIFY(film_->view()->maps()->map()->empty());
    QVERIFY(!film_->view()->surface()->minimumSpacingAt());
    QCOMPARE(film_->view()->surface()->area().width(), 1.2e-3);
    QCOMPARE(film_->controller().state(), State::Idle);
}

void TestFilmWindow::reportsProgress()
{
    waiting_ = true;
    film_->solve(case_, false);
    film_->view()->setPage(Page::Gap);
    const auto says = [this](const QString& text) {
        for (const QLabel* label : film_->view()->findChildren<QLabel*>())
            if (label->isVisible() && label->text() == text) return true;
        return false;
    };
    QVERIFY(says(QStringLiteral("Solving…")));
    QTRY_VERIFY2(film_->progress()->text().startsWith(QStringLiteral("grid 97 × 97 · iteration ")),
                 qPrintable(film_->progress()->text()));
    QVERIFY(film_->progress()->text().contains(QStringLiteral("residual 2e−05")));
    QVERIFY(film_->progress()->text().contains(QStringLiteral("height 9\u00a0nm")));
    film_->controller().stopAndWait();
    QVERIFY(says(QStringLiteral("There is no solution yet.")));
}

void TestFilmWindow::tabsChooseTheField()
{
    solve();
    for (const auto& [page, title] : {std::pair(Page::Pressure, "Pressure above ambient"), std::pair(Page::Gap, "Gap"),
                                      std::pair(Page::Recess, "Recess")}) {
        film_->view()->setPage(page);
        QCOMPARE(film_->view()->maps()->map()->title(), QLatin1String(title));
        QVERIFY(film_->view()->maps()->controls()->isVisible());
    }
    film_->view()->setPage(Page::Surface);
    QVERIFY(!film_->view()->maps()->controls()->isVisible());
}

/// They have the case as it is edited, and results of their own.
void TestFilmWindow::modesAndSeriesHaveTheirPages()
{
    FilmView* view = film_->view();
    QVERIFY(!view->modes()->isVisible() && !view->series()->isVisible());
    view->setPage(Page::Modes);
    QVERIFY(view->modes()->isVisible());
    QVERIFY(!gridShown()->isVisible() && !view->maps()->controls()->isVisible());
    Case edited = case_;
    edited.steady.radii = {15e-3, 20e-3, 25e-3};
    film_->edit(edited);
    view->setPage(Page::Series);
    QVERIFY(view->series()->isVisible());
    view->series()->setup()->setChoice({.varied = Varied::Lists});
    QCOMPARE(view->series()->setup()->points().size(), std::size_t(3));
    view->setPage(Page::Gap);
    QVERIFY(gridShown()->isVisible());
    film_->open(case_);
    QVERIFY(view->series()->states().empty());
    QCOMPARE(view->series()->setup()->points().size(), std::size_t(9));
}

void TestFilmWindow::oneActionStopsModesAndSeries()
{
    FilmView* view = film_->view();
    QVERIFY(!view->busy());
    QSignalSpy changed(view, &FilmView::busyChanged);
    view->modes()->startOrStop();
    view->series()->startOrStop();
    QVERIFY(view->busy());
    QCOMPARE(changed.count(), 2);
    view->stop();
    QVERIFY(!view->busy());
    QTRY_VERIFY_WITH_TIMEOUT(!view->modes()->controller().active() && !view->series()->controller().active(), 30000);
}

void TestFilmWindow::theGridIsOnBoth()
{
    solve();
    const QImage surface = film_->view()->surface()->grab().toImage();
    gridShown()->click();
    QVERIFY(surface != film_->view()->surface()->grab().toImage());
    film_->view()->setPage(Page::Recess);
    const QImage with = film_->view()->maps()->map()->grab().toImage();
    gridShown()->click();
    QVERIFY(with != film_->view()->maps()->map()->grab().toImage());
}

void TestFilmWindow::copiesTheTables()
{
    solve();
    film_->attitude()->copy();
    const QString text = QGuiApplication::clipboard()->text();
    QVERIFY2(text.startsWith(QStringLiteral("Attitude\nNominal trailing edge height\t10.00\u00a0nm\n")),
             qPrintable(text.left(80)));
    QVERIFY(text.contains(QStringLiteral("Force [mN]\t2.500\t1.200\t0.003000")));
}

// What the page shows leaves as a picture of twice its pixels, in the colours of paper.
void TestFilmWindow::exportsThePage()
{
    const QTemporaryDir folder;
    QTRY_VERIFY(film_->view()->surface()->settled());
    const QString file = folder.filePath(QStringLiteral("page.png"));
    QCOMPARE(savePicture(*film_->view(), file), QString());
    const QImage image(file);
    QCOMPARE(image.size(), 2 * film_->view()->size());
    SurfaceView* surface = film_->view()->surface();
    const QPointF pad = surface->mapTo(film_->view(), surface->toPixel({0.2e-3, 0.2e-3}));
    QCOMPARE(image.pixelColor((2.0 * pad).toPoint()).rgb(), surface->scale().colour(0.0));
    for (const char* ending : {"svg", "pdf"}) {
        const QString other = folder.filePath(QStringLiteral("page.%1").arg(QLatin1String(ending)));
        QCOMPARE(savePicture(*film_->view(), other), QString());
        QVERIFY(QFileInfo(other).size() > 5000);
    }
}

// The standard atmosphere at 3000 m: 101325 (1 - 0.0065 * 3000/288.16)^5.256 = 70109 Pa.
void TestFilmWindow::ambientPressureOfTheAir()
{
    case_.air.given.pressure = 90e3;
    QCOMPARE(airOf(case_.air).pressure, 90e3);
    case_.air.source = AirSource::EstablishedStandard;
    QCOMPARE(airOf(case_.air).pressure, 101325.0);
    case_.air.source = AirSource::Atmosphere;
    case_.air.altitude = 3000.0;
    QVERIFY2(std::abs(airOf(case_.air).pressure - 70109.0) < 1.0,
             qPrintable(QString::number(airOf(case_.air).pressure)));
}

TOUCHDOWN_TEST(TestFilmWindow)

} // namespace test_film_window

#include "test_film_window.moc"
