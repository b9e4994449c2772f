// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gaps/film_gaps.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/physics/slider/recess.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_gaps {

constexpr double L = 1.0e-3, W = 0.8e-3;

CellGrid grid(int nx, int ny)
{
    // Lines of a mild sine: no two cells are alike.
    CellGrid result;
    for (int i = 0; i <= nx; ++i) result.x.push_back(L * (i + 0.3 * std::sin(1.7 * i) * (i > 0 && i < nx)) / nx);
    for (int j = 0; j <= ny; ++j) result.y.push_back(W * (j + 0.3 * std::sin(2.3 * j) * (j > 0 && j < ny)) / ny);
    return result;
}

Rail box(double x0, double x1, double y0, double y1, double recess, int wall = 0)
{
    return {.points = {{x0, y0, wall}, {x1, y0, wall}, {x1, y1, wall}, {x0, y1, wall}}, .recess = {recess}};
}

double volume(const FilmGaps& gaps)
{
    double sum = 0.0;
    for (int j = 0; j < gaps.pad.ny; ++j)
        for (int i = 0; i < gaps.pad.nx; ++i)
            sum += gaps.meanRecess[gaps.pad.at(i, j)] * gaps.grid.widthX(i) * gaps.grid.widthY(j);
    return sum;
}

const CutPlace* cutAt(const FilmGaps& gaps, std::size_t axis, int i, int j)
{
    for (const CutPlace& place : gaps.faces[axis].cut)
        if (place.at == gaps.pad.at(i, j)) return &place;
    return nullptr;
}

class TestFilmGaps : public QObject {
    Q_OBJECT

private slots:
    /// For the recess at the centres of 7 rows of cells and one beside them on either side, for 7 rows of faces across
    /// x and 8 across y.
    void isAskedAtEachRow()
    {
        AirBearingSurface surface;
        surface.baseRecess = 1e-6;
        surface.rails = {box(0.2e-3, 0.7e-3, 0.1e-3, 0.6e-3, 0.0)};
        const Recess recess(surface, L, W);
        int calls = 0;
        const FilmGaps gaps(recess, grid(9, 7), [&] { return ++calls > 0; });
        QCOMPARE(calls, 9 + 7 + 8);
        QVERIFY(gaps.rows.size() == FilmGaps(recess, grid(9, 7)).rows.size());
        // Once it was told to stop each of the three asks once more.
        for (int last = 1; last <= 24; ++last) {
            int asked = 0;
            const FilmGaps stopped(recess, grid(9, 7), [&] { return ++asked < last; });
            QVERIFY(asked >= last && asked <= last + 2);
        }
    }
    /// Cells 1, 3 and 4 wide: centres at 0.5, 2.5, 6; the outermost paths end at the outline.
    void paths()
    {
        AirBearingSurface plane;
        plane.baseRecess = 0.0;
        const FilmGaps gaps(Recess(plane, 8.0, 2.0), {{0.0, 1.0, 4.0, 8.0}, {0.0, 2.0}});
        const FilmGaps::Faces& f = gaps.faces[0];
        QCOMPARE(f.pathMid, (std::vector<double>{0.25, 1.5, 4.25, 7.0}));
        QCOMPARE(f.pathLength, (std::vector<double>{0.5, 2.0, 3.5, 2.0}));
        QCOMPARE(f.upperShare, (std::vector<double>{0.0, 0.25, 1.5 / 3.5, 1.0}));
        QCOMPARE(gaps.faces[1].pathMid, (std::vector<double>{0.5, 1.5}));
        QCOMPARE(gaps.length, 8.0);
        QCOMPARE(gaps.width, 2.0);
    }

    /// h = height + pitch (L - x) - roll (y - W/2)
    void lift()
    {
        AirBearingSurface plane;
        const FilmGaps gaps(Recess(plane, L, W), uniform(2, 2));
        QVERIFY(std::abs(gaps.lift({10e-9, 100e-6, 5e-6}, 0.2e-3, 0.7e-3) - (10e-9 + 80e-9 - 1.5e-9)) < 1e-22);
    }

