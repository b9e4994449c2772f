// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_plot_path {

PlotAxis axis(double low, double high, AxisScale scale = AxisScale::Linear)
{
    PlotAxis axis;
    axis.label.scale = scale;
    axis.setRange({low, high});
    return axis;
}

class TestPlotPath : public QObject {
    Q_OBJECT

private slots:
    void arrowsPointTheWay();
    void dashesOfAWayBackCoverThoseOfTheWayThere();
    void cutLineKeepsItsSlope();
    void nothingFarOutside();
    void denseLineKeepsItsExtremes();
    void zerosNeverReachALogarithmicAxis();
    void piecesEndAtTheBorder();
    void phasePortraitIsACircle();
    void phasePortraitOfDifferentTimes();
    void phasePortraitLosesNoSample();
    void phasePortraitOfDrawnCurves_data();
    void phasePortraitOfDrawnCurves();
    void coveredLinesAreLeftOut();
    void costIsBoundedWhereLinesAreLong();
    void leavesOutWhatIsStraight();
};

// A straight line from (0, -1e6) to (1, 1e6) crosses y = 0 .. 1 within 1e-6 of x = 0.5: the cut must not tilt it.
void TestPlotPath::cutLineKeepsItsSlope()
{
    MinMaxPyramid data;
    data.append(std::vector{0.0, 1.0}, std::vector{-1e6, 1e6});
    const auto path = timePath(data, axis(0.0, 1.0), axis(0.0, 1.0), 100);
    const auto pieces = insideArea(path);
    QCOMPARE(pieces.size(), std::size_t(1));
    QVERIFY(std::abs(pieces[0].first().x() - 0.5) < 1e-9);
    QCOMPARE(pieces[0].first().y(), 0.0);
    QVERIFY(std::abs(pieces[0].last().x() - (0.5 + 0.5e-6)) < 1e-9);
    QCOMPARE(pieces[0].last().y(), 1.0);
}

void TestPlotPath::nothingFarOutside()
{
    MinMaxPyramid data;
    data.append(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{1e9, -1e9, 1e9, 0.5});
    for (const QPointF& point : timePath(data, axis(1.4, 1.6), axis(0.0, 1.0), 100)) {
        QVERIFY(std::abs(point.x()) <= 1.5);
        QVERIFY(std::abs(point.y()) <= 1.5);
    }
}

void TestPlotPath::denseLineKeepsItsExtremes()
{
    std::vector<double> times;
    std::vector<double> values;
    for (int i = 0; i < 100000; ++i) {
        times.push_back(i);
        values.push_back(i == 61803 ? 0.01 : 0.5 + 0.2 * std::sin(0.7 * i)); // one sample dips
    }
    MinMaxPyramid data;
    data.append(times, values);
    const auto path = timePath(data, axis(0.0, 1e5), axis(0.0, 1.0), 500);
    const auto lowest = std::min_element(path.begin(), path.end(), [](QPointF a, QPointF b) { return a.y() < b.y(); });
    QCOMPARE(lowest->y(), 0.01);
    QVERIFY(std::abs(lowest->x() - 0.61803) < 1.0 / 500);
    QVERIFY(path.size() <= 2004);
}

void TestPlotPath::zerosNeverReachALogarithmicAxis()
{
    MinMaxPyramid data;
    data.append(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{1e-3, 0.0, -5.0, 1e-1});
    const auto path = timePath(data, axis(0.0, 3.0), axis(1e-4, 1.0, AxisScale::Logarithmic), 100);
    QVERIFY(path.size() >= 4);
    for (const QPointF& point : path) QVERIFY(std::isfinite(point.y()) && point.y() >= -0.5);
    QCOMPARE(path.front(), QPointF(0.0, 0.25)); // 1e-3 on 1e-4 .. 1
    QCOMPARE(path.back().y(), 0.75);            // 1e-1
    const auto below = std::count_if(path.begin(), path.end(), [](QPointF p) { return p.y() == -0.5; });
    QVERIFY(below >= 2); // the zero and the negative value leave through the floor
}

void TestPlotPath::piecesEndAtTheBorder()
{
    // In from the left, out through the top, in again, out to the right.
    const std::vector<QPointF> path{{-0.5, 0.5}, {0.25, 0.5}, {0.25, 1.5}, {0.75, 1.5}, {0.75, 0.5}, {1.5, 0.5}};
    const auto pieces = insideArea(path);
    QCOMPARE(pieces.size(), std::size_t(2));
    QCOMPARE(pieces[0], (QPolygonF{QPointF(0.0, 0.5), QPointF(0.25, 0.5), QPointF(0.25, 1.0)}));
    QCOMPARE(pieces[1], (QPolygonF{QPointF(0.75, 1.0), QPointF(0.75, 0.5), QPointF(1.0, 0.5)}));
    QVERIFY(insideArea({{-0.5, 1.2}, {1.5, 1.2}}).empty());
}

