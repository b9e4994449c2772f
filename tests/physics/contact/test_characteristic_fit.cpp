// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/characteristic_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/physics/contact/multi_asperity.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_characteristic_fit {

struct Setting {
    Asperities asperities{.radius = 1e-6, .density = 8.5e12, .heightDeviation = 0.2e-9, .planeHeight = 2.1e-9};
    Meniscus meniscus{.surfaceTension = 0.025, .contactAngle = 0.0, .filmThickness = 0.5e-9, .breakingLength = 1.5e-9};
    ElasticPair pair;
    double area = 62e-6 * 62e-6;

    MultiAsperity model() const { return {asperities, meniscus, pair, area}; }
};

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

bool finite(const CharacteristicFit& fit)
{
    const OnoYamane& p = fit.parameters;
    for (const double value : {p.meniscusForce, p.contactStiffness, p.initialContactForce, p.touchDown, p.takeOff,
                               fit.contact.worst, fit.contact.rms, fit.adhesion.worst, fit.adhesion.rms})
        if (!std::isfinite(value)) return false;
    return p.meniscusForce >= 0.0 && p.contactStiffness >= 0.0 && p.initialContactForce >= 0.0 &&
           p.takeOff >= p.touchDown;
}

class TestCharacteristicFit : public QObject {
    Q_OBJECT

private slots:
    /// Which surfaces the five parameters describe: dense and low ones, as the paper says, and not the others.
    void describesDenseAndLow_data()
    {
        QTest::addColumn<double>("density");
        QTest::addColumn<double>("deviation");
        QTest::addColumn<bool>("describes");
        QTest::newRow("dense and low") << 8.5e12 << 0.2e-9 << true;
        QTest::newRow("denser and lower") << 20e12 << 0.1e-9 << true;
        QTest::newRow("dense and tall") << 8.5e12 << 0.6e-9 << false;
        QTest::newRow("sparse and low") << 1e12 << 0.2e-9 << false;
        QTest::newRow("sparse and tall") << 1e12 << 0.8e-9 << false;
    }
    void describesDenseAndLow()
    {
        QFETCH(double, density);
        QFETCH(double, deviation);
        QFETCH(bool, describes);
        Setting s;
        s.asperities.density = density;
        s.asperities.heightDeviation = deviation;
        const CharacteristicFit fit = fitCharacteristic(s.model(), 0.0, 1e-9);
        QVERIFY(finite(fit));
        const QString found = QString("%1 contact %2 adhesion %3")
                                  .arg(fit.message.c_str())
                                  .arg(fit.contact.worst)
                                  .arg(fit.adhesion.worst);
        QVERIFY2(fit.describes == describes, qPrintable(found));
        QCOMPARE(fit.describes, fit.contact.worst <= 0.1 && fit.adhesion.worst <= 0.1);
        QVERIFY(fit.contact.rms <= fit.contact.worst && fit.adhesion.rms <= fit.adhesion.worst);
        QVERIFY(fit.message.starts_with(describes ? "The five parameters describe"
                                                  : "The five parameters do not describe"));
    }

    /// Summits all alike at y_s: d_s = y_s + t, d_e = y_s + h_b + f_m/k_b, f_m of all menisci; F_cr is stiff against
    /// the bulk, so k_c tends to k_b and F_cr = f_m + k_b (s - d) with s little below y_s: f_c0 = f_m - k_b (d_s - s).
    /// The summits give way by w = (F_cr/(eta A (4/3) E* sqrt(R)))^(2/3), 0.12 nm for 5 mN and 0.20 nm for 10 mN, so
    /// k_c = k_b to a tenth.
    void summitsOfOneHeight()
    {
        Setting s;
        s.asperities.heightDeviation = 1e-12;
        const MultiAsperity model = s.model();
        const CharacteristicFit fit = fitCharacteristic(model, 0.0, 1e-9);
        const double fm = s.asperities.density * s.area * 4.0 * std::numbers::pi * 1e-6 * 0.025;
        const double kb = model.bulkStiffness();
        QVERIFY2(fit.describes, fit.message.c_str());
        // What keeps the work makes up for the curve of F_cr.
        QVERIFY2(near(fit.parameters.meniscusForce, fm, 0.02 * fm),
                 qPrintable(QString::number(fit.parameters.meniscusForce / fm)));
        QVERIFY(near(OnoYamaneLaw(fit.parameters).cycleWork(), fit.cycleWork, 1e-9 * fit.cycleWork));
        QVERIFY(near(fit.parameters.touchDown, 2.6e-9, 5e-12));
        QVERIFY(near(fit.parameters.takeOff, 3.6e-9 + fm / kb, 5e-12));
        QVERIFY(fit.parameters.contactStiffness < kb && fit.parameters.contactStiffness > 0.9 * kb);
        QVERIFY(fit.adhesion.worst < 0.02);
    }

