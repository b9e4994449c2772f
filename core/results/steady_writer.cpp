// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/steady_writer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/hdf5_file.h"
#include "core/formats/output_file.h"
#include "core/results/file_header.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

void putPlace(const Hdf5Group& group, const std::string& name, const SurfacePoint& place, const std::string& longName)
{
    group.put(name, std::vector{place.x, place.y}, "m", longName);
}

void writeFields(const Hdf5Group& state, const SteadyResult& result)
{
    const CellGrid& grid = result.grid;
    if (grid.x.size() < 2 || grid.y.size() < 2 || result.pressure.size() != grid.cells()) return;
    std::vector<double> x, y;
    for (int i = 0; i < grid.nx(); ++i) x.push_back(grid.centreX(i));
    for (int j = 0; j < grid.ny(); ++j) y.push_back(grid.centreY(j));

    const Hdf5Group group = state.create("fields");
    const Hdf5Dataset alongX = group.put("x", x, "m", "Distance from the leading edge, of the cells' centres");
    const Hdf5Dataset alongY = group.put("y", y, "m", "Distance from the inner edge, of the cells' centres");
    alongX.makeScale("x");
    alongY.makeScale("y");
    group.put("x_lines", grid.x, "m", "Distance from the leading edge, of the cells' borders");
    group.put("y_lines", grid.y, "m", "Distance from the inner edge, of the cells' borders");

    const auto putField = [&](const char* name, const std::vector<double>& values, const char* unit,
                              const char* longName) {
        if (values.size() != grid.cells()) return;
        const Hdf5Dataset field = group.table(name, y.size(), x.size(), values.data(), unit, longName);
        field.attachScale(alongY, 0);
        field.attachScale(alongX, 1);
    };
    putField("pressure", result.pressure, "Pa", "Air pressure, absolute");
    putField("gap", result.gap, "m", "Gap, mean over the cell");
    putField("recess", result.recess, "m", "Recess of the surface, mean over the cell");
}

void writeInterest(const Hdf5Group& state, const std::vector<SurfacePoint>& points, const std::vector<double>& spacing)
{
    if (points.empty() || points.size() != spacing.size()) return;
    std::vector<double> rows;
    for (std::size_t i = 0; i < points.size(); ++i) rows.insert(rows.end(), {points[i].x, points[i].y, spacing[i]});
    state.table("points_of_interest", points.size(), 3, rows.data(), "m", "Points of interest: x, y and spacing");
}

void writeSensitivities(const Hdf5Group& state, const std::vector<Sensitivity>& sensitivities)
{
    if (sensitivities.empty()) return;
    const Hdf5Group group = state.create("sensitivities");
    for (const Sensitivity& each : sensitivities)
        group.put(each.parameter, std::vector{each.height, each.pitch, each.roll, each.minimumSpacing}, "SI",
                  "Change of trailing edge height, pitch, roll and minimum spacing" +
                      (each.unit.empty() ? "" : " per " + each.unit));
}

/// The other states of a slider with contact.
void writeOthers(const Hdf5Group& state, const std::vector<RestingState>& others)
{
    if (others.empty()) return;
    const Hdf5Group group = state.create("other_states");
    int number = 0;
    for (const RestingState& other : others) {
        const Hdf5Group each = group.create(std::to_string(++number));
        each.set("contact_state", other.contact.state);
        each.set("unstable", std::int64_t{other.contact.diverges});
        each.put("nominal_trailing_edge_height", other.attitude.height, "m", "Height of the trailing edge's centre");
        each.put("pitch", other.attitude.pitch, "rad", "Pitch");
        each.put("roll", other.attitude.roll, "rad", "Roll");
        each.put("minimum_spacing", other.minimumSpacing, "m", "Minimum spacing");
        each.put("contact_force", other.contact.contact, "N", "Real contact force");
        each.put("intermolecular_force", other.contact.adhesion, "N", "Adhesion force");
        each.put("friction_force", other.contact.friction, "N", "Friction force");
    }
}

constexpr std::array<std::string_view, 4> askedFor{"nominal_trailing_edge_height", "pitch", "roll", "minimum_spacing"};

