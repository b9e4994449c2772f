// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/spectrogram.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <QTest>

#include "core/numerics/spectrum.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spectrogram {

/// The frequency of the largest density of a column [Hz].
double loudest(const Spectrogram& result, std::size_t column)
{
    std::size_t best = 0;
    for (std::size_t k = 1; k < result.frequency.size(); ++k)
        if (result.at(column, k) > result.at(column, best)) best = k;
    return result.frequency[best];
}

class TestSpectrogram : public QObject {
    Q_OBJECT

private slots:
    void followsAFrequencyThatRises();
    void saysItsResolutions();
    void averagesNeighbours();
    void needsAWholeWindow();
    void readsColumnByColumn();
};

// x = sin(2 pi (f0 t + c t^2/2)) has the frequency f0 + c t: 50 kHz rising to 250 kHz in 10 ms, sampled every 1 us. The
// largest bin is within one bin and what the chirp passes in half a window, 256 us * c / 2 = 2.6 kHz.
void TestSpectrogram::followsAFrequencyThatRises()
{
    constexpr double dt = 1e-6, f0 = 50e3, c = 20e6;
    std::vector<double> x;
    for (int i = 0; i < 10'000; ++i) {
        const double t = i * dt;
        x.push_back(std::sin(2.0 * std::numbers::pi * (f0 * t + 0.5 * c * t * t)));
    }
    const Spectrogram result = spectrogram(x, dt, 256, 1000);
    QCOMPARE(result.averaged, std::size_t(1));
    QCOMPARE(result.columns, std::size_t((10'000 - 256) / 128 + 1));
    for (std::size_t k = 0; k < result.columns; ++k) {
        const double t = result.firstCentre + static_cast<double>(k) * result.step;
        QVERIFY(std::abs(loudest(result, k) - (f0 + c * t)) < 1.0 / (256 * dt) + 2.6e3);
    }
}

// 256 samples of 1 us: 256 us, and 1.5 bins of 1/(256 us) = 5859.375 Hz.
void TestSpectrogram::saysItsResolutions()
{
    const std::vector<double> x(2560, 1.0);
    const Spectrogram result = spectrogram(x, 1e-6, 256, 1000);
    QVERIFY(std::abs(result.timeResolution - 256e-6) < 1e-12);
    QVERIFY(std::abs(result.frequencyResolution - 5859.375) < 1e-6);
    QVERIFY(std::abs(result.firstCentre - 127.5e-6) < 1e-12);
    QVERIFY(std::abs(result.step - 128e-6) < 1e-12);
    QCOMPARE(result.frequency.size(), std::size_t(129));
    QCOMPARE(result.frequency.back(), 0.5e6);
}

// With room for two columns, each is the mean of its windows: the spectrum of its part by Welch's method.
void TestSpectrogram::averagesNeighbours()
{
    std::vector<double> x;
    for (int i = 0; i < 1024; ++i) x.push_back(std::sin(0.3 * i) * (i < 512 ? 1.0 : 3.0));
    const Spectrogram result = spectrogram(x, 1e-6, 64, 2);
    QCOMPARE(result.columns, std::size_t(2));
    QCOMPARE(result.averaged, std::size_t(16)); // 31 windows
    const std::size_t covered = 64 + 15 * 32;
    const Spectrum whole = welch(std::span(x).first(covered), 1e-6, {.segment = 64});
    QCOMPARE(whole.segments, std::size_t(16));
    const Spectrum rest = welch(std::span(x).subspan(16 * 32), 1e-6, {.segment = 64});
    QCOMPARE(rest.segments, std::size_t(15));
    for (std::size_t k = 0; k < whole.power.size(); ++k) {
        QCOMPARE(result.at(0, k), whole.power[k]);
        QCOMPARE(result.at(1, k), rest.power[k]);
    }
}

void TestSpectrogram::needsAWholeWindow()
{
    QVERIFY(spectrogram(std::vector<double>(255, 1.0), 1e-6, 256, 100).empty());
    QVERIFY(spectrogram({}, 1e-6, 256, 100).empty());
    QVERIFY(spectrogram(std::vector<double>(256, 1.0), 0.0, 256, 100).empty());
    const Spectrogram one = spectrogram(std::vector<double>(256, 1.0), 1e-6, 256, 1);
    QCOMPARE(one.columns, std::size_t(1));
    QVERIFY(std::ranges::all_of(one.density, [](double p) { return p == 0.0; })); // a constant has no power
}

// A signal that is read in parts has the same result, and no more than a column is read at once.
void TestSpectrogram::readsColumnByColumn()
{
    std::vector<double> x;
    for (int i = 0; i < 5000; ++i) x.push_back(std::sin(0.3 * i) + 1e-3 * (i % 17));
    std::size_t most = 0, calls = 0;
    const SampleReader read = [&](std::size_t first, std::span<double> to) {
        most = std::max(most, to.size());
        std::ranges::copy(std::span(x).subspan(first, to.size()), to.begin());
        return ++calls < 1000;
    };
    const Spectrogram whole = spectrogram(x, 1e-6, 64, 10);
    const Spectrogram parts = spectrogram(x.size(), read, 1e-6, 64, 10);
    QVERIFY(parts.density == whole.density && parts.frequency == whole.frequency);
    QCOMPARE(parts.columns, whole.columns);
    QCOMPARE(most, 64 + (whole.averaged - 1) * 32);
    calls = 995; // gives up in the fifth column
    QVERIFY(spectrogram(x.size(), read, 1e-6, 64, 10).empty());
}

TOUCHDOWN_TEST(TestSpectrogram)

} // namespace test_spectrogram

#include "test_spectrogram.moc"
