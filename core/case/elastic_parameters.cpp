// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact and adhesion of surfaces that are given point by point.
#include "core/case/parameter_builders.h"

#include "core/physics/contact/adhesion_kind.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr const char* overcoats = "assumed: carbon overcoats on a glass disk and on a ceramic slider";
constexpr double stiffest = 1e14; // [Pa]

bool withBodies(const Case& c) { return withSurfaces(c) || withAsperities(c); }
/// Between surfaces that deform, or beside the summits of rigid ones.
bool withAttraction(const Case& c) { return withSurfaces(c) || (c.contact == ContactKind::Asperity && contactActs(c)); }
bool withLennardJones(const Case& c) { return withAttraction(c) && c.adhesion.kind == AdhesionKind::LennardJones; }
bool withVanDerWaals(const Case& c) { return withAttraction(c) && c.adhesion.kind == AdhesionKind::VanDerWaals; }
/// The slider finds out by itself where it can touch.
bool withPatchSearch(const Case& c) { return withFilm(c) && withSurfaces(c); }
bool withShift(const Case& c) { return withLennardJones(c) || (withAttraction(c) && c.adhesion.voltage != 0.0); }

} // namespace

std::vector<Parameter> elasticParameters()
{
    return {
        number("elastic.modulus", "disk modulus", "E_1", gigapascals, positive(stiffest),
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::diskModulus), withBodies,
               "Young's modulus of the disk.", overcoats),
        number("elastic.poisson_ratio", "disk Poisson ratio", "nu_1", noUnit, notNegative(0.5),
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::diskPoissonRatio), withBodies,
               "Poisson's ratio of the disk.", overcoats),
        number("elastic.slider_modulus", "slider modulus", "E_2", gigapascals, positive(stiffest),
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::sliderModulus), withBodies,
               "Young's modulus of the slider; the pair deforms as one half-space of 1/E* = (1 - nu_1^2)/E_1 + (1 - "
               "nu_2^2)/E_2.",
               overcoats),
        number("elastic.slider_poisson_ratio", "slider Poisson ratio", "nu_2", noUnit, notNegative(0.5),
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::sliderPoissonRatio), withBodies,
               "Poisson's ratio of the slider.", overcoats),
        number("elastic.hardness", "hardness", "H", gigapascals, notNegative(stiffest),
               at(&Case::elastic, &ElasticCase::hardness), withSurfaces,
               "Largest contact pressure, at which the softer body yields (elastic, perfectly plastic); 0 = the "
               "contact stays elastic.",
               "ours: elastic; Almqvist et al. 2007"),
        number("elastic.friction", "friction coefficient", "mu", noUnit, notNegative(100),
               at(&Case::elastic, &ElasticCase::friction), withSurfaces,
               "Coulomb friction coefficient on the contact force.", "assumed: the paper's value is lost"),
        number("elastic.cell", "cell", "", micrometres, positive(1e-3), at(&Case::elastic, &ElasticCase::cell),
               withSurfaces,
               "Side of a square cell of the contact patch; pad.length and pad.width, if used, must be whole numbers "
               "of cells.",
               "ours"),
        number("elastic.tolerance", "tolerance", "", noUnit, between(1e-14, 1e-2),
               at(&Case::elastic, &ElasticCase::tolerance), withSurfaces,
               "Allowed relative error of the force balance and of the complementarity of pressure and gap. Under a "
               "film, where a run solves many thousand contacts, it is 1e4 times larger, but at most 0.01.",
               "ours"),
        integer("elastic.maximum_iterations", "maximum iterations", between(1, 1000000),
                at(&Case::elastic, &ElasticCase::maximumIterations), withSurfaces,
                "Iterations of one contact solution before it counts as failed.", "ours"),
        boolean("elastic.periodic", "periodic", at(&Case::elastic, &ElasticCase::periodic), withPadSurfaces,
                "Whether the patch and its load repeat periodically in both directions; false = one patch alone on the "
                "half-space.",
                "Stanley & Kato 1997; ours: one patch alone"),
        number("elastic.patch_pitch", "patch pitch", "", microradians, within(0.1),
               at(&Case::elastic, &ElasticCase::patchPitch), withPatchSearch,
               "Pitch at which the program searches the slider's surface for the parts that can touch the disk; a "
               "usual pitch of the slider in contact.",
               "ours: a typical pitch of a flying slider"),
        number("elastic.patch_reach", "patch reach", "", nanometres, positive(1e-6),
               at(&Case::elastic, &ElasticCase::patchReach), withPatchSearch,
               "Height above the slider's lowest point, at elastic.patch_pitch, up to which its surface takes part in "
               "the contact. It must cover the roughness of the disk, the change of tilt and the indentation.",
               "ours"),
        choice(
            "adhesion.kind", "adhesion", {"none", "lennard-jones", "van-der-waals"},
            at(&Case::adhesion, &Adhesion::kind), withAttraction,
            "Intermolecular forces between the surfaces: lennard-jones = shifted so that the forces vanish in "
            "contact, van-der-waals = the classical form with its own repulsion. With contact = \"asperity\" they act "
            "between the mean planes of two rigid surfaces, beside the summits.",
            "paper, section 2: Lennard-Jones; the shifted form is a reading of the paper's reference [8], whose "
            "equations were not available"),
        number("adhesion.surface_energy", "surface energy", "dgamma", millinewtonsPerMetre, notNegative(100),
               at(&Case::adhesion, &Adhesion::surfaceEnergy), withLennardJones,
               "Work of adhesion: the energy per area that is needed to separate the surfaces. It includes the effect "
               "of the lubricant.",
               "assumed: 50 mN/m; 50 to 106 mN/m are reported"),
        number("adhesion.equilibrium_distance", "equilibrium distance", "z_0", nanometres, positive(1e-6),
               at(&Case::adhesion, &Adhesion::equilibriumDistance), withShift,
               "Distance between the molecules of two surfaces in contact; it sets the range of the adhesion.",
               "assumed: 0.3 nm; 0.2 to 0.4 nm are usual"),
        number("adhesion.hamaker_a", "Hamaker constant", "A", {"J", "J"}, notNegative(1e-15),
               at(&Case::adhesion, &Adhesion::hamakerA), withVanDerWaals, "Strength of the attraction -A/(6 pi g^3).",
               "the usual 1e-19 J"),
        number("adhesion.hamaker_b", "repulsion constant", "B", {"J m^6", "J m^6"}, positive(1e-60),
               at(&Case::adhesion, &Adhesion::hamakerB), withVanDerWaals, "Strength of the repulsion B/(45 pi g^9).",
               "the usual 1e-76 J m^6"),
        number("adhesion.voltage", "voltage", "V", {"V", "V"}, within(1000), at(&Case::adhesion, &Adhesion::voltage),
               withAttraction,
               "Voltage between slider and disk; it adds the attraction eps0 V^2/2 over the square of the distance.",
               "ours: none"),
    };
}

} // namespace touchdown
