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
    CmlFields& fields = part.fields();
    const SliderCase& slider = fields.value().slider;
    if (differs(n[0].value, slider.length) || differs(n[1].value * n[0].value, slider.width))
        part.leaveOut("a slider of another size than that of the rails (xl, yl)");
    if (n[2].value != 0.0 || n[3].value != 0.0) part.leaveOut("a mass centre off the middle of the slider (xg, yg)");
    if (n[4].value != 0.0 && differs(n[4].value * n[0].value, 0.5 * slider.thickness))
        part.leaveOut("the height of the mass centre (zg)");
    if (n[5].value != 0.0) {
        fields.choose("air.source", "atmosphere", n[5].line);
        fields.set("air.altitude", n[5]);
    }
    fields.set("suspension.preload", n[6], "kgf");
    fields.setNumber("suspension.offset_x", n[7].value * slider.length, n[7].line);
    fields.setNumber("suspension.offset_y", n[8].value * slider.width, n[8].line);
    fields.set("slider.mass", n[9]);
    fields.set("slider.pitch_inertia", n[10]);
    fields.set("slider.roll_inertia", n[11]);
    fields.set("disk.speed", n[12], "rpm");
    fields.choose("run.steps", "fixed", n[13].line); // as theirs
    fields.set("run.step", n[13]);
    fields.set("run.duration", n[14]);
    fields.set("disk.radius", n[15]);
}

void readSuspension(CmlPart& part)
{
    const Numbers n = part.sequence(18);
    CmlFields& fields = part.fields();
    if (n[0].value != 0.0) part.leaveOut("an actuator (iact)");
    fields.set("disk.skew", n[4], "deg");
    if (n[5].value != 0.0) part.leaveOut("a suspension of modes (isusp)");
    static constexpr std::array<std::string_view, 6> keys{"suspension.stiffness",      "suspension.pitch_stiffness",
                                                          "suspension.roll_stiffness", "suspension.damping",
                                                          "suspension.pitch_damping",  "suspension.roll_damping"};
    for (std::size_t i = 0; i < keys.size(); ++i) fields.set(keys[i], n[10 + i]);
    fields.choose("suspension.holds_attitude", "true", n[16].line);
    fields.set("suspension.static_pitch", n[16]);
    fields.set("suspension.static_roll", n[17]);
}

void readInitial(CmlPart& part)
{
    const Numbers n = part.sequence(6);
    CmlFields& fields = part.fields();
    fields.set("initial.nominal_trailing_edge_height", n[0]);
    fields.set("initial.pitch", n[1]);
    fields.set("initial.roll", n[2]);
    fields.set("initial.vertical_velocity", n[3]);
    fields.set("initial.pitch_velocity", n[4]);
    fields.set("initial.roll_velocity", n[5]);
}

void readDynamicsSolution(CmlPart& part)
{
    const Numbers n = part.sequence(4);
    CmlFields& fields = part.fields();
    const int model = wholeCmlNumber(n[0], "the slip model", 0, 5);
    static constexpr std::array<std::string_view, 6> models{"continuum", "first-order", "second-order", "",
                                                            "",          "fukui-kaneko"};
    if (models[static_cast<std::size_t>(model)].empty())
        throw CmlError(n[0].line, "the slip model must be 0, 1, 2 or 5, not " + std::to_string(model));
    fields.choose("air.slip", models[static_cast<std::size_t>(model)], n[0].line);
    fields.set("film.tolerance", n[1]);
    fields.set("steady.load_tolerance", n[2]);
    const int scheme = wholeCmlNumber(n[3], "the scheme", 1, 4);
    static constexpr std::array<std::string_view, 4> schemes{"complete-flux", "complete-flux", "upwind", "hybrid"};
    fields.choose("film.scheme", schemes[static_cast<std::size_t>(scheme - 1)], n[3].line);
    if (scheme <= 2)
        part.leaveOut(scheme == 1 ? "the power law as such; complete-flux is taken"
                                  : "central differences; complete-flux is taken");
}

void readDynamicsGrid(CmlPart& part)
{
    const Numbers n = part.sequence(7);
    part.fields().choose("film.grid", n[0].value != 0.0 ? "adapted" : "uniform", n[0].line);
    if (n[1].value != 0.0) part.leaveOut("symmetry (isymmetry); the whole width is solved");
    if (n[2].value != 0.0) part.leaveOut("an existing grid (ioldgrid)");
    setCmlNodes(part, n[3], n[4], 1);
    if (n[5].value > 1.0 || n[6].value > 1.0) part.leaveOut("grid sections (nsx, nsy)");
}

void readDynamicsAir(CmlPart& part)
{
    for (const CmlNamedNumber& each : part.namedNumbers()) {
        if (each.name.starts_with("p0"))
            part.fields().set("air.pressure", each.number);
        else if (each.name.starts_with("al") || each.name.starts_with("mfp") || each.name.starts_with("lambda"))
            part.fields().set("air.mean_free_path", each.number);
        else if (each.name.starts_with("vis"))
            part.fields().set("air.viscosity", each.number);
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

void readCmlDynamics(std::string_view text, CmlFields& fields)
{
    fields.setNumber("steady.shear_arm", 1.0, 0);
    readCmlSections(text, dynamicsSections, fields);
    settleCmlDisk(fields);
}

} // namespace touchdown
