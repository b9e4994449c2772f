// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/spectrum.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <thread>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spectrum {

using std::numbers::pi;

std::vector<double> noise(std::size_t n, double sigma)
{
    std::mt19937_64 generator(20240607);
    std::normal_distribution<double> normal(0.0, sigma);
    std::vector<double> x(n);
    for (double& value : x) value = normal(generator);
    return x;
}

std::vector<double> sine(std::size_t n, double amplitude, double cyclesPerSample, double phase = 0.3)
{
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = amplitude * std::sin(2.0 * pi * cyclesPerSample * static_cast<double>(i) + phase);
    return x;
}

double integral(const Spectrum& s) { return std::accumulate(s.power.begin(), s.power.end(), 0.0) * s.frequency[1]; }

bool near(double actual, double expected, double relative)
{
    return std::abs(actual - expected) <= relative * std::abs(expected);
}

void addWindows()
{
    QTest::addColumn<SpectrumWindow>("window");
    QTest::newRow("rectangular") << SpectrumWindow::Rectangular;
    QTest::newRow("Hann") << SpectrumWindow::Hann;
    QTest::newRow("Hamming") << SpectrumWindow::Hamming;
    QTest::newRow("Blackman") << SpectrumWindow::Blackman;
    QTest::newRow("flat top") << SpectrumWindow::FlatTop;
}

class TestSpectrum : public QObject {
    Q_OBJECT

private slots:
    void parsevalWithoutWindow_data();
    void parsevalWithoutWindow();
    void parsevalWithWindow_data() { addWindows(); }
    void parsevalWithWindow();
    void sineOnABin_data() { addWindows(); }
    void sineOnABin();
    void whiteNoiseDensity_data() { addWindows(); }
    void whiteNoiseDensity();
    void agreesWithSciPy_data();
    void agreesWithSciPy();
    void oddSegmentWithoutMeanRemoval();
    void shortSignals_data();
    void shortSignals();
    void topBetweenBins();
    void constantSignalHasNoPower();
    void peakBetweenBins_data();
    void peakBetweenBins();
    void peaksAreOrderedAndLimited();
    void noiseFloorIsNoPeak();
    void repeatsBitForBit();
    void threadsDoNotDisturbEachOther();
};

// Rectangular, no overlap, mean kept, the signal cut into whole segments:
// sum_k P_k df = (1/N) sum_i x_i^2, since sum_k |X_k|^2 over both sides = n sum x^2 in each segment.
void TestSpectrum::parsevalWithoutWindow_data()
{
    QTest::addColumn<int>("segment");
    QTest::newRow("power of two") << 256;
    QTest::newRow("odd") << 125;
    QTest::newRow("prime") << 101;
    QTest::newRow("whole signal") << 10100;
}

void TestSpectrum::parsevalWithoutWindow()
{
    QFETCH(int, segment);
    const auto n = static_cast<std::size_t>(segment);
    std::vector<double> x = noise(n * (10100 / n), 3.0);
    for (double& value : x) value += 1.7;
    const double meanSquare = std::inner_product(x.begin(), x.end(), x.begin(), 0.0) / static_cast<double>(x.size());

    const Spectrum s = welch(x, 1e-7, {SpectrumWindow::Rectangular, SpectrumScaling::Density, n, 0.0, false});
    QCOMPARE(s.segments, x.size() / n);
    QVERIFY2(near(integral(s), meanSquare, 1e-12), qPrintable(QString::number(integral(s) / meanSquare - 1.0)));
}

