// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window with a case of the model "contact": its pages, its run, and what is said of it.
#include <QDockWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/disk/disk_surface_view.h"
#include "ui/lists/record_panel.h"
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
#include "ui/style/message_strip.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_main_window_contact {

/// A window on the sphere of Hertz with a coarse patch.
struct Fixture : test::WindowFixture {
    Fixture() : WindowFixture("contact_hertz")
    {
        edit("elastic.cell", QStringLiteral("0.5 um"));
        edit("run.sample_interval", QStringLiteral("20 us"));
        edit("run.field_snapshots", QStringLiteral("11"));
    }

    bool offered(RunView::Page page) { return window.runView().tabs()->isTabVisible(static_cast<int>(page)); }
};

class TestMainWindowContact : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void runsTheSampleCases_data();
    void runsTheSampleCases();
    void showsThePanesOfARun();
    void offersThePagesOfTheCase();
    void mapsFollowTheChosenRun();
    void goingThroughMapsMovesTheCursor();
    void runsOfAnotherModelLeaveThePlots();
    void showsTheDiskThatIsEdited();
    void groupsTheParameters();
    void keepsMapsInAFile();
    void exportsEachPage();
    void fitsASmallScreen();
    void helpTellsOfContact();
    void namesEveryControl();
};

void TestMainWindowContact::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_main_window_contact"));
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestMainWindowContact::runsTheSampleCases_data()
{
    QTest::addColumn<QString>("name");
    for (const SampleCase& sample : sampleCases())
        if (openCase(sample.name).value.model == ModelKind::Contact)
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
}

void TestMainWindowContact::runsTheSampleCases()
{
    QFETCH(const QString, name);
    Fixture f;
    f.window.files().openNow(name);
    // Few and coarse states: what the window shows of them is the question here.
    if (findParameter("elastic.cell")->used(f.window.edits().value()))
        f.edit("elastic.cell", QStringLiteral("0.25 um"));
    f.edit("run.sample_interval", QString::number(f.window.edits().value().run.duration / 20.0) + QStringLiteral(" s"));
    QCOMPARE(f.window.edits().reasonNotToRun(), QString());
    const RunRecord& run = f.runToEnd();
    QCOMPARE(run.summary->status, RunStatus::Completed);
    QCOMPARE(run.fields.size(), recordedFields(run.value).size());
    for (const FieldHistory& history : run.fields) QVERIFY(!history.snapshots.empty());
    QVERIFY(f.window.runView().plots()->plot(QStringLiteral("force_separation"))->isVisible());
    QVERIFY(!f.window.runView().spectrum()->isVisible());
    QVERIFY2(f.window.messages().text().contains(QStringLiteral("Largest contact force ")),
             qPrintable(f.window.messages().text()));
    QVERIFY(f.window.aboutCase().toPlainText().contains(QStringLiteral("Its figures")));
}

void TestMainWindowContact::showsThePanesOfARun()
{
    Fixture f;
    QVERIFY(f.window.runView().isVisible());
    QVERIFY(f.dock("runs")->isVisible() && f.dock("values")->isVisible());
    QVERIFY(!f.dock("attitude")->isVisible());
    QVERIFY(f.window.actions().pause->isVisible());
}

void TestMainWindowContact::offersThePagesOfTheCase()
{
    Fixture f;
    QVERIFY(f.offered(RunView::Page::Maps) && f.offered(RunView::Page::Disk));
    f.window.runView().setPage(RunView::Page::Maps);
    // A law that knows forces alone has neither maps nor a surface.
    f.edit("contact", QStringLiteral("asperity"));
    QVERIFY(!f.offered(RunView::Page::Maps) && !f.offered(RunView::Page::Disk));
    QVERIFY(!f.window.runView().tabs()->isVisible());
    QCOMPARE(f.window.runView().page(), RunView::Page::Plots);
    QVERIFY(f.window.runView().plots()->isVisible());
    f.window.edits().undoStack().setClean();
    f.window.files().openNow(QStringLiteral("fig10a"));
    QVERIFY(f.offered(RunView::Page::Side) && !f.offered(RunView::Page::Maps) && !f.offered(RunView::Page::Disk));
    QVERIFY(f.window.runView().spectrum()->isVisible());
    f.window.files().openNow(QStringLiteral("springs_waviness"));
    QVERIFY(f.offered(RunView::Page::Side) && !f.offered(RunView::Page::Maps) && f.offered(RunView::Page::Disk));
}

void TestMainWindowContact::mapsFollowTheChosenRun()
{
    Fixture f;
    f.window.runView().setPage(RunView::Page::Maps);
    f.runToEnd();
    RunMaps& maps = *f.window.runView().maps();
    QCOMPARE(maps.shownRun(), 1);
    QVERIFY(!maps.empty());
    f.runToEnd();
    QCOMPARE(maps.shownRun(), 2);
    f.window.runWindow().panel()->list()->setCurrentIndex(f.window.runs().index(0));
    QCOMPARE(maps.shownRun(), 1);
}

void TestMainWindowContact::goingThroughMapsMovesTheCursor()
{
    Fixture f;
    f.window.runView().setPage(RunView::Page::Maps);
    const RunRecord& run = f.runToEnd();
    f.window.runView().maps()->time()->setValue(2);
    QCOMPARE(*f.window.runView().plots()->group()->cursor(0), run.fields.front().snapshots[2].time);
}

void TestMainWindowContact::runsOfAnotherModelLeaveThePlots()
{
    Fixture f;
    f.runToEnd();
    f.window.edits().undoStack().setClean();
    f.window.files().openNow(QStringLiteral("fig10a"));
    QVERIFY(f.runToEnd().shown);
    QVERIFY(!f.window.runs().record(0).shown);
    QVERIFY(!f.window.runView().plots()->plot(QStringLiteral("pressure"))->isVisible());
    QVERIFY(f.window.runView().plots()->plot(QStringLiteral("pitch"))->isVisible());
}

