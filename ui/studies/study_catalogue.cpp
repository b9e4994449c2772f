// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_catalogue.h"

namespace touchdown {

StudyCatalogue coreStudies()
{
    const std::span<const StudyKind> kinds = studyKinds();
    return {{kinds.begin(), kinds.end()},
            sampleStudies(),
            studyTemplate,
            [](const std::string& kind, const std::string& text, const std::string& name,
               const std::filesystem::path& folder,
               const Case& c) { return parseStudy(kind, text, name, folder, &c); }};
}

} // namespace touchdown
