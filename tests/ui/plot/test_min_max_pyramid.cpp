// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/min_max_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <thread>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/plot/cold_samples.h"

using namespace touchdown;

namespace test_min_max_pyramid {

struct Samples {
    std::vector<double> times;
    std::vector<double> values;
};

Samples noise(std::size_t count, bool even, unsigned seed = 7)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> value(7e-9, 1e-9);
    std::exponential_distribution<double> step(1e8);
    Samples samples;
    double time = 1e-6;
    for (std::size_t i = 0; i < count; ++i) {
        samples.times.push_back(time);
        samples.values.push_back(value(random));
        time += even ? 1e-8 : (i % 7 == 0 ? 0.0 : step(random)); // some times twice, as at an event
    }
    return samples;
}

class TestMinMaxPyramid : public QObject {
    Q_OBJECT

private slots:
    void aTwinStaysAsItWas();
    void extremesAgreeWithBruteForce_data();
    void extremesAgreeWithBruteForce();
    void thinningKeepsEveryBinsExtremes_data();
    void thinningKeepsEveryBinsExtremes();
    void fewSamplesStayAsTheyAre();
    void gridDoesNotMoveWithTheWindow();
    void longHistoriesLoseNoSample();
    void aWideViewNeedsNoSamples();
    void showsBlocksUntilTheDiskIsRead();
    void quantitiesShareTheirTimes();
    void refusesWhatIsNoSample();
    void interpolatesBetweenNeighbours();
    void findsTheNearestSample();
    void resultsOutliveAppending();
    void emptyAnswersNothing();
};

void TestMinMaxPyramid::extremesAgreeWithBruteForce_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("even");
    for (const int count : {1, 63, 64, 65, 255, 4095, 4097, 20000}) {
        QTest::addRow("%d even", count) << count << true;
        QTest::addRow("%d uneven", count) << count << false;
    }
}

void TestMinMaxPyramid::extremesAgreeWithBruteForce()
{
    QFETCH(int, count);
    QFETCH(bool, even);
    const Samples samples = noise(static_cast<std::size_t>(count), even);
    MinMaxPyramid pyramid;
    for (std::size_t i = 0; i < samples.times.size();) { // batches of 1, 2, 3 ...
        const std::size_t batch = std::min(samples.times.size() - i, i % 97 + 1);
        QCOMPARE(pyramid.append({&samples.times[i], batch}, {&samples.values[i], batch}), batch);
        i += batch;
    }
    std::mt19937 random(3);
    std::uniform_int_distribution<std::size_t> index(0, samples.times.size() - 1);
    for (int trial = 0; trial < 200; ++trial) {
        const auto [a, b] = std::minmax({index(random), index(random)});
        const double from = samples.times[a];
        const double to = samples.times[b];
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        for (std::size_t i = 0; i < samples.times.size(); ++i) {
            if (samples.times[i] < from || samples.times[i] > to) continue;
            low = std::min(low, samples.values[i]);
            high = std::max(high, samples.values[i]);
        }
        const auto found = pyramid.extremes(from, to);
        QVERIFY(found.has_value());
        QCOMPARE(found->low, low);
        QCOMPARE(found->high, high);
    }
}

void TestMinMaxPyramid::thinningKeepsEveryBinsExtremes_data()
{
    QTest::addColumn<bool>("even");
    QTest::addColumn<bool>("logarithmic");
    QTest::addColumn<int>("pixels");
    QTest::addRow("even, 100 px") << true << false << 100;
    QTest::addRow("uneven, 100 px") << false << false << 100;
    QTest::addRow("even, 777 px") << true << false << 777;
    QTest::addRow("uneven, 3 px") << false << false << 3;
    QTest::addRow("even, logarithmic time, 50 px") << true << true << 50;
}

