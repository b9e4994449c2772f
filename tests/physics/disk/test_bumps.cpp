// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/bumps.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_bumps {

using std::numbers::pi;

/// One bump of 10 nm, 6 um long and 4 um wide, in the middle of a track of 100 x 20 um.
DiskSurface oneBump(BumpShape shape)
{
    DiskSurface s;
    s.kind = DiskSurfaceKind::Bumps;
    s.bumpShape = shape;
    s.bumpHeights = {10e-9};
    s.bumpLengths = {6e-6};
    s.bumpWidths = {4e-6};
    s.bumpX = {50e-6};
    s.bumpY = {10e-6};
    s.track = 100e-6;
    s.trackWidth = 20e-6;
    return s;
}

void shapes()
{
    QTest::addColumn<BumpShape>("shape");
    QTest::addColumn<double>("half");   // height halfway to the base's end, of the top
    QTest::addColumn<double>("volume"); // of height x length x width
    // sqrt(3/4); half an ellipsoid has 2/3 of pi/4.
    QTest::newRow("ellipsoid") << BumpShape::Ellipsoid << std::sqrt(0.75) << pi / 6.0;
    // exp(-4.5/4); 2 pi (1/6)^2 of a side.
    QTest::newRow("gaussian") << BumpShape::Gaussian << std::exp(-1.125) << 2.0 * pi / 36.0;
    // 1/2; the integral of pi r (1 + cos(pi r)) over r is pi/2 - 2/pi, times a quarter.
    QTest::newRow("cosine") << BumpShape::Cosine << 0.5 << (pi / 2.0 - 2.0 / pi) / 4.0;
}

class TestBumps : public QObject {
    Q_OBJECT

private slots:
    void theShapeIsThatOfTheHeader_data() { shapes(); }
    void theShapeIsThatOfTheHeader()
    {
        QFETCH(BumpShape, shape);
        QFETCH(double, half);
        const Bumps bump(oneBump(shape));
        QVERIFY(std::abs(bump.height(50e-6, 10e-6) - 10e-9) < 1e-22);
        for (const double side : {-1.0, 1.0}) {
            QVERIFY(std::abs(bump.height(50e-6 + side * 1.5e-6, 10e-6) - half * 10e-9) < 1e-20);
            QVERIFY(std::abs(bump.height(50e-6, 10e-6 + side * 1e-6) - half * 10e-9) < 1e-20);
        }
        // At the base: 0, and what a gaussian has at three standard deviations. An ellipsoid's flank is upright there:
        // what rounding leaves of 1 - r^2, 1e-15, its root makes 3e-8 of the height.
        const double base = shape == BumpShape::Gaussian ? std::exp(-4.5) * 10e-9 : 0.0;
        QVERIFY(std::abs(bump.height(53e-6, 10e-6) - base) < 1e-15);
        QCOMPARE(bump.height(70e-6, 10e-6), 0.0);
    }

    void aPitIsABumpDownwards()
    {
        DiskSurface s = oneBump(BumpShape::Cosine);
        s.bumpHeights = {-10e-9};
        QCOMPARE(Bumps(s).height(51e-6, 10e-6), -Bumps(oneBump(BumpShape::Cosine)).height(51e-6, 10e-6));
        QCOMPARE(Bumps(s).highest(), 0.0);
        QCOMPARE(Bumps(s).lowest(), -10e-9);
    }

    void withoutWidthsTheyAreRound()
    {
        DiskSurface s = oneBump(BumpShape::Ellipsoid);
        s.bumpWidths = {};
        const Bumps bump(s);
        QVERIFY(std::abs(bump.height(52e-6, 10e-6) - bump.height(50e-6, 12e-6)) < 1e-20);
    }

