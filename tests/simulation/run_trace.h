// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tests of whole runs share: samples as vectors, values of a summary, a motion with a known solution.
#pragma once

#include <cmath>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/numerics/cvode.h"
#include "core/simulation/run.h"

namespace touchdown::test {

/// A final value of a run; not a number where the run has no such quantity.
inline double finalValue(const Summary& summary, const char* name)
{
    for (const auto& [quantity, value] : summary.final)
        if (quantity == name) return value;
    return NAN;
}

/// All samples of a run.
struct Trace {
    std::vector<double> time;
    std::vector<double> flyingHeight;
    std::vector<double> pitch;
    int updates = 0;
    bool finite = true;

    RunCallback recorder(const Case& c)
    {
        const auto quantities = recordedQuantities(c);
        const auto height = std::size_t(findQuantity(quantities, "flying_height"));
        const auto angle = std::size_t(findQuantity(quantities, "pitch"));
        return [this, height, angle](const RunUpdate& update) {
            ++updates;
            const SampleBatch& batch = update.samples;
            time.insert(time.end(), batch.time.begin(), batch.time.end());
            flyingHeight.insert(flyingHeight.end(), batch.columns[height].begin(), batch.columns[height].end());
            pitch.insert(pitch.end(), batch.columns[angle].begin(), batch.columns[angle].end());
            for (const auto& column : batch.columns)
                for (const double value : column) finite = finite && std::isfinite(value);
            return true;
        };
    }
};

/// 1 mg on a spring of 1e3 N/m and nothing else, at rest at 10 nm; its period is 199 us.
inline Case massOnASpring()
{
    Case c;
    c.contact = noContact;
    c.slider.mass = 1e-6;
    c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
    c.springs.frontDistance = c.springs.rearDistance = c.springs.padDistance = 0.0;
    c.springs.flyingHeight = c.initial.flyingHeight = 10e-9;
    c.springs.pitch = c.initial.pitch = 0.0;
    c.suspension = {.stiffness = 1e3, .pitchStiffness = 0.0, .dampingRatio = 0.0, .pitchDampingRatio = 0.0};
    c.run.duration = 100e-6;
    c.run.stepCheck = false;
    return c;
}

/// A column "integrator" with a row for each method that this build has.
inline void integratorRows()
{
    QTest::addColumn<int>("integrator");
    QTest::newRow("rk4") << int(IntegratorKind::Rk4);
    QTest::newRow("rk4-events") << int(IntegratorKind::Rk4Events);
    QTest::newRow("newmark") << int(IntegratorKind::Newmark);
    QTest::newRow("dopri5") << int(IntegratorKind::Dopri5);
    if (haveCvode) QTest::newRow("cvode") << int(IntegratorKind::Cvode);
}

} // namespace touchdown::test
