// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/asperity_contact.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <QTest>

#include "core/physics/contact/asperity_model.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_asperity_contact {

using std::numbers::pi;

double normal(double u) { return std::exp(-0.5 * u * u) / std::sqrt(2.0 * pi); }

/// Adaptive Simpson.
double simpson(const std::function<double(double)>& f, double a, double fa, double m, double fm, double b, double fb,
               double whole, double tolerance, int depth)
{
    const double l = 0.5 * (a + m), r = 0.5 * (m + b);
    const double fl = f(l), fr = f(r);
    const double left = (m - a) / 6.0 * (fa + 4.0 * fl + fm);
    const double right = (b - m) / 6.0 * (fm + 4.0 * fr + fb);
    const double difference = left + right - whole;
    if (depth <= 0 || std::abs(difference) <= 15.0 * tolerance) return left + right + difference / 15.0;
    return simpson(f, a, fa, l, fl, m, fm, left, 0.5 * tolerance, depth - 1) +
           simpson(f, m, fm, r, fr, b, fb, right, 0.5 * tolerance, depth - 1);
}

double integral(const std::function<double(double)>& f, double a, double b, double tolerance)
{
    if (b <= a) return 0.0;
    double sum = 0.0;
    const int parts = 16; // so that a narrow peak is met
    for (int i = 0; i < parts; ++i) {
        const double lower = a + (b - a) * i / parts, upper = a + (b - a) * (i + 1) / parts,
                     middle = 0.5 * (lower + upper);
        const double fa = f(lower), fm = f(middle), fb = f(upper);
        sum += simpson(f, lower, fa, middle, fm, upper, fb, (upper - lower) / 6.0 * (fa + 4.0 * fm + fb),
                       tolerance / parts, 40);
    }
    return sum;
}

double relative(double value, double expected, double scale = 0.0)
{
    return std::abs(value - expected) / std::max(std::abs(expected), scale);
}

/// The plain integral over heights that the header states, of a summit's force P(w), in pieces at w_c.
double plainPressure(const Asperities& a, const std::function<double(double)>& force, double wc, double d)
{
    const double sigma = a.heightDeviation;
    const auto f = [&](double z) { return z <= d ? 0.0 : force(z - d) * normal(z / sigma) / sigma; };
    const double bottom = std::max(d, -14.0 * sigma), top = std::max(14.0 * sigma, d);
    const double middle = std::clamp(d + wc, bottom, top);
    const double scale = force(sigma);
    // At the very place of w_c both laws end in their own value: the pieces stop a hair beside it.
    const double hair = 1e-13 * sigma;
    return a.density * (integral(f, bottom, std::max(bottom, middle - hair), 1e-12 * scale) +
                        integral(f, std::min(top, middle + hair), top, 1e-12 * scale));
}

Asperities surface(AsperityModel model, double yield)
{
    Asperities a;
    a.model = model;
    a.radius = 2e-6;
    a.density = 10e12;
    a.heightDeviation = 0.5e-9;
    a.yieldStrength = yield;
    a.planeHeight = 0.0;
    return a;
}

class TestAsperityContact : public QObject {
    Q_OBJECT

private slots:
    /// F_n(0) = int_0^inf u^n phi du = 2^(n/2 - 1) Gamma((n+1)/2)/sqrt(pi): F_3/2(0) = 2^(-1/4) Gamma(5/4)/sqrt(pi) =
    /// 0.430019, F_5/2(0) = 2^(1/4) Gamma(7/4)/sqrt(pi), F_1(0) = 1/sqrt(2 pi), F_0(0) = 1/2; p' = -(3/2) F_1/2,
    /// F_1/2(0) = 2^(-3/4) Gamma(3/4)/sqrt(pi).
    void greenwoodWilliamsonAtTheMeanPlane()
    {
        const Asperities a = surface(AsperityModel::GreenwoodWilliamson, 1.0);
        const ElasticPair pair;
        const AsperityContact contact(a, pair);
        const double sigma = a.heightDeviation;
        const double unit = 4.0 / 3.0 * contactModulus(pair) * std::sqrt(a.radius) * a.density;
        const double root = std::sqrt(pi);
        QVERIFY(relative(contact.pressure(0.0),
                         unit * std::pow(sigma, 1.5) * std::pow(2.0, -0.25) * std::tgamma(1.25) / root) < 1e-11);
        QVERIFY(relative(contact.energy(0.0),
                         0.4 * unit * std::pow(sigma, 2.5) * std::pow(2.0, 0.25) * std::tgamma(1.75) / root) < 1e-12);
        QVERIFY(relative(contact.stiffness(0.0),
                         1.5 * unit * std::sqrt(sigma) * std::pow(2.0, -0.75) * std::tgamma(0.75) / root) < 1e-10);
        QVERIFY(relative(contact.contactArea(0.0), pi * a.radius * a.density * sigma / std::sqrt(2.0 * pi)) < 1e-13);
        QVERIFY(relative(contact.contactDensity(0.0), 0.5 * a.density) < 1e-13);
        QCOMPARE(contact.criticalInterference(), std::numeric_limits<double>::infinity());
    }

