// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/phase_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plot/plot_path.h"
#include "ui/plot/plot_widget.h"

namespace touchdown {

namespace {

constexpr PlotRange always{-HUGE_VAL, HUGE_VAL};

bool isDrawn(const PlotCurve& curve) { return curve.visible && curve.data != nullptr && curve.xData != nullptr; }

} // namespace

bool PhasePicture::isFor(const PlotWidget& plot)
{
    if (!plot.isPhasePortrait()) return false;
    const PlotRange window = plot.timeWindow().value_or(always);
    std::size_t samples = 0;
    for (const PlotCurve& curve : plot.curves()) {
        if (!isDrawn(curve)) continue;
        const auto [begin, end] = curve.data->samplesWithin(window.low, window.high);
        samples += end - begin;
    }
    return samples > manySamples;
}

PhasePicture::PhasePicture(const PlotWidget& plot, std::function<void()> arrived)
    : plot_(plot), arrived_(std::move(arrived))
{}

PhasePicture::~PhasePicture() = default;

PhasePicture::Job PhasePicture::jobOf() const
{
    Job job{plot_.xAxis(),
            plot_.yAxis(),
            plot_.timeWindow(),
            plot_.plotArea().size(),
            plot_.devicePixelRatioF(),
            plot_.theme(),
            plot_.hasPaleCurves(),
            {}};
    // The curves to look at are above the pale ones.
    for (const bool pale : {true, false})
        for (const PlotCurve& curve : plot_.curves()) {
            if (!isDrawn(curve) || curve.pale != pale) continue;
            const auto times = curve.data->times()->twin();
            const bool together = curve.xData->times() == curve.data->times();
            job.lines.push_back({curve, curve.data->times(), together ? curve.xData->twin(times) : curve.xData->twin(),
                                 curve.data->twin(times)});
        }
    return job;
}

QImage PhasePicture::draw(const Job& job)
{
    const QRectF area(QPointF(), job.size);
    QImage image((job.size * job.pixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(job.pixelRatio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    std::vector<std::vector<QPointF>> paths;
    for (const Line& line : job.lines) {
        paths.push_back(phasePath(*line.x, *line.y, job.time.value_or(always), job.x, job.y, job.size));
        painter.setPen(pathPen(line.curve, paths.back(), job.size, job.theme, job.wide));
        drawPath(painter, paths.back(), area);
    }
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (const PlotCurve& curve = job.lines[i].curve; curve.arrows && !curve.pale)
            drawArrows(painter, paths[i], area, job.theme.colour(curve.style));
    return image;
}

void PhasePicture::update()
{
    if (!showsOnlyCurvesOf(plot_)) {
        image_ = {};
        drawn_.clear();
    }
    again_ = busy_;
    if (busy_ || plot_.plotArea().isEmpty()) return;
    busy_ = true;
    if (!queue_) queue_ = std::make_unique<TaskQueue>(nullptr);
    auto job = std::make_shared<const Job>(jobOf());
    auto image = std::make_shared<QImage>();
    queue_->post(
        [job, image] {
            *image = draw(*job);
            return QString();
        },
        [this, job, image, generation = generation_](const QString& problem) {
            busy_ = false;
            if (generation == generation_) {
                problem_ = problem;
                image_ = *image;
                x_ = job->x;
                y_ = job->y;
                drawn_.clear();
                for (const Line& line : job->lines) drawn_.push_back({line.curve.xData, line.curve.data, line.times});
                if (!showsOnlyCurvesOf(plot_)) image_ = {};
            }
            arrived_();
            if (again_) update();
        });
}

void PhasePicture::forget()
{
    ++generation_;
    again_ = false;
    problem_.clear();
    image_ = {};
    drawn_.clear();
}

/// The pointers in the image are compared, not followed: a curve may be gone.
bool PhasePicture::showsOnlyCurvesOf(const PlotWidget& plot) const
{
    return std::ranges::all_of(drawn_, [&plot](const auto& drawn) {
        return std::ranges::any_of(plot.curves(), [&drawn](const PlotCurve& curve) {
            return isDrawn(curve) && curve.xData == drawn.x && curve.data == drawn.y &&
                   curve.data->times() == drawn.times.lock();
        });
    });
}

void PhasePicture::paint(QPainter& painter) const
{
    const QRectF area = plot_.plotArea();
    if (!problem_.isEmpty()) {
        painter.setPen(plot_.theme().mutedText);
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap,
                         PlotWidget::tr("The curves could not be drawn: %1").arg(problem_));
    }
    const PlotAxis &x = plot_.xAxis(), &y = plot_.yAxis();
    const bool sameScales = x_.label.scale == x.label.scale && y_.label.scale == y.label.scale;
    if (image_.isNull() || !sameScales) return;
    if (x_.range() == x.range() && y_.range() == y.range() && image_.deviceIndependentSize() == area.size()) {
        painter.drawImage(area.topLeft(), image_);
        return;
    }
    // Where the corners of the area lie in the picture.
    const QRectF parts(QPointF(x_.position(x.range().low), 1.0 - y_.position(y.range().high)),
                       QPointF(x_.position(x.range().high), 1.0 - y_.position(y.range().low)));
    const QSizeF pixels = image_.size();
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, image_,
                      QRectF(parts.left() * pixels.width(), parts.top() * pixels.height(),
                             parts.width() * pixels.width(), parts.height() * pixels.height()));
    painter.restore();
}

} // namespace touchdown
