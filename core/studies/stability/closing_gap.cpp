// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/closing_gap.h"

#include <algorithm>
#include <cmath>

#include "core/formats/units.h"
#include "core/physics/film/film_newton.h"
#include "core/physics/film/slip_model.h"
#include "core/physics/slider/recess.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/studies/stability/stability_curves.h"

namespace touchdown {

namespace {

constexpr double exponent = 0.9;   // s of first order [-]
constexpr double inlet = 100e-9;   // of the wedge [m]
constexpr double finest = 2e-12;   // gap at the first cell's end [m]
constexpr double smallest = 5e-12; // that is shown [m]
constexpr int cells = 160;
constexpr double rowWidth = 1e6; // so far apart that nothing flows across [m]

/// Cells along x that grow from the wedge's edge on, three rows across.
CellGrid wedgeGrid(double angle)
{
    const double length = inlet / angle, first = finest / angle;
    double low = 1.0 + 1e-9, high = 2.0;
    const auto sum = [&](double ratio) { return first * (std::pow(ratio, cells) - 1.0) / (ratio - 1.0); };
    for (int n = 0; n < 60; ++n) (sum(0.5 * (low + high)) < length ? low : high) = 0.5 * (low + high);
    std::vector<double> distance{0.0};
    double width = first;
    for (int i = 0; i < cells; ++i, width *= low) distance.push_back(distance.back() + width);
    CellGrid grid;
    grid.y = {0.0, rowWidth, 2.0 * rowWidth, 3.0 * rowWidth};
    for (int i = cells; i >= 0; --i)
        grid.x.push_back(length * (1.0 - distance[static_cast<std::size_t>(i)] / distance.back()));
    return grid;
}

struct WedgePoint {
    double gap = 0.0, pressure = 0.0; // [m], [Pa]
};

double wedgeAngle(const Case& c)
{
    const Air air = airOf(c.air);
    return air.viscosity * std::abs(c.disk.speed * c.disk.radius) / (exponent * air.meanFreePath * air.pressure);
}

/// From wide to narrow; empty where it could not be solved.
std::vector<WedgePoint> pressuresInWedge(const Case& c, SlipModel model)
{
    FilmSetting setting = filmSetting(c);
    setting.slip.model = model;
    setting.leastGap = 0.0;
    if (!slipLaw(model).knowsAccommodation && model != SlipModel::Combination) setting.slip.accommodation = 1.0;
    const double speed = std::abs(c.disk.speed * c.disk.radius);
    setting.disk = {.speed = speed, .radius = 1.0, .skew = 0.0, .field = VelocityField::Uniform};
    setting.scheme = ConvectionScheme::CompleteFlux;
    AirBearingSurface plane;
    plane.baseRecess = 0.0;
    const double angle = wedgeAngle(c), length = inlet / angle;
    GasFilm film(std::make_shared<const FilmGaps>(Recess(plane, length, 3.0 * rowWidth), wedgeGrid(angle)), setting);
    const FilmGaps& gaps = film.gaps();
    film.setAttitude({0.0, angle, 0.0});
    std::vector<double> p(gaps.pad.size(), film.ambient());
    std::vector<WedgePoint> points;
    if (!FilmNewton(film).solve(p, {.tolerance = 1e-9, .maximumIterations = 200}).converged) return points;
    for (int i = 0; i < cells; ++i) {
        const double gap = angle * (length - gaps.grid.centreX(i));
        if (gap >= smallest) points.push_back({gap, p[gaps.pad.at(i, 1)]});
    }
    return points;
}

double pressureAt(const std::vector<WedgePoint>& points, double gap)
{
    return std::ranges::min_element(points, {},
                                    [&](const WedgePoint& each) { return std::abs(std::log(each.gap / gap)); })
        ->pressure;
}

/// By how much Q jumps at the hard switch of the combination, at a pressure against ambient.
double jumpOfQ(const Case& c, double pressure)
{
    const Air air = airOf(c.air);
    const double knudsen = air.meanFreePath / (pressure * c.air.slip.switchGap);
    return flowFactor({.model = SlipModel::FukuiKaneko}, knudsen) /
           flowFactor({.model = SlipModel::NewSecondOrder, .accommodation = c.air.slip.accommodation}, knudsen);
}

} // namespace

bool addClosingGap(const Case& c, StudyReport& picture, const std::function<bool()>& goOn)
{
    if (c.disk.speed * c.disk.radius == 0.0) return true;
    const double ambient = airOf(c.air).pressure;
    StudyChart chart;
    chart.title = "Pressure in a gap that closes, by slip model";
    chart.caption =
        "An infinitely wide wedge of " + fewDigits(wedgeAngle(c), "") +
        " rad that touches the disk, in the case's air at its disk's speed. With a second-order term the "
        "pressure stays bounded in this wedge; "
        "without one it grows with every refinement of the grid. The angle is our choice: there the pressure of the "
        "first-order model grows as the gap to the power -0.9.";
    ChartPanel& panel = chart.panels.emplace_back();
    panel.x = {.label = "Gap", .unit = "m", .displayUnit = "nm", .logarithmic = true};
    panel.y = {.label = "Pressure", .unit = "Pa", .displayUnit = "kPa", .logarithmic = true};
    StudyTable table{"closing_gap",
                     {{"slip"},
                      {"at_1_nm", "Pa", "kPa", "Pressure at a gap of 1 nm"},
                      {"at_0_1_nm", "Pa", "kPa", "Pressure at 0.1 nm"},
                      {"at_0_01_nm", "Pa", "kPa", "Pressure at 0.01 nm"},
                      {"growth", "", "", "From 0.1 nm to 0.01 nm"}}};
    constexpr double bounded = 1.5; // growth over a decade of gap
    for (std::size_t k = 0; k < slipLaws().size(); ++k) {
        if (goOn && !goOn()) return false;
        const SlipModel model = static_cast<SlipModel>(k);
        const std::string slip(slipLaws()[k].name);
        const std::vector<WedgePoint> points = pressuresInWedge(c, model);
        if (points.empty()) {
            picture.warnings.push_back("The pressure in a closing gap was not found with the slip model " + slip + ".");
            continue;
        }
        ChartSeries& series = panel.series.emplace_back();
        series.name = slip;
        series.markers = false;
        for (const WedgePoint& each : points) series.points.push_back({.x = each.gap, .y = each.pressure});
        const double wide = pressureAt(points, 1e-9), middle = pressureAt(points, 1e-10),
                     narrow = pressureAt(points, 1e-11), growth = narrow / middle;
        table.rows.push_back({slip, wide, middle, narrow, growth});
        if (model != c.air.slip.model) continue;
        const std::string figures = fewDigits(wide / ambient, "") + ", " + fewDigits(middle / ambient, "") + " and " +
                                    fewDigits(narrow / ambient, "") + " times ambient at gaps of 1, 0.1 and 0.01 nm";
        picture.findings.push_back(
            growth > bounded
                ? "Where a gap closes, the case's slip model, " + slip + ", lets the pressure grow without bound: to " +
                      figures +
                      ", in a wedge at its disk's speed. The models with a second-order term keep it bounded there."
                : "Where a gap closes, the case's slip model, " + slip + ", keeps the pressure bounded: at " + figures +
                      ", in a wedge at its disk's speed.");
    }
    if (c.air.slip.model == SlipModel::Combination && c.air.slip.blendWidth == 0.0)
        picture.warnings.push_back("The hard switch of slip at " + fewDigits(c.air.slip.switchGap, "nm") +
                                   " makes the flow factor jump, by a factor of " + fewDigits(jumpOfQ(c, 1.0), "") +
                                   " at ambient pressure, " + fewDigits(jumpOfQ(c, 10.0), "") + " at ten times and " +
                                   fewDigits(jumpOfQ(c, 30.0), "") +
                                   " at thirty times that, and loads with it: air.blend_width blends it.");
    picture.charts.push_back(std::move(chart));
    picture.tables.push_back(std::move(table));
    return true;
}

} // namespace touchdown