    void theyRepeatWithTheTrack_data() { shapes(); }
    void theyRepeatWithTheTrack()
    {
        QFETCH(BumpShape, shape);
        DiskSurface s = oneBump(shape);
        s.bumpX = {1e-6}; // reaches over the end of the track
        s.bumpY = {19.5e-6};
        const Bumps bump(s);
        for (const double x : {-1.3e-6, 0.0, 1.7e-6, 99.2e-6})
            for (const double y : {-1e-6, 0.0, 0.7e-6}) {
                const double height = bump.height(x, y);
                QVERIFY(height > 0.0);
                QVERIFY(std::abs(bump.height(x + 100e-6, y) - height) < 1e-17);
                QVERIFY(std::abs(bump.height(x - 300e-6, y + 40e-6) - height) < 1e-17);
            }
    }

    void aMovedGridSeesWhatTheDiskHasThere_data() { shapes(); }
    void aMovedGridSeesWhatTheDiskHasThere()
    {
        QFETCH(BumpShape, shape);
        DiskSurface s = oneBump(shape);
        s.bumpHeights.push_back(-3e-9);
        s.bumpLengths.push_back(9e-6);
        s.bumpWidths.push_back(8e-6);
        s.bumpX.push_back(53e-6);
        s.bumpY.push_back(12e-6);
        const Bumps bumps(s);
        const UniformGrid grid{250, 60, 0.9e-6, 0.5e-6, -13e-6, -4e-6}; // longer and wider than the track
        std::vector<double> heights(grid.cells(), 0.0);
        bumps.addHeights(grid, 41.7e-6, -3.3e-6, heights);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                const double expected = bumps.height(grid.x(i) - 41.7e-6, grid.y(j) + 3.3e-6);
                QVERIFY(std::abs(heights[static_cast<std::size_t>(j * grid.nx + i)] - expected) < 1e-17);
            }
    }

    void cellsHoldItsVolume_data()
    {
        QTest::addColumn<BumpShape>("shape");
        QTest::addColumn<double>("volume");
        QTest::addColumn<double>("width");
        for (const double width : {0.3e-6, 1.1e-6, 5e-6, 20e-6}) {
            const QString cells = QString(", cells of %1 um").arg(width * 1e6);
            QTest::newRow(qPrintable("ellipsoid" + cells)) << BumpShape::Ellipsoid << pi / 6.0 << width;
            QTest::newRow(qPrintable("gaussian" + cells)) << BumpShape::Gaussian << 2.0 * pi / 36.0 << width;
            QTest::newRow(qPrintable("cosine" + cells)) << BumpShape::Cosine << (pi / 2.0 - 2.0 / pi) / 4.0 << width;
        }
    }
    void cellsHoldItsVolume()
    {
        QFETCH(BumpShape, shape);
        QFETCH(double, volume);
        QFETCH(double, width);
        const Bumps bump(oneBump(shape));
        CellGrid grid;
        for (double x = 30e-6; x < 80e-6; x += width) grid.x.push_back(x);
        for (double y = 0.0; y < 20e-6 + 0.5 * width; y += width) grid.y.push_back(y);
        if (grid.y.back() < 19e-6) grid.y.push_back(20e-6);
        std::vector<double> means(grid.cells(), 0.0);
        bump.addMeans(grid, 0.013e-6, 0.0, means);
        double sum = 0.0;
        for (int j = 0; j < grid.ny(); ++j)
            for (int i = 0; i < grid.nx(); ++i)
                sum += means[static_cast<std::size_t>(j * grid.nx() + i)] * grid.widthX(i) * grid.widthY(j);
        const double error = sum / (10e-9 * 6e-6 * 4e-6) - volume;
        QVERIFY2(std::abs(error) < 0.005, qPrintable(QString::number(error)));
    }

    void noMeanIsFurtherOffThanTheHeaderSays_data() { shapes(); }
    void noMeanIsFurtherOffThanTheHeaderSays()
    {
        QFETCH(BumpShape, shape);
        const Bumps bump(oneBump(shape));
        double worst = 0.0;
        for (const double width : {0.2e-6, 0.7e-6, 2.3e-6, 9.0e-6}) {
            CellGrid grid;
            for (int i = 0; i <= 6; ++i) grid.x.push_back(46.4e-6 + i * width);
            for (int j = 0; j <= 4; ++j) grid.y.push_back(7.7e-6 + j * 0.8 * width);
            std::vector<double> means(grid.cells(), 0.0);
            bump.addMeans(grid, 0.0, 0.0, means);
            for (int j = 0; j < grid.ny(); ++j)
                for (int i = 0; i < grid.nx(); ++i) {
                    const int n = 200; // points of a reference, each way
                    double sum = 0.0;
                    for (int l = 0; l < n; ++l)
                        for (int k = 0; k < n; ++k)
                            sum += bump.height(grid.x[static_cast<std::size_t>(i)] + (k + 0.5) / n * width,
                                               grid.y[static_cast<std::size_t>(j)] + (l + 0.5) / n * 0.8 * width);
                    worst = std::max(worst, std::abs(means[static_cast<std::size_t>(j * grid.nx() + i)] - sum / n / n));
                }
        }
        QVERIFY2(worst < 0.005 * 10e-9, qPrintable(QString::number(worst / 10e-9)));
    }

    void whereTheyMeetTheyAdd()
    {
        DiskSurface s = oneBump(BumpShape::Cosine);
        s.bumpHeights = {10e-9, 4e-9, 7e-9};
        s.bumpLengths = {6e-6, 6e-6, 6e-6};
        s.bumpWidths = {};
        s.bumpX = {50e-6, 52e-6, 80e-6};
        s.bumpY = {10e-6, 10e-6, 10e-6};
        const Bumps bumps(s);
        // At 51 um both are at r = 1/3, where the cosine is 3/4 of its height.
        QVERIFY(std::abs(bumps.height(51e-6, 10e-6) - 0.75 * 14e-9) < 1e-20);
        QVERIFY(std::abs(bumps.highest() - 14e-9) < 1e-20); // the third one meets none
        QCOMPARE(bumps.lowest(), 0.0);
    }

    /// 6 um long and 4 um wide: their bases meet where they are less than that apart, times the reach of the shape.
    void theBoundAddsOnlyNeighboursThatOverlap_data() { shapes(); }
    void theBoundAddsOnlyNeighboursThatOverlap()
    {
        QFETCH(BumpShape, shape);
        const double reach = shape == BumpShape::Gaussian ? 3.0 : 1.0; // in half lengths: nine deviations
        for (const bool across : {false, true})
            for (const double share : {0.9, 1.1}) {
                DiskSurface s = oneBump(shape);
                s.bumpHeights = {10e-9, 4e-9};
                s.bumpLengths = {6e-6, 6e-6};
                s.bumpWidths = {4e-6, 4e-6};
                const double apart = share * reach * (across ? 4e-6 : 6e-6);
                s.bumpX = {50e-6, across ? 50e-6 : 50e-6 + apart};
                s.bumpY = {2e-6, across ? 2e-6 + apart : 2e-6};
                s.trackWidth = 40e-6;
                QVERIFY(std::abs(Bumps(s).highest() - (share < 1.0 ? 14e-9 : 10e-9)) < 1e-20);
            }
    }

    void aBumpAsLongAsTheTrackMeetsItself()
    {
        DiskSurface s = oneBump(BumpShape::Gaussian);
        s.bumpLengths = {100e-6};
        s.bumpWidths = {20e-6};
        const Bumps bump(s);
        // Six standard deviations long: halfway to its copies both sides add exp(-4.5).
        QVERIFY(std::abs(bump.height(0.0, 10e-6) - 2.0 * std::exp(-4.5) * 10e-9) < 1e-13);
        QVERIFY(bump.highest() >= bump.height(50e-6, 10e-6));
    }
};

TOUCHDOWN_TEST(TestBumps)

} // namespace test_bumps

#include "test_bumps.moc"
