// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_energy_balance.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spring_energy_balance {

double imbalance(const Case& c)
{
    const Summary summary = run(c, {}, {.energyBalance = true});
    for (const RunFigure& figure : summary.figures)
        if (figure.quantity.name == "energy_balance" && summary.status == RunStatus::Completed) return figure.value;
    return std::nan("");
}

Case drop(IntegratorKind integrator, double step = 10e-9)
{
    Case c;
    c.run.integrator = integrator;
    c.run.step = step;
    c.run.stepCheck = false;
    return c;
}

class TestSpringEnergyBalance : public QObject {
    Q_OBJECT

private slots:
    /// The fall until the pad first touches: what a method makes of energy shrinks as its order says, Simpson's rule
    /// being of fourth order too.
    void closesWithTheOrder_data()
    {
        QTest::addColumn<IntegratorKind>("integrator");
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("order");
        QTest::newRow("rk4-events") << IntegratorKind::Rk4Events << 40e-9 << 4.0;
        QTest::newRow("newmark") << IntegratorKind::Newmark << 40e-9 << 2.0;
    }
    void closesWithTheOrder()
    {
        QFETCH(IntegratorKind, integrator);
        QFETCH(double, step);
        QFETCH(double, order);
        Case c = drop(integrator, step);
        c.run.duration = 20e-6;
        const double coarse = imbalance(c);
        c.run.step = 0.5 * step;
        const double fine = imbalance(c);
        QVERIFY2(std::abs(std::log2(coarse / fine) - order) < 0.15,
                 qPrintable(QString("%1, %2").arg(coarse).arg(fine)));
        QVERIFY2(fine < 1e-3, qPrintable(QString::number(fine)));
    }
    /// The whole drop, with 28 switches.
    void closesWithDopri5()
    {
        Case c = drop(IntegratorKind::Dopri5);
        c.run.tolerance = 1e-10;
        QVERIFY2(imbalance(c) < 1e-6, qPrintable(QString::number(imbalance(c))));
    }
    /// Switches that are looked for between steps come late by up to a step: in 10 ns the pad goes some 0.2 nm at 20
    /// mm/s, under a wrong force of f_m + f_c0 = 15 mN at most, 3e-12 J of some 1e-10 J a drop; ten times less with a
    /// tenth of the step.
    void showsSwitchesThatAreMissed()
    {
        const double naive = imbalance(drop(IntegratorKind::Rk4, 10e-9)),
                     located = imbalance(drop(IntegratorKind::Rk4Events, 10e-9));
        QVERIFY2(naive > 30.0 * located, qPrintable(QString("%1, %2").arg(naive).arg(located)));
        const double finer = imbalance(drop(IntegratorKind::Rk4, 1e-9));
        QVERIFY2(finer < naive && naive < 0.2, qPrintable(QString("%1, %2").arg(naive).arg(finer)));
    }
    /// gamma < 1/2 feeds energy to each oscillation: (1/2 - gamma) omega dt a radian, more than is lost at xi = 0.01
    /// here.
    void showsEnergyThatAMethodMakes()
    {
        Case c = drop(IntegratorKind::Newmark, 50e-9);
        const double right = imbalance(c);
        c.run.newmarkGamma = 0.6; // and gamma > 1/2 takes it away
        const double damped = imbalance(c);
        QVERIFY2(damped > 3.0 * right && damped > 0.05, qPrintable(QString("%1, %2").arg(damped).arg(right)));
    }
    /// The linear take-off law, a start in contact, friction: every part of the balance counts.
    void closesInContact()
    {
        Case c = drop(IntegratorKind::Dopri5);
        c.run.tolerance = 1e-11;
        c.onoYamane.takeOffShape = TakeOffShape::Linear;
        c.onoYamane.friction = 2.0;
        c.onoYamane.meniscusForce = 30e-3;
        c.initial.flyingHeight = 1e-9;
        QVERIFY2(imbalance(c) < 1e-5, qPrintable(QString::number(imbalance(c))));
    }
    /// The balance is computed on request alone.
    void onlyWhenAsked()
    {
        const auto has = [](const Summary& summary) {
            return std::ranges::any_of(summary.figures,
                                       [](const RunFigure& f) { return f.quantity.name == "energy_balance"; });
        };
        QVERIFY(!has(run(drop(IntegratorKind::Rk4Events))));
        QVERIFY(has(run(drop(IntegratorKind::Rk4Events), {}, {.energyBalance = true})));
    }
};

TOUCHDOWN_TEST(TestSpringEnergyBalance)

} // namespace test_spring_energy_balance

#include "test_spring_energy_balance.moc"
