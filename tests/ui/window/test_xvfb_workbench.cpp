// SPDX-License-Identifier: GPL-3.0-or-later
//
// The workbench as a person meets it: a real window on an X server, real keys and clicks from outside the program.
#include <set>
#include <utility>

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QImage>
#include <QLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
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
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_maps.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/runs/side_view.h"
#include "ui/slider/attitude_table.h"
#include "ui/studies/study_chart_view.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_table.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/style/theme.h"
#include "ui/window/figure_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_xvfb_workbench {

using State = RunController::State;

/// Keys and clicks by the X server, not by Qt.
void xdotool(const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(QStringLiteral("xdotool"), arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        qFatal("xdotool fails: %s", qPrintable(arguments.join(QLatin1Char(' '))));
}

void click(const QWidget* widget, const QPoint& at)
{
    const QPoint screen = widget->mapToGlobal(at);
    xdotool({QStringLiteral("mousemove"), QString::number(screen.x()), QString::number(screen.y()),
             QStringLiteral("click"), QStringLiteral("1")});
}

void click(const QWidget* widget) { click(widget, widget->rect().center()); }

void type(const QString& text)
{
    xdotool({QStringLiteral("type"), QStringLiteral("--delay"), QStringLiteral("5"), text});
}

void press(const char* key) { xdotool({QStringLiteral("key"), QString::fromLatin1(key)}); }

/// How many different colours an area has: an empty one has one, drawn text has many by its smooth edges.
std::size_t colours(const QImage& image)
{
    std::set<QRgb> found;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) found.insert(image.pixel(x, y));
    return found.size();
}

class TestXvfbWorkbench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void drawsText();
    void typesAFlyingHeightAndRuns();
    void refusesABadEntryUntilUndone();
    void opensASampleCaseByKeyboard();
    void goesThroughTheMapsOfAContact();
    void stopsByAClick();
    void showsAndWritesAStudy();
    void zoomsAndReadsAPlot();
    void comparesTwoRunsAndPrintsAFigure();
    void growsForAProjector();
    void fitsASmallScreen();

private:
    QLineEdit* flyingHeight()
    {
        QWidget* field = window_->casePanel().editor("springs.flying_height")->input();
        window_->casePanel().findChild<QScrollArea*>()->ensureWidgetVisible(field);
        return qobject_cast<QLineEdit*>(field);
    }
    QWidget* button(QAction* action) { return window_->actions().toolBar->widgetForAction(action); }

    std::unique_ptr<MainWindow> window_;
};

void TestXvfbWorkbench::initTestCase()
{
    QCOMPARE(QGuiApplication::platformName(), QStringLiteral("xcb"));
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_xvfb_workbench"));
    applyTheme(Theme::Light);
}

void TestXvfbWorkbench::init()
{
    QSettings().clear();
    window_ = std::make_unique<MainWindow>();
    window_->files().openNow(QStringLiteral("fig10a"));
    window_->move(0, 0);
    window_->resize(1280, 800);
    window_->show();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    // The rows of parameters have found their places in the pane.
    QPoint place;
    const auto rests = [&] {
        const QPoint now = flyingHeight()->mapToGlobal(QPoint());
        return std::exchange(place, now) == now;
    };
    QTRY_VERIFY(rests());
}

void TestXvfbWorkbench::drawsText()
{
    QLabel* label = nullptr;
    for (QLabel* candidate : window_->casePanel().editor("slider.mass")->findChildren<QLabel*>())
        if (candidate->text().startsWith(QStringLiteral("Mass"))) label = candidate;
    QVERIFY(label);
    QTRY_VERIFY(colours(label->grab().toImage()) > 5);
    // Without a font every letter is the same box.
    QVERIFY(label->fontMetrics().inFont(QLatin1Char('M')));
}

void TestXvfbWorkbench::typesAFlyingHeightAndRuns()
{
    click(flyingHeight());
    QTRY_VERIFY(flyingHeight()->hasFocus());
    press("ctrl+a");
    type(QStringLiteral("0.0032 um"));
    press("Return");
    QTRY_COMPARE(flyingHeight()->text(), QStringLiteral("3.2"));
    QCOMPARE(window_->edits().value().springs.flyingHeight, 3.2e-9);
    QVERIFY(window_->isWindowModified());
    QCOMPARE(namedWidget<QComboBox>(window_->casePanel(), QStringLiteral("Sample case"))->currentIndex(), -1);

    click(button(window_->actions().run));
    QTRY_COMPARE(window_->runs().count(), 1);
    QTRY_VERIFY(window_->runs().record(0).finished());
    QCOMPARE(window_->runs().record(0).value.springs.flyingHeight, 3.2e-9);
    // The curve is drawn: blue ink in the plot area.
    PlotWidget* plot = window_->runView().plots()->plot(QStringLiteral("spacing"));
    QTRY_VERIFY(colours(plot->grab(plot->plotArea().toRect()).toImage()) > 20);
}

