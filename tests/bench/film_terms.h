// SPDX-License-Identifier: GPL-3.0-or-later
//
// What parts the load of a static film at a fixed attitude, counted in the established program's manner
// (core/studies/convergence/node_film.h), from ours on as many lines: one term after the other is switched, so that the
// changes add up to the whole difference. As the grid is refined both tend to one limit.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

/// Prints a table of a case, or a folder of files of the established program, at its initial attitude; `settings` are
/// key=value as for `touchdown steady --set`. Returns an exit code.
int tellFilmTerms(const std::string& fileOrFolder, const std::vector<std::string>& settings);

} // namespace touchdown
