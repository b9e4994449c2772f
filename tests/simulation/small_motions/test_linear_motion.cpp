// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/simulation/small_motions/linear_motion.h"
#include "tests/support/film_flight.h"
#include "tests/support/taper_flat.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_linear_motion {

class TestLinearMotion : public QObject {
    Q_OBJECT

private slots:
    void followsTheFilmWhereMotionsAreSmall_data();
    void followsTheFilmWhereMotionsAreSmall();
    void twiceTheWaveTwiceTheAnswer();
};

Case restingSlider(int degreesOfFreedom)
{
    Case c = test::taperFlat(degreesOfFreedom);
    c.initial.state = InitialState::Static;
    c.run.duration = 60e-6;
    c.run.stepError = 1e-14;
    c.run.fieldSnapshots = 0;
    return c;
}

void setWave(Case& c, double amplitude)
{
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {amplitude};
    c.diskSurface.waveLengths = {c.disk.speed * c.disk.radius / 100e3}; // passes at 100 kHz
    c.diskSurface.wavePhases = {0.4};
}

// Displacements of 1 pm over a gap of 40 nm: what is nonlinear is 1/40,000 of them. What the film forgets at rates of
// its own, the air in the cavity within some 40 us, is left out: a displaced slider comes back by a tenth so slowly. Of
// the velocity that is a tenth times (1/40 us)/(2 pi 85 kHz), 0.5 %, after the first periods, in which the faster rates
// of the film fade.
void TestLinearMotion::followsTheFilmWhereMotionsAreSmall_data()
{
    QTest::addColumn<int>("degreesOfFreedom");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("wave");
    QTest::newRow("a displaced slider, its roll held") << 2 << 1e-12 << 0.0;
    QTest::newRow("a displaced slider") << 3 << 1e-12 << 0.0;
    QTest::newRow("a wave that comes at once") << 3 << 0.0 << 1e-12;
}

void TestLinearMotion::followsTheFilmWhereMotionsAreSmall()
{
    QFETCH(int, degreesOfFreedom);
    QFETCH(double, offset);
    QFETCH(double, wave);
    Case c = restingSlider(degreesOfFreedom);
    c.initial.heightOffset = offset;
    if (wave > 0.0) setWave(c, wave);
    const test::Flight flight = test::fly(c);
    QVERIFY_STATUS(flight, RunStatus::Completed);
    const LinearMotion motion = linearMotion(c);
    QVERIFY2(motion.status == SteadyStatus::Converged, motion.message.c_str());
    const auto centre = [&](double time) {
        const Attitude a = motion.at(time);
        return a.height + 0.5 * c.slider.length * a.pitch;
    };
    constexpr double dt = 1e-9; // of the central difference: it is wrong by (omega dt)^2/6, 1e-7 of itself
    double largest = 0.0, apart = 0.0;
    for (std::size_t k = 0; k < flight.time.size(); ++k) {
        const double t = flight.time[k];
        if (t < 20e-6) continue;
        const double velocity = (centre(t + dt) - centre(t - dt)) / (2.0 * dt);
        largest = std::max(largest, std::abs(velocity));
        apart = std::max(apart, std::abs(velocity - flight.of("vertical_velocity")[k]));
    }
    QVERIFY2(apart < 0.02 * largest, qPrintable(QString("%1 of %2").arg(apart).arg(largest)));
}

void TestLinearMotion::twiceTheWaveTwiceTheAnswer()
{
    Case c = restingSlider(2);
    setWave(c, 1e-10);
    const LinearMotion one = linearMotion(c);
    setWave(c, 2e-10);
    const LinearMotion two = linearMotion(c);
    QCOMPARE(one.waves.size(), 1u);
    for (Eigen::Index k = 0; k < 2; ++k)
        QVERIFY(std::abs(two.waves[0].amplitude[k] - 2.0 * one.waves[0].amplitude[k]) <
                1e-9 * std::abs(two.waves[0].amplitude[k]));
    QCOMPARE(std::abs(one.waves[0].amplitude[2]), 0.0);
}

TOUCHDOWN_TEST(TestLinearMotion)

} // namespace test_linear_motion

#include "test_linear_motion.moc"
