// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kind of study and its text, which starts with the defaults for the case in the window: as a form, as text, and
// the sample studies of all kinds. Errors are listed while the user types. The text of each kind is kept; a text
// without changes follows the case.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "ui/studies/study_draft.h"
#include "ui/studies/study_form_view.h"
#include "ui/studies/study_samples.h"
#include "ui/studies/study_text_edit.h"

namespace touchdown {

struct EngineTask;
class TomlEditor;

/// The studies that the window offers.
struct StudyCatalogue {
    std::vector<StudyKind> kinds;
    std::vector<SampleStudy> samples;
    std::function<std::string(const std::string& kind, const Case& c)> defaultText; // of a study of this case
    std::function<StudyPlan(const std::string& kind, const std::string& text, const std::string& name,
                            const std::filesystem::path& folder, const Case& c)>
        plan;
    std::function<StudyForm(const std::string& kind, const Case& c)> form{}; // none: without fields
};
StudyCatalogue coreStudies();

class StudyEditor : public QWidget {
    Q_OBJECT

public:
    explicit StudyEditor(StudyCatalogue catalogue, QWidget* parent = nullptr);

    /// The case in the window, as it is edited.
    void setCase(const Case& c);
    void setKind(const QString& name);
    /// Of the file of the chosen kind's text; empty: it has none.
    QString folder() const;
    QString kind() const { return kinds_->currentData().toString(); }
    /// The plan of the chosen kind; an empty study is a plan with a problem.
    const StudyPlan& plan();
    void setText(const QString& text) { text_->setPlainText(text); }
    QString toText() const { return text_->toPlainText(); }
    void openSample(const SampleStudy& sample);
    /// A sweep of the case over a key; asks first where it would replace an edited one.
    void vary(const std::string& key);
    /// Empty, or why the file cannot be read. Asks first where it would replace an edited text.
    QString open(const QString& file);
    /// Writes the text of a kind. Empty, or why the file cannot be written: also that another program has changed it.
    QString save(const QString& kind, const QString& file);
    QString save(const QString& file) { return save(kind(), file); }
    /// As save(), and says so; asks first if another program has changed the file since it was opened or saved.
    void saveTo(const QString& file) { saveTo(kind(), file, {}); }
    /// The texts that were edited since they were opened or saved, with what is typed in the form and not taken yet.
    std::vector<StudyDraft> unsaved() const;
    /// A text from another window; false where an edited one would be replaced, or there is no such kind.
    bool restore(const StudyDraft& draft);
    /// The text of a report, where its kind has none but the defaults.
    void showTextOf(const std::string& kind, const std::string& text);
    /// Of a kind, as the list shows it.
    QString titleOf(const QString& kind) const;
    /// Whether a study is under way; one of the chosen kind?
    void setRunning(bool running, bool chosen);
    /// Whether the study goes on with the rows that it has.
    void setContinues(bool continues);
    /// The time that the study takes, in a sentence; empty: nothing is said.
    void setDuration(const QString& sentence);
    QString duration() const { return duration_->text(); }

    QComboBox* kinds() const { return kinds_; }
    QPushButton* run() const { return run_; }
    QPushButton* stop() const { return stop_; }
    QToolButton* cluster() const { return cluster_; }
    QString problems() const { return problems_->text(); }
    StudyFormView* form() const { return form_; }
    StudySamples* samples() const { return samples_; }
    QTabWidget* tabs() const { return tabs_; }
    /// Which case is studied, as rich text.
    QString subject() const { return subject_->text(); }

signals:
    void runRequested();
    /// The study is to be performed elsewhere.
    void engineChosen(const touchdown::EngineTask& engine);
    void stopRequested();
    /// Something was opened or saved, or could not be.
    void succeeded(const QString& message);
    void failed(const QString& problem);
    void fileOpened(const QString& file);
    /// A text has changed, or its file, or what is typed in the form.
    void edited();
    /// Another plan, another kind.
    void planned();
    void hidden();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Draft : StudyDraft {
        QString defaults; // a text that equals them follows the case
    };

    void build();
    void chooseOpen();
    void chooseEngine();
    /// Whether this is the draft's file, and another program has changed it since it was opened or saved.
    static bool changedOutside(const StudyDraft& draft, const QString& file);
    /// Asks about an edited text of a kind; calls `next` unless the user cancels.
    void whenSettled(const QString& kind, const std::function<void()>& next);
    /// Asks for a file and writes the text to it; then calls `next`, if there is one.
    void chooseSave(const QString& kind, const std::function<void()>& next);
    void saveTo(const QString& kind, const QString& file, const std::function<void()>& next);
    /// Before the file of a study is written over that another program has changed.
    void askAboutFile(const QString& kind, const QString& file, const std::function<void()>& next);
    void showKind();
    void showForm();
    void enter(const QString& key, const QString& value);
    /// The text of the chosen kind with another value of a key.
    QString textWith(const std::string& key, const std::string& value) const;
    /// Changes tables of the text.
    void change(const std::function<void(TomlEditor&)>& change);
    void replaceText(const QString& text);
    void takeDefaults();
    void replan();
    void showProblems();
    void nameRun();
    void colour();

    StudyCatalogue catalogue_;
    Case case_;
    std::map<QString, Draft> drafts_;
    StudyPlan plan_;
    bool running_ = false, continues_ = false; // the study of the chosen kind
    bool stale_ = true;                        // the plan is of another text or another case
    QTimer soon_;

    QComboBox* kinds_;
    QLabel* help_;
    QLabel* subject_; // the case that is studied
    QTabWidget* tabs_;
    StudyFormView* form_;
    StudyTextEdit* text_;
    StudySamples* samples_;
    QLabel* problems_;
    QLabel* duration_; // of the study
    QPushButton *run_, *stop_;
    QToolButton *open_, *save_, *defaults_, *cluster_;
};

} // namespace touchdown
