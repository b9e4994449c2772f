// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/law_switch.h"

#include <cmath>

#include <QtTest>

#include "core/case/parameters.h"
#include "core/simulation/contact/slider_contact.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_law_switch {

constexpr double width = 0.1e-9, shortest = 1e-14, dt = 1e-6;

/// A law that holds from 3 nm on.
class Law : public SliderContact {
public:
    const SliderContactForces& at(const Attitude&, double) override { return none_; }
    Matrix3 stiffness() const override { return Matrix3::Zero(); }
    bool outOfReach(const Attitude&) const override { return false; }
    void accept() override {}
    double separation(const Attitude& attitude) const override { return attitude.height; }
    Interval interval() const override { return {3e-9, INFINITY}; }

private:
    SliderContactForces none_;
};

/// A step that begins at a height and moves at a constant speed.
struct Step {
    Step(double height, double speed) : body(defaultsOf(ModelKind::Film), {})
    {
        begin.motion.q = {height, 0.0, 0.0};
        begin.motion.v = end.motion.v = {speed, 0.0, 0.0};
        end.motion.q = {height + speed * dt, 0.0, 0.0};
        end.time = end.dt = dt;
    }
    SliderBody body;
    Law law;
    FilmPoint begin, end;
};

bool near(double value, double expected) { return std::abs(value - expected) <= 1e-9 * std::abs(expected); }

class TestLawSwitch : public QObject {
    Q_OBJECT

private slots:
    /// From 10 nm at 20 mm/s down: half of the width below 3 nm after (10 - 2.95) nm / 20 mm/s = 352.5 ns.
    void theWay()
    {
        const Step step(10e-9, -0.02);
        const auto way = wayToSwitch(step.law, step.body, step.begin, step.end, width, shortest);
        QVERIFY(way);
        QVERIFY2(near(*way, 352.5e-9), qPrintable(QString::number(*way)));
        // At 10 mm/s twice that, at 6 mm/s it stays above.
        const Step slow(10e-9, -0.01);
        QVERIFY(near(*wayToSwitch(slow.law, slow.body, slow.begin, slow.end, width, shortest), 705e-9));
        const Step above(10e-9, -0.006);
        QVERIFY(!wayToSwitch(above.law, above.body, above.begin, above.end, width, shortest));
    }
    /// Beyond the switch by less than its width at the end alone: the whole step.
    void justCrossed()
    {
        const Step step(10e-9, -0.00705);
        QCOMPARE(*wayToSwitch(step.law, step.body, step.begin, step.end, width, shortest), dt);
    }
    /// At 3.02 nm there is 0.07 nm to the middle of the width, and the law still holds; at 2.96 nm 0.01 nm, and it does
    /// not.
    void theAim()
    {
        const Step step(10e-9, -0.02);
        SliderMotion tried = step.end.motion;
        tried.q[0] = 3.02e-9;
        SwitchAim aim = aimAtSwitch(step.law, step.body, step.begin.motion, tried, 349e-9, width);
        QVERIFY(!aim.upper);
        QVERIFY(!aim.reached);
        QVERIFY(std::abs(aim.miss - 0.07e-9) < 1e-18);
        QVERIFY(std::abs(aim.rate + 0.02) < 1e-8);
        tried.q[0] = 2.96e-9;
        aim = aimAtSwitch(step.law, step.body, step.begin.motion, tried, 352e-9, width);
        QVERIFY(aim.reached);
        QVERIFY(std::abs(aim.miss - 0.01e-9) < 1e-18);
        // Where it turns back at the end of the step, the way from the beginning tells the rate: -7.04 nm in 352 ns.
        tried.v[0] = 0.01;
        QVERIFY(near(aimAtSwitch(step.law, step.body, step.begin.motion, tried, 352e-9, width).rate, -0.02));
    }
};

TOUCHDOWN_TEST(TestLawSwitch)

} // namespace test_law_switch

#include "test_law_switch.moc"