void TestXvfbWorkbench::refusesABadEntryUntilUndone()
{
    click(flyingHeight());
    QTRY_VERIFY(flyingHeight()->hasFocus());
    press("ctrl+a");
    type(QStringLiteral("7 mN"));
    press("Return");
    QTRY_VERIFY(!window_->actions().run->isEnabled());
    QVERIFY(!window_->casePanel().editor("springs.flying_height")->reason().isEmpty());
    // F5 does nothing now; Ctrl+Z takes the entry back.
    press("F5");
    press("ctrl+z");
    QTRY_COMPARE(flyingHeight()->text(), QStringLiteral("7"));
    QVERIFY(window_->actions().run->isEnabled());
    QCOMPARE(window_->runs().count(), 0);
}

void TestXvfbWorkbench::opensASampleCaseByKeyboard()
{
    click(namedWidget<QComboBox>(window_->casePanel(), QStringLiteral("Sample case")));
    QTRY_VERIFY(QApplication::activePopupWidget());
    press("Down");
    press("Return");
    QTRY_COMPARE(window_->files().sample(), QStringLiteral("fig10b"));
    press("F5");
    QTRY_COMPARE(window_->runs().count(), 1);
    QTRY_VERIFY(window_->runs().record(0).finished());
}

void TestXvfbWorkbench::goesThroughTheMapsOfAContact()
{
    window_->files().openNow(QStringLiteral("contact_hertz"));
    const QTabBar* tabs = window_->runView().tabs();
    QTRY_VERIFY(tabs->isVisible());
    press("F5");
    QTRY_COMPARE(window_->runs().count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(window_->runs().record(0).finished(), 60'000);
    RunMaps* maps = window_->runView().maps();
    click(window_->runView().tabs(), tabs->tabRect(static_cast<int>(RunView::Page::Maps)).center());
    QTRY_VERIFY(maps->isVisible() && !maps->empty());
    // The pad is nearest to the disk half way through; arrow keys go on from there.
    const int nearest = maps->time()->value();
    QCOMPARE(maps->time()->maximum(), 2 * nearest);
    maps->time()->setFocus();
    press("Left");
    QTRY_COMPARE(maps->time()->value(), nearest - 1);
    press("Home");
    QTRY_COMPARE(maps->time()->value(), 0);
    QCOMPARE(*window_->runView().plots()->group()->cursor(0), 0.0);
    // A click on the map pins the sections there.
    const QPoint at = maps->view()->map()->toPixel({2e-6, 2e-6}).toPoint();
    click(maps->view()->map(), at);
    QTRY_VERIFY(maps->view()->pinned());
}

void TestXvfbWorkbench::stopsByAClick()
{
    window_->actions().pace->setCurrentIndex(window_->actions().pace->findData(1e-5));
    press("F5");
    QTRY_COMPARE(window_->controller().state(), State::Running);
    QTRY_VERIFY(window_->runs().record(0).sampleCount() > 10);
    click(button(window_->actions().stop));
    QTRY_COMPARE(window_->controller().state(), State::Idle);
    QCOMPARE(window_->runs().record(0).summary->status, RunStatus::Cancelled);
}

/// Its page by a click on its tab; what is typed into its text is a problem until it is taken back.
void TestXvfbWorkbench::showsAndWritesAStudy()
{
    auto* tabs = window_->findChild<QTabBar*>(QStringLiteral("pages"));
    click(tabs, tabs->tabRect(static_cast<int>(MainWindow::Page::Studies)).center());
    StudyEditor* editor = window_->studies().editor();
    QTRY_VERIFY(editor->isVisible() && window_->studies().results()->isVisible());
    QTRY_VERIFY(!editor->toText().isEmpty());
    QTRY_VERIFY2(editor->run()->isEnabled(), qPrintable(editor->problems()));
    QTabBar* views = editor->tabs()->tabBar();
    editor->layout()->activate(); // the names above it have just got their lines
    click(views, views->tabRect(1).center());
    auto* text = editor->findChild<QPlainTextEdit*>();
    QTRY_VERIFY(text->isVisible());
    click(text, QPoint(60, 12));
    QTRY_VERIFY(text->hasFocus());
    press("ctrl+End");
    type(QStringLiteral("no such key"));
    QTRY_VERIFY(!editor->run()->isEnabled());
    QVERIFY(!editor->problems().isEmpty());
    press("ctrl+z");
    QTRY_VERIFY(editor->run()->isEnabled());
}

void TestXvfbWorkbench::zoomsAndReadsAPlot()
{
    press("F5");
    QTRY_COMPARE(window_->runs().count(), 1);
    QTRY_VERIFY(window_->runs().record(0).finished());
    PlotWidget* plot = window_->runView().plots()->plot(QStringLiteral("spacing"));
    PlotGroup* group = window_->runView().plots()->group();
    QTRY_COMPARE(plot->xAxis().range().high, 0.3e-3); // where the default case moves
    const QPoint centre = plot->plotArea().center().toPoint();
    click(plot, centre);
    QTRY_VERIFY(group->cursor(0).has_value());
    const double before = plot->xAxis().range().width();
    xdotool({QStringLiteral("click"), QStringLiteral("4")}); // wheel, away from the user
    QTRY_VERIFY(plot->xAxis().range().width() < before);
    QVERIFY(!window_->actions().follow->isChecked());
    click(button(window_->actions().fit));
    QTRY_COMPARE(plot->xAxis().range().high, 2e-3); // all of the run
}

/// A researcher's path: two runs, their spectra read at two frequencies, a figure with two panels. Six clicks.
void TestXvfbWorkbench::comparesTwoRunsAndPrintsAFigure()
{
    const QTemporaryDir folder;
    const auto runTo = [this](int count) {
        click(button(window_->actions().run));
        QTRY_COMPARE(window_->runs().count(), count);
        QTRY_VERIFY(window_->runs().record(count - 1).finished());
    };
    runTo(1);
    click(flyingHeight());
    QTRY_VERIFY(flyingHeight()->hasFocus());
    press("ctrl+a");
    type(QStringLiteral("8"));
    press("Return");
    QTRY_COMPARE(window_->edits().value().springs.flyingHeight, 8e-9);
    runTo(2);

    const PlotWidget* spectrum = window_->runView().spectrum()->view()->plot();
    const PlotGroup* group = window_->runView().spectrum()->view()->group();
    QTRY_COMPARE(spectrum->curves().size(), std::size_t(2));
    const QRect area = spectrum->plotArea().toRect();
    click(spectrum, area.topLeft() + QPoint(area.width() / 3, area.height() / 2));
    QTRY_VERIFY(group->cursor(0).has_value());
    xdotool({QStringLiteral("keydown"), QStringLiteral("shift")});
    click(spectrum, area.topLeft() + QPoint(2 * area.width() / 3, area.height() / 2));
    xdotool({QStringLiteral("keyup"), QStringLiteral("shift")});
    QTRY_VERIFY(group->cursor(1).has_value());
    QCOMPARE(group->readings().size(), std::size_t(2)); // one for each run

    press("ctrl+shift+e");
    FigureDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = window_->findChild<FigureDialog*>()) != nullptr);
    QVERIFY(QTest::qWaitForWindowActive(dialog));
    click(dialog->exportButton());
    QFileDialog* files = nullptr;
    QTRY_VERIFY((files = dialog->findChild<QFileDialog*>()) != nullptr);
    QVERIFY(QTest::qWaitForWindowActive(files));
    auto* name = files->findChild<QLineEdit*>();
    QTRY_VERIFY(name->hasFocus());
    press("ctrl+a");
    type(folder.filePath(QStringLiteral("figure.pdf")));
    QTRY_COMPARE(name->text(), folder.filePath(QStringLiteral("figure.pdf")));
    press("Return");
    QTRY_VERIFY2(dialog->remark().startsWith(QStringLiteral("Written")), qPrintable(dialog->remark()));
    QFile pdf(folder.filePath(QStringLiteral("figure.pdf")));
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    QVERIFY(pdf.readAll().startsWith("%PDF"));
    QCOMPARE(QDir(folder.path()).entryList({QStringLiteral("*.csv")}),
             (QStringList{QStringLiteral("figure-a.csv"), QStringLiteral("figure-b.csv")}));
}

