// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_difference.h"

#include "core/case/case_key.h"
#include "tests/support/random_case.h"
#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <functional>

#include <QTest>

using namespace touchdown;

namespace test_case_difference {

using Change = std::function<void(Case&)>;

Rail box(double x, double recess)
{
    return {RailKind::Step,
            {{x, 0.1e-3, 1}, {x + 0.1e-3, 0.1e-3, 1}, {x + 0.1e-3, 0.3e-3, 1}, {x, 0.3e-3, 1}},
            {recess, 0.0, 0.0}};
}

Case filmCase()
{
    Case c = defaultsOf(ModelKind::Film);
    c.surface.rails = {box(0.1e-3, 0.0), box(0.3e-3, 0.1e-6), box(0.5e-3, 0.1e-6), box(0.7e-3, 0.0)};
    c.surface.walls = {{{-1e-6, 0.0, 2e-6}, {0.0, 0.5e-6, 1e-6}}};
    c.surface.pointsOfInterest = {{1e-3, 0.5e-3}};
    return c;
}

/// "key kind before after" of each change.
QStringList shown(const std::vector<CaseChange>& changes)
{
    static const char* const kinds[] = {"value", "kind", "added", "removed", "order"};
    QStringList list;
    for (const CaseChange& change : changes)
        list << QString::fromStdString(
            change.key + ' ' + kinds[static_cast<int>(change.kind)] +
            (change.before.empty() && change.after.empty() ? "" : " " + change.before + " to " + change.after));
    return list;
}

/// A drawn half of the numbers of a surface gets other values.
void changeNumbers(AirBearingSurface& surface, test::RandomSurface& draw)
{
    const auto change = [&](double& length, double most) {
        if (draw.whole(0, 1)) length += draw.uniform(-most, most);
    };
    for (Rail& rail : surface.rails) {
        const std::size_t count = rail.kind == RailKind::Step ? 1 : 3;
        for (std::size_t i = 0; i < count; ++i) change(rail.recess[i], 1e-6);
        for (RailPoint& point : rail.points) {
            change(point.x, 1e-4), change(point.y, 1e-4);
            if (draw.whole(0, 1)) point.wall = draw.whole(0, static_cast<int>(surface.walls.size()));
        }
    }
    for (WallProfile& wall : surface.walls) {
        for (double& distance : wall.distance) change(distance, 1e-5);
        for (double& recess : wall.recess) change(recess, 1e-6);
    }
    for (SurfacePoint& point : surface.pointsOfInterest) change(point.x, 1e-4), change(point.y, 1e-4);
}

class TestCaseDifference : public QObject {
    Q_OBJECT

private slots:
    void namesEachChange_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QStringList>("found");
        const auto row = [](const char* name, const Change& change, const QStringList& found) {
            QTest::newRow(name) << change << found;
        };
        row("nothing", [](Case&) {}, {});
        row("a title", [](Case& c) { c.title = c.about.watch = "other"; }, {});
        row("a value without effect", [](Case& c) { c.springs.cutoff = 1e-10; }, {});
        row("a number", [](Case& c) { c.surface.crown = 5e-9; }, {"abs.crown value 0 nm to 5 nm"});
        row("the name of a file",
            [](Case& c) {
                c.diskSurface.kind = DiskSurfaceKind::File;
                c.diskSurface.file = "track.txt";
            },
            {"disk.surface.kind value flat to file", "disk.surface.file value  to track.txt"});
        row("a recess", [](Case& c) { c.surface.rails[2].recess[0] = 0.2e-6; },
            {"abs.rail[3].recess value 0.1 um to 0.2 um"});
        row("a small change", [](Case& c) { c.surface.rails[2].recess[0] = 0.1000001e-6; },
            {"abs.rail[3].recess value 0.1 um to 0.1000001 um"});
        row("a corner", [](Case& c) { c.surface.rails[1].points[3].x = 0.25e-3; },
            {"abs.rail[2].point[4].x value 0.3 mm to 0.25 mm"});
        row("the wall of an edge", [](Case& c) { c.surface.rails[1].points[0].wall = 0; },
            {"abs.rail[2].wall[1] value 1 to 0"});
        row("a corner added",
            [](Case& c) {
                auto& points = c.surface.rails[0].points;
                points.insert(points.begin() + 2, {0.25e-3, 0.2e-3, 1});
            },
            {"abs.rail[1].point[3] added"});
        row("a ramp",
            [](Case& c) {
                c.surface.rails[3].kind = RailKind::Ramp;
                c.surface.rails[3].recess = {0.0, 0.0, 1e-6};
            },
            {"abs.rail[4] kind step to ramp"});
        row("a rail added", [](Case& c) { c.surface.rails.push_back(box(0.9e-3, 0.0)); }, {"abs.rail[5] added"});
        row("a rail removed", [](Case& c) { c.surface.rails.erase(c.surface.rails.begin() + 1); },
            {"abs.rail[2] removed"});
        row("rails in another order", [](Case& c) { std::swap(c.surface.rails[1], c.surface.rails[2]); },
            {"abs.rail order"});
        row("a wall profile", [](Case& c) { c.surface.walls[0].recess[1] = 0.6e-6; },
            {"abs.wall[1].recess[2] value 0.5 um to 0.6 um"});
        row("a point of interest", [](Case& c) { c.surface.pointsOfInterest[0].y = 0.4e-3; },
            {"abs.points_of_interest[1].y value 0.5 mm to 0.4 mm"});
    }
    void namesEachChange()
    {
        QFETCH(Change, change);
        QFETCH(QStringList, found);
        const Case before = filmCase();
        Case after = before;
        change(after);
        QCOMPARE(shown(caseChanges(before, after)), found);
    }

