// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <cmath>
#include <numbers>

#include "core/numerics/plane_convolution.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_plane_convolution {

class TestPlaneConvolution : public QObject {
    Q_OBJECT

private slots:
    void isTheSumOverAllPairs_data();
    void isTheSumOverAllPairs();
    void multipliesWaves_data();
    void multipliesWaves();
    void paddedSizesSuitFftw();
    void allocatesNothing();
};

std::size_t product(int a, int b) { return static_cast<std::size_t>(a) * static_cast<std::size_t>(b); }

double kernel(int i, int j) { return 1.0 / (1.0 + std::abs(i) + 0.7 * j * j); }

std::vector<double> field(int nx, int ny)
{
    std::vector<double> values(product(nx, ny));
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(1.0 + 3.7 * static_cast<double>(k * k % 101));
    return values;
}

PlaneConvolution padded(int nx, int ny)
{
    const int mx = paddedSize(nx);
    const int my = paddedSize(ny);
    std::vector<double> quarter;
    for (int j = 0; j <= my / 2; ++j)
        for (int i = 0; i <= mx / 2; ++i) quarter.push_back(kernel(i, j));
    PlaneConvolution::transformKernel(quarter, mx, my);
    PlaneConvolution convolution(nx, ny, mx, my);
    convolution.setTransform(quarter);
    return convolution;
}

void TestPlaneConvolution::isTheSumOverAllPairs_data()
{
    QTest::addColumn<int>("nx");
    QTest::addColumn<int>("ny");
    QTest::newRow("one cell") << 1 << 1;
    QTest::newRow("a row") << 9 << 1;
    QTest::newRow("a column") << 1 << 6;
    QTest::newRow("even") << 8 << 6;
    QTest::newRow("odd") << 7 << 13;
    QTest::newRow("a prime above 7") << 23 << 11;
}

void TestPlaneConvolution::isTheSumOverAllPairs()
{
    QFETCH(int, nx);
    QFETCH(int, ny);
    std::vector<double> values = field(nx, ny);
    std::vector<double> expected(values.size(), 0.0);
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            for (int l = 0; l < ny; ++l)
                for (int k = 0; k < nx; ++k)
                    expected[product(j, nx) + std::size_t(i)] +=
                        kernel(i - k, j - l) * values[product(l, nx) + std::size_t(k)];
    PlaneConvolution convolution = padded(nx, ny);
    std::vector<double> out(values.size());
    convolution.apply(values, out);
    convolution.apply(values, values); // in place, and once more with the same working memory
    for (std::size_t k = 0; k < out.size(); ++k) {
        QVERIFY(std::abs(out[k] - expected[k]) < 1e-13);
        QCOMPARE(values[k], out[k]);
    }
}

void TestPlaneConvolution::multipliesWaves_data()
{
    QTest::addColumn<int>("waveX");
    QTest::addColumn<int>("waveY");
    QTest::newRow("mean") << 0 << 0;
    QTest::newRow("along x") << 2 << 0;
    QTest::newRow("along y") << 0 << 3;
    QTest::newRow("oblique") << 3 << 2;
    QTest::newRow("oblique the other way") << 3 << -2;
    QTest::newRow("shortest along y") << 1 << 5;
}

void multiplyWave(int nx, int ny, int waveX, int waveY)
{
    std::vector<double> transform;
    for (int j = 0; j <= ny / 2; ++j)
        for (int i = 0; i <= nx / 2; ++i) transform.push_back(1.0 + 10.0 * i + j);
    PlaneConvolution convolution(nx, ny, nx, ny);
    convolution.setTransform(transform);
    std::vector<double> wave;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            wave.push_back(std::cos(2.0 * std::numbers::pi * (waveX * i / double(nx) + waveY * j / double(ny)) + 0.3));
    std::vector<double> out(wave.size());
    convolution.apply(wave, out);
    const double factor = 1.0 + 10.0 * waveX + std::abs(waveY);
    for (std::size_t k = 0; k < out.size(); ++k) QVERIFY(std::abs(out[k] - factor * wave[k]) < 1e-13 * factor);
}

/// In domains that are longer along x and along y.
void TestPlaneConvolution::multipliesWaves()
{
    QFETCH(int, waveX);
    QFETCH(int, waveY);
    multiplyWave(11, 10, waveX, waveY);
    multiplyWave(9, 10, waveX, waveY);
}

void TestPlaneConvolution::paddedSizesSuitFftw()
{
    QCOMPARE(paddedSize(1), 2);    // 1 is odd
    QCOMPARE(paddedSize(4), 8);    // 7 is odd
    QCOMPARE(paddedSize(9), 20);   // no code for 18
    QCOMPARE(paddedSize(11), 32);  // nor for 22 to 30
    QCOMPARE(paddedSize(33), 72);  // the power of two is twice as long
    QCOMPARE(paddedSize(55), 128); // 112 is more than three quarters of it
    QCOMPARE(paddedSize(128), 256);
    QCOMPARE(paddedSize(182), 384); // 368 and 376 have the prime factors 23 and 47
    QCOMPARE(paddedSize(600), 1200);
}

void TestPlaneConvolution::allocatesNothing()
{
    PlaneConvolution convolution = padded(40, 30);
    std::vector<double> values = field(40, 30);
    convolution.apply(values, values);
    const long long before = test::allocations;
    convolution.apply(values, values);
    QCOMPARE(test::allocations.load(), before);
}

TOUCHDOWN_TEST(TestPlaneConvolution)

} // namespace test_plane_convolution

#include "test_plane_convolution.moc"