void TestXvfbWorkbench::growsForAProjector()
{
    const int before = window_->casePanel().editor("slider.mass")->height();
    for (QAction* action : window_->actions().fontSize->actions())
        if (action->data().toInt() == 9) action->trigger();
    QCOMPARE(QApplication::font().pointSize(), systemPointSize() + 9);
    QTRY_VERIFY(window_->casePanel().editor("slider.mass")->height() > before);
    // No row of the parameters is cut off at the right.
    const auto* rows = window_->casePanel().findChild<QScrollArea*>();
    QTRY_VERIFY(rows->viewport()->width() >= rows->widget()->minimumSizeHint().width());
    QTRY_VERIFY2(window_->minimumSizeHint().width() <= 1920,
                 qPrintable(QString::number(window_->minimumSizeHint().width())));
    applyTheme(Theme::Light);
}

void TestXvfbWorkbench::fitsASmallScreen()
{
    QCOMPARE(window_->size(), QSize(1280, 800));
    QVERIFY2(window_->minimumSizeHint().width() <= 1280,
             qPrintable(QString::number(window_->minimumSizeHint().width())));
    QVERIFY2(window_->minimumSizeHint().height() <= 800,
             qPrintable(QString::number(window_->minimumSizeHint().height())));
}

TOUCHDOWN_TEST(TestXvfbWorkbench)

} // namespace test_xvfb_workbench

#include "test_xvfb_workbench.moc"
