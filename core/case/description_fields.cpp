// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case says about itself, and the choice of its models.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

std::vector<Field> descriptionFields()
{
    using enum FieldKind;
    return {
        plain(Text, {.key = "title", .label = "title", .help = "What the case shows, in a line."}, at(&Case::title)),
        choice({.key = "model",
                .label = "model",
                .choices = {"springs", "film", "contact"},
                .help =
                    "Model of the air bearing: springs = two lumped nonlinear springs and dashpots (Ono & Yamane), "
                    "film = the generalised Reynolds equation under the slider's surface, contact = none: a pad alone, "
                    "moved towards the disk and away from it again.",
                .source = "the paper's third model, Fig. 9, and its first, section 2"},
               at(&Case::model)),
        choice(
            {.key = "contact",
             .label = "contact",
             .choices = {"none", "ono-yamane", "elastic", "asperity", "multi-asperity"},
             .help =
                 "Contact and adhesion: none; ono-yamane = the simplified multi-asperity characteristic with menisci; "
                 "with the models film and contact, elastic = of surfaces given point by point, with intermolecular "
                 "adhesion; and, with the model contact, asperity = of a statistical surface; multi-asperity = the "
                 "same with menisci on a pad that "
                 "yields, the full model of Ono & Yamane. A film case has none where it does not say otherwise, a "
                 "contact case elastic.",
             .source = "paper, section 2 and Fig. 3"},
            at(&Case::contact)),
        plain(
            Integer,
            {.key = "degrees_of_freedom",
             .label = "degrees of freedom",
             .minimum = 2,
             .maximum = 3,
             .help =
                 "Motions that are free: 2 = height and pitch, 3 = height, pitch and roll. The springs have 2; a film "
                 "case has 3 where it does not say 2, which holds the initial roll.",
             .source = "paper, equation (2), and section 4: a huge suspension roll stiffness"},
            at(&Case::degreesOfFreedom), withBearing),
        plain(Text,
              {.key = "about.paper", .label = "what the paper saw", .help = "What the paper reports for this case."},
              at(&Case::about, &About::paper)),
        plain(Text, {.key = "about.watch", .label = "what to watch", .help = "What to look at while the case runs."},
              at(&Case::about, &About::watch)),
        plain(Text,
              {.key = "about.assumed",
               .label = "what is assumed",
               .help = "Which values stand in for values of the paper that are lost."},
              at(&Case::about, &About::assumed)),
    };
}

} // namespace touchdown
