// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_grid.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_grid {

constexpr double L = 1.2e-3, W = 1.0e-3;

Rail box(double x0, double x1, double y0, double y1)
{
    return {.points = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .recess = {0.0}};
}

int lineAt(const std::vector<double>& lines, double position)
{
    const auto found = std::find(lines.begin(), lines.end(), position);
    return found == lines.end() ? -1 : static_cast<int>(found - lines.begin());
}

double spacingAt(const std::vector<double>& lines, double position)
{
    const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, position);
    return *above - *(above - 1);
}

class TestFilmGrid : public QObject {
    Q_OBJECT

private slots:
    void uniform()
    {
        const CellGrid grid = uniformGrid(L, W, 5, 4);
        QCOMPARE(grid.nx(), 5);
        QCOMPARE(grid.ny(), 4);
        for (int i = 0; i < 5; ++i) QVERIFY(std::abs(grid.centreX(i) - (i + 0.5) * 0.24e-3) < 1e-18);
        for (int j = 0; j < 4; ++j) QVERIFY(std::abs(grid.widthY(j) - 0.25e-3) < 1e-18);
        QCOMPARE(grid.x.back(), L);
        QCOMPARE(grid.y.back(), W);
    }

    /// Edges along the axes lie on lines of even numbers, exactly; oblique ones ask for no line. Cells crowd where
    /// edges are.
    void gradedByRails()
    {
        AirBearingSurface surface;
        surface.rails = {box(0.237e-3, 0.9e-3, 0.15e-3, 0.311e-3),
                         {.points = {{0.5e-3, 0.5e-3}, {0.61e-3, 0.7e-3}, {0.53e-3, 0.8e-3}}, .recess = {0.0}}};
        const CellGrid grid = gradedGrid(surface, L, W, 64, 48);
        QCOMPARE(grid.nx(), 64);
        QCOMPARE(grid.ny(), 48);
        for (const double x : {0.237e-3, 0.9e-3}) {
            QVERIFY(lineAt(grid.x, x) > 0);
            QCOMPARE(lineAt(grid.x, x) % 2, 0);
        }
        for (const double y : {0.15e-3, 0.311e-3}) {
            QVERIFY(lineAt(grid.y, y) > 0);
            QCOMPARE(lineAt(grid.y, y) % 2, 0);
        }
        QCOMPARE(lineAt(grid.x, 0.61e-3), -1);
        QVERIFY(spacingAt(grid.x, 0.9e-3) < 0.8 * spacingAt(grid.x, 0.75e-3));
        QVERIFY(std::is_sorted(grid.x.begin(), grid.x.end()));
        QVERIFY(std::is_sorted(grid.y.begin(), grid.y.end()));
    }
    /// A surface without rails: an even grid.
    void gradedByNothing()
    {
        const CellGrid grid = gradedGrid({}, L, W, 12, 8), even = uniformGrid(L, W, 12, 8);
        for (std::size_t i = 0; i < grid.x.size(); ++i) QVERIFY(std::abs(grid.x[i] - even.x[i]) < 1e-12 * L);
        for (std::size_t j = 0; j < grid.y.size(); ++j) QVERIFY(std::abs(grid.y[j] - even.y[j]) < 1e-12 * W);
    }

