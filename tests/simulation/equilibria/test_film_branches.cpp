// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_branches.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case_files/case_file.h"
#include "tests/support/menisci_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_branches {

double staticSpacing(const Case& c) { return staticStateOf(c, always).minimumSpacing; }

class TestFilmBranches : public QObject {
    Q_OBJECT

private slots:
    /// The static states at both ends; touch-down where the static spacing is d_s, half-way.
    void flyingIsTheStaticState()
    {
        Case c = smallCase();
        const double light = 8e-3, heavy = 14e-3; // [N]
        const auto at = [&](double preload) {
            Case moved = c;
            moved.suspension.preload = preload;
            return moved;
        };
        const double upper = staticSpacing(at(light)), lower = staticSpacing(at(heavy));
        QVERIFY(lower > 1e-9 && upper > lower + 1e-9);
        c.onoYamane.touchDown = 0.5 * (lower + upper);
        c.onoYamane.takeOff = c.onoYamane.touchDown; // what is pressed does not reach farther
        c.onoYamane.meniscusForce = 2e-3;
        const EquilibriumBranches all = traceFilmBranches(at, light, heavy, 2);
        QVERIFY(!all.branches.empty());
        const EquilibriumBranch& flying = all.branches.front();
        QCOMPARE(flying.contact, ContactRegion::Apart);
        QCOMPARE(flying.points.front().parameter, light);
        // Loads to 1e-9 of the preload over a stiffness of some 1e5 N/m: 1e-13 m; Newton's last change is 1e-5 of ten
        // nanometres, and what is left after it smaller by its square.
        QVERIFY(std::abs(flying.points.front().spacing - upper) < 1e-12);
        const MarkedEquilibrium* mark = markOf(all, EquilibriumMark::Switch);
        QVERIFY(mark != nullptr);
        QCOMPARE(mark->name, std::string("touch-down"));
        const double value = mark->at.parameter, slack = 2.0 * branchesLocatedTo * (heavy - light);
        QVERIFY(staticSpacing(at(value - slack)) > c.onoYamane.touchDown);
        QVERIFY(staticSpacing(at(value + slack)) < c.onoYamane.touchDown);
    }

    /// Static states are found on grids of their own, adapted to each. On the grid of the branches they lie on one
    /// branch, which is followed once.
    void aBranchIsFollowedOnce()
    {
        Case c = openCase("fig05_fm_3_62mN").value;
        c.film.nodes = {49, 49};
        const auto at = [&](double speed) {
            Case moved = c;
            moved.disk.speed = speed;
            return moved;
        };
        const EquilibriumBranches all = traceFilmBranches(at, 550.0, 800.0, 2);
        QCOMPARE(std::ranges::count(all.branches, ContactRegion::Apart, &EquilibriumBranch::contact), 1);
    }

    /// What holds the slider does not know d_e as long as the menisci reach: the branch ends where d_e is its spacing.
    void takesOffWhereMenisciReachNoFarther()
    {
        const double spacing = staticSpacing(smallCase());
        const SteadyResult rest = staticStateOf(smallCase(), always);
        const double held = spacingUnder(1e-3, spacing, rest).value_or(0.0);
        QVERIFY(held > spacing - 5e-9 && held < spacing - 1e-10);
        const double from = spacing + 1e-9, to = spacing - 5e-9;
        const auto caseAt = [&](double takeOff) {
            Case c = withMenisci(spacing, TakeOffShape::Constant);
            c.onoYamane.takeOff = takeOff;
            return c;
        };
        const EquilibriumBranches all = traceFilmBranches(caseAt, from, to, 3);
        const MarkedEquilibrium* mark = nullptr;
        for (const MarkedEquilibrium& each : all.marks)
            if (each.name == "take-off") mark = &each;
        QVERIFY(mark != nullptr);
        QCOMPARE(mark->kind, EquilibriumMark::Switch);
        QVERIFY(std::abs(mark->at.parameter - held) < 2.0 * branchesLocatedTo * (from - to));
        QVERIFY(std::abs(mark->at.spacing - held) < 1e-12);
    }

    void stopsWhenAsked()
    {
        const double spacing = staticSpacing(smallCase());
        int left = 300;
        const EquilibriumBranches all = traceFilmBranches(
            [&](double force) {
                Case c = withMenisci(spacing, TakeOffShape::Constant);
                c.onoYamane.meniscusForce = force;
                return c;
            },
            1e-3, 2e-3, 3, [&](double) { return left-- > 0; });
        QVERIFY(all.stopped);
        QVERIFY(left > -20); // it is not asked much after it said no
    }
};

TOUCHDOWN_TEST(TestFilmBranches)

} // namespace test_film_branches

#include "test_film_branches.moc"
