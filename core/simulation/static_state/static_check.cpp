// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/static_check.h"

#include <cmath>

#include "core/case/case.h"
#include "core/formats/units.h"
#include "core/physics/film/gas_film.h"
#include "core/simulation/static_state/slider_body.h"
#include "core/simulation/static_state/steady_result.h"

namespace touchdown {

namespace {

Attitude startOf(const Case& c) { return {c.initial.nominalTrailingEdgeHeight, c.initial.pitch, c.initial.roll}; }

std::string placeWords(const SurfacePoint& at)
{
    return "x = " + fewDigits(at.x, "mm", 4) + ", y = " + fewDigits(at.y, "mm", 4);
}

std::string depthWords(const MinimumSpacing::Place& lowest)
{
    return (lowest.spacing < 0.0 ? fewDigits(-lowest.spacing, "nm", 3) + " below" : std::string("at")) +
           " its mean plane at " + placeWords(lowest.at);
}

} // namespace

std::string attitudeWords(const Attitude& attitude)
{
    return "trailing edge height " + fewDigits(attitude.height, "nm", 4) + ", pitch " +
           fewDigits(attitude.pitch, "urad", 4) + ", roll " + fewDigits(attitude.roll, "urad", 4);
}

std::string whyNoStaticState(const Case& c, const MinimumSpacing& spacing)
{
    if (!c.steady.fixedAttitude) {
        if (c.disk.speed != 0.0) return {};
        return "there is no flying attitude over a disk at rest (disk.speed is 0 rpm): no air bearing forms, and the "
               "film carries nothing" +
               (c.suspension.preload != 0.0 ? " of the preload of " + fewDigits(c.suspension.preload, "gf", 4)
                                            : std::string());
    }
    if (c.contact != noContact) return {};
    const MinimumSpacing::Place lowest = spacing.at(startOf(c));
    if (lowest.spacing > 0.0) return {};
    return "the rails are inside the disk, " + depthWords(lowest) +
           ", at the fixed attitude: " + attitudeWords(startOf(c)) +
           "; the film needs an open gap everywhere, as the case has no contact law; " +
           "raise initial.nominal_trailing_edge_height above " +
           fewDigits(c.initial.nominalTrailingEdgeHeight - lowest.spacing, "nm", 4);
}

std::optional<Attitude> unloadedRest(const Case& c)
{
    const SuspensionCase& s = c.suspension;
    if (c.disk.speed != 0.0 || s.preload != 0.0) return std::nullopt;
    Attitude rest = startOf(c);
    if (s.holdsAttitude) {
        if (s.pitchStiffness > 0.0) rest.pitch = s.staticPitch;
        if (s.rollStiffness > 0.0 && c.degreesOfFreedom == 3) rest.roll = s.staticRoll;
    } else if (s.pitchTorque != 0.0 || (s.rollTorque != 0.0 && c.degreesOfFreedom == 3)) {
        return std::nullopt;
    }
    return rest;
}

std::string noteOnClosedGap(const Case& c, const MinimumSpacing& spacing)
{
    if (!c.steady.fixedAttitude) return {};
    const MinimumSpacing::Place lowest = spacing.at(startOf(c));
    if (lowest.spacing > 0.0) return {};
    return "the rails are inside the disk, " + depthWords(lowest) + ": there the film is solved with a gap of " +
           fewDigits(moleculeGap, "nm", 2) + ", and the forces are those of the film without contact";
}

std::string noteOnHeldRoll(const Case& c, const SteadyResult& state)
{
    // The film of a pico slider would balance such a torque with a roll of about 1 urad: 0.5 nm at its sides. A grid
    // of 65 x 65 nodes, which is not its own mirror image, makes less than a tenth of it on a symmetric slider.
    constexpr double leastTold = 1e-3; // of the film's force times the width [-]
    const SliderLoad load = sliderLoad(c);
    if (c.steady.fixedAttitude || !load.holdsRoll) return {};
    const double torque = state.forces.rollTorque + state.shearRollTorque + state.contact.rollTorque + load.rollTorque -
                          load.rollStiffness * (state.attitude.roll - load.staticRoll);
    double force = state.forces.net;
    if (state.contact.acts()) force += state.contact.contact + state.contact.adhesion;
    if (!(std::abs(torque) > leastTold * std::abs(force) * c.slider.width)) return {};
    return "two degrees of freedom hold the roll at " + fewDigits(state.attitude.roll, "urad", 4) +
           " and leave a roll torque of " + fewDigits(torque, "uN m", 4) +
           " unbalanced: " + (state.contact.acts() ? "film and contact carry " : "the film carries ") +
           fewDigits(std::abs(torque / force), "um", 3) +
           " beside the centre line of the load; with three degrees of freedom the slider rolls until it is balanced";
}

std::string lastStateWords(const Case& c, const SteadyResult& state)
{
    return "the last attitude with rails above the disk was: " + attitudeWords(state.attitude) + ", minimum spacing " +
           fewDigits(state.minimumSpacing, "nm", 3) + ", net force of the film " +
           fewDigits(state.forces.net, "gf", 4) + " for a preload of " + fewDigits(c.suspension.preload, "gf", 4);
}

} // namespace touchdown