    /// Against an independent adaptive quadrature of the integral over heights, from everything pressed to the last
    /// summits.
    void tableAgreesWithAdaptiveQuadrature_data()
    {
        QTest::addColumn<double>("yield");
        QTest::newRow("elastic") << 0.0;
        // w_c = (pi K H/(2 E*))^2 R: 0.03, 0.5 and 3.3 sigma for these.
        QTest::newRow("soft: most contacts flow") << 0.1e9;
        QTest::newRow("some contacts flow") << 0.4e9;
        QTest::newRow("hard: few contacts flow") << 1.0e9;
        QTest::newRow("hard: some flow when pressed deep") << 2.3e9; // w_c = 17.6 sigma
    }
    void tableAgreesWithAdaptiveQuadrature()
    {
        QFETCH(double, yield);
        const ElasticPair pair;
        const Asperities a =
            surface(yield > 0.0 ? AsperityModel::ElasticPlastic : AsperityModel::GreenwoodWilliamson, yield);
        const AsperityContact contact(a, pair);
        const double modulus = contactModulus(pair);
        // The summit's laws once more, from the header's text.
        const double kh = (0.454 + 0.41 * pair.diskPoissonRatio) * 2.8 * yield;
        const double wc =
            yield > 0.0 ? std::pow(pi * kh / (2.0 * modulus), 2) * a.radius : std::numeric_limits<double>::infinity();
        const auto force = [&](double w) {
            return w < wc ? 4.0 / 3.0 * modulus * std::sqrt(a.radius) * std::pow(w, 1.5)
                          : pi * a.radius * kh * (2.0 * w - wc);
        };
        const auto area = [&](double w) { return pi * a.radius * (w < wc ? w : 2.0 * w - wc); };
        const double peak = contact.pressure(0.0);
        for (double t = -29.87; t < 6.0; t += 0.37) {
            const double d = t * a.heightDeviation;
            const double expected = plainPressure(a, force, wc, d);
            const double error = relative(contact.pressure(d), expected, peak);
            QVERIFY2(error < 1e-9, qPrintable(QString("t %1: %2").arg(t).arg(error)));
            const double share = plainPressure(a, area, wc, d);
            QVERIFY(relative(contact.contactArea(d), share, contact.contactArea(0.0)) < 1e-9);
        }
    }

    /// The table is one smooth function: at its joints value, pressure and stiffness agree from both sides; pressure is
    /// minus the energy's slope and stiffness minus the pressure's everywhere (central differences, whose error is
    /// h^2/6 of the third derivative: below 1e-7 for h = 1e-4 sigma).
    void smoothAndConsistent_data()
    {
        QTest::addColumn<AsperityModel>("model");
        QTest::addColumn<double>("yield");
        QTest::newRow("elastic") << AsperityModel::GreenwoodWilliamson << 1.0;
        QTest::newRow("some contacts flow") << AsperityModel::ElasticPlastic << 0.4e9;
        QTest::newRow("some flow when pressed deep") << AsperityModel::ElasticPlastic << 2.3e9;
    }
    void smoothAndConsistent()
    {
        QFETCH(AsperityModel, model);
        QFETCH(double, yield);
        const AsperityContact contact(surface(model, yield), {});
        const double sigma = 0.5e-9;
        const double peak = contact.pressure(0.0);
        for (double t = -30.0; t < 9.0; t += 0.125) {
            const double d = t * sigma;
            const double hair = 1e-9 * sigma;
            QVERIFY(relative(contact.pressure(d + hair), contact.pressure(d - hair), peak) < 1e-7);
            QVERIFY(relative(contact.stiffness(d + hair), contact.stiffness(d - hair), peak / sigma) < 1e-7);
            const double h = 1e-4 * sigma;
            QVERIFY(relative((contact.energy(d - h) - contact.energy(d + h)) / (2.0 * h), contact.pressure(d), peak) <
                    1e-6);
            QVERIFY(relative((contact.pressure(d - h) - contact.pressure(d + h)) / (2.0 * h), contact.stiffness(d),
                             peak / sigma) < 1e-6);
        }
    }

