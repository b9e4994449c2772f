// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of the lesson as HTML, for its pane and for its print.
#pragma once

#include <string>

#include <QColor>
#include <QString>

#include "core/studies/lesson/lesson.h"

namespace touchdown {

/// f_m with a subscript, us as µs, a minus sign; a number stays beside its unit, the key of a parameter is a link to
/// it.
QString lessonHtml(const std::string& text);
/// Paragraphs under a heading; the heading may be empty.
QString lessonBlock(const QString& heading, const std::string& text, const QColor& colour);
/// "fig13a, d_e = 7 nm".
QString lessonSubject(const LessonRun& run);

} // namespace touchdown
