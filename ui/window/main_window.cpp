// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QPointer>
#include <QSettings>
#include <QStatusBar>

#include "core/case_files/case_file.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/static_solution.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/film/surface_page.h"
#include "ui/guides/guide_strip.h"
#include "ui/guides/guides.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/small_motions_strip.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/sessions/session.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/loss_question.h"
#include "ui/style/message_strip.h"
#include "ui/style/theme.h"
#include "ui/window/apply_question.h"
#include "ui/window/presenter.h"
#include "ui/window/recording.h"
#include "ui/window/result_messages.h"
#include "ui/window/start_card.h"
#include "ui/window/window_actions.h"
#include "ui/workbench/closing_question.h"

namespace touchdown {

MainWindow::MainWindow(QWidget* parent) : MainWindow(coreStudies(), parent) {}

MainWindow::MainWindow(StudyCatalogue studies, QWidget* parent)
    : QMainWindow(parent),
      edits_(new CaseEdits(this)),
      actions_(new WindowActions(*this, edits_->undoStack())),
      files_(new CaseFiles(*edits_, *this)),
      casePanel_(new CasePanel(*edits_, this)),
      aboutCase_(new AboutCasePane(this)),
      runs_(new RunWindow(this)),
      film_(new FilmWindow(steadyWithContact, actions_->solve, this)),
      studies_(new StudyWindow(std::move(studies), this)),
      messages_(new MessageStrip(this)),
      startCard_(new StartCard(this))
{
    showForeignTextPlainly();
    setObjectName(QStringLiteral("workbench"));
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    pages_ = new WindowPages(
        {*this, *actions_, *runs_, *film_, *studies_, *casePanel_, *aboutCase_, *messages_, *startCard_});
    runFiles_ = new RunFiles(runs(), *page(), *this);
    solutionFiles_ = new SolutionFiles(film_->solutions(), *this);
    guides_ = new Guides(*this, *this);
    pages_->addFoot(*guides_->strip());
    smallMotions_ = new SmallMotionsStrip(*this, guides_->live(), *actions_->smallMotions, *guides_->strip());
    pages_->addFoot(*smallMotions_);
    presenter_ = new Presenter(*this, *this, *actions_, *pages_, *guides_);
    recording_ = new Recording(*actions_->record, *runs_, *this);
    results_ = std::make_unique<ResultMessages>(*messages_, *aboutCase_, *film_);
    closing_ = new ClosingQuestion(*this, *this);
    connectFiles();
    connectRuns();
    connectFilm();
    connectStudies();
    connectView();
    connectHelp();
    connectSession();
    resize(1500, 940);
    pages_->limitSizes();
    updateRunActions();
    updateTitle();
}

MainWindow::~MainWindow()
{
    // These call the window, whose parts live on for a moment.
    for (QObject* caller :
         {static_cast<QObject*>(session_), static_cast<QObject*>(presenter_), static_cast<QObject*>(smallMotions_),
          static_cast<QObject*>(guides_), static_cast<QObject*>(closing_)})
        delete caller;
    guides_ = nullptr;
    // The members and the case's edits are destroyed before the widgets that show them.
    edits_->undoStack().disconnect(this);
    for (QObject* sender : {static_cast<QObject*>(runs_), static_cast<QObject*>(&runs()),
                            static_cast<QObject*>(&controller()), static_cast<QObject*>(film_),
                            static_cast<QObject*>(studies_), static_cast<QObject*>(&studies_->controller())})
        sender->disconnect(this);
    controller().stopAndWait();
    film_->controller().stopAndWait();
    studies_->controller().stopAndWait();
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
    delete takeCentralWidget();
}

void MainWindow::takeTyped()
{
    const QPointer<QWidget> focused = focusWidget();
    if (!focused || !(qobject_cast<QLineEdit*>(focused) || casePanel_->isAncestorOf(focused))) return;
    focused->clearFocus();
    if (focused && focused->isVisible()) focused->setFocus(); // the editor of a cell is closed
}

bool MainWindow::readyToRun()
{
    takeTyped();
    if (edits_->reasonNotToRun().isEmpty()) return true;
    actions_->alone->setChecked(false);
    casePanel_->showFirstProblem();
    return false;
}

void MainWindow::leaveMessage() { messages_->clear(MessageStrip::Topic::Any); }

void MainWindow::solveStaticState(bool atGivenAttitude)
{
    if (!readyToRun()) return;
    messages_->clear();
    setPage(Page::StaticState);
    film_->solve(edits_->value(), atGivenAttitude);
}

void MainWindow::startRun()
{
    if (!readyToRun()) return;
    endSlowMotion();
    recording_->whenFree([this] {
        runs_->start({edits_->value(), files_->wholeText(), recording_->file().toStdString()});
    });
}

void MainWindow::performStudy() { performStudy(nullptr); }

void MainWindow::performStudy(const EngineTask* engine)
{
    setPage(Page::Studies);
    if (!readyToRun()) return;
    const StudyPlan& plan = studies_->editor()->plan();
    if (!plan.valid() || !plan.perform)
        return messages_->show(MessageStrip::Kind::Failure,
                               tr("The study cannot be performed: its errors are listed below its text."));
    const auto perform = [this, by = engine ? std::optional(*engine) : std::nullopt] {
        if (studies_->perform(by)) messages_->clear(); // also that the one before it was stopped
    };
    const QString other = studies_->kindUnderWay();
    if (const StudyReport* former = studies_->unsaved(plan.kind); former && (engine != nullptr || !studies_->goesOn()))
        askToReplaceReport(*this, *former, perform);
    else if (!other.isEmpty() && other != QString::fromStdString(plan.kind))
        askBeforeLoss(*this,
                      {QStringLiteral("studyUnderWay"), tr("Stop a study"),
                       tr("The study “%1” is under way.").arg(studies_->editor()->titleOf(other)),
                       tr("One study is performed at a time: the new one would stop it."), tr("&Stop it")},
                      perform);
    else
        perform();
}

void MainWindow::onCaseOpened()
{
    const bool byGuide = guides_->openedCase();
    casePanel_->setPreset(files_->sample());
    if (byGuide)
        setPage(Page::Run);
    else if (pages_->page() != Page::Studies)
        setPage(Page::StaticState);
    aboutCase_->clearResult();
    aboutCase_->setWarnings({});
    film_->open(edits_->value());
    runs_->view()->opened(files_->sample(), edits_->value());
    runs_->view()->spectrum()->setOptionsOf(edits_->value());
    messages_->clear();
    updateTitle();
}

void MainWindow::onCaseEdited()
{
    aboutCase_->setCase(edits_->value());
    film_->edit(edits_->value());
    if (!film_->solvedAsEdited() && (!film_->result() || film_->stale())) results_->clearSolution();
    runs_->view()->setCase(edits_->value());
    studies_->editor()->setCase(edits_->value());
    pages_->showModel(edits_->value().model);
    updateRunActions();
    updateTitle();
}

void MainWindow::showInFile()
{
    film_->view()->shape()->editor()->setGhost(edits_->value().surface);
    updateTitle();
}

void MainWindow::updateRunActions()
{
    using State = RunController::State;
    const State state = controller().state();
    const QString reason = edits_->reasonNotToRun();
    actions_->run->setEnabled(reason.isEmpty());
    const QString cannot = tr("The case cannot be run. %1").arg(reason);
    actions_->run->setToolTip(
        plainTip(reason.isEmpty() ? tr("Run the case in time; a run in progress starts again (F5)") : cannot));
    actions_->solve->setToolTip(plainTip(
        reason.isEmpty() ? tr("Solve for the static attitude; a solution in progress starts again (F9)") : cannot));
    for (QAction* action : {actions_->solve, actions_->solveGiven})
        action->setEnabled(pages_->model() == ModelKind::Film && reason.isEmpty());
    if (!reason.isEmpty())
        messages_->show(MessageStrip::Kind::Failure, cannot, tr("Show it"), MessageStrip::Topic::Case);
    else
        messages_->clear(MessageStrip::Topic::Case);
    for (QAction* action : {actions_->surface, actions_->underlay})
        action->setEnabled(pages_->model() == ModelKind::Film);
    actions_->pause->setEnabled(state == State::Running || state == State::Paused);
    actions_->pause->setChecked(state == State::Paused);
    actions_->step->setEnabled(state == State::Paused);
    actions_->stop->setEnabled(state == State::Running || state == State::Paused ||
                               film_->controller().state() == SteadyController::State::Running ||
                               film_->view()->busy() || (guides_ && guides_->live().finds()) ||
                               studies_->controller().state() == StudyController::State::Running);
    studies_->setOthersBusy((controller().active() && state != State::Paused) || film_->controller().active() ||
                            film_->view()->busy());
    actions_->resetAll->setEnabled(edits_->anyChanged());
    const bool anyEnded = runs().count() > (controller().active() ? 1 : 0);
    actions_->saveResults->setEnabled(anyEnded);
    actions_->exportCsv->setEnabled(anyEnded);
    pages_->updateProgress();
}

void MainWindow::updateTitle()
{
    setWindowTitle(
        tr("%1[*] – Touchdown").arg(files_->shortName().replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"))));
    setWindowModified(files_->modified());
}

void MainWindow::updateRecentMenu()
{
    actions_->recent->clear();
    for (const QString& file : files_->recent())
        actions_->recent->addAction(onButton(QDir::toNativeSeparators(file)), files_,
                                    [this, file] { files_->open(file); });
    if (actions_->recent->isEmpty()) actions_->recent->addAction(tr("None yet"))->setEnabled(false);
}

void MainWindow::useParametersOf(int number)
{
    const RunRecord* run = runs().find(number);
    if (run && !run->caseProblem.isEmpty())
        messages_->show(
            MessageStrip::Kind::Failure,
            tr("The parameters of run %1 are not known: %2").arg(QString::number(number), run->caseProblem));
    else if (run)
        files_->use(run->value, tr("run %1").arg(number), tr("use the parameters of run %1").arg(number));
}

void MainWindow::runFromSolution(int number)
{
    const SolutionRecord* solution = film_->solutions().find(number);
    if (!solution) return;
    const bool held = solution->value.steady.fixedAttitude;
    if (solution->result.status != SteadyStatus::Converged && !held)
        return messages_->show(MessageStrip::Kind::Failure,
                               tr("Solution %1 did not converge: no run can start from it.").arg(number));
    Case c = withRunOf(solution->value, edits_->value());
    const Attitude& attitude = solution->result.attitude;
    // At a balance the run starts from the solution; elsewhere where the slider was held.
    c.initial.state = held ? InitialState::Given : InitialState::Static;
    c.initial.nominalTrailingEdgeHeight = attitude.height;
    c.initial.pitch = attitude.pitch;
    c.initial.roll = attitude.roll;
    files_->use(c, tr("solution %1").arg(number), tr("run from solution %1").arg(number), [this] { startRun(); });
}

void MainWindow::useTheme(const QString& name)
{
    givenTheme_ = name;
    look();
}

void MainWindow::look()
{
    const QSize before = size();
    const QAction* theme = actions_->theme->checkedAction();
    const QAction* size = actions_->fontSize->checkedAction();
    const int own = systemPointSize() + (size ? size->data().toInt() : 0);
    const QString name = !givenTheme_.isEmpty() ? givenTheme_ : theme ? theme->data().toString() : QString();
    applyTheme(name.isEmpty() ? Theme::System : themeFromName(name),
               presenter_->on() ? std::max(own, presenter_->pointSize()) : own);
    pages_->limitSizes();
    QMetaObject::invokeMethod(
        this, [this, before] { followFont(before); }, Qt::QueuedConnection); // with the new font
}

/// When every part has the new font: the window keeps its size.
void MainWindow::followFont(const QSize& before)
{
    // A combo box forgets its least size with the style only.
    QEvent style(QEvent::StyleChange);
    for (QComboBox* box : findChildren<QComboBox*>()) QCoreApplication::sendEvent(box, &style);
    pages_->limitSizes();
    // An empty label keeps the height that it had with the former font, and a hidden part the one of its labels.
    for (QLabel* label : statusBar()->findChildren<QLabel*>()) label->setIndent(label->indent());
    for (const QWidget* part : statusBar()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (part->layout()) part->layout()->invalidate();
    actions_->toolBar->layout()->invalidate();
    if (!isMaximized() && !isFullScreen()) resize(before);
    QCoreApplication::postEvent(statusBar(), new QEvent(QEvent::LayoutRequest));
}

void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    if (!std::exchange(arranged_, true)) pages_->arrangeAtFirst();
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
        if (CaseFiles::canOpen(url.toLocalFile())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (CaseFiles::canOpen(url.toLocalFile())) files_->open(url.toLocalFile());
    event->acceptProposedAction();
}

} // namespace touchdown
