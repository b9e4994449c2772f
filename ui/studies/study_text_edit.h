// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of a study as it is written: fixed font, quiet comments, the line of a problem marked.
#pragma once

#include <QPlainTextEdit>
#include <QSyntaxHighlighter>

namespace touchdown {

class StudyTextEdit : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit StudyTextEdit(QWidget* parent = nullptr);

    /// Lines count from 1.
    void markLines(const std::vector<int>& lines);
    void goToLine(int line);

protected:
    void changeEvent(QEvent* event) override;

private:
    class Comments;

    void adaptFont();
    void paintMarks();

    Comments* comments_;
    std::vector<int> marked_;
};

} // namespace touchdown