// One segment: sum_k P_k df = sum_i (w_i x_i)^2 / sum_i w_i^2, with the windows as published.
void TestSpectrum::parsevalWithWindow()
{
    QFETCH(SpectrumWindow, window);
    const std::size_t n = 240;
    const std::vector<double> x = noise(n, 2.0);
    double weighted = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double a = 2.0 * pi * static_cast<double>(i) / static_cast<double>(n);
        double w = 1.0;
        switch (window) {
        case SpectrumWindow::Rectangular: break;
        case SpectrumWindow::Hann: w = std::pow(std::sin(a / 2.0), 2); break;
        case SpectrumWindow::Hamming: w = 0.54 - 0.46 * std::cos(a); break;
        case SpectrumWindow::Blackman: w = 0.42 - 0.5 * std::cos(a) + 0.08 * std::cos(2.0 * a); break;
        case SpectrumWindow::FlatTop:
            w = 0.21557895 - 0.41663158 * std::cos(a) + 0.277263158 * std::cos(2.0 * a) -
                0.083578947 * std::cos(3.0 * a) + 0.006947368 * std::cos(4.0 * a);
            break;
        }
        weighted += w * w * x[i] * x[i];
        squares += w * w;
    }
    const Spectrum s = welch(x, 1e-6, {window, SpectrumScaling::Density, n, 0.5, false});
    QCOMPARE(s.segments, std::size_t{1});
    QVERIFY(near(integral(s), weighted / squares, 1e-12));
}

// A sine of amplitude A on bin 40 shows A^2/2 there, whatever the window; the density there times the
// window's noise bandwidth is the same power.
void TestSpectrum::sineOnABin()
{
    QFETCH(SpectrumWindow, window);
    const std::vector<double> x = sine(4096, 2.5e-9, 40.0 / 512.0);
    const Spectrum power = welch(x, 1e-7, {window, SpectrumScaling::Amplitude, 512, 0.5, true});
    QVERIFY(near(power.power[40], 2.5e-9 * 2.5e-9 / 2.0, 1e-12));
    QVERIFY(near(power.frequency[40], 40.0 / (512.0 * 1e-7), 1e-14));
    QVERIFY(near(power.frequency.back(), 5e6, 1e-14));

    const Spectrum density = welch(x, 1e-7, {window, SpectrumScaling::Density, 512, 0.5, true});
    QVERIFY(near(density.power[40] * density.equivalentNoiseBandwidth, 2.5e-9 * 2.5e-9 / 2.0, 1e-12));

    for (const auto& [spectrum, scaling] :
         {std::pair{power, SpectrumScaling::Amplitude}, std::pair{density, SpectrumScaling::Density}}) {
        const std::vector<Peak> peaks = findPeaks(spectrum, scaling);
        QCOMPARE(peaks.size(), std::size_t{1});
        QVERIFY(near(peaks[0].frequency, power.frequency[40], 1e-6));
        QVERIFY(near(peaks[0].amplitude, 2.5e-9, 1e-6));
    }
}

// E[P_k] = sigma^2/(fs/2) on every inner bin. Without overlap each bin is the mean of K independent
// exponential variables (rectangular: independent from bin to bin as well), so it scatters by 1/sqrt(K);
// the mean over B bins by 1/sqrt(K B), more by at most sqrt(ENBW/df) <= 2 for windows. Band: 5 of these.
void TestSpectrum::whiteNoiseDensity()
{
    QFETCH(SpectrumWindow, window);
    const double sigma = 0.8;
    const double interval = 2e-6;
    const std::size_t n = 128;
    const std::size_t segments = 2000;
    const Spectrum s = welch(noise(n * segments, sigma), interval, {window, SpectrumScaling::Density, n, 0.0, false});
    QCOMPARE(s.segments, segments);
    const double expected = sigma * sigma * 2.0 * interval;
    double sum = 0.0;
    for (std::size_t k = 2; k + 2 < s.power.size(); ++k) {
        QVERIFY(near(s.power[k], expected, 5.0 / std::sqrt(2000.0)));
        sum += s.power[k];
    }
    const double bins = static_cast<double>(s.power.size()) - 4.0;
    QVERIFY(near(sum / bins, expected, 5.0 * 2.0 / std::sqrt(2000.0 * bins)));
}