void TestMainWindowContact::showsTheDiskThatIsEdited()
{
    Fixture f;
    f.window.runView().setPage(RunView::Page::Disk);
    DiskSurfaceView& disk = *f.window.runView().disk();
    QVERIFY(disk.empty());
    f.edit("disk.surface.kind", QStringLiteral("rough"));
    f.edit("disk.surface.track", QStringLiteral("100 um"));
    QTRY_VERIFY_WITH_TIMEOUT(!disk.empty(), 20'000);
    f.edit("disk.surface.rms", QStringLiteral("0.4 nm"));
    QTRY_COMPARE_WITH_TIMEOUT(disk.statistics()->text(0, 1), readout(0.4e-9, "nm", 4), 20'000);
}

void TestMainWindowContact::groupsTheParameters()
{
    Fixture f;
    QStringList titles;
    for (const QToolButton* header : f.window.casePanel().findChildren<QToolButton*>())
        if (header->isVisibleTo(&f.window) && header->accessibleName().startsWith(QStringLiteral("Group ")))
            titles << header->text();
    QCOMPARE(titles, (QStringList{"Model", "Slider", "Contact pad", "Approach and retraction", "Elastic contact",
                                  "Intermolecular adhesion", "Disk surface", "Run and numerics"}));
    const auto shown = [&](const char* key) { return f.window.casePanel().editor(key)->isVisibleTo(&f.window); };
    QVERIFY(shown("pad.radius") && !shown("disk.surface.rms") && !shown("springs.cutoff") && !shown("run.tolerance"));
    f.edit("disk.surface.kind", QStringLiteral("waves"));
    QVERIFY(shown("disk.surface.wave_amplitudes") && !shown("disk.surface.file"));
    f.edit("disk.surface.wave_amplitudes", QStringLiteral("1, 2"));
    QCOMPARE(f.window.edits().value().diskSurface.waveAmplitudes, (std::vector<double>{1e-9, 2e-9}));
    f.edit("disk.surface.kind", QStringLiteral("file"));
    QVERIFY(shown("disk.surface.file") && !shown("disk.surface.wave_amplitudes"));
}

void TestMainWindowContact::keepsMapsInAFile()
{
    const QTemporaryDir folder;
    Fixture f;
    f.window.runView().setPage(RunView::Page::Maps);
    const RunRecord& run = f.runToEnd();
    const QString file = folder.filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(run, file), QString());
    f.window.files().open(file);
    const RunRecord& read = f.window.runs().record(1);
    QCOMPARE(read.fields.size(), std::size_t{1});
    const FieldHistory& kept = read.fields.front();
    const FieldHistory& seen = run.fields.front();
    QCOMPARE(kept.snapshots.size(), seen.snapshots.size());
    QCOMPARE(kept.fields.grid.x, seen.fields.grid.x);
    for (std::size_t i = 0; i < seen.snapshots.size(); ++i) {
        QCOMPARE(kept.snapshots[i].time, seen.snapshots[i].time);
        QCOMPARE(kept.snapshots[i].values, seen.snapshots[i].values);
    }
    QCOMPARE(f.window.runView().maps()->shownRun(), 2);
    QVERIFY(!f.window.runView().maps()->empty());
}

void TestMainWindowContact::exportsEachPage()
{
    const QTemporaryDir folder;
    Fixture f;
    f.runToEnd();
    f.edit("disk.surface.kind", QStringLiteral("rough"));
    f.edit("disk.surface.track", QStringLiteral("100 um"));
    for (const RunView::Page page : {RunView::Page::Plots, RunView::Page::Maps, RunView::Page::Disk}) {
        f.window.runView().setPage(page);
        if (page == RunView::Page::Disk) QTRY_VERIFY_WITH_TIMEOUT(!f.window.runView().disk()->empty(), 20'000);
        const QString file = folder.filePath(QStringLiteral("page.png"));
        QCOMPARE(savePicture(*f.window.page(), file), QString());
        const QImage image(file);
        int coloured = 0;
        for (int y = 0; y < image.height(); y += 4)
            for (int x = 0; x < image.width(); x += 4) coloured += image.pixelColor(x, y).saturation() > 60;
        QVERIFY2(coloured > 300, qPrintable(QStringLiteral("page %1: %2").arg(static_cast<int>(page)).arg(coloured)));
    }
}

void TestMainWindowContact::fitsASmallScreen()
{
    Fixture f;
    f.runToEnd();
    for (const RunView::Page page : {RunView::Page::Plots, RunView::Page::Maps, RunView::Page::Disk}) {
        f.window.runView().setPage(page);
        const QSize least = f.window.minimumSizeHint();
        QVERIFY2(least.width() <= 1280 && least.height() <= 800,
                 qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
    }
}

void TestMainWindowContact::helpTellsOfContact()
{
    HelpWindow help({});
    help.open(HelpWindow::Page::Contact);
    for (const char* word : {"Polonsky", "Greenwood", "Lennard", "roll-off", "assumptions"})
        QVERIFY2(help.text().contains(QLatin1String(word), Qt::CaseInsensitive), word);
}

void TestMainWindowContact::namesEveryControl()
{
    Fixture f;
    f.runToEnd();
    for (const RunView::Page page : {RunView::Page::Plots, RunView::Page::Maps, RunView::Page::Disk}) {
        f.window.runView().setPage(page);
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

TOUCHDOWN_TEST(TestMainWindowContact)

} // namespace test_main_window_contact

#include "test_main_window_contact.moc"
