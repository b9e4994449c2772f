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
