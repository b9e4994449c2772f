// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/interval.h"
#include "core/physics/contact/ono_yamane.h"

#include <array>
#include <cmath>
#include <random>
#include <string>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_ono_yamane {

using enum ContactRegion;

bool near(double a, double b, double tolerance = 1e-15) { return std::abs(a - b) <= tolerance; }

/// Those of Figs. 5 to 8 with f_m = 10 mN and d_e = 5 nm.
OnoYamane paperValues(TakeOffShape shape = TakeOffShape::Constant)
{
    OnoYamane p;
    p.meniscusForce = 10e-3;
    p.takeOffShape = shape;
    return p;
}

/// Follows the separation from place to place, as a quasi-static cycle does.
ContactRegion follow(const OnoYamaneLaw& law, ContactRegion region, double to)
{
    for (int i = 0; i < 5; ++i) {
        const Interval interval = law.interval(region);
        if (to < interval.lower)
            region = law.beyond(region, false);
        else if (to > interval.upper)
            region = law.beyond(region, true);
        else
            return region;
    }
    return region;
}

class TestOnoYamane : public QObject {
    Q_OBJECT

private slots:
    /// The paper's values: f_c0 = 5 mN, k_c = 5e6 N/m, d_s = 3 nm, d_e = 5 nm, f_m = 10 mN. On the take-off branch F_cr
    /// ends at d_s + f_c0/k_c = 4 nm.
    void touchDownAndTakeOff_data()
    {
        QTest::addColumn<double>("d");
        QTest::addColumn<int>("region");
        QTest::addColumn<double>("real");
        QTest::addColumn<double>("adhesion");
        QTest::newRow("coming from above") << 4.5e-9 << int(Apart) << 0.0 << 0.0;
        QTest::newRow("just above touch-down") << 3.01e-9 << int(Apart) << 0.0 << 0.0;
        QTest::newRow("at 2 nm") << 2e-9 << int(Pressed) << 10e-3 << -10e-3;
        QTest::newRow("lifting through 3.5 nm") << 3.5e-9 << int(Lifting) << 2.5e-3 << -10e-3;
        QTest::newRow("held at 4.5 nm") << 4.5e-9 << int(Bridged) << 0.0 << -10e-3;
        QTest::newRow("back to 3.5 nm") << 3.5e-9 << int(Lifting) << 2.5e-3 << -10e-3;
        QTest::newRow("held again") << 4.9e-9 << int(Bridged) << 0.0 << -10e-3;
        QTest::newRow("taken off") << 5.01e-9 << int(Apart) << 0.0 << 0.0;
        QTest::newRow("no force on coming back") << 3.5e-9 << int(Apart) << 0.0 << 0.0;
    }
    void touchDownAndTakeOff()
    {
        static const OnoYamaneLaw law{paperValues()};
        static const std::array<double, 9> way{4.5e-9, 3.01e-9, 2e-9, 3.5e-9, 4.5e-9, 3.5e-9, 4.9e-9, 5.01e-9, 3.5e-9};
        QFETCH(double, d);
        QFETCH(int, region);
        QFETCH(double, real);
        QFETCH(double, adhesion);
        // Each row is reached by the whole way before it, so that rows may run alone.
        ContactRegion at = Apart;
        bool reached = false;
        for (const double place : way) {
            at = follow(law, at, place);
            if (place == d && int(at) == region) {
                reached = true;
                break;
            }
        }
        QVERIFY(reached);
        QVERIFY(near(law.contactForce(at, d), real));
        QVERIFY(near(law.adhesionForce(at, d), adhesion));
    }

    /// Linear shape: F_m = -f_m (d_e - d)/(d_e - d_s); at 3.5 nm -7.5 mN, continuous at both ends.
    void linearTakeOffShape()
    {
        OnoYamane parameters = paperValues();
        parameters.takeOffShape = TakeOffShape::Linear;
        const OnoYamaneLaw law(parameters);
        QVERIFY(near(law.adhesionForce(Lifting, 3.5e-9), -7.5e-3));
        QVERIFY(near(law.adhesionForce(Lifting, 3e-9), -10e-3));
        QVERIFY(near(law.adhesionForce(Bridged, 5e-9), 0.0));
        QVERIFY(near(law.adhesionForce(Pressed, 1e-9), -10e-3));
    }

    /// F_cr = f_c0 (d_e - d)/(d_e - d_s): at 4 nm half of 5 mN, and F_m half of -10 mN.
    void bothLinearTakeOffShape()
    {
        const OnoYamaneLaw law(paperValues(TakeOffShape::BothLinear));
        QVERIFY(near(law.contactForce(Lifting, 4e-9), 2.5e-3));
        QVERIFY(near(law.adhesionForce(Lifting, 4e-9), -5e-3));
        QVERIFY(near(law.contactForce(Lifting, 5e-9), 0.0));
        QVERIFY(near(law.contactForce(Pressed, 2e-9), 10e-3));
        QCOMPARE(law.beyond(Lifting, true), Apart);
        // 10 mN falling to 5 mN over 1 nm, then to zero over 2 nm.
        QVERIFY(near(law.storedEnergy(Pressed, 2e-9), 7.5e-12 + 5e-12, 1e-25));
    }