// i = np.arange(100); x = np.sin(0.3*i) + 0.5*np.cos(1.1*i) + 0.01*i
// f, P = scipy.signal.welch(x, fs=1e3, window=..., nperseg=32, noverlap=16, scaling=...)   (SciPy 1.10.1)
void TestSpectrum::agreesWithSciPy_data()
{
    QTest::addColumn<SpectrumWindow>("window");
    QTest::addColumn<SpectrumScaling>("scaling");
    QTest::addColumn<QList<double>>("expected"); // P[0], P[2], P[6], P[16]
    using W = SpectrumWindow;
    using S = SpectrumScaling;
    QTest::newRow("boxcar, density") << W::Rectangular << S::Density
                                     << QList<double>{0.0, 0.007323017298619559, 0.0021926254710827532,
                                                      1.453871387866425e-05};
    QTest::newRow("boxcar, spectrum") << W::Rectangular << S::Amplitude
                                      << QList<double>{0.0, 0.2288442905818612, 0.06851954597133604,
                                                       0.0004543348087082577};
    QTest::newRow("hann, density") << W::Hann << S::Density
                                   << QList<double>{0.001574233505892694, 0.007967101090160236, 0.0021911334798865195,
                                                    9.847152543536936e-11};
    QTest::newRow("hann, spectrum") << W::Hann << S::Amplitude
                                    << QList<double>{0.07379219558872004, 0.37345786360126104, 0.1027093818696806,
                                                     4.615852754782939e-09};
    QTest::newRow("hamming, density") << W::Hamming << S::Density
                                      << QList<double>{0.0012573269118528966, 0.0081899536284847, 0.002273514481273781,
                                                       2.2633325686973051e-07};
    QTest::newRow("blackman, density") << W::Blackman << S::Density
                                       << QList<double>{0.0024911115918465113, 0.007795586921607903,
                                                        0.0019799728454724928, 1.391817354766971e-11};
    QTest::newRow("flattop, spectrum") << W::FlatTop << S::Amplitude
                                       << QList<double>{0.6297567674261366, 0.6755115299771849, 0.1243286210246,
                                                        9.506665460390937e-10};
}

static std::vector<double> scipySignal()
{
    std::vector<double> x(100);
    for (std::size_t k = 0; k < x.size(); ++k) {
        const auto i = static_cast<double>(k);
        x[k] = std::sin(0.3 * i) + 0.5 * std::cos(1.1 * i) + 0.01 * i;
    }
    return x;
}

void TestSpectrum::agreesWithSciPy()
{
    QFETCH(SpectrumWindow, window);
    QFETCH(SpectrumScaling, scaling);
    QFETCH(QList<double>, expected);
    const Spectrum s = welch(scipySignal(), 1e-3, {window, scaling, 32, 0.5, true});
    QCOMPARE(s.power.size(), std::size_t{17});
    QCOMPARE(s.segments, std::size_t{5});
    const std::array<std::size_t, 4> bins{0, 2, 6, 16};
    // Rounding of the transform is about 1e-16 of the largest bin.
    const double largest = *std::max_element(s.power.begin(), s.power.end());
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const double wanted = expected[static_cast<qsizetype>(i)];
        QVERIFY2(std::abs(s.power[bins[i]] - wanted) <= 1e-11 * wanted + 1e-17 * largest,
                 qPrintable(QString("bin %1: %2, SciPy %3")
                                .arg(bins[i])
                                .arg(s.power[bins[i]], 0, 'g', 17)
                                .arg(wanted, 0, 'g', 17)));
    }
}

