// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_branches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <QTest>

#include "tests/support/menisci_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_branches_fold {

class TestFilmBranchesFold : public QObject {
    Q_OBJECT

private slots:
    /// Menisci whose force falls linearly to zero at d_e, below the static spacing: F = f_m (d_e - d)/(d_e - d_s) at
    /// spacing d. Where the film bears F at d(F), f_m = F (d_e - d_s)/(d_e - d(F)); it has a least value, below which
    /// there is no equilibrium, and two above.
    void findsTheFoldOfMenisci()
    {
        const SteadyResult rest = staticStateOf(smallCase(), always);
        const double spacing = rest.minimumSpacing, width = 5e-9, takeOff = spacing - 1e-9;
        const auto needed = [&](double force) {
            const double pulled = takeOff - spacingUnder(force, spacing, rest).value_or(takeOff);
            return pulled > 0.0 ? force * width / pulled : std::numeric_limits<double>::infinity();
        };
        // From three forces of which the middle one needs least, to the bottom of the parabola through them, time and
        // again.
        std::array<double, 3> x{1e-4, 2e-4, 4e-4}, y{needed(x[0]), needed(x[1]), needed(x[2])};
        while (!(y[1] <= y[0] && y[1] < y[2] && std::isfinite(y[0]))) {
            x = {x[1], x[2], 2.0 * x[2]};
            y = {y[1], y[2], needed(x[2])};
        }
        for (int k = 0; k < 6; ++k) {
            const double p = (x[1] - x[0]) * (y[1] - y[2]), q = (x[1] - x[2]) * (y[1] - y[0]);
            const double bottom = x[1] - 0.5 * ((x[1] - x[0]) * p - (x[1] - x[2]) * q) / (p - q),
                         value = needed(bottom);
            const bool above = bottom > x[1], lower = value < y[1];
            if (lower) {
                (above ? x[0] : x[2]) = x[1];
                (above ? y[0] : y[2]) = y[1];
                x[1] = bottom;
                y[1] = value;
            } else {
                (above ? x[2] : x[0]) = bottom;
                (above ? y[2] : y[0]) = value;
            }
        }
        const double least = y[1];
        const auto caseAt = [&](double meniscusForce) {
            Case c = withMenisci(spacing, TakeOffShape::Linear);
            c.onoYamane.meniscusForce = meniscusForce;
            return c;
        };
        const EquilibriumBranches all = traceFilmBranches(caseAt, 0.95 * least, 1.1 * least, 2);
        const MarkedEquilibrium* fold = markOf(all, EquilibriumMark::Fold);
        QVERIFY(fold != nullptr);
        // Both are stationary: errors of the force and along the branch count by their squares.
        QVERIFY2(std::abs(fold->at.parameter - least) < 1e-5 * least,
                 qPrintable(QString::number(fold->at.parameter / least - 1.0)));
        const auto branch = std::ranges::find(all.branches, ContactRegion::Bridged, &EquilibriumBranch::contact);
        QVERIFY(branch != all.branches.end());
        // One side grows without oscillating, the other does not.
        const bool first = branch->points.front().stability == Stability::Divergence;
        const bool last = branch->points.back().stability == Stability::Divergence;
        QVERIFY(first != last);
    }
};

TOUCHDOWN_TEST(TestFilmBranchesFold)

} // namespace test_film_branches_fold

#include "test_film_branches_fold.moc"