void writeState(const Hdf5Group& state, const Case& c, const SteadyResult& result)
{
    state.set("status", name(result.status));
    state.set("message", result.message);
    state.set("iterations", std::int64_t{result.iterations});
    state.set("wall_seconds", result.wallSeconds);
    // Without a solution only the attitude that was asked for is known. A list of states may have left out the fields.
    const bool known = result.grid.x.size() > 1 || result.status == SteadyStatus::Converged;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    state.set("residual", known ? result.residual : unknown);
    state.set("load_error", known ? result.loadError : unknown);
    for (const auto& [quantity, value] : steadyQuantities(result)) {
        const bool asked = std::ranges::count(askedFor, quantity.name) > 0;
        state.put(quantity.name, known || asked ? value : unknown, quantity.unit, quantity.longName);
    }
    const FilmForces& forces = result.forces;
    putPlace(state, "minimum_spacing_at", result.minimumAt, "Where the spacing is least");
    putPlace(state, "maximum_pressure_at", forces.maximumAt, "Where the pressure is highest");
    putPlace(state, "minimum_pressure_at", forces.minimumAt, "Where the pressure is lowest");
    putPlace(state, "centre_of_positive_pressure", forces.centreOfPositive, "Centre of the pressure above ambient");
    putPlace(state, "centre_of_negative_pressure", forces.centreOfNegative, "Centre of the pressure below ambient");
    if (result.stiffness)
        state.table("stiffness", 3, 3, Matrix3(result.stiffness->transpose()).data(), "SI",
                    "Stiffness of the film: force, pitch and roll torque (rows) by height, pitch and roll (columns)");
    if (result.contactStiffness)
        state.table("contact_stiffness", 3, 3, Matrix3(result.contactStiffness->transpose()).data(), "SI",
                    "Stiffness of the contact: force, pitch and roll torque (rows) by height of the mass centre, pitch "
                    "and roll (columns)");
    if (!result.contact.state.empty()) {
        state.set("contact_state", result.contact.state);
        state.set("contact_region", static_cast<std::int64_t>(result.contact.region));
        state.set("contact_branch", static_cast<std::int64_t>(result.contact.branch));
    }
    if (const auto& rest = result.suspensionRest)
        state.put(
            "suspension_rest", std::vector{rest->height, rest->pitch, rest->roll}, "SI",
            "Height of the trailing edge's centre [m], pitch and roll [rad] at which the suspension exerts its load");
    writeOthers(state, result.contactStates);
    writeInterest(state, c.surface.pointsOfInterest, result.interestSpacing);
    writeSensitivities(state, result.sensitivities);
    writeFields(state, result);
}

/// Returns the problem, or "".
std::string attempt(const fs::path& file, const auto& write)
{
    try {
        write();
    } catch (const std::exception& error) {
        return "cannot write results to " + file.string() + ": " + error.what();
    }
    return {};
}

} // namespace

struct SteadyWriter::File {
    fs::path path;
    PartFile part;
    Case value;
    Hdf5Group root;
    std::size_t count = 0;
    std::vector<std::pair<Quantity, std::vector<double>>> series; // columns

    File(const fs::path& file, const Case& c, const std::string& caseText)
        : path(file), part(file, PartName::Own), value(c)
    {
        const Hdf5Access access;
        Hdf5Group created = createHdf5File(part.path());
        part.takeMode();
        writeFileHeader(created, steadyFormat, steadyFormatMajor, steadyFormatMinor, dateNow(), c.title);
        writeCaseGroup(created, c, caseText);
        created.create("states");
        root = std::move(created);
    }
    ~File()
    {
        const Hdf5Access access;
        root = {};
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void add(const SteadySeriesPoint& point, const SteadyResult& result)
    {
        const Hdf5Access access;
        writeState(root.create("states/" + std::to_string(++count)), value, result);
        for (const auto& numbers : {seriesQuantities(point), steadyQuantities(result)})
            for (const auto& [quantity, number] : numbers) columnOf(quantity).push_back(number);
        // A state that was not found has no numbers of its contact.
        for (auto& [quantity, values] : series) values.resize(count, std::numeric_limits<double>::quiet_NaN());
    }

    std::vector<double>& columnOf(const Quantity& wanted)
    {
        for (auto& [quantity, values] : series)
            if (quantity.name == wanted.name) return values;
        std::vector<double>& values = series.emplace_back(wanted, std::vector<double>()).second;
        values.resize(count - 1, std::numeric_limits<double>::quiet_NaN());
        return values;
    }

    void finish(SteadyStatus status, const std::string& message)
    {
        const Hdf5Access access;
        root.set("status", name(status));
        root.set("message", message);
        if (count > 1) {
            const Hdf5Group group = root.create("series");
            for (const auto& [quantity, values] : series)
                group.put(quantity.name, values, quantity.unit, quantity.longName);
        }
        root.close();
        part.show();
    }
};

SteadyWriter::SteadyWriter() = default;
SteadyWriter::~SteadyWriter() = default;
SteadyWriter::SteadyWriter(SteadyWriter&&) noexcept = default;
SteadyWriter& SteadyWriter::operator=(SteadyWriter&&) noexcept = default;

std::string SteadyWriter::open(const fs::path& file, const Case& c, const std::string& caseText)
{
    file_.reset();
    if (std::string problem = checkOutputFile(file); !problem.empty()) return problem;
    return attempt(file, [&] { file_ = std::make_unique<File>(file, c, caseText); });
}

std::string SteadyWriter::add(const SteadySeriesPoint& point, const SteadyResult& result)
{
    if (!file_) return "no results file is open";
    return attempt(file_->path, [&] { file_->add(point, result); });
}

std::string SteadyWriter::finish(SteadyStatus status, const std::string& message)
{
    if (!file_) return "no results file is open";
    std::string problem = attempt(file_->path, [&] { file_->finish(status, message); });
    file_.reset();
    return problem;
}

} // namespace touchdown
