// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of every method with every setting at every value of a parameter, each classified (run_class.h), and beside that
// the result of the paper's own criterion: does the answer change when the step is ten times shorter, 1e-9 instead of
// 1e-8 s?
//
//   fooled           it does not change, and is not the reference's
//   false alarm      it changes, though it is the reference's with the longer step already
//   right            it does not change and is the reference's, or changes from one that is not
//   not determined   the end of the reference is not determined
//
// The map is a list: the reference of each value, the cells, and the pairs of cells that the criterion compares. A
// thread that needs a reference helps to make it. A part of the list makes the references and the runs of pairs that it
// needs by itself: many parts do this work several times.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/runs/proven_reference.h"
#include "core/studies/runs/run_class.h"
#include "core/studies/runs/swept_method.h"
#include "core/studies/study/item_study.h"

namespace touchdown {

struct Parameter;

/// One value of the parameter.
struct StabilityRow {
    std::string label;  // "5 N/um", as it was given; "" where there is no parameter
    double value = 0.0; // [unit of the parameter]; its number in the list where it is no number
    std::vector<ReferenceCase> references;
    std::vector<SweptMethod> methods; // as many as MethodSpecs, with as many settings
};

struct StabilityTask {
    Case start;
    bool picture = true;
    bool map = true;
    const Parameter* parameter = nullptr; // null: none is varied
    bool parameterIsNumber = false;
    std::vector<MethodSpec> methods;
    std::vector<StabilityRow> rows;
    ClassRule rule;
};

enum class CriterionVerdict : std::uint8_t { Right, Fooled, FalseAlarm, NotDetermined };
inline std::string_view name(CriterionVerdict verdict)
{
    constexpr std::array<std::string_view, 4> names{"right", "fooled", "false alarm", "not determined"};
    static_assert(names.size() == static_cast<std::size_t>(CriterionVerdict::NotDetermined) + 1);
    return names[static_cast<std::size_t>(verdict)];
}

struct CriterionResult {
    std::string finer; // the setting with which it is compared, "1 ns"
    bool endChanges = false;
    double trajectoryChange = 0.0; // the largest [m]
    CriterionVerdict verdict = CriterionVerdict::Right;
};

struct StabilityCell {
    std::size_t row = 0, method = 0, setting = 0;
    bool done = false; // what follows is known
    RunVerdict verdict{};
    std::string end{}; // "flying"
    double steps = 0.0, evaluations = 0.0, switches = 0.0;
    std::optional<CriterionResult> criterion{}; // where there is a run with a tenth of its step
};

/// What is known of a proven reference.
struct StabilityReference {
    bool done = false;
    std::string label{}, other{}, knowledge{};
    double apart = 0.0;              // [m]
    std::optional<double> horizon{}; // [s]
    bool endKnown = false;
};

struct StabilityMap {
    std::vector<StabilityReference> references; // one a row
    std::vector<StabilityCell> cells;           // row by row, method by method
};

/// `reportOf`: of what is known of the map; `whole` where that is all.
ItemStudy stabilityItems(const std::shared_ptr<const StabilityTask>& task,
                         std::function<StudyReport(const StabilityMap&, bool whole)> reportOf);

} // namespace touchdown
