// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/mode_motion.h"

#include <cmath>

#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double farAway = 10.0;    // lengths of the slider
constexpr double nearlyStill = 0.1; // of the largest motion of a corner

std::complex<double> amplitude(const AirBearingMode& mode, std::size_t motion)
{
    return {mode.shape[motion][0], mode.shape[motion][1]};
}

bool isRoll(const AirBearingMode& mode) { return mode.kind == "roll"; }

} // namespace

std::complex<double> motionAt(const AirBearingMode& mode, const SliderCase& slider, double x, double y)
{
    return amplitude(mode, 0) + amplitude(mode, 1) * (0.5 * slider.length - x) -
           amplitude(mode, 2) * (y - 0.5 * slider.width);
}

Attitude changeAt(const AirBearingMode& mode, const SliderCase& slider, double phase)
{
    const std::complex<double> turn = std::polar(1.0, phase);
    const auto now = [&](std::size_t motion) { return (amplitude(mode, motion) * turn).real(); };
    // The attitude's height is that of the trailing edge's centre.
    return {now(0) - 0.5 * slider.length * now(1), now(1), now(2)};
}

std::optional<LeastMotion> leastMotion(const AirBearingMode& mode, const SliderCase& slider)
{
    // |q_height + q s|^2 is least at s = -Re(q_height conj(q)) / |q|^2, with q = q_pitch and s = L/2 - x, or q =
    // -q_roll and s = y - W/2.
    const bool roll = isRoll(mode);
    const std::complex<double> height = amplitude(mode, 0);
    const std::complex<double> angle = roll ? -amplitude(mode, 2) : amplitude(mode, 1);
    const double size = std::norm(angle);
    if (!(size > 0.0)) return std::nullopt;
    const double s = -(height * std::conj(angle)).real() / size;
    if (std::abs(s) > farAway * slider.length) return std::nullopt;
    return LeastMotion{roll ? 0.5 * slider.width + s : 0.5 * slider.length - s, std::abs(height + angle * s)};
}

QString motionWords(const AirBearingMode& mode, const SliderCase& slider)
{
    const auto least = leastMotion(mode, slider);
    if (!least) return tr("moves up and down as a whole");
    const bool roll = isRoll(mode);
    const QString place = QStringLiteral("%1 = %2 mm").arg(roll ? "y" : "x", typeset(least->at / 1e-3, 2));
    QString words = least->motion < nearlyStill
                        ? tr("turns about %1").arg(place)
                        : tr("moves least at %1, by %2 % of the most").arg(place, typeset(100.0 * least->motion, 0));
    if (least->at < 0.0) words += roll ? tr(", beyond the inner edge") : tr(", ahead of the slider");
    if (least->at > (roll ? slider.width : slider.length))
        words += roll ? tr(", beyond the outer edge") : tr(", behind the slider");
    return words;
}

QString kindWord(const AirBearingMode& mode)
{
    if (mode.kind == "vertical") return tr("Vertical");
    if (mode.kind == "pitch") return tr("Pitch");
    if (mode.kind == "roll") return tr("Roll");
    return QString::fromStdString(mode.kind);
}

} // namespace touchdown
