// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact and adhesion of surfaces that are given point by point.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr const char* overcoats = "assumed: carbon overcoats on a glass disk and on a ceramic slider";
constexpr double stiffest = 1e14; // [Pa]

bool withBodies(const Case& c) { return withSurfaces(c) || withAsperities(c); }
bool withLennardJones(const Case& c) { return withSurfaces(c) && c.adhesion.kind == AdhesionKind::LennardJones; }
bool withVanDerWaals(const Case& c) { return withSurfaces(c) && c.adhesion.kind == AdhesionKind::VanDerWaals; }
/// The slider finds out by itself where it can touch.
bool withPatchSearch(const Case& c) { return withFilm(c) && withSurfaces(c); }
bool withShift(const Case& c) { return withLennardJones(c) || (withSurfaces(c) && c.adhesion.voltage != 0.0); }

std::vector<Field> bodyFields()
{
    return {
        number({.key = "elastic.modulus",
                .label = "disk modulus",
                .symbol = "E_1",
                .unit = "Pa",
                .displayUnit = "GPa",
                .minimum = 0,
                .maximum = stiffest,
                .minimumAllowed = false,
                .help = "Young's modulus of the disk.",
                .source = overcoats},
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::diskModulus), withBodies),
        number({.key = "elastic.poisson_ratio",
                .label = "disk Poisson ratio",
                .symbol = "nu_1",
                .minimum = 0,
                .maximum = 0.5,
                .help = "Poisson's ratio of the disk.",
                .source = overcoats},
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::diskPoissonRatio), withBodies),
        number({.key = "elastic.slider_modulus",
                .label = "slider modulus",
                .symbol = "E_2",
                .unit = "Pa",
                .displayUnit = "GPa",
                .minimum = 0,
                .maximum = stiffest,
                .minimumAllowed = false,
                .help =
                    "Young's modulus of the slider; the pair deforms as one half-space of 1/E* = (1 - nu_1^2)/E_1 + "
                    "(1 - nu_2^2)/E_2.",
                .source = overcoats},
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::sliderModulus), withBodies),
        number({.key = "elastic.slider_poisson_ratio",
                .label = "slider Poisson ratio",
                .symbol = "nu_2",
                .minimum = 0,
                .maximum = 0.5,
                .help = "Poisson's ratio of the slider.",
                .source = overcoats},
               at(&Case::elastic, &ElasticCase::pair, &ElasticPair::sliderPoissonRatio), withBodies),
        number(
            {.key = "elastic.hardness",
             .label = "hardness",
             .symbol = "H",
             .unit = "Pa",
             .displayUnit = "GPa",
             .minimum = 0,
             .maximum = stiffest,
             .help =
                 "Largest contact pressure, above which the softer body flows (elastic - perfectly plastic); 0 = the "
                 "contact stays elastic.",
             .source = "ours: elastic; Almqvist et al. 2007"},
            at(&Case::elastic, &ElasticCase::hardness), withSurfaces),
        number({.key = "elastic.friction",
                .label = "friction coefficient",
                .symbol = "mu",
                .minimum = 0,
                .maximum = 100,
                .help = "Coulomb friction coefficient on the contact force.",
                .source = "assumed: the paper's value is lost"},
               at(&Case::elastic, &ElasticCase::friction), withSurfaces),
        number({.key = "elastic.cell",
                .label = "cell",
                .unit = "m",
                .displayUnit = "um",
                .minimum = 0,
                .maximum = 1e-3,
                .minimumAllowed = false,
                .help = "Side of a cell of the contact patch, the same along and across; pad.length and pad.width, "
                        "where they are "
                        "used, are whole numbers of cells.",
                .source = "ours"},
               at(&Case::elastic, &ElasticCase::cell), withSurfaces),
        number({.key = "elastic.tolerance",
                .label = "tolerance",
                .minimum = 1e-14,
                .maximum = 1e-2,
                .help = "Error allowed in the balance of forces and in the complementarity of pressure and gap, "
                        "relative; under a "
                        "film, where a run solves many thousand contacts, 1e4 times as much, at most 0.01.",
                .source = "ours"},
               at(&Case::elastic, &ElasticCase::tolerance), withSurfaces),
        plain(FieldKind::Integer,
              {.key = "elastic.maximum_iterations",
               .label = "maximum iterations",
               .minimum = 1,
               .maximum = 1000000,
               .help = "Iterations of one contact solution before it counts as failed.",
               .source = "ours"},
              at(&Case::elastic, &ElasticCase::maximumIterations), withSurfaces),
        plain(
            FieldKind::Boolean,
            {.key = "elastic.periodic",
             .label = "periodic",
             .help =
                 "Whether the patch and its load repeat in both directions for ever, instead of standing alone on the "
                 "half-space.",
             .source = "Stanley & Kato 1997; ours: it stands alone"},
            at(&Case::elastic, &ElasticCase::periodic), withPadSurfaces),
        number({.key = "elastic.patch_pitch",
                .label = "patch pitch",
                .unit = "rad",
                .displayUnit = "urad",
                .minimum = -0.1,
                .maximum = 0.1,
                .help = "Pitch at which the parts of the slider's surface are sought that can touch the disk; a usual "
                        "pitch of "
                        "the slider in contact.",
                .source = "ours: a typical pitch of a flying slider"},
               at(&Case::elastic, &ElasticCase::patchPitch), withPatchSearch),
        number(
            {.key = "elastic.patch_reach",
             .label = "patch reach",
             .unit = "m",
             .displayUnit = "nm",
             .minimum = 0,
             .maximum = 1e-6,
             .minimumAllowed = false,
             .help =
                 "How high above the lowest point of the slider, at elastic.patch_pitch, its surface can still touch: "
                 "what lies higher has no part in the contact. It must cover the disk's roughness and how far the "
                 "slider tilts and is pressed in.",
             .source = "ours"},
            at(&Case::elastic, &ElasticCase::patchReach), withPatchSearch),
    };
}

