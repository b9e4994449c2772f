// SPDX-License-Identifier: GPL-3.0-or-later
//
// The actions of every picture: copy and save the picture and the numbers that it shows.
#pragma once

#include <QMenu>

namespace touchdown {

/// `shown` is a PagePart.
void addPictureActions(QMenu& menu, QWidget& shown);

} // namespace touchdown
