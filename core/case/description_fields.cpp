// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case says about itself, and the choice of its models.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

std::vector<Field> descriptionFields()
{
    return {
        text("title", "title", at(&Case::title), always, "What the case shows, in a line."),
        choice("model", "model", {"springs", "film", "contact"}, at(&Case::model), always,
               "Model of the air bearing: springs = two lumped nonlinear springs and dashpots (Ono & Yamane), film = "
               "the generalised Reynolds equation under the slider's surface, contact = none: a pad alone, moved "
               "towards the disk and away from it again.",
               "the paper's third model, Fig. 9, and its first, section 2"),
        choice("contact", "contact", {"none", "ono-yamane", "elastic", "asperity", "multi-asperity"},
               at(&Case::contact), always,
               "Contact and adhesion: none; ono-yamane = the simplified multi-asperity characteristic with menisci; "
               "with the models film and contact, elastic = of surfaces given point by point, with intermolecular "
               "adhesion; and, with the model contact, asperity = of a statistical surface; multi-asperity = the same "
               "with menisci on a pad that yields, the full model of Ono & Yamane. A film case has none where it does "
               "not say otherwise, a contact case elastic.",
               "paper, section 2 and Fig. 3"),
        integer("degrees_of_freedom", "degrees of freedom", between(2, 3), at(&Case::degreesOfFreedom), withBearing,
                "Motions that are free: 2 = height and pitch, 3 = height, pitch and roll. The springs have 2; a film "
                "case has 3 where it does not say 2, which holds the initial roll.",
                "paper, equation (2), and section 4: a huge suspension roll stiffness"),
        text("about.paper", "what the paper saw", at(&Case::about, &About::paper), always,
             "What the paper reports for this case."),
        text("about.watch", "what to watch", at(&Case::about, &About::watch), always,
             "What to look at while the case runs."),
        text("about.assumed", "what is assumed", at(&Case::about, &About::assumed), always,
             "Which values stand in for values of the paper that are lost."),
    };
}

} // namespace touchdown
