// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases whose every value is drawn from its range, for round trips. The values need not make sense together.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/case/parameters.h"

namespace touchdown::test {

class RandomCase {
public:
    explicit RandomCase(unsigned seed) : generator_(seed) {}

    /// Changes each value with the given probability.
    void change(Case& c, double probability)
    {
        for (const Parameter& parameter : parameters())
            if (uniform(0.0, 1.0) < probability) parameter.set(c, value(parameter));
    }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }

    ParameterValue value(const Parameter& parameter)
    {
        switch (parameter.kind) {
        case ParameterKind::Number: return number(parameter);
        case ParameterKind::Integer:
            return whole(static_cast<int>(parameter.minimum), static_cast<int>(parameter.maximum));
        case ParameterKind::Choice:
            return parameter
                .choices[static_cast<std::size_t>(whole(0, static_cast<int>(parameter.choices.size()) - 1))];
        case ParameterKind::Boolean: return whole(0, 1) == 1;
        case ParameterKind::Text: return text();
        case ParameterKind::List: {
            std::vector<double> values(
                static_cast<std::size_t>(whole(static_cast<int>(parameter.minimumCount),
                                               static_cast<int>(std::min<std::size_t>(parameter.maximumCount, 7)))));
            for (double& each : values) each = number(parameter);
            return values;
        }
        }
        return {};
    }
    /// Few digits or all of them, over the decades of the range.
    double number(const Parameter& parameter)
    {
        if (parameter.stride > 0) {
            const int most = static_cast<int>(parameter.maximum - parameter.minimum) / parameter.stride;
            return parameter.minimum + parameter.stride * whole(0, most);
        }
        const double low = std::max(parameter.minimum, -1e30);
        const double high = std::min(parameter.maximum, 1e30);
        double value = uniform(-1.0, 1.0) * std::pow(10.0, uniform(-20.0, std::log10(high)));
        if (whole(0, 2) == 0) value = std::stod(std::to_string(whole(1, 99)) + "e" + std::to_string(whole(-15, 3)));
        if (value < low) value = std::abs(value);
        return std::clamp(value, parameter.minimumAllowed ? low : std::nextafter(low, high), high);
    }
    ParameterValue text()
    {
        static const std::string alphabet[] = {"a", "Z",  " ",  "7", "\"", "\\", "'", "#", "=", "[",
                                               "]", "\n", "\t", "µ", "π",  "𝛑",  "{", ".", ","};
        std::string result;
        for (int i = whole(0, 40); i > 0; --i)
            result += alphabet[static_cast<std::size_t>(whole(0, static_cast<int>(std::size(alphabet)) - 1))];
        return result;
    }

    std::mt19937 generator_;
};

/// The first key in which two cases differ; "" when they are the same.
inline std::string firstDifference(const Case& a, const Case& b)
{
    for (const Parameter& parameter : parameters())
        if (parameter.get(a) != parameter.get(b)) return parameter.key;
    return a.surface == b.surface ? std::string() : "abs";
}

} // namespace touchdown::test
