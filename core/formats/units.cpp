// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/units.h"

#include "core/formats/decimal.h"
#include "core/formats/quotation.h"
#include "core/formats/words.h"

#include <udunits2.h>

#include <locale.h>

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

namespace touchdown {

namespace {

/// SI value = factor * number + offset. Where the factor is a power of ten the decimal exponent is shifted instead,
/// so that "7 nm" is the double nearest to 7e-9, which 7 * 1e-9 is not.
struct Scale {
    double factor = 1.0;
    double offset = 0.0;
    std::optional<int> decade; // factor = 10^decade
};

/// UDUNITS reads numbers with strtod, so the definitions of its units need the C locale, whatever the process has.
class DecimalPointLocale {
public:
    DecimalPointLocale() : c_(newlocale(LC_ALL_MASK, "C", nullptr)), previous_(uselocale(c_)) {}
    ~DecimalPointLocale()
    {
        uselocale(previous_);
        freelocale(c_);
    }
    DecimalPointLocale(const DecimalPointLocale&) = delete;
    DecimalPointLocale& operator=(const DecimalPointLocale&) = delete;

private:
    locale_t c_;
    locale_t previous_;
};

using Unit = std::unique_ptr<ut_unit, void (*)(ut_unit*)>;

/// The one unit system of the process; UDUNITS itself knows nothing of threads.
class UnitSystem {
public:
    static UnitSystem& instance()
    {
        static UnitSystem system;
        return system;
    }

    bool loaded() const { return system_ != nullptr; }

    /// The scale of a unit that a person wrote; nothing when it is unknown.
    std::optional<Scale> scale(std::string_view name)
    {
        const Guard guard(mutex_);
        const Unit unit = parse(name);
        return unit ? scaleOf(unit.get()) : std::nullopt;
    }
    /// The same for the program's own units, which are few and asked for often.
    std::optional<Scale> ownScale(std::string_view name)
    {
        const Guard guard(mutex_);
        const auto known = own_.find(name);
        if (known != own_.end()) return known->second;
        const Unit unit = parse(name);
        const auto scale = unit ? scaleOf(unit.get()) : std::nullopt;
        if (scale) own_.emplace(name, *scale);
        return scale;
    }
    /// Same dimension? UDUNITS takes the radian for 1, so that an angle may be a ratio of lengths. But 90 Hz are no
    /// angular velocity, as turns may be meant, and 90 rad/s no frequency. (ut_are_convertible also takes reciprocals:
    /// MHz for us.)
    bool sameDimension(std::string_view a, std::string_view b)
    {
        const Guard guard(mutex_);
        const Unit first = parse(a);
        const Unit second = parse(b);
        if (!first || !second) return false;
        const Unit ratio(ut_divide(first.get(), second.get()), ut_free);
        std::array<char, 64> text{};
        if (!ratio || ut_is_dimensionless(ratio.get()) == 0 ||
            ut_format(ratio.get(), text.data(), text.size(), UT_ASCII | UT_DEFINITION) <= 0)
            return false;
        const std::string_view rest = text.data();
        return rest.find("rad") == std::string_view::npos || (b != "rad/s" && b != "Hz");
    }

private:
    struct Guard {
        explicit Guard(std::mutex& mutex) : lock(mutex) {}
        std::lock_guard<std::mutex> lock;
        DecimalPointLocale locale;
    };

    UnitSystem()
    {
        const DecimalPointLocale locale;
        ut_set_error_message_handler(ut_ignore);
        system_ = ut_read_xml(nullptr);
        if (system_ == nullptr) return;
        // The usual short form; UDUNITS has only "degree" and "arc_degree".
        if (const Unit degree = parse("degree")) ut_map_name_to_unit("deg", UT_ASCII, degree.get());
    }
    ~UnitSystem() { ut_free_system(system_); }

    Unit parse(std::string_view name) const
    {
        return {system_ == nullptr ? nullptr : ut_parse(system_, std::string(name).c_str(), UT_UTF8), ut_free};
    }