// x = cos t, y = sin t on axes from -2 to 2: a circle of radius 1/4 about the middle of the area.
void TestPlotPath::phasePortraitIsACircle()
{
    std::vector<double> times;
    std::vector<double> x;
    std::vector<double> y;
    constexpr int count = 1'000'000;
    for (int i = 0; i < count; ++i) {
        const double t = 20.0 * std::numbers::pi * i / count; // ten times around
        times.push_back(t);
        x.push_back(std::cos(t));
        y.push_back(std::sin(t));
    }
    MinMaxPyramid across;
    MinMaxPyramid up;
    across.append(times, x);
    up.append(times, y);
    const auto path = phasePath(across, up, {0.0, 100.0}, axis(-2.0, 2.0), axis(-2.0, 2.0), {400.0, 400.0});
    QVERIFY(path.size() > 1000); // 10 circles of 628 px, points some 0.7 px apart
    QVERIFY(path.size() < 10000);
    for (const QPointF& point : path) QVERIFY(std::abs(std::hypot(point.x() - 0.5, point.y() - 0.5) - 0.25) < 1e-6);
    const auto [left, right] =
        std::minmax_element(path.begin(), path.end(), [](QPointF a, QPointF b) { return a.x() < b.x(); });
    QVERIFY(left->x() < 0.2501 && right->x() > 0.7499);
}

/// On axes from -2.5 to 2.5.
std::vector<QPointF> pathOfAll(const std::vector<double>& x, const std::vector<double>& y, const QSizeF& pixels)
{
    std::vector<double> times(x.size());
    std::iota(times.begin(), times.end(), 0.0);
    MinMaxPyramid across, up;
    across.append(times, x);
    up.append(times, y);
    const PlotAxis axes = axis(-2.5, 2.5);
    return phasePath(across, up, {0.0, times.back()}, axes, axes, pixels);
}

/// The first sample that is more than a pixel away from what is drawn; -1: none.
int lost(const std::vector<double>& x, const std::vector<double>& y, const QSizeF& pixels,
         const std::vector<QPointF>& path)
{
    QImage drawn(pixels.toSize(), QImage::Format_ARGB32_Premultiplied);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::black, 3.0));
    drawPath(painter, path, QRectF(QPointF(), pixels));
    painter.end();
    const PlotAxis axes = axis(-2.5, 2.5);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const QPoint at(static_cast<int>(axes.position(x[i]) * pixels.width()),
                        static_cast<int>((1.0 - axes.position(y[i])) * pixels.height()));
        if (drawn.valid(at) && drawn.pixelColor(at) == Qt::white) return static_cast<int>(i);
    }
    return -1;
}

