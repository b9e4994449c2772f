// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is read from results files and maps, for core/formats/passed_values.h.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <type_traits>

#include "core/formats/passed_values.h"
#include "core/formats/reader_process.h"
#include "core/results/results_reader.h"
#include "core/results/steady_reader.h"

namespace touchdown {

void pass(auto& stream, Passed<Quantity> auto& quantity)
{
    stream(quantity.name, quantity.unit, quantity.displayUnit, quantity.longName);
}

void pass(auto& stream, Passed<CellGrid> auto& grid) { stream(grid.x, grid.y); }

void pass(auto& stream, Passed<RecordedFields> auto& set) { stream(set.group, set.grid, set.quantities); }

void pass(auto& stream, Passed<FieldSnapshot> auto& snapshot) { stream(snapshot.time, snapshot.set, snapshot.values); }

void pass(auto& stream, Passed<SampleBatch> auto& samples) { stream(samples.time, samples.columns); }

void pass(auto& stream, Passed<StoredCheckpoint> auto& checkpoint)
{
    stream(checkpoint.at.time, checkpoint.at.extends, checkpoint.at.state, checkpoint.layout, checkpoint.version,
           checkpoint.machine, checkpoint.samples, checkpoint.snapshots);
}

void pass(auto& stream, Passed<StoredRun> auto& run)
{
    stream(run.problem, run.title, run.status, run.message, run.caseText, run.softwareVersion, run.date, run.quantities,
           run.samples, run.recorded, run.fields, run.checkpoints, run.continued, run.motion, run.swing);
}

void pass(auto& stream, Passed<Sensitivity> auto& each)
{
    stream(each.parameter, each.unit, each.height, each.pitch, each.roll, each.minimumSpacing);
}

void pass(auto& stream, Passed<std::optional<Matrix3>> auto& matrix)
{
    bool present = matrix.has_value();
    std::array<double, 9> numbers{};
    if (present) std::copy_n(matrix->data(), numbers.size(), numbers.begin());
    stream(present, numbers);
    if constexpr (!std::is_const_v<std::remove_reference_t<decltype(matrix)>>)
        if (present) matrix.emplace(numbers.data());
}

void pass(auto& stream, Passed<ContactAtRest> auto& at)
{
    stream(at.state, at.contact, at.adhesion, at.friction, at.pitchTorque, at.rollTorque, at.area, at.peakPressure,
           at.diverges, at.region, at.branch);
}

void pass(auto& stream, Passed<RestingState> auto& state)
{
    stream(state.attitude, state.minimumSpacing, state.contact);
}

void pass(auto& stream, Passed<SteadyResult> auto& state)
{
    stream(state.status, state.message, state.iterations, state.solves, state.wallSeconds, state.residual,
           state.loadError, state.attitude, state.minimumSpacing, state.minimumAt, state.forces, state.shearPitchTorque,
           state.shearRollTorque, state.stiffness, state.sensitivities, state.discretisationError,
           state.unresolvedRidges, state.interestSpacing, state.otherEquilibria, state.contact, state.contactStates,
           state.contactStiffness, state.suspensionRest, state.grid, state.pressure, state.gap, state.recess);
}

void pass(auto& stream, Passed<StoredSteady> auto& stored)
{
    stream(stored.problem, stored.title, stored.caseText, stored.states);
}

/// Lets a second process read a file, "run" or "steady"; `problem` of the answer says why there is none, or that its
/// parts do not fit together.
template <class Stored>
Stored readByProcess(const char* reader, const std::filesystem::path& file, bool (*fits)(const Stored&))
{
    Stored stored;
    std::string problem;
    try {
        readAnswer({reader, file, ""}, stored);
        if (fits(stored)) return stored;
        problem = "is damaged: what was read from it does not fit together";
    } catch (const ReaderFailure& failure) {
        problem = failure.what();
    } catch (const std::bad_alloc&) {
        problem = "does not fit into memory";
    }
    Stored nothing;
    nothing.problem = file.string() + ' ' + problem;
    return nothing;
}

} // namespace touchdown
