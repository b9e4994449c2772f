// SPDX-License-Identifier: GPL-3.0-or-later
//
// Message boxes of a window, and a person who answers them.
#pragma once

#include <QAbstractButton>
#include <QMessageBox>
#include <QtTest>

#include "tests/ui/named_widget.h"

namespace touchdown {

/// The box with this object name; nullptr if it is not open.
inline QMessageBox* question(const QWidget& window, const char* name)
{
    for (QMessageBox* box : window.findChildren<QMessageBox*>(QString::fromLatin1(name)))
        if (box->isVisible()) return box;
    return nullptr;
}

/// Clicks a button of an open box by its text, without "&".
inline void answer(const QWidget& window, const char* name, const QString& text)
{
    QMessageBox* box = question(window, name);
    if (!box) qFatal("no question %s is open", name);
    auto* button = namedWidget<QAbstractButton>(*box, text);
    if (!button) qFatal("the question %s has no button %s", name, qPrintable(text));
    button->click();
}

} // namespace touchdown
