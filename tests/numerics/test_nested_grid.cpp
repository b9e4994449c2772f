// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/nested_grid.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_nested_grid {

const CellGrid uneven{{0.0, 1.0, 1.5, 3.0, 4.0, 6.0, 6.5, 8.0}, {0.0, 0.5, 2.0, 3.0, 3.25, 5.0, 6.0, 7.0, 7.5}};

PaddedGrid padOf(const CellGrid& grid) { return {grid.nx(), grid.ny()}; }

/// f(x, y) at the cell centres, zero in the rings.
template <typename Function>
std::vector<double> sampled(const CellGrid& grid, Function&& f)
{
    const PaddedGrid pad = padOf(grid);
    std::vector<double> field(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) field[pad.at(i, j)] = f(grid.centreX(i), grid.centreY(j));
    return field;
}

double integral(const CellGrid& grid, const std::vector<double>& field)
{
    double sum = 0.0;
    for (int j = 0; j < grid.ny(); ++j)
        for (int i = 0; i < grid.nx(); ++i) sum += field[padOf(grid).at(i, j)] * grid.widthX(i) * grid.widthY(j);
    return sum;
}

double total(const std::vector<double>& field)
{
    double sum = 0.0;
    for (const double value : field) sum += value;
    return sum;
}

double wavy(double x, double y) { return std::sin(3.0 * x) + x * y * y; }

class TestNestedGrid : public QObject {
    Q_OBJECT

private slots:
    /// Seven cells along x make four, the last alone; eight along y make four.
    void lines()
    {
        const CellGrid coarse = everySecondLine(uneven);
        QCOMPARE(coarse.x, (std::vector<double>{0.0, 1.5, 4.0, 6.5, 8.0}));
        QCOMPARE(coarse.y, (std::vector<double>{0.0, 2.0, 3.25, 6.0, 7.5}));
    }

    void sumsKeepTheTotal()
    {
        const std::vector<double> fine = sampled(uneven, wavy);
        std::vector<double> coarse(padOf(everySecondLine(uneven)).size(), 7.0);
        GridTransfer(uneven).sum(fine, coarse);
        QVERIFY(std::abs(total(coarse) - total(fine)) <= 1e-12 * std::abs(total(fine)));
        const PaddedGrid pad = padOf(uneven);
        QCOMPARE(coarse[padOf(everySecondLine(uneven)).at(1, 0)],
                 fine[pad.at(2, 0)] + fine[pad.at(3, 0)] + fine[pad.at(2, 1)] + fine[pad.at(3, 1)]);
    }

    /// And leave the rings alone, where a pressure has its outline.
    void meansKeepTheIntegral()
    {
        const CellGrid coarseGrid = everySecondLine(uneven);
        const std::vector<double> fine = sampled(uneven, wavy);
        std::vector<double> coarse(padOf(coarseGrid).size(), 7.0);
        GridTransfer(uneven).mean(fine, coarse);
        const double expected = integral(uneven, fine);
        QVERIFY(std::abs(integral(coarseGrid, coarse) - expected) <= 1e-12 * std::abs(expected));
        QCOMPARE(coarse[padOf(coarseGrid).at(-1, 2)], 7.0);
    }

    /// Away from the outline a plane stays the same plane.
    void interpolatesPlanes()
    {
        const auto plane = [](double x, double y) { return 2.0 + 0.5 * x - 0.25 * y; };
        const std::vector<double> coarse = sampled(everySecondLine(uneven), plane), expected = sampled(uneven, plane);
        std::vector<double> fine(padOf(uneven).size(), 0.0);
        GridTransfer(uneven).interpolate(coarse, fine);
        for (int j = 1; j < uneven.ny() - 1; ++j)
            for (int i = 1; i < uneven.nx() - 1; ++i) {
                const std::size_t at = padOf(uneven).at(i, j);
                QVERIFY2(std::abs(fine[at] - expected[at]) < 1e-14, qPrintable(QString("%1, %2").arg(i).arg(j)));
            }
    }

    /// Of 1 everywhere: beside the outline the centre of the first cell, x = 0.5, lies at 0.5/0.75 of the way from the
    /// outline to that of the coarse one, 0.75; and y = 0.25 at 0.25 of the way to 1. The last cell along x is a coarse
    /// cell itself.
    void fallsToZeroOnTheOutline()
    {
        const std::vector<double> coarse = sampled(everySecondLine(uneven), [](double, double) { return 1.0; });
        std::vector<double> fine(padOf(uneven).size(), 0.0);
        GridTransfer(uneven).interpolate(coarse, fine);
        const PaddedGrid pad = padOf(uneven);
        QCOMPARE(fine[pad.at(0, 3)], 0.5 / 0.75);
        QCOMPARE(fine[pad.at(3, 0)], 0.25);
        QCOMPARE(fine[pad.at(0, 0)], 0.5 / 0.75 * 0.25);
        QCOMPARE(fine[pad.at(6, 3)], 1.0);
    }
};

TOUCHDOWN_TEST(TestNestedGrid)

} // namespace test_nested_grid

#include "test_nested_grid.moc"
