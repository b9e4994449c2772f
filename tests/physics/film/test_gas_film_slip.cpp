// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the slip models make of gaps that close, and of the switch between two of them.
#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/physics/film/gas_film.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_gas_film_slip {

constexpr double wedgeAngle = 0.03, wedgeInlet = 100e-9, wedgeSpeed = 10.0; // [rad], [m], [m/s]

/// A wedge from 100 nm down to the disk, which it touches, infinitely wide: the middle one of three rows that are a
/// thousand kilometres wide. Cells grow from 2 pm over the angle. Pressures against ambient where the gap is nearest to
/// these.
std::vector<double> wedgePressures(SlipModel model, const std::vector<double>& gaps)
{
    constexpr int cells = 200;
    const double length = wedgeInlet / wedgeAngle, first = 2e-12 / wedgeAngle;
    double low = 1.0 + 1e-6, high = 3.0;
    const auto sum = [&](double ratio) { return first * (std::pow(ratio, cells) - 1.0) / (ratio - 1.0); };
    for (int n = 0; n < 60; ++n) (sum(0.5 * (low + high)) < length ? low : high) = 0.5 * (low + high);
    CellGrid grid;
    grid.y = {0.0, 1e6, 2e6, 3e6};
    double at = 0.0, width = first;
    std::vector<double> distances{0.0};
    for (int i = 0; i < cells; ++i, width *= low) distances.push_back(at += width);
    for (int i = cells; i >= 0; --i) grid.x.push_back(length * (1.0 - distances[static_cast<std::size_t>(i)] / at));
    FilmProblem problem(planeSurface(), length, 3e6, grid,
                        {.air = {}, .slip = {.model = model}, .disk = uniformMotion(wedgeSpeed)},
                        {0.0, wedgeAngle, 0.0});
    if (!problem.solve({.tolerance = 1e-9, .maximumIterations = 200}).converged)
        return std::vector<double>(gaps.size(), std::nan(""));
    std::vector<double> pressures;
    for (const double gap : gaps) {
        int nearest = 0;
        const auto distance = [&](int i) {
            return std::abs(wedgeAngle * (length - problem.gaps.grid.centreX(i)) - gap);
        };
        for (int i = 0; i < cells; ++i)
            if (distance(i) < distance(nearest)) nearest = i;
        pressures.push_back(problem.at(nearest, 1) / problem.film.ambient());
    }
    return pressures;
}

/// A pad behind a step of 5 nm, parallel to the disk, so that all of it passes the switch of the combination at once.
double padLoad(double gap, double blendWidth)
{
    constexpr double L = 0.1e-3;
    AirBearingSurface surface;
    surface.baseRecess = 5e-9;
    surface.rails = {{.points = {{0.5 * L, 0.0}, {L, 0.0}, {L, L}, {0.5 * L, L}}, .recess = {0.0}}};
    const FilmSetting setting{.air = {},
                              .slip = {.model = SlipModel::Combination, .switchGap = 0.3e-9, .blendWidth = blendWidth},
                              .disk = uniformMotion(10.0)};
    FilmProblem problem(surface, L, L, uniformGrid(L, L, 24, 24), setting, {gap, 0.0, 0.0});
    return problem.solve({.tolerance = 1e-11}).converged ? problem.load() : std::nan("");
}

