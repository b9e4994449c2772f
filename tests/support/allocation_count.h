// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts heap allocations of a test program.
#pragma once

#include <atomic>

namespace touchdown::test {

extern std::atomic<long long> allocations;

} // namespace touchdown::test
