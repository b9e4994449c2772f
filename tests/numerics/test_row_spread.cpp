// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include <QTest>

#include "core/numerics/row_spread.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_row_spread {

constexpr int nx = 20, ny = 4;
constexpr PaddedGrid grid{nx, ny};

/// Cells whose widths differ by up to `unevenness` of their mean, 1 [m].
std::vector<double> lines(double unevenness)
{
    std::vector<double> x;
    for (int i = 0; i <= nx; ++i) x.push_back(i + unevenness * std::sin(2.1 * i));
    return x;
}

/// Two in row 1, none in rows 0 and 2, one in row 3, and some that are no faces within a row.
std::vector<std::size_t> closed()
{
    return {grid.at(12, 1), grid.at(5, 1), grid.at(7, 3), grid.at(0, 2), grid.at(nx, 2), grid.at(4, ny)};
}

std::vector<double> randomRow(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double> row(nx);
    for (double& value : row) value = uniform(random);
    return row;
}

double sum(const std::vector<double>& row, int first, int end)
{
    double result = 0.0;
    for (int i = first; i < end; ++i) result += row[static_cast<std::size_t>(i)];
    return result;
}

class TestRowSpread : public QObject {
    Q_OBJECT

private slots:
    void nothingIsLostBetweenClosedFaces();
    void evenSourcesStay();
    void wavesGrowByTheirSymbol();
    void transposedMap();
    void complexSources();
    void emptyCellsGiveNothing();
    void likeContentsChangeNothing();
};

/// The sum between two closed faces stays, and no other sum does.
void TestRowSpread::nothingIsLostBetweenClosedFaces()
{
    const RowSpread spread(grid, lines(0.2), closed());
    std::vector<double> passed(nx + 1);
    for (int j = 0; j < ny; ++j) {
        const std::vector<double> before = randomRow(3);
        std::vector<double> after = before;
        spread.spread(j, after.data(), passed.data());
        QVERIFY(std::abs(sum(after, 0, nx) - sum(before, 0, nx)) < 1e-14);
        for (int face = 1; face < nx; ++face) {
            const bool isClosed = (j == 1 && (face == 5 || face == 12)) || (j == 3 && face == 7);
            const double change = std::abs(sum(after, 0, face) - sum(before, 0, face));
            QVERIFY(isClosed ? change < 1e-14 : change > 1e-6);
        }
    }
}

/// A source that is the same per length stays as it is; one that grows evenly does so within even cells, and at the
/// ends 1/12 of its rise passes, with nothing beyond.
void TestRowSpread::evenSourcesStay()
{
    std::vector<double> source, passed(nx + 1);
    const std::vector<double> x = lines(0.2);
    for (std::size_t k = 0; k < nx; ++k) source.push_back(x[k + 1] - x[k]);
    RowSpread(grid, x, closed()).spread(1, source.data(), passed.data());
    for (std::size_t k = 0; k < nx; ++k) QVERIFY(std::abs(source[k] - (x[k + 1] - x[k])) < 1e-14);

    for (std::size_t k = 0; k < nx; ++k) source[k] = static_cast<double>(k);
    RowSpread(grid, lines(0.0), {}).spread(1, source.data(), passed.data());
    for (std::size_t k = 1; k + 1 < nx; ++k) QVERIFY(std::abs(source[k] - static_cast<double>(k)) < 1e-13);
    QVERIFY(std::abs(source[0] + 1.0 / 12.0) < 1e-14);
}

/// The factor 1 + (2 - 2 cos k)/12 on even cells, here 3 m wide each.
void TestRowSpread::wavesGrowByTheirSymbol()
{
    std::vector<double> x = lines(0.0), passed(nx + 1), source(nx);
    for (double& line : x) line *= 3.0;
    constexpr double k = 1.3;
    for (std::size_t i = 0; i < nx; ++i) source[i] = std::cos(k * static_cast<double>(i));
    RowSpread(grid, x, {}).spread(0, source.data(), passed.data());
    const double factor = 1.0 + (2.0 - 2.0 * std::cos(k)) / 12.0;
    for (std::size_t i = 1; i + 1 < nx; ++i)
        QVERIFY(std::abs(source[i] - factor * std::cos(k * static_cast<double>(i))) < 1e-14);
}

