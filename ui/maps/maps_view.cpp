// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/maps_view.h"

#include <algorithm>
#include <utility>

#include "core/case/case.h"
#include "core/simulation/static_state/steady.h"
#include "ui/maps/field_map.h"

namespace touchdown {

namespace {

constexpr double nearAmbient = 1e3; // a logarithmic scale shows a smaller difference from ambient as zero [Pa]

/// The middle of the cell with the smallest gap: the point of minimum spacing itself lies on the border of a rail.
std::optional<SurfacePoint> nearestTheDisk(const SteadyResult& result)
{
    if (result.gap.empty()) return std::nullopt;
    const auto cell = static_cast<int>(std::ranges::min_element(result.gap) - result.gap.begin());
    return SurfacePoint{result.grid.centreX(cell % result.grid.nx()), result.grid.centreY(cell / result.grid.nx())};
}

} // namespace

MapsView::MapsView(QWidget* parent) : FieldsView(parent)
{
    using Colours = MapKind::Colours;
    using Logarithm = MapKind::Logarithm;
    setKinds(
        {{tr("Pressure above ambient"), {"kPa", "atm", "MPa"}, Colours::Signed, Logarithm::Offered, nearAmbient, true},
         {tr("Gap"), {"nm", "um"}, Colours::BrightLow, Logarithm::AtFirst},
         {tr("Recess"), {"nm", "um"}, Colours::Recess}}); // on the pads it is zero: no logarithm
}

void MapsView::setResult(const SteadyResult& result, const SliderCase& slider, double skew, double ambient)
{
    map()->setSlider(slider.length, slider.width);
    map()->setSkew(skew);
    proposeSectionPoint(nearestTheDisk(result));
    std::vector<double> pressure = result.pressure;
    for (double& value : pressure) value -= ambient;
    setFields(result.grid, {std::move(pressure), result.gap, result.recess});
}

void MapsView::clear()
{
    proposeSectionPoint(std::nullopt);
    setFields({}, {});
}

double ambientPressure(const Case& c)
{
    switch (c.air.source) {
    case AirSource::Given: break;
    case AirSource::Atmosphere: return airAt(c.air.altitude, c.air.temperature).pressure;
    case AirSource::EstablishedStandard: return establishedStandardAir.pressure;
    }
    return c.air.given.pressure;
}

} // namespace touchdown
