// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sample_points.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_sample_points {

using Points = std::vector<std::vector<double>>;

/// Mean of a product of cosines over the points: 0 for an even distribution over the cube.
double unevenness(const Points& points)
{
    double sum = 0.0;
    for (const auto& point : points) {
        double product = 1.0;
        for (const double x : point) product *= 1.0 + 0.5 * (x - 0.5);
        sum += product - 1.0;
    }
    return std::abs(sum) / double(points.size());
}

class TestSamplePoints : public QObject {
    Q_OBJECT

private slots:
    void liesInTheCube_data()
    {
        QTest::addColumn<SampleMethod>("method");
        for (const SampleMethod each : {SampleMethod::Random, SampleMethod::LatinHypercube, SampleMethod::Sobol})
            QTest::addRow("%s", std::string(name(each)).c_str()) << each;
    }
    void liesInTheCube()
    {
        QFETCH(SampleMethod, method);
        for (const std::size_t dimensions : {1, 2, 5, 16}) {
            const Points points = samplePoints(method, dimensions, 1000, 3);
            QCOMPARE(points.size(), std::size_t(1000));
            for (const auto& point : points) {
                QCOMPARE(point.size(), dimensions);
                for (const double x : point) QVERIFY(x >= 0.0 && x < 1.0);
            }
            QVERIFY2(unevenness(points) < 0.1, qPrintable(QString::number(unevenness(points))));
            QVERIFY(samplePoints(method, dimensions, 1000, 3) == points);
            QVERIFY(samplePoints(method, dimensions, 1000, 4) != points);
        }
    }
    /// A longer list begins with a shorter one.
    void goesOn()
    {
        for (const SampleMethod method : {SampleMethod::Random, SampleMethod::Sobol}) {
            const Points few = samplePoints(method, 3, 20, 7), many = samplePoints(method, 3, 64, 7);
            QVERIFY(std::equal(few.begin(), few.end(), many.begin()));
        }
    }
    void eachSliceOfALatinHypercubeHoldsOne()
    {
        const Points points = samplePoints(SampleMethod::LatinHypercube, 4, 50, 1);
        for (std::size_t d = 0; d < 4; ++d) {
            std::set<int> slices;
            for (const auto& point : points) slices.insert(int(50.0 * point[d]));
            QCOMPARE(slices.size(), std::size_t(50));
        }
    }
    /// The mean of a smooth function: that of Sobol's points is far nearer than 1/sqrt(n) of random ones.
    void sobolIsEven()
    {
        double sobol = 0.0, random = 0.0;
        for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
            sobol += unevenness(samplePoints(SampleMethod::Sobol, 5, 1024, seed));
            random += unevenness(samplePoints(SampleMethod::Random, 5, 1024, seed));
        }
        QVERIFY2(sobol < 0.1 * random, qPrintable(QString("%1 %2").arg(sobol).arg(random)));
    }
    /// Values of scipy.special.ndtri.
    void quantilesOfANormalDistribution()
    {
        for (const auto& [share, value] : {std::pair(0.5, 0.0), std::pair(0.975, 1.959963984540054),
                                           std::pair(1e-10, -6.361340902404056), std::pair(0.9, 1.2815515655446004)})
            QVERIFY(std::abs(normalQuantile(share) - value) < 1e-9);
    }
};

TOUCHDOWN_TEST(TestSamplePoints)

} // namespace test_sample_points

#include "test_sample_points.moc"
