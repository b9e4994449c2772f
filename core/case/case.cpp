// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case.h"

namespace touchdown {

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;
bool Case::operator==(const Case&) const = default;

} // namespace touchdown
