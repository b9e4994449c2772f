// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers on the disk instead of in memory, for reading.
//
// They are written to a file of their own, which loses its name at once and is mapped into memory. Nobody else can
// change or remove such a file, two windows cannot meet in it, and the system frees its space as soon as the last
// pointer goes, also when the program is killed. The system reads what is used, and drops it again when memory gets
// short. If the disk fails later, so that a page cannot be read back, the system ends the program.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <QString>

namespace touchdown {

/// Writes the parts one after another to a file in `folder` and waits until the disk has them. nullptr if this fails
/// (disk full, no permission), with `problem` set to a sentence; then nothing is left on the disk.
std::shared_ptr<const double[]> toUnnamedFile(const QString& folder, const std::vector<std::span<const double>>& parts,
                                              QString& problem);

/// Whether the mapped numbers are in memory. If not, the system begins to read them.
bool atHand(std::span<const double> mapped);

/// The process holds the pages of the numbers no longer; the system may keep them for the next use.
void letGo(std::span<const double> mapped);

} // namespace touchdown
