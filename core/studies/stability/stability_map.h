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
// All references are made before the first cell, so that a cell has its class, which does not change any more, as soon
// as its run ends.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/runs/proven_reference.h"
#include "core/studies/runs/run_class.h"
#include "core/studies/runs/swept_method.h"

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
    bool done = false; // its run has ended, and its class is final
    MeasuredRun run;
    RunVerdict verdict;
    std::optional<CriterionResult> criterion; // where there is a run with a tenth of its step
};

struct StabilityMap {
    std::vector<ProvenReference> references; // one a row
    std::vector<StabilityCell> cells;        // row by row, method by method
};

/// Asked with the share that is done, by expected time, and what is done next; false stops. `soFar`: the map without
/// references, and its cells without their runs, where there is more to show than before.
using MapCallback = std::function<bool(double share, const std::string& doing, const StabilityMap* soFar)>;

/// On up to `jobs` threads, on which the outcome does not depend. Returns false where the callback stopped it.
bool performMap(const StabilityTask& task, int jobs, StabilityMap& map, const MapCallback& callback);

} // namespace touchdown
