// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air around the slider, its slip at the walls, and the disk that drags it along.
#include "core/case/parameter_builders.h"

#include "core/formats/words.h"
#include "core/physics/film/slip_model.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr const char* usualAir = "a usual value of air at 20 C";

/// The disk's motion drags the air along, or a surface that is not flat.
bool withMotion(const Case& c)
{
    return withFilm(c) || (withUnevenDisk(c) && c.diskSurface.motion == SurfaceMotion::Moving);
}
bool withGivenAir(const Case& c) { return withFilm(c) && c.air.source == AirSource::Given; }
/// A series over altitudes takes the temperature too.
bool withTemperature(const Case& c)
{
    return withFilm(c) && (c.air.source == AirSource::Atmosphere || !c.steady.altitudes.empty());
}
bool withAltitude(const Case& c) { return withFilm(c) && c.air.source == AirSource::Atmosphere; }
bool withAccommodation(const Case& c) { return withFilm(c) && c.air.slip.model != SlipModel::Continuum; }
bool withCombination(const Case& c) { return withFilm(c) && c.air.slip.model == SlipModel::Combination; }

std::vector<std::string> slipNames(bool (*of)(const SlipLaw&) = [](const SlipLaw&) { return true; })
{
    std::vector<std::string> names;
    for (const SlipLaw& law : slipLaws())
        if (of(law)) names.emplace_back(law.name);
    return names;
}

std::string slipMeanings()
{
    std::string help = "How the rarefied air slips at the walls.";
    for (const SlipLaw& law : slipLaws()) help += " " + std::string(law.name) + ": " + std::string(law.meaning);
    return help;
}

std::string accommodationMeaning()
{
    return "Accommodation coefficient of the walls: 1 = all molecules leave them diffusely. These slip models take 1 "
           "alone: " +
           joined(slipNames([](const SlipLaw& law) { return !law.knowsAccommodation; })) + ".";
}

} // namespace

std::vector<Parameter> airParameters()
{
    return {
        choice("air.source", "air", {"given", "atmosphere", "established-standard"}, at(&Case::air, &AirCase::source),
               withFilm,
               "Source of pressure, viscosity and mean free path: given = the values of this table, atmosphere = from "
               "altitude and temperature, established-standard = 101325 Pa, 1.8372e-5 Pa s and 68.6 nm, the standard "
               "air of the established static program.",
               "ours: given"),
        number("air.pressure", "ambient pressure", "p_0", {"Pa", "kPa"}, between(1, 1e8),
               at(&Case::air, &AirCase::given, &Air::pressure), withGivenAir, "Pressure of the air around the slider.",
               "the standard atmosphere at sea level"),
        number("air.viscosity", "viscosity", "mu", {"Pa s", "Pa s"}, positive(1),
               at(&Case::air, &AirCase::given, &Air::viscosity), withGivenAir, "Dynamic viscosity of the air.",
               usualAir),
        number("air.mean_free_path", "mean free path", "lambda", nanometres, between(1e-12, 1e-3),
               at(&Case::air, &AirCase::given, &Air::meanFreePath), withGivenAir,
               "Mean free path of the air's molecules at the ambient pressure. Air without slip has air.slip = "
               "continuum.",
               usualAir),
        number("air.altitude", "altitude", "", metres, between(-1000, 20000), at(&Case::air, &AirCase::altitude),
               withAltitude, "Height above sea level, which sets the pressure of the standard atmosphere.",
               "ours: sea level"),
        number("air.temperature", "temperature", "T", {"K", "K"}, between(100, 1000),
               at(&Case::air, &AirCase::temperature), withTemperature,
               "Temperature of the air, which sets its viscosity and, with the pressure, its mean free path.",
               "25 C; viscosity by Sutherland, mean free path of hard spheres"),
        choice("air.slip", "slip model", slipNames(), at(&Case::air, &AirCase::slip, &Slip::model), withFilm,
               slipMeanings().c_str(), "Fukui & Kaneko 1988, 1990; paper, section 2: the combination"),
        number("air.accommodation", "accommodation", "alpha", noUnit, positive(1),
               at(&Case::air, &AirCase::slip, &Slip::accommodation), withAccommodation, accommodationMeaning().c_str(),
               "the usual assumption"),
        number("air.switch_gap", "switch gap", "", nanometres, notNegative(1e-6),
               at(&Case::air, &AirCase::slip, &Slip::switchGap), withCombination,
               "Gap below which the combination uses the new second-order model.", "paper, section 2: 0.3 nm"),
        number("air.blend_width", "blend width", "", nanometres, notNegative(1e-6),
               at(&Case::air, &AirCase::slip, &Slip::blendWidth), withCombination,
               "Range of gaps around air.switch_gap over which the combination blends its two models; 0 = the paper's "
               "hard switch.",
               "paper, section 2: a hard switch"),
    };
}

std::vector<Parameter> diskParameters()
{
    return {
        number("disk.speed", "disk speed", "omega", turnsPerMinute, notNegative(1e5),
               at(&Case::disk, &DiskMotion::speed), withMotion, "Speed of rotation of the disk.",
               "paper, section 4: 5400 rpm"),
        number("disk.radius", "radius", "R", millimetres, positive(1), at(&Case::disk, &DiskMotion::radius), withMotion,
               "Radius of the track under the slider's centre.", "a typical track"),
        number("disk.skew", "skew", "phi", degrees, within(1.5), at(&Case::disk, &DiskMotion::skew), withMotion,
               "Angle between the slider and the track; positive when air flows from the outer leading to the inner "
               "trailing edge.",
               "ours: none"),
        choice("disk.velocity_field", "velocity field", {"rotating", "uniform"}, at(&Case::disk, &DiskMotion::field),
               withFilm,
               "Velocity of the disk under the slider: rotating = that of a rotating disk, which differs by a few per "
               "cent and about two degrees from edge to edge; uniform = the value at the slider's centre everywhere.",
               "geometry; the established static program uses the rotating one"),
    };
}

} // namespace touchdown