    void labelsNameRailAndCorner()
    {
        const Case before = filmCase();
        Case after = before;
        after.surface.rails[1].points[3].x = 0.25e-3;
        after.surface.rails[2].recess[0] = 0.2e-6;
        const auto changes = caseChanges(before, after);
        QCOMPARE(changes.size(), std::size_t(2));
        QCOMPARE(changes[0].label, std::string("rail 2, corner 4: x"));
        QCOMPARE(changes[1].label, std::string("rail 3: recess"));
    }

    /// What `--set` does with the key and the value of each change makes the second case out of the first one.
    void eachChangedValueCanBeSet()
    {
        std::size_t changed = 0;
        for (unsigned seed = 1; seed <= 40; ++seed) {
            test::RandomSurface draw(seed);
            Case before = filmCase();
            before.surface = draw.draw();
            before.surface.pointsOfInterest = {{1e-4, 2e-4}, {3e-4, 1e-4}};
            Case after = before;
            test::RandomCase(seed).change(after, 0.3);
            after.model = ModelKind::Film;
            changeNumbers(after.surface, draw);

            Case set = before;
            for (const CaseChange& change : caseChanges(before, after)) {
                QCOMPARE(change.kind, CaseChangeKind::Value);
                const auto found = caseKey(before, change.key);
                QVERIFY2(std::holds_alternative<Parameter>(found), change.key.c_str());
                const auto problem = setFromText(set, std::get<Parameter>(found), change.after);
                QVERIFY2(!problem, (change.key + ": " + problem.value_or("")).c_str());
                ++changed;
            }
            QVERIFY2(set.surface == after.surface, std::to_string(seed).c_str());
            QCOMPARE(shown(caseChanges(set, after)), QStringList());
        }
        QVERIFY(changed > 40 * 40); // at least 2 rails and 4 walls each, half of whose numbers change
    }

