// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/model_defaults.h"

namespace touchdown {

bool takeModelDefaults(Case& c, ModelKind before, const std::function<bool(const Parameter&)>& stated)
{
    const Case old = defaultsOf(before), now = defaultsOf(c.model);
    bool changed = false;
    for (const Parameter& parameter : parameters()) {
        const ParameterValue value = parameter.get(now);
        if (parameter.key == "model" || value == parameter.get(old) || stated(parameter)) continue;
        if (parameter.get(c) != parameter.get(old)) continue;
        parameter.set(c, value);
        changed = true;
    }
    return changed;
}

} // namespace touchdown
