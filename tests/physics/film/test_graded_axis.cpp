// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/graded_axis.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_graded_axis {

/// The number of the line at this position, -1 for none.
int lineAt(const std::vector<double>& lines, double position)
{
    const auto found = std::find(lines.begin(), lines.end(), position);
    return found == lines.end() ? -1 : static_cast<int>(found - lines.begin());
}

class TestGradedAxis : public QObject {
    Q_OBJECT

private slots:
    /// Equal densities give equal cells.
    void evenWish()
    {
        const std::vector<double> lines =
            gradedAxis({.start = -1.0, .end = 3.0, .density = std::vector<double>(50, 7.0), .marks = {}}, 16);
        QCOMPARE(lines.size(), std::size_t{17});
        for (int i = 0; i <= 16; ++i) QVERIFY(std::abs(lines[static_cast<std::size_t>(i)] - (-1.0 + 0.25 * i)) < 1e-12);
        QCOMPARE(lines.front(), -1.0);
        QCOMPARE(lines.back(), 3.0);
    }

    /// A density 1 + x, too mild for the limit: line i is where x + x^2/2 is i/n of 3/2.
    void followsTheDensity()
    {
        std::vector<double> density;
        for (int k = 0; k < 1000; ++k) density.push_back(1.0 + (k + 0.5) / 1000);
        const std::vector<double> lines = gradedAxis({.density = density, .marks = {}}, 60);
        for (int i = 0; i <= 60; ++i) {
            const double expected = std::sqrt(1.0 + 3.0 * i / 60.0) - 1.0;
            // Within a bin the density counts as constant: off by at most an eighth of (1/1000)^2 of its slope.
            QVERIFY(std::abs(lines[static_cast<std::size_t>(i)] - expected) < 1e-6);
        }
    }

    /// A density that jumps by a factor: spacings s of centres (s1 + s2)/2 apart differ by at most growth times that,
    /// so their ratio is at most (1 + g/2)/(1 - g/2) = 1.2222 for g = 0.2. The limit acts on bins, 1/50 of a cell here.
    void growthIsLimited_data()
    {
        QTest::addColumn<double>("jump");
        QTest::addColumn<double>("growth");
        QTest::newRow("a hundred times") << 100.0 << 0.2;
        QTest::newRow("ten times, gentle") << 10.0 << 0.05;
        QTest::newRow("nothing wished for on one side") << 1e9 << 0.2;
    }
    void growthIsLimited()
    {
        QFETCH(double, jump);
        QFETCH(double, growth);
        std::vector<double> density(4000, 1.0);
        std::fill(density.begin() + 2600, density.begin() + 2800, jump);
        const std::vector<double> lines = gradedAxis({.density = density, .marks = {}, .growth = growth}, 80);
        const double bound = (1.0 + 0.5 * growth) / (1.0 - 0.5 * growth);
        double largest = 0.0, narrowest = 1.0, widest = 0.0;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            const double spacing = lines[i] - lines[i - 1];
            QVERIFY(spacing > 0.0);
            narrowest = std::min(narrowest, spacing);
            widest = std::max(widest, spacing);
            if (i == 1) continue;
            const double before = lines[i - 1] - lines[i - 2];
            largest = std::max({largest, spacing / before, before / spacing});
        }
        QVERIFY2(largest < bound + 0.01, qPrintable(QString::number(largest)));
        QVERIFY2(largest > 1.0 + 0.6 * growth, qPrintable(QString::number(largest))); // the limit is used
        QVERIFY(widest > 3.0 * narrowest);
    }

    void marksAreExactAndOnEvenLines()
    {
        const std::vector<AxisMark> marks{{0.137, 1.0}, {0.512345, 2.0}, {0.9, 0.3}};
        for (const int multiple : {2, 4}) {
            const std::vector<double> lines =
                gradedAxis({.density = std::vector<double>(100, 1.0), .marks = marks, .multiple = multiple}, 64);
            QCOMPARE(lines.size(), std::size_t{65});
            QVERIFY(std::is_sorted(lines.begin(), lines.end()));
            for (const AxisMark& mark : marks) {
                const int line = lineAt(lines, mark.position);
                QVERIFY(line > 0);
                QCOMPARE(line % multiple, 0);
            }
        }
    }

    /// Two marks 0.01 apart on cells of 0.1 want the same line: the heavier has it, in whatever order they come.
    void theHeavierMarkHolds()
    {
        for (const bool swapped : {false, true}) {
            std::vector<AxisMark> marks{{0.40, 1.0}, {0.41, 2.0}};
            if (swapped) std::swap(marks[0], marks[1]);
            const std::vector<double> lines = gradedAxis({.density = std::vector<double>(20, 1.0), .marks = marks}, 10);
            QCOMPARE(lineAt(lines, 0.41), 4);
            QCOMPARE(lineAt(lines, 0.40), -1);
        }
    }

    /// Marks at the ends, outside or without number change nothing.
    void marksBesideTheAxis()
    {
        const AxisWish wish{.start = 1.0, .end = 2.0, .density = std::vector<double>(30, 1.0), .marks = {}};
        AxisWish marked = wish;
        marked.marks = {{1.0, 5.0}, {2.0, 5.0}, {0.5, 5.0}, {2.5, 5.0}, {std::nan(""), 5.0}};
        QCOMPARE(gradedAxis(marked, 12), gradedAxis(wish, 12));
    }

    /// Whatever is wished for: so many lines, ascending, from end to end, and no cell shrinks or swells without bound
    /// next to a mark: a mark may press the cells beside it to 0.4 or 2.5 times their wish, and the limit of growth
    /// holds before it.
    void anyWish()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (int trial = 0; trial < 200; ++trial) {
            AxisWish wish{.start = 0.0, .end = 1e-3, .density = {}, .marks = {}};
            for (int k = 0; k < 512; ++k) wish.density.push_back(std::pow(unit(random), 6.0));
            for (int k = 0; k < trial % 20; ++k) wish.marks.push_back({1e-3 * unit(random), unit(random)});
            const int cells = 8 + 2 * (trial % 40);
            const std::vector<double> lines = gradedAxis(wish, cells);
            QCOMPARE(static_cast<int>(lines.size()), cells + 1);
            QCOMPARE(lines.front(), 0.0);
            QCOMPARE(lines.back(), 1e-3);
            for (std::size_t i = 1; i < lines.size(); ++i) QVERIFY(lines[i] > lines[i - 1]);
            for (std::size_t i = 2; i < lines.size(); ++i) {
                const double ratio = (lines[i] - lines[i - 1]) / (lines[i - 1] - lines[i - 2]);
                QVERIFY2(ratio < 8.0 && ratio > 0.125, qPrintable(QString("%1 %2").arg(trial).arg(ratio)));
            }
        }
    }

    /// No wish at all is an even one.
    void zeroDensity()
    {
        const std::vector<double> lines = gradedAxis({.density = std::vector<double>(10, 0.0), .marks = {}}, 4);
        for (int i = 0; i <= 4; ++i) QVERIFY(std::abs(lines[static_cast<std::size_t>(i)] - 0.25 * i) < 1e-12);
    }
};

TOUCHDOWN_TEST(TestGradedAxis)

} // namespace test_graded_axis

#include "test_graded_axis.moc"
