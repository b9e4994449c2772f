// SPDX-License-Identifier: GPL-3.0-or-later
//
// One message at the foot of the window: the outcome of a run, a failure, a warning.
//
// It has the height of one line, whatever it says and also while it says nothing, so that the page above never moves.
// A click on a message that is longer shows all of it, over the page.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>

namespace touchdown {

class MessageStrip : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Information, Success, Warning, Failure };
    Q_ENUM(Kind)
    /// Case: about the case as it is now, to be cleared when this is over.
    enum class Topic { Any, Case };

    explicit MessageStrip(QWidget* parent = nullptr);

    /// `action` and `second` are the texts of buttons, for which `actionRequested` and `secondRequested` are emitted;
    /// none when empty.
    void show(Kind kind, const QString& text, const QString& action = {}, Topic topic = Topic::Any,
              const QString& second = {});
    void clear();
    /// Only a message of this topic.
    void clear(Topic topic);
    /// Whether it keeps its place while it is hidden; it does at first.
    void keepPlace(bool kept);
    const QString& text() const { return text_; }
    Kind kind() const { return kind_; }
    /// The line does not show all of it.
    bool isCut() const { return !more_->isHidden(); }
    /// Shows all of it over the page, or no longer.
    void showWhole(bool on);
    const QPlainTextEdit* whole() const { return whole_; }

signals:
    void actionRequested();
    void secondRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void colour();
    void fitHeight();
    void fitLine();
    void placeWhole();

    Kind kind_ = Kind::Information;
    Topic topic_ = Topic::Any;
    QString text_;
    QLabel *mark_, *line_;
    QToolButton* more_;
    QPushButton *action_, *second_;
    QPlainTextEdit* whole_; // over the page
};

} // namespace touchdown
