// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case says about itself, and the choice of its models.
#include <array>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/case/parameter_builders.h"
#include "core/physics/contact/asperity_model.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr std::array modelNames{"springs", "film", "contact"};

std::vector<std::string> contactNames()
{
    std::vector<std::string> names;
    for (const ContactLaw& law : contactLaws()) names.emplace_back(law.name);
    return names;
}

/// Each law with the models in which it acts.
std::string contactMeanings()
{
    std::string help = "Contact and adhesion.";
    for (const ContactLaw& law : contactLaws()) {
        std::string models;
        for (std::size_t i = 0; i < modelNames.size(); ++i)
            if (law.whyNot(static_cast<ModelKind>(i)).empty())
                models += (models.empty() ? " (" : ", ") + std::string(modelNames[i]);
        help += " " + std::string(law.name) + models + "): " + std::string(law.meaning);
    }
    return help + " greenwood-williamson and elastic-plastic are read as asperity with that asperity.model, "
                  "unless asperity.model is given as well. The default is none for a film case and elastic for a "
                  "contact case.";
}

/// The laws of one summit are known by their own names: each stands for "asperity" with that asperity.model.
Parameter contactChoice()
{
    Parameter contact = choice("contact", "contact", contactNames(), at(&Case::contact), always,
                               contactMeanings().c_str(), "paper, section 2 and Fig. 3");
    contact.spellings = {asperityModelNames.begin(), asperityModelNames.end()};
    contact.set = [setLaw = contact.set](Case& c, const ParameterValue& value) {
        const auto model = std::ranges::find(asperityModelNames, std::get<std::string>(value));
        if (model == asperityModelNames.end()) return setLaw(c, value);
        c.contact = ContactKind::Asperity;
        c.asperity.model = static_cast<AsperityModel>(model - asperityModelNames.begin());
    };
    return contact;
}

} // namespace

std::vector<Parameter> descriptionParameters()
{
    return {
        text("title", "title", at(&Case::title), always, "What the case shows, in one line."),
        choice("model", "model", {modelNames.begin(), modelNames.end()}, at(&Case::model), always,
               "Model of the air bearing: springs = two lumped nonlinear springs and dashpots (Ono & Yamane), film = "
               "the generalised Reynolds equation under the slider's surface, contact = no air bearing: a pad moves "
               "towards the disk and back.",
               "the paper's third model, Fig. 9, and its first, section 2"),
        contactChoice(),
        integer("degrees_of_freedom", "degrees of freedom", between(2, 3), at(&Case::degreesOfFreedom), withBearing,
                "Free motions of the slider: 2 = height and pitch, 3 = height, pitch and roll. The springs have 2. A "
                "film case has 3 by default; with 2 the slider keeps its initial roll.",
                "paper, equation (2), and section 4: a huge suspension roll stiffness"),
        text("about.paper", "what the paper saw", at(&Case::about, &About::paper), always,
             "What the paper reports for this case."),
        text("about.watch", "what to watch", at(&Case::about, &About::watch), always,
             "What to look at while the case runs."),
        text("about.assumed", "what is assumed", at(&Case::about, &About::assumed), always,
             "Which values replace values of the paper that are lost."),
    };
}

} // namespace touchdown
