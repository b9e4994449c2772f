// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window with a case of a film: its two pages, their panes, and the ways from the case to the static attitude and
// to a run in time.
#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/cml_case.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/contact_rest.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/window_fixture.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/disk/disk_surface_view.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/maps/fields_view.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_maps.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/runs/side_view.h"
#include "ui/slider/attitude_table.h"
#include "ui/slider/surface_view.h"
#include "ui/style/message_strip.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_main_window_film {

using State = SteadyController::State;

/// A window on a film case with a coarse grid.
struct Fixture : test::WindowFixture {
    explicit Fixture(const char* sample = "film_pico") : WindowFixture(sample)
    {
        edit("film.nodes", QStringLiteral("33, 33"));
    }

    const SteadyResult& solve()
    {
        toEnd([this] { window.solveStaticState(); });
        return *window.film().result();
    }
    /// 40 us from 2 nm above the static state on a coarse grid, a sample each 0.5 us and three snapshots.
    void editToRun()
    {
        edit("run.duration", QStringLiteral("40 us"));
        edit("run.sample_interval", QStringLiteral("0.5 us"));
        edit("run.field_snapshots", QStringLiteral("3"));
        edit("initial.state", QStringLiteral("static"));
        edit("initial.height_offset", QStringLiteral("2 nm"));
        if (!window.edits().reasonNotToRun().isEmpty()) qFatal("%s", qPrintable(window.edits().reasonNotToRun()));
    }
};

class TestMainWindowFilm : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void solvesTheSampleCases_data();
    void solvesTheSampleCases();
    void solvesAtTheGivenAttitude();
    void showsThePanesOfTheModel();
    void closedPanesStayClosed();
    void offersTheActionsOfTheModel();
    void runsInTime();
    void showsAndKeepsTheMapsOfARun();
    void eachPageHasItsPanes();
    void stopsARunAtOnce();
    void stopsASolution();
    void followsEditsOfTheCase();
    void importsByDrop();
    void closesWhileSolving();
    void exportsThePage();
    void fitsASmallScreen();
    void namesEveryControl();
};

void TestMainWindowFilm::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_main_window_film"));
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestMainWindowFilm::solvesTheSampleCases_data()
{
    QTest::addColumn<QString>("name");
    for (const SampleCase& sample : sampleCases())
        if (sample.name.starts_with("film_")) QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
}

void TestMainWindowFilm::solvesTheSampleCases()
{
    QFETCH(const QString, name);
    Fixture f(name.toLatin1().constData());
    const SteadyResult& shown = f.solve();
    // What the window shows is what the core says.
    const SteadyResult alone = steadyWithContact(f.window.edits().value());
    QCOMPARE(shown.status, SteadyStatus::Converged);
    QCOMPARE(shown.attitude.height, alone.attitude.height);
    QCOMPARE(shown.pressure, alone.pressure);
    QVERIFY(f.window.messages().kind() == MessageStrip::Kind::Success ||
            f.window.messages().kind() == MessageStrip::Kind::Warning);
    QVERIFY(f.window.messages().text().contains(withError(alone.attitude.height, 0.0, "nm")));
    // A text without formats has plain spaces.
    QVERIFY(f.window.aboutCase().toPlainText().contains(
        withError(alone.attitude.height, 0.0, "nm").replace(QChar(0x00A0), QLatin1Char(' '))));
}

void TestMainWindowFilm::solvesAtTheGivenAttitude()
{
    Fixture f;
    const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
    f.window.actions().solveGiven->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
    const Case& c = f.window.edits().value();
    QCOMPARE(f.window.film().result()->attitude.height, c.initial.nominalTrailingEdgeHeight);
    QCOMPARE(f.window.film().result()->attitude.pitch, c.initial.pitch);
    QVERIFY(!c.steady.fixedAttitude); // the case stays as it is
}