    /// The springs have no surface.
    void pointsThatMoveTogether()
    {
        const Case before = filmCase();
        AirBearingSurface after = before.surface;
        for (RailPoint& point : after.rails[1].points) point.x += 2e-6;
        after.rails[3].points[0].y -= 1e-6;
        after.rails[3].points[1].y -= 1e-6 + 2e-13; // the same to 1 pm
        after.rails[3].points[2].x += 3e-6;
        after.rails[2].points.pop_back(); // another number of points
        const std::vector<MovedPoints> moved = movedPoints(before.surface, after);
        QCOMPARE(moved.size(), std::size_t{3});
        QCOMPARE(moved[0].rail, std::size_t{1});
        QCOMPARE(moved[0].how, MovedPoints::How::Rail);
        QVERIFY(std::abs(moved[0].x - 2e-6) < 1e-15 && moved[0].y == 0.0);
        QCOMPARE(moved[1].points, (std::vector<std::size_t>{0, 1}));
        QCOMPARE(moved[1].how, MovedPoints::How::Points);
        QVERIFY(std::abs(moved[1].y + 1e-6) < 1e-15);
        QCOMPARE(moved[2].points, std::vector<std::size_t>{2});
        after.rails.pop_back(); // rails cannot be told apart by their number
        QVERIFY(movedPoints(before.surface, after).empty());
    }

    /// A trapezium whose slanted sides meet the upper edge: as the edge moves up by h, its ends follow the sides.
    void anEdgeThatMovesParallel()
    {
        AirBearingSurface before;
        before.rails = {{RailKind::Step, {{0.0, 0.0}, {4e-4, 0.0}, {3e-4, 1e-4}, {1e-4, 1e-4}}, {}}};
        AirBearingSurface after = before;
        constexpr double h = 2e-5; // both sides rise by 1 in 1
        after.rails[0].points[2] = {3e-4 - h, 1e-4 + h, 0};
        after.rails[0].points[3] = {1e-4 + h, 1e-4 + h, 0};
        std::vector<MovedPoints> moved = movedPoints(before, after);
        QCOMPARE(moved.size(), std::size_t{1});
        QCOMPARE(moved[0].how, MovedPoints::How::Edge);
        QCOMPARE(moved[0].points, (std::vector<std::size_t>{2, 3}));
        QVERIFY(std::abs(moved[0].x) < 1e-15 && std::abs(moved[0].y - h) < 1e-15);
        after.rails[0].points[3].y += 1e-6; // no longer parallel
        QCOMPARE(movedPoints(before, after).size(), std::size_t{2});
        after = before;
        after.rails[0].points[0].x -= h; // the edge from the last point to the first: along (1, 1), moved to the left
        after.rails[0].points[3].x -= h;
        after.rails[0].points[3].x -= 5e-6, after.rails[0].points[3].y -= 5e-6; // and along itself
        moved = movedPoints(before, after);
        QCOMPARE(moved[0].points, (std::vector<std::size_t>{3, 0}));
        QVERIFY(std::abs(moved[0].x + 0.5 * h) < 1e-15 && std::abs(moved[0].y - 0.5 * h) < 1e-15);
    }

    void aMirroredRail()
    {
        AirBearingSurface before;
        before.rails = {{RailKind::Step, {{0.0, 0.0}, {4e-4, 0.0}, {3e-4, 1e-4}}, {}}};
        AirBearingSurface after = before;
        for (RailPoint& point : after.rails[0].points) point.y = 1e-4 - point.y;
        const std::vector<MovedPoints> moved = movedPoints(before, after);
        QCOMPARE(moved.size(), std::size_t{1});
        QCOMPARE(moved[0].how, MovedPoints::How::Mirrored);
    }

    void leavesOutASurfaceThatIsNotUsed()
    {
        Case before = filmCase();
        before.model = ModelKind::Springs;
        Case after = before;
        after.surface.rails.clear();
        QVERIFY(after != before);
        QVERIFY(caseChanges(before, after).empty());
    }
};

TOUCHDOWN_TEST(TestCaseDifference)

} // namespace test_case_difference

#include "test_case_difference.moc"
