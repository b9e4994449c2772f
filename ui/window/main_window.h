// SPDX-License-Identifier: GPL-3.0-or-later
//
// The workbench: parameters at the left; in the centre the pages of runs over time, of a film's static state and of
// studies; the case, the runs and the values at the cursors, or the static attitude, or the text of a study at the
// right; what happened at the foot.
#pragma once

#include <memory>

#include <QMainWindow>

#include "ui/runs/run_window.h"
#include "ui/window/help_window.h"
#include "ui/window/window_pages.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

class AboutCasePane;
class CasePanel;
class ClosingQuestion;
class Guides;
class Presenter;
class Recording;
class ResultMessages;
class RunFiles;
class RunView;
class Session;
class SmallMotionsStrip;
class StartCard;
class SolutionFiles;
class WindowActions;
struct EngineTask;
struct SteadyResult;
struct StudyCatalogue;
struct StudyReport;
struct Summary;

class MainWindow : public QMainWindow, public Workbench {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    /// With other studies than those of the core.
    explicit MainWindow(StudyCatalogue studies, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Geometry, theme, font and panes of the last session.
    void restoreArrangement();
    /// Not larger than the screen, with the frame that the system draws about a window.
    void fitScreen();
    /// Instead of the chosen theme, until another one is chosen.
    void useTheme(const QString& name);
    /// The case of the last session, or the default case.
    void openLastCase();
    /// From now on the work is kept against a crash. `offer`: asks whether to restore a session that broke off.
    /// `remarks`: sentences to be shown with its own.
    void beginSession(bool offer, QStringList remarks = {});
    /// Shows a newcomer the default case in slow motion, and where to go from there.
    void greet();
    void startRun() override;
    /// Solves a film case for its static state, or only for the pressure at the attitude of its start.
    void solveStaticState(bool atGivenAttitude = false);
    void performStudy() override;
    /// Performs the lesson beside the window and writes it as PDF.
    void printLessonTo(const QString& file);
    void setPage(Page page) override { pages_->setPage(page); }
    Page shownPage() const override { return pages_->page(); }
    /// The page that is shown, as it is exported.
    QWidget* page() const { return pages_->pages(); }

    CaseEdits& edits() override { return *edits_; }
    CaseFiles& files() override { return *files_; }
    RunsModel& runs() { return runs_->runs(); }
    RunController& controller() { return runs_->controller(); }
    WindowActions& actions() { return *actions_; }
    CasePanel& casePanel() { return *casePanel_; }
    RunWindow& runWindow() override { return *runs_; }
    RunView& runView() { return *runs_->view(); }
    MessageStrip& messages() override { return *messages_; }
    StartCard& startCard() { return *startCard_; }
    AboutCasePane& aboutCase() { return *aboutCase_; }
    Guides& guides() { return *guides_; }
    Presenter& presenter() { return *presenter_; }
    FilmWindow& film() override { return *film_; }
    StudyWindow& studies() override { return *studies_; }

signals:
    /// A run, a solution or a study has ended, after the window shows it; `valid` when it has an answer.
    void calculationEnded(bool valid, const QString& message);

protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// `engine`: by which, if not here.
    void performStudy(const EngineTask* engine);
    void connectFiles();
    void connectRuns();
    void connectFilm();
    void connectStudies();
    void connectView();
    void connectHelp();
    void connectSession();

    /// Takes text that was typed into a field or a cell and not confirmed yet.
    void takeTyped();
    bool readyToRun();
    /// A message belongs to the page and the tab on which it was shown; one about the case to all.
    void leaveMessage();
    void onCaseOpened();
    /// The values are those of the file.
    void showInFile();
    void onCaseEdited();
    void onRunEnded(int number, const Summary& summary);
    void onSolved(const SteadyResult& result);
    /// The text of a study (TOML) or its saved report (HDF5).
    void openStudy(const QString& file);
    void onStudyOpened(const QString& file);
    void onStudied(const StudyReport& report);
    void updateRunActions();
    void updateTitle();
    void updateRecentMenu();
    void makeFigure();
    void printLesson();
    void showGallery();
    void chooseNewCase();
    void endSlowMotion();
    void useParametersOf(int number);
    void runFromSolution(int number);
    void showHelp(HelpWindow::Page page);
    void look();
    void followFont(const QSize& before);
    void listSessions();
    void showWhatIsKept();
    void saveArrangement();

    CaseEdits* edits_;
    WindowActions* actions_;
    CaseFiles* files_;
    RunFiles* runFiles_ = nullptr;
    SolutionFiles* solutionFiles_ = nullptr;
    CasePanel* casePanel_;
    AboutCasePane* aboutCase_;
    RunWindow* runs_;
    FilmWindow* film_;
    StudyWindow* studies_;
    MessageStrip* messages_;
    StartCard* startCard_;
    WindowPages* pages_ = nullptr;
    HelpWindow* help_ = nullptr;
    Guides* guides_ = nullptr;
    SmallMotionsStrip* smallMotions_ = nullptr;
    Presenter* presenter_ = nullptr;
    QString givenTheme_;         // by the command line; empty: none
    bool slowMotion_ = false;    // of the first steps
    Session* session_ = nullptr; // none in a window that only draws pictures
    Recording* recording_ = nullptr;
    std::unique_ptr<ResultMessages> results_;
    ClosingQuestion* closing_ = nullptr;
    bool arranged_ = false; // the panes, by the user or at first
    bool mayClose_ = false; // that question was answered
};

} // namespace touchdown
