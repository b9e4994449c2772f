// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact of a statistical rough surface, and the menisci on its summits.
#include "core/case/contact_kind.h"
#include "core/case/parameter_builders.h"
#include "core/physics/contact/asperity_model.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr const char* assumed = "assumed: the paper gives only the five fitted parameters";

bool withYield(const Case& c) { return withAsperities(c) && c.asperity.model == AsperityModel::ElasticPlastic; }
bool withMenisci(const Case& c) { return c.contact == ContactKind::MultiAsperity && contactActs(c); }

} // namespace

std::vector<Parameter> asperityParameters()
{
    return {
        choice("asperity.model", "model", {asperityModelNames.begin(), asperityModelNames.end()},
               at(&Case::asperity, &Asperities::model), withAsperities,
               "Law of one summit: greenwood-williamson = elastic, elastic-plastic = the summit yields when it is "
               "pressed far enough.",
               "Greenwood & Williamson 1966; Chang, Etsion & Bogy 1987"),
        number("asperity.radius", "summit radius", "R", micrometres, positive(1),
               at(&Case::asperity, &Asperities::radius), withAsperities, "Radius of the summits.", assumed),
        number("asperity.density", "summit density", "eta", {"1/m^2", "1/um^2"}, positive(1e20),
               at(&Case::asperity, &Asperities::density), withAsperities,
               "Number of summits per area of the nominal surface.", assumed),
        number("asperity.height_deviation", "height deviation", "sigma_s", nanometres, between(1e-12, 1e-3),
               at(&Case::asperity, &Asperities::heightDeviation), withAsperities,
               "Standard deviation of the summits' heights, which are normally distributed.", assumed),
        number("asperity.plane_height", "summit plane", "y_s", nanometres, within(1e-3),
               at(&Case::asperity, &Asperities::planeHeight), withAsperities,
               "Height of the summits' mean plane above the mean plane of the disk, from which the separation is "
               "measured.",
               assumed),
        number("asperity.yield_strength", "yield strength", "Y", gigapascals, positive(1e14),
               at(&Case::asperity, &Asperities::yieldStrength), withYield, "Yield strength of the softer body.",
               assumed),
        number("asperity.friction", "friction coefficient", "mu", noUnit, notNegative(100),
               at(&Case::asperity, &Asperities::friction), withAsperities,
               "Coulomb friction coefficient on the contact force.", "assumed: the paper's value is lost"),
        number("meniscus.surface_tension", "surface tension", "gamma", millinewtonsPerMetre, notNegative(10),
               at(&Case::meniscus, &Meniscus::surfaceTension), withMenisci,
               "Surface tension of the lubricant; one meniscus pulls with 2 pi R gamma (1 + cos theta).",
               "assumed: a perfluoropolyether, 25 mN/m"),
        number("meniscus.contact_angle", "contact angle", "theta", degrees, notNegative(1.5707963267948966),
               at(&Case::meniscus, &Meniscus::contactAngle), withMenisci,
               "Contact angle of the lubricant on both surfaces.", "assumed: the lubricant wets both surfaces"),
        number("meniscus.film_thickness", "film thickness", "", nanometres, notNegative(1e-6),
               at(&Case::meniscus, &Meniscus::filmThickness), withMenisci,
               "Thickness of the mobile lubricant; a meniscus forms when the gap at a summit falls to this value.",
               assumed),
        number("meniscus.breaking_length", "breaking length", "", nanometres, positive(1e-6),
               at(&Case::meniscus, &Meniscus::breakingLength), withMenisci,
               "Gap at which a meniscus breaks; at least meniscus.film_thickness.", assumed),
    };
}

} // namespace touchdown
