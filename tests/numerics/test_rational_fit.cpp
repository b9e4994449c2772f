// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/rational_fit.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_rational_fit {

using Complex = std::complex<double>;

RationalFit drawn(std::mt19937_64& random, int pairs, int reals, std::size_t functions)
{
    std::uniform_real_distribution<double> decade(3.5, 6.5), damping(0.02, 0.9), size(-1.0, 1.0);
    RationalFit fit;
    for (int k = 0; k < pairs + reals; ++k) {
        const double rate = std::pow(10.0, decade(random)), share = damping(random);
        fit.poles.push_back(k < reals ? Complex(-rate) : Complex(-share * rate, std::sqrt(1.0 - share * share) * rate));
        auto& residues = fit.residues.emplace_back();
        for (std::size_t e = 0; e < functions; ++e)
            residues.push_back(rate * (k < reals ? Complex(size(random)) : Complex(size(random), size(random))));
    }
    for (std::size_t e = 0; e < functions; ++e) fit.constants.push_back(size(random));
    return fit;
}

std::vector<RationalSample> samplesOf(const RationalFit& fit, int count)
{
    std::vector<RationalSample> samples;
    for (int k = 0; k < count; ++k) {
        RationalSample& sample = samples.emplace_back();
        sample.s = {0.0, 1e3 * std::pow(1e4, k / (count - 1.0))};
        for (std::size_t e = 0; e < fit.constants.size(); ++e) sample.values.push_back(fit.at(sample.s, e));
        sample.weights.assign(fit.constants.size(), 1.0);
    }
    return samples;
}

/// The largest difference at frequencies between, of the largest value.
double missed(const RationalFit& fit, const RationalFit& exact)
{
    double worst = 0.0, largest = 0.0;
    for (double rate = 1.5e3; rate < 8e6; rate *= 1.07)
        for (std::size_t e = 0; e < exact.constants.size(); ++e) {
            worst = std::max(worst, std::abs(fit.at({0.0, rate}, e) - exact.at({0.0, rate}, e)));
            largest = std::max(largest, std::abs(exact.at({0.0, rate}, e)));
        }
    return worst / largest;
}

class TestRationalFit : public QObject {
    Q_OBJECT
private slots:
    // A function of the order that is fitted is found again, between its samples and with its poles.
    void findsFunctionsOfItsOrder()
    {
        std::mt19937_64 random(11);
        for (int draw = 0; draw < 40; ++draw) {
            const int pairs = 1 + draw % 4, reals = 2 * (draw % 2);
            const RationalFit exact = drawn(random, pairs, reals, 3);
            const RationalFit fit = fitRationally(samplesOf(exact, 24), 2 * pairs + reals, 20);
            const double error = missed(fit, exact);
            QVERIFY2(error < 1e-6, qPrintable(QString("draw %1: %2").arg(draw).arg(error)));
            for (const Complex pole : exact.poles) {
                double nearest = 1.0;
                for (const Complex found : fit.poles)
                    nearest = std::min(nearest, std::abs(found - pole) / std::abs(pole));
                QVERIFY2(nearest < 1e-3, qPrintable(QString("draw %1: %2").arg(draw).arg(nearest)));
            }
        }
    }

    // tanh of a root has infinitely many poles: more of them come closer.
    void comesCloserWithMorePoles()
    {
        const auto exact = [](Complex s) { return 1.0 - std::tanh(std::sqrt(1e-5 * s)) / std::sqrt(1e-5 * s); };
        std::vector<RationalSample> samples;
        for (int k = 0; k < 40; ++k) {
            const Complex s(0.0, 1e3 * std::pow(1e4, k / 39.0));
            samples.push_back({s, {exact(s)}, {1.0}});
        }
        double before = 1.0;
        for (const int order : {2, 4, 6}) {
            const RationalFit fit = fitRationally(samples, order);
            double worst = 0.0;
            for (double rate = 1.2e3; rate < 9e6; rate *= 1.1)
                worst = std::max(worst, std::abs(fit.at({0.0, rate}, 0) - exact({0.0, rate})));
            QVERIFY2(worst < 0.1 * before, qPrintable(QString("order %1: %2").arg(order).arg(worst)));
            before = worst;
            for (const Complex pole : fit.poles) QVERIFY(pole.real() < 0.0);
        }
        QVERIFY(before < 1e-4);
    }

    // A growing function has no fit with decaying poles.
    void missesGrowingFunctions()
    {
        RationalFit growing;
        growing.poles = {{2e4, 1e5}};
        growing.residues = {{{1e5, 0.0}}};
        growing.constants = {0.5};
        const RationalFit fit = fitRationally(samplesOf(growing, 24), 2);
        for (const Complex pole : fit.poles) QVERIFY(pole.real() < 0.0);
        QVERIFY(missed(fit, growing) > 0.1);
    }

    void findsResiduesOfKnownPoles()
    {
        std::mt19937_64 random(5);
        for (const bool constant : {true, false}) {
            RationalFit exact = drawn(random, 3, 1, 2);
            if (!constant) exact.constants = {0.0, 0.0};
            const RationalFit fit = fitResidues(samplesOf(exact, 20), exact.poles, constant);
            QVERIFY(missed(fit, exact) < 1e-9);
            if (!constant) QCOMPARE(fit.constants, exact.constants);
        }
    }

    // More poles than the functions have, and a function that is zero: all remains finite.
    void bearsFewerPolesThanAskedFor()
    {
        std::mt19937_64 random(21);
        for (int draw = 0; draw < 20; ++draw) {
            RationalFit exact = drawn(random, 1 + draw % 3, draw % 2, 3);
            for (auto& residues : exact.residues) residues[1] = 0.0;
            exact.constants[1] = 0.0;
            if (draw % 5 == 0)
                for (auto& residues : exact.residues) residues = {0.0, 0.0, 0.0}; // constants alone
            const RationalFit fit = fitRationally(samplesOf(exact, 20), 24);
            QVERIFY2(missed(fit, exact) < 5e-3, qPrintable(QString("draw %1: %2").arg(draw).arg(missed(fit, exact))));
            for (const Complex pole : fit.poles) {
                QVERIFY(std::isfinite(std::abs(fit.at(0.0, 0) - fit.at(0.0, 0) / pole)));
                QVERIFY(pole.real() < 0.0);
            }
        }
    }

    void refusesTooFewSamples()
    {
        std::mt19937_64 random(1);
        const std::vector<RationalSample> samples = samplesOf(drawn(random, 1, 0, 1), 4);
        QVERIFY_EXCEPTION_THROWN(fitRationally(samples, 8), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(fitRationally(samples, 3), std::invalid_argument);
        QCOMPARE(fitRationally(samples, 6).poles.size(), fitRationally(samples, 6).residues.size());
    }
};

TOUCHDOWN_TEST(TestRationalFit)

} // namespace test_rational_fit

#include "test_rational_fit.moc"