void TestMainWindowFilm::showsThePanesOfTheModel()
{
    Fixture f;
    QVERIFY(f.window.film().view()->isVisible());
    QVERIFY(!f.window.runView().plots()->isVisible());
    QVERIFY(f.dock("attitude")->isVisible());
    QVERIFY(!f.dock("runs")->isVisible());
    QVERIFY(!f.dock("values")->isVisible());
    QVERIFY(f.dock("parameters")->isVisible() && f.dock("about")->isVisible());
    f.window.edits().undoStack().setClean();
    f.window.files().openNow(QStringLiteral("fig10a"));
    QVERIFY(!f.window.film().view()->isVisible());
    QVERIFY(f.window.runView().plots()->isVisible());
    QVERIFY(!f.dock("attitude")->isVisible());
    QVERIFY(f.dock("runs")->isVisible());
    QVERIFY(f.dock("values")->isVisible());
}

void TestMainWindowFilm::closedPanesStayClosed()
{
    Fixture f("fig10a");
    f.dock("values")->close();
    f.window.files().openNow(QStringLiteral("film_pico"));
    f.dock("attitude")->close();
    f.window.files().openNow(QStringLiteral("fig10b"));
    QVERIFY(!f.dock("values")->isVisible());
    QVERIFY(f.dock("runs")->isVisible());
    f.window.files().openNow(QStringLiteral("film_pico"));
    QVERIFY(!f.dock("attitude")->isVisible());
}

void TestMainWindowFilm::offersTheActionsOfTheModel()
{
    Fixture f;
    const WindowActions& actions = f.window.actions();
    QVERIFY(actions.solveGiven->isVisible() && actions.solveGiven->isEnabled());
    QVERIFY(actions.exportCml->isVisible() && actions.exportDxf->isVisible());
    QVERIFY(actions.solve->isVisible() && actions.run->isVisible());
    for (const QAction* action : {actions.pause, actions.step, actions.follow, actions.zoomBack})
        QVERIFY(!action->isVisible());
    f.window.setPage(MainWindow::Page::Run);
    for (const QAction* action :
         {actions.solve, actions.solveGiven, actions.run, actions.pause, actions.step, actions.follow})
        QVERIFY(action->isVisible());
    f.window.setPage(MainWindow::Page::StaticState);
    f.edit("suspension.preload", QStringLiteral("nonsense"));
    for (const QAction* action : {actions.run, actions.solve, actions.solveGiven}) QVERIFY(!action->isEnabled());
    f.window.actions().undo->trigger();
    f.window.files().openNow(QStringLiteral("fig10a"));
    QVERIFY(!actions.solve->isVisible() && !actions.solveGiven->isVisible());
    QVERIFY(actions.pause->isVisible());
}

void TestMainWindowFilm::runsInTime()
{
    Fixture f;
    f.editToRun();
    const RunRecord& run = f.runToEnd();
    QVERIFY2(run.summary->status == RunStatus::Completed, run.summary->message.c_str());
    QVERIFY(f.window.runView().isVisible());
    QCOMPARE(run.sampleCount(), std::size_t(81));
    const QString told = f.window.messages().text();
    QVERIFY2(told.contains(QStringLiteral("with minimum spacing ")) && told.contains(QStringLiteral(" pitch ")),
             qPrintable(told));
    QVERIFY(f.window.aboutCase().toPlainText().contains(QStringLiteral("with minimum spacing ")));
    for (const char* name : {"spacing", "pitch", "roll", "energy"})
        QVERIFY2(f.window.runView().plots()->plot(QString::fromLatin1(name))->isVisible(), name);
    // Without contact there are no forces of contact to show, and what is asked for comes.
    QVERIFY(!f.window.runView().plots()->plot(QStringLiteral("forces"))->isVisible());
    for (const char* name : {"air_bearing", "velocity", "angular_velocity", "step"}) {
        QVERIFY2(!f.window.runView().plots()->plot(QString::fromLatin1(name))->isVisible(), name);
        f.window.runView().plots()->entry(QString::fromLatin1(name)).wanted->trigger();
        QVERIFY2(f.window.runView().plots()->plot(QString::fromLatin1(name))->isVisible(), name);
    }
    QVERIFY(f.window.runView().spectrum()->isVisible());
    f.edit("degrees_of_freedom", QStringLiteral("2")); // roll is held
    QVERIFY(!f.window.runView().plots()->plot(QStringLiteral("roll"))->isVisible());
    // The time step is positive once there was a step.
    QVERIFY(*run.last("time_step") > 0.0);
}

