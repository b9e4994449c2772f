// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/formats/cml_text.h"

namespace touchdown::test {

/// The line that a reader refuses; -1 where it refuses nothing.
inline int refusedLine(const std::function<void()>& action)
{
    try {
        action();
    } catch (const CmlError& error) {
        return error.line();
    }
    return -1;
}

} // namespace touchdown::test
