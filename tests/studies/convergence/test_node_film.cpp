// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/node_film.h"

#include <QTest>

#include "core/physics/film/film_grid.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_node_film {

NodeFilm planeFilm(int nodes)
{
    const Case c = sample("film_plane");
    const double length = c.slider.length, width = c.slider.width;
    FilmSetting setting = filmSetting(c);
    setting.scheme = ConvectionScheme::PowerLaw;
    return NodeFilm(Recess(c.surface, length, width), setting, uniformGrid(length, width, nodes - 1, nodes - 1),
                    FaceGaps::TwoOfSamples);
}

Attitude ownAttitude()
{
    const Case c = sample("film_plane");
    return {c.initial.nominalTrailingEdgeHeight, c.initial.pitch, c.initial.roll};
}

class TestNodeFilm : public QObject {
    Q_OBJECT

private slots:
    /// The limit of the plane slider's load is 8.2148 gf (an independent Newton solution, Richardson extrapolation).
    /// The power law acts as an upwind scheme at large Peclet numbers: of first order, so half the error on half the
    /// spacing.
    void planeSlider()
    {
        constexpr double limit = 8.2148 * 9.80665e-3; // [N]
        const NodeFilmResult coarse = planeFilm(65).solve(ownAttitude()), fine = planeFilm(129).solve(ownAttitude());
        QVERIFY(coarse.converged && fine.converged);
        QVERIFY(fine.residual <= 5e-7);
        const double before = std::abs(coarse.load - limit), last = std::abs(fine.load - limit);
        QVERIFY2(last < 0.02 * limit, qPrintable(QString::number(last / limit)));
        QVERIFY2(std::log2(before / last) > 0.8, qPrintable(QString::number(before / last)));
    }
    /// Between parallel planes the disk carries as much air out as in: the pressure stays ambient.
    void parallelPlanes()
    {
        const NodeFilmResult result = planeFilm(33).solve({100e-9, 0.0, 0.0});
        QVERIFY(result.converged);
        QVERIFY(std::abs(result.load) < 1e-9);
    }
    /// Of the same film in other cells: the torques of the load about the centre, within the scheme's error.
    void torques()
    {
        Case c = sample("film_plane");
        c.film.nodes = {129, 129};
        c.initial.roll = 2e-6;
        c.steady.fixedAttitude = true;
        c.steady.stiffness = false;
        const SteadyResult ours = steady(c);
        const NodeFilmResult result = planeFilm(129).solve(ours.attitude);
        QVERIFY(ours.forces.pitchTorque < 0.0 && ours.forces.rollTorque != 0.0);
        QVERIFY(std::abs(result.pitchTorque / ours.forces.pitchTorque - 1.0) < 0.03);
        QVERIFY(std::abs(result.rollTorque / ours.forces.rollTorque - 1.0) < 0.03);
    }
    /// A solution is the same from any start.
    void anotherAttitude()
    {
        NodeFilm film = planeFilm(33);
        const double first = film.solve(ownAttitude()).load;
        Attitude higher = ownAttitude();
        higher.height *= 1.1;
        QVERIFY(film.solve(higher).load < 0.99 * first);
        QVERIFY(std::abs(film.solve(ownAttitude()).load / first - 1.0) < 1e-5);
    }
    void stops()
    {
        int asked = 0;
        const NodeFilmResult result = planeFilm(33).solve(ownAttitude(), [&] { return ++asked < 2; });
        QVERIFY(!result.converged);
        QCOMPARE(asked, 2);
    }
};

TOUCHDOWN_TEST(TestNodeFilm)

} // namespace test_node_film

#include "test_node_film.moc"
