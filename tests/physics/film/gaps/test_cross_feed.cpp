// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gaps/film_gaps.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <QTest>

#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cross_feed {

constexpr double side = 0.3e-3; // [m]

/// A triangle whose leading edge lies at 45 degrees to the motion, with a wall of 20 um down to the base.
AirBearingSurface slantedWall()
{
    AirBearingSurface surface;
    surface.baseRecess = 1.5e-6;
    surface.walls.push_back({.distance = {0.0, 3e-6, 20e-6}, .recess = {0.1e-6, 0.4e-6, 1.5e-6}});
    surface.rails.push_back(
        {.points = {{0.08e-3, 0.05e-3, 0}, {0.28e-3, 0.05e-3, 0}, {0.28e-3, 0.25e-3, 1}}, .recess = {0.1e-6}});
    return surface;
}

double load(int nx, int ny)
{
    FilmProblem problem(slantedWall(), side, side, uniformGrid(side, side, nx, ny), {.air = {}, .slip = {}, .disk = {}},
                        {20e-9, 100e-6, 0.0});
    return problem.solve().converged ? problem.load() : 0.0;
}

/// A rail whose slanted edge, with a wall of 1 um, runs across the slider's side 0 (leading), 1 (trailing), 2 or 3
/// (inner, outer) [deg], [m].
AirBearingSurface railAtSide(int which, double angle, double recess, double base)
{
    AirBearingSurface surface;
    surface.baseRecess = base;
    surface.walls.push_back({.distance = {-0.1e-6, 0.9e-6}, .recess = {std::min(recess, 0.05e-6), base}});
    const double c = std::cos(angle * M_PI / 180.0), s = std::sin(angle * M_PI / 180.0);
    Rail rail{.points = {}, .recess = {recess}};
    for (const auto& [along, aside] : {std::pair{-1.0, 0.0}, {0.7, 0.0}, {0.7, 0.3}, {-1.0, 0.3}}) {
        double x = side * (along * c - aside * s), y = side * (0.4 + along * s + aside * c);
        if (which % 2 == 1) x = side - x;
        if (which >= 2) std::swap(x, y);
        rail.points.push_back({x, y, 1});
    }
    surface.rails.push_back(rail);
    return surface;
}

class TestCrossFeed : public QObject {
    Q_OBJECT

private slots:
    /// Across a steep edge pieces have their even part or none. In each other cell the parts of the halves that are cut
    /// add up to those halves, or to less where one would be more than four times its even share.
    void partsAddUpToTheCell()
    {
        const FilmGaps gaps(Recess(slantedWall(), side, side), uniformGrid(side, side, 37, 41));
        for (const std::size_t axis : {0u, 1u}) {
            std::vector<double> feed(gaps.pad.size(), 0.0), area(gaps.pad.size(), 0.0);
            std::vector<bool> full(gaps.pad.size(), false);
            const std::size_t step = gaps.pad.step(static_cast<int>(axis));
            for (const CutPlace& place : gaps.faces[axis].cut)
                for (std::uint32_t r = place.rows; r < place.rowEnd; ++r)
                    for (std::uint32_t k = gaps.rows[r].pieces; k < gaps.rows[r].pieceEnd; ++k) {
                        const GapPiece& piece = gaps.pieces[k];
                        if (gaps.rows[r].feed == Feed::None) {
                            QVERIFY(piece.feed == 0.0 && piece.lead == 0.0);
                            continue;
                        }
                        if (gaps.rows[r].feed == Feed::ByCentre) {
                            QVERIFY(piece.feed == 0.0 || piece.feed == piece.extent);
                            continue;
                        }
                        const std::size_t cell = piece.start < 0.0 ? place.at - step : place.at;
                        feed[cell] += gaps.rows[r].width * piece.feed;
                        area[cell] += gaps.rows[r].width * piece.extent;
                        full[cell] = full[cell] || piece.feed > (4.0 - 1e-9) * piece.extent;
                        QVERIFY(piece.feed > 0.0 && piece.feed < (4.0 + 1e-9) * piece.extent);
                    }
            int whole = 0;
            const double cell = side * side / (37 * 41);
            for (std::size_t at = 0; at < feed.size(); ++at) {
                if (area[at] == 0.0) continue;
                QVERIFY(feed[at] < (1.0 + 1e-9) * area[at]);
                if (full[at]) continue;
                ++whole;
                QVERIFY(std::abs(feed[at] - area[at]) < 1e-12 * cell);
            }
            QVERIFY2(whole > 60, qPrintable(QString::number(whole)));
        }
    }

