// SPDX-License-Identifier: GPL-3.0-or-later
//
// The laws of contact; core/case/contact_law.h describes them. Only for files that name one: a new law compiles these.
#pragma once

#include <cstdint>

namespace touchdown {

enum class ContactKind : std::uint8_t { None, OnoYamane, Elastic, Asperity, MultiAsperity };

} // namespace touchdown
