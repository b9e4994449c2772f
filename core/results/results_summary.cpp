// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_layout.h"

#include <cmath>

namespace touchdown {
namespace {

void writeNumber(hid_t group, const char* name, double value, const std::string& unit, const std::string& longName)
{
    if (!std::isfinite(value)) return; // never a NaN in a file
    describeHdf5(writeHdf5Scalar(group, name, value), unit.empty() ? "1" : unit, longName);
}

void writeCount(hid_t group, const char* name, long long value, const std::string& longName)
{
    describeHdf5(writeHdf5Scalar(group, name, std::int64_t{value}), "1", longName);
}

void writeText(hid_t group, const char* name, const std::string& value, const std::string& longName)
{
    describeHdf5(writeHdf5Scalar(group, name, value), "1", longName);
}

Quantity known(const std::vector<Quantity>& quantities, const std::string& name)
{
    const int i = findQuantity(quantities, name);
    return i >= 0 ? quantities[static_cast<std::size_t>(i)] : Quantity{name, "", "", name};
}

void writeEvents(hid_t file, const std::vector<RunEvent>& events)
{
    const Hdf5Handle group = createHdf5Group(file, "events");
    std::vector<double> times;
    std::vector<std::string> names;
    for (const RunEvent& event : events) {
        times.push_back(event.time);
        names.push_back(event.name);
    }
    describeHdf5(writeHdf5Array(group, "time", times), "s", "Time of the event");
    describeHdf5(writeHdf5Array(group, "name", names), "1", "What happened");
}

void writePeaks(hid_t group, const std::vector<Quantity>& quantities, const std::vector<SpectrumPeak>& peaks)
{
    std::vector<double> frequencies;
    std::vector<double> amplitudes;
    for (const SpectrumPeak& peak : peaks) {
        frequencies.push_back(peak.frequency);
        amplitudes.push_back(peak.amplitude);
    }
    const Hdf5Handle both = createHdf5Group(group, "peaks");
    describeHdf5(writeHdf5Array(both, "frequency", frequencies), "Hz", "Peaks of the minimum spacing's spectrum");
    describeHdf5(writeHdf5Array(both, "amplitude", amplitudes), known(quantities, "minimum_spacing").unit,
                 "Amplitude of a sine with that peak");
}

void writeFigures(hid_t group, const std::vector<RunFigure>& figures)
{
    if (figures.empty()) return;
    const Hdf5Handle all = createHdf5Group(group, "figures");
    for (const auto& [quantity, value] : figures)
        writeNumber(all, quantity.name.c_str(), value, quantity.unit, quantity.longName);
}

void writeFit(hid_t group, const CharacteristicFit& fit)
{
    const Hdf5Handle all = createHdf5Group(group, "fit");
    const OnoYamane& p = fit.parameters;
    writeNumber(all, "meniscus_force", p.meniscusForce, "N", "f_m of the fitted characteristic");
    writeNumber(all, "contact_stiffness", p.contactStiffness, "N/m", "k_c of the fitted characteristic");
    writeNumber(all, "initial_contact_force", p.initialContactForce, "N", "f_c0 of the fitted characteristic");
    writeNumber(all, "touch_down", p.touchDown, "m", "d_s of the fitted characteristic");
    writeNumber(all, "take_off", p.takeOff, "m", "d_e of the fitted characteristic");
    writeText(all, "take_off_shape", p.takeOffShape == TakeOffShape::Constant ? "constant" : "linear",
              "Adhesion between d_s and d_e of the fitted characteristic");
    writeNumber(all, "contact_error", fit.contact.worst, "",
                "Worst error of the contact force against its largest value");
    writeNumber(all, "adhesion_error", fit.adhesion.worst, "", "Worst error of the adhesion against its largest value");
    writeCount(all, "describes", fit.describes ? 1 : 0, "1 when the five parameters describe the model");
    writeText(all, "message", fit.message, "How well they do");
}

} // namespace

void writeSummary(hid_t file, const std::vector<Quantity>& quantities, const Summary& summary)
{
    writeHdf5Attribute(file, "status", std::string(name(summary.status)));
    writeHdf5Attribute(file, "message", summary.message);
    writeEvents(file, summary.events);

    const Hdf5Handle group = createHdf5Group(file, "summary");
    writeNumber(group, "end_time", summary.endTime, "s", "Time reached");
    writeCount(group, "steps", summary.steps, "Accepted steps");
    writeCount(group, "rejected_steps", summary.rejectedSteps, "Rejected steps");
    writeCount(group, "evaluations", summary.evaluations, "Evaluations of the right-hand side");
    writeNumber(group, "solver_seconds", summary.solverSeconds, "s", "Wall time of the integration alone");
    writeNumber(group, "wall_seconds", summary.wallSeconds, "s", "Wall time of the run");
    writeText(group, "model", summary.model, "Model");
    writeText(group, "integrator", summary.integrator, "Integrator");
    writeCount(group, "bouncing", summary.bouncing ? 1 : 0, "1 when the motion is sustained");
    writeText(group, "bouncing_rule", summary.bouncingRule, "The rule that decided on bouncing");
    describeHdf5(writeHdf5Array(group, "warnings", summary.warnings), "1", "Warnings");
    writePeaks(group, quantities, summary.peaks);
    writeFigures(group, summary.figures);
    if (summary.fit) writeFit(group, *summary.fit);

    const Hdf5Handle final = createHdf5Group(group, "final");
    for (const auto& [key, value] : summary.final) {
        const Quantity quantity = known(quantities, key);
        writeNumber(final, key.c_str(), value, quantity.unit, quantity.longName + " at the end");
    }
    const Hdf5Handle tail = createHdf5Group(group, "tail");
    for (const auto& [key, value] : summary.tail) {
        const Quantity quantity = known(quantities, key);
        const Hdf5Handle one = createHdf5Group(tail, key);
        writeNumber(one, "mean", value.mean, quantity.unit, quantity.longName + ", mean of the last 10 %");
        writeNumber(one, "std", value.std, quantity.unit, quantity.longName + ", standard deviation of the last 10 %");
        writeNumber(one, "min", value.min, quantity.unit, quantity.longName + ", minimum of the last 10 %");
        writeNumber(one, "max", value.max, quantity.unit, quantity.longName + ", maximum of the last 10 %");
    }
}

} // namespace touchdown
