// SPDX-License-Identifier: GPL-3.0-or-later
//
// The profile of a wall as a curve: the recess downwards, as it lies on the slider seen from its side, against the
// distance from the edge. Its points can be changed.
//
// Mouse: drag a point; double click on the curve adds one. Keys: N and B choose the next and the previous point, arrows
// move it by 0.1 µm along the distance and by 10 nm in recess, with Shift ten times as far; Insert or + adds a point
// after it, Del removes it, Esc gives a drag back.
#pragma once

#include <optional>

#include <QPixmap>
#include <QWidget>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// The curve alone, for menus and lists; a vertical edge for a profile without points. `width` fills the picture [m],
/// so that several can be compared; nothing: that of the wall.
QPixmap wallPixmap(const WallProfile& wall, const QSize& size, const QPalette& palette, double ratio,
                   std::optional<double> width = {});

class WallPicture : public QWidget {
    Q_OBJECT

public:
    explicit WallPicture(QWidget* parent = nullptr);

    void setWall(const WallProfile& wall);
    const WallProfile& wall() const { return wall_; }
    std::optional<std::size_t> point() const { return point_; }
    void setPoint(std::optional<std::size_t> point);
    /// Where a point of the profile is drawn [px].
    QPointF pixel(std::size_t point) const;

    QSize sizeHint() const override { return {200, 150}; }
    QSize minimumSizeHint() const override { return {120, 80}; }

signals:
    void pointChosen(int point);
    /// `row`: one of several moves by keys in a row.
    void edited(const touchdown::WallProfile& wall, bool row);

protected:
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// The distances and recesses that the picture spans [m].
    struct Span {
        double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
        bool operator==(const Span&) const = default;
    };
    static Span spanOf(const WallProfile& wall);
    QRectF area() const;
    QPointF toPixel(double distance, double recess) const;
    std::optional<std::size_t> pointAt(const QPointF& pixel) const;
    bool isComplete() const { return wall_.distance.size() >= 2 && wall_.recess.size() == wall_.distance.size(); }
    void choose(std::size_t point);
    void moveBy(double distance, double recess);
    void addAt(double distance);
    void paintScale(QPainter& painter) const;

    WallProfile wall_, before_; // as shown, and before a drag
    Span span_;                 // stays during a drag
    std::optional<std::size_t> point_;
    bool dragging_ = false;
};

} // namespace touchdown