void TestMainWindowFilm::showsAndKeepsTheMapsOfARun()
{
    const QTemporaryDir folder;
    Fixture f;
    f.editToRun();
    const RunRecord& run = f.runToEnd();
    QCOMPARE(run.fields.size(), std::size_t(1)); // the air alone: nothing touches
    QVERIFY(run.fields.front().snapshots.size() >= 3);
    f.window.runView().setPage(RunView::Page::Maps);
    const RunMaps& maps = *f.window.runView().maps();
    QVERIFY(!maps.empty());
    QCOMPARE(maps.time()->value(), maps.time()->maximum());
    QCOMPARE(f.window.runView().side()->state()->time, run.lastTime());
    maps.time()->setValue(0); // the side view goes along
    QCOMPARE(f.window.runView().side()->state()->time, 0.0);

    const QString file = folder.filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(run, file), QString());
    f.window.setPage(MainWindow::Page::StaticState);
    f.window.files().open(file); // what was read is there to be seen
    QVERIFY(f.window.runView().isVisible());
    const RunRecord& read = f.window.runs().record(1);
    QCOMPARE(read.fields.front().snapshots.size(), run.fields.front().snapshots.size());
    QCOMPARE(read.fields.front().snapshots[1].values, run.fields.front().snapshots[1].values);
}

void TestMainWindowFilm::eachPageHasItsPanes()
{
    Fixture f;
    const auto* tabs = f.window.findChild<QTabBar*>(QStringLiteral("pages"));
    QVERIFY(tabs->isVisible());
    f.window.setPage(MainWindow::Page::Run);
    QVERIFY(f.window.runView().isVisible() && !f.window.film().view()->isVisible());
    QVERIFY(f.dock("runs")->isVisible() && f.dock("values")->isVisible() && !f.dock("attitude")->isVisible());
    QVERIFY(f.window.runWindow().progress()->isVisible() && !f.window.film().progress()->isVisible());
    f.dock("values")->close();
    f.window.setPage(MainWindow::Page::StaticState);
    QVERIFY(f.dock("attitude")->isVisible() && !f.dock("runs")->isVisible());
    QVERIFY(!f.window.runWindow().progress()->isVisible() && f.window.film().progress()->isVisible());
    f.window.setPage(MainWindow::Page::Run);
    QVERIFY(f.dock("runs")->isVisible() && !f.dock("values")->isVisible());
    f.window.actions().solve->trigger(); // its result is on the other page
    QVERIFY(f.window.film().view()->isVisible());
    f.window.edits().undoStack().setClean();
    f.window.files().openNow(QStringLiteral("fig10a"));
    QVERIFY(!tabs->isTabVisible(static_cast<int>(MainWindow::Page::StaticState)) && f.window.runView().isVisible());
}

/// In the static state that begins it, and in its steps.
void TestMainWindowFilm::stopsARunAtOnce()
{
    for (const bool inSteps : {false, true}) {
        Fixture f;
        f.editToRun();
        f.edit("run.duration", QStringLiteral("1 s"));
        f.edit("run.sample_interval", QStringLiteral("1 us"));
        if (!inSteps) f.edit("film.nodes", QStringLiteral("513, 513"));
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.window.startRun();
        QTRY_COMPARE(f.window.controller().state(), RunController::State::Running);
        if (inSteps) QTRY_VERIFY_WITH_TIMEOUT(f.window.runs().record(0).sampleCount() > 10, 60'000);
        f.window.actions().stop->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        QCOMPARE(f.window.runs().record(0).summary->status, RunStatus::Cancelled);
        QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Information);
    }
}

void TestMainWindowFilm::stopsASolution()
{
    Fixture f;
    f.edit("film.nodes", QStringLiteral("513, 513"));
    const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
    f.window.solveStaticState();
    QTRY_VERIFY(!f.window.film().progress()->text().isEmpty());
    QVERIFY(f.window.actions().stop->isEnabled());
    f.window.actions().stop->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
    QCOMPARE(ended[0][0].toBool(), false);
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Information);
    QVERIFY(!f.window.actions().stop->isEnabled());
}

