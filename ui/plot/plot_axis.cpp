// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_axis.h"

#include <algorithm>
#include <cmath>

#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double farBelow = -1e6; // of the axis, for what has no logarithm
constexpr double mostDecades = 14.0;

int decimalsFor(double step) { return std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 12); }

/// A unit with an SI prefix times a power of 1000 as the next unit: "ms", -3 gives "\u00b5s"; empty where there is
/// none.
QString withPrefix(const QString& unit, int exponent)
{
    static const QString prefixes = QStringLiteral("fpn\u00b5m kMG"); // the blank: the unit itself
    static const QStringList bases{"m", "s", "N", "J", "Hz", "rad", "Pa"};
    const QString base = unit.mid(1);
    const qsizetype place = unit.isEmpty() || !bases.contains(base) ? -1 : prefixes.indexOf(unit[0]);
    const qsizetype wanted = place + exponent / 3;
    if (place < 0 || wanted < 0 || wanted >= prefixes.size()) return {};
    return prefixes[wanted] == u' ' ? base : prefixes[wanted] + base;
}

double magnitude(const PlotRange& range) { return std::max(std::abs(range.low), std::abs(range.high)); }

} // namespace

QString powerOfTen(int exponent)
{
    static const QString raised = QStringLiteral("\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079");
    QString text = QStringLiteral("10");
    if (exponent < 0) text += QChar(0x207b);
    for (const QChar digit : QString::number(std::abs(exponent))) text += raised[digit.digitValue()];
    return text;
}

double niceStep(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= value * (1.0 - 1e-9)) return factor * power;
    return 10.0 * power;
}

void PlotAxis::setRange(PlotRange range)
{
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) return;
    if (range.low > range.high) std::swap(range.low, range.high);
    if (logarithmic()) {
        if (range.high <= 0.0) range.high = label.factor;
        range.low = std::max(range.low, range.high * std::pow(10.0, -mostDecades));
        if (range.high < range.low * 1.01) range = {range.low / 1.01, range.high * 1.01};
    } else {
        // Below this, doubles leave fewer than a thousand different positions on the axis.
        const double least = std::max(magnitude(range) * 1e-12, 1e-300);
        if (range.width() < least) {
            const double middle = 0.5 * (range.low + range.high);
            range = {middle - least, middle + least};
        }
    }
    range_ = range;
}

double PlotAxis::position(double value) const
{
    if (!logarithmic()) return (value - range_.low) / range_.width();
    if (!(value > 0.0)) return farBelow;
    return std::log(value / range_.low) / std::log(range_.high / range_.low);
}

double PlotAxis::valueAt(double position) const
{
    if (!logarithmic()) return range_.low + position * range_.width();
    return range_.low * std::pow(range_.high / range_.low, position);
}

PlotRange PlotAxis::part(double from, double to) const { return {valueAt(from), valueAt(to)}; }

PlotAxis::Notation PlotAxis::notation() const
{
    Notation result;
    const double most = magnitude(range_) / label.factor;
    const bool hertz = label.unit.endsWith(QLatin1String("Hz")) && most > 1e3; // "5 MHz", not "5000 kHz"
    if (most >= 1e5 || hertz || (most < 1e-2 && most > 0.0))
        result.exponent = 3 * static_cast<int>(std::floor(std::log10(most) / 3.0 + 1e-12));
    const double unit = label.factor * std::pow(10.0, result.exponent);
    const double width = range_.width() / unit;
    const int digits = static_cast<int>(std::floor(std::log10(std::max(most * label.factor / unit, 1.0)))) + 1;
    if (digits + decimalsFor(niceStep(width / 8.0)) > 7) {
        const double coarse = std::pow(10.0, std::ceil(std::log10(width)));
        result.offset = std::floor(range_.low / unit / coarse) * coarse;
        result.offsetDecimals = decimalsFor(coarse);
    }
    return result;
}

std::vector<AxisTick> PlotAxis::ticks(int most) const
{
    most = std::max(most, 2);
    const double decades = logarithmic() ? std::log10(range_.high / range_.low) : 0.0;
    return decades >= 1.0 ? logarithmicTicks(most, decades) : linearTicks(most);
}

std::vector<AxisTick> PlotAxis::linearTicks(int most) const
{
    const Notation how = logarithmic() ? Notation{} : notation();
    const double unit = label.factor * std::pow(10.0, how.exponent);
    const double low = range_.low / unit;
    const double high = range_.high / unit;
    double step = niceStep((high - low) / most);
    const auto count = [&] { return std::floor(high / step) - std::ceil(low / step) + 1.0; };
    while (count() > most) step = niceStep(step * 1.01);
    if (count() < 2.0) step = niceStep(step * 0.39); // the next finer one: a single number is no scale

    std::vector<AxisTick> ticks;
    const int decimals = decimalsFor(step);
    const double slack = 1e-9 * (high - low);
    for (double n = std::ceil((low - slack) / step); n * step <= high + slack; ++n)
        ticks.push_back({n * step * unit, typeset(n * step - how.offset, decimals), true});
    return ticks;
}