/// u (M v) = v (M^T u).
void TestRowSpread::transposedMap()
{
    const RowSpread spread(grid, lines(0.2), closed());
    const std::vector<double> u = randomRow(5), v = randomRow(6);
    std::vector<double> passed(nx + 1);
    for (int j = 0; j < ny; ++j) {
        std::vector<double> Mv = v, MTu = u;
        spread.spread(j, Mv.data(), passed.data());
        spread.spreadTransposed(j, MTu.data(), passed.data());
        double difference = 0.0;
        for (std::size_t k = 0; k < nx; ++k) difference += u[k] * Mv[k] - v[k] * MTu[k];
        QVERIFY(std::abs(difference) < 1e-14);
    }
}

void TestRowSpread::complexSources()
{
    using Complex = std::complex<double>;
    const RowSpread spread(grid, lines(0.2), closed());
    std::vector<double> u = randomRow(7), v = randomRow(8), passed(nx + 1);
    std::vector<Complex> both, work(nx + 1);
    for (std::size_t k = 0; k < nx; ++k) both.push_back({u[k], v[k]});
    spread.spread(1, u.data(), passed.data());
    spread.spread(1, v.data(), passed.data());
    spread.spread(1, both.data(), work.data());
    for (std::size_t k = 0; k < nx; ++k) QVERIFY(std::abs(both[k] - Complex(u[k], v[k])) < 1e-15);
}

/// Contents of 1 per width, but of 1e-3 in cell 7 and none in cell 8, row 1: cell 7 takes up 8e-3 of the 1/12 of what
/// its neighbour loses, the empty one not at all, others as ever, and nothing is lost.
void TestRowSpread::emptyCellsGiveNothing()
{
    RowSpread spread(grid, lines(0.0), {});
    std::vector<double> volume(grid.size(), 2.0), density(grid.size(), 0.5), passed(nx + 1);
    volume[grid.at(7, 1)] = 2e-3;
    density[grid.at(8, 1)] = 0.0;
    spread.weigh(volume, density);
    std::vector<double> source(nx, 0.0);
    source[6] = source[9] = -1.0;
    spread.spread(1, source.data(), passed.data());
    QVERIFY(std::abs(source[5] - 1.0 / 12.0) < 1e-14);
    QVERIFY(std::abs(source[7] - 8.0 * 1e-3 / (1.001 * 1.001) / 12.0) < 1e-14);
    QCOMPARE(source[8], 0.0);
    QVERIFY(std::abs(source[10] - 1.0 / 12.0) < 1e-14);
    QVERIFY(std::abs(sum(source, 0, nx) + 2.0) < 1e-14);
    // The row beside it, and the transposed map: u (M v) = v (M^T u).
    std::vector<double> beside(nx, 0.0);
    beside[6] = -1.0;
    spread.spread(2, beside.data(), passed.data());
    QVERIFY(std::abs(beside[7] - 1.0 / 12.0) < 1e-14);
    const std::vector<double> u = randomRow(5), v = randomRow(6);
    std::vector<double> Mv = v, MTu = u;
    spread.spread(1, Mv.data(), passed.data());
    spread.spreadTransposed(1, MTu.data(), passed.data());
    double difference = 0.0;
    for (std::size_t k = 0; k < nx; ++k) difference += u[k] * Mv[k] - v[k] * MTu[k];
    QVERIFY(std::abs(difference) < 1e-14);
}

/// Contents per width that differ by less than a factor of 1/0.18 from cell to cell, in cells of any width, and closed
/// faces: the map of before.
void TestRowSpread::likeContentsChangeNothing()
{
    const std::vector<double> x = lines(0.2);
    const RowSpread even(grid, x, closed());
    RowSpread weighed(grid, x, closed());
    std::vector<double> volume(grid.size(), 0.0), density(grid.size(), 0.0), passed(nx + 1);
    for (int j = 0; j < ny; ++j)
        for (std::size_t k = 0; k < nx; ++k) {
            volume[grid.at(0, j) + k] = (x[k + 1] - x[k]) * (k % 2 == 0 ? 0.18 : 1.0);
            density[grid.at(0, j) + k] = 3.0;
        }
    weighed.weigh(volume, density);
    for (int j = 0; j < ny; ++j) {
        std::vector<double> a = randomRow(9), b = a;
        even.spread(j, a.data(), passed.data());
        weighed.spread(j, b.data(), passed.data());
        for (std::size_t k = 0; k < nx; ++k) QCOMPARE(a[k], b[k]);
    }
}

TOUCHDOWN_TEST(TestRowSpread)

} // namespace test_row_spread

#include "test_row_spread.moc"
