// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that contradict each other although each is in its range, and values without effect.
#include "core/case/parameters.h"

#include "core/case/contact_check.h"
#include "core/case/contact_law.h"
#include "core/case/integrator_kind.h"
#include "core/case/ridge_check.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/physics/disk/disk_passage.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/slider/surface_check.h"

#include <algorithm>

namespace touchdown {

namespace {

constexpr double mostSamples = 1e8;
constexpr double mostSteps = 1e11;
constexpr std::size_t mostStates = 10000; // of a series

struct Spring {
    std::string name; // "front"
    std::string distanceKey;
    double stiffness;
    double distance; // from the mass centre, positive towards the leading edge [m]
};

/// The air force k_0 z_0^2/z^2 (z_0 - z) exists only above d_1, so both the static state and the start must be there:
/// z = FH + (d_h + distance) theta, with FH at the contact pad, d_h behind the mass centre (Chen & Bogy, equation (1)).
void checkSpacing(const Case& c, const Spring& spring, std::vector<CaseProblem>& problems)
{
    if (spring.stiffness <= 0.0) return;
    const double arm = c.springs.padDistance + spring.distance;
    const double still = c.springs.flyingHeight + arm * c.springs.pitch;
    const double start = c.initial.flyingHeight + arm * c.initial.pitch;
    const auto check = [&](const std::string& state, double spacing, const std::string& group) {
        if (spacing > c.springs.cutoff) return;
        const std::string height = group + ".flying_height", pitch = group + ".pitch";
        problems.push_back({height,
                            "the " + state + " spacing at the " + spring.name + " air bearing spring is " +
                                inNanometres(spacing) + ", which must be greater than springs.cutoff (d_1 = " +
                                inNanometres(c.springs.cutoff) + "); it follows from " + height + ", " + pitch + ", " +
                                spring.distanceKey + " and ono_yamane.pad_distance",
                            {"springs.cutoff", pitch, spring.distanceKey, "ono_yamane.pad_distance"}});
    };
    check("static", still, "springs");
    check("initial", start, "initial");
}

void checkTimes(const Case& c, std::vector<CaseProblem>& problems)
{
    const RunCase& run = c.run;
    const std::string duration = "run.duration (" + formatQuantity(run.duration, "ms") + ")";
    const auto add = [&](const char* key, const std::string& message) {
        problems.push_back({key, message, {"run.duration"}});
    };
    if (findParameter("run.step")->used(c)) {
        if (run.step > run.duration) add("run.step", "must be at most " + duration);
        if (run.duration / run.step > mostSteps)
            add("run.step", "makes more than 1e11 steps of " + duration + "; take a longer step");
    }
    if (run.sampleInterval > run.duration) add("run.sample_interval", "must be at most " + duration);
    if (run.duration / run.sampleInterval > mostSamples)
        add("run.sample_interval", "makes more than 1e8 samples of " + duration + "; take a longer interval");
    if (findParameter("spectrum.start")->used(c) && c.spectrum.start >= run.duration)
        add("spectrum.start", "must be less than " + duration);
}

/// What the equations of the springs and their steps ask of a surface that moves. Its file is not read here.
void checkDiskOfSprings(const Case& c, std::vector<CaseProblem>& problems)
{
    const std::size_t before = problems.size();
    checkMovingDisk(c, problems);
    const DiskSurface& surface = c.diskSurface;
    if (problems.size() > before || surface.motion == SurfaceMotion::Still) return;
    if (hasBumps(surface) && surface.bumpShape == BumpShape::Ellipsoid)
        problems.push_back(
            {"disk.surface.bump_shape",
             "must be \"gaussian\" or \"cosine\" where bumps move under springs: an ellipsoid is vertical "
             "at its base, so that the dashpots' forces would be infinite there",
             {"disk.surface.motion", "model"}});
    const SliderCase& slider = c.slider;
    const double longest = finestPassage(
        surface, diskVelocity(c.disk, slider.length, slider.width, 0.5 * slider.length, 0.5 * slider.width));
    if (hasFixedStep(c.run.integrator) && c.run.step > longest)
        problems.push_back({"run.step",
                            "must be at most " + fewDigits(longest / 1.005, "ns", 3) +
                                ", in which a sixteenth of the shortest wave or bump of disk.surface, or half a cell "
                                "of its map, passes under the slider",
                            {"disk.surface", "disk.speed", "run.integrator"}});
}

void checkSprings(const Case& c, std::vector<CaseProblem>& problems)
{
    if (c.degreesOfFreedom != 2)
        problems.push_back(
            {"degrees_of_freedom", "must be 2 with model \"springs\", which has height and pitch only", {"model"}});
    checkCharacteristic(c, problems);
    const SpringsCase& s = c.springs;
    checkSpacing(c, {"front", "springs.front_distance", s.frontStiffness, s.frontDistance}, problems);
    checkSpacing(c, {"rear", "springs.rear_distance", s.rearStiffness, -s.rearDistance}, problems);
    if (c.diskSurface.kind != DiskSurfaceKind::Flat) checkDiskOfSprings(c, problems);
    checkTimes(c, problems);
}

void checkSeries(const SteadyCase& steady, std::vector<CaseProblem>& problems)
{
    if (!steady.skews.empty() && steady.skews.size() != steady.radii.size())
        problems.push_back({"steady.skews",
                            "has " + counted(steady.skews.size(), "number") + "; steady.radii has " +
                                std::to_string(steady.radii.size()) + ", and each radius has one skew",
                            {"steady.radii"}});
    const auto length = [](const std::vector<double>& list) { return std::max<std::size_t>(list.size(), 1); };
    const std::size_t states = length(steady.radii) * length(steady.speeds) * length(steady.altitudes);
    if (states > mostStates)
        problems.push_back({"steady.radii",
                            "makes " + std::to_string(states) +
                                " static states with steady.speeds and steady.altitudes; at most " +
                                std::to_string(mostStates) + " are possible",
                            {"steady.speeds", "steady.altitudes"}});
}

void checkSliderSurface(const Case& c, std::vector<CaseProblem>& problems)
{
    if (c.surface.taperLength > c.slider.length)
        problems.push_back({"abs.taper_length",
                            "must be at most slider.length (" + formatQuantity(c.slider.length, "mm") + ")",
                            {"slider.length"}});
    for (const auto& [key, sentence, places] : surfaceProblems(c.surface))
        problems.push_back({key, sentence.substr(0, sentence.find_last_not_of('.') + 1)});
}

/// The linear film answers to the waves of a disk that moves; roughness it may leave to the contact.
void checkLinearFilm(const Case& c, std::vector<CaseProblem>& problems)
{
    const DiskSurface& disk = c.diskSurface;
    if (c.film.motion != FilmMotion::Linear || disk.kind == DiskSurfaceKind::Flat) return;
    const bool moves = disk.motion == SurfaceMotion::Moving, touches = c.contact != noContact;
    const bool answers = disk.kind == DiskSurfaceKind::Waves && !(touches && contactLaw(c).recordsSurfaces),
               leaves = disk.kind == DiskSurfaceKind::Rough && touches && contactLaw(c).seesDisk;
    if (moves && (answers || leaves)) return;
    problems.push_back({"film.motion",
                        "must be \"full\" over this surface of the disk: a linear film answers to waves of a disk that "
                        "moves, without elastic contact, and leaves roughness to a contact that sees it",
                        {"disk.surface.kind", "disk.surface.motion", "contact"}});
}

void checkFilm(const Case& c, std::vector<CaseProblem>& problems)
{
    if (!slipLaw(c.air.slip.model).knowsAccommodation && c.air.slip.accommodation != 1.0)
        problems.push_back({"air.accommodation",
                            "must be 1 with this air.slip (" + toText(c, *findParameter("air.slip")) +
                                "), which assumes diffuse walls",
                            {"air.slip"}});
    if (c.initial.state == InitialState::Static && c.steady.fixedAttitude)
        problems.push_back({"initial.state",
                            "must be \"given\" with steady.fixed_attitude, which computes no static attitude",
                            {"steady.fixed_attitude"}});
    checkSliderSurface(c, problems);
    checkSeries(c.steady, problems);
    checkTimes(c, problems);
    checkLinearFilm(c, problems);
    checkFilmContact(c, problems);
}

/// The choices of one parameter with which another would be used, as "a = \"x\" or \"y\""; empty if there are none.
std::string choicesFor(const Case& c, const Parameter& wanted, const Parameter& chosen)
{
    std::string names;
    Case other = c;
    const auto consider = [&](const ParameterValue& value, const std::string& name) {
        chosen.set(other, value);
        if (wanted.used(other)) names += (names.empty() ? chosen.key + " = " : " or ") + name;
    };
    for (const std::string& choice : chosen.choices) consider(choice, '"' + choice + '"');
    if (chosen.kind == ParameterKind::Boolean)
        for (const bool value : {false, true}) consider(value, value ? "true" : "false");
    return names;
}

} // namespace

std::string unusedMessage(const Case& c, const Parameter& parameter)
{
    if (parameter.used(c)) return {};
    const std::string message = "has no effect here";
    // Later choices depend on earlier ones: the search starts at the last parameter and reaches the model last.
    for (auto chosen = parameters().rbegin(); chosen != parameters().rend(); ++chosen)
        if (chosen->used(c))
            if (const std::string choices = choicesFor(c, parameter, *chosen); !choices.empty())
                return message + ", only with " + choices;
    return message;
}

std::vector<CaseProblem> checkCombinations(const Case& c)
{
    std::vector<CaseProblem> problems;
    if (const auto refused = contactRefusal(c)) problems.push_back({"contact", *refused, {"model"}});
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

std::vector<CaseProblem> caseWarnings(const Case& c)
{
    std::vector<CaseProblem> warnings;
    if (const auto law = characteristic(c)) warnOfCreatedEnergy(*law, warnings);
    if (c.model == ModelKind::Film) warnOfRidges(c, warnings);
    return warnings;
}

} // namespace touchdown