std::vector<AxisTick> PlotAxis::logarithmicTicks(int most, double decades) const
{
    const double low = range_.low / label.factor;
    const double high = range_.high / label.factor;
    const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    // A single number is no scale: more powers of ten than there is good room for, or 3 beside the only one.
    const auto powers = [&](int step) {
        int count = 0;
        for (int exponent = first; exponent <= last; ++exponent)
            count += exponent % step == 0 && std::pow(10.0, exponent) >= low * (1.0 - 1e-9) ? 1 : 0;
        return count;
    };
    int every = std::max(1, static_cast<int>(std::ceil((decades + 1.0) / most)));
    while (every > 1 && powers(every) < 2) --every;
    const bool lonely = powers(every) < 2;
    const bool plain = first >= -2 && last <= 4;

    std::vector<AxisTick> ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
        const double power = std::pow(10.0, exponent);
        const bool major = exponent % every == 0;
        if (power >= low * (1.0 - 1e-9)) {
            const QString text = plain ? typeset(power, std::max(0, -exponent)) : powerOfTen(exponent);
            ticks.push_back({power * label.factor, major ? text : QString(), major});
        }
        for (int digit = 2; digit <= 9 && (lonely || 2.0 * decades <= most); ++digit) {
            if (digit * power < low || digit * power > high) continue;
            const bool roomy = decades < 1.7 && 3 * (decades + 1.0) <= most;
            const bool named = roomy ? digit == 2 || digit == 5 : lonely && digit == 3;
            const QString text = plain ? typeset(digit * power, std::max(0, -exponent))
                                       : QString::number(digit) + QChar(0x00b7) + powerOfTen(exponent);
            ticks.push_back({digit * power * label.factor, named ? text : QString(), named});
        }
    }
    return ticks;
}

QString PlotAxis::text() const
{
    QString text = label.title;
    QString unit = label.unit;
    if (!logarithmic()) {
        const Notation how = notation();
        if (how.offset != 0.0) {
            const QChar sign(how.offset < 0.0 ? u'+' : u'\u2212');
            text += QStringLiteral(" %1 %2").arg(sign).arg(typeset(std::abs(how.offset), how.offsetDecimals));
        }
        if (const QString prefixed = withPrefix(unit, how.exponent); !prefixed.isEmpty())
            unit = prefixed;
        else if (how.exponent != 0)
            unit = unit.isEmpty() ? powerOfTen(how.exponent) : powerOfTen(how.exponent) + u' ' + unit;
    }
    if (unit.isEmpty()) return text;
    return text.isEmpty() ? unit : QStringLiteral("%1 [%2]").arg(text, unit);
}

QString PlotAxis::number(double value) const
{
    const double shown = value / label.factor;
    const double most = std::max(std::abs(shown), magnitude(range_) / label.factor);
    if (shown != 0.0 && (logarithmic() || most >= 1e6 || most < 1e-2)) {
        const int exponent = static_cast<int>(std::floor(std::log10(std::abs(shown))));
        if (exponent >= -2 && exponent < 5) return typeset(shown, std::max(0, 4 - exponent));
        return typeset(shown / std::pow(10.0, exponent), 3) + QChar(0x00b7) + powerOfTen(exponent);
    }
    const double resolution = range_.width() / label.factor / 1000.0;
    return typeset(shown, resolution > 0.0 && resolution < 1.0 ? decimalsFor(resolution) : 0);
}

QString PlotAxis::reading(double value) const
{
    const double shown = value / label.factor;
    const double coarse = range_.width() / label.factor / 1000.0;
    if (logarithmic() || !(coarse > 0.0) || magnitude(range_) / label.factor >= 1e6 || std::abs(shown) < 1e-3 * coarse)
        return number(value);
    const int decimals = coarse < 1.0 ? decimalsFor(coarse) : 0;
    return typeset(shown, std::clamp(decimalsFor(std::abs(shown) / 1000.0), decimals, decimals + 3));
}

PlotRange autoscaled(const PlotRange& data, const PlotRange& current, AxisScale scale, double unit)
{
    if (scale == AxisScale::Logarithmic) {
        const double high = data.high > 0.0 ? std::log10(data.high) : std::log10(unit);
        const double low = std::max(data.low > 0.0 ? std::log10(data.low) : high - 6.0, high - 12.0);
        if (current.low > 0.0) {
            const PlotRange now{std::log10(current.low), std::log10(current.high)};
            if (now.contains(low) && now.contains(high) && high - low > 0.5 * now.width()) return current;
        }
        const double margin = std::max(0.06 * (high - low), 0.15);
        return {std::pow(10.0, low - margin), std::pow(10.0, high + margin)};
    }
    // A width of rounding errors is not worth a picture.
    const double largest = magnitude(data);
    const double width = std::max(data.width(), largest > 0.0 ? 1e-6 * largest : unit);
    const bool fits = current.width() > 0.0 && current.contains(data.low) && current.contains(data.high);
    if (fits && width > 0.55 * current.width()) return current;

    const double middle = 0.5 * (data.low + data.high);
    const PlotRange padded{middle - 0.56 * width, middle + 0.56 * width};
    const double step = niceStep(width / 20.0); // round limits also keep the numbers still while the data grow
    return {std::floor(padded.low / step) * step, std::ceil(padded.high / step) * step};
}

} // namespace touchdown
