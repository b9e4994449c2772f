// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/roughness.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/physics/disk/surface_statistics.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_roughness {

using std::numbers::pi;
constexpr int seeds = 20;

/// 400 um of track: 1600 x 128 points.
DiskSurface rough(RoughnessSpectrum spectrum)
{
    DiskSurface s;
    s.kind = DiskSurfaceKind::Rough;
    s.spectrum = spectrum;
    s.track = 400e-6;
    return s;
}

UniformGrid gridOf(const DiskSurface& s)
{
    return {mapColumns(s), mapRows(s), s.cell, s.cell, -0.5 * s.cell, -0.5 * s.cell};
}

SurfaceStatistics statisticsOf(const DiskSurface& s)
{
    return surfaceStatistics(gridOf(s), generateRoughness(s), true);
}

/// Of seeds 1 to 20; computed once.
const std::vector<SurfaceStatistics>& statisticsOfSeeds(RoughnessSpectrum spectrum)
{
    static std::map<RoughnessSpectrum, std::vector<SurfaceStatistics>> known;
    std::vector<SurfaceStatistics>& all = known[spectrum];
    DiskSurface s = rough(spectrum);
    if (all.empty())
        for (s.seed = 1; s.seed <= seeds; ++s.seed) all.push_back(statisticsOf(s));
    return all;
}

void spectra()
{
    QTest::addColumn<RoughnessSpectrum>("spectrum");
    QTest::newRow("gaussian") << RoughnessSpectrum::Gaussian;
    QTest::newRow("exponential") << RoughnessSpectrum::Exponential;
    QTest::newRow("self-affine") << RoughnessSpectrum::SelfAffine;
}

class TestRoughness : public QObject {
    Q_OBJECT

private slots:
    void theRmsIsExactAndTheMeanZero_data() { spectra(); }
    void theRmsIsExactAndTheMeanZero()
    {
        QFETCH(RoughnessSpectrum, spectrum);
        const DiskSurface s = rough(spectrum);
        for (const SurfaceStatistics& statistics : statisticsOfSeeds(spectrum)) {
            QVERIFY(std::abs(statistics.rms / s.rms - 1.0) < 1e-12);
            QVERIFY(std::abs(statistics.mean) < 1e-12 * s.rms);
        }
    }

    // Of all densities of 20 seeds 95 % lie between the limits. Those of different wave numbers are independent: of n
    // of them the share outside scatters by sqrt(0.05 0.95/n); four of these are allowed beyond what the limits
    // themselves are off, 0.01 (Wilson & Hilferty's quantiles of a weighted sum).
    void theDensityOf20SeedsIsWithinItsLimits_data() { spectra(); }
    void theDensityOf20SeedsIsWithinItsLimits()
    {
        QFETCH(RoughnessSpectrum, spectrum);
        const DiskSurface s = rough(spectrum);
        const RequestedSpectrum request(s);
        int outside = 0, all = 0;
        for (const SurfaceStatistics& statistics : statisticsOfSeeds(spectrum)) {
            const ProfilePsd& psd = statistics.psd;
            const double plateau = request.profile(psd.waveNumber.front()).density;
            for (std::size_t k = 0; k < psd.density.size(); ++k) {
                const RequestedPsd asked = request.profile(psd.waveNumber[k]);
                if (asked.density < 1e-12 * plateau) { // nothing is asked for: what is left is rounding
                    QVERIFY(psd.density[k] < 1e-11 * plateau);
                    continue;
                }
                ++all;
                if (psd.density[k] < asked.low || psd.density[k] > asked.high) ++outside;
            }
        }
        const double share = static_cast<double>(outside) / all;
        const double scatter = std::sqrt(0.05 * 0.95 / all);
        QVERIFY2(std::abs(share - 0.05) < 0.01 + 4.0 * scatter, qPrintable(QString::number(share)));
    }

