// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact of a statistical rough surface, and the menisci on its summits.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr const char* assumed = "assumed: the paper gives the five fitted parameters alone";

bool withYield(const Case& c) { return withAsperities(c) && c.asperity.model == AsperityModel::ElasticPlastic; }
bool withMenisci(const Case& c) { return withContactModel(c) && c.contact == ContactKind::MultiAsperity; }

} // namespace

std::vector<Field> asperityFields()
{
    return {
        choice(
            {.key = "asperity.model",
             .label = "model",
             .choices = {"greenwood-williamson", "elastic-plastic"},
             .help =
                 "Law of one summit: greenwood-williamson = elastic, elastic-plastic = it yields where it is pressed "
                 "far enough.",
             .source = "Greenwood & Williamson 1966; Chang, Etsion & Bogy 1987"},
            at(&Case::asperity, &Asperities::model), withAsperities),
        number({.key = "asperity.radius",
                .label = "summit radius",
                .symbol = "R",
                .unit = "m",
                .displayUnit = "um",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Radius of the summits.",
                .source = assumed},
               at(&Case::asperity, &Asperities::radius), withAsperities),
        number({.key = "asperity.density",
                .label = "summit density",
                .symbol = "eta",
                .unit = "1/m^2",
                .displayUnit = "1/um^2",
                .minimum = 0,
                .maximum = 1e20,
                .minimumAllowed = false,
                .help = "Summits on each area of the nominal surface.",
                .source = assumed},
               at(&Case::asperity, &Asperities::density), withAsperities),
        number({.key = "asperity.height_deviation",
                .label = "height deviation",
                .symbol = "sigma_s",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-3,
                .minimumAllowed = false,
                .help = "Standard deviation of the summits' heights, which are normally distributed.",
                .source = assumed},
               at(&Case::asperity, &Asperities::heightDeviation), withAsperities),
        number({.key = "asperity.plane_height",
                .label = "summit plane",
                .symbol = "y_s",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1e-3,
                .maximum = 1e-3,
                .help =
                    "Height of the summits' mean plane above the mean plane of the disk, from which the separation is "
                    "measured.",
                .source = assumed},
               at(&Case::asperity, &Asperities::planeHeight), withAsperities),
        number({.key = "asperity.yield_strength",
                .label = "yield strength",
                .symbol = "Y",
                .unit = "Pa",
                .displayUnit = "GPa",
                .minimum = 0,
                .maximum = 1e14,
                .minimumAllowed = false,
                .help = "Yield strength of the softer body.",
                .source = assumed},
               at(&Case::asperity, &Asperities::yieldStrength), withYield),
        number({.key = "asperity.friction",
                .label = "friction coefficient",
                .symbol = "mu",
                .minimum = 0,
                .maximum = 100,
                .help = "Coulomb friction coefficient on the contact force.",
                .source = "assumed: the paper's value is lost"},
               at(&Case::asperity, &Asperities::friction), withAsperities),
        number({.key = "meniscus.surface_tension",
                .label = "surface tension",
                .symbol = "gamma",
                .unit = "N/m",
                .displayUnit = "mN/m",
                .minimum = 0,
                .maximum = 10,
                .help = "Surface tension of the lubricant; one meniscus pulls with 2 pi R gamma (1 + cos theta).",
                .source = "assumed: a perfluoropolyether, 25 mN/m"},
               at(&Case::meniscus, &Meniscus::surfaceTension), withMenisci),
        number({.key = "meniscus.contact_angle",
                .label = "contact angle",
                .symbol = "theta",
                .unit = "rad",
                .displayUnit = "deg",
                .minimum = 0,
                .maximum = 1.5707963267948966,
                .help = "Contact angle of the lubricant on both surfaces.",
                .source = "assumed: it wets them"},
               at(&Case::meniscus, &Meniscus::contactAngle), withMenisci),
        number({.key = "meniscus.film_thickness",
                .label = "film thickness",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-6,
                .help = "Thickness of the mobile lubricant: a meniscus forms where a summit comes as near as this.",
                .source = assumed},
               at(&Case::meniscus, &Meniscus::filmThickness), withMenisci),
        number({.key = "meniscus.breaking_length",
                .label = "breaking length",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-6,
                .minimumAllowed = false,
                .help = "Gap at which a meniscus breaks; at least meniscus.film_thickness.",
                .source = assumed},
               at(&Case::meniscus, &Meniscus::breakingLength), withMenisci),
    };
}

} // namespace touchdown
