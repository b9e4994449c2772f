// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/marked_slider.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>

#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int steps = 1000;
constexpr int restAfterKeys = 800; // [ms], longer than the first repetition of a key
constexpr int markHeight = 6;      // [px]

} // namespace

MarkedSlider::MarkedSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent)
{
    setRange(0, steps);
    setSingleStep(steps / 100);
    setPageStep(steps / 10);
    rest_.setSingleShot(true);
    rest_.setInterval(restAfterKeys);
    connect(&rest_, &QTimer::timeout, this, &MarkedSlider::settled);
    connect(this, &QSlider::valueChanged, this, [this](int step) {
        emit movedTo(step);
        if (!isSliderDown()) rest_.start();
    });
    connect(this, &QSlider::sliderReleased, this, [this] {
        rest_.stop();
        emit settled();
    });
}

void MarkedSlider::setMark(double share)
{
    mark_ = share;
    update();
}

int MarkedSlider::markedStep() const { return static_cast<int>(std::lround(mark_ * steps)); }

void MarkedSlider::setEnds(const QString& left, const QString& right)
{
    left_ = left;
    right_ = right;
    update();
}

void MarkedSlider::setShare(double share)
{
    if (isSliderDown() || rest_.isActive()) return; // the number follows the slider, with fewer digits
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::lround(share * steps)));
}

double MarkedSlider::share() const { return static_cast<double>(value()) / steps; }

QSize MarkedSlider::sizeHint() const
{
    return {std::max(QSlider::sizeHint().width(), 120), thickness() + markHeight + fontMetrics().height()};
}

int MarkedSlider::thickness() const { return style()->pixelMetric(QStyle::PM_SliderThickness, nullptr, this); }

/// The slider stands above the mark and the texts, for the mouse as well.
void MarkedSlider::initStyleOption(QStyleOptionSlider* option) const
{
    QSlider::initStyleOption(option);
    option->rect.setHeight(thickness());
}

int MarkedSlider::xOf(double share) const
{
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
    return handle / 2 +
           QStyle::sliderPositionFromValue(0, steps, static_cast<int>(std::lround(share * steps)), width() - handle);
}

void MarkedSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QStyleOptionSlider option;
    initStyleOption(&option);
    option.subControls = QStyle::SC_SliderGroove | QStyle::SC_SliderHandle;
    style()->drawComplexControl(QStyle::CC_Slider, &option, &painter, this);

    const MeaningColours colours = meaningColours(palette());
    const int top = thickness();
    const int at = xOf(mark_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.change);
    painter.drawPolygon(QPolygon{{at, top - 2}, {at - 4, top + markHeight - 2}, {at + 4, top + markHeight - 2}});
    painter.setPen(colours.muted);
    const QRect texts(2, top + markHeight - 2, width() - 4, fontMetrics().height());
    painter.drawText(texts, Qt::AlignLeft, left_);
    painter.drawText(texts, Qt::AlignRight, right_);
}

void MarkedSlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

void MarkedSlider::mouseDoubleClickEvent(QMouseEvent* event)
{
    setSliderDown(false);
    setValue(markedStep());
    event->accept();
}

} // namespace touchdown
