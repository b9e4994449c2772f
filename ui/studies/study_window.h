// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the window for studies: the pane with the study's text, the page with its results, the progress, and the
// calculation between them.
#pragma once

#include <map>
#include <optional>

#include <QObject>

#include "core/studies/study_plan.h"
#include "ui/studies/study_controller.h"

namespace touchdown {

class ProgressStrip;
class StudyEditor;
class StudyResults;
struct StudyCatalogue;

class StudyWindow : public QObject {
    Q_OBJECT

public:
    StudyWindow(StudyCatalogue catalogue, QWidget* parent);

    StudyEditor* editor() const { return editor_; }
    StudyResults* results() const { return results_; }
    ProgressStrip* progress() const { return progress_; }
    StudyController& controller() { return controller_; }

    /// Performs the study in the editor; false if it has errors.
    bool perform();

signals:
    void started();
    /// After the page shows the report.
    void ended(const touchdown::StudyReport& report);
    /// The user wants to edit the case that the study found.
    void applyRequested(const touchdown::Case& found, const QString& kind);
    void succeeded(const QString& message);
    void failed(const QString& problem);

private:
    struct Outcome {
        StudyPlan plan;                    // as it was performed
        std::optional<StudyReport> report; // none before the first result
    };

    void onFinished(const StudyReport& report);
    /// The results of the chosen kind, if there are any.
    void show();
    bool underWay(const std::string& kind) const { return controller_.active() && kind == performing_; }
    void updateStale();
    void chooseSave();

    StudyController controller_;
    StudyEditor* editor_;
    StudyResults* results_;
    ProgressStrip* progress_;
    std::map<std::string, Outcome> outcomes_; // the latest of each kind
    std::string performing_;                  // the kind of the study under way, or of the last one
    std::string shown_;                       // the kind on the page
};

} // namespace touchdown
