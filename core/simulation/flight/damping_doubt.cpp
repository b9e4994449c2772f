// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/damping_doubt.h"

#include <algorithm>
#include <cmath>

#include "core/case/case.h"
#include "core/formats/units.h"
#include "core/numerics/spectrum.h"

namespace touchdown {

namespace {

constexpr double largeShare = 0.1;     // of the largest peak
constexpr double oftenUnfitted = 0.1;  // of a run's time
constexpr double enoughPerPeriod = 60; // steps with which BDF2OPT keeps a damping ratio to a twentieth or 5e-5

std::string kilohertz(double frequency) { return std::to_string(std::lround(frequency / 1e3)) + " kHz"; }

std::string doubtOnSteps(const Case& c, double frequency, const UnfittedSteps& unfitted, double duration)
{
    const double perPeriod = static_cast<double>(unfitted.count) / (unfitted.time * frequency);
    if (!(unfitted.time > oftenUnfitted * duration) || perPeriod >= enoughPerPeriod) return {};
    const bool staggered = c.film.coupling == FilmCoupling::Staggered, fixed = c.run.steps == StepControl::Fixed;
    const std::string shorter = fewDigitsOfTime(1.0 / (enoughPerPeriod * frequency), 2);
    return "the steps in time change the damping of the motion at " + kilohertz(frequency) + ": in " +
           std::to_string(std::lround(100.0 * unfitted.time / duration)) + " % of the run there were " +
           std::to_string(std::lround(perPeriod)) + " steps a period, not fitted to it; " +
           (staggered ? "film.coupling = \"monolithic\" fits them, or "
            : fixed   ? "run.steps = \"adaptive\" fits them, or "
                      : "those that differ from the last one by more than a quarter are not; ") +
           "fixed steps of " + shorter + " are short enough";
}

} // namespace

std::vector<std::string> doubtsOnDamping(const Case& c, const std::vector<Peak>& peaks, double resolved,
                                         const UnfittedSteps& unfitted, double duration)
{
    std::vector<std::string> doubts;
    if (peaks.empty()) return doubts;
    double fastest = 0.0;
    for (const Peak& peak : peaks)
        if (peak.amplitude >= largeShare * peaks.front().amplitude) fastest = std::max(fastest, peak.frequency);
    if (fastest > resolved)
        doubts.push_back("the damping of the motion at " + kilohertz(fastest) + " depends on the grid: above " +
                         kilohertz(resolved) +
                         " a wave that the air carries along the slider spans fewer than six cells; the modes of the "
                         "case state the error of this grid, and more film.nodes along the slider make it smaller");
    if (std::string doubt = doubtOnSteps(c, fastest, unfitted, duration); !doubt.empty())
        doubts.push_back(std::move(doubt));
    return doubts;
}

} // namespace touchdown