std::vector<Field> adhesionFields()
{
    return {
        choice(
            {.key = "adhesion.kind",
             .label = "adhesion",
             .choices = {"none", "lennard-jones", "van-der-waals"},
             .help =
                 "Intermolecular forces between the surfaces: lennard-jones = shifted so that they vanish in contact, "
                 "van-der-waals = the classical form with a repulsion of its own.",
             .source =
                 "paper, section 2: Lennard-Jones; the shifted form is a reading of the paper's reference [8], whose "
                 "equations were not available"},
            at(&Case::adhesion, &Adhesion::kind), withSurfaces),
        number({.key = "adhesion.surface_energy",
                .label = "surface energy",
                .symbol = "dgamma",
                .unit = "N/m",
                .displayUnit = "mN/m",
                .minimum = 0,
                .maximum = 100,
                .help =
                    "Work of adhesion: the energy for each area that parting the surfaces takes. The lubricant enters "
                    "through it.",
                .source = "assumed: 50 mN/m; 50 to 106 mN/m are reported"},
               at(&Case::adhesion, &Adhesion::surfaceEnergy), withLennardJones),
        number({.key = "adhesion.equilibrium_distance",
                .label = "equilibrium distance",
                .symbol = "z_0",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-6,
                .minimumAllowed = false,
                .help = "Distance of the molecules of surfaces in contact, which sets the reach of the adhesion.",
                .source = "assumed: 0.3 nm; usual are 0.2 to 0.4 nm"},
               at(&Case::adhesion, &Adhesion::equilibriumDistance), withShift),
        number({.key = "adhesion.hamaker_a",
                .label = "Hamaker constant",
                .symbol = "A",
                .unit = "J",
                .displayUnit = "J",
                .minimum = 0,
                .maximum = 1e-15,
                .help = "Strength of the attraction -A/(6 pi g^3).",
                .source = "the usual 1e-19 J"},
               at(&Case::adhesion, &Adhesion::hamakerA), withVanDerWaals),
        number({.key = "adhesion.hamaker_b",
                .label = "repulsion constant",
                .symbol = "B",
                .unit = "J m^6",
                .displayUnit = "J m^6",
                .minimum = 0,
                .maximum = 1e-60,
                .minimumAllowed = false,
                .help = "Strength of the repulsion B/(45 pi g^9).",
                .source = "the usual 1e-76 J m^6"},
               at(&Case::adhesion, &Adhesion::hamakerB), withVanDerWaals),
        number({.key = "adhesion.voltage",
                .label = "voltage",
                .symbol = "V",
                .unit = "V",
                .displayUnit = "V",
                .minimum = -1000,
                .maximum = 1000,
                .help =
                    "Voltage between slider and disk, whose attraction eps0 V^2/2 over the square of the distance is "
                    "added.",
                .source = "ours: none"},
               at(&Case::adhesion, &Adhesion::voltage), withSurfaces),
    };
}

} // namespace

std::vector<Field> elasticFields()
{
    std::vector<Field> all = bodyFields();
    for (Field& field : adhesionFields()) all.push_back(std::move(field));
    return all;
}

} // namespace touchdown