class TestGasFilmSlip : public QObject {
    Q_OBJECT

private slots:
    void singularModels_data()
    {
        QTest::addColumn<SlipModel>("model");
        QTest::addColumn<double>("exponent"); // of 1/gap; zero: unknown
        const Air air;
        const double s = air.viscosity * wedgeSpeed / (air.meanFreePath * air.pressure * wedgeAngle);
        QTest::newRow("first order") << SlipModel::FirstOrder << s;
        QTest::newRow("new first order") << SlipModel::NewFirstOrder << std::min(1.5 * s, 1.0);
        QTest::newRow("Fukui-Kaneko") << SlipModel::FukuiKaneko << 0.0;
        QTest::newRow("Fukui-Kaneko fit") << SlipModel::FukuiKanekoFit << 0.0;
    }
    /// Where the gap closes nothing passes, and dp/dx = 6 mu U/(Q h^2). With first order, 1 + 6 a Kn or 1 + 4 a Kn, Q
    /// h^2 becomes 6 or 4 a lambda0 p0 h/p, so that p goes with h^-s, s = mu U/(a lambda0 p0 theta), 0.94 here, or 1.5
    /// times that; more slowly as long as the 1 in Q counts. Fukui-Kaneko's Q is larger by a logarithm. Ten times less
    /// of a gap multiplies the pressure, without end.
    void singularModels()
    {
        QFETCH(SlipModel, model);
        QFETCH(double, exponent);
        const std::vector<double> p = wedgePressures(model, {1e-9, 1e-10, 1e-11});
        QVERIFY2(p[1] > 1.5 * p[0] && p[2] > 1.5 * p[1],
                 qPrintable(QString("%1, %2, %3").arg(p[0]).arg(p[1]).arg(p[2])));
        if (exponent == 0.0) return;
        const double found = std::log10(p[2] / p[1]);
        QVERIFY2(found < 1.05 * exponent && found > 0.85 * exponent,
                 qPrintable(QString("%1 of %2").arg(found).arg(exponent)));
    }
    void boundedModels_data()
    {
        QTest::addColumn<SlipModel>("model");
        QTest::addColumn<double>("second"); // the factor of Kn^2 in Q
        QTest::newRow("second order") << SlipModel::SecondOrder << 6.0;
        QTest::newRow("1.5 order") << SlipModel::OnePointFiveOrder << 8.0 / 3.0;
        QTest::newRow("new second order") << SlipModel::NewSecondOrder << 3.0;
        QTest::newRow("combination, new second order below 0.3 nm") << SlipModel::Combination << 3.0;
    }
    /// With a second-order term c Kn^2, Q h^2 is at least c (lambda0 p0/p)^2 whatever the gap, so that 1/p falls by no
    /// more than 6 mu U/(c (lambda0 p0)^2) times the way: in the last tenth of a nanometre, 3.3 nm long, by some
    /// hundredths of 1/p0 (Wu & Bogy 2003).
    void boundedModels()
    {
        QFETCH(SlipModel, model);
        QFETCH(double, second);
        const Air air;
        const double slip = air.meanFreePath * air.pressure;
        const double perWay = 6.0 * air.viscosity * wedgeSpeed / (second * slip * slip) * air.pressure;
        const std::vector<double> gaps{1e-10, 1e-11, 3e-12}, p = wedgePressures(model, gaps);
        for (std::size_t k = 1; k < gaps.size(); ++k) {
            // Cells grow by a twentieth of their distance from the disk; each pressure is that of a cell nearby.
            const double bound = 1.0 / (1.0 / p[0] - 1.05 * perWay * gaps[0] / wedgeAngle);
            QVERIFY2(p[k] >= p[k - 1] && p[k] < bound,
                     qPrintable(QString("%1, %2, bound %3").arg(p[k - 1]).arg(p[k]).arg(bound)));
        }
        QVERIFY(p[2] < 1.2 * p[0]);
    }

    /// The paper's hard switch: Q jumps at 0.3 nm, the load of a parallel pad with it, upwards with the gap, so that
    /// two heights carry the same load. Blended over 0.1 nm it falls steadily, by as little as the gap changes.
    void theHardSwitchJumps()
    {
        const double below = padLoad(0.3e-9 - 1e-16, 0.0), above = padLoad(0.3e-9 + 1e-16, 0.0);
        QVERIFY2(above > 1.01 * below, qPrintable(QString("%1, %2").arg(below).arg(above)));
        QVERIFY(padLoad(0.31e-9, 0.0) < above && padLoad(0.29e-9, 0.0) > below); // falling on either side

        const double blendedBelow = padLoad(0.3e-9 - 1e-16, 0.1e-9), blendedAbove = padLoad(0.3e-9 + 1e-16, 0.1e-9);
        QVERIFY2(std::abs(blendedAbove / blendedBelow - 1.0) < 1e-5,
                 qPrintable(QString("%1, %2").arg(blendedBelow).arg(blendedAbove)));
        double before = padLoad(0.24e-9, 0.1e-9);
        for (double gap = 0.25e-9; gap < 0.365e-9; gap += 0.01e-9) {
            const double load = padLoad(gap, 0.1e-9);
            QVERIFY2(load < before && load > 0.93 * before,
                     qPrintable(QString("%1: %2, %3").arg(gap).arg(load).arg(before)));
            before = load;
        }
    }
};

TOUCHDOWN_TEST(TestGasFilmSlip)

} // namespace test_gas_film_slip

#include "test_gas_film_slip.moc"
