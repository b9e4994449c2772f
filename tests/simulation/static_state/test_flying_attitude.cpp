// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/simulation/static_state/film_setup.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_flying_attitude {

class TestFlyingAttitude : public QObject {
    Q_OBJECT

private slots:
    void loadsAreTorquesAboutTheCentre();
    void findsTheSameAttitudeFromAnySaneStart_data();
    void findsTheSameAttitudeFromAnySaneStart();
    void stiffnessAgreesWithDifferences();
    void theHeldAttitudeTurnsTheSlider();
    void tellsWhenItIsCancelled();
    void isAskedAtEachLinearIteration_data();
    void isAskedAtEachLinearIteration();
    void saysWhenItDoesNotConverge();
};

/// A case solved on one graded grid.
struct Solved {
    explicit Solved(const Case& c, Attitude start = {20e-9, 120e-6, 0.0})
        : value(c),
          recess(c.surface, c.slider.length, c.slider.width),
          spacing(c.surface, recess),
          level(value, recess, spacing,
                gradedGrid(c.surface, c.slider.length, c.slider.width, c.film.nodes[0] - 1, c.film.nodes[1] - 1)),
          attitude(start),
          solution(level.flying.approach(level.pressure, attitude, {.filmTolerance = 1e-10, .loadTolerance = 1e-9}))
    {}
    Case value;
    Recess recess;
    MinimumSpacing spacing;
    FilmLevel level;
    Attitude attitude;
    AttitudeSolution solution;
};

void TestFlyingAttitude::loadsAreTorquesAboutTheCentre()
{
    Case c = test::smallSlider();
    c.suspension.preload = 0.01;
    c.suspension.offsetX = 1e-4;
    c.suspension.offsetY = -2e-4;
    c.suspension.pitchTorque = 3e-7;
    c.steady.shearArm = 1.0;
    const SliderLoad load = sliderLoad(c);
    QCOMPARE(load.pitchTorque, 0.01 * 1e-4 + 3e-7);
    QCOMPARE(load.rollTorque, -0.01 * 2e-4);
    QCOMPARE(load.shearArm, c.slider.thickness);
    QCOMPARE(load.pitchStiffness, 0.0);
}

void TestFlyingAttitude::findsTheSameAttitudeFromAnySaneStart_data()
{
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("pitch");
    QTest::addColumn<double>("roll");
    QTest::newRow("near") << 12e-9 << 120e-6 << 0.0;
    QTest::newRow("trailing edge in the disk") << -30e-9 << 100e-6 << 0.0;
    QTest::newRow("high") << 300e-9 << 200e-6 << 0.0;
    QTest::newRow("flat and low") << 2e-9 << 5e-6 << 0.0;
    QTest::newRow("rolled") << 40e-9 << 150e-6 << 40e-6;
    QTest::newRow("steep") << 20e-9 << 600e-6 << 0.0;
}

void TestFlyingAttitude::findsTheSameAttitudeFromAnySaneStart()
{
    QFETCH(double, height);
    QFETCH(double, pitch);
    QFETCH(double, roll);
    const Solved reference(test::smallSlider(49));
    QVERIFY(reference.solution.converged);
    const Solved solved(test::smallSlider(49), {height, pitch, roll});
    QVERIFY(solved.solution.converged);
    QVERIFY(std::abs(solved.attitude.height - reference.attitude.height) < 1e-14);
    QVERIFY(std::abs(solved.attitude.pitch - reference.attitude.pitch) < 1e-11);
    QVERIFY(std::abs(solved.attitude.roll - reference.attitude.roll) < 1e-11);
}

void TestFlyingAttitude::stiffnessAgreesWithDifferences()
{
    Solved solved(test::smallSlider(49));
    QVERIFY(solved.solution.converged);
    const Matrix3 rough = solved.level.flying.roughStiffness(solved.level.pressure);
    const Matrix3 stiffness = solved.level.flying.stiffness(solved.level.pressure);
    const Attitude at = solved.attitude;
    const double length = solved.value.slider.length;
    for (std::size_t m = 0; m < 3; ++m) {
        // Steps that raise a corner by about 2 pm: the difference's own error is the step squared, 1e-7 of the result.
        const double step = m == 0 ? 2e-12 : 2e-12 / length;
        std::array<std::array<double, 3>, 2> loads{};
        for (int side = 0; side < 2; ++side) {
            const double d = side == 0 ? -step : step;
            const Attitude moved{at.height + (m == 0 ? d : 0.0), at.pitch + (m == 1 ? d : 0.0),
                                 at.roll + (m == 2 ? d : 0.0)};
            std::vector<double> p = solved.level.pressure;
            solved.level.film.setAttitude(moved);
            QVERIFY(solved.level.flying.solveFilm(p, {.tolerance = 1e-13, .maximumIterations = 30}).residual < 1e-11);
            loads[static_cast<std::size_t>(side)] = solved.level.loads.load(p);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const double difference = -(loads[1][k] - loads[0][k]) / (2.0 * step);
            const double scale = std::sqrt(std::abs(stiffness(k, k) * stiffness(m, m)));
            QVERIFY2(std::abs(stiffness(k, m) - difference) < 1e-5 * scale,
                     qPrintable(QString("%1 %2: %3 and %4").arg(k).arg(m).arg(stiffness(k, m)).arg(difference)));
            QVERIFY2(std::abs(rough(k, m) - stiffness(k, m)) < 0.03 * scale,
                     qPrintable(QString("%1 %2: %3 and %4").arg(k).arg(m).arg(stiffness(k, m)).arg(rough(k, m))));
        }
    }
}

