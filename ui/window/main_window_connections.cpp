// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connections between the actions, the parts of the window and their signals; messages at the end of a calculation, an
// import or an export.
#include "ui/window/main_window.h"

#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>

#include "core/simulation/static_state/steady.h"
#include "core/studies/study/study.h"
#include "core/studies/study/study_file_reader.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/case/file_notice.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/solution_files.h"
#include "ui/film/surface_page.h"
#include "ui/guides/guide_strip.h"
#include "ui/guides/guides.h"
#include "ui/lists/record_panel.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/style/quantity_format.h"
#include "ui/window/presenter.h"
#include "ui/window/recording.h"
#include "ui/window/result_messages.h"
#include "ui/window/run_continuation.h"
#include "ui/window/study_links.h"
#include "ui/window/window_actions.h"

namespace touchdown {

namespace {

/// What a part of the window has done, and what failed.
template <class Part>
void tell(MessageStrip& messages, const Part& part)
{
    const auto show = [&messages](MessageStrip::Kind kind) {
        return [&messages, kind](const QString& text) { messages.show(kind, text); };
    };
    QObject::connect(&part, &Part::succeeded, &messages, show(MessageStrip::Kind::Success));
    QObject::connect(&part, &Part::failed, &messages, show(MessageStrip::Kind::Failure));
}

} // namespace

void MainWindow::connectFiles()
{
    connect(actions_->newCase, &QAction::triggered, this, &MainWindow::chooseNewCase);
    connect(actions_->open, &QAction::triggered, files_, &CaseFiles::chooseFile);
    connect(actions_->caseGallery, &QAction::triggered, this, &MainWindow::showGallery);
    connect(actions_->save, &QAction::triggered, files_, &CaseFiles::save);
    connect(actions_->saveAs, &QAction::triggered, files_, &CaseFiles::saveAs);
    connect(actions_->importCml, &QAction::triggered, files_, &CaseFiles::chooseImport);
    connect(actions_->exportCml, &QAction::triggered, files_, &CaseFiles::chooseExport);
    connect(actions_->exportDxf, &QAction::triggered, files_, &CaseFiles::chooseDrawing);
    connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
    connect(actions_, &WindowActions::sampleChosen, files_, &CaseFiles::open);
    connect(casePanel_, &CasePanel::galleryWanted, this, &MainWindow::showGallery);
    connect(casePanel_, &CasePanel::presetChosen, files_, &CaseFiles::open);
    connect(actions_->recent, &QMenu::aboutToShow, this, &MainWindow::updateRecentMenu);
    connect(actions_->resetAll, &QAction::triggered, edits_, &CaseEdits::resetAll);
    connect(actions_->findParameter, &QAction::triggered, this, [this] {
        actions_->alone->setChecked(false);
        casePanel_->search()->setFocus();
        casePanel_->search()->selectAll();
    });
    connect(actions_->openResults, &QAction::triggered, runFiles_, &RunFiles::chooseOpen);
    connect(actions_->saveResults, &QAction::triggered, this,
            [this] { runFiles_->chooseSave(runs_->panel()->chosen(), false); });
    connect(actions_->exportCsv, &QAction::triggered, this,
            [this] { runFiles_->chooseSave(runs_->panel()->chosen(), true); });
    connect(actions_->exportPage, &QAction::triggered, runFiles_, &RunFiles::choosePicture);
    connect(actions_->figure, &QAction::triggered, this, &MainWindow::makeFigure);
    connect(actions_->copyPage, &QAction::triggered, this, [this] { copyPicture(*page()); });
    connect(files_, &CaseFiles::opened, this, &MainWindow::onCaseOpened);
    SurfaceEditor* editor = film_->view()->shape()->editor();
    connect(actions_->underlay, &QAction::triggered, actions_->surface, &QAction::trigger);
    connect(actions_->underlay, &QAction::triggered, editor, &SurfaceEditor::placeUnderlay);
    connect(&editor->underlay(), &Underlay::failed, this,
            [this](const QString& sentence) { messages_->show(MessageStrip::Kind::Failure, sentence); });
    connect(files_, &CaseFiles::opened, this, [this, editor] { editor->underlay().openCase(files_->origin()); });
    connect(files_, &CaseFiles::saved, this, [this, editor] { editor->underlay().renameCase(files_->origin()); });
    connect(files_, &CaseFiles::aboutToUse, this, &MainWindow::takeTyped);
    // `remark`: what is not as in the file; empty: all is.
    const auto tellFile = [this](const QString& what, const QString& path, const QString& remark = {}) {
        messages_->show(remark.isEmpty() ? MessageStrip::Kind::Success : MessageStrip::Kind::Warning,
                        what.arg(QDir::toNativeSeparators(path)) + remark);
    };
    connect(files_, &CaseFiles::saved, this, [this, tellFile] {
        casePanel_->setPreset({});
        showInFile();
        tellFile(tr("Saved: %1"), files_->file());
    });
    connect(files_, &CaseFiles::reloaded, this, [this, tellFile](const QStringList& warnings) {
        aboutCase_->setWarnings(warnings);
        showInFile();
        tellFile(tr("Reloaded: %1. Undo brings the values back."), files_->file());
    });
    pages_->addNotice(*new FileNotice(*files_, this));
    connect(files_, &CaseFiles::warned, aboutCase_, &AboutCasePane::setWarnings);
    connect(files_, &CaseFiles::imported, this, [this, tellFile](const QString& path, const QStringList& warnings) {
        aboutCase_->setWarnings(warnings);
        const QString several = tr(" There are %1 remarks on the files: see About this case.").arg(warnings.size());
        tellFile(tr("Imported: %1."), path,
                 warnings.isEmpty()     ? QString()
                 : warnings.size() == 1 ? tr(" There is a remark on the files: see About this case.")
                                        : several);
    });
    connect(files_, &CaseFiles::exported, this, [tellFile](const QString& path, const QString& remark) {
        tellFile(tr("Written: %1"), path, remark.isEmpty() ? remark : QLatin1Char('\n') + remark);
    });
    connect(edits_, &CaseEdits::relationsEnded, this,
            [this](const QString& which) { messages_->show(MessageStrip::Kind::Information, which); });
    connect(files_, &CaseFiles::resultsFileChosen, runFiles_, &RunFiles::openResults);
    tell(*messages_, *runFiles_);
    connect(edits_, &CaseEdits::edited, this, &MainWindow::onCaseEdited);
    connect(edits_, &CaseEdits::modelFollowed, this, [this](const QStringList& changes) {
        messages_->show(
            MessageStrip::Kind::Information,
            tr("What goes with this choice: %1. Undo takes it back.").arg(changes.join(QStringLiteral("; "))));
    });
    connect(&edits_->undoStack(), &QUndoStack::indexChanged, this, &MainWindow::updateTitle);
    connect(&edits_->undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
}

void MainWindow::connectRuns()
{
    connect(actions_->run, &QAction::triggered, this, &MainWindow::startRun);
    runs_->takeRestsFrom([this](const Case& c) { return film_->solutions().restOf(c); });
    RunController* controller = &this->controller();
    connect(actions_->pause, &QAction::triggered, controller,
            [controller](bool on) { on ? controller->pause() : controller->resume(); });
    connect(actions_->step, &QAction::triggered, controller, &RunController::step);
    connect(actions_->stop, &QAction::triggered, controller, &RunController::stop);
    connect(actions_->record, &QAction::triggered, recording_, &Recording::choose);
    connect(actions_->pace, &QComboBox::currentIndexChanged, controller, [this, controller] {
        controller->setPace(actions_->pace->currentData().toDouble());
        runs_->progress()->restartEstimate();
    });
    connect(controller, &RunController::stateChanged, this, &MainWindow::updateRunActions);
    connect(controller, &RunController::recordingFailed, this,
            [this](int, const QString& problem) { messages_->show(MessageStrip::Kind::Failure, problem); });
    connect(runs_, &RunWindow::started, this, [this] {
        aboutCase_->clearResult();
        messages_->clear();
    });
    connect(runs_, &RunWindow::ended, this, &MainWindow::onRunEnded);
    RunMemory* memory = &runs_->memory();
    for (QAction* action : actions_->runMemory->actions())
        if (action->data().toLongLong() == RunMemory::setting()) action->setChecked(true);
    connect(actions_->runMemory, &QActionGroup::triggered, memory,
            [memory](const QAction* action) { memory->setBudget(action->data().toLongLong()); });
    // After the message of the run that was opened or has ended, which would hide it.
    connect(
        memory, &RunMemory::failed, this,
        [this](const QString& problem) { messages_->show(MessageStrip::Kind::Warning, problem); },
        Qt::QueuedConnection);
    connect(messages_, &MessageStrip::actionRequested, this, [this] {
        actions_->alone->setChecked(false);
        if (casePanel_->showFirstProblem()) return;
        setPage(Page::StaticState); // the surface has no field in the panel
        film_->view()->setPage(FilmView::Page::Surface);
    });
    connect(messages_, &MessageStrip::secondRequested, this, [this] {
        Case c = edits_->value();
        if (!readyToRun() || c.model != ModelKind::Film) return; // another case by now
        c.initial.state = InitialState::Static;
        edits_->setAll(c, tr("start where it flies"));
        startRun();
    });
    connect(runs_->panel(), &RecordPanel::openRequested, runFiles_, &RunFiles::chooseOpen);
    connect(runs_->panel(), &RecordPanel::saveRequested, this,
            [this](int number) { runFiles_->chooseSave(number, false); });
    offerToContinue({*runs_, *edits_, *recording_, *messages_, *actions_->continueRun},
                    [this] { endSlowMotion(), setPage(Page::Run); });
    connect(runs_->panel(), &RecordPanel::parametersRequested, this, &MainWindow::useParametersOf);
    connect(&runs(), &RunsModel::rowsInserted, this, &MainWindow::updateRunActions);
    connect(&runs(), &RunsModel::rowsRemoved, this, &MainWindow::updateRunActions);
}

void MainWindow::connectFilm()
{
    connect(actions_->solve, &QAction::triggered, this, [this] { solveStaticState(); });
    connect(actions_->solveGiven, &QAction::triggered, this, [this] { solveStaticState(true); });
    connect(pages_, &WindowPages::shown, this, [this, before = pages_->page()]() mutable {
        if (std::exchange(before, pages_->page()) != pages_->page()) leaveMessage();
        updateRunActions();
    });
    connect(film_->view(), &FilmView::pageChanged, this, &MainWindow::leaveMessage);
    connect(runs_->view(), &RunView::pageChanged, this, &MainWindow::leaveMessage);
    connect(actions_->stop, &QAction::triggered, &film_->controller(), &SteadyController::stop);
    connect(&film_->controller(), &SteadyController::stateChanged, this, &MainWindow::updateRunActions);
    connect(actions_->stop, &QAction::triggered, film_->view(), &FilmView::stop);
    connect(film_->view(), &FilmView::busyChanged, this, &MainWindow::updateRunActions);
    connect(film_, &FilmWindow::solved, this, &MainWindow::onSolved);
    connect(film_->view()->modes(), &ModesPage::found, runView().spectrum(), &LiveSpectrum::setFilmModes);
    connect(film_, &FilmWindow::shownChanged, this,
            [this] { results_->solutionShown(pages_->page() == Page::StaticState); });
    connect(film_, &FilmWindow::surfaceEdited, edits_, &CaseEdits::setSurface);
    connect(actions_->fit, &QAction::triggered, film_->view(), &FilmView::fit);
    connect(actions_->surface, &QAction::triggered, this, [this] {
        setPage(Page::StaticState);
        film_->view()->setPage(FilmView::Page::Surface);
        film_->view()->shape()->editor()->setFocus();
    });
    RecordPanel* panel = film_->panel();
    panel->offer(tr("Use"), tr("Take the parameters of this solution, also its shape, into the case that is edited"),
                 [this](int number) {
                     files_->use(film_->solutions().find(number)->value, tr("solution %1").arg(number),
                                 tr("use the parameters of solution %1").arg(number));
                 });
    panel->offer(
        tr("Run from here"),
        tr("Run this solution's case in time, from its static state; disk surface and run as they are set now"),
        [this](int number) { runFromSolution(number); });
    connect(panel, &RecordPanel::openRequested, runFiles_, &RunFiles::chooseOpen);
    connect(panel, &RecordPanel::saveRequested, solutionFiles_, &SolutionFiles::chooseSave);
    connect(runFiles_, &RunFiles::solutionsChosen, solutionFiles_, &SolutionFiles::open);
    connect(solutionFiles_, &SolutionFiles::opened, this, [this](int number, const QString& file) {
        if (pages_->model() == ModelKind::Film) return setPage(Page::StaticState);
        // Another model has no page for it.
        files_->use(film_->solutions().find(number)->value, QFileInfo(file).fileName(), {},
                    [this] { setPage(Page::StaticState); });
    });
    tell(*messages_, *solutionFiles_);
}

void MainWindow::connectStudies()
{
    connect(actions_->study, &QAction::triggered, this, [this] { performStudy(nullptr); });
    connect(studies_->editor(), &StudyEditor::runRequested, this, [this] { performStudy(nullptr); });
    connect(studies_->editor(), &StudyEditor::engineChosen, this,
            [this](const EngineTask& engine) { performStudy(&engine); });
    connect(studies_->editor(), &StudyEditor::fileOpened, this, &MainWindow::onStudyOpened);
    connect(actions_->stop, &QAction::triggered, &studies_->controller(), &StudyController::stop);
    connect(&studies_->controller(), &StudyController::stateChanged, this, &MainWindow::updateRunActions);
    connect(studies_, &StudyWindow::ended, this, &MainWindow::onStudied);
    tell(*messages_, *studies_);
    linkStudies({*this, *studies_, *casePanel_, *edits_, *files_, *messages_}, [this] { setPage(Page::Studies); });
    connect(files_, &CaseFiles::studyFileChosen, this, &MainWindow::openStudy);
    connect(runFiles_, &RunFiles::studyChosen, this, &MainWindow::openStudy);
}

void MainWindow::connectView()
{
    PlotGroup* group = runs_->view()->plots()->group();
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
    const auto fillPlots = [this] { runs_->view()->fillPlotsMenu(*actions_->plots); };
    connect(runs_->view()->plots(), &LivePlots::plotsChanged, this, fillPlots);
    // Who chooses plots wants to see them.
    connect(actions_->plots, &QMenu::triggered, this, [this] { runView().setStage({}); });
    fillPlots();
    connect(runs_->view()->plots(), &LivePlots::refused, this,
            [this](const QString& reason) { messages_->show(MessageStrip::Kind::Warning, reason); });

    connect(actions_->theme, &QActionGroup::triggered, this, [this] { useTheme({}); });
    connect(actions_->fontSize, &QActionGroup::triggered, this, &MainWindow::look);
    connect(actions_->alone, &QAction::toggled, pages_, &WindowPages::showAlone);
    connect(actions_->presenter, &QAction::toggled, this, [this](bool on) {
        if (on) actions_->alone->setChecked(false); // the presenter brings back what was there before
        actions_->alone->setEnabled(!on);
        presenter_->set(on);
    });
    connect(presenter_, &Presenter::changed, this, &MainWindow::look);
    connect(guides_, &Guides::stepShown, presenter_, &Presenter::showCaption);
    connect(files_, &CaseFiles::opened, presenter_, &Presenter::showCaption);
    connect(actions_->fullScreen, &QAction::triggered, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

void MainWindow::openStudy(const QString& file)
{
    QString problem;
    if (CaseFiles::isResultsFile(file)) {
        StoredStudy stored = readStudy(file.toStdString());
        problem = QString::fromStdString(stored.problem);
        if (problem.isEmpty() && studies_->underWay(stored.report.kind))
            problem = tr("A study of this kind is being performed. Stop it before a report is opened.");
        const StudyReport* there = studies_->unsaved(stored.report.kind);
        const auto show = [this, file, stored] {
            studies_->editor()->setKind(QString::fromStdString(stored.report.kind));
            studies_->restore(stored, file);
            onStudyOpened(file);
        };
        if (problem.isEmpty() && there)
            askToReplaceReport(*this, *there, show);
        else if (problem.isEmpty())
            show();
    } else {
        problem = studies_->editor()->open(file);
    }
    if (!problem.isEmpty()) messages_->show(MessageStrip::Kind::Failure, problem);
}

void MainWindow::onStudyOpened(const QString& file)
{
    setPage(Page::Studies);
    messages_->show(MessageStrip::Kind::Success, tr("Opened: %1").arg(QDir::toNativeSeparators(file)));
}

void MainWindow::onStudied(const StudyReport& report)
{
    updateRunActions();
    results_->studied(report, pages_->page() == Page::Studies &&
                                  studies_->editor()->kind() == QString::fromStdString(report.kind));
    emit calculationEnded(report.status == StudyStatus::Completed, QString::fromStdString(report.message));
}

void MainWindow::onRunEnded(int number, const Summary& summary)
{
    updateRunActions();
    // In a lecture the end of a good run stands below the page already; a step of the lesson that asks hides others.
    const RunRecord& run = *runs().find(number);
    results_->runEnded(run, guides_->strip()->isVisible() || (guides_->staged() && !run.shown));
    emit calculationEnded(summary.status == RunStatus::Completed, QString::fromStdString(summary.message));
}

void MainWindow::onSolved(const SteadyResult& result)
{
    updateRunActions();
    results_->solved(result);
    emit calculationEnded(result.status == SteadyStatus::Converged, QString::fromStdString(result.message));
}

} // namespace touchdown
