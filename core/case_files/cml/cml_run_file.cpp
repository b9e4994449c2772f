// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_run_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/case/parameters.h"

namespace touchdown {

namespace {

constexpr int anyFlag = 9; // the largest value of a switch that is taken for one
constexpr int longestSeries = 1000;
constexpr int mostRegions = 1000; // of a grid

std::string shown(std::string_view name, const CmlNumber& number)
{
    return std::string(name) + " = " + std::string(number.text);
}

void readRunSolution(CmlPart& part)
{
    const int stiffness = part.whole(0, 0, "istiff", 0, anyFlag);
    const int solution = part.whole(0, 1, "isolv", 0, anyFlag);
    const int oldGrid = part.whole(0, 2, "ioldg", 0, anyFlag);
    const int adapt = part.whole(0, 3, "iadpt", 0, anyFlag);
    CmlParameters& parameters = part.parameters();
    const int line = part.list(0).front().line;
    parameters.choose("steady.stiffness", stiffness != 0 ? "true" : "false", line);
    parameters.choose("steady.fixed_attitude", solution == 0 ? "true" : "false", line);
    parameters.choose("film.grid", adapt != 0 ? "adapted" : "uniform", line);
    if (solution > 1) part.leaveOut("geometry only or its extrapolation (isolv = " + std::to_string(solution) + ")");
    if (oldGrid != 0) part.leaveOut("an existing grid (ioldg)");
}

void readAttitude(CmlPart& part)
{
    part.set("initial.nominal_trailing_edge_height", 0, 0, "hm");
    part.set("initial.pitch", 0, 1, "the pitch");
    part.set("initial.roll", 0, 2, "the roll");
}

/// One value sets the scalar, several the list.
void setSeries(CmlPart& part, std::size_t list, int count, std::string_view what, std::string_view scalar,
               std::string_view series, std::string_view unit)
{
    const auto numbers = part.numbers(list, static_cast<std::size_t>(count), what);
    part.parameters().set(scalar, numbers.front(), unit);
    if (count > 1) part.parameters().setList(series, numbers, unit);
}

/// Altitudes wait for the section that says whether they count.
void readRuns(CmlPart& part)
{
    const int radii = part.whole(0, 0, "the number of radii", 1, longestSeries);
    const int speeds = part.whole(0, 1, "the number of speeds", 1, longestSeries);
    const int altitudes = part.whole(0, 2, "the number of altitudes", 0, longestSeries);
    setSeries(part, 1, radii, "a radius", "disk.radius", "steady.radii", "");
    setSeries(part, 2, radii, "a skew", "disk.skew", "steady.skews", "deg");
    setSeries(part, 3, speeds, "a speed", "disk.speed", "steady.speeds", "rpm");
    const auto numbers = part.numbers(4, static_cast<std::size_t>(altitudes), "an altitude");
    if (altitudes > 1)
        part.parameters().setList("steady.altitudes", numbers);
    else if (altitudes == 1)
        part.parameters().set("air.altitude", numbers.front());
}

void readRunAir(CmlPart& part)
{
    part.set("air.pressure", 0, 0, "p0");
    part.set("air.mean_free_path", 0, 1, "the mean free path");
    part.set("air.viscosity", 0, 2, "the viscosity");
}

void readLoad(CmlPart& part)
{
    part.set("suspension.preload", 0, 0, "f0", "kgf");
    part.set("suspension.offset_x", 0, 1, "xf0");
    part.set("suspension.offset_y", 0, 2, "yf0");
    part.set("suspension.pitch_torque", 1, 0, "xfs", "uN m");
    part.set("suspension.roll_torque", 1, 1, "yfs", "uN m");
    part.set("steady.load_tolerance", 1, 2, "emax");
    if (part.list(0).size() == 3) return; // an older file
    part.set("suspension.static_pitch", 0, 3, "psa");
    part.set("suspension.static_roll", 0, 4, "rsa");
    const int useStiffness = part.whole(0, 5, "usestiff", 0, anyFlag);
    part.parameters().choose("suspension.holds_attitude", useStiffness != 0 ? "true" : "false",
                             part.list(0).front().line);
    part.set("suspension.pitch_stiffness", 1, 3, "skp");
    part.set("suspension.roll_stiffness", 1, 4, "skr");
}

void readRunGrid(CmlPart& part)
{
    setCmlNodes(part, part.number(0, 0, "nx"), part.number(0, 1, "ny"), 0);
    if (part.whole(1, 0, "nsx", 0, mostRegions) > 1 || part.whole(1, 1, "nsy", 0, mostRegions) > 1)
        part.leaveOut("grid sections (nsx, nsy)");
    if (part.whole(1, 2, "isymm", 0, anyFlag) != 0) part.leaveOut("symmetry (isymm); the whole width is solved");
}

/// How the established program crowds its grid: our grids have their own rules.
void readAdaptiveGrid(CmlPart&) {}

void readRefinement(CmlPart& part)
{
    if (part.whole(0, 0, "the number of regions", 0, mostRegions) > 0)
        part.leaveOut("refined bands (" + std::to_string(static_cast<int>(part.list(0)[0].value)) + ")");
}

void readReynolds(CmlPart& part)
{
    // A power law's load is several per cent off where the scheme that is taken instead errs by less than one.
    static constexpr std::array<std::string_view, 3> schemes{"upwind", "hybrid", "complete-flux"};
    static constexpr std::array<std::string_view, 4> models{"continuum", "first-order", "second-order", "fukui-kaneko"};
    const int scheme = part.whole(0, 0, "ischeme", 0, 2);
    const int model = part.whole(0, 1, "the slip model", 0, 3);
    CmlParameters& parameters = part.parameters();
    const int line = part.list(0).front().line;
    parameters.choose("film.scheme", schemes[static_cast<std::size_t>(scheme)], line);
    if (scheme == 2) part.leaveOut("the power law as such; complete-flux is taken, film.scheme = power-law compares");
    parameters.choose("air.slip", models[static_cast<std::size_t>(model)], line);
    part.set("film.tolerance", 0, 2, "akmax");
    if (!part.has(0, 5)) return;
    const CmlNumber& accommodation = part.number(0, 5, "the accommodation coefficient");
    if (model == 1)
        parameters.set("air.accommodation", accommodation);
    else if (accommodation.value != 1.0)
        part.leaveOut(shown("the accommodation coefficient", accommodation) + " with this slip model");
}

void readContact(CmlPart& part)
{
    const int model = part.whole(0, 0, "icmodel", 0, anyFlag);
    if (model == 3)
        part.leaveOut("intermolecular forces (icmodel = 3)");
    else if (model != 0)
        part.leaveOut("partial contact (icmodel = " + std::to_string(model) + ")");
    if (part.has(1, 3) && part.number(1, 3, "elecpot").value != 0.0) part.leaveOut("an electric potential (elecpot)");
}

void readSensitivities(CmlPart& part)
{
    bool wanted = false;
    for (std::size_t list = 0; list < 3; ++list)
        for (const CmlNumber& increment : part.numbers(list, 3, "an increment")) wanted |= increment.value != 0.0;
    part.parameters().choose("steady.sensitivities", wanted ? "true" : "false", part.line());
}

/// Pairs of a line with names and a line with their values.
void readAdditional(CmlPart& part)
{
    for (const CmlNamedNumber& each : part.namedNumbers()) {
        const bool on = each.number.value != 0.0;
        if (each.name.starts_with("use_standard_air")) {
            part.parameters().choose("air.source", on ? "established-standard" : "given", each.number.line);
        } else if (each.name.starts_with("temperature")) {
            part.parameters().set("air.temperature", each.number, "degC");
        } else if (each.name.starts_with("use_imf")) {
            if (on) part.leaveOut("intermolecular forces (use_imf)");
        } else if (each.name.starts_with("do_humidity")) {
            if (on) part.leaveOut("humidity");
        } else if (!each.name.starts_with("output_shear") && !each.name.starts_with("humidity") && on) {
            part.leaveOut(shown(each.name, each.number));
        }
    }
}

constexpr std::array<CmlSectionReader, 13> runSections{{
    {"solution", "Solution Control", true, readRunSolution},
    {"attitude", "Initial Attitude", true, readAttitude},
    {"runs", "Runs", true, readRuns},
    {"air", "Air Parameters", true, readRunAir},
    {"load", "Load Parameters", true, readLoad},
    {"adaptive", "Adaptive Grid", false, readAdaptiveGrid},
    {"refinement in x", "Mesh Refinement in X Direction", false, readRefinement},
    {"refinement in y", "Mesh Refinement in Y Direction", false, readRefinement},
    {"grid", "Grid Control", true, readRunGrid},
    {"reynolds", "Reynolds Equation", true, readReynolds},
    {"contact", "Partial Contact", false, readContact},
    {"sensitivit", "Sensitivities", false, readSensitivities},
    {"additional", "Additional Parameters", false, readAdditional},
}};

/// The established program uses altitudes only with its standard air; a single altitude is then that of the atmosphere.
void settleAir(CmlParameters& parameters)
{
    const bool standard = parameters.value().air.source == AirSource::EstablishedStandard;
    const bool series = !parameters.value().steady.altitudes.empty();
    const int line = parameters.lineOf(series ? "steady.altitudes" : "air.altitude");
    if (!parameters.wasSet("air.source") && parameters.wasSet("air.pressure"))
        parameters.addWarning(
            parameters.lineOf("air.pressure"),
            "Air Parameters: the air of the file is used, because the file does not contain use_standard_air");
    if (!series && parameters.value().air.altitude == 0.0) return;
    if (standard) {
        if (!series) parameters.choose("air.source", "atmosphere", line);
        return;
    }
    parameters.addWarning(line, "Runs: the altitudes do not count without use_standard_air; the file's air is taken");
    parameters.setNumbers("steady.altitudes", {}, line);
    parameters.setNumber("air.altitude", 0.0, line);
}

} // namespace

void readCmlRun(std::string_view text, CmlParameters& parameters)
{
    parameters.setNumber("steady.shear_arm", 1.0, 0);
    readCmlSections(text, runSections, parameters);
    settleAir(parameters);
}

} // namespace touchdown
