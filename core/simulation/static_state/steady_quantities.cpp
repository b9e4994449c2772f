// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady_quantities.h"

#include <utility>

namespace touchdown {

namespace {

/// The numbers of a state that are stored as they are, each with its place in `r`, a SteadyResult or a const one.
auto numbersOf(auto& r)
{
    auto& f = r.forces;
    auto& e = r.discretisationError;
    auto& t = r.contact;
    using Number = std::pair<Quantity, decltype(&r.minimumSpacing)>;
    std::vector<Number> numbers{
        {{"nominal_trailing_edge_height", "m", "nm", "Height of the trailing edge's centre, recess 0"},
         &r.attitude.height},
        {{"pitch", "rad", "urad", "Pitch, leading edge up"}, &r.attitude.pitch},
        {{"roll", "rad", "urad", "Roll, inner edge up"}, &r.attitude.roll},
        {{"minimum_spacing", "m", "nm", "Minimum spacing"}, &r.minimumSpacing},
        {{"net_force", "N", "gf", "Force of the air's pressure above ambient"}, &f.net},
        {{"positive_force", "N", "gf", "Its part above ambient"}, &f.positive},
        {{"negative_force", "N", "gf", "Its part below ambient"}, &f.negative},
        {{"pitch_torque", "N m", "uN m", "Torque of the pressure about the slider's centre, nose up"}, &f.pitchTorque},
        {{"roll_torque", "N m", "uN m", "Torque of the pressure about the slider's centre, inner edge up"},
         &f.rollTorque},
        {{"shear_force_x", "N", "mN", "Shear force of the air towards the trailing edge"}, &f.shearX},
        {{"shear_force_y", "N", "mN", "Shear force of the air towards the outer edge"}, &f.shearY},
        {{"shear_pitch_torque", "N m", "uN m", "Torque of the air's shear, nose up"}, &r.shearPitchTorque},
        {{"shear_roll_torque", "N m", "uN m", "Torque of the air's shear, inner edge up"}, &r.shearRollTorque},
        {{"maximum_pressure", "Pa", "kPa", "Highest pressure, absolute"}, &f.maximumPressure},
        {{"minimum_pressure", "Pa", "kPa", "Lowest pressure, absolute"}, &f.minimumPressure},
        {{"mass_flow", "Pa m^3/s", "Pa m^3/s", "Pressure times volume that enters by the outline"}, &f.massFlow},
        {{"minimum_spacing_error", "m", "nm", "Estimated error of the grid in the minimum spacing"}, &e.minimumSpacing},
        {{"pitch_error", "rad", "urad", "Estimated error of the grid in the pitch"}, &e.pitch},
        {{"roll_error", "rad", "urad", "Estimated error of the grid in the roll"}, &e.roll},
        {{"load_error", "N", "gf", "Estimated error of the grid in the load"}, &e.load},
    };
    if (t.state.empty()) return numbers;
    numbers.insert(
        numbers.end(),
        {{{"contact_force", "N", "mN", "Real contact force"}, &t.contact},
         {{"intermolecular_force", "N", "mN", "Adhesion force, of menisci or molecules"}, &t.adhesion},
         {{"friction_force", "N", "mN", "Friction force, in the disk's direction"}, &t.friction},
         {{"contact_pitch_torque", "N m", "uN m", "Torque of contact, adhesion and friction, nose up"}, &t.pitchTorque},
         {{"contact_roll_torque", "N m", "uN m", "Torque of contact, adhesion and friction, inner edge up"},
          &t.rollTorque},
         {{"contact_area", "m^2", "um^2", "Real area of contact; 0 where the law has none"}, &t.area},
         {{"peak_contact_pressure", "Pa", "MPa", "Peak contact pressure; 0 where the law has none"}, &t.peakPressure}});
    return numbers;
}

Quantity ridgesNumber()
{
    return {"unresolved_ridges", "1", "1", "Edges with a ridge narrower than a cell, which the errors count"};
}

} // namespace

std::vector<SteadyQuantity> steadyQuantities(const SteadyResult& result)
{
    std::vector<SteadyQuantity> quantities;
    for (const auto& [quantity, value] : numbersOf(result)) quantities.push_back({quantity, *value});
    quantities.push_back({ridgesNumber(), static_cast<double>(result.unresolvedRidges)});
    return quantities;
}

void setSteadyQuantity(SteadyResult& result, const std::string& name, double value)
{
    for (const auto& [quantity, place] : numbersOf(result))
        if (quantity.name == name) *place = value;
    if (name == ridgesNumber().name && value >= 0.0) result.unresolvedRidges = static_cast<std::size_t>(value);
}

std::vector<SteadyQuantity> seriesQuantities(const SteadySeriesPoint& point)
{
    std::vector<SteadyQuantity> quantities{
        {{"radius", "m", "mm", "Radius of the track"}, point.radius},
        {{"skew", "rad", "deg", "Skew"}, point.skew},
        {{"speed", "rad/s", "rpm", "Speed of the disk"}, point.speed},
    };
    if (point.altitude) quantities.push_back({{"altitude", "m", "m", "Altitude"}, *point.altitude});
    return quantities;
}

Progress progressOf(const SteadyProgress& update)
{
    return {{},
            update.stage,
            {{"iteration", static_cast<double>(update.iteration), "", 10},
             {"residual", update.residual, "", 2},
             {"load error", update.loadError, "", 2},
             {"height", update.attitude.height, "nm", 4},
             {"pitch", update.attitude.pitch, "urad", 4},
             {"roll", update.attitude.roll, "urad", 4}}};
}

} // namespace touchdown