    /// The law with the fitted parameters, followed by its own rules, stays within the error that the fit states, on
    /// places that the fit did not use.
    void errorsAreWhatTheLawGives()
    {
        const Setting s;
        const MultiAsperity model = s.model();
        const CharacteristicFit fit = fitCharacteristic(model, 0.0, 1e-9);
        const OnoYamaneLaw law(fit.parameters);
        const auto curve = multiAsperityCurve(model, model.reach(), 1e-9, 1237);
        double largest = 0.0;
        for (const MultiAsperityPoint& point : curve.towards) largest = std::max(largest, point.forces.contact);
        ContactBranch branch = ContactBranch::TouchDown;
        double worstContact = 0.0, worstAdhesion = 0.0;
        for (const auto* way : {&curve.towards, &curve.away}) {
            for (std::size_t i = 0; i < way->size(); ++i) {
                const double d = (*way)[i].padSeparation;
                branch = law.nextBranch(branch, d);
                // The two ends of a jump lie at one d, where either side is right.
                if (d == fit.parameters.touchDown || d == fit.parameters.takeOff) continue;
                const ContactRegion region = law.region(branch, d);
                worstContact =
                    std::max(worstContact, std::abs(law.contactForce(region, d) - (*way)[i].forces.contact) / largest);
                worstAdhesion =
                    std::max(worstAdhesion, std::abs(law.adhesionForce(region, d) - (*way)[i].forces.adhesion) /
                                                fit.parameters.meniscusForce);
            }
        }
        QVERIFY2(worstContact < 1.05 * fit.contact.worst,
                 qPrintable(QString("%1 %2").arg(worstContact).arg(fit.contact.worst)));
        QVERIFY2(worstAdhesion < 1.05 * fit.adhesion.worst,
                 qPrintable(QString("%1 %2").arg(worstAdhesion).arg(fit.adhesion.worst)));
    }

    /// The default surface and lubricant, on a pad of 62 x 62 um, come near the paper's five values.
    void defaultsComeNearThePaper()
    {
        const MultiAsperity model(Asperities{}, Meniscus{}, ElasticPair{}, 62e-6 * 62e-6);
        const CharacteristicFit fit = fitCharacteristic(model, 0.0, 1e-9);
        QVERIFY2(fit.describes, fit.message.c_str());
        OnoYamane paper;
        paper.meniscusForce = 10e-3;
        const OnoYamane& p = fit.parameters;
        QVERIFY(near(OnoYamaneLaw(p).cycleWork(), fit.cycleWork, 1e-6 * fit.cycleWork));
        QVERIFY(near(p.touchDown, paper.touchDown, 0.05e-9));
        QVERIFY(near(p.takeOff, paper.takeOff, 0.05e-9));
        QVERIFY(near(p.meniscusForce, paper.meniscusForce, 0.5e-3));
        QVERIFY(near(p.contactStiffness, paper.contactStiffness, 0.2e6));
        QVERIFY(near(p.initialContactForce, paper.initialContactForce, 0.3e-3));
        QCOMPARE(p.takeOffShape, TakeOffShape::Constant);
    }

    /// The message names what fails.
    void messageNamesWhatFails_data()
    {
        QTest::addColumn<double>("density");
        QTest::addColumn<double>("deviation");
        QTest::addColumn<double>("tension");
        QTest::addColumn<double>("closest");
        QTest::addColumn<QString>("words");
        QTest::newRow("no touch-down jump") << 1e12 << 0.8e-9 << 0.025 << 1e-9 << "without a jump at touch-down";
        QTest::newRow("no take-off jump") << 1e12 << 0.8e-9 << 0.025 << 1e-9 << "without a jump at take-off";
        QTest::newRow("menisci before the jump") << 8.5e12 << 0.6e-9 << 0.025 << 1e-9 << "F_m is off by";
        QTest::newRow("contact not straight") << 1e12 << 0.8e-9 << 0.025 << 1e-9 << "F_cr is no straight line";
        QTest::newRow("no adhesion") << 8.5e12 << 0.2e-9 << 0.0 << 1e-9 << "no adhesion";
        QTest::newRow("turned before touch-down")
            << 8.5e12 << 0.2e-9 << 0.025 << 3.05e-9 << "but touches down at 3.02 nm";
        QTest::newRow("not deep enough") << 8.5e12 << 0.2e-9 << 0.025 << 6e-9 << "must go deeper";
    }
    void messageNamesWhatFails()
    {
        QFETCH(double, density);
        QFETCH(double, deviation);
        QFETCH(double, tension);
        QFETCH(double, closest);
        QFETCH(QString, words);
        Setting s;
        s.asperities.density = density;
        s.asperities.heightDeviation = deviation;
        s.meniscus.surfaceTension = tension;
        const CharacteristicFit fit = fitCharacteristic(s.model(), 0.0, closest);
        QVERIFY(!fit.describes);
        QVERIFY(finite(fit));
        QVERIFY2(QString(fit.message.c_str()).contains(words), fit.message.c_str());
    }

    void keepsTheFriction()
    {
        const CharacteristicFit fit = fitCharacteristic(Setting{}.model(), 0.0, 1e-9, {.friction = 0.7});
        QCOMPARE(fit.parameters.friction, 0.7);
    }
};

TOUCHDOWN_TEST(TestCharacteristicFit)

} // namespace test_characteristic_fit

#include "test_characteristic_fit.moc"
