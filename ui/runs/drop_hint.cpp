// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/drop_hint.h"

#include <algorithm>

#include <QPainter>

#include "ui/plot/plot_export.h"
#include "ui/plot/plot_theme.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int stripLines = 2; // of text, as high as the strip is

} // namespace

DropHint::DropHint(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

QRect DropHint::strip() const
{
    const int high = stripLines * fontMetrics().height();
    const QRect seen = partInView(*parentWidget(), *window());
    return {seen.left(), std::max(seen.top(), seen.bottom() + 1 - high), seen.width(), high};
}

void DropHint::show(const QRect& target, const QString& text, bool refused)
{
    target_ = target;
    text_ = text;
    refused_ = refused;
    setGeometry(parentWidget()->rect());
    raise();
    setVisible(true);
    update();
}

void DropHint::paintEvent(QPaintEvent*)
{
    const PlotTheme theme = plotTheme(palette());
    QPainter painter(this);
    const auto box = [&](const QRect& area, const QColor& colour, const QString& text, bool marked) {
        QColor fill = colour;
        fill.setAlphaF(marked ? 0.15F : 0.05F);
        painter.setPen(QPen(colour, marked ? 2.0 : 1.0, Qt::DashLine));
        painter.setBrush(fill);
        painter.drawRect(area.adjusted(2, 2, -3, -3));
        if (text.isEmpty()) return;
        const QRect room = area.adjusted(12, 4, -12, -4);
        const QRect place = fontMetrics().boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, text);
        painter.fillRect(place.adjusted(-6, -3, 6, 3), theme.plotArea);
        painter.setPen(theme.text);
        painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, text);
    };
    const QColor refusal = meaningColours(palette()).warning;
    const bool atStrip = target_ == strip();
    if (!atStrip) box(strip(), theme.selection, tr("Drop here for a plot of its own"), false);
    if (!target_.isEmpty()) box(target_, refused_ ? refusal : theme.selection, text_, true);
}

} // namespace touchdown
