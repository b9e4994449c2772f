// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/picture_widget.h"

#include <QContextMenuEvent>

#include "ui/plot/plot_frame.h"

namespace touchdown {

LaidOutAs::LaidOutAs(QWidget& widget, const QSizeF& size, const QFont& font)
    : widget_(widget),
      geometry_(widget.geometry()),
      least_(widget.minimumSize()),
      font_(widget.testAttribute(Qt::WA_SetFont) ? widget.font() : QFont())
{
    widget.installEventFilter(this);
    widget.setFont(font);
    widget.setMinimumSize(0, 0); // which the screen has, not the paper
    widget.resize(size.toSize());
}

LaidOutAs::~LaidOutAs()
{
    widget_.setFont(font_);
    widget_.setMinimumSize(least_);
    widget_.setGeometry(geometry_);
}

bool LaidOutAs::eventFilter(QObject* watched, QEvent* event)
{
    return event->type() == QEvent::Resize && watched->event(event);
}

void PictureWidget::paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme)
{
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    painter.setFont(plotTextFont(font()));
    paint(painter, theme);
    painter.restore();
}

void PictureWidget::paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours)
{
    const double wider = widening(size.width(), textWidth_);
    const LaidOutAs laidOut(*this, wider * size, font);
    painter.save();
    painter.scale(1.0 / wider, 1.0 / wider);
    painter.setFont(font);
    paint(painter, paperTheme(colours));
    painter.restore();
}

double PictureWidget::heightOnPaper(double width, const QFont& /*font*/) const { return shape_ * width; }

void PictureWidget::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) update();
}

void PictureWidget::contextMenuEvent(QContextMenuEvent* event)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    addPictureActions(*menu, *this);
    menu->popup(event->globalPos());
}

void PictureWidget::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter, plotTheme(palette()));
}

} // namespace touchdown
