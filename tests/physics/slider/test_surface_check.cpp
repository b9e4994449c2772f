// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_check.h"

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <QRegularExpression>
#include <QTest>

#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_check {

constexpr double length = 0.85e-3; // [m]
constexpr double width = 0.70e-3;  // [m]
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// A square with walls, and a ramp: nothing is wrong with it.
AirBearingSurface goodSurface()
{
    AirBearingSurface surface;
    surface.walls = {{{0.0, 5e-6, 5e-6, 10e-6}, {0.0, 0.2e-6, 0.3e-6, 1e-6}}, {{-2e-6, 4e-6}, {0.1e-6, 1e-6}}};
    Rail square;
    square.points = {{1e-4, 1e-4, 1}, {2e-4, 1e-4, 2}, {2e-4, 2e-4, 0}, {1e-4, 2e-4, 1}};
    Rail ramp;
    ramp.kind = RailKind::Ramp;
    ramp.points = {{3e-4, 1e-4, 0}, {4e-4, 1e-4, 0}, {4e-4, 2e-4, 0}};
    ramp.recess = {0.0, 1e-7, 1e-7};
    surface.rails = {square, ramp};
    surface.pointsOfInterest = {{0.0, 0.0}, {length, width}};
    return surface;
}

using Change = std::function<void(AirBearingSurface&)>;

/// The sentences; "?" in front of one whose key names another rail or wall profile than the sentence.
QStringList toList(const std::vector<SurfaceProblem>& problems)
{
    QStringList list;
    for (const SurfaceProblem& problem : problems) {
        const QString sentence = QString::fromStdString(problem.sentence);
        const QString number = sentence.section(QRegularExpression("[^0-9]+"), 1, 1);
        const QString key = sentence.startsWith("Rail ")           ? "abs.rail[" + number + "]"
                            : sentence.startsWith("Wall profile ") ? "abs.wall[" + number + "]"
                                                                   : QString("abs");
        list.append((QString::fromStdString(problem.key) == key ? "" : "?") + sentence);
    }
    return list;
}

class TestSurfaceCheck : public QObject {
    Q_OBJECT

private slots:
    void nothingIsWrong()
    {
        QCOMPARE(toList(surfaceProblems(goodSurface())), QStringList());
        QCOMPARE(toList(surfaceWarnings(goodSurface(), length, width)), QStringList());
        QCOMPARE(toList(surfaceProblems(AirBearingSurface{})), QStringList());
        for (unsigned seed = 1; seed <= 20; ++seed)
            QCOMPARE(toList(surfaceProblems(test::RandomSurface(seed).draw())), QStringList());
    }

    /// The bow tie's edges from (100, 200) to (200, 100) um and back cross in its middle.
    void placesOnTheSurface()
    {
        const auto only = [](const std::vector<SurfaceProblem>& problems) {
            if (problems.size() != 1) qFatal("not one problem");
            return problems.front().places;
        };
        AirBearingSurface surface = goodSurface();
        std::swap(surface.rails[0].points[2], surface.rails[0].points[3]);
        const std::vector<SurfacePoint> crossing = only(surfaceProblems(surface));
        QCOMPARE(crossing.size(), std::size_t(1));
        QVERIFY(std::abs(crossing[0].x - 1.5e-4) < 1e-12 && std::abs(crossing[0].y - 1.5e-4) < 1e-12);
        surface = goodSurface();
        surface.rails[0].points[1].x = notANumber;
        QVERIFY(only(surfaceProblems(surface)).empty());
        surface = goodSurface();
        surface.rails[1].points[1].x = surface.rails[1].points[2].x = 2.0 * length;
        const std::vector<SurfacePoint> outside = only(surfaceWarnings(surface, length, width));
        QCOMPARE(outside, (std::vector<SurfacePoint>{{2.0 * length, 1e-4}, {2.0 * length, 2e-4}}));
    }

