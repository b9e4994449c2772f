// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QSizeF>
#include <QWidget>

namespace touchdown {

/// Gives a widget another size and font while this lives, to paint it for a figure on paper. The screen shows nothing
/// of it: no event is handled meanwhile.
class LaidOutAs {
public:
    LaidOutAs(QWidget& widget, const QSizeF& size, const QFont& font)
        : widget_(widget),
          geometry_(widget.geometry()),
          font_(widget.testAttribute(Qt::WA_SetFont) ? widget.font() : QFont())
    {
        widget.setFont(font);
        widget.resize(size.toSize());
    }
    ~LaidOutAs()
    {
        widget_.setFont(font_);
        widget_.setGeometry(geometry_);
    }
    LaidOutAs(const LaidOutAs&) = delete;
    LaidOutAs& operator=(const LaidOutAs&) = delete;

private:
    QWidget& widget_;
    const QRect geometry_;
    const QFont font_;
};

} // namespace touchdown
