// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/multi_asperity_curve.h"

#include <cassert>
#include <cstddef>

namespace touchdown {

MultiAsperityCurve multiAsperityCurve(const MultiAsperity& model, double start, double closest, int points)
{
    assert(start > closest && points > 1);
    MultiAsperityCurve curve;
    MultiAsperityState state = model.start(start);
    const auto follow = [&](double from, double to, std::vector<MultiAsperityPoint>& way,
                            std::vector<MultiAsperityJump>& jumps) {
        const PadMotion motion = to < from ? PadMotion::Towards : PadMotion::Away;
        const auto passed = [&](double place, double d) {
            return motion == PadMotion::Towards ? d < place : d > place;
        };
        const auto add = [&](double d) { way.push_back({d, state, model.forces(state)}); };
        auto jump = model.nextJump(state, motion);
        for (int i = 0; i < points; ++i) {
            const double d = i + 1 == points ? to : from + (to - from) * i / (points - 1);
            for (; jump && passed(jump->padSeparation, d); jump = model.nextJump(state, motion)) {
                state = jump->from;
                add(jump->padSeparation);
                state = jump->to;
                add(jump->padSeparation);
                jumps.push_back(*jump);
            }
            state = model.advance(state, d);
            add(d);
        }
    };
    follow(start, closest, curve.towards, curve.touchDowns);
    follow(closest, start, curve.away, curve.takeOffs);

    for (const auto* way : {&curve.towards, &curve.away}) {
        for (std::size_t i = 1; i < way->size(); ++i) {
            const MultiAsperityPoint& a = (*way)[i - 1];
            const MultiAsperityPoint& b = (*way)[i];
            curve.work -= 0.5 * (a.forces.total() + b.forces.total()) * (b.padSeparation - a.padSeparation);
        }
    }
    return curve;
}

} // namespace touchdown
