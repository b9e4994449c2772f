// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/expected_cost.h"

#include <cmath>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_expected_cost {

class TestExpectedCost : public QObject {
    Q_OBJECT

private slots:
    /// A tenth of the step needs ten times the right-hand sides; a film of four times the nodes costs four times as
    /// much.
    void expectedCosts()
    {
        Case c = sample("fig10a");
        c.run.integrator = IntegratorKind::Rk4;
        c.run.step = 10e-9;
        Case fine = c;
        fine.run.step = 1e-9;
        QVERIFY(std::abs(expectedCost(fine) / expectedCost(c) - 10.0) < 1e-9);
        Case film = sample("film_pico"), wide = film;
        wide.film.nodes = {2 * film.film.nodes[0], 2 * film.film.nodes[1]};
        QVERIFY(std::abs(expectedCost(wide) / expectedCost(film) - 4.0) < 1e-9);
    }
};

TOUCHDOWN_TEST(TestExpectedCost)

} // namespace test_expected_cost

#include "test_expected_cost.moc"
