// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/kinetic_flow_rate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace touchdown {

namespace {

/// Q_P without the continuum's D/6, which is left to be interpolated, and its derivative by ln D.
struct Excess {
    double value, logSlope;
};

/// At D = 1e-4, each next one 10^(1/8) larger, up to D = 100: tests/support/kinetic_flow_rate.py.
constexpr std::array<Excess, 49> kineticExcess{{
    {5.5572782797, -0.5617106785}, {5.3956903349, -0.5610956541}, {5.2342994670, -0.5603365259},
    {5.0731514796, -0.5594023329}, {4.9123018943, -0.5582563826}, {4.7518177093, -0.5568554938},
    {4.5917793762, -0.5551492395}, {4.4322829895, -0.5530792357}, {4.2734426684, -0.5505785307},
    {4.1153930898, -0.5475711697}, {3.9582921128, -0.5439720231}, {3.8023234004, -0.5396869845},
    {3.6476989183, -0.5346136549}, {3.4946611513, -0.5286426362}, {3.3434848464, -0.5216595512},
    {3.1944780564, -0.5135478893}, {3.0479822385, -0.5041927438}, {2.9043711461, -0.4934854512},
    {2.7640482612, -0.4813290771}, {2.6274425424, -0.4676446069}, {2.4950023150, -0.4523776196},
    {2.3671872059, -0.4355051444}, {2.2444581208, -0.4170423463}, {2.1272653662, -0.3970486719},
    {2.0160351224, -0.3756331048}, {1.9111545687, -0.3529582344}, {1.8129560370, -0.3292429012},
    {1.7217006359, -0.3047631877}, {1.6375618653, -0.2798514177}, {1.5606098797, -0.2548925011},
    {1.4907973282, -0.2303163436}, {1.4279482010, -0.2065840837}, {1.3717519200, -0.1841647466},
    {1.3217660493, -0.1634979221}, {1.2774322759, -0.1449383358}, {1.2381111112, -0.1286816554},
    {1.2031397309, -0.1146807258}, {1.1719121803, -0.1025808558}, {1.1439691059, -0.0917297312},
    {1.1190654219, -0.0813310094}, {1.0971696339, -0.0707581867}, {1.0783643133, -0.0598875932},
    {1.0626820072, -0.0491671247}, {1.0499794409, -0.0392939150}, {1.0399306887, -0.0307827339},
    {1.0321125464, -0.0237942830}, {1.0260965751, -0.0182306939}, {1.0215012628, -0.0138846665},
    {1.0180088253, -0.0105305686},
}};
constexpr double firstInverseKnudsen = 1e-4, lastInverseKnudsen = 100.0, slipFlowInverseKnudsen = 1000.0;
constexpr double spacing = std::numbers::ln10 / 8.0; // in ln D

constexpr double freeMolecularSlope = -std::numbers::inv_sqrtpi; // dQ_P/d ln D

Excess slipFlow(double d) { return {1.0162 + 1.0653 / d, -1.0653 / d}; }

/// Cubic with the values and slopes of both ends; `fraction` of the distance `width` in ln D.
Excess between(Excess a, Excess b, double fraction, double width)
{
    const double t = fraction, ga = a.logSlope * width, gb = b.logSlope * width, rise = b.value - a.value;
    const double c2 = 3.0 * rise - 2.0 * ga - gb, c3 = ga + gb - 2.0 * rise;
    return {a.value + t * (ga + t * (c2 + t * c3)), (ga + t * (2.0 * c2 + t * 3.0 * c3)) / width};
}

Excess excess(double d)
{
    if (d >= slipFlowInverseKnudsen) return slipFlow(d);
    if (d >= lastInverseKnudsen) {
        const double width = std::log(slipFlowInverseKnudsen / lastInverseKnudsen);
        return between(kineticExcess.back(), slipFlow(slipFlowInverseKnudsen), std::log(d / lastInverseKnudsen) / width,
                       width);
    }
    const double place = std::log(d / firstInverseKnudsen) / spacing;
    const std::size_t i = std::min(static_cast<std::size_t>(place), kineticExcess.size() - 2);
    return between(kineticExcess[i], kineticExcess[i + 1], place - static_cast<double>(i), spacing);
}

/// -ln(D)/sqrt(pi) + constant + what is linear in D, so that it meets `at` with its slope.
FlowRate freeMolecules(double d, double limit, FlowRate at)
{
    const double linear = (at.logSlope - freeMolecularSlope) * d / limit;
    return {at.value + freeMolecularSlope * std::log(d / limit) + linear - (at.logSlope - freeMolecularSlope),
            freeMolecularSlope + linear};
}

} // namespace

FlowRate kineticFlowRate(double d)
{
    if (d < firstInverseKnudsen) {
        constexpr Excess first = kineticExcess.front();
        constexpr double continuum = firstInverseKnudsen / 6.0;
        return freeMolecules(d, firstInverseKnudsen, {first.value + continuum, first.logSlope + continuum});
    }
    const Excess e = excess(d);
    return {e.value + d / 6.0, e.logSlope + d / 6.0};
}

FlowRate fittedFlowRate(double d)
{
    if (d >= leastFittedInverseKnudsen) return fittedParts(d);
    return {fittedParts(leastFittedInverseKnudsen).value + freeMolecularSlope * std::log(d / leastFittedInverseKnudsen),
            freeMolecularSlope};
}

} // namespace touchdown