    /// Crown alone: no face is cut, the recess is that of the middle of each path and cell.
    void smoothSurface()
    {
        AirBearingSurface surface;
        surface.baseRecess = 0.0;
        surface.crown = 20e-9;
        const FilmGaps gaps(Recess(surface, L, W), grid(7, 5));
        QVERIFY(gaps.faces[0].cut.empty() && gaps.faces[1].cut.empty() && gaps.cutCells.empty());
        const auto crown = [](double x) { return -4.0 * 20e-9 * x / L * (1.0 - x / L); };
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 7; ++i) {
                const std::size_t at = gaps.pad.at(i, j);
                QVERIFY(std::abs(gaps.faces[0].recess[at] - crown(gaps.faces[0].pathMid[std::size_t(i)])) < 1e-22);
                QVERIFY(std::abs(gaps.faces[1].recess[at] - crown(gaps.grid.centreX(i))) < 1e-22);
                QVERIFY(std::abs(gaps.meanRecess[at] - crown(gaps.grid.centreX(i))) < 1e-22);
            }
    }

    /// Steps from edge to edge, wherever they fall among the cells: the volume is exact.
    void volumeOfSteps_data()
    {
        QTest::addColumn<bool>("alongX");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        for (const bool alongX : {true, false}) {
            const char* axis = alongX ? "x" : "y";
            QTest::addRow("rail of a third, %s", axis) << alongX << 0.3 << 0.63;
            QTest::addRow("a groove inside one cell, %s", axis) << alongX << 0.511 << 0.512;
            QTest::addRow("edges just beside lines, %s", axis) << alongX << 0.25 + 1e-9 << 0.75 - 1e-9;
            QTest::addRow("edges on lines of the even grid, %s", axis) << alongX << 0.25 << 0.75;
        }
    }
    void volumeOfSteps()
    {
        QFETCH(bool, alongX);
        QFETCH(double, from);
        QFETCH(double, to);
        AirBearingSurface surface;
        surface.baseRecess = 1.5e-6;
        surface.rails = {alongX ? box(from * L, to * L, 0.0, W, 10e-9) : box(0.0, L, from * W, to * W, 10e-9)};
        const double exact = L * W * ((to - from) * 10e-9 + (1.0 - to + from) * 1.5e-6);
        for (const CellGrid& cells : {grid(9, 7), uniform(8, 8), uniform(16, 12)})
            QVERIFY(std::abs(volume(FilmGaps(Recess(surface, L, W), cells)) / exact - 1.0) < 1e-12);
    }

    /// Rails with corners inside cells, edges through the very centres of cells among them (the sixth, of 1/24 L): each
    /// half of a cell belongs to the path on its side, divided where the edges are; at corners by four rows.
    void volumeOfCorners()
    {
        AirBearingSurface surface;
        surface.baseRecess = 1e-6;
        for (int k = 0; k < 40; ++k) {
            const double s = 0.02 * k / 40;
            surface.rails = {
                box((0.31 + s) * L, (0.72 + 0.7 * s) * L, (0.22 + 0.3 * s) * W, (0.66 + 1.1 * s) * W, 0.0)};
            const double exact = L * W * 1e-6 * (1.0 - (0.41 - 0.3 * s) * (0.44 + 0.8 * s));
            const double error =
                (volume(FilmGaps(Recess(surface, L, W), uniform(24, 24))) - exact) / (L * W * 1e-6 / 576);
            QVERIFY2(std::abs(error) < 0.03, qPrintable(QString("%1: %2 cells").arg(k).arg(error)));
        }
    }
    /// Oblique edges: to an eighth of one of 576 cells, the edges cross some 70.
    void volumeOfObliqueEdges()
    {
        AirBearingSurface surface;
        surface.baseRecess = 1e-6;
        const double cell = L * W / 576;
        for (int k = 0; k < 40; ++k) {
            const double s = 0.02 * k / 40;
            surface.rails = {{.points = {{(0.2 + s) * L, 0.1 * W},
                                         {0.7 * L, (0.2 + s) * W},
                                         {(0.8 - s) * L, 0.9 * W},
                                         {0.3 * L, 0.7 * W}},
                              .recess = {0.0}}};
            double area = 0.0;
            const auto& p = surface.rails[0].points;
            for (std::size_t m = 0; m < 4; ++m) area += 0.5 * (p[m].x * p[(m + 1) % 4].y - p[(m + 1) % 4].x * p[m].y);
            const double error = volume(FilmGaps(Recess(surface, L, W), uniform(24, 24))) - 1e-6 * (L * W - area);
            QVERIFY2(std::abs(error) < 0.125 * 1e-6 * cell, qPrintable(QString::number(error / 1e-6 / cell)));
        }
    }

    /// A step anywhere along a path: its pieces add up, break exactly at the step and at the face, and pass what the
    /// two gaps in series do: K = width/(sum of lengths/h^3).
    void stepAnywhereOnAPath_data()
    {
        QTest::addColumn<double>("position");
        for (int k = 1; k < 20; ++k) QTest::addRow("%d twentieths", k) << k / 20.0;
        QTest::newRow("just after the start") << 1e-6;
        QTest::newRow("just before the end") << 1.0 - 1e-6;
    }
    void stepAnywhereOnAPath()
    {
        QFETCH(double, position);
        for (const std::size_t axis : {0u, 1u}) {
            const CellGrid cells = grid(6, 6);
            const std::vector<double>& lines = axis == 0 ? cells.x : cells.y;
            const double start = 0.5 * (lines[2] + lines[3]), end = 0.5 * (lines[3] + lines[4]), face = lines[3];
            const double step = start + position * (end - start);
            AirBearingSurface surface;
            surface.baseRecess = 500e-9;
            surface.rails = {axis == 0 ? box(step, L, 0.0, W, 0.0) : box(0.0, L, step, W, 0.0)};
            const FilmGaps gaps(Recess(surface, L, W), cells);
            const CutPlace* place = axis == 0 ? cutAt(gaps, 0, 3, 1) : cutAt(gaps, 1, 1, 3);
            QVERIFY(place);
            const auto cube = [](double h) { return h * h * h; };
            double width = 0.0;
            for (std::uint32_t r = place->rows; r < place->rowEnd; ++r) {
                const GapRow& row = gaps.rows[r];
                width += row.width;
                double length = 0.0, resistance = 0.0;
                for (std::uint32_t k = row.pieces; k < row.pieceEnd; ++k) {
                    const GapPiece& piece = gaps.pieces[k];
                    QVERIFY(std::abs(face + piece.start - (start + length)) < 1e-12 * L);
                    QVERIFY(piece.start >= 0.0 || piece.start + piece.extent <= 1e-12 * L);
                    length += piece.extent;
                    resistance += piece.extent / cube(piece.recess + 20e-9);
                }
                QVERIFY(std::abs(length - (end - start)) < 1e-12 * L);
                const double exact = (step - start) / cube(520e-9) + (end - step) / cube(20e-9);
                QVERIFY(std::abs(resistance / exact - 1.0) < 1e-10);
            }
            QVERIFY(std::abs(width - (axis == 0 ? cells.widthY(1) : cells.widthX(1))) < 1e-12 * L);
        }
    }

    /// An edge along the paths, or slanted: the deep and the shallow width of each line of faces are exact.
    void widthsOfALineOfFaces_data()
    {
        QTest::addColumn<double>("slope");
        for (const double slope : {0.0, 0.3, -0.7, 1.5}) QTest::addRow("%g", slope) << slope;
    }
    void widthsOfALineOfFaces()
    {
        QFETCH(double, slope);
        AirBearingSurface surface;
        surface.baseRecess = 500e-9;
        const int count = 16;
        const CellGrid cells = uniform(count, count);
        for (int k = 0; k < 20; ++k) {
            // The rail lies above the edge y = middle + slope (x - L/2).
            const double middle = (0.5 + 0.05 * (k + 0.5) / count) * W, rise = 0.5 * slope * W;
            surface.rails = {{.points = {{-0.1 * L, middle - 1.2 * rise},
                                         {1.1 * L, middle + 1.2 * rise},
                                         {1.1 * L, 9 * W},
                                         {-0.1 * L, 9 * W}},
                              .recess = {7e-9}}};
            const FilmGaps gaps(Recess(surface, L, W), cells);
            for (int i = 6; i <= 10; ++i) {
                double deep = 0.0, shallow = 0.0;
                for (int j = 0; j < count; ++j) {
                    const std::size_t at = gaps.pad.at(i, j);
                    const CutPlace* place = cutAt(gaps, 0, i, j);
                    if (!place) (gaps.faces[0].recess[at] > 100e-9 ? deep : shallow) += W / count;
                    for (std::uint32_t r = place ? place->rows : 0; place && r < place->rowEnd; ++r) {
                        const GapRow& row = gaps.rows[r];
                        double lowest = 1.0;
                        for (std::uint32_t p = row.pieces; p < row.pieceEnd; ++p)
                            lowest = std::min(lowest, gaps.pieces[p].recess);
                        (lowest > 100e-9 ? deep : shallow) += row.width;
                    }
                }
                const double edge = middle + rise * 2.0 * (cells.x[std::size_t(i)] / L - 0.5);
                QVERIFY2(std::abs(deep - edge) < 1e-9 * W, qPrintable(QString::number((deep - edge) * count / W)));
                QVERIFY(std::abs(shallow - (W - edge)) < 1e-9 * W);
            }
        }
    }

    /// A wall from 20 to 500 nm over a third of a path: its resistance int dx/h^3 is 1/(2 slope) (1/h1^2 - 1/h2^2).
    void wallAlongAPath()
    {
        AirBearingSurface surface;
        surface.baseRecess = 500e-9;
        const CellGrid cells = uniform(4, 4);
        const double dx = L / 4, wall = dx / 3;
        surface.walls = {{.distance = {0.0, wall}, .recess = {0.0, 500e-9}}};
        for (int k = 0; k < 8; ++k) {
            const double edge = dx * (1.5 + k / 12.0);
            surface.rails = {box(0.0, edge, 0.0, W, 0.0, 1)};
            const FilmGaps gaps(Recess(surface, L, W), cells);
            const CutPlace* place = cutAt(gaps, 0, 2, 1);
            QVERIFY(place);
            double resistance = 0.0;
            const GapRow& row = gaps.rows[place->rows];
            for (std::uint32_t p = row.pieces; p < row.pieceEnd; ++p)
                resistance += gaps.pieces[p].extent / std::pow(gaps.pieces[p].recess + 20e-9, 3);
            const auto inverseSquare = [](double h) { return 1.0 / (h * h); };
            const double exact = (edge - 1.5 * dx) / 8e-24 +
                                 wall / 500e-9 * 0.5 * (inverseSquare(20e-9) - inverseSquare(520e-9)) +
                                 (2.5 * dx - edge - wall) / std::pow(520e-9, 3);
            // Four samples follow the wall: what it adds to the rail's resistance is wall h0/(2 * 500 nm), 2 % of its
            // length.
            QVERIFY2(std::abs(resistance - exact) < 0.25 * wall / 8e-24,
                     qPrintable(QString::number((resistance - exact) * 8e-24 / wall)));
        }
    }

private:
    static CellGrid uniform(int nx, int ny)
    {
        CellGrid result;
        for (int i = 0; i <= nx; ++i) result.x.push_back(L * i / nx);
        for (int j = 0; j <= ny; ++j) result.y.push_back(W * j / ny);
        return result;
    }
};

TOUCHDOWN_TEST(TestFilmGaps)

} // namespace test_film_gaps

#include "test_film_gaps.moc"
