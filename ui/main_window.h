// SPDX-License-Identifier: GPL-3.0-or-later
//
// The workbench: parameters at the left, live plots and the spectrum in the centre, the case, the runs and the values at
// the cursors at the right, what happened at the foot.
#pragma once

#include "ui/about_case_pane.h"
#include "ui/case_files.h"
#include "ui/case_panel.h"
#include "ui/cursor_table.h"
#include "ui/help_window.h"
#include "ui/live_plots.h"
#include "ui/live_spectrum.h"
#include "ui/message_strip.h"
#include "ui/run_controller.h"
#include "ui/run_files.h"
#include "ui/run_progress.h"
#include "ui/runs_panel.h"
#include "ui/window_actions.h"

#include <QMainWindow>
#include <QSplitter>

namespace touchdown {

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// What the last session left: geometry, theme, font, panes.
    void restoreSession();
    /// The case that the last session left, or the default one.
    void openLastCase();
    void startRun();
    void openResults(const QString& file) { runFiles_->openRun(file); }
    /// The plots and the spectrum, as they are exported.
    QWidget* page() const { return page_; }

    CaseEdits& edits() { return edits_; }
    CaseFiles& files() { return *files_; }
    RunsModel& runs() { return runs_; }
    RunController& controller() { return controller_; }
    WindowActions& actions() { return *actions_; }
    CasePanel& casePanel() { return *casePanel_; }
    RunsPanel& runsPanel() { return *runsPanel_; }
    LivePlots& plots() { return *plots_; }
    LiveSpectrum& spectrum() { return *spectrum_; }
    MessageStrip& messages() { return *messages_; }
    RunProgress& progress() { return *progress_; }
    AboutCasePane& aboutCase() { return *aboutCase_; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildCentre();
    void buildDocks();
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    void connectFiles();
    void connectRuns();
    void connectView();
    void connectHelp();

    void onCaseOpened();
    void onCaseEdited();
    void onRunStarted(int run);
    void onRunDelivered(const RunDelivery& delivery);
    void onRunFinished(int run, const Summary& summary);
    void updateRunActions();
    void updateTitle();
    void updateRecentMenu();
    void chooseRecording(bool on);
    void useParametersOf(int number);
    void showHelp(HelpWindow::Page page);
    void look();
    void saveSession();

    RunsModel runs_;
    CaseEdits edits_;
    RunController controller_;
    WindowActions* actions_;
    CaseFiles* files_;
    RunFiles* runFiles_ = nullptr;
    CasePanel* casePanel_;
    RunsPanel* runsPanel_;
    AboutCasePane* aboutCase_;
    LivePlots* plots_;
    LiveSpectrum* spectrum_;
    CursorTable* cursorTable_ = nullptr;
    QWidget* page_ = nullptr;
    QSplitter* splitter_ = nullptr;
    MessageStrip* messages_;
    RunProgress* progress_;
    HelpWindow* help_ = nullptr;
    QString recordTo_;
    int runNumber_ = -1;     // in the list, of the run under way
    bool closing_ = false;   // the question about changes was answered
};

} // namespace touchdown
