// SPDX-License-Identifier: GPL-3.0-or-later
//
// One message at the foot of the window: the outcome of a run, a failure, a warning.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

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
    /// Whether it takes the place of one line while it is hidden; it does at first.
    void keepPlace(bool kept);
    QString text() const { return text_->text(); }
    Kind kind() const { return kind_; }

signals:
    void actionRequested();
    void secondRequested();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void colour();

    Kind kind_ = Kind::Information;
    Topic topic_ = Topic::Any;
    QLabel* mark_;
    QLabel* text_;
    QPushButton *action_, *second_;
};

} // namespace touchdown
