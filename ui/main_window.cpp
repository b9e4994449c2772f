// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QVBoxLayout>

#include "ui/icons.h"
#include "ui/plot_export.h"
#include "ui/quantity_format.h"
#include "ui/theme.h"

namespace touchdown {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      actions_(new WindowActions(*this, edits_.undoStack())),
      files_(new CaseFiles(edits_, *this)),
      casePanel_(new CasePanel(edits_, this)),
      aboutCase_(new AboutCasePane(this)),
      runs_(new RunWindow(this)),
      film_(new FilmWindow(steady, actions_->solve, this)),
      messages_(new MessageStrip(this))
{
    setObjectName(QStringLiteral("workbench"));
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    buildCentre();
    buildDocks();
    statusBar()->addWidget(runs_->progress(), 1);
    statusBar()->addWidget(film_->progress(), 1);
    statusBar()->setSizeGripEnabled(false);
    connectFiles();
    connectRuns();
    connectFilm();
    connectView();
    connectHelp();
    resize(1500, 940);
    updateRunActions();
    updateTitle();
}

MainWindow::~MainWindow()
{
    // What shows the runs and the case goes before them: they are members, and those go before child widgets.
    edits_.undoStack().disconnect(this);
    for (QObject* sender : {static_cast<QObject*>(runs_), static_cast<QObject*>(&runs()), static_cast<QObject*>(&controller()), static_cast<QObject*>(film_)})
        sender->disconnect(this);
    controller().stopAndWait();
    film_->controller().stopAndWait();
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
    delete takeCentralWidget();
}

void MainWindow::buildCentre()
{
    pages_ = new QStackedWidget(this);
    pages_->addWidget(runs_->view());
    pages_->addWidget(film_->view());

    pageTabs_ = new QTabBar(this);
    for (const QString& name : {tr("Static state"), tr("Run in time")}) pageTabs_->addTab(name);
    pageTabs_->setAccessibleName(tr("What is shown of the film"));
    pageTabs_->setExpanding(false);
    pageTabs_->setFocusPolicy(Qt::StrongFocus);
    pageTabs_->hide();

    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(pageTabs_);
    layout->addWidget(pages_, 1);
    layout->addWidget(messages_);
    setCentralWidget(centre);
    runFiles_ = new RunFiles(runs(), *pages_, *this);
    session_ = std::make_unique<WindowSession>(WindowSession::Parts{*this, *actions_, *runs_->view()->splitter(), *runs_->panel()});
}

void MainWindow::buildDocks()
{
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* parameters = addDock(QStringLiteral("parameters"), tr("Parameters"), casePanel_, Qt::LeftDockWidgetArea);
    QDockWidget* about = addDock(QStringLiteral("about"), tr("About this case"), aboutCase_, Qt::RightDockWidgetArea);
    QDockWidget* runs = addDock(QStringLiteral("runs"), tr("Runs"), runs_->panel(), Qt::RightDockWidgetArea);
    QDockWidget* values = addDock(QStringLiteral("values"), tr("Values at the cursors"), runs_->values(), Qt::RightDockWidgetArea);
    QDockWidget* attitude = addDock(QStringLiteral("attitude"), tr("Static attitude"), film_->attitude(), Qt::RightDockWidgetArea);
    resizeDocks({parameters, about}, {340, 340}, Qt::Horizontal);
    resizeDocks({about, runs, values}, {280, 240, 260}, Qt::Vertical);
    runDocks_ = {runs, values};
    filmDocks_ = {attitude};
    openDocks_ = filmDocks_;
    attitude->hide();
    attitude->toggleViewAction()->setVisible(false);
    film_->progress()->hide();
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setAccessibleName(title);
    addDockWidget(area, dock);
    actions_->panes->addAction(dock->toggleViewAction());
    return dock;
}

void MainWindow::connectFiles()
{
    connect(actions_->newCase, &QAction::triggered, files_, &CaseFiles::newCase);
    connect(actions_->open, &QAction::triggered, files_, &CaseFiles::chooseFile);
    connect(actions_->save, &QAction::triggered, files_, &CaseFiles::save);
    connect(actions_->saveAs, &QAction::triggered, files_, &CaseFiles::saveAs);
    connect(actions_->importCml, &QAction::triggered, files_, &CaseFiles::chooseImport);
    connect(actions_->exportCml, &QAction::triggered, files_, &CaseFiles::chooseExport);
    connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
    connect(actions_, &WindowActions::sampleChosen, files_, &CaseFiles::open);
    connect(casePanel_, &CasePanel::presetChosen, files_, &CaseFiles::open);
    connect(actions_->recent, &QMenu::aboutToShow, this, &MainWindow::updateRecentMenu);
    connect(actions_->resetAll, &QAction::triggered, &edits_, &CaseEdits::resetAll);
    connect(actions_->findParameter, &QAction::triggered, this, [this] {
        casePanel_->search()->setFocus();
        casePanel_->search()->selectAll();
    });
    connect(actions_->openResults, &QAction::triggered, runFiles_, &RunFiles::chooseOpen);
    connect(actions_->saveResults, &QAction::triggered, this, [this] { runFiles_->chooseSave(runs_->panel()->chosen(), false); });
    connect(actions_->exportCsv, &QAction::triggered, this, [this] { runFiles_->chooseSave(runs_->panel()->chosen(), true); });
    connect(actions_->exportPage, &QAction::triggered, runFiles_, &RunFiles::choosePicture);
    connect(actions_->copyPage, &QAction::triggered, this, [this] { copyPage(*pages_); });
    connect(files_, &CaseFiles::opened, this, &MainWindow::onCaseOpened);
    connect(files_, &CaseFiles::saved, this, [this] {
        casePanel_->setPreset({});
        updateTitle();
        messages_->show(MessageStrip::Kind::Success, tr("Saved: %1").arg(QDir::toNativeSeparators(files_->file())));
    });
    connect(files_, &CaseFiles::imported, this, &MainWindow::onImported);
    connect(files_, &CaseFiles::exported, this, &MainWindow::onExported);
    connect(files_, &CaseFiles::resultsFileChosen, runFiles_, &RunFiles::openRun);
    connect(runFiles_, &RunFiles::succeeded, this,
            [this](const QString& text) { messages_->show(MessageStrip::Kind::Success, text); });
    connect(runFiles_, &RunFiles::failed, this,
            [this](const QString& text) { messages_->show(MessageStrip::Kind::Failure, text); });
    connect(&edits_, &CaseEdits::edited, this, &MainWindow::onCaseEdited);
    connect(&edits_.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::updateTitle);
    connect(&edits_.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
}

void MainWindow::connectRuns()
{
    connect(actions_->run, &QAction::triggered, this, &MainWindow::startRun);
    RunController* controller = &this->controller();
    connect(actions_->pause, &QAction::triggered, controller, [controller](bool on) { on ? controller->pause() : controller->resume(); });
    connect(actions_->step, &QAction::triggered, controller, &RunController::step);
    connect(actions_->stop, &QAction::triggered, controller, &RunController::stop);
    connect(actions_->record, &QAction::triggered, this, &MainWindow::chooseRecording);
    connect(actions_->pace, &QComboBox::currentIndexChanged, controller,
            [this, controller] { controller->setPace(actions_->pace->currentData().toDouble()); });
    connect(controller, &RunController::stateChanged, this, &MainWindow::updateRunActions);
    connect(controller, &RunController::recordingFailed, this,
            [this](int, const QString& problem) { messages_->show(MessageStrip::Kind::Failure, problem); });
    connect(runs_, &RunWindow::started, this, [this] {
        aboutCase_->setResult({});
        messages_->clear();
    });
    connect(runs_, &RunWindow::ended, this, &MainWindow::onRunEnded);
    connect(messages_, &MessageStrip::actionRequested, casePanel_, &CasePanel::showFirstProblem);
    connect(runs_->panel(), &RunsPanel::openRequested, runFiles_, &RunFiles::chooseOpen);
    connect(runs_->panel(), &RunsPanel::saveRequested, this, [this](int number) { runFiles_->chooseSave(number, false); });
    connect(runs_->panel(), &RunsPanel::parametersRequested, this, &MainWindow::useParametersOf);
    connect(&runs(), &RunsModel::rowsInserted, this, &MainWindow::updateRunActions);
    connect(&runs(), &RunsModel::rowsRemoved, this, &MainWindow::updateRunActions);
}

void MainWindow::connectFilm()
{
    connect(actions_->solve, &QAction::triggered, this, &MainWindow::solveStaticState);
    connect(actions_->solveGiven, &QAction::triggered, this, &MainWindow::solveAtGivenAttitude);
    connect(pageTabs_, &QTabBar::currentChanged, this, [this] { showModel(shownModel_); });
    // What comes into the list is there to be seen.
    connect(&runs(), &RunsModel::added, this, [this] { setPage(Page::Run); });
    connect(actions_->stop, &QAction::triggered, &film_->controller(), &SteadyController::stop);
    connect(&film_->controller(), &SteadyController::stateChanged, this, &MainWindow::updateRunActions);
    connect(film_, &FilmWindow::solved, this, &MainWindow::onSolved);
    connect(actions_->fit, &QAction::triggered, film_->view(), &FilmView::fit);
}

void MainWindow::connectView()
{
    PlotGroup* group = plots().group();
    connect(actions_->fit, &QAction::triggered, runs_->view(), &RunView::fit);
    connect(actions_->follow, &QAction::triggered, group,
            [group](bool on) { group->setFollow(on ? PlotGroup::Follow::WholeRun : PlotGroup::Follow::Frozen); });
    connect(group, &PlotGroup::followChanged, this,
            [this](PlotGroup::Follow follow) { actions_->follow->setChecked(follow != PlotGroup::Follow::Frozen); });
    connect(actions_->zoomBack, &QAction::triggered, group, &PlotGroup::goBack);
    connect(actions_->zoomForward, &QAction::triggered, group, &PlotGroup::goForward);
    const auto updateHistory = [this, group] {
        actions_->zoomBack->setEnabled(group->canGoBack());
        actions_->zoomForward->setEnabled(group->canGoForward());
    };
    connect(group, &PlotGroup::historyChanged, this, updateHistory);
    updateHistory();
    for (const LivePlots::Entry& entry : plots().plots()) actions_->plots->addAction(entry.wanted);
    actions_->plots->addAction(runs_->view()->spectrumWanted());

    connect(actions_->theme, &QActionGroup::triggered, this, &MainWindow::look);
    connect(actions_->fontSize, &QActionGroup::triggered, this, &MainWindow::look);
    connect(actions_->fullScreen, &QAction::triggered, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

void MainWindow::connectHelp()
{
    connect(actions_->help, &QAction::triggered, this, [this] { showHelp(HelpWindow::Page::Use); });
    connect(actions_->shortcuts, &QAction::triggered, this, [this] { showHelp(HelpWindow::Page::Shortcuts); });
    connect(actions_->aboutProgram, &QAction::triggered, this, [this] { showHelp(HelpWindow::Page::About); });
    connect(actions_->aboutQt, &QAction::triggered, this, [this] {
        auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Qt"),
                                    tr("Touchdown uses Qt %1, by The Qt Company and its contributors, under the GNU General "
                                       "Public License, version 3.")
                                        .arg(QString::fromLatin1(qVersion())),
                                    QMessageBox::Close, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
}

bool MainWindow::readyToRun()
{
    // What stands in a field but was not confirmed yet counts.
    if (QWidget* focused = focusWidget(); focused && casePanel_->isAncestorOf(focused)) {
        focused->clearFocus();
        focused->setFocus();
    }
    if (edits_.reasonNotToRun().isEmpty()) return true;
    casePanel_->showFirstProblem();
    return false;
}

void MainWindow::solveStaticState() { solve(false); }

void MainWindow::solveAtGivenAttitude() { solve(true); }

void MainWindow::solve(bool given)
{
    if (!readyToRun()) return;
    messages_->clear();
    setPage(Page::StaticState);
    film_->solve(edits_.value(), given);
}

void MainWindow::startRun()
{
    if (!readyToRun()) return;
    runs_->start({edits_.value(), files_->text(), recordTo_.toStdString()});
}

void MainWindow::onRunEnded(int number, const Summary& summary)
{
    updateRunActions();
    const RunRecord& run = *runs().find(number);
    const QString result = resultText(run);
    aboutCase_->setResult(result, sentence(summary.bouncingRule), figuresText(summary));
    QStringList lines{tr("Run %1: %2").arg(number).arg(result)};
    MessageStrip::Kind kind = MessageStrip::Kind::Success;
    for (const std::string& warning : summary.warnings) lines << sentence(warning);
    // A check that found a difference is among the warnings.
    if (summary.stepCheck && summary.stepCheck->sameEndState) lines << sentence(summary.stepCheck->message);
    if (!summary.warnings.empty() || (summary.stepCheck && !summary.stepCheck->sameEndState)) kind = MessageStrip::Kind::Warning;
    if (summary.status == RunStatus::Cancelled) kind = MessageStrip::Kind::Information;
    if (summary.status == RunStatus::Failed || summary.status == RunStatus::Diverged) {
        kind = MessageStrip::Kind::Failure;
        lines.front() = tr("Run %1 failed at %2: %3").arg(number).arg(timeText(summary.endTime), result);
    }
    messages_->show(kind, lines.join(QLatin1Char('\n')));
    emit calculationEnded(summary.status == RunStatus::Completed, QString::fromStdString(summary.message));
}

void MainWindow::onSolved(const SteadyResult& result)
{
    updateRunActions();
    const QString text = steadyText(result);
    aboutCase_->setResult(result.status == SteadyStatus::Cancelled ? QString() : text);
    switch (result.status) {
    case SteadyStatus::Converged:
        messages_->show(result.message.empty() ? MessageStrip::Kind::Success : MessageStrip::Kind::Warning, text);
        break;
    case SteadyStatus::Cancelled: messages_->show(MessageStrip::Kind::Information, text); break;
    case SteadyStatus::NotConverged:
    case SteadyStatus::Failed: messages_->show(MessageStrip::Kind::Failure, text); break;
    }
    emit calculationEnded(result.status == SteadyStatus::Converged, QString::fromStdString(result.message));
}

void MainWindow::showModel(ModelKind model)
{
    const bool film = model == ModelKind::Film;
    shownModel_ = model;
    pageTabs_->setVisible(film);
    showPage(film && pageTabs_->currentIndex() == static_cast<int>(Page::StaticState));
}

void MainWindow::showPage(bool staticState)
{
    const bool before = std::exchange(staticShown_, staticState);
    actions_->setPage(shownModel_, staticState);
    updateRunActions();
    if (staticState == before) return;
    pages_->setCurrentWidget(staticState ? static_cast<QWidget*>(film_->view()) : runs_->view());
    const std::vector<QDockWidget*> coming = std::exchange(openDocks_, {});
    for (QDockWidget* dock : staticState ? runDocks_ : filmDocks_) {
        if (!dock->isHidden()) openDocks_.push_back(dock);
        dock->hide();
        dock->toggleViewAction()->setVisible(false);
    }
    for (QDockWidget* dock : staticState ? filmDocks_ : runDocks_) dock->toggleViewAction()->setVisible(true);
    for (QDockWidget* dock : coming) dock->show();
    // The tables are long, and what a film case says about itself is short.
    if (staticState)
        resizeDocks({findChild<QDockWidget*>(QStringLiteral("about")), filmDocks_.front()}, {180, 560}, Qt::Vertical);
}

/// That of the page; and of the other one while something is under way there.
void MainWindow::updateProgress()
{
    runs_->progress()->setVisible(!staticShown_ || controller().active());
    film_->progress()->setVisible(staticShown_ || film_->controller().active());
}

void MainWindow::onCaseOpened()
{
    casePanel_->setPreset(files_->sample());
    setPage(Page::StaticState);
    aboutCase_->setResult({});
    aboutCase_->setWarnings({});
    film_->open(edits_.value());
    runs_->open(edits_.value());
    messages_->clear();
    updateTitle();
}

void MainWindow::onImported(const QString& path, const QStringList& warnings)
{
    aboutCase_->setWarnings(warnings);
    const QString text = tr("Imported: %1.").arg(QDir::toNativeSeparators(path));
    if (warnings.isEmpty()) messages_->show(MessageStrip::Kind::Success, text);
    else
        messages_->show(MessageStrip::Kind::Warning,
                        text + QLatin1Char(' ')
                            + tr("%n thing(s) that it says are not modelled: see About this case.", nullptr, static_cast<int>(warnings.size())));
}

void MainWindow::onExported(const QString& path, const QStringList& warnings)
{
    const QString text = tr("Written: %1").arg(QDir::toNativeSeparators(path));
    if (warnings.isEmpty()) messages_->show(MessageStrip::Kind::Success, text);
    else
        messages_->show(MessageStrip::Kind::Warning,
                        text + QLatin1Char('\n')
                            + tr("Kept in the comments of run.dat, where the established program does not see them: %1")
                                  .arg(warnings.join(QStringLiteral(", "))));
}

void MainWindow::onCaseEdited()
{
    aboutCase_->setCase(edits_.value());
    film_->edit(edits_.value());
    runs_->edit(edits_.value());
    showModel(edits_.value().model);
    updateRunActions();
    updateTitle();
}

void MainWindow::updateRunActions()
{
    using State = RunController::State;
    const State state = controller().state();
    const QString reason = edits_.reasonNotToRun();
    actions_->run->setEnabled(reason.isEmpty());
    const QString cannot = tr("The case cannot be run. %1").arg(reason);
    actions_->run->setToolTip(reason.isEmpty() ? tr("Run the case in time; a run under way starts again (F5)") : cannot);
    actions_->solve->setToolTip(reason.isEmpty() ? tr("Solve for the static attitude; a solution under way starts again (F9)") : cannot);
    for (QAction* action : {actions_->solve, actions_->solveGiven})
        action->setEnabled(shownModel_ == ModelKind::Film && reason.isEmpty());
    if (!reason.isEmpty())
        messages_->show(MessageStrip::Kind::Failure, cannot, tr("Show the field"));
    else if (messages_->text().startsWith(tr("The case cannot be run.")))
        messages_->clear();
    actions_->pause->setEnabled(state == State::Running || state == State::Paused);
    actions_->pause->setChecked(state == State::Paused);
    actions_->step->setEnabled(state == State::Paused);
    actions_->stop->setEnabled(state == State::Running || state == State::Paused
                               || film_->controller().state() == SteadyController::State::Running);
    actions_->resetAll->setEnabled(edits_.anyChanged());
    const bool anyEnded = runs().count() > (controller().active() ? 1 : 0);
    actions_->saveResults->setEnabled(anyEnded);
    actions_->exportCsv->setEnabled(anyEnded);
    updateProgress();
}

void MainWindow::updateTitle()
{
    setWindowTitle(tr("%1[*] – Touchdown").arg(files_->shortName()));
    setWindowModified(files_->modified());
}

void MainWindow::updateRecentMenu()
{
    actions_->recent->clear();
    for (const QString& file : files_->recent())
        actions_->recent->addAction(QDir::toNativeSeparators(file), files_, [this, file] { files_->open(file); });
    if (actions_->recent->isEmpty()) actions_->recent->addAction(tr("None yet"))->setEnabled(false);
}

void MainWindow::chooseRecording(bool on)
{
    if (!on) {
        recordTo_.clear();
        return;
    }
    auto* dialog = new QFileDialog(this, tr("Record the runs that follow to"), {}, tr("HDF5 (*.h5)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("h5"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { recordTo_ = file; });
    connect(dialog, &QDialog::finished, this, [this] { actions_->record->setChecked(!recordTo_.isEmpty()); });
    dialog->open();
}

void MainWindow::useParametersOf(int number)
{
    const RunRecord* run = runs().find(number);
    if (run) edits_.setAll(run->value, tr("use the parameters of run %1").arg(number));
}

void MainWindow::showHelp(HelpWindow::Page page)
{
    if (!help_) {
        QString rows = QStringLiteral("<table cellpadding='3'>");
        for (const QAction* action : actions_->withShortcuts())
            rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                        .arg(action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                             action->text().remove(QLatin1Char('&')).remove(QStringLiteral("…")).toHtmlEscaped());
        help_ = new HelpWindow(rows + QStringLiteral("</table>"), this);
    }
    help_->open(page);
}

void MainWindow::look()
{
    const QAction* theme = actions_->theme->checkedAction();
    const QAction* size = actions_->fontSize->checkedAction();
    applyTheme(theme ? themeFromName(theme->data().toString()) : Theme::System,
               systemPointSize() + (size ? size->data().toInt() : 0));
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) actions_->updateIcons(palette());
    if (event->type() == QEvent::WindowStateChange) actions_->fullScreen->setChecked(isFullScreen());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (CaseFiles::isCaseFile(url.toLocalFile()) || CaseFiles::isResultsFile(url.toLocalFile()))
            event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls()) {
        const QString file = url.toLocalFile();
        if (CaseFiles::isResultsFile(file)) runFiles_->openRun(file);
        else if (CaseFiles::isCaseFile(file)) files_->open(file);
    }
    event->acceptProposedAction();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!closing_ && files_->modified()) {
        event->ignore();
        files_->whenSettled([this] {
            closing_ = true;
            close();
        });
        return;
    }
    controller().stop();
    film_->controller().stop();
    saveSession();
    event->accept();
}

void MainWindow::saveSession()
{
    showModel(ModelKind::Springs); // the next session begins with its panes
    session_->save(files_->file().isEmpty() ? files_->sample() : files_->file());
}

void MainWindow::restoreSession()
{
    session_->restore();
    for (QDockWidget* dock : filmDocks_) dock->hide(); // comes with a film
    look();
}

void MainWindow::openLastCase()
{
    const QString last = WindowSession::lastCase();
    const bool sample = std::ranges::any_of(sampleCases(), [&last](const SampleCase& c) { return last == QLatin1String(c.name); });
    // A file that is gone or spoiled since is no reason to begin with an error.
    if (!last.isEmpty() && (sample || QFileInfo(last).isFile()) && openCase(last.toStdString()).valid()) files_->openNow(last);
    else files_->openNow(QString::fromUtf8(defaultCaseName.data(), static_cast<qsizetype>(defaultCaseName.size())));
}

} // namespace touchdown
