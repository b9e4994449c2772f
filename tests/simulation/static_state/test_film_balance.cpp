// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/film_balance.h"

#include <cmath>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/simulation/equilibria/film_equilibria.h"
#include "core/simulation/static_state/film_setup.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_balance {

const std::function<bool()> always = [] { return true; };

Case withMenisci()
{
    Case c = test::smallSlider(33);
    c.film.grid = GridKind::Graded;
    c.film.tolerance = 1e-12;
    c.steady.shearArm = 0.5;
    c.contact = ContactKind::OnoYamane;
    c.onoYamane = {.meniscusForce = 1e-3,
                   .contactStiffness = 5e6,
                   .initialContactForce = 5e-3,
                   .touchDown = 5e-9,
                   .takeOff = 20e-9,
                   .friction = 0.3,
                   .takeOffShape = TakeOffShape::Linear};
    return c;
}

class TestFilmBalance : public QObject {
    Q_OBJECT

private slots:
    void staticStateIsBalanced()
    {
        const Case c = withMenisci();
        const SteadyResult rest = staticStateOf(c, always);
        const auto balance = FilmBalance::make(c, rest.grid, rest.gaps, rest.attitude, always);
        balance->level().gaps.pad.pad<double>(rest.pressure, balance->level().pressure);
        QVERIFY(balance->solve(balance->body().coordinates(rest.attitude), always));
        QVERIFY(balance->error(balance->force(ContactRegion::Apart)) < 2.0 * c.steady.loadTolerance);
        // The menisci pull with f_m (d_e - d)/(d_e - d_s) there.
        const double pull = 1e-3 * (20e-9 - rest.minimumSpacing) / 15e-9;
        QVERIFY(std::abs(balance->netContactForce(ContactRegion::Bridged) + pull) < 1e-6 * pull);
    }

    void stiffnessIsTheForcesSlope_data()
    {
        QTest::addColumn<int>("region");
        QTest::newRow("apart") << static_cast<int>(ContactRegion::Apart);
        QTest::newRow("bridged") << static_cast<int>(ContactRegion::Bridged);
    }
    /// Central differences over 0.02 nm at the slider's ends: their error is of second order, (0.02/10)^2 of the
    /// stiffness, and rounding of the film, 1e-12 of some 10 mN, counts 1e-14/(1e5 4e-11) = 2e-9.
    void stiffnessIsTheForcesSlope()
    {
        QFETCH(int, region);
        const auto law = static_cast<ContactRegion>(region);
        const Case c = withMenisci();
        const SteadyResult rest = staticStateOf(c, always);
        const auto balance = FilmBalance::make(c, rest.grid, rest.gaps, rest.attitude, always);
        balance->level().gaps.pad.pad<double>(rest.pressure, balance->level().pressure);
        const Vector3 q = balance->body().coordinates(rest.attitude);
        QVERIFY(balance->solve(q, always));
        const Matrix3 stiffness = balance->stiffness(law, always);
        const Vector3 scale(1.0, 1.0 / c.slider.length, 1.0 / c.slider.width);
        const Matrix3 scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
        // A roll moves the place of the contact's force within a hundredth of a nanometre: without contact alone it is
        // smooth so far.
        for (int m = 0; m < (law == ContactRegion::Apart ? 3 : 2); ++m) {
            const double step = 2e-11 * scale[m];
            Vector3 forces[2];
            for (int side = 0; side < 2; ++side) {
                Vector3 moved = q;
                moved[m] += side == 0 ? step : -step;
                QVERIFY(balance->solve(moved, always));
                forces[side] = balance->force(law);
            }
            for (int k = 0; k < 3; ++k) {
                if (law != ContactRegion::Apart && k == 2) continue;
                const double slope = -(forces[0][k] - forces[1][k]) / (2.0 * step) * scale[k] * scale[m];
                QVERIFY2(std::abs(slope - scaled(k, m)) < 1e-5 * scaled.norm(),
                         qPrintable(QString("%1 %2: %3 %4").arg(k).arg(m).arg(slope).arg(scaled(k, m))));
            }
        }
    }

    /// Apart the static state knows no spring in height; those that hold the attitude count once in both.
    void springsCountOnce()
    {
        Case c = withMenisci();
        const SteadyResult free = staticStateOf(c, always);
        c.suspension.holdsAttitude = true;
        c.suspension.staticPitch = free.attitude.pitch;
        c.suspension.staticRoll = free.attitude.roll;
        const SteadyResult rest = staticStateOf(c, always);
        const auto balance = FilmBalance::make(c, rest.grid, rest.gaps, rest.attitude, always);
        balance->level().gaps.pad.pad<double>(rest.pressure, balance->level().pressure);
        QVERIFY(balance->solve(balance->body().coordinates(rest.attitude), always));
        const Matrix3 more = balance->stiffnessWithSprings(ContactRegion::Apart, always) -
                             balance->stiffness(ContactRegion::Apart, always);
        // Of a stiffness of some 1e5 N/m rounding leaves 1e-11 N/m; twice the springs would leave 15 N/m and 2e-5 N
        // m/rad.
        QVERIFY2(std::abs(more(0, 0) - c.suspension.stiffness) < 1e-9, qPrintable(QString::number(more(0, 0))));
        for (int i = 1; i < 3; ++i) QVERIFY2(std::abs(more(i, i)) < 1e-12, qPrintable(QString::number(more(i, i))));
    }

    void knowsWhatLiesBeyondASwitch()
    {
        Case c = withMenisci();
        const SteadyResult rest = staticStateOf(c, always);
        const auto balance = FilmBalance::make(c, rest.grid, rest.gaps, rest.attitude, always);
        Vector3 q = balance->body().coordinates(rest.attitude);
        q[0] += 5e-9 - rest.minimumSpacing; // at d_s
        QVERIFY(balance->solve(q, always));
        const FilmBalance::Beyond beyond = balance->beyond(ContactRegion::Apart, false);
        QCOMPARE(beyond.name, std::string("touch-down"));
        QCOMPARE(beyond.region, ContactRegion::Pressed);
        QVERIFY(beyond.jumps); // by f_c0 - f_m
        // Where the contact force ends the menisci go on to pull.
        const double ends = balance->interval(ContactRegion::Lifting).upper;
        q[0] += ends - 5e-9;
        QVERIFY(balance->solve(q, always));
        const FilmBalance::Beyond bridged = balance->beyond(ContactRegion::Lifting, true);
        QCOMPARE(bridged.region, ContactRegion::Bridged);
        QVERIFY(balance->netContactForce(ContactRegion::Bridged) < -1e-4);
        QVERIFY(!bridged.jumps && bridged.kinks);
        // At d_e the menisci pull no more: a kink.
        q[0] += 20e-9 - ends;
        QVERIFY(balance->solve(q, always));
        const FilmBalance::Beyond off = balance->beyond(ContactRegion::Bridged, true);
        QCOMPARE(off.region, ContactRegion::Apart);
        QVERIFY(!off.jumps && off.kinks);
    }
};

TOUCHDOWN_TEST(TestFilmBalance)

} // namespace test_film_balance

#include "test_film_balance.moc"