// f, P = scipy.signal.welch(x, fs=1e3, window='hann', nperseg=33, noverlap=8, scaling='density', detrend=False)
void TestSpectrum::oddSegmentWithoutMeanRemoval()
{
    const Spectrum s =
        welch(scipySignal(), 1e-3, {SpectrumWindow::Hann, SpectrumScaling::Density, 33, 8.5 / 33.0, false});
    QCOMPARE(s.power.size(), std::size_t{17});
    QVERIFY(near(s.power[0], 0.005673312492200998, 1e-11));
    QVERIFY(near(s.power[2], 0.008889829239498432, 1e-11));
    QVERIFY(near(s.power[6], 0.0026014315156018884, 1e-11));
    QVERIFY(near(s.power[16], 1.2547213282251583e-11, 1e-5));
}

void TestSpectrum::shortSignals_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<double>("interval");
    QTest::addColumn<int>("bins");
    QTest::newRow("none") << 0 << 1.0 << 0;
    QTest::newRow("one") << 1 << 1.0 << 0;
    QTest::newRow("seven") << 7 << 1.0 << 0;
    QTest::newRow("eight: one segment of eight") << 8 << 1.0 << 5;
    QTest::newRow("shorter than the segment") << 100 << 1.0 << 51;
    QTest::newRow("no interval") << 100 << 0.0 << 0;
    QTest::newRow("interval not a number") << 100 << std::nan("") << 0;
}

void TestSpectrum::shortSignals()
{
    QFETCH(int, samples);
    QFETCH(double, interval);
    QFETCH(int, bins);
    const Spectrum s = welch(noise(static_cast<std::size_t>(samples), 1.0), interval);
    QCOMPARE(s.power.size(), static_cast<std::size_t>(bins));
    QCOMPARE(s.frequency.size(), s.power.size());
    QCOMPARE(s.empty(), bins == 0);
    QVERIFY(bins > 0 || findPeaks(s, SpectrumScaling::Density).empty());
}

/// A Gaussian h exp(-(x - x0)^2/w) is a parabola in its logarithm: the top is found to rounding.
void TestSpectrum::topBetweenBins()
{
    for (const double place : {-0.49, -0.2, 0.0, 0.37}) {
        const auto power = [&](double x) { return 3e-18 * std::exp(-std::pow(x - place, 2) / 1.7); };
        const PeakTop top = topBetween(power(-1.0), power(0.0), power(1.0));
        QVERIFY(std::abs(top.offset - place) < 1e-12);
        QVERIFY(std::abs(top.power - 3e-18) < 1e-12 * 3e-18);
    }
    QCOMPARE(topBetween(2.0, 2.0, 2.0).offset, 0.0); // flat
}

void TestSpectrum::constantSignalHasNoPower()
{
    const Spectrum s = welch(std::vector<double>(5000, 7.1e-9), 1e-7);
    QCOMPARE(s.segment, std::size_t{2048});
    for (double p : s.power) QCOMPARE(p, 0.0);
    QVERIFY(findPeaks(s, SpectrumScaling::Density).empty());
}

// A Hann window sees a sine that is delta bins off with the amplitude W = sinc(delta) / (1 - delta^2). The
// parabola through ln W^2 at delta - 1, delta, delta + 1 then has its top at the offset and value below: at
// most 0.016 bins and 3.8 % off, where the nearest bin alone is off by half a bin and 15 %.
void TestSpectrum::peakBetweenBins_data()
{
    QTest::addColumn<double>("bin");
    QTest::newRow("quarter") << 60.25;
    QTest::newRow("nearly half") << 60.49;
    QTest::newRow("just below the next") << 60.9;
}

