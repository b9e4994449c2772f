// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a study of forced motion.
#pragma once

#include <string>
#include <vector>

#include "core/studies/response/response_result.h"
#include "core/studies/study/study.h"

namespace touchdown {

std::vector<std::string> responseFindings(const ResponseTask& task, const ResponseResult& result);
StudyReport responseReport(const ResponseTask& task, const ResponseResult& result);

} // namespace touchdown
