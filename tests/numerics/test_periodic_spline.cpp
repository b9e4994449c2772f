// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/periodic_spline.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_periodic_spline {

void addMeans(const PeriodicSpline& s, const CellGrid& grid, double shiftX, double shiftY, std::span<double> out)
{
    std::vector<double> work;
    s.addMeans(grid, shiftX, shiftY, out, work);
}

using std::numbers::pi;

std::vector<double> noise(int nx, int ny, unsigned seed = 7)
{
    std::mt19937_64 engine(seed);
    std::vector<double> values(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
    double sum = 0.0;
    for (double& v : values) sum += v = static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5;
    for (double& v : values) v -= sum / static_cast<double>(values.size());
    return values;
}

/// cos(2 pi (i/period)) along x, the same across.
PeriodicSpline cosine(int period)
{
    std::vector<double> values;
    for (int i = 0; i < period; ++i) values.push_back(std::cos(2.0 * pi * i / period));
    return {period, 1, 1.0, 1.0, std::move(values)};
}

/// Cells whose centres are the points of a spline, `margin` cells wider on each side.
UniformGrid pointsOf(const PeriodicSpline& s, int margin = 0)
{
    return {s.nx() + 2 * margin,      s.ny() + 2 * margin,     s.dx(), s.dy(),
            -(0.5 + margin) * s.dx(), -(0.5 + margin) * s.dy()};
}

std::vector<double> valuesOf(const PeriodicSpline& s, const UniformGrid& grid, double shiftX = 0.0, double shiftY = 0.0)
{
    std::vector<double> out(grid.cells(), 0.0);
    s.addValues(grid, shiftX, shiftY, out);
    return out;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

class TestPeriodicSpline : public QObject {
    Q_OBJECT

private slots:
    void itPassesThroughTheValues_data()
    {
        QTest::addColumn<int>("nx");
        QTest::addColumn<int>("ny");
        QTest::newRow("one value") << 1 << 1;
        QTest::newRow("two along") << 2 << 1;
        QTest::newRow("three across") << 1 << 3;
        QTest::newRow("fewer than the weights") << 4 << 3;
        QTest::newRow("as many as the recursion reaches") << 40 << 41;
        QTest::newRow("a map") << 96 << 50;
    }
    void itPassesThroughTheValues()
    {
        QFETCH(int, nx);
        QFETCH(int, ny);
        const auto values = noise(nx, ny);
        const PeriodicSpline s(nx, ny, 0.25e-6, 0.5e-6, values);
        const auto read = valuesOf(s, pointsOf(s));
        // Values of 1/2; sums of some thousand of them are rounded at 1e-13.
        QVERIFY(largestDifference(read, values) < 1e-12);
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                QVERIFY(std::abs(s.value(i * 0.25e-6, j * 0.5e-6) - read[static_cast<std::size_t>(j * nx + i)]) <
                        1e-12);
    }

    // Halfway between points, 1/2 and 3/2 from the nearest ones, the B-spline is 23/48 and 1/48; at points 2/3 and 1/6.
    // Of a wave cos(theta i) the spline keeps there (23 cos(theta/2) + cos(3 theta/2))/24 over (2 + cos theta)/3.
    void wavesLoseAsMuchAsASplineMust_data()
    {
        QTest::addColumn<int>("cells");
        QTest::addColumn<double>("kept"); // as the header of the disk's topography says
        QTest::newRow("2 cells") << 2 << 0.0;
        QTest::newRow("3 cells") << 3 << 0.875;
        QTest::newRow("4 cells") << 4 << 0.972;
        QTest::newRow("8 cells") << 8 << 0.9988;
        QTest::newRow("16 cells") << 16 << 0.99994;
    }
    void wavesLoseAsMuchAsASplineMust()
    {
        QFETCH(int, cells);
        QFETCH(double, kept);
        const double theta = 2.0 * pi / cells;
        const double factor =
            (23.0 * std::cos(theta / 2) + std::cos(3 * theta / 2)) / 24.0 / ((2.0 + std::cos(theta)) / 3.0);
        const double exact = std::cos(theta / 2);
        const double value = cosine(cells).value(0.5, 0.0);
        QVERIFY2(std::abs(value - factor * exact) < 1e-14, qPrintable(QString::number(value - factor * exact)));
        QVERIFY(std::abs(factor - kept) < 0.6 * std::pow(10.0, cells < 8 ? -3 : cells < 16 ? -4 : -5));
    }

    // The error of cubic spline interpolation falls with the fourth power of the step (de Boor 1978).
    void theErrorIsOfFourthOrder()
    {
        std::vector<double> errors;
        for (const int n : {16, 32, 64}) {
            const PeriodicSpline s = cosine(n);
            double error = 0.0;
            for (int k = 0; k < 1000; ++k)
                error = std::max(error, std::abs(s.value(k * n / 1000.0, 0.0) - std::cos(2.0 * pi * k / 1000.0)));
            errors.push_back(error);
        }
        for (std::size_t k = 1; k < errors.size(); ++k) {
            const double order = std::log2(errors[k - 1] / errors[k]);
            QVERIFY2(std::abs(order - 4.0) < 0.15, qPrintable(QString::number(order)));
        }
    }

    void valueSlopeAndCurvatureGoOnWhereItRepeats()
    {
        const PeriodicSpline s(12, 9, 1.0, 1.0, noise(12, 9));
        // A cubic with f''' about 10: one-sided second differences over h are apart by less than 2 h f''', and first
        // ones by h f''.
        const double h = 1e-3;
        for (const double seam : {0.0, 12.0, -12.0, 5.0})
            for (const double y : {0.3, 4.0, 8.7}) {
                const auto f = [&](double x) { return s.value(seam + x, y); };
                QVERIFY(std::abs(f(h) - f(-h)) < 10 * h);
                QVERIFY(std::abs((f(h) - f(0)) - (f(0) - f(-h))) / h < 20 * h);
                const double behind = (f(2 * h) - 2 * f(h) + f(0)) / (h * h);
                const double before = (f(0) - 2 * f(-h) + f(-2 * h)) / (h * h);
                QVERIFY2(std::abs(behind - before) < 40 * h, qPrintable(QString::number(behind - before)));
            }
    }

    void movedByWholeCellsItReturnsTheSameBits_data()
    {
        QTest::addColumn<double>("dx");
        QTest::addColumn<double>("fraction"); // of a cell, of the grid's first centre
        QTest::addColumn<double>("turns");
        for (const double turns : {0.0, 3.0, 1e3, 1e6})
            for (const double dx : {0.25e-6, 0.3e-6, 1e-6 / 3.0}) {
                const QString name = QString("cell %1 um, %2 periods, ").arg(dx * 1e6).arg(turns);
                QTest::newRow(qPrintable(name + "on points")) << dx << 0.0 << turns;
                QTest::newRow(qPrintable(name + "halfway")) << dx << 0.5 << turns;
            }
    }
    void movedByWholeCellsItReturnsTheSameBits()
    {
        QFETCH(double, dx);
        QFETCH(double, fraction);
        QFETCH(double, turns);
        const int nx = 400, ny = 24;
        const PeriodicSpline s(nx, ny, dx, dx, noise(nx, ny));
        const UniformGrid grid{nx, ny, dx, dx, (fraction - 0.5) * dx, (fraction - 0.5) * dx};
        const auto still = valuesOf(s, grid);
        for (const int cells : {1, 7, 399, 400, 1234}) {
            const double whole = cells + turns * nx;
            const auto moved = valuesOf(s, grid, whole * dx, -(cells + turns * ny) * dx);
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) {
                    const int from = ((i - cells) % nx + nx) % nx, row = (j + cells) % ny;
                    QCOMPARE(moved[static_cast<std::size_t>(j * nx + i)],
                             still[static_cast<std::size_t>(row * nx + from)]);
                }
        }
    }

    // Where the grid's points lie between those of the map, and how far the surface has gone, must not matter.
    void anyGridSeesTheSameBitsAfterWholePeriods()
    {
        const int nx = 400, ny = 128;
        const double dx = 0.25e-6;
        const PeriodicSpline s(nx, ny, dx, dx, noise(nx, ny));
        CellGrid cells;
        for (int i = 0; i <= 150; ++i) cells.x.push_back(1.3e-6 * i + 2e-10 * i * i);
        for (int j = 0; j <= 40; ++j) cells.y.push_back(0.7e-6 * j);
        std::vector<double> first(cells.cells(), 0.0);
        addMeans(s, cells, 0.0, 0.0, first);
        for (const double pitch : {0.33e-6, 0.1e-6, 1e-6 / 3.0}) {
            const UniformGrid grid{300, 40, pitch, 0.41e-6, -7e-6, 3e-6};
            const auto still = valuesOf(s, grid);
            for (const double turns : {1.0, -17.0, 1e3, 1e6, 9e7}) {
                QVERIFY2(valuesOf(s, grid, turns * nx * dx, -turns * ny * dx) == still,
                         qPrintable(QString::number(turns)));
                std::vector<double> later(cells.cells(), 0.0);
                addMeans(s, cells, turns * nx * dx, -turns * ny * dx, later);
                QVERIFY2(later == first, qPrintable(QString::number(turns)));
            }
        }
    }

    void aPeriodSummedUpReturnsToTheStart()
    {
        // As a run adds up time: 4000 steps of 0.1 cell.
        const PeriodicSpline s(400, 3, 0.25e-6, 0.25e-6, noise(400, 3));
        double shift = 0.0;
        for (int k = 0; k < 4000; ++k) shift += 0.025e-6;
        QVERIFY(valuesOf(s, pointsOf(s)) == valuesOf(s, pointsOf(s), shift, 0.0));
    }

    void theMeanIsThatOfTheSplineItself_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("shift");
        for (const double width : {0.05, 0.8, 1.0, 3.7, 31.0})
            for (const double shift : {0.0, 13.3, -1e4}) {
                const QString name = QString("%1 cells wide, shifted by %2").arg(width).arg(shift);
                QTest::newRow(qPrintable(name)) << width << shift;
            }
    }
    void theMeanIsThatOfTheSplineItself()
    {
        QFETCH(double, width);
        QFETCH(double, shift);
        const PeriodicSpline s(20, 14, 1.0, 1.0, noise(20, 14));
        const CellGrid grid{{-3.3, -3.3 + width, -3.3 + 2 * width}, {0.6, 0.6 + 0.7 * width, 0.6 + 1.7 * width}};
        std::vector<double> means(grid.cells(), 0.0);
        addMeans(s, grid, shift, 0.5 * shift, means);
        // Gauss's rule of three points is exact for the cubic pieces; cells are divided at all points.
        const auto pieces = [](double from, double to) {
            std::vector<std::pair<double, double>> nodes; // place, weight
            for (double a = from; a < to;) {
                const double b = std::min(to, std::floor(a) + 1.0);
                const double u0 = std::sqrt(0.6);
                for (const auto& [u, w] : {std::pair(-u0, 5.0 / 18), {0.0, 8.0 / 18}, {u0, 5.0 / 18}})
                    nodes.emplace_back(0.5 * (a + b) + 0.5 * (b - a) * u, w * (b - a));
                a = b;
            }
            return nodes;
        };
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
                double sum = 0.0;
                for (const auto& [x, wx] : pieces(grid.x[k] - shift, grid.x[k + 1] - shift))
                    for (const auto& [y, wy] : pieces(grid.y[l] - 0.5 * shift, grid.y[l + 1] - 0.5 * shift))
                        sum += wx * wy * s.value(x, y);
                const double mean = sum / (grid.widthX(i) * grid.widthY(j));
                // Running sums up to 10, rounded at 1e-15, over the cell's area; positions at 1e-9 of a cell.
                const double allowed = 2e-8 + 1e-14 / (width * width);
                QVERIFY2(std::abs(means[l * 2 + k] - mean) < allowed,
                         qPrintable(QString::number(means[l * 2 + k] - mean)));
            }
    }

    void whatIsShorterThanACellIsAveragedOut()
    {
        // A wave of 4 points seen by cells of 4 and of 6: nothing, and sin(u)/u with u = pi 6/4, times what the spline
        // keeps of the wave's mean: the fourth power of sinc(pi/4) over its own (2 + cos theta)/3.
        const PeriodicSpline s = cosine(4);
        CellGrid four{{}, {0.0, 1.0}}, six{{-3.0, 3.0}, {0.0, 1.0}};
        for (int i = 0; i <= 10; ++i) four.x.push_back(0.37 + 4.0 * i);
        std::vector<double> means(10, 0.0), mean(1, 0.0);
        addMeans(s, four, 0.0, 0.0, means);
        addMeans(s, six, 0.0, 0.0, mean);
        for (const double m : means) QVERIFY(std::abs(m) < 1e-9);
        // Points of the spline are not a pure wave: its value is the sum of cos over images 1 +- 4 k of the wave
        // number. All have the same integral over six cells but for their B-spline factor and 1/u.
        double expected = 0.0;
        for (int k = -200; k <= 200; ++k) {
            const double q = 2.0 * pi * (0.25 + k);
            expected += std::pow(std::sin(q / 2) / (q / 2), 4) * 1.5 * std::sin(3.0 * q) / (3.0 * q);
        }
        QVERIFY2(std::abs(mean[0] - expected) < 1e-9, qPrintable(QString::number(mean[0] - expected)));
    }

    void theMeansOfCellsAddUp()
    {
        const PeriodicSpline s(37, 11, 1.0, 1.0, noise(37, 11));
        CellGrid grid{{0.0}, {0.0}};
        for (int i = 1; i <= 300; ++i) grid.x.push_back(37.0 * i / 300);
        for (int j = 1; j <= 50; ++j) grid.y.push_back(11.0 * j / 50);
        std::vector<double> means(grid.cells(), 0.0);
        addMeans(s, grid, 5.4, 2.1, means);
        double sum = 0.0;
        for (const double m : means) sum += m;
        QVERIFY(std::abs(sum / static_cast<double>(means.size())) < 1e-10); // the mean of the values, 0
    }

    void theBoundsHold()
    {
        const PeriodicSpline s(16, 16, 1.0, 1.0, noise(16, 16));
        const UniformGrid fine{160, 160, 0.1, 0.1, 0.0, 0.0};
        const auto values = valuesOf(s, fine);
        const auto [lowest, highest] = std::ranges::minmax_element(values);
        QVERIFY(*highest <= s.upperBound() && *lowest >= s.lowerBound());
        // White noise is the worst: its coefficients are up to 9 times as large.
        QVERIFY(s.upperBound() < 9.0 * *highest);
    }

    void readingAllocatesNothing()
    {
        const PeriodicSpline s(64, 64, 1.0, 1.0, noise(64, 64));
        const UniformGrid grid = pointsOf(s, 3);
        CellGrid cells;
        for (int i = 0; i <= 300; ++i) cells.x.push_back(0.4 * i);
        cells.y = {0.0, 1.0, 5.0};
        std::vector<double> values(grid.cells(), 0.0), means(cells.cells(), 0.0);
        std::vector<double> work, again = means;
        s.addMeans(cells, 0.0, 0.0, means, work);
        std::ranges::fill(means, 0.0);
        const long long before = test::allocations;
        s.addValues(grid, 1.7, 0.3, values);
        s.addMeans(cells, 1.7, 0.3, means, work);
        QCOMPARE(test::allocations.load(), before);
        addMeans(s, cells, 1.7, 0.3, again);
        QVERIFY(means == again);
    }
};

TOUCHDOWN_TEST(TestPeriodicSpline)

} // namespace test_periodic_spline

#include "test_periodic_spline.moc"