// Every column of pixels must show its smallest and largest sample. A bin is at most one column wide; a bin of four
// blocks or more begins and ends with a block, which adds less than a block. So each sample has a drawn point
// within 1.25 columns that lies at least as far down, and one at least as far up.
void TestMinMaxPyramid::thinningKeepsEveryBinsExtremes()
{
    QFETCH(bool, even);
    QFETCH(bool, logarithmic);
    QFETCH(int, pixels);
    const AxisScale scale = logarithmic ? AxisScale::Logarithmic : AxisScale::Linear;
    const auto coordinate = [&](double time) { return logarithmic ? std::log2(time) : time; };
    const Samples samples = noise(30000, even);
    MinMaxPyramid pyramid;
    pyramid.append(samples.times, samples.values);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int trial = 0; trial < 30; ++trial) {
        const double whole = samples.times.back() - samples.times.front();
        const double from = samples.times.front() + 0.5 * part(random) * whole;
        const double to = from + (0.02 + 0.5 * part(random)) * whole;
        const auto points = pyramid.thinned(from, to, pixels, scale);
        QVERIFY(points.size() <= static_cast<std::size_t>(4 * pixels + 4));
        QVERIFY(std::is_sorted(points.begin(), points.end(), [](QPointF a, QPointF b) { return a.x() < b.x(); }));

        const double column = (coordinate(to) - coordinate(from)) / pixels;
        for (std::size_t i = 0; i < samples.times.size(); ++i) {
            if (samples.times[i] < from || samples.times[i] > to) continue;
            const double here = coordinate(samples.times[i]);
            const auto first = std::find_if(points.begin(), points.end(),
                                            [&](QPointF p) { return coordinate(p.x()) >= here - 1.2501 * column; });
            const auto last = std::find_if(first, points.end(),
                                           [&](QPointF p) { return coordinate(p.x()) > here + 1.2501 * column; });
            QVERIFY(std::any_of(first, last, [&](QPointF p) { return p.y() <= samples.values[i]; }));
            QVERIFY(std::any_of(first, last, [&](QPointF p) { return p.y() >= samples.values[i]; }));
        }
        const auto extremes = pyramid.extremes(from, to);
        const auto drawnLow =
            std::min_element(points.begin(), points.end(), [](QPointF a, QPointF b) { return a.y() < b.y(); });
        QVERIFY(drawnLow->y() <= extremes->low);
    }
}

