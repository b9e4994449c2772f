// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever can be saved or copied as a picture.
#pragma once

#include <functional>

#include <QPainter>
#include <QString>

#include "ui/plot/plot_theme.h"

namespace touchdown {

/// Anything that paints itself.
struct Picture {
    QSizeF size; // [px]
    QString title;
    std::function<void(QPainter&)> paint;
};

/// A widget that belongs to the picture of its page.
class PagePart {
public:
    virtual ~PagePart() = default;
    virtual QString title() const = 0;
    /// The whole widget into `target`, in the colours of `theme`. The proportions of the screen stay.
    virtual void paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme) = 0;
};

} // namespace touchdown
