// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/established_film.h"

#include <cmath>
#include <vector>

#include <QTest>

#include "core/simulation/static_state/steady.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_established_film {

class TestEstablishedFilm : public QObject {
    Q_OBJECT

private slots:
    /// Both discretisations tend to one limit; the established manner is within 2 % of it on 129 x 129 nodes.
    void fixedAttitude()
    {
        Case c = sample("film_plane");
        c.film.nodes = {129, 129};
        c.steady.fixedAttitude = true;
        c.steady.stiffness = false;
        const FilmState state = establishedMethod().solve(c, 129, {});
        QCOMPARE(state.problem, std::string());
        QVERIFY(!state.statedError && state.seconds > 0.0);
        const SteadyResult ours = steady(c);
        const double difference = std::abs(state.netForce / ours.forces.net - 1.0);
        QVERIFY2(difference > 1e-6 && difference < 0.02, qPrintable(QString::number(difference)));
        QCOMPARE(state.minimumSpacing, ours.minimumSpacing);
    }
    /// A plane slider, loaded as our film at its attitude. The other film flies there, too, but for the error of its
    /// scheme, which is of first order: half of it on twice as many cells.
    void flight()
    {
        Case c = sample("film_plane");
        c.film.nodes = {257, 257};
        c.steady.stiffness = false;
        const SteadyResult held = steady(c);
        c.suspension.preload = held.forces.net;
        c.suspension.offsetX = -(held.forces.pitchTorque + held.shearPitchTorque) / held.forces.net;
        c.suspension.offsetY = -(held.forces.rollTorque + held.shearRollTorque) / held.forces.net;
        c.steady.fixedAttitude = false;
        std::vector<double> errors;
        for (const int nodes : {65, 129, 257}) {
            const FilmState state = establishedMethod().solve(c, nodes, {});
            QCOMPARE(state.problem, std::string());
            QVERIFY(std::abs(state.netForce / c.suspension.preload - 1.0) <= 1e-5);
            QVERIFY(std::abs(state.roll) < 1e-9);
            errors.push_back(state.minimumSpacing / held.minimumSpacing - 1.0);
        }
        for (std::size_t i = 1; i < errors.size(); ++i) {
            const double shrinks = errors[i] / errors[i - 1];
            QVERIFY2(shrinks > 0.25 && shrinks < 0.55, qPrintable(QString::number(shrinks)));
        }
        // With two degrees of freedom the roll stays where it is.
        c.degreesOfFreedom = 2;
        c.initial.roll = 1e-6;
        QCOMPARE(establishedMethod().solve(c, 65, {}).roll, 1e-6);
    }
    void stops()
    {
        Case c = sample("film_plane");
        c.steady.fixedAttitude = true;
        QVERIFY(!establishedMethod().solve(c, 65, [] { return false; }).problem.empty());
    }
};

TOUCHDOWN_TEST(TestEstablishedFilm)

} // namespace test_established_film

#include "test_established_film.moc"
