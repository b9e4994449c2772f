// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/steady_file.h"

#include <system_error>
#include <utility>
#include <vector>

#include <hdf5_hl.h>

#include "core/results/results_file.h"
#include "core/results/results_layout.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

constexpr unsigned deflateLevel = 2;

std::string unitText(const std::string& unit) { return unit.empty() ? "1" : unit; }

/// `rows` x `columns`, row by row; compressed in one piece.
Hdf5Handle writeMatrix(hid_t group, const std::string& name, hsize_t rows, hsize_t columns, const double* values)
{
    const hsize_t size[2]{rows, columns};
    const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
    const Hdf5Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    checkHdf5(H5Pset_chunk(list, 2, size));
    checkHdf5(H5Pset_shuffle(list));
    checkHdf5(H5Pset_deflate(list, deflateLevel));
    Hdf5Handle dataset(H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT),
                       H5Dclose);
    checkHdf5(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    return dataset;
}

void writePlace(hid_t group, const std::string& name, const SurfacePoint& place, const std::string& longName)
{
    describeHdf5(writeHdf5Array(group, name, std::vector<double>{place.x, place.y}), "m", longName);
}

Hdf5Handle writeAxis(hid_t group, const std::string& name, const std::vector<double>& values,
                     const std::string& longName)
{
    Hdf5Handle axis = writeHdf5Array(group, name, values);
    describeHdf5(axis, "m", longName);
    return axis;
}

void writeFields(hid_t state, const SteadyResult& result)
{
    const CellGrid& grid = result.grid;
    if (grid.x.size() < 2 || grid.y.size() < 2) return;
    std::vector<double> x, y;
    for (int i = 0; i < grid.nx(); ++i) x.push_back(grid.centreX(i));
    for (int j = 0; j < grid.ny(); ++j) y.push_back(grid.centreY(j));

    const Hdf5Handle group = createHdf5Group(state, "fields");
    const Hdf5Handle alongX = writeAxis(group, "x", x, "Distance from the leading edge, of the cells' centres");
    const Hdf5Handle alongY = writeAxis(group, "y", y, "Distance from the inner edge, of the cells' centres");
    checkHdf5(H5DSset_scale(alongX, "x"));
    checkHdf5(H5DSset_scale(alongY, "y"));
    writeAxis(group, "x_lines", grid.x, "Distance from the leading edge, of the cells' borders");
    writeAxis(group, "y_lines", grid.y, "Distance from the inner edge, of the cells' borders");

    struct Entry {
        const char* name;
        const char* unit;
        const char* longName;
        const std::vector<double>& values;
    };
    for (const Entry& entry : {Entry{"pressure", "Pa", "Air pressure, absolute", result.pressure},
                               Entry{"gap", "m", "Gap, mean over the cell", result.gap},
                               Entry{"recess", "m", "Recess of the surface, mean over the cell", result.recess}}) {
        if (entry.values.size() != grid.cells()) continue;
        const Hdf5Handle field = writeMatrix(group, entry.name, y.size(), x.size(), entry.values.data());
        describeHdf5(field, entry.unit, entry.longName);
        checkHdf5(H5DSattach_scale(field, alongY, 0));
        checkHdf5(H5DSattach_scale(field, alongX, 1));
    }
}

void writeInterest(hid_t state, const std::vector<SurfacePoint>& points, const std::vector<double>& spacing)
{
    if (points.empty() || points.size() != spacing.size()) return;
    std::vector<double> rows;
    for (std::size_t i = 0; i < points.size(); ++i) rows.insert(rows.end(), {points[i].x, points[i].y, spacing[i]});
    describeHdf5(writeMatrix(state, "points_of_interest", points.size(), 3, rows.data()), "m",
                 "Points of interest: x, y and spacing");
}

void writeSensitivities(hid_t state, const std::vector<Sensitivity>& sensitivities)
{
    if (sensitivities.empty()) return;
    const Hdf5Handle group = createHdf5Group(state, "sensitivities");
    for (const Sensitivity& each : sensitivities) {
        const std::vector<double> row{each.height, each.pitch, each.roll, each.minimumSpacing};
        const std::string per = each.unit.empty() ? "" : " per " + each.unit;
        describeHdf5(writeHdf5Array(group, each.parameter, row), "SI",
                     "Change of trailing edge height, pitch, roll and minimum spacing" + per);
    }
}

