// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/outside_path.h"

#include <algorithm>
#include <system_error>

#include "core/formats/quotation.h"

namespace touchdown {

namespace fs = std::filesystem;

bool leadsOutside(const fs::path& folder, const fs::path& name)
{
    std::error_code error;
    const fs::path base = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
    if (error) return true;
    fs::path inside = fs::weakly_canonical(base, error);
    if (error) return true;
    if (!inside.has_filename()) inside = inside.parent_path(); // "a/" is "a"
    const fs::path whole = fs::weakly_canonical(base / name, error);
    if (error) return true;
    return std::ranges::mismatch(inside, whole).in1 != inside.end();
}

std::string outsideProblem(const std::string& name, const std::string& what)
{
    return "names " + inQuotes(name) + ", which lies outside the folder of " + what +
           " and is not read; move it into that folder, or allow it with --allow-paths";
}

} // namespace touchdown
