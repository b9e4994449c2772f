// SPDX-License-Identifier: GPL-3.0-or-later
//
// Combinations of values that make no sense, although each is in its range; values that have no effect beside others.
#include "core/case/fields.h"

#include "core/case/contact_check.h"
#include "core/formats/decimal.h"
#include "core/formats/units.h"
#include "core/physics/slider/surface_check.h"

#include <algorithm>

namespace touchdown {

namespace {

constexpr double mostSamples = 1e8;
constexpr double mostSteps = 1e11;
constexpr std::size_t mostStates = 10000; // of a series

/// To four digits, for a message.
std::string inNanometres(double length) { return decimalText(length, 9, 4) + " nm"; }

/// An air bearing spring, with the keys that describe it.
struct Spring {
    std::string_view name; // "front"
    std::string_view stiffnessKey;
    std::string_view distanceKey;
    double stiffness;
    double distance; // from the mass centre, positive towards the leading edge [m]
};

/// The air force k_0 z_0^2/z^2 (z_0 - z) exists above d_1 alone, so both the static state and the start must be there:
/// z = FH + (d_h + distance) theta, with FH at the contact pad, d_h behind the mass centre (Chen & Bogy, equation (1)).
void checkSpacing(const Case& c, const Spring& spring, std::vector<CaseProblem>& problems)
{
    if (spring.stiffness <= 0.0) return;
    const double arm = c.onoYamane.padDistance + spring.distance;
    const double still = c.springs.flyingHeight + arm * c.springs.pitch;
    const double start = c.initial.flyingHeight + arm * c.initial.pitch;
    const std::string beyond = " air bearing spring is %1, which must be greater than springs.cutoff (d_1 = " +
                               inNanometres(c.springs.cutoff) + "); ";
    const auto message = [&](std::string_view what, double spacing, std::string_view group) {
        std::string text = std::string(what) + " spacing at the " + std::string(spring.name) + beyond;
        text.replace(text.find("%1"), 2, inNanometres(spacing));
        return text + "it follows from " + std::string(group) + ".flying_height, " + std::string(group) + ".pitch, " +
               std::string(spring.distanceKey) + " and ono_yamane.pad_distance";
    };
    if (still <= c.springs.cutoff)
        problems.push_back({"springs.flying_height", message("the static", still, "springs")});
    if (start <= c.springs.cutoff)
        problems.push_back({"initial.flying_height", message("the initial", start, "initial")});
}

void checkTimes(const Case& c, std::vector<CaseProblem>& problems)
{
    const RunCase& run = c.run;
    const std::string duration = "run.duration (" + formatQuantity(run.duration, "ms") + ")";
    if (findField("run.step")->used(c)) {
        if (run.step > run.duration) problems.push_back({"run.step", "must be at most " + duration});
        if (run.duration / run.step > mostSteps)
            problems.push_back({"run.step", "makes more than 1e11 steps of " + duration + "; take a longer step"});
    }
    if (run.sampleInterval > run.duration) problems.push_back({"run.sample_interval", "must be at most " + duration});
    if (run.duration / run.sampleInterval > mostSamples)
        problems.push_back(
            {"run.sample_interval", "makes more than 1e8 samples of " + duration + "; take a longer interval"});
    if (findField("spectrum.start")->used(c) && c.spectrum.start >= run.duration)
        problems.push_back({"spectrum.start", "must be less than " + duration});
}

void checkSprings(const Case& c, std::vector<CaseProblem>& problems)
{
    if (c.degreesOfFreedom != 2)
        problems.push_back(
            {"degrees_of_freedom", "must be 2 with model \"springs\", which has height and pitch alone"});
    if (c.contact == ContactKind::OnoYamane) checkCharacteristic(c.onoYamane, problems);
    if (c.contact != ContactKind::OnoYamane && c.contact != ContactKind::None)
        problems.push_back({"contact",
                            "must be \"none\" or \"ono-yamane\" with model \"springs\"; elastic belongs to models "
                            "\"film\" and \"contact\", asperity and multi-asperity to model \"contact\""});
    checkSpacing(c,
                 {"front", "springs.front_stiffness", "springs.front_distance", c.springs.frontStiffness,
                  c.springs.frontDistance},
                 problems);
    checkSpacing(
        c,
        {"rear", "springs.rear_stiffness", "springs.rear_distance", c.springs.rearStiffness, -c.springs.rearDistance},
        problems);
    checkTimes(c, problems);
}

void checkSeries(const SteadyCase& steady, std::vector<CaseProblem>& problems)
{
    const auto counted = [](std::size_t count) { return std::to_string(count); };
    if (!steady.skews.empty() && steady.skews.size() != steady.radii.size())
        problems.push_back({"steady.skews", "has " + counted(steady.skews.size()) + " numbers; steady.radii has " +
                                                counted(steady.radii.size()) + ", and each radius has one skew"});
    const auto length = [](const std::vector<double>& list) { return std::max<std::size_t>(list.size(), 1); };
    const std::size_t states = length(steady.radii) * length(steady.speeds) * length(steady.altitudes);
    if (states > mostStates)
        problems.push_back({"steady.radii", "makes " + counted(states) +
                                                " static states with steady.speeds and steady.altitudes; at most " +
                                                counted(mostStates) + " are possible"});
}

void checkSliderSurface(const Case& c, std::vector<CaseProblem>& problems)
{
    if (c.surface.taperLength > c.slider.length)
        problems.push_back(
            {"abs.taper_length", "must be at most slider.length (" + formatQuantity(c.slider.length, "mm") + ")"});
    for (const auto& [key, sentence] : surfaceProblems(c.surface))
        problems.push_back({key, sentence.substr(0, sentence.find_last_not_of('.') + 1)});
}

void checkFilm(const Case& c, std::vector<CaseProblem>& problems)
{
    if (!slipLaw(c.air.slip.model).knowsAccommodation && c.air.slip.accommodation != 1.0)
        problems.push_back({"air.accommodation", "must be 1 with this air.slip (" + toText(c, *findField("air.slip")) +
                                                     "), which knows diffuse walls alone"});
    if (c.initial.state == InitialState::Static && c.steady.fixedAttitude)
        problems.push_back(
            {"initial.state", "must be \"given\" with steady.fixed_attitude, which looks for no static attitude"});
    checkSliderSurface(c, problems);
    checkSeries(c.steady, problems);
    checkTimes(c, problems);
    checkFilmContact(c, problems);
}

/// The choices of one field with which another would be used, as "a = \"x\" or \"y\""; empty if there are none.
std::string choicesFor(const Case& c, const Field& wanted, const Field& chosen)
{
    std::string names;
    Case other = c;
    const auto consider = [&](const FieldValue& value, const std::string& name) {
        chosen.set(other, value);
        if (wanted.used(other)) names += (names.empty() ? chosen.key + " = " : " or ") + name;
    };
    for (const std::string& choice : chosen.choices) consider(choice, '"' + choice + '"');
    if (chosen.kind == FieldKind::Boolean)
        for (const bool value : {false, true}) consider(value, value ? "true" : "false");
    return names;
}

} // namespace

std::string unusedMessage(const Case& c, const Field& field)
{
    if (field.used(c)) return {};
    const std::string message = "has no effect here";
    // What is chosen last hangs on what was chosen before: the nearest condition is behind the model.
    for (auto chosen = fields().rbegin(); chosen != fields().rend(); ++chosen)
        if (chosen->used(c))
            if (const std::string choices = choicesFor(c, field, *chosen); !choices.empty())
                return message + ", only with " + choices;
    return message;
}

std::vector<CaseProblem> checkCombinations(const Case& c)
{
    std::vector<CaseProblem> problems;
    switch (c.model) {
    case ModelKind::Springs: checkSprings(c, problems); break;
    case ModelKind::Film: checkFilm(c, problems); break;
    case ModelKind::Contact:
        if (usesSliderSurface(c)) checkSliderSurface(c, problems);
        checkTimes(c, problems);
        checkContact(c, problems);
        break;
    }
    return problems;
}

} // namespace touchdown