    void problems_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char* name, const Change& change, const QStringList& expected) {
            QTest::newRow(name) << change << expected;
        };
        row("two points", [](AirBearingSurface& s) { s.rails[0].points.resize(2); },
            {"Rail 1 has 2 corners; it needs three or more."});
        row("no points", [](AirBearingSurface& s) { s.rails[1].points.clear(); },
            {"Rail 2 has 0 corners; it needs three or more."});
        row("coordinate that is no number", [](AirBearingSurface& s) { s.rails[0].points[2].y = notANumber; },
            {"Rail 1: corner 3 has a coordinate that is no number."});
        row("infinite coordinates",
            [](AirBearingSurface& s) {
                s.rails[0].points[0].x = HUGE_VAL;
                s.rails[0].points[3].y = -HUGE_VAL;
            },
            {"Rail 1: corners 1 and 4 have coordinates that are no numbers."});
        row("recess that is no number", [](AirBearingSurface& s) { s.rails[1].recess[2] = notANumber; },
            {"Rail 2: the recess is no number."});
        row("unused recess of a step", [](AirBearingSurface& s) { s.rails[0].recess[2] = notANumber; }, {});
        row("wall profile beyond the last", [](AirBearingSurface& s) { s.rails[0].points[1].wall = 3; },
            {"Rail 1: corner 2 names a wall profile that does not exist; there are 2."});
        row("negative wall profile",
            [](AirBearingSurface& s) {
                s.walls.pop_back();
                s.rails[0].points[0].wall = -1;
            },
            {"Rail 1: corners 1 and 2 name a wall profile that does not exist; there is 1."});
        row("ramp over collinear points",
            [](AirBearingSurface& s) {
                s.rails[1].points = {{3e-4, 1e-4, 0}, {4e-4, 1e-4, 0}, {5e-4, 1e-4, 0}, {4e-4, 3e-4, 0}};
            },
            {"Rail 2: the first three corners lie on a line, so that no ramp goes through them."});
        row("bow tie", [](AirBearingSurface& s) { std::swap(s.rails[0].points[1], s.rails[0].points[2]); },
            {"Rail 1: the outline crosses itself."});
        row("edge across a far edge",
            [](AirBearingSurface& s) {
                s.rails[0].points = {{0, 0, 0}, {4e-4, 0, 0}, {4e-4, 3e-4, 0}, {2e-4, -1e-5, 0}, {0, 3e-4, 0}};
            },
            {"Rail 1: the outline crosses itself."});
        row("no area",
            [](AirBearingSurface& s) {
                s.rails[0].points = {{0, 0, 0}, {2e-4, 1e-4, 0}, {4e-4, 2e-4, 0}};
            },
            {"Rail 1 has no area."});
        row("one and the same point",
            [](AirBearingSurface& s) {
                s.rails[0].points.assign(4, {1e-4, 1e-4, 0});
            },
            {"Rail 1 has no area."});
        row("fewer recesses than distances", [](AirBearingSurface& s) { s.walls[0].recess.pop_back(); },
            {"Wall profile 1 has 4 distances but 3 recesses."});
        row("profile of one point",
            [](AirBearingSurface& s) {
                s.walls[1] = {{0.0}, {0.0}};
            },
            {"Wall profile 2 has 1 point; it needs two or more."});
        row("distances that fall", [](AirBearingSurface& s) { s.walls[0].distance[3] = 4e-6; },
            {"Wall profile 1: the distances must ascend; point 4 lies before the point ahead of it."});
        row("wall recess that is no number", [](AirBearingSurface& s) { s.walls[0].recess[1] = notANumber; },
            {"Wall profile 1: point 2 has a value that is no number."});
        row("form and base", [](AirBearingSurface& s) { s.crown = s.baseRecess = notANumber; },
            {"The base recess is no number.", "The crown is no number."});
    }
    void problems()
    {
        QFETCH(Change, change);
        QFETCH(QStringList, expected);
        AirBearingSurface surface = goodSurface();
        change(surface);
        QCOMPARE(toList(surfaceProblems(surface)), expected);
    }

    void warnings_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char* name, const Change& change, const QStringList& expected) {
            QTest::newRow(name) << change << expected;
        };
        row("points outside the slider",
            [](AirBearingSurface& s) { s.rails[0].points[0].x = s.rails[0].points[3].x = -1e-6; },
            {"Rail 1: corners 1 and 4 lie outside the slider."});
        row("many points outside the slider",
            [](AirBearingSurface& s) {
                s.rails[0].points.clear();
                for (int i = 0; i < 8; ++i)
                    s.rails[0].points.push_back({2e-3 + 1e-4 * std::cos(0.7 * i), 1e-4 * std::sin(0.7 * i), 0});
            },
            {"Rail 1: corners 1, 2, 3, 4 and 4 more lie outside the slider."});
        row("repeated point",
            [](AirBearingSurface& s) { s.rails[0].points.insert(s.rails[0].points.begin() + 1, s.rails[0].points[1]); },
            {"Rail 1: corner 2 is repeated by the corner after."});
        row("first point repeated at the end",
            [](AirBearingSurface& s) { s.rails[0].points.push_back(s.rails[0].points[0]); },
            {"Rail 1: corner 5 is repeated by the corner after."});
        row("collinear point",
            [](AirBearingSurface& s) {
                s.rails[0].points.insert(s.rails[0].points.begin() + 1, RailPoint{1.3e-4, 1e-4, 0});
            },
            {"Rail 1: corner 2 lies on the line between the corners before and after."});
        row("spike",
            [](AirBearingSurface& s) {
                s.rails[0].points = {{1e-4, 1e-4, 0}, {2e-4, 1e-4, 0},   {2e-4, 2e-4, 0},
                                     {2e-4, 3e-4, 0}, {2e-4, 2.5e-4, 0}, {1e-4, 2e-4, 0}};
            },
            {"Rail 1: corner 3 lies on the line between the corners before and after.",
             "Rail 1: at corner 4 the outline turns back on itself."});
        row("corner on a far edge",
            [](AirBearingSurface& s) {
                s.rails[0].points = {{0, 0, 0}, {4e-4, 0, 0}, {4e-4, 3e-4, 0}, {2e-4, 0, 0}, {0, 3e-4, 0}};
            },
            {"Rail 1: the outline touches itself."});
        row("walls of a ramp", [](AirBearingSurface& s) { s.rails[1].points[0].wall = 1; },
            {"Rail 2 is a ramp: its walls are not used."});
        row("walls of a hollow", [](AirBearingSurface& s) { s.rails[0].recess[0] = s.baseRecess; },
            {"Rail 1 does not rise above the base recess: its walls are not used."});
        row("point of interest", [](AirBearingSurface& s) { s.pointsOfInterest[1].y = 1.0; },
            {"Points of interest: point 2 lies outside the slider."});
    }
    void warnings()
    {
        QFETCH(Change, change);
        QFETCH(QStringList, expected);
        AirBearingSurface surface = goodSurface();
        change(surface);
        QCOMPARE(toList(surfaceProblems(surface)), QStringList());
        QCOMPARE(toList(surfaceWarnings(surface, length, width)), expected);
    }
};

TOUCHDOWN_TEST(TestSurfaceCheck)

} // namespace test_surface_check

#include "test_surface_check.moc"
