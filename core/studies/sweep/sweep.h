// SPDX-License-Identifier: GPL-3.0-or-later
//
// The study "sweep": any values of any case over lists, a grid or samples; what is read off each item stands in one
// table. An item that fails is a row with its reason.
#pragma once

#include "core/studies/study/item_study.h"
#include "core/studies/sweep/sweep_form.h"

namespace touchdown {

class StudyReader;

/// Reads the keys of the sweep; their problems are the reader's.
StudyWork planSweep(StudyReader& reader);

} // namespace touchdown
