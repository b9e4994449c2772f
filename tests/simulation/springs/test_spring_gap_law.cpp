// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pressure of the gap under the pad of the spring model.
#include <cmath>
#include <random>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/simulation/equilibria/spring_equilibria.h"
#include "core/simulation/springs/spring_model.h"
#include "tests/simulation/run_trace.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spring_gap_law {

using State = SpringModel::State;

/// Summits that reach above the static flying height of 7 nm.
Case onSummits()
{
    Case c;
    c.contact = ContactKind::Asperity;
    c.asperity = {.radius = 2e-6, .density = 5e12, .heightDeviation = 0.5e-9, .planeHeight = 7.5e-9, .friction = 0.4};
    c.pad.length = c.pad.width = 20e-6;
    c.run.duration = 1e-3;
    c.run.sampleInterval = 1e-6;
    return c;
}

class TestSpringGapLaw : public QObject {
    Q_OBJECT

private slots:
    /// At states drawn near the summits, with an attraction: central differences.
    void jacobianFollowsDifferences()
    {
        Case c = onSummits();
        c.adhesion.kind = AdhesionKind::LennardJones;
        const SpringModel model(c);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        for (int i = 0; i < 30; ++i) {
            State y = model.staticState() + model.scale().cwiseProduct(State(0.2 * unit(random), 0.2 * unit(random),
                                                                             unit(random), unit(random)));
            const auto jacobian = model.jacobian(y, {});
            for (int k = 0; k < 4; ++k) {
                State step = State::Zero();
                step[k] = 1e-6 * model.scale()[k];
                const Eigen::Vector2d difference =
                    (model.derivative(y + step, {}) - model.derivative(y - step, {})).tail<2>() / (2.0 * step[k]);
                for (int row = 0; row < 2; ++row) {
                    const double size =
                        jacobian.row(row).cwiseAbs().cwiseProduct(model.scale().transpose()).maxCoeff() /
                        model.scale()[k];
                    QVERIFY2(std::abs(jacobian(row, k) - difference[row]) < 1e-5 * size,
                             qPrintable(QString("%1 %2 %3").arg(i).arg(row).arg(k)));
                }
            }
        }
    }

    /// dE/dt along the motion is the power of dashpots, contact and friction.
    void powerIsTheRateOfTheEnergy()
    {
        const SpringModel model(onSummits());
        State y = model.staticState();
        y += State(-0.3e-9, 1e-6, 2e-3, -3.0);
        const State rate = model.derivative(y, {});
        const double h = 1e-12;
        const double change = (model.energy(y + h * rate) - model.energy(y - h * rate)) / (2.0 * h);
        QVERIFY2(std::abs(change - model.power(y, {})) < 1e-5 * std::abs(change),
                 qPrintable(QString("%1 %2").arg(change).arg(model.power(y, {}))));
    }

    /// The force is the summits', and the energy balance holds over a run that bounces on them.
    void runKeepsTheEnergy()
    {
        Case c = onSummits();
        c.initial.flyingHeight = 60e-9;
        c.run.tolerance = 1e-10;
        const Summary summary = run(c, {}, {.energyBalance = true});
        QCOMPARE(summary.status, RunStatus::Completed);
        double most = 0.0;
        for (const auto& [quantity, extremes] : summary.extremes)
            if (quantity == "contact_force") most = extremes.most;
        QVERIFY(most > 1e-4);
        for (const RunFigure& figure : summary.figures)
            if (figure.quantity.name == "energy_balance")
                QVERIFY2(figure.value < 1e-5, qPrintable(QString::number(figure.value)));
    }

    /// The one equilibrium that is found is where a run with damping comes to rest.
    void settlesOnItsEquilibrium()
    {
        Case c = onSummits();
        c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.2;
        const SpringModel model(c);
        const std::vector<FoundEquilibrium> found = springEquilibria(model);
        QCOMPARE(found.size(), std::size_t(1));
        const double spacing = model.guards(found.front().q)[SpringModel::Pad];
        QVERIFY(spacing > 7.01e-9); // lifted by the summits
        c.initial.flyingHeight = 8e-9;
        c.initial.pitch = c.springs.pitch;
        const Summary summary = run(c);
        QVERIFY2(std::abs(test::finalValue(summary, "flying_height") - spacing) < 1e-13,
                 qPrintable(QString::number(test::finalValue(summary, "flying_height") - spacing)));
        QVERIFY(test::finalValue(summary, "contact_area") > 0.0);
    }
};

TOUCHDOWN_TEST(TestSpringGapLaw)

} // namespace test_spring_gap_law

#include "test_spring_gap_law.moc"
