// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown describe study.sweep.readings`: what can be read off a calculation, by name.
#pragma once

namespace touchdown {

int describeReadings(bool json);

} // namespace touchdown
