// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <numbers>

#include "core/studies/advice/ringing_fit.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_ringing_fit {

class TestRingingFit : public QObject {
    Q_OBJECT

private slots:
    void findsRatesThatAreKnownAbout();
    void keepsAFixedRate();
    void saysWhatItLeaves();
    void whatCreepsIsTold();
    void needsPeriodsAndSamples();
};

using Complex = std::complex<double>;
constexpr double twoPi = 2.0 * std::numbers::pi;
constexpr double interval = 0.1e-6; // [s]

Complex rate(double frequency, double damping) { return {-damping, twoPi * frequency}; }

std::vector<double> ringing(std::size_t count, double constant, const std::vector<std::pair<Complex, Complex>>& terms)
{
    std::vector<double> samples(count, constant);
    for (std::size_t k = 0; k < count; ++k)
        for (const auto& [s, amplitude] : terms)
            samples[k] += (amplitude * std::exp(s * (interval * static_cast<double>(k)))).real();
    return samples;
}

// The signal is of the fitted form: what is left is rounding, of numbers about 40 nm: 1e-16 * 4e-8.
void TestRingingFit::findsRatesThatAreKnownAbout()
{
    const Complex first = rate(80e3, 1.2e4), second = rate(125e3, 8e3);
    const std::vector<double> samples =
        ringing(1000, 40e-9, {{first, Complex(1e-9, 0.5e-9)}, {second, Complex(-0.4e-9, 0.2e-9)}});
    const auto fit = fitRinging(samples, interval, {{1.02 * first, false}, {rate(123e3, 6e3), false}});
    QVERIFY(fit);
    QVERIFY(std::abs(fit->rates[0] - first) < 1e-6 * std::abs(first));
    QVERIFY(std::abs(fit->rates[1] - second) < 1e-6 * std::abs(second));
    QVERIFY(std::abs(fit->amplitudes[1] - Complex(-0.4e-9, 0.2e-9)) < 1e-15);
    QVERIFY(std::abs(fit->constant - 40e-9) < 1e-15);
    QVERIFY(fit->left < 1e-15);
    QVERIFY(std::abs(fit->at(50e-6) - samples[500]) < 1e-14);
}

void TestRingingFit::keepsAFixedRate()
{
    const Complex wave = rate(100e3, 0.0), mode = rate(85e3, 2e4);
    const auto fit = fitRinging(ringing(1200, 10e-9, {{wave, 0.3e-9}, {mode, 1e-9}}), interval,
                                {{wave, true}, {1.03 * mode, false}});
    QVERIFY(fit);
    QCOMPARE(fit->rates[0], wave);
    QVERIFY(std::abs(fit->amplitudes[0] - 0.3e-9) < 1e-15);
}

// A second motion at 300 kHz with an amplitude of 0.1 nm is none of those fitted: its root mean square of 0.1/sqrt 2 nm
// is left, but for what the fitted one can take of it, which over 80 periods is about 1/80.
void TestRingingFit::saysWhatItLeaves()
{
    const Complex known = rate(100e3, 0.0);
    const auto fit =
        fitRinging(ringing(8000, 10e-9, {{known, 1e-9}, {rate(300e3, 0.0), 0.1e-9}}), interval, {{known, true}});
    QVERIFY(fit);
    QVERIFY(std::abs(fit->left / (0.1e-9 / std::numbers::sqrt2) - 1.0) < 0.02);
}

// 2 nm that decay within 50 us, by 2.6 times over the samples, beside a motion that rings.
void TestRingingFit::whatCreepsIsTold()
{
    const Complex mode = rate(85e3, 2e4);
    const auto fit = fitRinging(ringing(1300, 10e-9, {{mode, 1e-9}, {Complex(-2e4), 2e-9}}), interval,
                                {{1.01 * mode, false}, {-1.2e4, false}});
    QVERIFY(fit);
    QVERIFY(std::abs(fit->constant - 10e-9) < 1e-14);
    QVERIFY(std::abs(fit->rates[1] - Complex(-2e4)) < 1.0);
}

void TestRingingFit::needsPeriodsAndSamples()
{
    const Complex mode = rate(100e3, 0.0);
    QVERIFY(!fitRinging(ringing(140, 0.0, {{mode, 1e-9}}), interval, {{mode, false}})); // 1.4 periods
    QVERIFY(!fitRinging({}, interval, {{mode, false}}));
}

TOUCHDOWN_TEST(TestRingingFit)

} // namespace test_ringing_fit

#include "test_ringing_fit.moc"
