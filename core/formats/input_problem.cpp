// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/input_problem.h"

#include "core/formats/quotation.h"

namespace touchdown {

std::string InputProblem::text() const
{
    std::string result = file;
    if (line > 0) result += ':' + std::to_string(line);
    if (!result.empty()) result += ": ";
    if (!key.empty()) result += key + ": ";
    return printable(result + message);
}

} // namespace touchdown
