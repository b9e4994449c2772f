// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values changed on the command line or by a study: "key=value".
#pragma once

#include "core/case/case_document.h"

#include <string>
#include <vector>

namespace touchdown {

/// Applies settings in order. Their problems are added to the document; combinations, the file of a measured disk
/// surface and values without effect are checked again.
void applySettings(CaseDocument& document, const std::vector<std::string>& settings);

} // namespace touchdown