void writeState(hid_t parent, const std::string& name, const Case& c, const SteadyResult& result)
{
    const Hdf5Handle state = createHdf5Group(parent, name);
    writeHdf5Attribute(state, "status", std::string(touchdown::name(result.status)));
    writeHdf5Attribute(state, "message", result.message);
    writeHdf5Attribute(state, "iterations", static_cast<std::int64_t>(result.iterations));
    writeHdf5Attribute(state, "wall_seconds", result.wallSeconds);
    writeHdf5Attribute(state, "residual", result.residual);
    writeHdf5Attribute(state, "load_error", result.loadError);
    for (const auto& [quantity, value] : steadyQuantities(result))
        describeHdf5(writeHdf5Scalar(state, quantity.name, value), unitText(quantity.unit), quantity.longName);
    const FilmForces& forces = result.forces;
    writePlace(state, "minimum_spacing_at", result.minimumAt, "Where the spacing is least");
    writePlace(state, "maximum_pressure_at", forces.maximumAt, "Where the pressure is highest");
    writePlace(state, "minimum_pressure_at", forces.minimumAt, "Where the pressure is lowest");
    writePlace(state, "centre_of_positive_pressure", forces.centreOfPositive, "Centre of the pressure above ambient");
    writePlace(state, "centre_of_negative_pressure", forces.centreOfNegative, "Centre of the pressure below ambient");
    if (result.stiffness)
        describeHdf5(writeMatrix(state, "stiffness", 3, 3, Matrix3(result.stiffness->transpose()).data()), "SI",
                     "Stiffness of the film: force, pitch and roll torque (rows) by height, pitch and roll (columns)");
    writeInterest(state, c.surface.pointsOfInterest, result.interestSpacing);
    writeSensitivities(state, result.sensitivities);
    writeFields(state, result);
}

} // namespace

struct SteadyWriter::File {
    fs::path path;
    fs::path part;
    Case value;
    Hdf5Handle file;
    Hdf5Handle states;
    std::size_t count = 0;
    bool finished = false;
    std::vector<std::pair<Quantity, std::vector<double>>> series; // columns

    File(const fs::path& target, const Case& c, const std::string& caseText)
        : path(target), part(target.string() + ".part"), value(c)
    {
        const Hdf5Access access;
        file = Hdf5Handle(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, hdf5FileAccess()), H5Fclose);
        writeFileHeader(file, steadyFormat, steadyFormatMajor, steadyFormatMinor, dateNow(), c.title);
        writeCaseGroup(file, c, caseText);
        states = createHdf5Group(file, "states");
    }
    ~File()
    {
        const Hdf5Access access;
        states = {};
        file = {};
        std::error_code none;
        if (!finished) fs::remove(part, none);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void add(const SteadySeriesPoint& point, const SteadyResult& result)
    {
        const Hdf5Access access;
        writeState(states, std::to_string(++count), value, result);
        std::size_t column = 0;
        for (const auto& numbers : {seriesQuantities(point), steadyQuantities(result)})
            for (const auto& [quantity, number] : numbers) {
                if (column == series.size()) series.emplace_back(quantity, std::vector<double>());
                series[column++].second.push_back(number);
            }
    }

    void finish(SteadyStatus status, const std::string& message)
    {
        const Hdf5Access access;
        writeHdf5Attribute(file, "status", std::string(name(status)));
        writeHdf5Attribute(file, "message", message);
        if (count > 1) {
            const Hdf5Handle group = createHdf5Group(file, "series");
            for (const auto& [quantity, values] : series)
                describeHdf5(writeHdf5Array(group, quantity.name, values), unitText(quantity.unit), quantity.longName);
        }
        states.close();
        file.close();
        fs::rename(part, path);
        finished = true;
    }

    std::string problem(const std::exception& error) const
    {
        return "cannot write results to " + path.string() + ": " + error.what();
    }
};

SteadyWriter::SteadyWriter() = default;
SteadyWriter::~SteadyWriter() = default;
SteadyWriter::SteadyWriter(SteadyWriter&&) noexcept = default;
SteadyWriter& SteadyWriter::operator=(SteadyWriter&&) noexcept = default;

std::string SteadyWriter::open(const fs::path& file, const Case& c, const std::string& caseText)
{
    file_.reset();
    if (std::string problem = checkResultsTarget(file); !problem.empty()) return problem;
    // Through a symbolic link, so that the link stays one.
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error);
    try {
        file_ = std::make_unique<File>(error ? file : target, c, caseText);
    } catch (const std::exception& failure) {
        return "cannot write results to " + file.string() + ": " + failure.what();
    }
    return {};
}

std::string SteadyWriter::add(const SteadySeriesPoint& point, const SteadyResult& result)
{
    if (!file_) return "no results file is open";
    try {
        file_->add(point, result);
    } catch (const std::exception& error) {
        return file_->problem(error);
    }
    return {};
}

std::string SteadyWriter::finish(SteadyStatus status, const std::string& message)
{
    if (!file_) return "no results file is open";
    std::string problem;
    try {
        file_->finish(status, message);
    } catch (const std::exception& error) {
        problem = file_->problem(error);
    }
    file_.reset();
    return problem;
}

} // namespace touchdown
