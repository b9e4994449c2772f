// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where steps of a slider on its film find no solution, each time with the better way beside it.
#include <algorithm>

#include <QTest>

#include "core/physics/film/slip_model.h"
#include "tests/support/film_flight.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_run_limits {

bool warns(const Flight& flight, const char* of)
{
    return std::ranges::any_of(flight.summary.warnings,
                               [&](const std::string& each) { return each.find(of) != std::string::npos; });
}

/// Pressed down with three times the load of its design: low, and stiff.
Case low(double step, FilmCoupling coupling)
{
    Case c = fromRest("film_pico", 12e-6);
    c.suspension.preload *= 3.0;
    c.initial.heightOffset = 0.2e-9;
    c.run.steps = StepControl::Fixed;
    c.run.step = step;
    c.film.coupling = coupling;
    return c;
}

/// A pad of 50 um behind a step, that swings through a gap of 0.3 nm, parallel to the disk but for 3 pm.
Case throughTheSwitch(double blendWidth, FilmCoupling coupling)
{
    constexpr double L = 0.1e-3;
    Case c = fromRest("film_plane", 1e-6);
    c.degreesOfFreedom = 2;
    c.slider = {.mass = 1e-8, .pitchInertia = 1e-17, .rollInertia = 1e-17, .length = L, .width = L, .thickness = 3e-5};
    c.surface = {};
    c.surface.baseRecess = 5e-9;
    c.surface.rails = {{.points = {{0.5 * L, 0.0}, {L, 0.0}, {L, L}, {0.5 * L, L}}, .recess = {0.0}}};
    c.disk = {.speed = 500.0, .radius = 0.02, .skew = 0.0, .field = VelocityField::Uniform};
    c.air.slip = {.model = SlipModel::Combination, .switchGap = 0.3e-9, .blendWidth = blendWidth};
    c.film.grid = GridKind::Uniform;
    c.film.coupling = coupling;
    c.suspension = {};
    c.suspension.holdsAttitude = true;
    c.suspension.pitchStiffness = c.suspension.rollStiffness = 5.0;
    c.suspension.preload = 7e-3;
    c.initial.nominalTrailingEdgeHeight = 0.4e-9;
    c.initial.pitch = 0.0;
    c.initial.heightOffset = 0.1e-9;
    c.run.stepError = 1e-13;
    c.run.sampleInterval = 1e-9;
    return c;
}

class TestFilmRunLimits : public QObject {
    Q_OBJECT

private slots:
    /// The pitch mode near 250 kHz drags waves of U/(2 f) along, about a cell long on 49 lines. The roll mode near 60
    /// kHz has waves of more than six cells on 145 lines.
    void saysWhereItsDampingDependsOnTheGrid()
    {
        Case c = fromRest("film_pico", 40e-6);
        c.initial.pitchOffset = 5e-6;
        const Flight pitching = fly(c);
        QVERIFY_STATUS(pitching, RunStatus::Completed);
        QVERIFY(warns(pitching, "the damping of the motion at "));
        c.initial.pitchOffset = 0.0;
        c.initial.rollOffset = 2e-6;
        c.film.nodes = {145, 145};
        const Flight rolling = fly(c);
        QVERIFY_STATUS(rolling, RunStatus::Completed);
        QVERIFY(!rolling.summary.peaks.empty());
        QVERIFY(!warns(rolling, "the damping of the motion at "));
    }

    /// In turns, steps find a solution up to 2/omega of the stiffest way to move. Longer ones are cut, and the run says
    /// so and why; solved at once they need no cut at either length.
    void inTurnsAtLowSpacing()
    {
        const double fastest = [] {
            Case c = low(1e-7, FilmCoupling::Monolithic);
            const ModesResult result = modes(c);
            double most = 0.0;
            for (const AirBearingMode& mode : result.modes) most = std::max(most, 2.0 * M_PI * mode.frequency);
            return most;
        }();
        const double longStep = 3.0 / fastest, shortStep = 1.0 / fastest;
        const Flight cut = fly(low(longStep, FilmCoupling::Staggered));
        QVERIFY_STATUS(cut, RunStatus::Completed);
        QVERIFY(cut.summary.rejectedSteps > 0);
        QVERIFY(warns(cut, "film and slider do not come to agree") && warns(cut, "monolithic"));
        const Flight whole = fly(low(shortStep, FilmCoupling::Staggered));
        QVERIFY_STATUS(whole, RunStatus::Completed);
        QVERIFY(whole.summary.rejectedSteps == 0 && !warns(whole, "were cut"));
        for (const double step : {longStep, shortStep}) {
            const Flight atOnce = fly(low(step, FilmCoupling::Monolithic));
            QVERIFY_STATUS(atOnce, RunStatus::Completed);
            QVERIFY2(atOnce.summary.rejectedSteps == 0, qPrintable(QString::number(atOnce.summary.rejectedSteps)));
            QVERIFY(!warns(atOnce, "were cut"));
        }
    }
    /// The hard switch of slip at 0.3 nm: the force jumps, and more steps find no solution, or have errors that ask for
    /// shorter ones, than with the switch blended over 0.1 nm. Both are the same motion but for the jump.
    void throughTheHardSwitchOfSlip()
    {
        const Flight hard = fly(throughTheSwitch(0.0, FilmCoupling::Staggered)),
                     smooth = fly(throughTheSwitch(0.1e-9, FilmCoupling::Staggered));
        QVERIFY_STATUS(hard, RunStatus::Completed);
        QVERIFY_STATUS(smooth, RunStatus::Completed);
        for (const Flight* flight : {&hard, &smooth}) {
            QVERIFY(std::ranges::min(flight->of("minimum_spacing")) < 0.29e-9);
            QVERIFY(flight->of("minimum_spacing").front() > 0.4e-9);
        }
        QVERIFY2(hard.summary.rejectedSteps > smooth.summary.rejectedSteps,
                 qPrintable(QString("%1, %2").arg(hard.summary.rejectedSteps).arg(smooth.summary.rejectedSteps)));
        QVERIFY(hard.summary.steps > smooth.summary.steps);
    }
};

TOUCHDOWN_TEST(TestFilmRunLimits)

} // namespace test_film_run_limits

#include "test_film_run_limits.moc"
