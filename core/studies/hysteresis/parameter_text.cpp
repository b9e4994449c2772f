// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/parameter_text.h"

#include <cctype>

#include "core/case/fields.h"
#include "core/studies/runs/design_key.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

std::string ParameterText::inSentence() const
{
    std::string text = label;
    if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])))
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

std::string ParameterText::of(double value) const { return fewDigits(value, displayUnit, 4); }

ParameterText parameterText(const DesignKey& key)
{
    ParameterText text{key.key, key.unit, key.displayUnit};
    if (const Field* field = findField(key.key)) {
        text.label = field->label;
        text.label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text.label[0])));
        if (!field->symbol.empty()) text.label += " " + field->symbol;
    }
    return text;
}

} // namespace touchdown
