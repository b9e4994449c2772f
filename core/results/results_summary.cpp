// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_summary.h"

#include <cmath>

namespace touchdown {
namespace {

void putFinite(const Hdf5Group& group, const std::string& name, double value, const std::string& unit,
               const std::string& longName)
{
    if (std::isfinite(value)) group.put(name, value, unit, longName);
}

void putCount(const Hdf5Group& group, const std::string& name, long long value, const std::string& longName)
{
    group.put(name, std::int64_t{value}, "1", longName);
}

Quantity quantityNamed(const std::vector<Quantity>& quantities, const std::string& name)
{
    const int i = findQuantity(quantities, name);
    return i >= 0 ? quantities[static_cast<std::size_t>(i)] : Quantity{name, "", "", name};
}

void writeEvents(const Hdf5Group& file, const std::vector<RunEvent>& events)
{
    const Hdf5Group group = file.create("events");
    std::vector<double> times;
    std::vector<std::string> names;
    for (const RunEvent& event : events) {
        times.push_back(event.time);
        names.push_back(event.name);
    }
    group.put("time", times, "s", "Time of the event");
    group.put("name", names, "1", "What happened");
}

void writePeaks(const Hdf5Group& summary, const std::vector<Quantity>& quantities, const std::vector<Peak>& peaks)
{
    const Hdf5Group group = summary.create("peaks");
    std::vector<double> frequencies, amplitudes;
    for (const Peak& peak : peaks) {
        frequencies.push_back(peak.frequency);
        amplitudes.push_back(peak.amplitude);
    }
    group.put("frequency", frequencies, "Hz", "Peaks of the minimum spacing's spectrum");
    group.put("amplitude", amplitudes, quantityNamed(quantities, "minimum_spacing").unit,
              "Amplitude of a sine with that peak");
}

void writeFit(const Hdf5Group& group, const CharacteristicFit& fit)
{
    const OnoYamane& p = fit.parameters;
    putFinite(group, "meniscus_force", p.meniscusForce, "N", "f_m of the fitted characteristic");
    putFinite(group, "contact_stiffness", p.contactStiffness, "N/m", "k_c of the fitted characteristic");
    putFinite(group, "initial_contact_force", p.initialContactForce, "N", "f_c0 of the fitted characteristic");
    putFinite(group, "touch_down", p.touchDown, "m", "d_s of the fitted characteristic");
    putFinite(group, "take_off", p.takeOff, "m", "d_e of the fitted characteristic");
    group.put("take_off_shape", std::string(name(p.takeOffShape)), "1",
              "Forces between d_s and d_e of the fitted characteristic");
    putFinite(group, "cycle_work", OnoYamaneLaw(p).cycleWork(), "J",
              "Work that a touch-down and take-off takes out of the slider");
    putFinite(group, "contact_error", fit.contact.worst, "",
              "Worst error of the contact force against its largest value");
    putFinite(group, "adhesion_error", fit.adhesion.worst, "", "Worst error of the adhesion against its largest value");
    putCount(group, "describes", fit.describes ? 1 : 0, "1 when the five parameters describe the model");
    group.put("message", fit.message, "1", "How well they do");
}

} // namespace

void writeSummary(const Hdf5Group& file, const std::vector<Quantity>& quantities, const Summary& summary)
{
    file.set("status", name(summary.status));
    file.set("message", summary.message);
    writeEvents(file, summary.events);

    const Hdf5Group group = file.create("summary");
    putFinite(group, "end_time", summary.endTime, "s", "Time reached");
    putCount(group, "steps", summary.steps, "Accepted steps");
    putCount(group, "rejected_steps", summary.rejectedSteps, "Rejected steps");
    putCount(group, "evaluations", summary.evaluations, "Evaluations of the right-hand side");
    putFinite(group, "solver_seconds", summary.solverSeconds, "s", "Wall time of the integration alone");
    putFinite(group, "wall_seconds", summary.wallSeconds, "s", "Wall time of the run");
    group.put("model", summary.model, "1", "Model");
    group.put("integrator", summary.integrator, "1", "Integrator");
    const MotionVerdict& verdict = summary.verdict;
    group.put("motion", std::string(name(verdict.motion)), "1", "How the motion ends");
    putCount(group, "bouncing", summary.bouncing() ? 1 : 0, "1 when the slider bounces on the disk to the end");
    group.put("bouncing_rule", verdict.rule, "1", "The rule that decided on the motion");
    if (verdict.motion != Motion::NotJudged) {
        group.put("contact", std::string(name(verdict.touch)), "1", "Contact in the judged last part of the run");
        putCount(group, "forced", verdict.forced ? 1 : 0, "1 when the moving surface of the disk drives the motion");
        putFinite(group, "swing", verdict.swing, "m", "Minimum spacing in the judged part, peak to peak");
        putFinite(group, "rms", verdict.rms, "m", "Minimum spacing in the judged part, standard deviation");
        putFinite(group, "frequency", verdict.frequency, "Hz", "Main frequency of the motion there; 0: none");
    }
    group.put("warnings", summary.warnings, "1", "Warnings");
    writePeaks(group, quantities, summary.peaks);
    if (!summary.figures.empty()) {
        const Hdf5Group figures = group.create("figures");
        for (const RunFigure& figure : summary.figures)
            figures.put(figure.quantity.name, figure.value, figure.quantity.unit, figure.quantity.longName);
    }
    if (summary.fit) writeFit(group.create("fit"), *summary.fit);

    const Hdf5Group final = group.create("final");
    for (const auto& [key, value] : summary.final) {
        const Quantity quantity = quantityNamed(quantities, key);
        putFinite(final, key, value, quantity.unit, quantity.longName + " at the end");
    }
    const auto putExtremes = [](const Hdf5Group& one, const Quantity& quantity, double least, double most,
                                const std::string& span) {
        putFinite(one, "min", least, quantity.unit, quantity.longName + ", minimum of the " + span);
        putFinite(one, "max", most, quantity.unit, quantity.longName + ", maximum of the " + span);
    };
    const Hdf5Group extremes = group.create("extremes");
    for (const auto& [key, value] : summary.extremes)
        putExtremes(extremes.create(key), quantityNamed(quantities, key), value.least, value.most, "whole run");
    const Hdf5Group tail = group.create("tail");
    for (const auto& [key, value] : summary.tail) {
        const Quantity quantity = quantityNamed(quantities, key);
        const Hdf5Group one = tail.create(key);
        putFinite(one, "mean", value.mean, quantity.unit, quantity.longName + ", mean of the last 10 %");
        putFinite(one, "std", value.std, quantity.unit, quantity.longName + ", standard deviation of the last 10 %");
        putExtremes(one, quantity, value.min, value.max, "last 10 %");
    }
}

} // namespace touchdown
