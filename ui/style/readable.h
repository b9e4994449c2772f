// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of the core, which are written with the characters of a keyboard, with those of print.
#pragma once

#include <string_view>

#include <QString>

namespace touchdown {

/// "0.5 +- 0.1 um^2, f_m >= -3 mN" as "0.5 ± 0.1 µm², fₘ ≥ −3 mN". Keys of a case, text in quotation marks or
/// backquotes, and subscripts for which there is no character stay as they are.
QString readable(std::string_view text);

} // namespace touchdown
