// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/convection.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_convection {

EffectiveConductance conductance(ConvectionScheme scheme, double K, double c)
{
    switch (scheme) {
        using enum ConvectionScheme;
    case Upwind: return effectiveConductance<Upwind>(K, c);
    case Hybrid: return effectiveConductance<Hybrid>(K, c);
    case PowerLaw: return effectiveConductance<PowerLaw>(K, c);
    case Exponential: return effectiveConductance<Exponential>(K, c);
    case CompleteFlux: break;
    }
    return effectiveConductance<ConvectionScheme::CompleteFlux>(K, c);
}

void addSchemes()
{
    QTest::addColumn<ConvectionScheme>("scheme");
    QTest::newRow("upwind") << ConvectionScheme::Upwind;
    QTest::newRow("hybrid") << ConvectionScheme::Hybrid;
    QTest::newRow("power law") << ConvectionScheme::PowerLaw;
    QTest::newRow("exponential") << ConvectionScheme::Exponential;
    QTest::newRow("complete flux") << ConvectionScheme::CompleteFlux;
}

class TestConvection : public QObject {
    Q_OBJECT

private slots:
    /// u coth u and coth u - u/sinh^2 u in long double. The series below u = 0.02 leaves out 2 u^6/945 of the
    /// value, 1.4e-13, and 12 u^5/945 of the slope 2u/3, 3e-9 of it; the tail above 10 leaves out 2 u exp(-4u), 1e-17
    /// of the value.
    void cothProductAndItsSlope()
    {
        for (double u = 1e-6; u < 40.0; u *= 1.0173) {
            const long double exact = u, sinh = std::sinh(exact), value = exact / std::tanh(exact);
            // From the series where the difference of the formula loses its digits.
            const long double slope =
                u < 1e-3 ? exact * (2.0L / 3 - exact * exact * (4.0L / 45 - exact * exact * 4.0L / 315))
                         : 1.0L / std::tanh(exact) - exact / (sinh * sinh);
            const CothProduct result = cothProduct(u);
            QVERIFY2(std::abs(result.value / value - 1.0L) < 1e-12L, qPrintable(QString::number(u)));
            QVERIFY2(std::abs(result.derivative / slope - 1.0L) < 4e-9L, qPrintable(QString::number(u)));
        }
        QCOMPARE(cothProduct(0.0).value, 1.0);
        QCOMPARE(cothProduct(0.0).derivative, 0.0);
    }
    void cothProductOfHugeArguments()
    {
        QCOMPARE(cothProduct(1e9).value, 1e9);
        QCOMPARE(cothProduct(1e9).derivative, 1.0);
    }

    /// K = 2: upwind K + |c|/2; hybrid max(K, |c|/2); power law K (1 - |Pe|/10)^5 + |c|/2, at Pe = 5 and c = 10:
    /// 2 (1/32 + 2.5); exponential K (Pe/2) coth(Pe/2), at Pe = 2 2 coth 1.
    void values_data()
    {
        QTest::addColumn<ConvectionScheme>("scheme");
        QTest::addColumn<double>("convection");
        QTest::addColumn<double>("expected");
        using enum ConvectionScheme;
        QTest::newRow("upwind") << Upwind << -10.0 << 7.0;
        QTest::newRow("hybrid, diffusion") << Hybrid << 3.9 << 2.0;
        QTest::newRow("hybrid, convection") << Hybrid << -4.2 << 2.1;
        QTest::newRow("power law, Pe 5") << PowerLaw << 10.0 << 5.0625;
        QTest::newRow("power law, Pe -5") << PowerLaw << -10.0 << 5.0625;
        QTest::newRow("power law, Pe 20") << PowerLaw << 40.0 << 20.0;
        QTest::newRow("exponential, Pe 2") << Exponential << 4.0 << 2.0 * 1.3130352854993313;
        QTest::newRow("exponential, Pe -2") << Exponential << -4.0 << 2.0 * 1.3130352854993313;
        QTest::newRow("complete flux is exponential") << CompleteFlux << 4.0 << 2.0 * 1.3130352854993313;
        QTest::newRow("exponential, no diffusion left") << Exponential << 1e10 << 5e9;
    }
    void values()
    {
        QFETCH(ConvectionScheme, scheme);
        QFETCH(double, convection);
        QFETCH(double, expected);
        QVERIFY(std::abs(conductance(scheme, 2.0, convection).value / expected - 1.0) < 1e-14);
    }

