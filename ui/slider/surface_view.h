// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air bearing surface as it is designed: recess in colours that step through its levels, slopes of the walls, rails
// outlined and numbered, points of interest, the point of minimum spacing.
//
// The colours leave out crown, camber and twist, which would hide the steps of the design; the readout has them.
#pragma once

#include <optional>

#include <QImage>
#include <QTimer>

#include "core/physics/slider/recess.h"
#include "ui/calculation/calculation_controller.h"
#include "ui/plot/colour_scale.h"
#include "ui/slider/outline_layer.h"
#include "ui/slider/plan_marks.h"
#include "ui/slider/slider_plan.h"

namespace touchdown {

/// The recess of a part of a slider as a picture, made beside the window: coarse at first, then pixel by pixel. A new
/// request ends the one before.
class RecessPicture : public CalculationController {
    Q_OBJECT

public:
    explicit RecessPicture(QObject* parent = nullptr) : CalculationController(parent) {}
    ~RecessPicture() override { giveUp(); }

    /// `part` in m, its top the smallest y.
    void request(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels);
    /// Stops the calculation and discards the picture.
    void clear();

    /// The latest picture, the largest y uppermost, and the part that it shows; null before the first.
    const QImage& image() const { return drawn_.image; }
    const QRectF& part() const { return drawn_.part; }

signals:
    /// There is a picture, a finer one, or one of another part.
    void drawn();

protected:
    void deliver() override;

private:
    struct Mail {
        QImage image; // null: nothing new
        QRectF part;
        bool finished = false;
    };

    Mail drawn_;
    Mailbox<Mail> mailbox_{*this};
};

class SurfaceView : public SliderPlan {
    Q_OBJECT

public:
    explicit SurfaceView(QWidget* parent = nullptr);

    /// A surface that cannot be drawn (a rail with two corners, a wall that does not exist) leaves the slider empty.
    /// `passing`: another one follows soon, as in a drag; the numbers of the rails stay where they are.
    void setSurface(const AirBearingSurface& surface, double length, double width, bool passing = false);
    const AirBearingSurface& surface() const { return surface_; }
    /// The point of minimum spacing and the spacing there, as the state prints it; nothing when it is not known.
    void setMinimumSpacing(const std::optional<SurfacePoint>& at, const QString& spacing = {});
    std::optional<SurfacePoint> minimumSpacingAt() const { return minimumAt_; }

    const ColourScale& scale() const { return scale_; }
    /// The corners of all rails, with the walls of the edges that begin there.
    std::function<void(QIODevice&)> dataWriter() const override;
    /// The picture of the recess has its full resolution.
    bool settled() const;

protected:
    void paintContent(QPainter& painter, const PlotTheme& theme) override;
    /// In the place of the colours of the recess, below outlines and marks; false: nothing.
    virtual bool paintTops(QPainter& /*painter*/, const PlotTheme& /*theme*/) const { return false; }
    void paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme) override;
    double keyWidth() const override;
    QStringList readingAt(const SurfacePoint& point) const override;

private:
    void requestPicture();
    QSize wantedPixels() const;
    std::vector<ScaleTick> levelTicks() const;
    void paintRecess(QPainter& painter) const;
    void paintMarks(QPainter& painter, const PlotTheme& theme, TakenRoom& taken) const;
    void paintNumbers(QPainter& painter, const PlotTheme& theme, TakenRoom& taken) const;

    AirBearingSurface surface_;
    std::optional<Recess> recess_;      // with crown, camber and twist
    std::optional<Recess> drawnRecess_; // without
    ColourScale scale_;
    RecessPicture picture_;
    OutlineLayer outlines_;
    QTimer pictureTimer_;
    std::vector<SurfacePoint> numberPoints_;
    bool numbersPass_ = false; // they are of a surface before
    std::optional<std::size_t> pointedRail_;
    std::optional<SurfacePoint> minimumAt_;
    QString minimumSpacing_; // "3.15 nm"
};

} // namespace touchdown
