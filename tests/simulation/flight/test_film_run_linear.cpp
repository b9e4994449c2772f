// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of a film that is linear about the static state, against those that solve it in each step.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <QtTest>

#include "core/simulation/run.h"
#include "core/simulation/small_motions/linear_state.h"
#include "tests/support/film_flight.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_run_linear {

/// The sample slider, moved from its static state by so much [m].
Case let(double offset, double duration = 30e-6)
{
    Case c = fromRest("film_pico", duration);
    c.initial.heightOffset = offset;
    c.initial.pitchOffset = offset / (2.0 * c.slider.length);
    return c;
}

Case linear(Case c, double limit = 10.0)
{
    c.film.motion = FilmMotion::Linear;
    c.film.linearLimit = limit;
    return c;
}

/// Root mean square difference of a quantity, against the standard deviation of the first.
double difference(const Flight& a, const Flight& b, const char* quantity)
{
    const std::vector<double>&x = a.of(quantity), &y = b.of(quantity);
    const std::size_t count = std::min(x.size(), y.size());
    double mean = 0.0, squares = 0.0, missed = 0.0;
    for (std::size_t n = 0; n < count; ++n) mean += x[n] / static_cast<double>(count);
    for (std::size_t n = 0; n < count; ++n) {
        squares += (x[n] - mean) * (x[n] - mean);
        missed += (x[n] - y[n]) * (x[n] - y[n]);
    }
    return std::sqrt(missed / squares);
}

double largestDifference(const Flight& a, const Flight& b)
{
    double largest = 0.0;
    for (const char* quantity : {"minimum_spacing", "height", "pitch"})
        largest = std::max(largest, difference(a, b, quantity));
    return largest;
}

class TestFilmRunLinear : public QObject {
    Q_OBJECT
private slots:
    // What is left out is of second order: an eighth of the motion, an eighth of its share. The stated error covers it.
    void agreesInSmallMotions()
    {
        std::vector<double> shares;
        for (const double offset : {0.8e-9, 0.1e-9}) {
            const Flight full = fly(let(offset)), small = fly(linear(let(offset)));
            QVERIFY_STATUS(full, RunStatus::Completed);
            QVERIFY_STATUS(small, RunStatus::Completed);
            QCOMPARE(small.time.size(), full.time.size());
            shares.push_back(largestDifference(full, small));
            QVERIFY(shares.back() < small.figure("film_linearity_error"));
            QVERIFY(small.figure("energy_balance") < 1e-3);
            QVERIFY(small.figure("film_fit_error") < 1e-3);
        }
        QVERIFY2(shares[1] < 0.02 && shares[1] < 0.25 * shares[0],
                 qPrintable(QString("%1 %2").arg(shares[0]).arg(shares[1])));
    }

    // A start that is given, over the same state; the air of the full film is that of a slider that stood there.
    void startsAtAGivenAttitude()
    {
        Case c = let(0.0);
        const SteadyResult rest = steady(c);
        c.initial.state = InitialState::Given;
        c.initial.nominalTrailingEdgeHeight = rest.attitude.height + 0.1e-9;
        c.initial.pitch = rest.attitude.pitch;
        c.initial.roll = rest.attitude.roll;
        const Flight full = fly(c), small = fly(linear(c));
        QVERIFY_STATUS(small, RunStatus::Completed);
        QVERIFY(largestDifference(full, small) < 0.02);
    }

    // Waves of the disk that begin to pass, and then last.
    void answersToWaves()
    {
        Case c = let(0.0, 40e-6);
        c.diskSurface.kind = DiskSurfaceKind::Waves;
        c.diskSurface.waveAmplitudes = {0.05e-9, 0.03e-9};
        c.diskSurface.waveLengths = {600e-6, 250e-6};
        c.diskSurface.waveAngles = {0.0, 0.2};
        c.diskSurface.wavePhases = {0.7, 2.0};
        const Flight full = fly(c), small = fly(linear(c));
        QVERIFY_STATUS(full, RunStatus::Completed);
        QVERIFY_STATUS(small, RunStatus::Completed);
        QVERIFY2(largestDifference(full, small) < 0.02, qPrintable(QString::number(largestDifference(full, small))));
    }

