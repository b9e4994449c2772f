// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_view.h"

#include <algorithm>
#include <utility>

#include <QTextStream>

#include "core/formats/units.h"
#include "ui/plot/plot_frame.h"
#include "ui/slider/rail_drawing.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int pictureDelay = 15; // of a view that is being dragged [ms]
constexpr int coarse = 4;        // pixels of the screen across one of the first picture

bool drawable(const AirBearingSurface& surface)
{
    return std::ranges::all_of(surface.rails, [&surface](const Rail& rail) {
        return rail.points.size() >= 3 && std::ranges::all_of(rail.points, [&surface](const RailPoint& point) {
                   return point.wall >= 0 && static_cast<std::size_t>(point.wall) <= surface.walls.size();
               });
    });
}

/// A null image when stopped.
QImage draw(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels,
            const std::stop_token& stop)
{
    QImage image(pixels, QImage::Format_RGB32);
    double last = 0.0; // most pixels have the recess of the one before
    QRgb colour = scale.colour(last);
    for (int row = 0; row < pixels.height(); ++row) {
        if (stop.stop_requested()) return {};
        const double y = part.bottom() - (row + 0.5) / pixels.height() * part.height();
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int column = 0; column < pixels.width(); ++column) {
            const double value = recess.at(part.left() + (column + 0.5) / pixels.width() * part.width(), y);
            if (value != last) colour = scale.colour(last = value);
            line[column] = colour;
        }
    }
    return image;
}

} // namespace

void RecessPicture::request(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels)
{
    stopAndWait(); // within a row of pixels
    if (part.isEmpty() || pixels.isEmpty()) return;
    begin([this, recess, scale, part, pixels](const std::stop_token& stop) {
        for (const int step : {coarse, 1}) {
            const QSize size((pixels.width() + step - 1) / step, (pixels.height() + step - 1) / step);
            const QImage image = draw(recess, scale, part, size, stop);
            mailbox_.post([&](Mail& mail) {
                if (!image.isNull()) mail = {image, part};
                mail.finished = step == 1;
            });
        }
    });
}

void RecessPicture::clear()
{
    stopAndWait();
    drawn_ = {};
    emit drawn();
}

void RecessPicture::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.finished) end();
    if (mail.image.isNull()) return;
    drawn_ = mail;
    emit drawn();
}

SurfaceView::SurfaceView(QWidget* parent) : SliderPlan(parent)
{
    setTitle(tr("Air bearing surface"));
    pictureTimer_.setSingleShot(true);
    connect(&pictureTimer_, &QTimer::timeout, this, &SurfaceView::requestPicture);
    connect(&picture_, &RecessPicture::drawn, this, qOverload<>(&QWidget::update));
    connect(this, &SliderPlan::viewChanged, this, [this] {
        if (!pictureTimer_.isActive()) pictureTimer_.start(pictureDelay);
    });
    connect(this, &SliderPlan::pointed, this, [this](const std::optional<SurfacePoint>& point) {
        const std::optional<std::size_t> rail = point ? railAt(surface_, *point) : std::nullopt;
        if (rail != std::exchange(pointedRail_, rail)) update();
    });
}

void SurfaceView::setSurface(const AirBearingSurface& surface, double length, double width, bool passing)
{
    const bool same = recess_ && surface == surface_ && length == area().width() && width == area().height();
    if (same && !numbersPass_) return;
    numbersPass_ = passing && surface.rails.size() == surface_.rails.size();
    surface_ = surface;
    recess_.reset();
    drawnRecess_.reset();
    if (!numbersPass_) numberPoints_.clear();
    pointedRail_.reset();
    scale_ = ColourScale::throughLevels(ColourMap::Mako, recessLevels(surface)).reversed();
    forgetLayout();
    if (drawable(surface)) {
        recess_.emplace(surface, length, width);
        AirBearingSurface flat = surface;
        flat.crown = flat.camber = flat.twist = 0.0;
        drawnRecess_.emplace(flat, length, width);
        if (!numbersPass_) numberPoints_ = railNumberPoints(surface);
    } else {
        picture_.clear();
        numberPoints_.clear();
    }
    setSlider(length, width);
    if (isFitted()) fit();
    pictureTimer_.start(0);
    update();
}

void SurfaceView::setMinimumSpacing(const std::optional<SurfacePoint>& at, const QString& spacing)
{
    minimumAt_ = at;
    minimumSpacing_ = spacing;
    update();
}

std::function<void(QIODevice&)> SurfaceView::dataWriter() const
{
    if (surface_.rails.empty()) return {};
    return [rails = surface_.rails](QIODevice& device) {
        QTextStream out(&device);
        const auto number = [](double value) { return QString::fromStdString(formatNumber(value)); };
        out << "rail,corner,x [m],y [m],wall,recess of the rail [m]\n";
        for (std::size_t i = 0; i < rails.size(); ++i)
            for (std::size_t k = 0; k < rails[i].points.size(); ++k) {
                const RailPoint& corner = rails[i].points[k];
                out << i + 1 << ',' << k + 1 << ',' << number(corner.x) << ',' << number(corner.y) << ',' << corner.wall
                    << ',' << number(rails[i].recess[0]) << '\n';
            }
    };
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

QStringList SurfaceView::readingAt(const SurfacePoint& point) const
{
    QStringList parts;
    if (recess_) parts << tr("recess %1").arg(lengthText(recess_->at(point.x, point.y), 4));
    const std::optional<std::size_t> rail = railAt(surface_, point);
    return parts << (rail ? tr("rail %1").arg(*rail + 1) : tr("base"));
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
    if (!paintTops(painter, theme)) paintRecess(painter);
    paintGrid(painter);
    outlines_.paint(painter, *this, surface_.rails);
    if (pointedRail_) paintRailOutline(painter, *this, surface_.rails[*pointedRail_], true);
    TakenRoom taken;
    paintMarks(painter, theme, taken);
    paintNumbers(painter, theme, taken);
}

void SurfaceView::paintRecess(QPainter& painter) const
{
    const QRectF slider(toPixel({0.0, area().bottom()}), toPixel({area().right(), 0.0}));
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
    if (minimumAt_) {
        // Of the surface before, while it is dragged: pale.
        constexpr double pale = 0.45;
        painter.setOpacity(numbersPass_ ? pale : 1.0);
        const QString text = tr("min %1").arg(minimumSpacing_);
        paintPlanMarks(painter, {{toPixel(*minimumAt_), PlanMark::Kind::Minimum, text}}, theme, taken);
        painter.setOpacity(1.0);
    }
    std::vector<PlanMark> marks;
    for (std::size_t i = 0; i < surface_.pointsOfInterest.size(); ++i)
        marks.push_back({toPixel(surface_.pointsOfInterest[i]), PlanMark::Kind::Interest, tr("P%1").arg(i + 1)});
    paintPlanMarks(painter, marks, theme, taken);
}

} // namespace touchdown
