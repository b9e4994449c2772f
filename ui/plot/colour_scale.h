// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours for values: a map from 0..1 to colours, a monotone scale from values to 0..1, and its key, a bar with
// numbers.
//
// Sequential maps are viridis (van der Walt & Smith 2015) and the upper part of mako (Waskom 2020): their lightness
// rises evenly, and the colour-blind read them as others do. The diverging map has blue and orange of equal lightness
// on either side of a neutral centre, made in Oklab (Ottosson 2020). Its centre is the colour of the paper, so that it
// has a light and a dark form.
#pragma once

#include <array>
#include <vector>

#include <QPainter>
#include <QString>

#include "ui/plot/plot_theme.h"

namespace touchdown {

enum class ColourMap { Viridis, Mako, DivergingOnLight, DivergingOnDark };

/// The colour at 0 to 1; beyond, that of the nearer end.
QColor mapColour(ColourMap map, double position);

/// A number beside a colour bar.
struct ScaleTick {
    double position = 0.0; // 0 to 1
    QString text;
};

/// From value to colour: piecewise linear through knots, in the value or in its logarithm.
class ColourScale {
public:
    /// Evenly from 0 to 1.
    ColourScale() : ColourScale(Kind::Linear, ColourMap::Viridis, {0.0, 1.0}) {}

    /// Evenly from `low` to `high`.
    static ColourScale linear(ColourMap map, double low, double high);
    /// Evenly in the logarithm; both above zero.
    static ColourScale logarithmic(ColourMap map, double low, double high);
    /// Zero in the middle; each side is stretched to its own end, so that a weak side is seen beside a strong one.
    static ColourScale aboutZero(ColourMap map, double low, double high);
    /// The same with each side even in log(1 + |value|/near), `near` > 0: what is weak shows on a side that has
    /// something strong.
    static ColourScale aboutZeroLogarithmic(ColourMap map, double low, double high, double near);
    /// Equal steps of colour between the levels, however far they are apart; ascending, one or more.
    static ColourScale throughLevels(ColourMap map, std::vector<double> levels);

    /// The same values with the colours the other way round.
    ColourScale reversed() const;
    /// The same values with the colours of white paper.
    ColourScale onPaper() const;

    double low() const { return knots_.front(); }
    double high() const { return knots_.back(); }
    /// The values at equal distances on the bar.
    const std::vector<double>& knots() const { return knots_; }
    /// Even in the logarithm of the value itself.
    bool isLogarithmic() const { return kind_ == Kind::Logarithmic; }

    /// Where the value lies on the bar, 0 to 1.
    double position(double value) const;
    QRgb colour(double value) const { return colourAt(position(value)); }
    QRgb colourAt(double position) const;

    /// Numbers in units of `factor` for a bar that has room for `most`.
    std::vector<ScaleTick> ticks(double factor, int most) const;

private:
    enum class Kind { Linear, Logarithmic, AboutZero, AboutZeroLogarithmic, Levels };
    ColourScale(Kind kind, ColourMap map, std::vector<double> knots);
    std::vector<ScaleTick> linearTicks(double from, double to, double factor, int most) const;
    std::vector<ScaleTick> decadeTicks(double end, double factor) const;

    Kind kind_;
    ColourMap map_;
    bool reversed_ = false;
    std::vector<double> knots_; // ascending
    double near_ = 1.0;         // of AboutZeroLogarithmic
    std::array<QRgb, 512> colours_{};
};

/// The column that a bar with these numbers needs beside it [px].
double colourBarWidth(const QFont& font, const std::vector<ScaleTick>& ticks);

/// How many numbers find room along a bar of this height.
int colourBarRoom(const QFont& font, double height);

/// Upright, with its numbers at the right and `title` ("kPa") above it; the lowest value is at the foot unless
/// `downwards`.
void paintColourBar(QPainter& painter, const QRectF& column, const QFont& font, const PlotTheme& theme,
                    const ColourScale& scale, const std::vector<ScaleTick>& ticks, const QString& title,
                    bool downwards = false);

} // namespace touchdown
