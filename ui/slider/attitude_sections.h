// SPDX-License-Identifier: GPL-3.0-or-later
//
// A static state in words and numbers, as tables: attitude, spacing, forces, stiffness, sensitivities, other
// equilibria, and how it was obtained. Where the error of the discretisation is estimated, it stands beside the value.
#pragma once

#include <vector>

#include <QLocale>
#include <QString>
#include <QStringList>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

struct AttitudeSection {
    QString title;
    QStringList columns;           // heads of the columns after the first; may be empty
    std::vector<QStringList> rows; // name first
};

/// `c` is the case that was solved.
std::vector<AttitudeSection> attitudeSections(const Case& c, const SteadyResult& result,
                                              const QLocale& locale = QLocale());

/// Tab-separated, for a spreadsheet.
QString sectionsAsText(const std::vector<AttitudeSection>& sections);

/// A value with its error: the digits end where the error begins, "7.03 ± 0.02 nm"; without an error four digits.
QString withError(double value, double error, std::string_view displayUnit, const QLocale& locale = QLocale());

/// The value alone, with the same digits.
QString roundedToError(double value, double error, std::string_view displayUnit, const QLocale& locale = QLocale());
/// Their decimals; of an error > 0 alone, in the unit that is shown.
int decimalsWithError(double value, double error, std::string_view displayUnit);
int decimalsOfError(double error);
/// "+0.31": a change of such a value, without its unit. On one grid it is known better than the value: it has the
/// decimals of the value and up to two more, where it has less than two digits otherwise.
QString changeText(double change, double value, double error, std::string_view displayUnit,
                   const QLocale& locale = QLocale());
/// Four significant digits; large and tiny numbers with three and a power of ten.
QString fourDigits(double value, const QLocale& locale = QLocale());

/// "not converged": numbers of such a result are of the last step of a search; empty of a state that was found.
QString notFoundText(const SteadyResult& result);

/// The outcome in a sentence or two: "Height 7.03 nm, pitch ...", or why there is none.
QString steadyText(const SteadyResult& result, const QLocale& locale = QLocale());

} // namespace touchdown
