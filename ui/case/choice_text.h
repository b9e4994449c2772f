// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choices of a parameter as people read them: a name and what it means in a sentence.
#pragma once

#include <string_view>

#include <QString>

namespace touchdown {

struct ChoiceText {
    QString name;    // "Runge-Kutta (paper)"; at most 19 characters
    QString meaning; // a sentence
};

/// The texts of the choice that a case file calls `choice` for the parameter `key`: "air.slip", "fukui-kaneko". Both
/// are empty if there is no such choice.
ChoiceText choiceText(std::string_view key, std::string_view choice);

} // namespace touchdown