// A bounce that is a little different each time fills a disk of 320 px across with a million samples. One sample of its
// own lies far outside.
void TestPlotPath::phasePortraitLosesNoSample()
{
    constexpr int count = 1'000'000, alone = 777'777;
    const QSizeF pixels(800.0, 400.0);
    std::vector<double> x, y;
    for (int i = 0; i < count; ++i) {
        const double t = 0.31 * i, radius = std::abs(std::sin(1.7e-4 * t));
        x.push_back(i == alone ? 2.3 : radius * std::cos(t));
        y.push_back(i == alone ? -2.3 : radius * std::sin(t));
    }
    const auto path = pathOfAll(x, y, pixels);
    QVERIFY2(path.size() < 200'000, qPrintable(QString::number(path.size())));
    const PlotAxis axes = axis(-2.5, 2.5);
    const QPointF spike(axes.position(2.3), axes.position(-2.3));
    QVERIFY(std::ranges::find(path, spike) != path.end());
    QCOMPARE(lost(x, y, pixels, path), -1);
}

void TestPlotPath::phasePortraitOfDrawnCurves_data()
{
    QTest::addColumn<int>("kind");
    QTest::addRow("noise") << 0;
    QTest::addRow("chirp") << 1;
    QTest::addRow("spiral") << 2;
    QTest::addRow("rare spike") << 3;
}

// What is guaranteed: each sample is within a pixel of a line that is drawn, and one that stands alone is an end of it.
void TestPlotPath::phasePortraitOfDrawnCurves()
{
    QFETCH(const int, kind);
    constexpr int count = 100'000;
    std::mt19937 generator(static_cast<unsigned>(kind + 20));
    std::normal_distribution<double> noise(0.0, 0.5);
    std::uniform_real_distribution<double> drawn(0.0, 1.0);
    const QSizeF pixels(500.0, 300.0);
    for (int draw = 0; draw < 4; ++draw) {
        const int spike = static_cast<int>(count * drawn(generator));
        const double a = 1e3 + 1e4 * drawn(generator), b = 1e3 + 1e4 * drawn(generator);
        std::vector<double> x, y;
        for (int i = 0; i < count; ++i) {
            const double part = static_cast<double>(i) / count;
            const double radius = kind == 2 ? 2.0 * part : 0.3;
            x.push_back(kind == 0 ? noise(generator) : radius * std::cos(a * part * (kind == 1 ? part : 1.0)));
            y.push_back(kind == 0 ? noise(generator) : radius * std::sin(b * part));
            if (kind == 3 && i == spike) y.back() = 2.4;
        }
        const std::vector<QPointF> path = pathOfAll(x, y, pixels);
        QCOMPARE(lost(x, y, pixels, path), -1);
        if (kind != 3) continue;
        const PlotAxis axes = axis(-2.5, 2.5);
        const QPointF tip(axes.position(x[static_cast<std::size_t>(spike)]), axes.position(2.4));
        QVERIFY(std::ranges::find(path, tip) != path.end());
    }
}

// There, back on the same pixels, then on: the way back is left out, and the pen is lifted there.
void TestPlotPath::coveredLinesAreLeftOut()
{
    const QSizeF pixels(100.0, 100.0);
    const std::vector<QPointF> path{{0.105, 0.505}, {0.905, 0.505}, {0.105, 0.505}, {0.105, 0.905}};
    const std::vector<QPointF> kept = withoutCovered(path, pixels);
    QCOMPARE(kept.size(), std::size_t(5));
    QVERIFY(kept[0] == path[0] && kept[1] == path[1] && std::isnan(kept[2].x()));
    QVERIFY(kept[3] == path[2] && kept[4] == path[3]);
    const auto pieces = insideArea(kept);
    QCOMPARE(pieces.size(), std::size_t(2));
    QCOMPARE(pieces[1].front(), path[2]);
    QVERIFY(std::abs(pathLength(kept, pixels) - 120.0) < 1e-9);
    // What lies outside is not drawn.
    QVERIFY(withoutCovered({{1.1, 0.2}, {1.4, 0.8}}, pixels).empty());
}

// Once no line may be followed any further, the ends decide: here each is new, and each sample is still drawn.
void TestPlotPath::costIsBoundedWhereLinesAreLong()
{
    const QSizeF pixels(100.0, 100.0);
    std::vector<QPointF> path;
    for (int i = 0; i < 200; ++i) path.emplace_back(i % 2 == 0 ? 0.005 : 0.995, 0.005 * i);
    const auto drawnPixels = [&](std::size_t mostFollowed) {
        const auto kept = withoutCovered(path, pixels, mostFollowed);
        return std::ranges::all_of(path, [&](const QPointF& point) {
            return std::ranges::any_of(kept, [&](const QPointF& other) {
                return std::hypot(point.x() - other.x(), point.y() - other.y()) <= 0.0101;
            });
        });
    };
    QVERIFY(drawnPixels(30'000'000) && drawnPixels(50));
}

void TestPlotPath::phasePortraitOfDifferentTimes()
{
    MinMaxPyramid across;
    MinMaxPyramid up;
    across.append(std::vector{0.0, 2.0}, std::vector{0.0, 1.0});                 // x = t / 2
    up.append(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{0.0, 1.0, 0.0, 5.0}); // beyond t = 2 there is no x
    const auto path = phasePath(across, up, {0.0, 10.0}, axis(0.0, 1.0), axis(0.0, 1.0), {100.0, 100.0});
    QCOMPARE(path, (std::vector<QPointF>{{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}}));
}

void TestPlotPath::arrowsPointTheWay()
{
    // To the right and back to the left, half a height up: each head lies on the line and points along it.
    const std::vector<QPointF> path{{0.1, 0.5}, {0.9, 0.5}, {0.9, 0.6}, {0.1, 0.6}};
    const QSizeF pixels(400.0, 200.0);
    const std::vector<PathArrow> arrows = pathArrows(path, pixels);
    QVERIFY(arrows.size() >= 4);
    for (const PathArrow& arrow : arrows) {
        const bool there = arrow.tip.y() < 0.55;
        if (arrow.tip.x() < 0.9) QCOMPARE(arrow.along, QPointF(there ? 1.0 : -1.0, 0.0));
    }
    QVERIFY(arrows.front().along.x() > 0.0 && arrows.back().along.x() < 0.0);
    // Outside the area there are none, nor on a line too short to carry one.
    QVERIFY(pathArrows({{1.1, 0.5}, {1.4, 0.5}, {1.4, 0.9}}, pixels).empty());
    QVERIFY(pathArrows({{0.1, 0.5}, {0.15, 0.5}}, pixels).empty());
}

void TestPlotPath::dashesOfAWayBackCoverThoseOfTheWayThere()
{
    // There in one line, back with a detour of 0.23 at the far end: both ways share the piece beside the turning point
    // and the one beside the ends.
    const std::vector<QPointF> path{{0.9, 0.5},  {0.1, 0.5}, {0.6, 0.5}, {0.6, 0.27},
                                    {0.8, 0.27}, {0.8, 0.5}, {0.9, 0.5}};
    const QSizeF pixels(400.0, 400.0);
    QPen pen(Qt::black, 1.5);
    pen.setDashPattern({5.0, 3.0});
    const QPen fitted = penThereAndBack(path, pixels, pen);
    const QList<qreal> dashes = fitted.dashPattern();
    QVERIFY(std::abs(dashes[0] / 5.0 - 1.0) < 0.1 && std::abs(dashes[1] / dashes[0] - 0.6) < 1e-9);
    const auto inked = [&](double walked) { // [px]
        const double period = dashes[0] + dashes[1];
        const double phase = std::fmod(walked / fitted.widthF() + fitted.dashOffset(), period);
        return std::min(std::abs(phase - dashes[0]), std::min(phase, period - phase)) < 0.05 ? -1
               : phase < dashes[0]                                                           ? 1
                                                                                             : 0; // -1: an end
    };
    const double turn = 0.8 * 400.0;
    const double whole = pathLength(path, pixels);
    for (double away = 0.0; away < 190.0; away += 3.1)
        QVERIFY(inked(turn - away) < 0 || inked(turn - away) == inked(turn + away));
    for (double away = 0.0; away < 39.0; away += 1.3) QVERIFY(inked(away) < 0 || inked(away) == inked(whole - away));
    // A solid pen stays what it is.
    QVERIFY(penThereAndBack(path, pixels, QPen(Qt::black, 1.5)).dashPattern().isEmpty());
}

void TestPlotPath::leavesOutWhatIsStraight()
{
    const QSizeF pixels(800.0, 200.0);
    // Level, with one sample below: its neighbours stay, and the ends.
    std::vector<QPointF> level;
    for (int k = 0; k <= 1000; ++k) level.emplace_back(1e-3 * k, k == 500 ? 0.1 : 0.5);
    const std::vector<QPointF> few = withoutStraightPoints(level, pixels);
    QCOMPARE(few, (std::vector<QPointF>{level[0], level[499], level[500], level[501], level[1000]}));
    // A wave of 20 periods: fewer points, nowhere more than a tenth of a pixel away.
    std::vector<QPointF> wave;
    for (int k = 0; k <= 3000; ++k)
        wave.emplace_back(k / 3000.0, 0.5 + 0.4 * std::sin(40.0 * std::numbers::pi * k / 3000.0));
    const std::vector<QPointF> kept = withoutStraightPoints(wave, pixels);
    QVERIFY(kept.size() < wave.size() / 2);
    std::size_t next = 1;
    for (const QPointF& point : wave) {
        while (kept[next].x() < point.x()) ++next;
        const double part = (point.x() - kept[next - 1].x()) / (kept[next].x() - kept[next - 1].x());
        QVERIFY(std::abs(std::lerp(kept[next - 1].y(), kept[next].y(), part) - point.y()) * 200.0 < 0.1001);
    }
    // Up and down within a column: all of it.
    const std::vector<QPointF> upright{{0.0, 0.0}, {0.1, 0.2}, {0.1, 0.9}, {0.1, 0.1}, {0.2, 0.5}};
    QCOMPARE(withoutStraightPoints(upright, pixels), upright);
    QVERIFY(withoutStraightPoints({}, pixels).empty());
}

TOUCHDOWN_TEST(TestPlotPath)

} // namespace test_plot_path

#include "test_plot_path.moc"
