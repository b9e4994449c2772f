// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_view.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/plot/colour_bar.h"
#include "ui/plot/plot_painter.h"
#include "ui/slider/rail_drawing.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int pictureDelay = 15; // of a view that is being dragged [ms]

bool drawable(const AirBearingSurface& surface)
{
    return std::ranges::all_of(surface.rails, [&surface](const Rail& rail) {
        return rail.points.size() >= 3 && std::ranges::all_of(rail.points, [&surface](const RailPoint& point) {
                   return point.wall >= 0 && static_cast<std::size_t>(point.wall) <= surface.walls.size();
               });
    });
}

} // namespace

SurfaceView::SurfaceView(QWidget* parent) : SliderPlan(parent)
{
    setTitle(tr("Air bearing surface"));
    pictureTimer_.setSingleShot(true);
    connect(&pictureTimer_, &QTimer::timeout, this, &SurfaceView::requestPicture);
    connect(&picture_, &RecessPicture::drawn, this, qOverload<>(&QWidget::update));
    connect(this, &SliderPlan::viewChanged, this, [this] {
        if (!pictureTimer_.isActive()) pictureTimer_.start(pictureDelay);
    });
    connect(this, &SliderPlan::pointed, this, &SurfaceView::readOut);
}

void SurfaceView::setSurface(const AirBearingSurface& surface, double length, double width)
{
    if (recess_ && surface == surface_ && length == sliderLength() && width == sliderWidth()) return;
    surface_ = surface;
    recess_.reset();
    drawnRecess_.reset();
    numberPoints_.clear();
    pointedRail_.reset();
    scale_ = ColourScale::throughLevels(ColourMap::Mako, recessLevels(surface)).reversed();
    if (drawable(surface)) {
        recess_.emplace(surface, length, width);
        AirBearingSurface flat = surface;
        flat.crown = flat.camber = flat.twist = 0.0;
        drawnRecess_.emplace(flat, length, width);
        numberPoints_ = railNumberPoints(surface);
    } else {
        picture_.clear();
    }
    setSlider(length, width);
    if (isFitted()) fit();
    pictureTimer_.start(0);
    update();
}

void SurfaceView::setGrid(const CellGrid& grid)
{
    grid_ = grid;
    update();
}

void SurfaceView::setGridShown(bool shown)
{
    gridShown_ = shown;
    update();
}

void SurfaceView::setMinimumSpacing(const std::optional<SurfacePoint>& at, double spacing)
{
    minimumAt_ = at;
    minimumSpacing_ = spacing;
    update();
}

QSize SurfaceView::wantedPixels() const { return (planArea().size() * devicePixelRatioF()).toSize(); }

bool SurfaceView::settled() const
{
    return !pictureTimer_.isActive() && picture_.image().size() == wantedPixels() && picture_.part() == view();
}

void SurfaceView::requestPicture()
{
    if (drawnRecess_) picture_.request(*drawnRecess_, scale_, view(), wantedPixels());
}

void SurfaceView::readOut(const std::optional<SurfacePoint>& point)
{
    const std::optional<std::size_t> rail = point ? railAt(surface_, *point) : std::nullopt;
    if (rail != pointedRail_) {
        pointedRail_ = rail;
        update();
    }
    if (!point) {
        setReading({});
        return;
    }
    QStringList parts{tr("x %1   y %2").arg(readout(point->x, "mm", 4), readout(point->y, "mm", 4))};
    if (recess_) parts << tr("recess %1").arg(lengthText(recess_->at(point->x, point->y), 4));
    parts << (rail ? tr("rail %1").arg(*rail + 1) : tr("base"));
    setReading(parts.join(QStringLiteral("   ·   ")));
}

std::vector<ScaleTick> SurfaceView::levelTicks() const
{
    std::vector<ScaleTick> ticks;
    for (const double level : scale_.knots()) ticks.push_back({scale_.position(level), lengthText(level)});
    return ticks;
}