void TestMainWindowFilm::followsEditsOfTheCase()
{
    Fixture f;
    f.solve();
    QVERIFY(!f.window.film().stale());
    f.edit("abs.crown", QStringLiteral("30"));
    QVERIFY(f.window.film().stale());
    QCOMPARE(f.window.film().view()->surface()->surface().crown, 30e-9);
    f.window.actions().undo->trigger();
    QVERIFY(!f.window.film().stale());
}

void TestMainWindowFilm::importsByDrop()
{
    const QTemporaryDir folder;
    const QString cml = folder.filePath(QStringLiteral("slider"));
    const CmlOutput output = formatCmlCase(openCase("film_pico").value);
    QCOMPARE(output.problem, std::string());
    QCOMPARE(writeCmlCase(cml.toStdString(), output.members), std::string());

    MainWindow window;
    window.files().openNow(QStringLiteral("fig10a"));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(cml)});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &drop);
    QCOMPARE(window.edits().value().model, ModelKind::Film);
    QCOMPARE(window.edits().value().surface, openCase("film_pico").value.surface);
    QVERIFY2(window.messages().text().startsWith(QStringLiteral("Imported: ")), qPrintable(window.messages().text()));
    QVERIFY(window.windowTitle().startsWith(QStringLiteral("slider")));
}

void TestMainWindowFilm::closesWhileSolving()
{
    Fixture f;
    f.window.edits().undoStack().setClean();
    f.window.solveStaticState();
    f.window.close();
    answer(f.window, "closing", QStringLiteral("Close without saving"));
    QVERIFY(!f.window.isVisible());
    // The next session begins with the panes of a run, whatever was shown last.
    MainWindow next;
    next.restoreArrangement();
    next.show();
    QVERIFY(!next.findChild<QDockWidget*>(QStringLiteral("attitude"))->isVisible());
    QVERIFY(next.findChild<QDockWidget*>(QStringLiteral("runs"))->isVisible());
}

void TestMainWindowFilm::exportsThePage()
{
    const QTemporaryDir folder;
    Fixture f;
    f.solve();
    f.window.film().view()->setPage(FilmView::Page::Pressure);
    const QString file = folder.filePath(QStringLiteral("page.png"));
    QCOMPARE(savePicture(*f.window.page(), file), QString());
    // Colours of the map and the sections on white paper.
    const QImage image(file);
    QVERIFY(image.width() == 2 * f.window.page()->width());
    int coloured = 0;
    for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4) coloured += image.pixelColor(x, y).saturation() > 60;
    QVERIFY2(coloured > 500, qPrintable(QString::number(coloured)));
}

void TestMainWindowFilm::fitsASmallScreen()
{
    Fixture f;
    f.solve();
    f.window.film().view()->setPage(FilmView::Page::Gap);
    QVERIFY2(f.window.minimumSizeHint().width() <= 1280,
             qPrintable(QString::number(f.window.minimumSizeHint().width())));
    QVERIFY2(f.window.minimumSizeHint().height() <= 800,
             qPrintable(QString::number(f.window.minimumSizeHint().height())));
}

void TestMainWindowFilm::namesEveryControl()
{
    Fixture f;
    f.solve();
    for (const FilmView::Page page : {FilmView::Page::Surface, FilmView::Page::Gap}) {
        f.window.film().view()->setPage(page);
        for (const QWidget* widget : f.window.findChildren<QWidget*>()) {
            if (!widget->isVisibleTo(&f.window) || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy())
                continue;
            if (widget->objectName().startsWith(QLatin1String("qt_")) || widget->inherits("QScrollBar")) continue;
            const bool named = !widget->accessibleName().isEmpty() || !widget->property("text").toString().isEmpty();
            QVERIFY2(named, qPrintable(QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') +
                                       widget->objectName()));
        }
    }
}

TOUCHDOWN_TEST(TestMainWindowFilm)

} // namespace test_main_window_film

#include "test_main_window_film.moc"
