// SPDX-License-Identifier: GPL-3.0-or-later
//
// Widgets as a screen reader finds them.
#pragma once

#include <QWidget>

namespace touchdown {

/// The widget with this accessible name, or this text (without "&"); nullptr if there is none.
template <class Widget>
Widget* namedWidget(const QWidget& parent, const QString& name)
{
    for (Widget* widget : parent.findChildren<Widget*>())
        if (widget->accessibleName() == name || widget->property("text").toString().remove(QLatin1Char('&')) == name)
            return widget;
    return nullptr;
}

} // namespace touchdown