void TestSpectrum::peakBetweenBins()
{
    QFETCH(double, bin);
    const double nearest = std::round(bin);
    const auto lobe = [](double delta) {
        return 2.0 * std::log(std::abs(std::sin(pi * delta) / (pi * delta * (1.0 - delta * delta))));
    };
    const double left = lobe(nearest - 1.0 - bin);
    const double middle = lobe(nearest - bin);
    const double right = lobe(nearest + 1.0 - bin);
    const double offset = 0.5 * (left - right) / (left - 2.0 * middle + right);
    const double amplitude = 3.0 * std::exp(0.5 * (middle - 0.25 * (left - right) * offset));

    const Spectrum s =
        welch(sine(8192, 3.0, bin / 1024.0), 1e-6, {SpectrumWindow::Hann, SpectrumScaling::Density, 1024, 0.5, true});
    const std::vector<Peak> peaks = findPeaks(s, SpectrumScaling::Density, 1);
    QCOMPARE(peaks.size(), std::size_t{1});
    // The sine's mirror at -f leaks about (1/120)^3 in.
    QVERIFY(near(peaks[0].frequency, (nearest + offset) * s.frequency[1], 1e-5));
    QVERIFY(near(peaks[0].amplitude, amplitude, 1e-4));
    QVERIFY(std::abs(peaks[0].frequency / s.frequency[1] - bin) < 0.017);
    QVERIFY(near(peaks[0].amplitude, 3.0, 0.039));
}

void TestSpectrum::peaksAreOrderedAndLimited()
{
    std::vector<double> x = sine(8192, 1.0, 50.0 / 1024.0);
    const std::vector<double> second = sine(8192, 3.0, 120.0 / 1024.0);
    const std::vector<double> third = sine(8192, 2.0, 300.0 / 1024.0);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += second[i] + third[i];
    const Spectrum s = welch(x, 1e-6, {SpectrumWindow::Hann, SpectrumScaling::Amplitude, 1024, 0.5, true});
    const std::vector<Peak> peaks = findPeaks(s, SpectrumScaling::Amplitude, 2);
    QCOMPARE(peaks.size(), std::size_t{2});
    QVERIFY(near(peaks[0].amplitude, 3.0, 1e-6));
    QVERIFY(near(peaks[1].amplitude, 2.0, 1e-6));
    QVERIFY(near(peaks[1].frequency, 300.0 * s.frequency[1], 1e-6));
}

// 500 segments scatter by 1/sqrt(500) = 4.5 %: no bin of noise stands out tenfold, a sine does.
void TestSpectrum::noiseFloorIsNoPeak()
{
    std::vector<double> x = noise(128 * 500, 1.0);
    const WelchOptions options{SpectrumWindow::Hann, SpectrumScaling::Density, 128, 0.0, true};
    QVERIFY(findPeaks(welch(x, 1e-6, options), SpectrumScaling::Density).empty());
    const std::vector<double> tone = sine(x.size(), 1.0, 20.0 / 128.0);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += tone[i];
    QCOMPARE(findPeaks(welch(x, 1e-6, options), SpectrumScaling::Density).size(), std::size_t{1});
}

void TestSpectrum::repeatsBitForBit()
{
    const std::vector<double> x = noise(20000, 1.0);
    WelchEstimator kept({});
    const Spectrum first = kept(x, 1e-7);
    kept(std::span(x).first(300), 1e-7); // another shape in between
    QCOMPARE(kept(x, 1e-7).power, first.power);
    QCOMPARE(welch(x, 1e-7).power, first.power);
}

void TestSpectrum::threadsDoNotDisturbEachOther()
{
    const std::vector<double> x = noise(6000, 1.0);
    std::array<Spectrum, 4> alone;
    std::array<Spectrum, 4> together;
    const auto options = [](std::size_t i) {
        return WelchOptions{SpectrumWindow::Hann, SpectrumScaling::Density, 100 + 37 * i, 0.5, true};
    };
    for (std::size_t i = 0; i < 4; ++i) alone[i] = welch(x, 1e-7, options(i));
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < 4; ++i)
            threads.emplace_back([&, i] {
                for (int repeat = 0; repeat < 50; ++repeat) together[i] = welch(x, 1e-7, options(i));
            });
    }
    for (std::size_t i = 0; i < 4; ++i) QCOMPARE(together[i].power, alone[i].power);
}

TOUCHDOWN_TEST(TestSpectrum)

} // namespace test_spectrum

#include "test_spectrum.moc"
