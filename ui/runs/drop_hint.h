// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a drop would do, drawn over the plots during a drag: a frame about the plot with a sentence, and at the foot a
// strip for a plot of its own.
#pragma once

#include <QWidget>

namespace touchdown {

class DropHint : public QWidget {
    Q_OBJECT

public:
    /// Covers its parent; the mouse goes through.
    explicit DropHint(QWidget* parent);

    /// `target` of the parent is marked, with what a drop there does, or why it does nothing.
    void show(const QRect& target, const QString& text, bool refused);
    /// The strip at the foot of the parent.
    QRect strip() const;
    const QString& text() const { return text_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect target_;
    QString text_;
    bool refused_ = false;
};

} // namespace touchdown