    // The mean of 20 seeds over tenths of a decade: limits of the many modes in a bin are narrow, and a shape that was
    // wrong by a few per cent would leave them. In each bin the chance is one in 20 to be outside twice the standard
    // deviation.
    void theMeanOf20SeedsFollowsTheRequest_data() { spectra(); }
    void theMeanOf20SeedsFollowsTheRequest()
    {
        QFETCH(RoughnessSpectrum, spectrum);
        const DiskSurface s = rough(spectrum);
        const RequestedSpectrum request(s);
        ProfilePsd mean;
        for (const SurfaceStatistics& statistics : statisticsOfSeeds(spectrum)) {
            const ProfilePsd& psd = statistics.psd;
            if (mean.density.empty())
                mean = ProfilePsd{psd.waveNumber, std::vector<double>(psd.density.size()), psd.modes};
            // Each against its own request, and so all of one size.
            for (std::size_t k = 0; k < psd.density.size(); ++k) {
                const double asked = request.profile(psd.waveNumber[k]).density;
                mean.density[k] += asked > 0.0 ? psd.density[k] / asked / seeds : 0.0;
            }
        }
        const double plateau = request.profile(mean.waveNumber.front()).density;
        double sum = 0.0, variance = 0.0;
        int bins = 0, beyond = 0, modes = 0;
        for (std::size_t k = 0; k < mean.density.size(); ++k) {
            const RequestedPsd asked = request.profile(mean.waveNumber[k], seeds);
            if (asked.density < 1e-12 * plateau) break;
            const double deviation = (asked.high - asked.low) / asked.density / (2.0 * 1.96);
            sum += mean.density[k] - 1.0;
            variance += deviation * deviation;
            if (++modes < 20) continue;
            ++bins;
            if (std::abs(sum) > 2.0 * std::sqrt(variance)) ++beyond;
            QVERIFY2(std::abs(sum) < 4.0 * std::sqrt(variance),
                     qPrintable(QString("q = %1: %2").arg(mean.waveNumber[k]).arg(sum / modes)));
            sum = variance = 0.0;
            modes = 0;
        }
        QVERIFY(bins >= 10);
        QVERIFY2(beyond <= 0.05 * bins + 4.0 * std::sqrt(0.05 * 0.95 * bins), qPrintable(QString::number(beyond)));
    }

    // The autocorrelation at lc is 1/e: exactly so in the mean, and the scatter of 20 seeds of 400 um is about
    // 2 %/sqrt(20) (2000 patches of pi lc^2/2 have sqrt(1/2000)).
    void theAutocorrelationFallsToOneOverEAtItsLength()
    {
        for (const auto spectrum : {RoughnessSpectrum::Gaussian, RoughnessSpectrum::Exponential}) {
            const DiskSurface s = rough(spectrum);
            double sum = 0.0;
            for (const SurfaceStatistics& statistics : statisticsOfSeeds(spectrum)) sum += statistics.correlationLength;
            QVERIFY2(std::abs(sum / seeds / s.correlationLength - 1.0) < 0.02,
                     qPrintable(QString::number(sum / seeds)));
        }
    }

    // Normal heights: skewness 0 and kurtosis 3, with standard deviations sqrt(6/n), sqrt(24/n) for n independent
    // heights. For R = exp(-r^2/lc^2) the sums over pairs, 6 R^3 and 24 R^4, give n = 3 A/(pi lc^2) and 4 A/(pi lc^2).
    void theHeightsAreNormal()
    {
        const DiskSurface s = rough(RoughnessSpectrum::Gaussian);
        const double patches = s.track * s.trackWidth / (pi * s.correlationLength * s.correlationLength);
        double skewness = 0.0, kurtosis = 0.0;
        for (const SurfaceStatistics& statistics : statisticsOfSeeds(RoughnessSpectrum::Gaussian)) {
            QVERIFY(std::abs(statistics.skewness) < 4.0 * std::sqrt(6.0 / (3.0 * patches)));
            QVERIFY(std::abs(statistics.kurtosis - 3.0) < 4.0 * std::sqrt(24.0 / (4.0 * patches)));
            skewness += statistics.skewness / seeds;
            kurtosis += statistics.kurtosis / seeds;
        }
        QVERIFY(std::abs(skewness) < 3.0 * std::sqrt(6.0 / (3.0 * patches * seeds)));
        QVERIFY(std::abs(kurtosis - 3.0) < 3.0 * std::sqrt(24.0 / (4.0 * patches * seeds)));
    }

    // <(dw/dx)^2> = sigma^2 2/lc^2 for R = exp(-r^2/lc^2); differences over one cell d see 2 (1 - exp(-d^2/lc^2))/d^2
    // of it.
    void theSlopeIsThatOfTheSpectrum()
    {
        const DiskSurface s = rough(RoughnessSpectrum::Gaussian);
        const double d = s.cell / s.correlationLength;
        const double expected = s.rms / s.cell * std::sqrt(2.0 * (1.0 - std::exp(-d * d)));
        double x = 0.0, y = 0.0;
        for (const SurfaceStatistics& statistics : statisticsOfSeeds(RoughnessSpectrum::Gaussian)) {
            x += statistics.slopeX / seeds;
            y += statistics.slopeY / seeds;
        }
        // 2000 patches pi lc^2/2 a seed: over 20 of them 1/sqrt(2 40000) of itself; four times that.
        QVERIFY(std::abs(x / expected - 1.0) < 0.014);
        QVERIFY(std::abs(y / expected - 1.0) < 0.014);
    }

