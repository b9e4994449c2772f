// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the window for studies: the pane with the study's text, the page with its results, the progress, and the
// calculation between them.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "core/studies/engine/engine.h"
#include "core/studies/study_plan.h"
#include "ui/studies/study_controller.h"
#include "ui/studies/study_pilot.h"
#include "ui/style/whole_file.h"

namespace touchdown {

class ProgressStrip;
class StudyEditor;
class StudyResults;
struct StoredStudy;
struct StudyCatalogue;

/// What was performed, and what came of it.
struct StudyOutcome {
    StudyPlan plan;                    // as it was performed
    std::optional<StudyReport> report; // none before the first result
    SavedFile file;                    // that the user saved the report to
    int number = 0;                    // of the calculation; 0: it was restored
    QString runs{};                    // the folder with the results of its runs; empty: it keeps none
    bool isContinued = false;          // its time is not that of all its rows
};

class StudyWindow : public QObject {
    Q_OBJECT

public:
    StudyWindow(StudyCatalogue catalogue, QWidget* parent);

    StudyEditor* editor() const { return editor_; }
    StudyResults* results() const { return results_; }
    ProgressStrip* progress() const { return progress_; }
    StudyController& controller() { return controller_; }
    StudyPilot& pilot() { return pilot_; }

    /// Performs the study in the editor, by this engine if there is one; false if it has errors. Here, rows of the
    /// latest list of its kind are taken as they are.
    bool perform(const std::optional<EngineTask>& engine = {});
    /// Whether the study in the editor ended early and goes on with the rows that it has.
    bool goesOn() const;
    /// The kind of the study under way; empty: none.
    QString kindUnderWay() const { return controller_.active() ? QString::fromStdString(performing_) : QString(); }
    bool underWay(const std::string& kind) const { return controller_.active() && kind == performing_; }

    /// Whether a run or a static state has the processors: then no pilot runs beside it.
    void setOthersBusy(bool busy);

    /// The latest of each kind.
    const std::map<std::string, StudyOutcome>& outcomes() const { return outcomes_; }
    /// nullptr: there is none.
    const StudyOutcome* outcome(const std::string& kind) const;
    /// The report of a kind, also of a study under way, that no file of the user has; nullptr: there is none, or it has
    /// nothing to show.
    const StudyReport* unsaved(const std::string& kind) const;
    /// Saves the report of a kind that has one. Returns "" or the problem in a sentence.
    QString save(const std::string& kind, const QString& file);
    /// A report that was read from a file, as if it had been performed here. `file`: of the user; empty: none.
    void restore(StoredStudy stored, const QString& file = {});

signals:
    void started();
    /// After the page shows the report.
    void ended(const touchdown::StudyReport& report);
    /// The user wants to edit the case that the study found.
    void applyRequested(const touchdown::Case& found, const QString& kind);
    /// The user wants to see a case of a list.
    void caseRequested(const touchdown::Case& c, const QString& name);
    /// The user wants to see a run of a list, whose results are in this file.
    void runRequested(const QString& file);
    void succeeded(const QString& message);
    void failed(const QString& problem);

private:
    void onFinished(StudyReport report);
    /// Whether a row of the shown report has a case; the file with its run, "" where there is none.
    bool hasCase(int row) const;
    QString runOf(int row) const;
    /// The results of the chosen kind, if there are any.
    void show();
    void updateStale();
    /// Says how long the study in the editor takes; asks the pilot where that is not known.
    void updateDuration();
    void startPilot();
    void chooseSave();

    StudyController controller_;
    StudyPilot pilot_;
    QTimer pilotSoon_;
    StudyPlan estimated_; // of which the duration was asked
    QString duration_;    // of it, in a sentence
    bool othersBusy_ = false;
    StudyEditor* editor_;
    StudyResults* results_;
    ProgressStrip* progress_;
    std::map<std::string, StudyOutcome> outcomes_;
    bool byEngine_ = false;
    std::shared_ptr<std::size_t> taken_; // rows of the latest list that were there already
    std::string performing_;             // the kind of the study under way, or of the last one
    std::string shown_;                  // the kind on the page
};

} // namespace touchdown
