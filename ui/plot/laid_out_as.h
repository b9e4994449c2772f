// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QFont>
#include <QSizeF>
#include <QWidget>

namespace touchdown {

/// How many times wider than its place a picture is laid out whose texts need `least` pixels of width: its font becomes
/// smaller by as much.
inline double widening(double width, double least) { return std::max(1.0, least / width); }

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
