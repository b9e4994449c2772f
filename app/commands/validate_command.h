// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown validate`: every problem of a case, or of a study and its case.
#pragma once

#include "app/terminal/console.h"

namespace touchdown {

int validateCommand(const CaseArguments& arguments, bool json);

} // namespace touchdown
