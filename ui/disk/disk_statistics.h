// SPDX-License-Identifier: GPL-3.0-or-later
//
// The statistics of a disk surface as a table: quantity, value of this surface, what was asked for.
#pragma once

#include <vector>

#include <QLocale>
#include <QStringList>

#include "ui/disk/disk_surface_preview.h"

namespace touchdown {

std::vector<QStringList> diskStatistics(const DiskSurfacePreview& preview, const QLocale& locale = QLocale());

/// A length along the track: "128 µm", "1 mm".
QString trackText(double metres, const QLocale& locale = QLocale());

} // namespace touchdown
