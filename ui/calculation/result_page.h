// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a result. Above: the button that starts or stops its calculation, the progress, whether the case has
// changed since, and a remark. Below: an introduction while there is no result, then a picture and the table of its
// rows, which is copied and saved. A page derives from it with its words, its rows and its remarks.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

#include "ui/calculation/progress_strip.h"
#include "ui/style/result_table.h"
#include "ui/style/whole_file.h"

namespace touchdown {

/// A text while there is no result; then the two parts of the result over each other.
class ResultPages : public QStackedWidget {
    Q_OBJECT

public:
    explicit ResultPages(QWidget* parent);

    /// Heights in px. Of more room the upper part takes `upperShare`, the lower part `lowerShare`.
    void setParts(QWidget* upper, QWidget* lower, const QList<int>& heights, int upperShare = 1, int lowerShare = 0);
    void introduce(const QString& title, const QString& html);
    void showResult(bool known) { setCurrentIndex(known ? 1 : 0); }
    bool empty() const { return currentIndex() == 0; }

private:
    QLabel* introduction_;
};

class ResultPage : public QWidget {
    Q_OBJECT

public:
    ResultTable* table() const { return table_; }
    virtual bool stale() const = 0;
    /// All numbers of the result, as comma-separated values.
    virtual QByteArray csv() const = 0;
    /// Writes csv(). "" or the problem in a sentence.
    QString save(const QString& path);

signals:
    /// Another result is known, or none any more.
    void changed();

public slots:
    /// Finds the result for the case, or stops that.
    virtual void startOrStop() = 0;

protected:
    struct Words {
        QString result;                       // "series", in names of the parts of the page
        QString calculation, running;         // of the progress: "search for modes", "Searching"
        QString start, startTip;              // of the button
        QString title, introduction, awaited; // while there is no result: before and during the calculation
    };
    struct Notes {
        QString remark;
        bool failed = false; // the remark says why there is no result
        bool stale = false;  // the case has changed since
    };

    /// `controller` of the derived page. `setup`: what is chosen before the start; nullptr: nothing.
    void build(CalculationController& controller, const Words& words, QWidget* setup, QWidget* picture,
               const QList<int>& heights);
    explicit ResultPage(QWidget* parent)
        : QWidget(parent), start_(new QPushButton(this)) {} // first in the order of Tab
    virtual Notes notes() const = 0;
    /// To be called where they may have changed.
    void showNotes();
    void showResult(bool known) { pages_->showResult(known); }
    ProgressStrip& progress() { return *progress_; }
    /// Whether a file has what the table shows.
    bool saved() const { return saved_.holds(); }
    /// The table shows another result.
    void forgetFile() { saved_ = {}; }

    void changeEvent(QEvent* event) override;

private:
    QLayout* buildHead();
    QWidget* buildTable();
    void chooseSave();

    Words words_;
    CalculationController* controller_ = nullptr;
    QWidget* setup_ = nullptr;
    QPushButton* start_;
    ProgressStrip* progress_ = nullptr;
    QLabel *stale_ = nullptr, *remark_ = nullptr;
    ResultPages* pages_ = nullptr;
    ResultTable* table_ = nullptr;
    QToolButton *copy_ = nullptr, *save_ = nullptr;
    SavedFile saved_;
};

} // namespace touchdown
