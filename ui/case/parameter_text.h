// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of a case as people read and type them: in display units, with the decimal point of the user's locale.
#pragma once

#include <string>

#include <QLocale>
#include <QStringList>

namespace touchdown {

struct Case;
struct Parameter;

/// Text for the editor of a parameter: a number in the display unit without the unit, or the text.
QString editorText(const Case& c, const Parameter& parameter, const QLocale& locale = QLocale());
/// Typed text in the form that `setFromText` reads: with the display unit if none was typed, and a decimal point.
std::string entryText(const QString& typed, const Parameter& parameter, const QLocale& locale = QLocale());
/// The value with its unit, or the readable name of a choice, for a sentence: "7 nm", "Ono & Yamane".
QString valueText(const Case& c, const Parameter& parameter, const QLocale& locale = QLocale());

/// The heading of a group of parameters: "Air bearing springs" of "springs".
QString groupTitle(const std::string& name);

/// The changes of core/case/case_difference.h in words: "take-off height 5 nm → 8 nm",
/// "rail 3: recess 0.1 µm → 0.2 µm", "rail 4 added"; points that were moved together are one change:
/// "rail 3, corners 1, 2 moved by 2, 0 µm".
QStringList caseDifference(const Case& before, const Case& after);
/// The same as short names of `after`: "d_e 8 nm", "contact none", "rail 3: recess 0.2 µm", "rail 4 added".
QStringList shortDifference(const Case& before, const Case& after);

} // namespace touchdown
