// SPDX-License-Identifier: GPL-3.0-or-later
//
// The laws of contact, one row each: their names, the models in which they act, their friction and what a run records
// of them. The checks of a case, the choices and help of the key "contact" and the texts of the window come from here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/case/case.h"

namespace touchdown {

/// Why a law cannot act in a model, as half a sentence; empty: it acts.
struct LawRefusal {
    std::string_view springs{}, film{}, contact{};
};

struct ContactLaw {
    std::string_view name{};           // in case files: "ono-yamane"
    std::string_view label{};          // in the window
    std::string_view meaning{};        // one sentence
    LawRefusal refusal{};              // by model
    double (*friction)(const Case&){}; // Coulomb's coefficient [-]
    bool (*adheres)(const Case&){};    // whether it also pulls
    double (*reach)(const Case&){};    // separation up to which it acts; 0 where no length stands for it [m]
    bool remembers = false;            // more of its past than the branch of a characteristic
    bool menisci = false;              // they hold a pad whose asperities do not touch any more
    bool seesDisk = false;             // the heights of the disk's surface, not its mean plane alone
    bool recordsArea = false;          // real area of contact
    bool recordsSurfaces = false;      // acts on cells of the surfaces: peak pressure, smallest gap, maps
    bool recordsFit = false;           // of a pad: the forces of the five parameters that are fitted to it

    /// The refusal of this model.
    std::string_view whyNot(ModelKind model) const;
};

/// In the order of the enumerators (core/case/contact_kind.h).
std::span<const ContactLaw> contactLaws();
const ContactLaw& contactLaw(ContactKind kind);
const ContactLaw& contactLaw(const Case& c);

/// A sentence without the key, where the law of a case cannot act in its model: why not, and which laws can.
std::optional<std::string> contactRefusal(const Case& c);

/// Whether the law of a case acts in its model.
bool contactActs(const Case& c);

/// A case with the law of contact of another, and with the values of all laws.
Case withContactOf(Case c, const Case& other);

/// The five parameters of Ono and Yamane; none where another law acts.
std::optional<OnoYamane> characteristic(const Case& c);
/// The work W of their cycle (core/physics/contact/ono_yamane.h) [J].
std::optional<double> cycleWork(const Case& c);

} // namespace touchdown
