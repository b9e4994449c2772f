// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QList>
#include <QStackedWidget>

namespace touchdown {

/// The two pages of a result: 0, a text while there is none; 1, its two parts over each other with these heights [px],
/// of which the upper one takes what room there is more.
void addResultPages(QStackedWidget& pages, QLabel& empty, QWidget* upper, QWidget* lower, const QList<int>& heights);

} // namespace touchdown
