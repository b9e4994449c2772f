// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the cells of a contact patch decide what comes out: one contact state, the closest approach, solved with
// cells each half as large as the last, down to half of what the case asks for.
//
// Of three neighbouring levels f_1, f_2, f_3 with cells h, h/2, h/4: the observed order p = log2((f_2 - f_1)/(f_3 -
// f_2)), the limit f_3 + (f_3 - f_2)/(2^p - 1) (Richardson 1911), and the distance of f_3 from it as its error. Where
// the differences do not shrink with one sign, or faster than with third order, there is none, and the larger of the
// last two differences stands for the error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/simulation/recording/quantity.h"
#include "core/studies/study/item_study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

inline constexpr int fewestLevels = 3;
inline constexpr int mostLevels = 6;
inline constexpr int standardLevels = 4; // the last but one has the cell of the case

struct ConvergenceLevel {
    double cell = 0.0;          // [m]
    long long cells = 0;        // of all patches
    std::vector<double> values; // of ConvergenceStudy::quantities
    long long iterations = 0;
    double seconds = 0.0; // of wall time
    std::string problem;  // a sentence, where there is no solution
    bool solved = true;   // or tried
};

struct ObservedOrder {
    std::optional<double> order; // p [-]; none where the differences do not tell
    double limit = 0.0;          // [unit of the quantity]
    double error = 0.0;          // of the finest level [unit of the quantity]
};
ObservedOrder observedOrder(double coarse, double middle, double fine);

struct ConvergenceStudy {
    StudyStatus status = StudyStatus::Completed;
    std::string message;
    double separation = 0.0;              // of the state [m]
    std::vector<Quantity> quantities;     // contact_force, contact_area, ...
    std::vector<ConvergenceLevel> levels; // from coarse to fine
    std::vector<ObservedOrder> observed;  // one for each quantity, of the three finest levels
};

/// Why a valid case without a film cannot be studied so, in a sentence; "" when it can.
std::string reasonNotToConverge(const Case& c, int levels);

/// An item for each level, from coarse to fine.
ItemStudy convergenceItems(const Case& c, int levels);
/// Of the levels that are there; orders only where all are.
ConvergenceStudy convergenceOf(const Case& c, int levels, const ItemRows& rows);

StudyReport convergenceReport(const ConvergenceStudy& study);

/// Of a contact case as above; of a film case that of film_convergence.h.
StudyWork planConvergence(StudyReader& reader);
StudyForm convergenceForm(const Case& c);

} // namespace touchdown
