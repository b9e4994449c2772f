// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers, units and symbols as people read and type them in the window. Conversion itself is
// core/formats/units.h; here are the spelling (nm, um -> µm, N m/rad -> N·m/rad), the decimal
// point of the user's locale, and rounding for read-outs.
#pragma once

#include "core/simulation/recording/quantity.h"

#include <QLocale>
#include <QString>

#include <string_view>

namespace touchdown {

/// A unit for reading: "um" -> "µm", "kg m^2" -> "kg·m²".
QString unitText(std::string_view unit);
/// A symbol as rich text: "k_f0" -> k with a subscript, "xi_f" with the Greek letter.
QString symbolText(std::string_view symbol);

/// -0.5 as "−0.5" with a true minus sign, ungrouped, in the notation of the locale.
QString typeset(double value, int decimals, QLocale locale = QLocale());
/// A change: the same with its sign, "+0.5"; "0.0" where it rounds to nothing.
QString typesetChange(double value, int decimals, QLocale locale = QLocale());
/// The number with a true minus sign instead of a hyphen.
QString trueMinus(QString number);

/// A reason as the core writes it ("must be >= 0 kg") as a complete sentence, in the words of the window.
QString sentence(std::string_view reason);

/// A read-out in the display unit, with a true minus sign: "7.000 nm" for 7e-9 with three decimals.
QString readout(double value, std::string_view displayUnit, int decimals = 3, const QLocale& locale = QLocale());
/// A read-out of a recorded quantity with as many decimals as its unit deserves.
QString readout(double value, const Quantity& quantity, const QLocale& locale = QLocale());
/// A number with at most this many digits and its unit; times and small lengths as below.
QString roundedText(double value, std::string_view displayUnit, int digits, const QLocale& locale = QLocale());
/// A status as the core names it, for reading: "cancelled" -> "stopped".
QString statusText(std::string_view status);
/// A force with a fitting prefix and about four figures: "3.577 mN".
QString forceText(double newtons, const QLocale& locale = QLocale());
/// A small length in nm, or in µm from a micrometre on, with at most this many digits: "100 nm", "1.5 µm"; up to
/// three digits are all shown: "5.60 nm".
QString lengthText(double metres, int digits = 6, const QLocale& locale = QLocale());
/// A time with a fitting prefix and about four figures: "1.250 ms".
QString timeText(double seconds, const QLocale& locale = QLocale());
/// A frequency with a fitting prefix: "812.4 kHz".
QString frequencyText(double hertz, const QLocale& locale = QLocale());

} // namespace touchdown
