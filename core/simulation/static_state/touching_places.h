// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places at which a slider in contact is in balance (film_balance.h): Newton's method with the stiffnesses of film and
// contact, from an attitude lowered to several separations or from given ones. At each place that is tried
// the contact is as if the slider had come there on one branch: from afar, or out of a contact. A place that no start
// leads to is missed. A start that stays where the slider touches outside the modelled contact is left.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/numerics/small_matrix.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

class FilmBalance;

struct TouchingPlace {
    Vector3 q = Vector3::Zero();
    ContactRegion region = ContactRegion::Pressed;
    ContactBranch branch = ContactBranch::TakeOff; // on which it was found
};
struct TouchingPlaces {
    std::vector<TouchingPlace> found; // each once
    int givenUp = 0;                  // starts from which the film was not solved or Newton's method did not end
    std::string problem;              // of a start that stayed where no contact is modelled
};

/// Out of a contact, from `rest` set down to several separations.
TouchingPlaces touchingPlaces(FilmBalance& balance, const Attitude& rest, const std::function<bool()>& goOn);

/// On one branch, from the starts.
TouchingPlaces touchingPlaces(FilmBalance& balance, const std::vector<Attitude>& starts, ContactBranch branch,
                              const std::function<bool()>& goOn);

} // namespace touchdown
