// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>
#include <numbers>

#include <QTest>

#include "core/simulation/small_motions/mode_errors.h"
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
    void byTheDifferencesOfGrids();
    void notKnownWithoutACoarserGrid();
    void ratesOnACoarserGrid();
};

/// Two modes, on coarser grids in another order: x = max(d2, d4/4), X the larger x, F max(x, X/2).
void TestModeErrors::byTheDifferencesOfGrids()
{
    std::vector<AirBearingMode> modes{mode(100e3, 0.05), mode(300e3, 0.01)};
    const std::vector<Complex> finest{rate(100e3, 0.05), rate(300e3, 0.01)};
    const std::vector<Complex> half{rate(303e3, 0.014), rate(100e3, 0.051)}; // d2 0.001, 0.004; 0, 1 %
    const std::vector<Complex> quarter{rate(104e3, 0.035), rate(303e3, 0.014)};
    setErrors(modes, finest, half, {});
    QVERIFY(near(modes[0].dampingError, dampingErrorFactor * 0.002)); // half of the other's
    QVERIFY(near(modes[1].dampingError, dampingErrorFactor * 0.004));
    QVERIFY(near(modes[0].frequencyError, frequencyErrorFactor * 0.005 * 100e3));
    QVERIFY(near(modes[1].frequencyError, frequencyErrorFactor * 0.01 * 300e3));
    // The first mode's d4 is 0.016 and 4 %, a quarter of which is the largest difference of frequencies, too.
    setErrors(modes, finest, half, quarter);
    QVERIFY(near(modes[0].dampingError, dampingErrorFactor * 0.004));
    QVERIFY(near(modes[1].dampingError, dampingErrorFactor * 0.004));
    QVERIFY(near(modes[0].frequencyError, frequencyErrorFactor * 0.01 * 100e3));
    QVERIFY(near(modes[1].frequencyError, frequencyErrorFactor * 0.01 * 300e3));
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