double SurfaceView::keyWidth() const { return colourBarWidth(font(), levelTicks()) + 4.0; }

void SurfaceView::paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme)
{
    paintColourBar(painter, column, font(), theme, scale_, levelTicks(), tr("recess"), true);
}

void SurfaceView::paintContent(QPainter& painter, const PlotTheme& theme)
{
    paintRecess(painter);
    if (gridShown_) paintCellGrid(painter, *this, grid_);
    paintRails(painter);
    TakenRoom taken;
    paintMarks(painter, theme, taken);
    paintNumbers(painter, theme, taken);
}

void SurfaceView::paintRecess(QPainter& painter) const
{
    const QRectF slider(toPixel({0.0, sliderWidth()}), toPixel({sliderLength(), 0.0}));
    painter.save();
    painter.setClipRect(slider, Qt::IntersectClip);
    if (!picture_.image().isNull()) {
        const QRectF part = picture_.part();
        const QRectF target(toPixel({part.left(), part.bottom()}), toPixel({part.right(), part.top()}));
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(target, picture_.image());
    } else {
        painter.fillRect(slider, QColor(scale_.colour(surface_.baseRecess)));
    }
    painter.restore();
}

void SurfaceView::paintRails(QPainter& painter) const
{
    for (std::size_t i = 0; i < surface_.rails.size(); ++i) {
        QPolygonF outline;
        for (const RailPoint& point : surface_.rails[i].points) outline << toPixel({point.x, point.y});
        const bool pointed = pointedRail_ == i;
        // Dark on light tops and light on the dark base: one line in each.
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(255, 255, 255, pointed ? 230 : 90), pointed ? 4.0 : 2.4));
        painter.drawPolygon(outline);
        painter.setPen(QPen(QColor(20, 24, 28, pointed ? 255 : 190), pointed ? 1.8 : 1.0));
        painter.drawPolygon(outline);
    }
}

void SurfaceView::paintNumbers(QPainter& painter, const PlotTheme& theme, TakenRoom& taken) const
{
    const double height = QFontMetricsF(painter.font()).height();
    for (std::size_t i = 0; i < numberPoints_.size(); ++i) {
        const QRectF box = railPolygon(surface_.rails[i]).boundingRect();
        const QRectF drawn(toPixel({box.left(), box.bottom()}), toPixel({box.right(), box.top()}));
        if (std::min(drawn.width(), drawn.height()) <= 0.8 * height) continue;
        // Beside its place where a mark stands there, as long as it is still on its rail.
        const double step = 1.3 * height;
        for (const QPointF& aside : {QPointF(), QPointF(0.0, -step), QPointF(0.0, step), QPointF(-step, 0.0),
                                     QPointF(step, 0.0), QPointF(-2.0 * step, 0.0), QPointF(2.0 * step, 0.0)}) {
            const QPointF at = toPixel(numberPoints_[i]) + aside;
            if (!aside.isNull() && railAt(surface_, toSlider(at)) != i) continue;
            if (paintPlanLabel(painter, at, QString::number(i + 1), theme, taken)) break;
        }
    }
}

void SurfaceView::paintMarks(QPainter& painter, const PlotTheme& theme, TakenRoom& taken) const
{
    painter.setFont(plotNumberFont(font()));
    std::vector<PlanMark> marks;
    if (minimumAt_)
        marks.push_back(
            {toPixel(*minimumAt_), PlanMark::Kind::Minimum, tr("min %1").arg(lengthText(minimumSpacing_, 3))});
    for (std::size_t i = 0; i < surface_.pointsOfInterest.size(); ++i)
        marks.push_back({toPixel(surface_.pointsOfInterest[i]), PlanMark::Kind::Interest, tr("P%1").arg(i + 1)});
    paintPlanMarks(painter, marks, theme, taken);
}

} // namespace touchdown