    /// W against the formulas, where F_cr ends before d_e.
    void workOfACycle()
    {
        const double loop = 10e-3 * 2e-9, brought = 5e-3 * 5e-3 / (2 * 5e6);
        const auto work = [](TakeOffShape shape) { return OnoYamaneLaw(paperValues(shape)).cycleWork(); };
        QVERIFY(near(work(TakeOffShape::Constant), loop - brought, 1e-25));
        QVERIFY(near(work(TakeOffShape::Linear), 0.5 * loop - brought, 1e-25));
        QVERIFY(near(work(TakeOffShape::BothLinear), 0.5 * (10e-3 - 5e-3) * 2e-9, 1e-25));
    }

    /// f_m (d_e - d_s) = f_c0^2/(2 k_c): the loop has no area, and its W is 0 and no round-off.
    void workIsExactlyZero_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("takeOff");
        for (const TakeOffShape shape : {TakeOffShape::Constant, TakeOffShape::Linear, TakeOffShape::BothLinear})
            for (const double takeOff : {4e-9, 4.3e-9, 5e-9, 5.7e-9})
                QTest::addRow("%s, %g", std::string(name(shape)).c_str(), takeOff) << int(shape) << takeOff;
    }
    void workIsExactlyZero()
    {
        QFETCH(int, shape);
        QFETCH(double, takeOff);
        OnoYamane p = paperValues(TakeOffShape(shape));
        p.takeOff = takeOff;
        const double each = p.initialContactForce * p.initialContactForce / (2.0 * p.contactStiffness) /
                            (p.takeOff - p.touchDown); // [N]
        const std::array zeros{each, 2.0 * each, p.initialContactForce};
        p.meniscusForce = zeros.at(std::size_t(shape));
        QVERIFY(OnoYamaneLaw(p).cycleWork() == 0.0); // QCOMPARE takes 1e-13 for zero
        p.meniscusForce *= 1.0 + 1e-6;
        QVERIFY(OnoYamaneLaw(p).cycleWork() > 0.0);
        p.meniscusForce /= 1.0 + 2e-6;
        QVERIFY(OnoYamaneLaw(p).cycleWork() < 0.0);
    }

    /// W against the forces added up along the way down and up, by the midpoint rule, which is exact for a piecewise
    /// affine force but for the pieces that hold a corner. 200 laws of each shape, drawn at random.
    void workOfACycleAddsUp_data()
    {
        QTest::addColumn<int>("shape");
        for (const TakeOffShape shape : {TakeOffShape::Constant, TakeOffShape::Linear, TakeOffShape::BothLinear})
            QTest::newRow(std::string(name(shape)).c_str()) << int(shape);
    }
    void workOfACycleAddsUp()
    {
        QFETCH(int, shape);
        std::mt19937 random(18);
        const auto draw = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
        int negative = 0;
        for (int i = 0; i < 200; ++i) {
            OnoYamane p = paperValues(TakeOffShape(shape));
            p.meniscusForce = draw(0.0, 20e-3);
            p.contactStiffness = draw(0.5e6, 2e7);
            p.initialContactForce = draw(0.0, 15e-3);
            p.takeOff = p.touchDown + draw(0.1e-9, 6e-9);
            const OnoYamaneLaw law(p);
            double work = 0.0;
            ContactRegion region = Apart;
            const double top = p.takeOff + 0.5e-9, bottom = p.touchDown - 0.5e-9;
            constexpr int pieces = 20000;
            const double step = (top - bottom) / pieces;
            for (const double direction : {-1.0, 1.0})
                for (int k = 0; k < pieces; ++k) {
                    const double d = direction < 0.0 ? top - (k + 0.5) * step : bottom + (k + 0.5) * step;
                    region = follow(law, region, d);
                    work -= direction * step * (law.contactForce(region, d) + law.adhesionForce(region, d));
                }
            QCOMPARE(region, Apart);
            const double scale = p.meniscusForce + p.initialContactForce + p.contactStiffness * 1e-9;
            QVERIFY2(near(work, law.cycleWork(), 4.0 * step * scale), qPrintable(QString::number(i)));
            // The f_m that is found for a work gives it.
            OnoYamane other = p;
            other.meniscusForce = meniscusForceForWork(p, 3e-11);
            QVERIFY(near(OnoYamaneLaw(other).cycleWork(), 3e-11, 1e-23));
            negative += law.cycleWork() < 0.0;
        }
        QVERIFY(negative > 10 && negative < 190);
    }

    /// What F_cr would still do on lifting: at 2 nm, 10 mN falling to zero over 2 nm: 1e-11 J.
    void storedEnergy()
    {
        const OnoYamaneLaw law{paperValues()};
        QVERIFY(near(law.storedEnergy(Pressed, 2e-9), 1e-11, 1e-25));
        QVERIFY(near(law.storedEnergy(Lifting, 3.5e-9), 0.5 * 2.5e-3 * 0.5e-9, 1e-25));
        QCOMPARE(law.storedEnergy(Bridged, 4.5e-9), 0.0);
        QCOMPARE(law.storedEnergy(Apart, 2.0e-9), 0.0);
        // Let go at d_e = 3.5 nm with 2.5 mN left: (10 + 2.5)/2 mN over 1.5 nm.
        OnoYamane early = paperValues();
        early.takeOff = 3.5e-9;
        QVERIFY(near(OnoYamaneLaw(early).storedEnergy(Pressed, 2e-9), 9.375e-12, 1e-25));
    }

    void regionsOfNoWidthAreSteppedOver_data()
    {
        QTest::addColumn<double>("takeOff");
        QTest::addColumn<double>("initialForce");
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<int>("abovePressed");
        QTest::addColumn<int>("aboveLifting");
        QTest::newRow("the paper's") << 5e-9 << 5e-3 << 5e6 << int(Lifting) << int(Bridged);
        QTest::newRow("F_cr ends beyond take-off") << 3.5e-9 << 5e-3 << 5e6 << int(Lifting) << int(Apart);
        QTest::newRow("no initial force") << 5e-9 << 0.0 << 5e6 << int(Bridged) << int(Bridged);
        QTest::newRow("no hysteresis at all") << 3e-9 << 5e-3 << 5e6 << int(Apart) << int(Apart);
        QTest::newRow("neither") << 3e-9 << 0.0 << 5e6 << int(Apart) << int(Apart);
        QTest::newRow("constant force") << 5e-9 << 5e-3 << 0.0 << int(Lifting) << int(Apart);
        QTest::newRow("no force") << 5e-9 << 0.0 << 0.0 << int(Bridged) << int(Bridged);
    }
    void regionsOfNoWidthAreSteppedOver()
    {
        QFETCH(double, takeOff);
        QFETCH(double, initialForce);
        QFETCH(double, stiffness);
        QFETCH(int, abovePressed);
        QFETCH(int, aboveLifting);
        OnoYamane parameters = paperValues();
        parameters.takeOff = takeOff;
        parameters.initialContactForce = initialForce;
        parameters.contactStiffness = stiffness;
        const OnoYamaneLaw law(parameters);
        QCOMPARE(int(law.beyond(Pressed, true)), abovePressed);
        if (abovePressed == int(Lifting)) QCOMPARE(int(law.beyond(Lifting, true)), aboveLifting);
        for (const ContactRegion region : {Apart, Pressed, Lifting, Bridged}) {
            QVERIFY(std::isfinite(law.contactForce(region, 2e-9)));
            QVERIFY(std::isfinite(law.adhesionForce(region, 2e-9)));
        }
    }

    void branches()
    {
        const OnoYamaneLaw law{paperValues()};
        QCOMPARE(law.region(ContactBranch::TouchDown, 4e-9), Apart);
        QCOMPARE(law.region(ContactBranch::TakeOff, 4.2e-9), Bridged);
        QCOMPARE(law.region(ContactBranch::TakeOff, 3.2e-9), Lifting);
        QCOMPARE(law.region(ContactBranch::TakeOff, 6e-9), Apart);
        QCOMPARE(law.region(ContactBranch::TouchDown, 3e-9), Pressed);
        QCOMPARE(law.nextBranch(ContactBranch::TouchDown, 4e-9), ContactBranch::TouchDown);
        QCOMPARE(law.nextBranch(ContactBranch::TakeOff, 4e-9), ContactBranch::TakeOff);
        QCOMPARE(law.nextBranch(ContactBranch::TakeOff, 5e-9), ContactBranch::TouchDown);
        QCOMPARE(law.nextBranch(ContactBranch::TouchDown, 3e-9), ContactBranch::TakeOff);
    }
    void namesOfSwitchesTellTheBranch()
    {
        QCOMPARE(branchAfterSwitch(switchName(Apart, Pressed)), std::optional(ContactBranch::TakeOff));
        QCOMPARE(branchAfterSwitch(switchName(Pressed, Lifting)), std::optional(ContactBranch::TakeOff));
        QCOMPARE(branchAfterSwitch(switchName(Bridged, Apart)), std::optional(ContactBranch::TouchDown));
        QVERIFY(!branchAfterSwitch("rear spring lost"));
        QVERIFY(!branchAfterSwitch(""));
    }
};

TOUCHDOWN_TEST(TestOnoYamane)

} // namespace test_ono_yamane

#include "test_ono_yamane.moc"