    /// c p - k dp/dx = F with constant c, k over a length of 1 has p2 = F/c + (p1 - F/c) exp(c/k).
    void exponentialIsExact()
    {
        for (const double peclet : {-30.0, -3.0, -0.1, 0.1, 0.7, 4.0, 25.0}) {
            const double k = 0.3, c = peclet * k, p1 = 1.7, flow = 0.4;
            const double p2 = flow / c + (p1 - flow / c) * std::exp(peclet);
            const double E = conductance(ConvectionScheme::Exponential, k, c).value;
            // Both terms are as large as exp(Pe): rounding is against them.
            QVERIFY(std::abs(0.5 * c * (p1 + p2) - E * (p2 - p1) - flow) <
                    1e-13 * (std::abs(c) + E) * (std::abs(p2) + p1));
        }
    }

    void derivativesAgainstDifferences_data() { addSchemes(); }
    void derivativesAgainstDifferences()
    {
        QFETCH(ConvectionScheme, scheme);
        // |c|/K below, between and above the bounds of the schemes (2, 10) and of the coth (0.04, 20).
        for (const double peclet : {0.03, 0.05, 1.3, 1.9, 2.1, 7.0, 9.7, 11.0, 19.0, 21.0, 300.0})
            for (const double sign : {1.0, -1.0}) {
                const double K = 0.8, c = sign * peclet * K, d = 1e-6;
                const EffectiveConductance e = conductance(scheme, K, c);
                const double byK =
                    (conductance(scheme, K * (1 + d), c).value - conductance(scheme, K * (1 - d), c).value) /
                    (2 * d * K);
                const double byC =
                    (conductance(scheme, K, c * (1 + d)).value - conductance(scheme, K, c * (1 - d)).value) /
                    (2 * d * c);
                // Differences lose 1e-16 E/(d K) and, by c, 1e-16 E/(d c).
                const double lost = 1e-9 * (1.0 + peclet);
                QVERIFY2(std::abs(e.byDiffusion - byK) < lost, qPrintable(QString::number(peclet)));
                QVERIFY2(std::abs(e.byConvection - byC) < lost / peclet + 1e-9, qPrintable(QString::number(peclet)));
            }
    }

    /// No negative coefficient: both E - c/2 and E + c/2 are at least zero. Without convection all are K.
    void neverBelowHalfTheConvection_data() { addSchemes(); }
    void neverBelowHalfTheConvection()
    {
        QFETCH(ConvectionScheme, scheme);
        for (double peclet = 1e-8; peclet < 1e12; peclet *= 1.37)
            for (const double c : {3.0 * peclet, -3.0 * peclet}) {
                const double E = conductance(scheme, 3.0, c).value;
                QVERIFY2(E >= 0.5 * std::abs(c), qPrintable(QString::number(peclet)));
            }
        QCOMPARE(conductance(scheme, 3.0, 0.0).value, 3.0);
    }

    void closedFacePassesNothing_data() { addSchemes(); }
    void closedFacePassesNothing()
    {
        QFETCH(ConvectionScheme, scheme);
        const EffectiveConductance e = conductance(scheme, 0.0, 0.0);
        QCOMPARE(e.value, 0.0);
        QVERIFY(std::isfinite(e.byDiffusion) && std::isfinite(e.byConvection));
    }
};

TOUCHDOWN_TEST(TestConvection)

} // namespace test_convection

#include "test_convection.moc"