    /// A step at 41 um, a rail 0.1 um behind a base of 0.3 um. The cell from 40 to 50 um has its centre at 45 um: its
    /// lower half has 1 um of base and 4 of rail, its upper half is smooth. With lifts of 20 nm the conduction is
    /// 0.32^2 = 0.1024 against 0.12^2 = 0.0144, its mean in the lower half (1*0.1024 + 4*0.0144)/5 = 0.032: the base
    /// has 3.2 times its even share, the rail less than half of it.
    void deepSideTakesTheFlow()
    {
        AirBearingSurface surface;
        surface.baseRecess = 0.3e-6;
        surface.rails.push_back(
            {.points = {{41e-6, -1e-6, 0}, {200e-6, -1e-6, 0}, {200e-6, 11e-6, 0}, {41e-6, 11e-6, 0}},
             .recess = {0.1e-6}});
        const FilmGaps gaps(Recess(surface, 100e-6, 10e-6), uniformGrid(100e-6, 10e-6, 10, 1));
        const CutPlace& place = gaps.faces[0].cut.front();
        QCOMPARE(place.at, gaps.pad.at(4, 0));
        const GapRow& row = gaps.rows[place.rows];
        QCOMPARE(row.pieceEnd - row.pieces, 3u);
        // Base in the cell before, where all is base; base and rail in this one.
        const GapPiece *before = &gaps.pieces[row.pieces], *base = before + 1, *rail = before + 2;
        const auto close = [](double a, double b) { return std::abs(a - b) < 1e-12; };
        QVERIFY(close(before->feed, 5e-6) && close(before->lead, -5e-6));
        QVERIFY(close(base->feed, 3.2e-6) && base->lead == 0.0);
        QVERIFY(close(rail->feed, 4e-6 * 0.0144 / 0.032) && close(rail->lead, base->feed));
    }

    /// The corrections at a cell's two faces take a part of what leaves it across, never all of it. Where a smooth half
    /// of a cell counted with its gap, but had its even part, they took up to 1.2 times as much, and Newton's method
    /// did not converge on some sliders.
    void cellsKeepWhatCrossesThem()
    {
        double least = 1.0;
        for (const int which : {0, 1, 2, 3})
            for (const double angle : {20.0, 45.0, 70.0})
                for (const auto& [recess, base] : {std::pair{0.0, 0.1e-6}, {0.05e-6, 0.25e-6}, {0.18e-6, 1.65e-6}}) {
                    constexpr int n = 54;
                    const bool alongX = which < 2;
                    FilmProblem problem(railAtSide(which, angle, recess, base), side, side,
                                        uniformGrid(side, side, alongX ? n : 4 * n, alongX ? 4 * n : n),
                                        {.air = {}, .slip = {}, .disk = uniformMotion(15.0, 0.1)}, {9e-9, 45e-6, 0.0});
                    std::vector<double> residual(problem.p.size());
                    problem.film.linearise(problem.p, residual);
                    const PaddedGrid& pad = problem.gaps.pad;
                    for (const int axis : {0, 1})
                        for (int j = 0; j < pad.ny; ++j)
                            for (int i = 0; i < pad.nx; ++i) {
                                const FilmFaces& f = problem.film.faces()[static_cast<std::size_t>(axis)];
                                const std::size_t at = pad.at(i, j);
                                const CellGrid& grid = problem.gaps.grid;
                                const double width = axis == 0 ? grid.widthX(i) : grid.widthY(j);
                                least = std::min(least, 1.0 - (f.above[at] - f.below[at + pad.step(axis)]) / width);
                            }
                }
        QVERIFY2(least > 0.05, qPrintable(QString::number(least)));
    }

    /// Of a slanted wall no direction is more in need of cells than another: twice as many along x or along y change
    /// the load by less than 0.5 %. Evenly spread, the flow across makes that 1.0 % up and 1.1 % down.
    void slantedWallIsIsotropic()
    {
        const double square = load(96, 96), alongX = load(192, 96), alongY = load(96, 192);
        QVERIFY(square > 0.0);
        QVERIFY2(std::abs(alongX / square - 1.0) < 5e-3, qPrintable(QString::number(alongX / square - 1.0)));
        QVERIFY2(std::abs(alongY / square - 1.0) < 5e-3, qPrintable(QString::number(alongY / square - 1.0)));
    }
};

TOUCHDOWN_TEST(TestCrossFeed)

} // namespace test_cross_feed

#include "test_cross_feed.moc"