    static std::optional<Scale> scaleOf(const ut_unit* unit)
    {
        static const ut_visitor visitor{
            [](const ut_unit*, void*) { return UT_SUCCESS; },
            [](const ut_unit*, int, const ut_unit* const*, const int*, void*) { return UT_SUCCESS; },
            [](const ut_unit* self, double factor, const ut_unit* base, double offset, void* result) {
                Scale& scale = *static_cast<Scale*>(result);
                scale.factor = factor;
                if (offset != 0.0) {
                    const std::unique_ptr<cv_converter, void (*)(cv_converter*)> converter(
                        ut_get_converter(const_cast<ut_unit*>(self), const_cast<ut_unit*>(base)), cv_free);
                    if (!converter) return UT_MEANINGLESS;
                    scale.offset = cv_convert_double(converter.get(), 0.0);
                }
                return UT_SUCCESS;
            },
            [](const ut_unit*, const ut_unit*, double, void*) { return UT_MEANINGLESS; },
            [](const ut_unit*, double, const ut_unit*, void*) { return UT_MEANINGLESS; },
        };
        Scale scale;
        if (ut_accept_visitor(unit, &visitor, &scale) != UT_SUCCESS) return std::nullopt;
        const double decade = std::round(std::log10(scale.factor));
        const double rounding = 8.0 * std::numeric_limits<double>::epsilon();
        if (scale.offset == 0.0 && std::abs(decade) < 300.0 &&
            std::abs(scale.factor / std::pow(10.0, decade) - 1.0) < rounding)
            scale.decade = static_cast<int>(decade);
        return scale;
    }

    std::mutex mutex_;
    ut_system* system_ = nullptr;
    std::map<std::string, Scale, std::less<>> own_;
};

/// Fitting units, for a message.
std::string fittingUnits(std::string_view unit)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 13> examples{{
        {"m", "a length such as nm, um or mm"},
        {"kg", "a mass such as mg, g or kg"},
        {"s", "a time such as ns, us or ms"},
        {"N", "a force such as mN, gf or N"},
        {"rad", "an angle such as urad, mrad or deg"},
        {"m/s", "a velocity such as um/s, mm/s or m/s"},
        {"rad/s", "an angular velocity such as rad/s, deg/s or rpm"},
        {"N/m", "a stiffness such as N/m, kN/m or mN/nm"},
        {"Pa", "a pressure such as kPa, MPa or GPa"},
        {"V", "a voltage such as mV or V"},
        {"J", "an energy such as J or zJ"},
        {"1/m^2", "a density such as 1/um^2 or 1/mm^2"},
        {"kg m^2", "a moment of inertia such as kg m^2 or g mm^2"},
    }};
    for (const auto& [key, text] : examples)
        if (key == unit) return std::string(text);
    return "a unit such as " + std::string(unit);
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

/// Whether a text can be the name of a unit. UDUNITS takes more: numbers as factors ("2 m"), origins ("m @ 5", "s since
/// 1970").
bool looksLikeUnit(std::string_view text)
{
    if (text.empty() || text.size() > 64) return false;
    if (text.starts_with("1/")) text.remove_prefix(2); // "1/um^2"
    if (text.empty()) return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isDigit(c)) { // an exponent, after a letter, '^' or ')', perhaps with a sign
            std::size_t k = i;
            while (k > 0 && isDigit(text[k - 1])) --k;
            if (k > 0 && (text[k - 1] == '-' || text[k - 1] == '+')) --k;
            if (k == 0 || !(isLetter(text[k - 1]) || text[k - 1] == '^' || text[k - 1] == ')')) return false;
        } else if (!isLetter(c) && std::string_view(" .*/^-+()%").find(c) == std::string_view::npos) {
            return false;
        }
    }
    return isLetter(text.front()) || text.front() == '%' || text.front() == '(';
}

std::optional<double> toSi(const Scale& scale, std::string_view number)
{
    if (scale.decade) return readDecimal(number, *scale.decade);
    const auto value = readDecimal(number, 0);
    if (!value) return std::nullopt;
    const double result = *value * scale.factor + scale.offset;
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

/// The shortest number that reads back as `value`; nothing when no number of 17 digits does.
std::optional<std::string> exactNumber(double value, const Scale& scale)
{
    if (scale.decade) return decimalText(value, -*scale.decade);
    const double number = (value - scale.offset) / scale.factor;
    for (int digits = 1; digits <= 17; ++digits) {
        std::string text = decimalText(number, 0, digits);
        if (toSi(scale, text) == value) return text;
    }
    for (const double direction : {-1.0, 1.0}) {
        double near = number;
        for (int i = 0; i < 4; ++i) {
            near = std::nextafter(near, direction * std::numeric_limits<double>::infinity());
            if (toSi(scale, decimalText(near)) == value) return decimalText(near);
        }
    }
    return std::nullopt;
}

Scale requiredScale(std::string_view unit)
{
    if (unit.empty()) return {1.0, 0.0, 0};
    UnitSystem& units = UnitSystem::instance();
    if (!units.loaded())
        throw std::runtime_error("the unit database of UDUNITS-2 (package libudunits2-data) is missing");
    const auto scale = units.ownScale(unit);
    assert(scale && "a unit of the program must be known to UDUNITS");
    return scale.value_or(Scale{});
}

} // namespace