void TestMinMaxPyramid::fewSamplesStayAsTheyAre()
{
    const std::vector<double> times{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
    const std::vector<double> values{5.0, 1.0, 4.0, 1.0, 5.0, 9.0};
    MinMaxPyramid pyramid;
    pyramid.append(times, values);
    // The window holds 2 and 3; its neighbours 1 and 4 let the line reach the edges.
    const auto points = pyramid.thinned(1.5, 3.5, 400);
    const std::vector<QPointF> expected{{1.0, 1.0}, {2.0, 4.0}, {3.0, 1.0}, {4.0, 5.0}};
    QCOMPARE(points, expected);
}

// While a window of fixed width moves on, what it and the window before both show must be drawn by the same points.
void TestMinMaxPyramid::gridDoesNotMoveWithTheWindow()
{
    const Samples samples = noise(50000, true);
    MinMaxPyramid pyramid;
    pyramid.append(samples.times, samples.values);
    const double width = 2e-4;
    const auto common = [&](double start) {
        std::vector<QPointF> points = pyramid.thinned(start, start + width, 300);
        std::erase_if(points, [](QPointF p) { return p.x() < 1.2e-4 || p.x() > 2.2e-4; });
        return points;
    };
    const auto reference = common(1e-4);
    QVERIFY(reference.size() > 300);
    for (const double shift : {1e-9, 3.3e-7, 7.77e-6, 1.9e-5}) QCOMPARE(common(1e-4 + shift), reference);
}

void TestMinMaxPyramid::longHistoriesLoseNoSample()
{
    constexpr std::size_t count = (std::size_t(1) << 20U) + 5;
    Samples samples = noise(count, true);
    samples.values[54321] = -3e-9; // a single deep minimum
    MinMaxPyramid pyramid;
    pyramid.append(samples.times, samples.values);
    QCOMPARE(pyramid.size(), count);
    for (std::size_t i = 0; i < count; i += 997) QCOMPARE(pyramid.value(i), samples.values[i]);
    const auto points = pyramid.thinned(samples.times.front(), samples.times.back(), 40);
    const auto low = std::ranges::min_element(points, {}, &QPointF::y);
    QCOMPARE(*low, QPointF(samples.times[54321], -3e-9));
}

// Samples that are on the disk are replaced by a number that would show.
void TestMinMaxPyramid::aWideViewNeedsNoSamples()
{
    const Samples samples = noise(SampleColumn::pieceSize * 3, true);
    MinMaxPyramid pyramid;
    pyramid.append(samples.times, samples.values);
    const double from = samples.times[20'001], to = samples.times[180'001];
    const auto before = pyramid.thinned(from, to, 100);
    const auto wrong = std::make_shared<double[]>(SampleColumn::pieceSize, 1.0);
    for (std::size_t piece = 0; piece < 3; ++piece) {
        pyramid.values().replace(piece, wrong);
        pyramid.times()->column().replace(piece, wrong);
    }
    QCOMPARE(pyramid.thinned(from, to, 100), before);
    QVERIFY(pyramid.thinned(from, from + 1e-6, 100) != before); // a close view reads them
}

void TestMinMaxPyramid::showsBlocksUntilTheDiskIsRead()
{
    const Samples samples = noise(SampleColumn::pieceSize * 8, true);
    MinMaxPyramid pyramid;
    pyramid.append(samples.times, samples.values);
    const double from = samples.times[1000], to = samples.times[400'000];
    const auto exact = pyramid.thinned(from, to, 4000);
    if (!makeCold(pyramid)) QSKIP("this system does not drop pages on request");
    bool waits = false;
    const auto coarse = pyramid.thinned(from, to, 4000, AxisScale::Linear, &waits);
    QVERIFY(waits);
    QVERIFY(coarse.size() > 400'000 / 64);
    const auto lowest = [](const auto& points) { return *std::ranges::min_element(points, {}, &QPointF::y); };
    QCOMPARE(lowest(coarse), lowest(exact));
    const auto isExact = [&] {
        bool stillWaits = false;
        return pyramid.thinned(from, to, 4000, AxisScale::Linear, &stillWaits) == exact && !stillWaits;
    };
    QTRY_VERIFY(isExact());
}

void TestMinMaxPyramid::quantitiesShareTheirTimes()
{
    const auto times = std::make_shared<SampleTimes>();
    MinMaxPyramid first(times), second(times), third(times);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int batch = 0; batch < 3; ++batch) {
        const std::vector<double> at{10.0 * batch, 10.0 * batch + 1.0};
        first.append(at, std::vector{1.0, 2.0});
        second.append(at, std::vector{3.0, 4.0});
        third.append(at, std::vector{5.0, batch == 1 ? nan : 6.0}); // refuses one
    }
    QCOMPARE(times->size(), std::size_t(6));
    QVERIFY(first.times() == times);
    QVERIFY(second.times() == times);
    QVERIFY(third.times() != times);
    QCOMPARE(third.size(), std::size_t(5));
    QCOMPARE(third.time(2), 10.0);
    QCOMPARE(third.time(3), 20.0);
    QCOMPARE(third.valueAt(21.0), std::optional(6.0));
    QCOMPARE(second.valueAt(11.0), std::optional(4.0));
}

void TestMinMaxPyramid::refusesWhatIsNoSample()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const std::vector<double> times{0.0, 1.0, 2.0, 1.5, nan, 3.0, 3.0};
    const std::vector<double> values{1.0, nan, 3.0, 9.0, 1.0, infinite, 4.0};
    MinMaxPyramid pyramid;
    // Taken: (0, 1), (2, 3), (3, 4). Refused: a value not a number, a time before the last, a time not a number,
    // infinity.
    QCOMPARE(pyramid.append(times, values), std::size_t(3));
    QCOMPARE(pyramid.size(), std::size_t(3));
    QCOMPARE(pyramid.valueAt(1.0), std::optional(2.0)); // the gap is bridged: half way from 1 to 3
    QCOMPARE(pyramid.extremes(0.0, 3.0)->high, 4.0);
}

void TestMinMaxPyramid::interpolatesBetweenNeighbours()
{
    MinMaxPyramid pyramid;
    pyramid.append(std::vector{0.0, 2.0, 2.0, 3.0}, std::vector{0.0, 4.0, 10.0, 20.0});
    QCOMPARE(pyramid.valueAt(0.5), std::optional(1.0));
    QCOMPARE(pyramid.valueAt(2.0), std::optional(10.0)); // after the jump
    QCOMPARE(pyramid.valueAt(2.5), std::optional(15.0));
    QCOMPARE(pyramid.valueAt(3.0), std::optional(20.0));
    QVERIFY(!pyramid.valueAt(-0.1).has_value());
    QVERIFY(!pyramid.valueAt(3.1).has_value());
}

void TestMinMaxPyramid::findsTheNearestSample()
{
    MinMaxPyramid pyramid;
    const double times[] = {1.0, 2.0, 4.0};
    pyramid.append(times, times);
    const std::pair<double, std::size_t> expected[] = {{-9.0, 0}, {1.0, 0}, {1.4, 0}, {1.5, 0}, {1.6, 1},
                                                       {2.9, 1},  {3.0, 1}, {3.1, 2}, {4.0, 2}, {99.0, 2}};
    for (const auto& [time, index] : expected) QCOMPARE(pyramid.nearest(time), index);
}

void TestMinMaxPyramid::resultsOutliveAppending()
{
    const Samples samples = noise(5000, true);
    MinMaxPyramid pyramid;
    pyramid.append({samples.times.data(), 1000}, {samples.values.data(), 1000});
    const auto points = pyramid.thinned(samples.times[0], samples.times[999], 50);
    const auto copy = points;
    pyramid.append({&samples.times[1000], 4000}, {&samples.values[1000], 4000}); // grows
    QCOMPARE(points, copy);
    QCOMPARE(pyramid.lastTime(), samples.times.back());
}

void TestMinMaxPyramid::emptyAnswersNothing()
{
    MinMaxPyramid pyramid;
    QVERIFY(pyramid.thinned(0.0, 1.0, 100).empty());
    QVERIFY(!pyramid.extremes(0.0, 1.0).has_value());
    QVERIFY(!pyramid.valueAt(0.0).has_value());
    pyramid.append(std::vector{1.0}, std::vector{2.0});
    QVERIFY(pyramid.thinned(1.0, 1.0, 100).empty()); // no width
    QVERIFY(!pyramid.extremes(2.0, 3.0).has_value());
}

/// While the original grows, another thread reads what was there.
void TestMinMaxPyramid::aTwinStaysAsItWas()
{
    MinMaxPyramid data;
    const auto append = [&data](std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const auto i = static_cast<double>(data.size());
            data.append(std::vector{i}, std::vector{std::sin(i)});
        }
    };
    append(70'001); // more than a piece
    const std::shared_ptr<const MinMaxPyramid> twin = data.twin();
    bool same = true;
    std::thread reader([&] {
        for (std::size_t k = 0; k < twin->size(); ++k) {
            const auto i = static_cast<double>(k);
            same = same && twin->time(k) == i && twin->value(k) == std::sin(i);
        }
    });
    append(70'000);
    reader.join();
    QVERIFY(same);
    QCOMPARE(twin->size(), std::size_t(70'001));
    QCOMPARE(twin->lastTime(), 70'000.0);
    QCOMPARE(twin->valueAt(0.5), data.valueAt(0.5));
    QCOMPARE(twin->samplesWithin(10.0, 1e9), (std::pair<std::size_t, std::size_t>(10, 70'001)));
    QCOMPARE(twin->extremes(0.0, 1e9)->high, data.extremes(0.0, 70'000.0)->high);
    QVERIFY(twin->bytesInMemory() < 1000); // the samples are those of the original
}

TOUCHDOWN_TEST(TestMinMaxPyramid)

} // namespace test_min_max_pyramid

#include "test_min_max_pyramid.moc"
