// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/steady_reader.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <string_view>
#include <utility>

#include "core/formats/hdf5_file.h"
#include "core/formats/hdf5_inspection.h"
#include "core/formats/reader_process.h"
#include "core/results/file_header.h"
#include "core/results/steady_writer.h"
#include "core/results/stored_values.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {
namespace {

SteadyStatus statusOf(const std::string& text)
{
    for (const SteadyStatus status : {SteadyStatus::Converged, SteadyStatus::NotConverged, SteadyStatus::Cancelled})
        if (text == name(status)) return status;
    return SteadyStatus::Failed;
}

std::vector<double> numbers(const Hdf5Group& state, const std::string& name, std::size_t count)
{
    std::vector<double> values = state.get(name).numbers();
    if (values.size() != count)
        throw Hdf5Error(name + " has " + std::to_string(values.size()) + " numbers instead of " +
                        std::to_string(count));
    return values;
}

SurfacePoint place(const Hdf5Group& state, const std::string& name)
{
    const std::vector<double> values = numbers(state, name, 2);
    return {values[0], values[1]};
}

std::vector<double> lines(const Hdf5Group& state, const std::string& name)
{
    std::vector<double> values = state.get(name).column();
    const auto ascends = [](double a, double b) { return std::isfinite(a) && std::isfinite(b) && a < b; };
    if (values.size() < 2 || std::ranges::adjacent_find(values, std::not_fn(ascends)) != values.end())
        throw Hdf5Error(name + " does not hold at least two increasing numbers");
    return values;
}

void readFields(const Hdf5Group& state, SteadyResult& result)
{
    if (!state.has("fields")) return;
    result.grid.x = lines(state, "fields/x_lines");
    result.grid.y = lines(state, "fields/y_lines");
    const std::size_t cells = result.grid.cells();
    const auto field = [&](const char* name, std::vector<double>& values) {
        values = numbers(state, std::string("fields/") + name, cells);
        checkFinite(values, std::string("fields/") + name);
    };
    field("pressure", result.pressure);
    field("gap", result.gap);
    field("recess", result.recess);
    const Attitude& a = result.attitude;
    if (!std::isfinite(a.height) || !std::isfinite(a.pitch) || !std::isfinite(a.roll) ||
        !std::isfinite(result.minimumSpacing))
        throw Hdf5Error("a state with fields has no attitude");
}

void readSensitivities(const Hdf5Group& state, SteadyResult& result)
{
    constexpr std::string_view per = " per "; // of the long name, before the parameter's unit
    if (!state.has("sensitivities")) return;
    const Hdf5Group group = state.group("sensitivities");
    for (const std::string& key : group.names()) {
        const std::vector<double> values = numbers(group, key, 4);
        const std::string words = group.get(key).attribute("long_name");
        const std::size_t at = words.rfind(per);
        result.sensitivities.push_back({key, at == std::string::npos ? std::string() : words.substr(at + per.size()),
                                        values[0], values[1], values[2], values[3]});
    }
}

Matrix3 matrix(const Hdf5Group& state, const char* name)
{
    const std::vector<double> values = numbers(state, name, 9);
    Matrix3 result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result(i, j) = values[static_cast<std::size_t>(3 * i + j)];
    return result;
}

void readOther(const Hdf5Group& group, SteadyResult& result)
{
    const auto number = [&](const char* name) { return numbers(group, name, 1).front(); };
    RestingState& other = result.contactStates.emplace_back();
    other.contact.state = group.attribute("contact_state");
    other.contact.diverges = group.numberAttribute("unstable") != 0.0;
    other.attitude = {number("nominal_trailing_edge_height"), number("pitch"), number("roll")};
    other.minimumSpacing = number("minimum_spacing");
    other.contact.contact = number("contact_force");
    other.contact.adhesion = number("intermolecular_force");
    other.contact.friction = number("friction_force");
}

SteadyResult readState(const Hdf5Group& state)
{
    SteadyResult result;
    result.status = statusOf(state.attribute("status"));
    result.message = state.attribute("message");
    const double iterations = state.numberAttribute("iterations");
    result.iterations = iterations >= 0.0 && iterations < 1e9 ? static_cast<int>(iterations) : 0;
    result.wallSeconds = state.numberAttribute("wall_seconds");
    result.residual = state.numberAttribute("residual");
    result.loadError = state.numberAttribute("load_error");
    result.contact.state = state.attribute("contact_state");
    if (!result.contact.state.empty()) {
        const double region = state.numberAttribute("contact_region"), branch = state.numberAttribute("contact_branch");
        if (!(region >= 0.0 && region < 4.0) || !(branch >= 0.0 && branch < 2.0))
            throw Hdf5Error("contact_region or contact_branch is none");
        result.contact.region = static_cast<ContactRegion>(region);
        result.contact.branch = static_cast<ContactBranch>(branch);
    }
    if (state.has("suspension_rest")) {
        const std::vector<double> rest = numbers(state, "suspension_rest", 3);
        checkFinite(rest, "suspension_rest");
        result.suspensionRest = {rest[0], rest[1], rest[2]};
    }
    if (state.has("contact_stiffness")) result.contactStiffness = matrix(state, "contact_stiffness");
    for (const SteadyQuantity& each : steadyQuantities(result))
        if (state.has(each.quantity.name))
            setSteadyQuantity(result, each.quantity.name, numbers(state, each.quantity.name, 1).front());
    result.minimumAt = place(state, "minimum_spacing_at");
    result.forces.maximumAt = place(state, "maximum_pressure_at");
    result.forces.minimumAt = place(state, "minimum_pressure_at");
    result.forces.centreOfPositive = place(state, "centre_of_positive_pressure");
    result.forces.centreOfNegative = place(state, "centre_of_negative_pressure");
    if (state.has("stiffness")) result.stiffness = matrix(state, "stiffness");
    if (state.has("other_states")) {
        const Hdf5Group others = state.group("other_states");
        for (const std::string& number : others.names()) readOther(others.group(number), result);
    }
    if (state.has("points_of_interest")) {
        const std::vector<double> values = state.get("points_of_interest").numbers();
        if (values.size() % 3 != 0) throw Hdf5Error("points_of_interest does not hold rows of x, y and spacing");
        for (std::size_t k = 2; k < values.size(); k += 3) result.interestSpacing.push_back(values[k]);
    }
    readSensitivities(state, result);
    readFields(state, result);
    return result;
}

/// The lengths are those that the reader found.
bool fieldsFit(const StoredSteady& stored)
{
    return std::ranges::all_of(stored.states, [](const SteadyResult& state) {
        if (state.grid.x.empty() && state.grid.y.empty())
            return state.pressure.empty() && state.gap.empty() && state.recess.empty();
        if (state.grid.x.size() < 2 || state.grid.y.size() < 2) return false;
        const std::size_t cells = state.grid.cells();
        return state.pressure.size() == cells && state.gap.size() == cells && state.recess.size() == cells;
    });
}

} // namespace

StoredSteady readSteady(const std::filesystem::path& path)
{
    return readByProcess<StoredSteady>("steady", path, fieldsFit);
}

StoredSteady readSteadyDirectly(const std::filesystem::path& path)
{
    const Hdf5Access access;
    StoredSteady stored;
    const auto refused = [](std::string problem) {
        StoredSteady nothing;
        nothing.problem = std::move(problem);
        return nothing;
    };
    if (std::string problem = notHdf5(path); !problem.empty()) return refused(std::move(problem));
    try {
        const Hdf5Group file = openHdf5File(path);
        if (std::string problem = foreignFile(path, file, steadyFormat, steadyFormatMajor, "static states");
            !problem.empty())
            return refused(std::move(problem));
        inspectHdf5File(file, readerLimits(path).data);
        stored.title = file.attribute("title");
        stored.caseText = file.get("case/text").text();
        const Hdf5Group states = file.group("states");
        for (const std::string& number : states.names()) stored.states.push_back(readState(states.group(number)));
    } catch (const Hdf5Error& error) {
        return refused(path.string() + " is damaged or cut short: " + error.what());
    } catch (const std::bad_alloc&) {
        return refused(path.string() + " does not fit into memory");
    }
    return stored;
}

} // namespace touchdown
