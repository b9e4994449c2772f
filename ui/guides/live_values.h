// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of the case that the reader moves: a slider for each, with its unit, its ends, and a mark at the value that
// the case was opened with. A double click on a slider takes the value back to the mark.
#pragma once

#include <string>
#include <vector>

#include <QLabel>
#include <QWidget>

#include "core/case/case.h"
#include "core/studies/lesson/lesson.h"

namespace touchdown {

class MarkedSlider;

class LiveValues : public QWidget {
    Q_OBJECT

public:
    /// `rows`: one below another, or beside it.
    explicit LiveValues(QWidget* parent = nullptr, Qt::Orientation rows = Qt::Vertical);
    /// The values of a step, of the case of its first run; none where that is a study.
    void setStep(const LessonStep& step);
    /// `own`: the case that these values are of.
    void setValues(const std::vector<LiveValue>& values, const Case& own);
    /// The case that is edited; a slider whose parameter it does not use is disabled.
    void showCase(const Case& c);
    const Case& shownCase() const { return case_; }
    /// In the order of Tab.
    std::vector<QWidget*> inputs() const;

signals:
    /// `text` as a case file has it, with three digits, or with those of the case at its mark: "3.62 mN".
    void moved(const touchdown::LiveValue& value, const std::string& text);
    /// The reader let go.
    void settled();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        LiveValue value;
        double own = 0.0;    // [unit of the parameters]
        std::string ownText; // the same, as a case file has it
        QWidget* cell;       // of the two
        MarkedSlider* slider;
        QLabel* label; // with the number
    };
    void settle();
    void write();

    std::vector<Row> rows_;
    Case case_;
    bool moving_ = false; // until settled()
};

} // namespace touchdown
