// SPDX-License-Identifier: GPL-3.0-or-later
//
// A map of the slider in true proportions, seen from the side of the disk: x to the right from the leading to the
// trailing edge, y upwards from the inner to the outer edge, scales in mm, names of the edges, an arrow for the air
// flow, a key at the right. Or a piece of another surface, in mm or µm, without these names. Derived classes draw the
// content.
//
// Mouse: wheel zooms about the pointer, drag moves, double click fits, click chooses a point, Shift + click another
// one. Keys: arrows move, + and - zoom, Home fits.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include <QRectF>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/air_bearing_surface.h"
#include "ui/plot/picture_widget.h"
#include "ui/plot/plot_axis.h"

namespace touchdown {

struct PlotFrame;

class SliderPlan : public PictureWidget {
    Q_OBJECT

public:
    explicit SliderPlan(QWidget* parent = nullptr);

    /// It is being painted on paper.
    bool onPaper() const { return paper_; }
    void setSlider(double length, double width); // [m]
    /// A pad or a piece of the disk instead of the slider; its top is the smallest y [m].
    void setPiece(const QRectF& area);
    /// The slider, or that piece [m].
    const QRectF& area() const { return area_; }
    /// Unit of the scales and the readings: "mm" or "um".
    std::string_view lengthUnit() const;
    /// A place on an axis as it is read: "0.1234 mm".
    QString placeText(double at) const;
    /// Of an axis along x or y.
    AxisLabel axisLabel(const QString& name) const;
    /// [rad]; positive: air flows from the outer leading to the inner trailing edge.
    void setSkew(double skew);
    /// The cells of the solver; drawn while they are `shown`.
    void setGrid(const CellGrid& grid);
    const CellGrid& grid() const { return grid_; }
    void setGridShown(bool shown);
    void setTitle(const QString& title);
    QString title() const override { return title_; }
    /// Place and content under the pointer, shown at the right of the title.
    QString reading() const { return reading_.isEmpty() ? resting_ : reading_; }
    /// Said there while the pointer is elsewhere.
    void setRestingReading(const QString& text);

    /// Shows the whole slider, also after the size changes.
    void fit();
    bool isFitted() const { return fitted_; }
    /// The part of the plane that is seen, in m; its top is the smallest y.
    QRectF view() const;
    void zoom(double factor, const QPointF& aboutPixel);
    void pan(const QPointF& byPixels);

    /// Where the plane is drawn, in pixels of this widget.
    QRectF planArea() const;
    QPointF toPixel(const SurfacePoint& point) const;
    SurfacePoint toSlider(const QPointF& pixel) const;
    bool onSlider(const SurfacePoint& point) const;

    void paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours) override;
    double heightOnPaper(double width, const QFont& font) const override;

    QSize sizeHint() const override { return {640, 460}; }
    QSize minimumSizeHint() const override { return {260, 180}; }

signals:
    /// The pointer is over this point of the slider; nothing: it is no longer.
    void pointed(const std::optional<touchdown::SurfacePoint>& point);
    void chosen(const touchdown::SurfacePoint& point);
    void secondChosen(const touchdown::SurfacePoint& point);
    void viewChanged();

protected:
    /// Content of the plan; the painter is in pixels of this widget and cut to the plan area.
    virtual void paintContent(QPainter& painter, const PlotTheme& theme) = 0;
    /// The borders of the cells, if they are shown.
    void paintGrid(QPainter& painter) const;
    /// The content at this point, in parts.
    virtual QStringList readingAt(const SurfacePoint& /*point*/) const { return {}; }
    /// Key of the content, in a column of keyWidth().
    virtual void paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme) = 0;
    virtual double keyWidth() const = 0; // [px]
    /// To be called when keyWidth() may have changed for another reason than size and font.
    void forgetLayout() { laidOutSize_ = {}; }

    void fillMenu(QMenu& menu) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paint(QPainter& painter, const PlotTheme& theme) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    static constexpr double arrowLength = 38.0, arrowOnPaper = 26.0; // of the air flow [px]

    /// Around the slider, for the names of its edges and for the air flow [px].
    struct Margins {
        double left, right, ends; // ends: above and below together
    };
    Margins margins(const QFont& font, bool above) const;
    /// On paper and in a narrow place the air flow stands above the slider, so that the plan is as wide as can be.
    bool airAbove() const { return paper_ || planArea().width() < narrow; }
    static constexpr double narrow = 600.0; // [px]

    void setArea(const QRectF& area, bool slider);
    void setReading(const QString& text);
    void applyFit();
    void paintSurroundings(QPainter& painter, const PlotTheme& theme) const;
    void paintAirFlow(QPainter& painter, const PlotTheme& theme) const;
    void paintScales(QPainter& painter, const PlotTheme& theme) const;
    void paintHeader(QPainter& painter, const PlotTheme& theme, const PlotFrame& frame) const;

    // planArea() as it was measured: each conversion between places and pixels asks for it.
    mutable QRectF planArea_;
    mutable QSize laidOutSize_;
    mutable QFont laidOutFont_;
    QRectF area_{0.0, 0.0, 1.25e-3, 1.0e-3}; // [m]
    CellGrid grid_;
    bool gridShown_ = false;
    bool slider_ = true; // edges and air are named
    bool paper_ = false; // it is being painted on paper
    double skew_ = 0.0;  // [rad]
    QString title_;
    QString reading_, resting_;
    SurfacePoint centre_; // of the view [m]
    double scale_ = 1e5;  // [px/m]
    bool fitted_ = true;
    std::optional<QPointF> pressedAt_; // [px]
    QPointF draggedTo_;                // [px]
    bool dragged_ = false;
};

} // namespace touchdown
