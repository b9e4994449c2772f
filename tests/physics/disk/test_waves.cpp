// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/waves.h"

#include <QTest>

#include <cmath>
#include <numbers>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_waves {

using std::numbers::pi;

DiskSurface twoWaves()
{
    DiskSurface s;
    s.kind = DiskSurfaceKind::Waves;
    s.waveAmplitudes = {1e-9, 0.4e-9};
    s.waveLengths = {50e-6, 7e-6};
    s.waveAngles = {0.0, 0.6};
    s.wavePhases = {0.0, 1.1};
    return s;
}

/// The sum as the header prints it.
double exact(const DiskSurface& s, double x, double y)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < s.waveAmplitudes.size(); ++i)
        sum += s.waveAmplitudes[i] *
               std::sin(2.0 * pi * (x * std::cos(s.waveAngles[i]) + y * std::sin(s.waveAngles[i])) / s.waveLengths[i] +
                        s.wavePhases[i]);
    return sum;
}

class TestWaves : public QObject {
    Q_OBJECT

private slots:
    void theHeightIsTheSumOfSines()
    {
        const DiskSurface s = twoWaves();
        const Waves waves(s);
        for (const double x : {0.0, 1e-6, 33e-6, -2e-3})
            for (const double y : {0.0, 5e-6, -70e-6}) QVERIFY(std::abs(waves.height(x, y) - exact(s, x, y)) < 1e-20);
    }

    void emptyAnglesAndPhasesAreZero()
    {
        DiskSurface s = twoWaves();
        s.waveAngles = {};
        s.wavePhases = {};
        DiskSurface zeros = s;
        zeros.waveAngles = zeros.wavePhases = {0.0, 0.0};
        QCOMPARE(Waves(s).height(1e-6, 2e-6), exact(zeros, 1e-6, 2e-6));
    }

    void aMovedGridSeesWhatTheDiskHasThere()
    {
        const DiskSurface s = twoWaves();
        const Waves waves(s);
        const UniformGrid grid{600, 3, 0.3e-6, 0.4e-6, -5e-6, 1e-6};
        std::vector<double> heights(grid.cells(), 1e-9); // what is there already stays
        waves.addHeights(grid, 12.3e-6, -4.5e-6, heights);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                const double expected = 1e-9 + exact(s, grid.x(i) - 12.3e-6, grid.y(j) + 4.5e-6);
                QVERIFY(std::abs(heights[static_cast<std::size_t>(j * grid.nx + i)] - expected) < 1e-21);
            }
    }

    // The integral of sin over a cell is the difference of -cos/k at its sides; of waves at an angle likewise across.
    void theMeanIsTheIntegralOverTheCell()
    {
        const DiskSurface s = twoWaves();
        const Waves waves(s);
        const CellGrid grid{{0.0, 1e-10, 3e-6, 60e-6}, {-1e-6, 0.0, 20e-6}};
        std::vector<double> means(grid.cells(), 0.0);
        waves.addMeans(grid, 2e-6, 1e-6, means);
        for (int j = 0; j < grid.ny(); ++j)
            for (int i = 0; i < grid.nx(); ++i) {
                const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
                const double x0 = grid.x[k] - 2e-6, x1 = grid.x[k + 1] - 2e-6, y0 = grid.y[l] - 1e-6,
                             y1 = grid.y[l + 1] - 1e-6;
                const double k1 = 2.0 * pi / 50e-6;
                double expected = 1e-9 * (std::cos(k1 * x0) - std::cos(k1 * x1)) / (k1 * (x1 - x0));
                const double kx = 2.0 * pi / 7e-6 * std::cos(0.6), ky = 2.0 * pi / 7e-6 * std::sin(0.6);
                const auto f = [&](double x, double y) { return -std::sin(kx * x + ky * y + 1.1) / (kx * ky); };
                expected += 0.4e-9 * (f(x1, y1) - f(x0, y1) - f(x1, y0) + f(x0, y0)) / ((x1 - x0) * (y1 - y0));
                // The differences lose digits in the cell of 0.1 nm: 1e-16/(k width) of the amplitude and more.
                const double allowed = i == 0 ? 1e-20 : 1e-23;
                const double error = means[l * 3 + k] - expected;
                QVERIFY2(std::abs(error) < allowed, qPrintable(QString::number(error)));
            }
    }

    void aWaveShorterThanTheCellIsAveragedOut()
    {
        DiskSurface s = twoWaves();
        s.waveAmplitudes = {1e-9};
        s.waveLengths = {2e-6};
        s.waveAngles = {};
        s.wavePhases = {0.3};
        const CellGrid grid{{0.1e-6, 2.1e-6, 12.1e-6, 15.1e-6}, {0.0, 1e-6}};
        std::vector<double> means(grid.cells(), 0.0);
        Waves(s).addMeans(grid, 0.0, 0.0, means);
        QVERIFY(std::abs(means[0]) < 1e-24);
        QVERIFY(std::abs(means[1]) < 1e-24);
        QVERIFY(std::abs(means[2]) <= 1e-9 / (1.5 * pi)); // at most 1/u, u = pi width/length
    }

    void noHeightExceedsTheSumOfAmplitudes()
    {
        const Waves waves(twoWaves());
        QVERIFY(std::abs(waves.amplitude() - 1.4e-9) < 1e-22);
        DiskSurface pit = twoWaves();
        pit.waveAmplitudes[0] = -1e-9;
        QVERIFY(std::abs(Waves(pit).amplitude() - 1.4e-9) < 1e-22);
    }
};

TOUCHDOWN_TEST(TestWaves)

} // namespace test_waves

#include "test_waves.moc"
