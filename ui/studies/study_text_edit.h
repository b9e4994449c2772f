// SPDX-License-Identifier: GPL-3.0-or-later
//
// Editor of the text of a study: fixed font, grey comments, lines with a problem marked.
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
