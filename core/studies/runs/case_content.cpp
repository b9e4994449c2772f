// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/case_content.h"

#include <cstdint>
#include <variant>

#include "core/case/case.h"
#include "core/case_files/case_text.h"
#include "core/formats/text_file.h"
#include "core/studies/study/item_study.h"

namespace touchdown {

std::string CaseContent::of(const Case& c)
{
    constexpr std::uintmax_t largest = std::uintmax_t{1} << 32; // [byte]
    std::string text = formatCase(c);
    if (c.diskSurface.file.empty()) return text;
    const std::string file = (c.folder / c.diskSurface.file).string();
    const std::lock_guard lock(mutex_);
    const auto [place, isNew] = files_.emplace(file, "");
    if (isNew) {
        const auto content = readTextFile(file, largest, FileContent::Any);
        const auto* held = std::get_if<std::string>(&content);
        place->second = held == nullptr ? file : itemKey(*held);
    }
    return text + place->second;
}

void CaseContent::forget()
{
    const std::lock_guard lock(mutex_);
    files_.clear();
}

} // namespace touchdown
