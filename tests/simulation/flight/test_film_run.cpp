// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_run.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/formats/units.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/static_solution.h"
#include "tests/support/film_flight.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_run {

class TestFilmRun : public QObject {
    Q_OBJECT

private slots:
    void staysAtRest_data()
    {
        QTest::addColumn<QString>("slider");
        QTest::addColumn<int>("coupling");
        QTest::newRow("pico, monolithic") << "film_pico" << int(FilmCoupling::Monolithic);
        QTest::newRow("pico, staggered") << "film_pico" << int(FilmCoupling::Staggered);
        QTest::newRow("femto, monolithic") << "film_femto" << int(FilmCoupling::Monolithic);
    }
    /// The static state is one of the equations in time, but for what its own solution leaves: 1e-10 of the load on
    /// some 1e6 N/m.
    void staysAtRest()
    {
        QFETCH(QString, slider);
        QFETCH(int, coupling);
        Case c = fromRest(slider.toStdString(), 20e-6);
        c.film.coupling = FilmCoupling(coupling);
        const SteadyResult rest = steady(c);
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QCOMPARE(flight.time.size(), std::size_t(201));
        QVERIFY(flight.largestDistance("minimum_spacing", rest.minimumSpacing) < 1e-12);
        QVERIFY(flight.largestDistance("pitch", rest.attitude.pitch) < 1e-9);
        QVERIFY(flight.largestDistance("roll", rest.attitude.roll) < 1e-9);
        QVERIFY(flight.largestDistance("air_bearing_force", rest.forces.net) < 1e-5 * c.suspension.preload);
    }
    void solvesOneStaticState_data()
    {
        QTest::addColumn<int>("start");
        QTest::addColumn<double>("preload");
        QTest::newRow("from rest") << int(InitialState::Static) << 1.0;
        QTest::newRow("from a given attitude") << int(InitialState::Given) << 1.0;
        QTest::newRow("without a static state") << int(InitialState::Given) << 100.0;
    }
    /// The page of the static state has solved for it, with its stiffness: a run that gets the solution solves for
    /// nothing, and has the same bits.
    void solvesOneStaticState()
    {
        QFETCH(int, start);
        QFETCH(double, preload);
        Case c = fromRest("film_pico", 1e-6);
        c.initial.state = InitialState(start);
        c.initial.heightOffset = 1e-9;
        c.suspension.preload *= preload;
        c.film.maximumIterations = 20;
        Case page = c;
        page.steady.stiffness = page.steady.sensitivities = true;
        const auto rest = std::make_shared<const StaticSolution>(StaticSolution{page, steady(page)});
        QCOMPARE(rest->state.status, preload > 1.0 ? SteadyStatus::NotConverged : SteadyStatus::Converged);
        const long long before = staticSolutions();
        const Flight alone = fly(c);
        QCOMPARE(staticSolutions(), before + 1);
        const Flight inHand = fly(c, 0, {.rest = rest});
        QCOMPARE(staticSolutions(), before + 1);
        QCOMPARE(inHand.summary.message, alone.summary.message);
        QVERIFY(inHand.time.size() > 1 && inHand.time == alone.time);
        QVERIFY(inHand.columns == alone.columns);
        QVERIFY(inHand.summary.warnings == alone.summary.warnings);
    }
    /// A solution from a file has no gaps: its film is solved once more from near, on its grid alone. A wrong one is
    /// found out.
    void aSolutionFromAFileIsNotBelieved()
    {
        const Case c = fromRest("film_pico", 1e-6);
        StaticSolution rest{c, steady(c)};
        const SteadyResult right = rest.state;
        rest.state.gaps = nullptr;
        const auto spacing = [&] {
            return fly(c, 0, {.rest = std::make_shared<const StaticSolution>(rest)}).of("minimum_spacing")[0];
        };
        const long long before = staticSolutions();
        QVERIFY(std::abs(spacing() - right.minimumSpacing) < 1e-13);
        QCOMPARE(staticSolutions(), before);
        for (double& p : rest.state.pressure) p *= 1.1;
        rest.state.attitude.height += 2e-9;
        QVERIFY(std::abs(spacing() - right.minimumSpacing) < 1e-13);
    }
    /// A run takes no state of another case.
    void aStateOfAnotherCaseIsNotUsed()
    {
        const Case c = fromRest("film_pico", 1e-6);
        Case lighter = c;
        lighter.suspension.preload *= 0.9;
        const auto rest = std::make_shared<const StaticSolution>(StaticSolution{lighter, steady(lighter)});
        const long long before = staticSolutions();
        const Flight other = fly(c, 0, {.rest = rest});
        QCOMPARE(staticSolutions(), before + 1);
        QVERIFY(other.columns == fly(c).columns);
    }
    /// Offsets count from the static state, of the mass centre: the trailing edge goes up by 3 nm less L/2 10 urad.
    /// Velocities count.
    void startsAtItsOffsets()
    {
        Case c = fromRest("film_femto", 0.1e-6);
        c.initial.heightOffset = 3e-9;
        c.initial.pitchOffset = 10e-6;
        c.initial.rollOffset = -2e-6;
        c.initial.verticalVelocity = 1e-3;
        c.initial.pitchVelocity = -2.0;
        c.initial.rollVelocity = 0.5;
        const SteadyResult rest = steady(c);
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        const double centre = rest.attitude.height + 0.5 * c.slider.length * rest.attitude.pitch;
        QVERIFY(std::abs(flight.of("height")[0] - (centre + 3e-9)) < 1e-18);
        QVERIFY(std::abs(flight.of("pitch")[0] - (rest.attitude.pitch + 10e-6)) < 1e-15);
        QVERIFY(std::abs(flight.of("roll")[0] - (rest.attitude.roll - 2e-6)) < 1e-15);
        QCOMPARE(flight.of("vertical_velocity")[0], 1e-3);
        QCOMPARE(flight.of("pitch_velocity")[0], -2.0);
        QCOMPARE(flight.of("roll_velocity")[0], 0.5);
    }
    /// With a given state it starts there, 250 nm up. Above the height of its design the pico's cavity pulls as hard as
    /// its pads bear or harder: it is pressed down with some f0/M = 9.2e3 m/s^2, 40 nm in 3 us. It cannot fall faster
    /// than with all of the atmosphere on it.
    void startsFarUp()
    {
        Case c = fromRest("film_pico", 3e-6);
        c.initial.state = InitialState::Given;
        c.initial.nominalTrailingEdgeHeight = 250e-9;
        c.initial.pitch = 150e-6;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        const std::vector<double>& height = flight.of("height");
        QVERIFY(std::abs(height.front() - (250e-9 + 150e-6 * 0.625e-3)) < 1e-18);
        QVERIFY(height.back() < height.front() - 20e-9);
        const double suction = c.air.given.pressure * c.slider.length * c.slider.width;
        for (std::size_t n = 0; n < height.size(); ++n) {
            const double t = flight.time[n];
            QVERIFY(height.front() - height[n] <=
                    0.5 * (c.suspension.preload + suction) / c.slider.mass * t * t + 1e-15);
        }
    }
    /// Steps of a run end where its duration does: with them the last map, as the last sample.
    void theLastMapIsOfTheEnd_data()
    {
        QTest::addColumn<bool>("fixed");
        QTest::addColumn<double>("duration"); // [s]
        QTest::newRow("steps by their error") << false << 0.73e-6;
        QTest::newRow("steps that divide the run") << true << 0.8e-6;
        QTest::newRow("steps that do not") << true << 0.77e-6;
    }
    void theLastMapIsOfTheEnd()
    {
        QFETCH(bool, fixed);
        QFETCH(double, duration);
        Case c = fromRest("film_femto", duration);
        c.film.nodes = {17, 17};
        c.initial.heightOffset = 5e-9;
        c.run.fieldSnapshots = 3;
        c.run.sampleInterval = duration / 7.3;
        if (fixed) c.run.steps = StepControl::Fixed, c.run.step = 20e-9;
        std::vector<FieldSnapshot> maps;
        const Summary summary = run(c, [&](const RunUpdate& update) {
            for (const FieldSnapshot& each : update.fields) maps.push_back(each);
            return true;
        });
        QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
        QCOMPARE(summary.endTime, duration);
        QCOMPARE(maps.size(), std::size_t(3));
        QCOMPARE(maps.back().time, duration);
        // The lowest of the cells' gaps to the mean plane lies at the minimum spacing that the last sample has, above
        // it by at most half a cell's slope: the pitch of some 200 urad over 0.43 mm/16/2.
        const std::vector<double>& gap = maps.back().values[0];
        double spacing = 0.0;
        for (const auto& [quantity, value] : summary.final)
            if (quantity == "minimum_spacing") spacing = value;
        const double lowest = *std::ranges::min_element(gap);
        QVERIFY2(lowest > spacing && lowest < spacing + 5e-9, qPrintable(QString::number(lowest - spacing)));
    }
    /// Twice the same bits.
    void isDeterministic()
    {
        Case c = fromRest("film_femto", 5e-6);
        c.initial.heightOffset = 2e-9;
        const Flight one = fly(c), other = fly(c);
        QVERIFY_STATUS(one, RunStatus::Completed);
        for (const auto& [quantity, values] : one.columns) QCOMPARE(values, other.columns.at(quantity));
        QCOMPARE(one.summary.steps, other.summary.steps);
    }
    /// 2-DOF by a suspension that holds the roll with 100 N m/rad, against which the air's torques, below 0.1 uN m,
    /// turn the slider by less than 1 nrad, or by no roll at all.
    void stiffRollIsNoRoll()
    {
        Case stiff = fromRest("film_pico", 15e-6);
        stiff.initial.heightOffset = 2e-9;
        stiff.run.stepError = 1e-13;
        Case without = stiff;
        without.degreesOfFreedom = 2;
        stiff.suspension.holdsAttitude = true;
        stiff.suspension.rollStiffness = 100.0;
        stiff.suspension.staticPitch = without.suspension.staticPitch = 0.0;
        without.suspension.holdsAttitude = true;
        const Flight one = fly(stiff), other = fly(without);
        QVERIFY_STATUS(one, RunStatus::Completed);
        QVERIFY_STATUS(other, RunStatus::Completed);
        const std::vector<double>&a = one.of("minimum_spacing"), &b = other.of("minimum_spacing");
        QCOMPARE(a.size(), b.size());
        double apart = 0.0, lowest = 1.0;
        for (std::size_t n = 0; n < a.size(); ++n) {
            apart = std::max(apart, std::abs(a[n] - b[n]));
            lowest = std::min(lowest, b[n]);
        }
        QVERIFY2(apart < 1e-3 * lowest, qPrintable(QString("%1 of %2 m").arg(apart).arg(lowest)));
        QVERIFY2(one.largestDistance("roll", 0.0) < 1e-9,
                 qPrintable(QString::number(one.largestDistance("roll", 0.0))));
    }
    /// Fixed steps of 5 ns: as many as fit, and the last one passes the end.
    void fixedSteps()
    {
        Case c = fromRest("film_pico", 2e-6);
        c.initial.heightOffset = 1e-9;
        c.run.steps = StepControl::Fixed;
        c.run.step = 5e-9;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QVERIFY(flight.summary.steps >= 400 && flight.summary.steps <= 401);
        for (std::size_t n = 1; n < flight.time.size(); ++n)
            QVERIFY(std::abs(flight.of("time_step")[n] - 5e-9) < 1e-18);
    }
    /// One call more at most, with what has come so far; its samples are kept, without gaps, and the last one is its
    /// end.
    void stops()
    {
        Case c = fromRest("film_pico", 0.1);
        c.initial.heightOffset = 1e-9;
        const Flight flight = fly(c, 2);
        QVERIFY_STATUS(flight, RunStatus::Cancelled);
        QVERIFY(flight.summary.message.starts_with("stopped at "));
        QVERIFY(flight.summary.endTime > 0.0 && flight.summary.endTime < 0.1);
        QVERIFY(flight.time.size() > 1);
        for (std::size_t n = 0; n + 1 < flight.time.size(); ++n)
            QVERIFY(std::abs(flight.time[n] - 1e-7 * double(n)) < 1e-15);
        QVERIFY(std::abs(flight.time.back() - flight.summary.endTime) < 1e-13);
        for (const auto& [name, value] : flight.summary.final) QVERIFY2(std::isfinite(value), name.c_str());
        int calls = 0;
        const Summary atOnce = runFilm(c, [&](const RunUpdate&) { return ++calls < 1; });
        QVERIFY(atOnce.status == RunStatus::Cancelled);
        QVERIFY(calls <= 2);
    }
    /// Pushed upwards with 1 m/s against a preload of 15 mN, which would stop it after 0.1 ms in 54 um; 3 m/s take it
    /// beyond 0.1 mm, from which no slider comes back.
    void leavesTheDisk()
    {
        Case c = fromRest("film_pico", 1e-3);
        c.initial.verticalVelocity = 3.0;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Diverged);
        QVERIFY2(flight.summary.message.find("left the disk") != std::string::npos, flight.summary.message.c_str());
        QVERIFY(flight.summary.endTime > 0.0 && flight.summary.endTime < 1e-3);
        QVERIFY(flight.final("minimum_spacing") > 1e-6);
    }
    /// Driven into a disk without a contact law: the run ends with the last good state and a sentence, and no number
    /// that is none.
    void cannotGoOn()
    {
        Case c = fromRest("film_pico", 50e-6);
        c.initial.verticalVelocity = -0.2;
        const Flight flight = fly(c);
        QVERIFY(flight.summary.status == RunStatus::Failed);
        QVERIFY2(flight.summary.message.find(" at " + fewDigitsOfTime(flight.summary.endTime, 4) + ":") !=
                     std::string::npos,
                 flight.summary.message.c_str());
        QVERIFY(flight.summary.endTime > 0.0);
        for (const auto& [quantity, values] : flight.columns)
            for (const double value : values) QVERIFY2(std::isfinite(value), quantity.c_str());
        for (const auto& [name, value] : flight.summary.final) QVERIFY2(std::isfinite(value), name.c_str());
    }
    /// No static state: three times the air's largest suction upwards.
    void hasNoStaticState()
    {
        Case c = fromRest("film_pico", 1e-6);
        c.suspension.preload = 50.0; // [N]
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Failed);
        QVERIFY2(flight.summary.message.find("static") != std::string::npos, flight.summary.message.c_str());
        QVERIFY(flight.time.empty());
    }
};

TOUCHDOWN_TEST(TestFilmRun)

} // namespace test_film_run

#include "test_film_run.moc"