    /// A film whose pressure bends at 0.8 L alone, in a gap too wide to drag: cells crowd there, edges keep their
    /// lines, and across, where nothing bends, cells stay alike.
    void adaptedToPressure()
    {
        AirBearingSurface surface;
        surface.rails = {box(0.237e-3, 0.9e-3, 0.0, W)};
        const CellGrid coarse = uniformGrid(L, W, 60, 10);
        KnownFilm known{coarse, {}, std::vector<double>(coarse.cells(), 5e-6), 1e5, 1e-6};
        for (int j = 0; j < 10; ++j)
            for (int i = 0; i < 60; ++i)
                known.pressure.push_back(1e5 *
                                         (1.0 + 3.0 * std::exp(-std::pow((coarse.centreX(i) / L - 0.8) / 0.02, 2))));
        const CellGrid grid = adaptedGrid(surface, L, W, 60, 10, known);
        QCOMPARE(grid.nx(), 60);
        QVERIFY(spacingAt(grid.x, 0.8 * L) < 0.5 * spacingAt(grid.x, 0.4 * L));
        QVERIFY(lineAt(grid.x, 0.9e-3) > 0 && lineAt(grid.x, 0.237e-3) > 0);
    }
    /// A gap that changes at 0.3 L where it is far below the gap that is dragged.
    void adaptedToGap()
    {
        const CellGrid coarse = uniformGrid(L, W, 60, 10);
        KnownFilm known{coarse, std::vector<double>(coarse.cells(), 1e5), {}, 1e5, 1e-6};
        for (int j = 0; j < 10; ++j)
            for (int i = 0; i < 60; ++i)
                known.gap.push_back(20e-9 * (1.5 + std::tanh((coarse.centreX(i) / L - 0.3) / 0.02)));
        const CellGrid grid = adaptedGrid({}, L, W, 60, 10, known);
        QVERIFY(spacingAt(grid.x, 0.3 * L) < 0.5 * spacingAt(grid.x, 0.7 * L));
        QVERIFY(std::abs(spacingAt(grid.y, 0.1 * W) / spacingAt(grid.y, 0.6 * W) - 1.0) < 1e-9);
    }

    /// Peclet over L/100: (U h/2)(L/100)/(p0 h^3/(12 mu)) = 1 where h^2 = 6 mu U L/(100 p0).
    void draggedGapIsWherePecletIsOne()
    {
        const double mu = 1.8e-5, U = 15.0, p0 = 1e5, h = draggedGap(mu, U, L, p0);
        QVERIFY(std::abs(0.5 * U * h * (0.01 * L) / (p0 * h * h * h / (12.0 * mu)) - 1.0) < 1e-13);
    }

    /// Exact for a x + b y + c x y between the outermost centres; towards the outline it falls to the value there.
    void transferIsBilinear()
    {
        const CellGrid from = uniformGrid(1.0, 1.0, 9, 6);
        const auto f = [](double x, double y) { return 2.0 * x - y + 3.0 * x * y; };
        std::vector<double> field;
        for (int j = 0; j < 6; ++j)
            for (int i = 0; i < 9; ++i) field.push_back(f(from.centreX(i), from.centreY(j)));
        CellGrid to;
        for (int i = 0; i <= 23; ++i) to.x.push_back(std::pow(i / 23.0, 1.3));
        for (int j = 0; j <= 17; ++j) to.y.push_back(std::pow(j / 17.0, 0.8));
        const std::vector<double> result = transfer(from, field, -7.0, to);
        QCOMPARE(result.size(), to.cells());
        int inside = 0;
        for (int j = 0; j < 17; ++j)
            for (int i = 0; i < 23; ++i) {
                const double x = to.centreX(i), y = to.centreY(j);
                if (x < 0.5 / 9 || x > 8.5 / 9 || y < 0.5 / 6 || y > 5.5 / 6) continue;
                QVERIFY(std::abs(result[static_cast<std::size_t>(j * 23 + i)] - f(x, y)) < 1e-13);
                ++inside;
            }
        QVERIFY(inside > 200);
        // Halfway from the outline to the first centre, in the middle between two rows of centres.
        const CellGrid strip{{0.0, 1.0 / 18}, {1.0 / 12, 3.0 / 12}};
        const double centre = 0.5 * (f(0.5 / 9, 0.5 / 6) + f(0.5 / 9, 1.5 / 6));
        QVERIFY(std::abs(transfer(from, field, -7.0, strip)[0] - 0.5 * (centre - 7.0)) < 1e-13);
    }
    void transferToItself()
    {
        const CellGrid grid = gradedGrid({}, L, W, 7, 5);
        std::vector<double> field;
        for (std::size_t k = 0; k < grid.cells(); ++k) field.push_back(std::sin(static_cast<double>(k)));
        const std::vector<double> result = transfer(grid, field, 0.0, grid);
        for (std::size_t k = 0; k < field.size(); ++k) QVERIFY(std::abs(result[k] - field[k]) < 1e-14);
    }
};

TOUCHDOWN_TEST(TestFilmGrid)

} // namespace test_film_grid

#include "test_film_grid.moc"
