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

    /// Performs what the editor says; false where there is something wrong with it.
    bool perform();

signals:
    void started();
    /// Everything shows it by now.
    void ended(const touchdown::StudyReport& report);
    /// The case that was found is wanted as the case of the window.
    void applyRequested(const touchdown::Case& found, const QString& kind);
    void succeeded(const QString& message);
    void failed(const QString& problem);

private:
    struct Outcome {
        StudyPlan plan;                    // as it was performed
        std::optional<StudyReport> report; // nothing while there is nothing to show
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
    std::string shown_;                       // the kind of what is shown
};

} // namespace touchdown
