// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lesson on paper, A4: for each step its texts, its runs with what they gave, a picture of its plots, the answer.
//
// The runs are performed beside the window, one after another, in a list and on plots of their own. A study of a step
// is named with its command. Runs with springs and with a film have pictures of their own.
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QImage>
#include <QObject>
#include <QString>

#include "core/studies/lesson/lesson.h"
#include "ui/calculation/task_queue.h"
#include "ui/runs/runs_model.h"

class QTextDocument;

namespace touchdown {

class LessonStages;
class RunView;

class LessonPrint : public QObject {
    Q_OBJECT

public:
    LessonPrint(std::vector<LessonStep> steps, const QString& title, QObject* parent);
    /// Ends the run under way.
    ~LessonPrint() override;

    /// A dialog with its progress and a way to cancel it, until it has ended; `file` is its name there.
    void showProgress(QWidget* window, const QString& file);
    /// `ended` follows, in any case.
    void start();
    void cancel();
    int runs() const; // that are performed in all

    /// After its end: as HTML, and as a file of PDF.
    const QString& html() const { return html_; }
    QByteArray pdf() const;
    int pages() const; // of that file

signals:
    void performed(int runs); // so far
    /// `problem` in a sentence; empty: it is whole, or was cancelled.
    void ended(bool whole, const QString& problem);

private:
    void next();
    void perform(std::size_t run);
    void finishModel();
    void showOnly(std::optional<int> number);
    void addStep();
    void addPicture(bool several);
    std::unique_ptr<QTextDocument> document() const;

    std::vector<LessonStep> steps_;
    QString title_;
    RunsModel list_;
    std::unique_ptr<RunView> view_; // never on the screen
    std::unique_ptr<LessonStages> stages_;
    std::size_t step_ = 0, run_ = 0;     // that is next
    std::map<std::size_t, int> numbers_; // of the step's runs in the list
    ModelKind model_ = {};               // of the last run
    bool allThere_ = false;              // all runs of the step with that model have been performed
    int performed_ = 0;
    std::vector<QImage> pictures_; // so far
    QString figures_;              // those of the step, as HTML
    QString html_;
    std::atomic<bool> cancelled_ = false;
    TaskQueue queue_; // last: its tasks use what stands above
};

} // namespace touchdown