std::variant<double, UnitProblem> parseQuantity(std::string_view text, std::string_view unit)
{
    const std::string shown = inQuotes(text);
    std::string_view rest = trimmed(text, blanks);
    if (rest.empty()) return UnitProblem{"is empty; a number is needed"};
    if (rest.size() > 1 && rest.front() == '+' && (isDigit(rest[1]) || rest[1] == '.')) rest.remove_prefix(1);

    double number = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error == std::errc::result_out_of_range) return UnitProblem{shown + " is beyond the range of numbers"};
    if (error != std::errc{}) return UnitProblem{shown + " is not a number"};
    if (!std::isfinite(number)) return UnitProblem{shown + " is not a finite number"};
    const std::string_view numberText = rest.substr(0, static_cast<std::size_t>(end - rest.data()));
    const std::string_view unitText = trimmed(rest.substr(numberText.size()), blanks);

    if (unitText.starts_with(',')) return UnitProblem{shown + " has a comma; write decimals with a point"};
    if (unitText.empty()) {
        if (unit.empty()) return number;
        return UnitProblem{shown + " has no unit; " + fittingUnits(unit) + " is needed"};
    }
    if (unit.empty() && unitText != "%" && unitText != "percent")
        return UnitProblem{shown + " has a unit; a plain number or % is needed"};

    UnitSystem& units = UnitSystem::instance();
    if (!units.loaded())
        return UnitProblem{
            "cannot be read, because the unit database of UDUNITS-2 (package libudunits2-data) is missing"};
    const auto scale = looksLikeUnit(unitText) ? units.scale(unitText) : std::nullopt;
    const std::string needed = unit.empty() ? "a plain number or %" : fittingUnits(unit);
    if (!scale) return UnitProblem{shown + " has an unknown unit; " + needed + " is needed"};
    const bool fits = unit.empty() || units.sameDimension(unitText, unit);
    // Only temperatures have an origin.
    if (!fits || (scale->offset != 0.0 && unit != "K"))
        return UnitProblem{shown + " has the wrong unit; " + needed + " is needed"};

    const auto value = toSi(*scale, numberText);
    if (!value) return UnitProblem{shown + " is beyond the range of numbers"};
    return *value;
}

double unitFactor(std::string_view unit) { return requiredScale(unit).factor; }

std::string formatQuantity(double value, std::string_view displayUnit)
{
    if (displayUnit.empty()) return formatNumber(value);
    if (std::isfinite(value)) {
        if (const auto number = exactNumber(value, requiredScale(displayUnit)))
            return *number + ' ' + std::string(displayUnit);
        return formatNumber(value);
    }
    return formatNumber(value) + ' ' + std::string(displayUnit);
}

std::string formatNumber(double value, std::string_view displayUnit)
{
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    const Scale scale = requiredScale(displayUnit);
    if (const auto number = exactNumber(value, scale)) return *number;
    return decimalText((value - scale.offset) / scale.factor);
}

double roundedTo(double value, int digits)
{
    if (value == 0.0 || !std::isfinite(value)) return value;
    const int place = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
    // Dividing by a power of ten, which is exact, keeps the text short where multiplying by its inverse does not.
    const double scale = std::pow(10.0, std::abs(place));
    return place >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

double roundedIn(double value, std::string_view displayUnit, int digits)
{
    const Scale scale = requiredScale(displayUnit);
    if (!std::isfinite(value)) return value;
    return toSi(scale, decimalText((value - scale.offset) / scale.factor, 0, digits)).value_or(value);
}

std::string fewDigits(double value, std::string_view displayUnit, int digits)
{
    if (displayUnit.empty() || displayUnit == "1") return formatNumber(roundedTo(value, digits));
    return formatNumber(roundedTo(value / unitFactor(displayUnit), digits)) + ' ' + std::string(displayUnit);
}

std::string inNanometres(double length) { return fewDigits(length, "nm", 4); }

std::string fewDigitsOfTime(double seconds, int digits)
{
    const char* unit = seconds >= 1.0 ? "s" : seconds >= 1e-3 ? "ms" : seconds >= 1e-6 ? "us" : "ns";
    return fewDigits(seconds, unit, digits);
}

std::string percent(double share, int digits) { return fewDigits(100.0 * share, "", digits) + " %"; }

} // namespace touchdown
