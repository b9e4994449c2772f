// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_dynamics_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/case_files/cml/cml_disk_file.h"

namespace touchdown {

namespace {

using Numbers = std::vector<CmlNumber>;

bool differs(double a, double b) { return std::abs(a - b) > 1e-6 * std::max(std::abs(a), std::abs(b)); }

void readProblem(CmlPart& part)
{
    const Numbers n = part.sequence(18);
    CmlParameters& parameters = part.parameters();
    const SliderCase& slider = parameters.value().slider;
    if (differs(n[0].value, slider.length) || differs(n[1].value * n[0].value, slider.width))
        part.leaveOut("a slider of another size than that of the rails (xl, yl)");
    if (n[2].value != 0.0 || n[3].value != 0.0) part.leaveOut("a mass centre off the middle of the slider (xg, yg)");
    if (n[4].value != 0.0 && differs(n[4].value * n[0].value, 0.5 * slider.thickness))
        part.leaveOut("the height of the mass centre (zg)");
    if (n[5].value != 0.0) {
        parameters.choose("air.source", "atmosphere", n[5].line);
        parameters.set("air.altitude", n[5]);
    }
    parameters.set("suspension.preload", n[6], "kgf");
    parameters.setNumber("suspension.offset_x", n[7].value * slider.length, n[7].line);
    parameters.setNumber("suspension.offset_y", n[8].value * slider.width, n[8].line);
    parameters.set("slider.mass", n[9]);
    parameters.set("slider.pitch_inertia", n[10]);
    parameters.set("slider.roll_inertia", n[11]);
    parameters.set("disk.speed", n[12], "rpm");
    parameters.choose("run.steps", "fixed", n[13].line); // as theirs
    parameters.set("run.step", n[13]);
    parameters.set("run.duration", n[14]);
    parameters.set("disk.radius", n[15]);
}

void readSuspension(CmlPart& part)
{
    const Numbers n = part.sequence(18);
    CmlParameters& parameters = part.parameters();
    if (n[0].value != 0.0) part.leaveOut("an actuator (iact)");
    parameters.set("disk.skew", n[4], "deg");
    if (n[5].value != 0.0) part.leaveOut("a suspension of modes (isusp)");
    static constexpr std::array<std::string_view, 6> keys{"suspension.stiffness",      "suspension.pitch_stiffness",
                                                          "suspension.roll_stiffness", "suspension.damping",
                                                          "suspension.pitch_damping",  "suspension.roll_damping"};
    for (std::size_t i = 0; i < keys.size(); ++i) parameters.set(keys[i], n[10 + i]);
    parameters.choose("suspension.holds_attitude", "true", n[16].line);
    parameters.set("suspension.static_pitch", n[16]);
    parameters.set("suspension.static_roll", n[17]);
}

void readInitial(CmlPart& part)
{
    const Numbers n = part.sequence(6);
    CmlParameters& parameters = part.parameters();
    parameters.set("initial.nominal_trailing_edge_height", n[0]);
    parameters.set("initial.pitch", n[1]);
    parameters.set("initial.roll", n[2]);
    parameters.set("initial.vertical_velocity", n[3]);
    parameters.set("initial.pitch_velocity", n[4]);
    parameters.set("initial.roll_velocity", n[5]);
}

void readDynamicsSolution(CmlPart& part)
{
    const Numbers n = part.sequence(4);
    CmlParameters& parameters = part.parameters();
    const int model = wholeCmlNumber(n[0], "the slip model", 0, 5);
    static constexpr std::array<std::string_view, 6> models{"continuum", "first-order", "second-order", "",
                                                            "",          "fukui-kaneko"};
    if (models[static_cast<std::size_t>(model)].empty())
        throw CmlError(n[0].line, "the slip model must be 0, 1, 2 or 5, not " + std::to_string(model));
    parameters.choose("air.slip", models[static_cast<std::size_t>(model)], n[0].line);
    parameters.set("film.tolerance", n[1]);
    parameters.set("steady.load_tolerance", n[2]);
    const int scheme = wholeCmlNumber(n[3], "the scheme", 1, 4);
    static constexpr std::array<std::string_view, 4> schemes{"complete-flux", "complete-flux", "upwind", "hybrid"};
    parameters.choose("film.scheme", schemes[static_cast<std::size_t>(scheme - 1)], n[3].line);
    if (scheme <= 2)
        part.leaveOut(scheme == 1 ? "the power law as such; complete-flux is taken"
                                  : "central differences; complete-flux is taken");
}

void readDynamicsGrid(CmlPart& part)
{
    const Numbers n = part.sequence(7);
    part.parameters().choose("film.grid", n[0].value != 0.0 ? "adapted" : "uniform", n[0].line);
    if (n[1].value != 0.0) part.leaveOut("symmetry (isymmetry); the whole width is solved");
    if (n[2].value != 0.0) part.leaveOut("an existing grid (ioldgrid)");
    setCmlNodes(part, n[3], n[4], 1);
    if (n[5].value > 1.0 || n[6].value > 1.0) part.leaveOut("grid sections (nsx, nsy)");
}

void readDynamicsAir(CmlPart& part)
{
    for (const CmlNamedNumber& each : part.namedNumbers()) {
        if (each.name.starts_with("p0"))
            part.parameters().set("air.pressure", each.number);
        else if (each.name.starts_with("al") || each.name.starts_with("mfp") || each.name.starts_with("lambda"))
            part.parameters().set("air.mean_free_path", each.number);
        else if (each.name.starts_with("vis"))
            part.parameters().set("air.viscosity", each.number);
        else if (each.number.value != 0.0)
            part.leaveOut(each.name + " = " + std::string(each.number.text));
    }
}

/// What is not modelled begins with the switches or the counts that switch it on: two for a surface, one elsewhere.
void readSwitches(CmlPart& part)
{
    const auto numbers = part.list(0);
    const std::size_t switches = part.name().find("surface") != std::string::npos ? 2 : 1;
    const auto first = numbers.first(std::min(switches, numbers.size()));
    if (std::ranges::any_of(first, [](const CmlNumber& n) { return n.value != 0.0; }))
        part.leaveOut("the whole section, which is switched on");
}

constexpr std::array<CmlSectionReader, 12> dynamicsSections{{
    {"problem", "Problem Definition", true, readProblem},
    {"suspension", "Suspension", true, readSuspension},
    {"initial", "Initial Condition", true, readInitial},
    {"solution", "Solution Control", true, readDynamicsSolution},
    {"grid", "Grid Control", true, readDynamicsGrid},
    {"track profile", "Disk Track Profile", false, readCmlTrackProfile},
    {"disk surface", "Disk Surface", false, readCmlDiskSurface},
    {"intermolecular", "Intermolecular Force", false, readCmlIntermolecular},
    {"asperity contact", "Asperity Contact", false, readCmlAsperityContact},
    {"air", "Air Parameters", false, readDynamicsAir},
    {"additional", "Additional Parameters", false, readDynamicsAir},
    {"", "", false, readSwitches},
}};

} // namespace

void readCmlDynamics(std::string_view text, CmlParameters& parameters)
{
    parameters.setNumber("steady.shear_arm", 1.0, 0);
    readCmlSections(text, dynamicsSections, parameters);
    settleCmlDisk(parameters);
}

} // namespace touchdown