    // What is asked for against the integrals of the spectra over the wave number across, where neither points nor
    // periods matter: sigma^2 lc/sqrt(pi) exp(-q^2 lc^2/4) and (2/pi) sigma^2 lc/(1 + q^2 lc^2), whose integral over q
    // > 0 is sigma^2.
    void theRequestIsTheSpectrumOfTheProfile()
    {
        DiskSurface s = rough(RoughnessSpectrum::Gaussian);
        s.cell = 0.05e-6;
        s.trackWidth = 100e-6;
        const double lc = s.correlationLength, sigma = s.rms;
        // Without the wave number 0, of which the share is pi lc^2/(track x width) and twice that.
        const double mean = pi * lc * lc / (s.track * s.trackWidth);
        for (const double q : {1e4, 3e5, 1e6, 2e6}) {
            const double u = q * lc;
            const double gaussian = sigma * sigma * lc / std::sqrt(pi) * std::exp(-0.25 * u * u) / (1.0 - mean);
            QVERIFY(std::abs(RequestedSpectrum(s).profile(q).density / gaussian - 1.0) < 1e-9);
        }
        s.spectrum = RoughnessSpectrum::Exponential;
        for (const double q : {1e4, 3e5, 1e6, 2e6}) {
            const double u = q * lc;
            const double exponential = 2.0 / pi * sigma * sigma * lc / (1.0 + u * u) / (1.0 - 2.0 * mean);
            // Folded: a share of about (q cell)^2/12, and the step at the origin (cell/lc)^2/12.
            const double folded = (q * s.cell * q * s.cell + 0.025 * 0.025) / 12.0 * 1.05;
            QVERIFY(std::abs(RequestedSpectrum(s).profile(q).density / exponential - 1.0) < folded + 1e-8);
        }
    }

    // In the plane C = C0, C0 (q/q_r)^(-2-2H), 0. On a wide track C0 follows from sigma^2 = 2 pi C0 (q_r^2/2 + q_r^2 (1
    // - (q_c/q_r)^(-2H))/(2H)).
    void theSelfAffineSpectrumIsThatOfTheHeader()
    {
        DiskSurface s = rough(RoughnessSpectrum::SelfAffine);
        s.trackWidth = 400e-6;
        const RequestedSpectrum request(s);
        const double qr = 2.0 * pi / s.rollOff, qc = 2.0 * pi / s.cutOff;
        const double c0 =
            s.rms * s.rms / (2.0 * pi * qr * qr * (0.5 + (1.0 - std::pow(qc / qr, -2.0 * s.hurst)) / (2.0 * s.hurst)));
        // Sums over 25 waves in each direction up to the roll-off instead of the integral.
        QVERIFY(std::abs(request.density(0.5 * qr) / c0 - 1.0) < 0.01);
        QCOMPARE(request.density(0.1 * qr), request.density(0.99 * qr));
        QVERIFY(std::abs(request.density(4.0 * qr) / request.density(qr) - std::pow(4.0, -3.6)) < 1e-12);
        QCOMPARE(request.density(1.001 * qc), 0.0);
    }

    void theRequestedVarianceIsTheAskedOne_data() { spectra(); }
    void theRequestedVarianceIsTheAskedOne()
    {
        QFETCH(RoughnessSpectrum, spectrum);
        const DiskSurface s = rough(spectrum);
        const RequestedSpectrum request(s);
        // Over all wave numbers of the period and q = 0 with half its density, less the mean.
        const int n = mapColumns(s);
        const double step = 2.0 * pi / s.track;
        double sum = 0.5 * request.profile(0.0).density * step;
        for (int k = 1; k <= n / 2; ++k) sum += (2 * k == n ? 0.5 : 1.0) * request.profile(k * step).density * step;
        sum -= request.density(0.0) * step * 2.0 * pi / s.trackWidth;
        QVERIFY2(std::abs(sum / (s.rms * s.rms) - 1.0) < 1e-6,
                 qPrintable(QString::number(sum / (s.rms * s.rms) - 1.0)));
    }

    void theSameSeedGivesTheSameBits_data() { spectra(); }
    void theSameSeedGivesTheSameBits()
    {
        QFETCH(RoughnessSpectrum, spectrum);
        DiskSurface s = rough(spectrum);
        s.track = 100e-6;
        const auto first = generateRoughness(s);
        QVERIFY(generateRoughness(s) == first);
        s.seed = 2;
        QVERIFY(generateRoughness(s) != first);
    }

    void anyNumberOfPointsWillDo_data()
    {
        QTest::addColumn<int>("nx");
        QTest::addColumn<int>("ny");
        QTest::newRow("even") << 64 << 64;
        QTest::newRow("odd along") << 65 << 64;
        QTest::newRow("odd across") << 64 << 65;
        QTest::newRow("prime") << 67 << 71;
    }
    void anyNumberOfPointsWillDo()
    {
        QFETCH(int, nx);
        QFETCH(int, ny);
        for (const auto spectrum :
             {RoughnessSpectrum::Gaussian, RoughnessSpectrum::Exponential, RoughnessSpectrum::SelfAffine}) {
            DiskSurface s = rough(spectrum);
            s.track = nx * s.cell;
            s.trackWidth = ny * s.cell;
            const SurfaceStatistics statistics = statisticsOf(s);
            QVERIFY(std::abs(statistics.rms / s.rms - 1.0) < 1e-12);
            QVERIFY(std::isfinite(statistics.kurtosis));
        }
    }
};

TOUCHDOWN_TEST(TestRoughness)

} // namespace test_roughness

#include "test_roughness.moc"