    /// Pressure, stiffness and energy fall with the separation and are never negative; beyond the reach there is
    /// nothing.
    void fallsToNothing()
    {
        for (const AsperityModel model : {AsperityModel::GreenwoodWilliamson, AsperityModel::ElasticPlastic}) {
            const AsperityContact contact(surface(model, 0.4e9), {});
            double last = std::numeric_limits<double>::infinity();
            for (double t = -17.0; t < 9.1; t += 0.01) {
                const double p = contact.pressure(t * 0.5e-9);
                QVERIFY(p >= 0.0 && p <= last);
                QVERIFY(contact.stiffness(t * 0.5e-9) >= 0.0 && contact.energy(t * 0.5e-9) >= 0.0);
                last = p;
            }
            const double reach = contact.reach();
            QVERIFY(contact.pressure(std::nextafter(reach, 0.0)) >= 0.0);
            QVERIFY(contact.pressure(std::nextafter(reach, 0.0)) < 1e-17 * contact.pressure(0.0));
            QCOMPARE(contact.pressure(reach), 0.0);
            QCOMPARE(contact.stiffness(1.0), 0.0);
            QCOMPARE(contact.energy(1.0), 0.0);
            QCOMPARE(contact.contactArea(1.0), 0.0);
            QCOMPARE(contact.contactDensity(1.0), 0.0);
        }
    }

    /// Pressed far beyond their heights all summits are alike: p -> eta P(-d) (1 + (3/8)(sigma/d)^2) for w^(3/2), as
    /// E[(1 + e)^(3/2)] = 1 + (3/8) E[e^2] + (3/128) E[e^4] + ...; with E[e^4] = 3e-8 the last is below 1e-9 at d =
    /// -100 sigma.
    void allSummitsAlikeWhenPressedDeep()
    {
        const Asperities a = surface(AsperityModel::GreenwoodWilliamson, 1.0);
        const AsperityContact contact(a, {});
        const double d = -100.0 * a.heightDeviation;
        const double expected =
            a.density * 4.0 / 3.0 * contactModulus({}) * std::sqrt(a.radius) * std::pow(-d, 1.5) * (1.0 + 0.375e-4);
        QVERIFY(relative(contact.pressure(d), expected) < 1e-8);
    }

    /// w_c by hand: E* = 1/((1 - 0.25^2)/100e9 + (1 - 0.24^2)/390e9) = 84.8075e9 Pa; K H = (0.454 + 0.41*0.25)*2.8*2e9
    /// = 3.1164e9 Pa; w_c = (pi*3.1164/(2*84.8075))^2 * 2 um = 6.6635 nm.
    void criticalInterferenceByHand()
    {
        const AsperityContact contact(surface(AsperityModel::ElasticPlastic, 2e9), {});
        QVERIFY(std::abs(contact.criticalInterference() - 6.6635e-9) < 0.0005e-9);
    }

    /// A yield strength that nothing reaches leaves the elastic model; a low one carries less at the same separation.
    void yieldingCarriesLess()
    {
        const AsperityContact elastic(surface(AsperityModel::GreenwoodWilliamson, 1.0), {});
        const AsperityContact hard(surface(AsperityModel::ElasticPlastic, 100e9), {});
        const AsperityContact soft(surface(AsperityModel::ElasticPlastic, 0.1e9), {});
        for (double t = -5.0; t < 5.0; t += 0.5) {
            QVERIFY(relative(hard.pressure(t * 0.5e-9), elastic.pressure(t * 0.5e-9)) < 1e-12);
            QVERIFY(soft.pressure(t * 0.5e-9) < elastic.pressure(t * 0.5e-9));
            QVERIFY(soft.contactArea(t * 0.5e-9) > elastic.contactArea(t * 0.5e-9));
        }
    }

    /// Summits that lie higher by y_s meet the flat y_s earlier.
    void summitsLieAboveTheMeanPlane()
    {
        Asperities a = surface(AsperityModel::GreenwoodWilliamson, 1.0);
        const AsperityContact low(a, {});
        a.planeHeight = 2e-9;
        const AsperityContact high(a, {});
        for (const double d : {-20e-9, -1e-9, 0.0, 1e-9}) {
            QVERIFY(relative(high.pressure(d + 2e-9), low.pressure(d)) < 1e-12);
            QVERIFY(relative(high.stiffness(d + 2e-9), low.stiffness(d)) < 1e-12);
            QVERIFY(relative(high.energy(d + 2e-9), low.energy(d)) < 1e-12);
            QVERIFY(relative(high.contactArea(d + 2e-9), low.contactArea(d)) < 1e-12);
            QVERIFY(relative(high.contactDensity(d + 2e-9), low.contactDensity(d)) < 1e-12);
        }
        QCOMPARE(high.reach(), 2e-9 + low.reach());
    }

    void allocatesNothing()
    {
        const AsperityContact contact(surface(AsperityModel::ElasticPlastic, 0.4e9), {});
        double sum = 0.0;
        const auto before = test::allocations.load();
        for (double t = -20.0; t < 10.0; t += 0.1) {
            const double d = t * 0.5e-9;
            sum += contact.pressure(d) + contact.stiffness(d) + contact.energy(d) + contact.contactArea(d) +
                   contact.contactDensity(d);
        }
        QCOMPARE(test::allocations.load(), before);
        QVERIFY(std::isfinite(sum));
    }
};

TOUCHDOWN_TEST(TestAsperityContact)

} // namespace test_asperity_contact

#include "test_asperity_contact.moc"
