// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QTest>

#include "core/case_files/case_file.h"

namespace touchdown {

inline Case sample(const std::string& name)
{
    const CaseDocument document = openCase(name);
    if (!document.valid()) qFatal("%s", document.problems.front().text().c_str());
    return document.value;
}

} // namespace touchdown