void TestFlyingAttitude::theHeldAttitudeTurnsTheSlider()
{
    // A suspension that wants more pitch than the slider has lifts its nose.
    Case c = test::smallSlider(49);
    const Solved free(c);
    c.suspension.holdsAttitude = true;
    c.suspension.pitchStiffness = 1e-3;
    c.suspension.staticPitch = free.attitude.pitch + 50e-6;
    const Solved held(c);
    QVERIFY(held.solution.converged);
    QVERIFY(held.attitude.pitch > free.attitude.pitch);
    QVERIFY(held.attitude.pitch < c.suspension.staticPitch);
}

void TestFlyingAttitude::tellsWhenItIsCancelled()
{
    const Case c = test::smallSlider(49);
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const MinimumSpacing spacing(c.surface, recess);
    FilmLevel level(c, recess, spacing, uniformGrid(c.slider.length, c.slider.width, 48, 48));
    Attitude attitude{20e-9, 120e-6, 0.0};
    int calls = 0;
    const AttitudeSolution s = level.flying.approach(level.pressure, attitude, {},
                                                     [&](int, double, double, const Attitude&) { return ++calls < 3; });
    QVERIFY(s.cancelled);
    QVERIFY(!s.converged);
    QCOMPARE(calls, 3);
}

/// Whatever it works on: between two calls there is one linear iteration at most beside a linearisation. Whenever it
/// says no, it is not asked again.
void TestFlyingAttitude::isAskedAtEachLinearIteration_data()
{
    QTest::addColumn<bool>("near");
    QTest::newRow("from far") << false;
    QTest::newRow("film and attitude together") << true;
}

void TestFlyingAttitude::isAskedAtEachLinearIteration()
{
    QFETCH(bool, near);
    const Case c = test::smallSlider(33);
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const MinimumSpacing spacing(c.surface, recess);
    const auto solve = [&](const AttitudeMonitor& monitor) {
        FilmLevel level(c, recess, spacing, uniformGrid(c.slider.length, c.slider.width, 32, 32));
        Attitude attitude{20e-9, 120e-6, 0.0};
        return near ? level.flying.solve(level.pressure, attitude, {}, monitor)
                    : level.flying.approach(level.pressure, attitude, {}, monitor);
    };
    int calls = 0;
    const AttitudeSolution whole = solve([&](int, double, double, const Attitude&) { return ++calls > 0; });
    QVERIFY(whole.converged);
    // A linear solution that its tolerance ends does not ask after its last iteration: of the at most four of each
    // attitude that is so, and what is solved for the film alone asks once more for each.
    const int solutions = 4 * (whole.iterations + 1);
    QVERIFY2(calls >= whole.solves - solutions,
             qPrintable(QString("%1 calls, %2 solves").arg(calls).arg(whole.solves)));
    for (int last = 1; last <= calls; last += 7) {
        int asked = 0;
        const AttitudeSolution stopped = solve([&](int, double, double, const Attitude&) { return ++asked < last; });
        QVERIFY(stopped.cancelled && !stopped.converged);
        QCOMPARE(asked, last);
    }
}

void TestFlyingAttitude::saysWhenItDoesNotConverge()
{
    // No air bearing of this size carries 100 N.
    Case c = test::smallSlider(33);
    c.suspension.preload = 100.0;
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const MinimumSpacing spacing(c.surface, recess);
    FilmLevel level(c, recess, spacing, uniformGrid(c.slider.length, c.slider.width, 32, 32));
    Attitude attitude{20e-9, 120e-6, 0.0};
    const AttitudeSolution s = level.flying.approach(level.pressure, attitude, {.maximumIterations = 5});
    QVERIFY(!s.converged);
    QVERIFY(s.loadError > 0.1);
    QVERIFY(std::isfinite(attitude.height) && std::isfinite(s.loadError));
    for (const double p : level.pressure) QVERIFY(p > 0.0 && std::isfinite(p));
}

TOUCHDOWN_TEST(TestFlyingAttitude)

} // namespace test_flying_attitude

#include "test_flying_attitude.moc"
