// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_actions.h"

#include <limits>

#include <QLabel>
#include <QMenuBar>
#include <QToolButton>

#include "core/case_files/case_file.h"
#include "ui/runs/run_controller.h"
#include "ui/style/foreign_text.h"

namespace touchdown {

WindowActions::WindowActions(QMainWindow& window, QUndoStack& stack) : QObject(&window)
{
    buildFile(window);
    buildEdit(window, stack);
    buildRun(window);
    buildView(window);
    buildHelp(window);
    buildToolBar(window);
    // Their keys work without the menus, too.
    window.addActions({alone, presenter, run, pause, step, stop, lesson, demonstrations});
    updateIcons(window.palette());
}

QAction* WindowActions::add(QMenu* menu, const QString& text, const QKeySequence& keys, const QString& iconName,
                            const QString& tip)
{
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    QString plain = text;
    plain.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
    QString hint = tip.isEmpty() ? plain : tip;
    if (!keys.isEmpty()) hint += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
    action->setToolTip(plainTip(hint));
    if (!iconName.isEmpty()) icons_.emplace_back(action, iconName);
    all_.push_back(action);
    return action;
}

QActionGroup* WindowActions::choices(QMenu* menu, const std::vector<std::pair<QVariant, QString>>& entries)
{
    auto* group = new QActionGroup(this);
    for (const auto& [data, text] : entries) {
        QAction* action = group->addAction(text);
        action->setCheckable(true);
        action->setData(data);
    }
    menu->addActions(group->actions());
    return group;
}

void WindowActions::buildFile(QMainWindow& window)
{
    QMenu* menu = window.menuBar()->addMenu(tr("&File"));
    newCase = add(menu, tr("&New case…"), QKeySequence::New, {}, tr("Begin with a typical slider, or with defaults"));
    open = add(menu, tr("&Open…"), QKeySequence::Open, QStringLiteral("open"), tr("Open a case file or a saved run"));
    samples = menu->addMenu(tr("Open sample &case"));
    for (const SampleCase& sample : sampleCases()) {
        const QString name = QString::fromStdString(sample.name);
        QAction* action = samples->addAction(QString::fromStdString(titleOf(sample)));
        action->setData(name);
        connect(action, &QAction::triggered, this, [this, name] { emit sampleChosen(name); });
    }
    caseGallery = add(menu, tr("Galler&y of cases…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G), {},
                      tr("All sample cases with small pictures, by theme"));
    recent = menu->addMenu(tr("Open &recent"));
    menu->addSeparator();
    save =
        add(menu, tr("&Save"), QKeySequence::Save, QStringLiteral("save"), tr("Save the case; its comments are kept"));
    saveAs = add(menu, tr("Save &as…"), QKeySequence::SaveAs);
    menu->addSeparator();
    importCml = add(menu, tr("&Import CML case…"), {}, {},
                    tr("Read rail.dat with run.dat or dynamics.def, or from a .cml archive"));
    exportCml = add(menu, tr("Export as C&ML case…"), {}, {},
                    tr("Write rail.dat and run.dat into a folder or into a .cml archive"));
    exportDxf = add(menu, tr("Save surface as &DXF…"), {}, {},
                    tr("Draw the outlines of all rails for a CAD program, in mm, with a layer for each rail"));
    underlay = add(menu, tr("Dra&wing under the plan…"), {}, {},
                   tr("Show a picture or a DXF drawing under the plan of the surface, to trace it"));
    for (QAction* action : {exportCml, exportDxf, underlay}) action->setVisible(false);
    menu->addSeparator();
    openResults = add(menu, tr("Open saved r&un…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O));
    saveResults = add(menu, tr("Save run as &HDF5…"));
    exportCsv = add(menu, tr("Export run as CS&V…"));
    exportPage = add(menu, tr("Export &plots…"), QKeySequence(Qt::CTRL | Qt::Key_E), {},
                     tr("Export all plots as PNG, SVG or PDF"));
    figure = add(menu, tr("Fi&gure for a paper…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), {},
                 tr("Draw the pictures of this page in the size and the font of a journal, as PDF, SVG or PNG"));
    menu->addSeparator();
    buildSessions(menu->addMenu(tr("Sess&ions")));
    quit = add(menu, tr("&Quit"), QKeySequence::Quit);
}

void WindowActions::buildSessions(QMenu* menu)
{
    sessions = menu->addMenu(tr("&Restore"));
    sessions->setToolTip(tr("Bring back the case and the results that an earlier session left"));
    reopen = add(menu, tr("&Start with the last case"));
    reopen->setCheckable(true);
    reopen->setChecked(true);
    sessionSpace = choices(menu->addMenu(tr("&Space on the disk")), {{qint64(500) << 20, tr("&500 MB")},
                                                                     {qint64(2) << 30, tr("&2 GB")},
                                                                     {qint64(10) << 30, tr("&10 GB")},
                                                                     {qint64(50) << 30, tr("5&0 GB")}});
}

void WindowActions::buildEdit(QMainWindow& window, QUndoStack& stack)
{
    QMenu* menu = window.menuBar()->addMenu(tr("&Edit"));
    undo = stack.createUndoAction(this, tr("Undo"));
    redo = stack.createRedoAction(this, tr("Redo"));
    undo->setShortcut(QKeySequence::Undo);
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    for (QAction* action : {undo, redo}) {
        // Its text says what is undone, which may be the title of a study.
        connect(action, &QAction::changed, action, [action] { action->setToolTip(plainTip(action->text())); });
        menu->addAction(action);
        all_.push_back(action);
    }
    icons_.emplace_back(undo, QStringLiteral("undo"));
    icons_.emplace_back(redo, QStringLiteral("redo"));
    menu->addSeparator();
    resetAll = add(menu, tr("Reset &all parameters"));
    findParameter = add(menu, tr("&Find parameter"), QKeySequence::Find);
    menu->addSeparator();
    copyPage = add(menu, tr("&Copy plots as picture"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
}

void WindowActions::buildRun(QMainWindow& window)
{
    QMenu* menu = window.menuBar()->addMenu(tr("&Run"));
    run = add(menu, tr("&Run"), QKeySequence(Qt::Key_F5), QStringLiteral("run"),
              tr("Run the case; a run in progress starts again"));
    pause = add(menu, tr("&Pause"), QKeySequence(Qt::Key_F6), QStringLiteral("pause"), tr("Pause or resume the run"));
    pause->setCheckable(true);
    step = add(menu, tr("S&tep"), QKeySequence(Qt::Key_F7), QStringLiteral("step"),
               tr("Advance a paused run by one picture"));
    stop = add(menu, tr("&Stop"), QKeySequence(Qt::Key_F8), QStringLiteral("stop"),
               tr("Stop the calculation; its results so far are kept"));
    continueRun = add(menu, tr("&Continue the chosen run"), {}, {},
                      tr("Continue the chosen run to its end, or to the longer duration that the case has now"));
    menu->addSeparator();
    solve = add(menu, tr("S&olve static attitude"), QKeySequence(Qt::Key_F9), QStringLiteral("solve"),
                tr("Solve for the static attitude; a solution in progress starts again"));
    solve->setIconText(tr("Solve"));
    study = add(menu, tr("Perform st&udy"), QKeySequence(Qt::SHIFT | Qt::Key_F5), QStringLiteral("study"),
                tr("Perform the study of the page Studies; a study in progress starts again"));
    solveGiven = add(menu, tr("Solve at the &given attitude"), QKeySequence(Qt::SHIFT | Qt::Key_F9), {},
                     tr("Solve for the pressure only, at the height, pitch and roll of the start"));
    smallMotions = add(menu, tr("F&ilm, small motions"), {}, {},
                       tr("Make the film linear about the static state and start near it: runs follow what you move"));
    smallMotions->setCheckable(true);
    for (QAction* action : {solve, solveGiven, smallMotions}) action->setVisible(false);
    menu->addSeparator();
    record = add(menu, tr("Record to &file…"), {}, {}, tr("Write the next runs to an HDF5 file during the run"));
    record->setCheckable(true);
    runMemory = choices(menu->addMenu(tr("&Memory for runs")), {{0, tr("A &quarter of the machine")},
                                                                {qint64(500) << 20, tr("&500 MB")},
                                                                {qint64(1) << 30, tr("&1 GB")},
                                                                {qint64(2) << 30, tr("&2 GB")},
                                                                {qint64(4) << 30, tr("&4 GB")},
                                                                {qint64(8) << 30, tr("&8 GB")},
                                                                {qint64(16) << 30, tr("1&6 GB")}});
}

void WindowActions::buildView(QMainWindow& window)
{
    QMenu* menu = window.menuBar()->addMenu(tr("&View"));
    surface = add(menu, tr("&Surface of the slider"), QKeySequence(Qt::CTRL | Qt::Key_G), {},
                  tr("Go to the plan of the air bearing surface"));
    fit = add(menu, tr("&Fit plots"), QKeySequence(Qt::CTRL | Qt::Key_0), QStringLiteral("fit"),
              tr("Show all of the runs"));
    follow = add(menu, tr("F&ollow the run"), QKeySequence(Qt::CTRL | Qt::Key_L), QStringLiteral("follow"),
                 tr("Let the time axis follow the run; off: freeze it"));
    follow->setCheckable(true);
    follow->setChecked(true);
    zoomBack = add(menu, tr("Zoom &back"), QKeySequence(Qt::ALT | Qt::Key_Left), QStringLiteral("back"));
    zoomForward = add(menu, tr("Zoom for&ward"), QKeySequence(Qt::ALT | Qt::Key_Right), QStringLiteral("forward"));
    menu->addSeparator();
    panes = menu->addMenu(tr("&Panes"));
    plots = menu->addMenu(tr("P&lots"));

    theme = choices(menu->addMenu(tr("&Theme")), {{themeName(Theme::System), tr("As the &system")},
                                                  {themeName(Theme::Light), tr("&Light")},
                                                  {themeName(Theme::Dark), tr("&Dark")}});
    fontSize = choices(menu->addMenu(tr("Font si&ze")),
                       {{0, tr("&Normal")}, {2, tr("&Large")}, {5, tr("&Projector")}, {9, tr("Lecture &hall")}});
    menu->addSeparator();
    alone = add(menu, tr("Page &alone"), QKeySequence(Qt::Key_F10), {},
                tr("The page has the whole window; again, and the panes come back"));
    presenter = add(menu, tr("P&resenter"), QKeySequence(Qt::Key_F11), {},
                    tr("For a lecture: the whole screen, large text, no panes; again to leave it (F11)"));
    fullScreen = add(menu, tr("F&ull screen"), QKeySequence(Qt::SHIFT | Qt::Key_F11));
    for (QAction* action : {alone, presenter, fullScreen}) action->setCheckable(true);
}

void WindowActions::buildHelp(QMainWindow& window)
{
    QMenu* menu = window.menuBar()->addMenu(tr("&Help"));
    help = add(menu, tr("&Contents: how to use it, the equations"), QKeySequence::HelpContents);
    firstSteps =
        add(menu, tr("&First steps"), {}, {}, tr("The default case in slow motion, and where to go from there"));
    lesson = add(menu, tr("&Lesson in six steps"), QKeySequence(Qt::SHIFT | Qt::Key_F1));
    printLesson = add(menu, tr("&Print the lesson…"), {}, {}, tr("A hand-out as PDF: texts, pictures and answers"));
    demonstrations = add(menu, tr("&Demonstrations of the paper's figures"), QKeySequence(Qt::SHIFT | Qt::Key_F2), {},
                         tr("Each figure with what to watch, what to try, and values to move"));
    shortcuts = add(menu, tr("&Shortcuts"), QKeySequence(Qt::CTRL | Qt::Key_F1));
    menu->addSeparator();
    aboutProgram = add(menu, tr("&About Touchdown"));
    aboutQt = add(menu, tr("About &Qt"));
}

void WindowActions::buildToolBar(QMainWindow& window)
{
    toolBar = window.addToolBar(tr("Tools"));
    toolBar->setObjectName(QStringLiteral("tools"));
    toolBar->setMovable(false);
    toolBar->setIconSize(QSize(20, 20));
    toolBar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    toolBar->addActions({open, save});
    toolBar->addSeparator();
    toolBar->addActions({undo, redo});
    toolBar->addSeparator();
    toolBar->addActions({solve, run, study, pause, step, stop});
    for (QAction* action : {solve, run})
        static_cast<QToolButton*>(toolBar->widgetForAction(action))->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);

    pace = new QComboBox(toolBar);
    pace->setAccessibleName(tr("Speed of the run"));
    pace->setToolTip(tr("Simulated time per second: slow motion for watching"));
    pace->setFocusPolicy(Qt::StrongFocus);
    pace->addItem(tr("Full speed"), RunController::fullSpeed);
    for (const auto& [value, text] :
         {std::pair(1e-3, tr("1 ms/s")), std::pair(3e-4, tr("300 µs/s")), std::pair(1e-4, tr("100 µs/s")),
          std::pair(3e-5, tr("30 µs/s")), std::pair(1e-5, tr("10 µs/s"))})
        pace->addItem(text, value);
    auto* label = new QLabel(tr("&Speed"), toolBar);
    label->setBuddy(pace);
    label->setContentsMargins(8, 0, 4, 0);
    pace_ = {toolBar->addWidget(label), toolBar->addWidget(pace)};
    toolBar->addSeparator();
    toolBar->addActions({fit, follow, zoomBack, zoomForward});
    for (QAction* action : toolBar->actions())
        if (QWidget* button = toolBar->widgetForAction(action);
            button && button != pace && button != label && !action->text().isEmpty())
            button->setAccessibleName(action->text().remove(QLatin1Char('&')).remove(QStringLiteral("…")));
}

void WindowActions::updateIcons(const QPalette& palette)
{
    for (const auto& [action, name] : icons_) action->setIcon(icon(name, palette));
}

QString WindowActions::shortcutTable() const
{
    QString rows;
    for (const QAction* action : all_) {
        if (action->shortcut().isEmpty()) continue;
        // What would be undone now is not asked for.
        const QString text = action == undo ? tr("Undo") : action == redo ? tr("Redo") : action->text();
        rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                         QString(text).remove(QLatin1Char('&')).remove(QStringLiteral("…")).toHtmlEscaped());
    }
    return QStringLiteral("<table cellpadding='3'>%1</table>").arg(rows);
}

void WindowActions::setPage(ModelKind model, bool inTime)
{
    const bool film = model == ModelKind::Film;
    for (QAction* action : {solve, solveGiven, smallMotions, exportCml, exportDxf}) action->setVisible(film);
    underlay->setVisible(film && !inTime);
    for (QAction* action : {pause, step, record, follow, zoomBack, zoomForward}) action->setVisible(inTime);
    for (QAction* action : pace_) action->setVisible(inTime);
    plots->menuAction()->setVisible(inTime);
}

} // namespace touchdown
