// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air around the slider, its slip at the walls, and the disk that drags it along.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr const char* usualAir = "a usual value of air at 20 C";

/// The disk's motion drags the air along, or a surface that is not flat.
bool withMotion(const Case& c)
{
    return withFilm(c) || (withSurfaces(c) && c.diskSurface.kind != DiskSurfaceKind::Flat &&
                           c.diskSurface.motion == SurfaceMotion::Moving);
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

} // namespace

std::vector<Field> airFields()
{
    return {
        choice(
            {.key = "air.source",
             .label = "air",
             .choices = {"given", "atmosphere", "established-standard"},
             .help =
                 "Where pressure, viscosity and mean free path come from: given, atmosphere = from altitude and "
                 "temperature, established-standard = 101325 Pa, 1.8372e-5 Pa s and 68.6 nm, as the established static "
                 "program has for standard air.",
             .source = "ours: given"},
            at(&Case::air, &AirCase::source), withFilm),
        number({.key = "air.pressure",
                .label = "ambient pressure",
                .symbol = "p_0",
                .unit = "Pa",
                .displayUnit = "kPa",
                .minimum = 0,
                .maximum = 1e8,
                .minimumAllowed = false,
                .help = "Pressure of the air around the slider.",
                .source = "the standard atmosphere at sea level"},
               at(&Case::air, &AirCase::given, &Air::pressure), withGivenAir),
        number({.key = "air.viscosity",
                .label = "viscosity",
                .symbol = "mu",
                .unit = "Pa s",
                .displayUnit = "Pa s",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Dynamic viscosity of the air.",
                .source = usualAir},
               at(&Case::air, &AirCase::given, &Air::viscosity), withGivenAir),
        number({.key = "air.mean_free_path",
                .label = "mean free path",
                .symbol = "lambda",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-3,
                .help = "Mean free path of the air's molecules at the ambient pressure.",
                .source = usualAir},
               at(&Case::air, &AirCase::given, &Air::meanFreePath), withGivenAir),
        number({.key = "air.altitude",
                .label = "altitude",
                .unit = "m",
                .displayUnit = "m",
                .minimum = -1000,
                .maximum = 20000,
                .help = "Height above sea level, which sets the pressure of the standard atmosphere.",
                .source = "ours: sea level"},
               at(&Case::air, &AirCase::altitude), withAltitude),
        number({.key = "air.temperature",
                .label = "temperature",
                .symbol = "T",
                .unit = "K",
                .displayUnit = "K",
                .minimum = 100,
                .maximum = 1000,
                .help = "Temperature of the air, which sets its viscosity and, with the pressure, its mean free path.",
                .source = "25 C; viscosity by Sutherland, mean free path of hard spheres"},
               at(&Case::air, &AirCase::temperature), withTemperature),
        choice({.key = "air.slip",
                .label = "slip model",
                .choices = {"continuum", "first-order", "second-order", "1.5-order", "fukui-kaneko", "fukui-kaneko-fit",
                            "new-first-order", "new-second-order", "combination"},
                .help =
                    "How the rarefied air slips at the walls: continuum = not at all; first-order = Burgdorfer 1959; "
                    "second-order = Hsia & Domoto 1983; 1.5-order = Mitsuya 1993; fukui-kaneko = the kinetic values of "
                    "Fukui & "
                    "Kaneko 1988, 1990; fukui-kaneko-fit = their published fit; new-first-order and new-second-order = "
                    "Wu & Bogy "
                    "2003; combination = fukui-kaneko, and new-second-order below a gap of air.switch_gap.",
                .source = "Fukui & Kaneko 1988, 1990; paper, section 2: the combination"},
               at(&Case::air, &AirCase::slip, &Slip::model), withFilm),
        number({.key = "air.accommodation",
                .label = "accommodation",
                .symbol = "alpha",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Accommodation coefficient of the walls: 1 = all molecules leave them diffusely. The "
                        "second-order and the "
                        "fukui-kaneko models know 1 only.",
                .source = "the usual assumption"},
               at(&Case::air, &AirCase::slip, &Slip::accommodation), withAccommodation),
        number({.key = "air.switch_gap",
                .label = "switch gap",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-6,
                .help = "Gap below which the combination takes the new second-order model.",
                .source = "paper, section 2: 0.3 nm"},
               at(&Case::air, &AirCase::slip, &Slip::switchGap), withCombination),
        number({.key = "air.blend_width",
                .label = "blend width",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-6,
                .help = "Width of the gaps about the switch over which the combination blends its two models; 0 = the "
                        "paper's hard switch.",
                .source = "paper, section 2: a hard switch"},
               at(&Case::air, &AirCase::slip, &Slip::blendWidth), withCombination),
    };
}

std::vector<Field> diskFields()
{
    return {
        number({.key = "disk.speed",
                .label = "disk speed",
                .symbol = "omega",
                .unit = "rad/s",
                .displayUnit = "rpm",
                .minimum = 0,
                .maximum = 1e5,
                .help = "Speed of rotation of the disk.",
                .source = "paper, section 4: 5400 rpm"},
               at(&Case::disk, &DiskMotion::speed), withMotion),
        number({.key = "disk.radius",
                .label = "radius",
                .symbol = "R",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Radius of the track under the slider's centre.",
                .source = "a typical track"},
               at(&Case::disk, &DiskMotion::radius), withMotion),
        number({.key = "disk.skew",
                .label = "skew",
                .symbol = "phi",
                .unit = "rad",
                .displayUnit = "deg",
                .minimum = -1.5,
                .maximum = 1.5,
                .help = "Angle between the slider and the track; positive when air flows from the outer leading to the "
                        "inner trailing edge.",
                .source = "ours: none"},
               at(&Case::disk, &DiskMotion::skew), withMotion),
        choice({.key = "disk.velocity_field",
                .label = "velocity field",
                .choices = {"rotating", "uniform"},
                .help =
                    "Velocity of the disk over the slider: rotating = that of a rotating disk, which differs by a few "
                    "per cent "
                    "and about two degrees from edge to edge; uniform = its value at the slider's centre everywhere.",
                .source = "geometry; the established static program takes the rotating one"},
               at(&Case::disk, &DiskMotion::field), withFilm),
    };
}

} // namespace touchdown
