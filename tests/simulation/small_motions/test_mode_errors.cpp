// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>
#include <numbers>

#include <QTest>

#include "core/simulation/small_motions/mode_errors.h"
#include "tests/support/random_slider.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_mode_errors {

using Complex = std::complex<double>;

constexpr double twoPi = 2.0 * std::numbers::pi;

Complex rate(double frequency, double damping)
{
    const double omega = twoPi * frequency;
    return {-damping * omega / std::sqrt(1.0 - damping * damping), omega};
}

AirBearingMode mode(double frequency, double damping)
{
    AirBearingMode result;
    result.frequency = frequency;
    result.dampingRatio = damping;
    return result;
}

bool near(double value, double expected) { return std::abs(value - expected) < 1e-9 * std::abs(expected); }

class TestModeErrors : public QObject {
    Q_OBJECT

private slots:
    void byTheDistanceOfRates();
    void holdForLightSliders_data();
    void holdForLightSliders();
    void notKnownWithoutACoarserGrid();
    void ratesOnACoarserGrid();
};

/// Rates s2 = (1 + e2) s and s4 = s2 + e4 s have the distances d2 = |e2| and d4 = |e4|: x = max(d2, d4/2), without a
/// quarter 2 d2. The second mode's damping ratio is the same on all grids: only its frequency tells that cells matter.
void TestModeErrors::byTheDistanceOfRates()
{
    std::vector<AirBearingMode> modes{mode(100e3, 0.05), mode(300e3, 0.01)};
    const std::vector<Complex> finest{rate(100e3, 0.05), rate(300e3, 0.01)};
    const Complex e2{0.003, 0.004}, e4{0.006, 0.008};
    const std::vector<Complex> half{1.02 * finest[1], (1.0 + e2) * finest[0]}; // in another order
    const std::vector<Complex> quarter{half[1] + e4 * finest[0], 1.07 * finest[1]};
    setErrors(modes, finest, half, {});
    QVERIFY(near(modes[0].dampingError, dampingErrorFactor * 0.01));
    QVERIFY(near(modes[1].dampingError, dampingErrorFactor * 0.04));
    QVERIFY(near(modes[0].frequencyError, frequencyErrorFactor * 0.01 * 100e3));
    QVERIFY(near(modes[1].frequencyError, frequencyErrorFactor * 0.04 * 300e3));
    setErrors(modes, finest, half, quarter);
    QVERIFY(near(modes[0].dampingError, dampingErrorFactor * 0.005));
    QVERIFY(near(modes[1].dampingError, dampingErrorFactor * 0.025));
    QVERIFY(near(modes[0].frequencyError, frequencyErrorFactor * 0.005 * 100e3));
    QVERIFY(near(modes[1].frequencyError, frequencyErrorFactor * 0.025 * 300e3));
}

void TestModeErrors::holdForLightSliders_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("nodes");
    QTest::newRow("693 kHz, damping ratio -0.06 % on 65 nodes, 0.85 % on 193") << 1 << 65;
    QTest::newRow("803 kHz, damping ratio 0.03 % on 97 nodes, 0.39 % on 193") << 2 << 97;
}

/// A quarter of the mass leaves the static state as it is and doubles the frequencies. Damping ratios of the coarser
/// grids agree by chance: their differences alone would state 0.05 and 0.11 %. Compared with 193 nodes.
void TestModeErrors::holdForLightSliders()
{
    QFETCH(int, seed);
    QFETCH(int, nodes);
    Case c = test::RandomSlider(std::uint64_t(seed)).draw();
    for (double* inertia : {&c.slider.mass, &c.slider.pitchInertia, &c.slider.rollInertia}) *inertia /= 4.0;
    c.film.nodes = {nodes, nodes};
    const ModesResult found = modes(c);
    QCOMPARE(found.modes.size(), std::size_t(3));
    std::vector<Complex> rates;
    for (const AirBearingMode& m : found.modes) rates.push_back(rate(m.frequency, m.dampingRatio));
    const std::vector<Complex> finer =
        coarserRates(c, found.steady, 192.0 / (nodes - 1), rates, [](const std::string&) { return true; });
    QCOMPARE(finer.size(), std::size_t(3));
    for (std::size_t k = 0; k < 3; ++k) {
        const AirBearingMode& m = found.modes[k];
        const double damping = -finer[k].real() / std::abs(finer[k]), frequency = finer[k].imag() / twoPi;
        QVERIFY2(std::abs(m.dampingRatio - damping) < m.dampingError,
                 qPrintable(QString("%1 +- %2, %3").arg(m.dampingRatio).arg(m.dampingError).arg(damping)));
        QVERIFY2(std::abs(m.frequency - frequency) < m.frequencyError,
                 qPrintable(QString("%1 +- %2, %3").arg(m.frequency).arg(m.frequencyError).arg(frequency)));
    }
}

void TestModeErrors::notKnownWithoutACoarserGrid()
{
    std::vector<AirBearingMode> modes{mode(100e3, 0.05)};
    const std::vector<Complex> finest{rate(100e3, 0.05)};
    setErrors(modes, finest, {}, {});
    QVERIFY(std::isnan(modes[0].dampingError) && std::isnan(modes[0].frequencyError));
}

/// Those of a case with half the nodes, also where the finer grid was chosen by an accuracy; none on fewer than 32
/// cells, and none when the search is stopped.
void TestModeErrors::ratesOnACoarserGrid()
{
    const ModesResult fine = modes(test::smallSlider(65)), coarse = modes(test::smallSlider(33));
    std::vector<Complex> near;
    for (const AirBearingMode& m : fine.modes) near.push_back(rate(m.frequency, m.dampingRatio));
    Case c = test::smallSlider(65);
    c.film.accuracy = 0.01;
    const std::vector<Complex> found = coarserRates(
        c, fine.steady, 0.5, near, [](const std::string& stage) { return stage == "modes on 33 x 33 nodes"; });
    QCOMPARE(found.size(), coarse.modes.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        const Complex expected = rate(coarse.modes[k].frequency, coarse.modes[k].dampingRatio);
        QVERIFY(std::abs(found[k] - expected) < 1e-4 * std::abs(expected));
    }
    const auto always = [](const std::string&) { return true; };
    QVERIFY(coarserRates(c, fine.steady, 0.25, near, always).empty());
    QVERIFY(coarserRates(c, fine.steady, 0.5, near, [](const std::string&) { return false; }).empty());
}

TOUCHDOWN_TEST(TestModeErrors)

} // namespace test_mode_errors

#include "test_mode_errors.moc"
