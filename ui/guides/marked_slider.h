// SPDX-License-Identifier: GPL-3.0-or-later
//
// A horizontal slider with a mark at one of its places, and the texts of its two ends below.
#pragma once

#include <QSlider>
#include <QTimer>

namespace touchdown {

class MarkedSlider : public QSlider {
    Q_OBJECT

public:
    explicit MarkedSlider(QWidget* parent = nullptr);

    /// From 0 at the left end to 1 at the right one.
    void setMark(double share);
    int markedStep() const;
    void setEnds(const QString& left, const QString& right);
    /// Without a signal.
    void setShare(double share);
    double share() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// By the user; a step of value().
    void movedTo(int step);
    /// The user let go of it, or stopped pressing keys.
    void settled();

protected:
    void initStyleOption(QStyleOptionSlider* option) const override;
    void paintEvent(QPaintEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    /// Whoever scrolls the text does not move a value.
    void wheelEvent(QWheelEvent* event) override;

private:
    int thickness() const; // of the slider alone [px]
    int xOf(double share) const;

    double mark_ = 0.0;
    QString left_, right_;
    QTimer rest_; // after the last key
};

} // namespace touchdown
