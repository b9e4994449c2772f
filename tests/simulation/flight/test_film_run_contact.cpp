// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs in which a slider on its film touches the disk: by the law of Ono & Yamane, and elastically.
#include "core/simulation/flight/film_run.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_kind.h"
#include "core/case_files/case_file.h"
#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/film_flight.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_run_contact {

/// A pico, without roll, let go some nanometres above a disk that it touches on its way down.
Case bouncing(double duration)
{
    Case c = fromRest("film_pico", duration);
    c.contact = ContactKind::OnoYamane;
    c.degreesOfFreedom = 2;
    c.onoYamane = {.meniscusForce = 5e-3,
                   .contactStiffness = 5e6,
                   .initialContactForce = 5e-3,
                   .touchDown = 3e-9,
                   .takeOff = 4e-9,
                   .friction = 0.3};
    c.initial.heightOffset = 15e-9;
    c.run.sampleInterval = 0.02e-6;
    return c;
}

std::size_t count(const Flight& flight, const char* event)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(flight.events, [&](const RunEvent& e) { return e.name == event; }));
}

class TestFilmRunContact : public QObject {
    Q_OBJECT

private slots:
    /// Samples so near to each switch that the spacing there is read off them: within 20 ns at 20 mm/s and 2e6 m/s^2 a
    /// parabola through three samples misses less than a tenth of run.step_error. At touch-down it is d_s, at take-off
    /// d_e.
    void switchesAreLocated()
    {
        Case c = bouncing(12e-6);
        c.run.sampleInterval = 2e-9;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QVERIFY(count(flight, "touch-down") >= 2);
        QVERIFY(count(flight, "take-off") >= 1);
        const std::vector<double>& spacing = flight.of("minimum_spacing");
        for (const RunEvent& event : flight.events) {
            const double place = event.time / c.run.sampleInterval;
            const std::size_t k = std::min(static_cast<std::size_t>(place), spacing.size() - 2);
            const double share = place - double(k);
            const double found = (1.0 - share) * spacing[k] + share * spacing[k + 1];
            const double expected =
                event.name == "touch-down" ? c.onoYamane.touchDown
                : event.name == "take-off"
                    ? c.onoYamane.takeOff
                    : c.onoYamane.touchDown + c.onoYamane.initialContactForce / c.onoYamane.contactStiffness;
            QVERIFY2(std::abs(found - expected) < c.run.stepError,
                     qPrintable(QString("%1 at %2 nm").arg(event.name.c_str()).arg(found * 1e9)));
        }
    }
    /// The paper's way to two degrees of freedom, in contact: a roll stiffness of 1e4 N m/rad, against which a contact
    /// of 10 mN at 0.5 mm turns the slider by 0.5 nrad at most, against a held roll. What is left between them is the
    /// error of the steps: 54, 14 and 3 pm with a step error of 1e-4, 1e-5 and 1e-6 nm, at 1e2 as at 1e6 N m/rad.
    void aHugeRollStiffnessIsAHeldRoll()
    {
        Case held = bouncing(8e-6);
        held.suspension.holdsAttitude = true;
        held.suspension.staticPitch = 0.0;
        held.run.stepError = 1e-15;
        Case stiff = held;
        stiff.degreesOfFreedom = 3;
        stiff.suspension.rollStiffness = 1e4;
        const Flight one = fly(stiff), other = fly(held);
        QVERIFY_STATUS(one, RunStatus::Completed);
        QVERIFY_STATUS(other, RunStatus::Completed);
        QVERIFY(count(other, "touch-down") >= 1);
        QCOMPARE(one.events.size(), other.events.size());
        const std::vector<double>&a = one.of("minimum_spacing"), &b = other.of("minimum_spacing");
        QCOMPARE(a.size(), b.size());
        double apart = 0.0;
        for (std::size_t n = 0; n < a.size(); ++n) apart = std::max(apart, std::abs(a[n] - b[n]));
        QVERIFY2(apart < 1e-11, qPrintable(QString("%1 m").arg(apart)));
        QVERIFY(one.largestDistance("roll", 0.0) < 0.5e-9);
    }
    /// In every sample: no contact force above d_e, menisci below d_s, forces of the law in between by the branch.
    void forcesAreThoseOfTheLaw()
    {
        const Case c = bouncing(20e-6);
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        const OnoYamane& law = c.onoYamane;
        for (std::size_t n = 0; n < flight.time.size(); ++n) {
            const double d = flight.of("minimum_spacing")[n], contact = flight.of("contact_force")[n];
            const double adhesion = flight.of("adhesion_force")[n];
            if (d > law.takeOff + c.run.stepError) QVERIFY(contact == 0.0 && adhesion == 0.0);
            if (d < law.touchDown - c.run.stepError) {
                // Linear in time between the ends of a step, in which d moves by up to some tenths of a nanometre.
                const double expected = law.initialContactForce + law.contactStiffness * (law.touchDown - d);
                QVERIFY(std::abs(contact - expected) < 0.05 * expected);
                QCOMPARE(adhesion, -law.meniscusForce);
            }
            QVERIFY(std::abs(flight.of("net_contact_force")[n] - contact - adhesion) < 1e-15);
            QVERIFY(std::abs(flight.of("friction_force")[n] - law.friction * contact) <
                    1e-3 * law.friction * contact + 1e-15);
        }
    }
    /// Pressed down by all of a fall from 250 nm, deeper than there is a gap: the contact carries.
    void fallsDeep()
    {
        Case c = bouncing(10e-6);
        c.initial.heightOffset = 250e-9;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QCOMPARE(count(flight, "touch-down"), std::size_t(1));
        QVERIFY(std::ranges::min(flight.of("minimum_spacing")) < 0.0);
        QVERIFY(flight.of("minimum_spacing").front() > 250e-9);
        for (const auto& [quantity, values] : flight.columns)
            for (const double value : values) QVERIFY2(std::isfinite(value), quantity.c_str());
    }
    /// Two ways to solve the same equations. Each ends a step with up to run.step_error of its own, 1e-12 m, and they
    /// fall by some 30 mm/s and 2e4 m/s^2: after the hundreds of steps to the first switch that is less than 5 ns and
    /// 0.1 nm.
    void staggeredAgrees()
    {
        Case c = bouncing(4e-6);
        c.run.stepError = 1e-12;
        Case staggered = c;
        staggered.film.coupling = FilmCoupling::Staggered;
        const Flight one = fly(c), other = fly(staggered);
        QVERIFY_STATUS(one, RunStatus::Completed);
        QVERIFY_STATUS(other, RunStatus::Completed);
        QVERIFY(!one.events.empty());
        QCOMPARE(one.events.size(), other.events.size());
        for (std::size_t k = 0; k < one.events.size(); ++k) {
            QCOMPARE(one.events[k].name, other.events[k].name);
            QVERIFY2(std::abs(one.events[k].time - other.events[k].time) < 5e-9,
                     qPrintable(QString::number(one.events[k].time - other.events[k].time)));
        }
        const double apart = std::abs(one.final("minimum_spacing") - other.final("minimum_spacing"));
        QVERIFY2(apart < 1e-10, qPrintable(QString::number(apart)));
    }
    /// Never asked where the slider is above d_e on the touch-down branch.
    void leavesOutWhatIsOutOfReach()
    {
        Case c = bouncing(5e-6);
        c.initial.heightOffset = 1e-9;
        c.onoYamane.touchDown = 1e-9;
        c.onoYamane.takeOff = 2e-9;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QCOMPARE(flight.figure("contact_solves"), 0.0);
        QVERIFY(flight.figure("contact_skipped") > 0.0);
        QVERIFY(flight.events.empty());
    }
    /// A pad lands on a rough disk that moves. The contact mode's period is about 1.2 us, 12.6 steps at the longest
    /// phase: 63 steps in 6 us, and three times as many while errors and surface shorten them. Where the air in closed
    /// gaps counted as a spring that the slider compresses alone, there were 362.
    void airInClosedGapsSetsNoStep()
    {
        Case c = openCase("fig02_case_2_moving").value;
        c.run.duration = 6e-6;
        c.run.fieldSnapshots = 0;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QVERIFY(flight.largestDistance("contact_force", 0.0) > 0.0);
        QVERIFY2(flight.summary.steps < 250, qPrintable(QString::number(flight.summary.steps)));
    }
    /// Cells of 0.5 um against a zone of adhesion of 0.14 um: the errors of contact force and area are stated as not
    /// known. Without adhesion they are known.
    void errorOfItsGrid()
    {
        Case c = coarseFlight("fig02_micro_pad_case_1_flat");
        c.initial = {.pitch = 120e-6, .nominalTrailingEdgeHeight = 0.5e-9};
        c.run.duration = 0.02e-6;
        c.run.sampleInterval = 0.01e-6;
        c.run.fieldSnapshots = 0;
        for (const bool adheres : {true, false}) {
            if (!adheres) c.adhesion.kind = AdhesionKind::None;
            const Flight flight = fly(c);
            QVERIFY_STATUS(flight, RunStatus::Completed);
            QVERIFY(flight.final("contact_force") > 0.0);
            for (const char* name : {"contact_force_error", "contact_area_error"}) {
                QVERIFY(std::ranges::any_of(flight.summary.figures,
                                            [&](const RunFigure& f) { return f.quantity.name == name; }));
                QCOMPARE(std::isnan(flight.figure(name)), adheres);
            }
        }
    }
    void isDeterministic()
    {
        const Case c = bouncing(10e-6);
        const Flight one = fly(c), other = fly(c);
        QVERIFY_STATUS(one, RunStatus::Completed);
        for (const auto& [quantity, values] : one.columns) QCOMPARE(values, other.columns.at(quantity));
        QCOMPARE(one.events.size(), other.events.size());
    }
};

TOUCHDOWN_TEST(TestFilmRunContact)

} // namespace test_film_run_contact

#include "test_film_run_contact.moc"
