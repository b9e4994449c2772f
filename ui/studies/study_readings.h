// SPDX-License-Identifier: GPL-3.0-or-later
//
// The object under the pointer of a study's chart, in words.
#pragma once

#include <QString>

#include "ui/studies/study_panel.h"

namespace touchdown {

/// Series and setting, x and y with their errors, how the point came out; the class and the sentence of a cell; the
/// label of a band. In HTML.
QString reading(const StudyPanel& panel, const PanelHit& hit);

} // namespace touchdown