    // About a state in contact, whose law switches nowhere near.
    void vibratesInContact()
    {
        Case c = coarseFlight("fig07_mu_2", 49);
        c.initial.state = InitialState::Static;
        c.initial.branch = ContactBranch::TakeOff;
        c.initial.heightOffset = 0.02e-9;
        c.run.duration = 20e-6;
        c.run.sampleInterval = 0.05e-6;
        const Flight full = fly(c), small = fly(linear(c));
        QVERIFY_STATUS(full, RunStatus::Completed);
        QVERIFY_STATUS(small, RunStatus::Completed);
        QVERIFY(std::ranges::max(small.of("contact_force")) > 1e-3);
        QVERIFY2(largestDifference(full, small) < 0.03, qPrintable(QString::number(largestDifference(full, small))));
    }

    void endsWhereTheMotionIsTooLarge()
    {
        const Flight flight = fly(linear(let(0.8e-9), 0.02));
        QVERIFY_STATUS(flight, RunStatus::Failed);
        QVERIFY(flight.summary.message.find("film.linear_limit") != std::string::npos);
        QVERIFY(flight.figure("film_linearity_error") > 0.02);
    }

    void needsAStaticState()
    {
        Case c = linear(let(0.0));
        c.suspension.preload = 0.5; // [N]
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Failed);
        QVERIFY(flight.summary.message.find("film.motion") != std::string::npos);
    }

    // The state is kept for other starts, and not for another load.
    void keepsTheStateForOtherStarts()
    {
        Case c = linear(let(0.1e-9, 2e-6));
        c.suspension.preload *= 1.01;
        QVERIFY(!knownLinearState(c));
        QVERIFY_STATUS(fly(c), RunStatus::Completed);
        const auto kept = knownLinearState(c);
        QVERIFY(kept);
        Case other = c;
        other.initial.heightOffset = 0.2e-9;
        other.run.duration = 3e-6;
        other.film.linearLimit = 5.0;
        QCOMPARE(knownLinearState(other), kept);
        other.diskSurface.kind = DiskSurfaceKind::Waves;
        other.diskSurface.waveAmplitudes = {0.05e-9};
        other.diskSurface.waveLengths = {600e-6};
        QVERIFY_STATUS(fly(other), RunStatus::Completed);
        QCOMPARE(knownLinearState(other)->film.waves.size(), std::size_t(1));
        QCOMPARE(knownLinearState(other)->film.fit.error, kept->film.fit.error);
        other.suspension.preload *= 1.01;
        QVERIFY(!knownLinearState(other));
        // Another one beside it, which it outlives.
        other.diskSurface = {};
        QVERIFY_STATUS(fly(other), RunStatus::Completed);
        QVERIFY(knownLinearState(other) && knownLinearState(c));
        QCOMPARE(knownLinearState(c)->film.fit.error, kept->film.fit.error);
    }

    // Who moves a value sees at once what the same film does about the state of another value: where the slider rests
    // then, and how it moves about that.
    void looksAboutTheStateOfASimilarCase_data()
    {
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("meniscus");
        QTest::addColumn<double>("load");
        QTest::addColumn<double>("mass");
        QTest::newRow("friction") << 0.9 << 1.0 << 1.0 << 1.0;
        QTest::newRow("menisci") << 1.0 << 1.03 << 1.0 << 1.0;
        QTest::newRow("load") << 1.0 << 1.0 << 1.005 << 1.0;
        QTest::newRow("mass") << 1.0 << 1.0 << 1.0 << 1.4;
        QTest::newRow("all") << 1.05 << 0.98 << 0.998 << 0.8;
    }
    void looksAboutTheStateOfASimilarCase()
    {
        QFETCH(double, friction);
        QFETCH(double, meniscus);
        QFETCH(double, load);
        QFETCH(double, mass);
        Case c = coarseFlight("fig07_mu_2", 49);
        c.initial.state = InitialState::Static;
        c.initial.branch = ContactBranch::TakeOff;
        c.run.duration = 20e-6;
        c.run.sampleInterval = 0.05e-6;
        QVERIFY_STATUS(fly(linear(c)), RunStatus::Completed);
        Case other = c;
        other.onoYamane.friction *= friction;
        other.onoYamane.meniscusForce *= meniscus;
        other.suspension.preload *= load;
        other.slider.mass *= mass;
        other.initial.heightOffset = 0.02e-9;
        QVERIFY(!hasLinearState(linear(other)) && nearestLinearState(linear(other)));
        const Flight look = fly(linear(other), 0, {.kept = KeptStates::Similar});
        QVERIFY_STATUS(look, RunStatus::Completed);
        QVERIFY(!hasLinearState(linear(other))); // it made none
        const Flight own = fly(linear(other));
        QVERIFY_STATUS(own, RunStatus::Completed);
        QVERIFY(hasLinearState(linear(other)));
        QVERIFY2(std::abs(look.of("minimum_spacing").front() - own.of("minimum_spacing").front()) < 0.003e-9,
                 qPrintable(QString::number(look.of("minimum_spacing").front() - own.of("minimum_spacing").front())));
        // The same start that is let go there swings as far.
        const auto swing = [](const Flight& flight) {
            const auto [least, most] = std::ranges::minmax(flight.of("minimum_spacing"));
            return most - least;
        };
        QVERIFY2(std::abs(swing(look) / swing(own) - 1.0) < 0.02,
                 qPrintable(QString::number(swing(look) / swing(own))));
        // At rest it stays there.
        other.initial.heightOffset = 0.0;
        other.slider.mass *= 1.01; // so that this state is not its own
        const Flight still = fly(linear(other), 0, {.kept = KeptStates::Similar});
        QVERIFY(swing(still) < 1e-14);
    }

    // Who compares times has it found anew.
    void findsItsStateAnew()
    {
        const Case c = linear(let(0.02e-9, 2e-6));
        const Flight first = fly(c);
        const auto kept = knownLinearState(c);
        QVERIFY(kept);
        QVERIFY_STATUS(fly(c), RunStatus::Completed);
        QCOMPARE(knownLinearState(c).get(), kept.get());
        const Flight anew = fly(c, 0, {.kept = KeptStates::None});
        QVERIFY(knownLinearState(c).get() != kept.get());
        QCOMPARE(largestDifference(first, anew), 0.0);
    }

    // Waves of another height are the same waves; other waves are not.
    void looksOverHigherWaves()
    {
        Case c = linear(let(0.0, 10e-6));
        c.diskSurface.kind = DiskSurfaceKind::Waves;
        c.diskSurface.waveAmplitudes = {0.02e-9, -0.03e-9};
        c.diskSurface.waveLengths = {600e-6, 250e-6};
        QVERIFY_STATUS(fly(c), RunStatus::Completed);
        for (double& amplitude : c.diskSurface.waveAmplitudes) amplitude *= 1.7;
        QVERIFY(!hasLinearState(c));
        const Flight look = fly(c, 0, {.kept = KeptStates::Similar}), own = fly(c);
        QVERIFY_STATUS(look, RunStatus::Completed);
        QVERIFY2(largestDifference(own, look) < 1e-4, qPrintable(QString::number(largestDifference(own, look))));
        QCOMPARE(look.figure("film_linearity_error") > 0.0, true);
        c.diskSurface.waveAmplitudes[0] *= 1.1;
        QVERIFY(!nearestLinearState(c));
        c.diskSurface.waveLengths = {600e-6, 200e-6};
        QVERIFY(!nearestLinearState(c));
        c.diskSurface = {};
        QVERIFY(hasLinearState(c));
    }

    // Dampers do not act at rest: it is their state, too. Another speed has another film.
    void dampersShareTheState()
    {
        Case c = linear(let(0.1e-9, 3e-6));
        c.suspension.preload *= 1.02;
        QVERIFY_STATUS(fly(c), RunStatus::Completed);
        Case damped = c;
        damped.suspension.damping = 0.02;
        damped.suspension.pitchDamping = 1e-9;
        damped.suspension.rollDamping = 1e-9;
        QCOMPARE(knownLinearState(damped), knownLinearState(c));
        const Flight look = fly(damped, 0, {.kept = KeptStates::Similar}), own = fly(damped);
        QCOMPARE(look.of("minimum_spacing"), own.of("minimum_spacing"));
        QVERIFY(own.of("minimum_spacing") != fly(c).of("minimum_spacing"));
        Case faster = c;
        faster.disk.speed *= 1.01;
        QVERIFY(!nearestLinearState(faster));
        faster = c;
        faster.surface.crown += 1e-9;
        QVERIFY(!nearestLinearState(faster));
    }

    // No fields: there are no pressures in time.
    void recordsNoFields()
    {
        Case c = linear(let(0.0));
        c.run.fieldSnapshots = 5;
        QVERIFY(!recordsFields(c));
        QVERIFY(recordedFields(c).empty());
        QVERIFY_STATUS(fly(c), RunStatus::Completed);
    }
};

TOUCHDOWN_TEST(TestFilmRunLinear)

} // namespace test_film_run_linear

#include "test_film_run_linear.moc"
