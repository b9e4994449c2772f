// SPDX-License-Identifier: GPL-3.0-or-later
//
// The actions of every picture: copy and save the picture and the numbers that it shows.
#pragma once

#include <functional>

#include <QIODevice>
#include <QMenu>

namespace touchdown {

/// `shown` is a PagePart. `writeData` writes the numbers as comma-separated values; none: the picture shows no numbers.
void addPictureActions(QMenu& menu, QWidget& shown, const std::function<void(QIODevice&)>& writeData = {});

} // namespace touchdown
