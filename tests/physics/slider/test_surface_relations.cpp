// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_relations.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include <Eigen/Dense>
#include <QTest>

#include "core/physics/slider/surface_arrange.h"
#include "core/physics/slider/surface_symmetry.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_relations {

constexpr double width = 0.8e-3, um = 1e-6; // [m]
constexpr double exact = 1e-14;             // [m]

Rail box(double x0, double y0, double x1, double y1)
{
    return {RailKind::Step,
            {{x0 * um, y0 * um, 0}, {x1 * um, y0 * um, 0}, {x1 * um, y1 * um, 0}, {x0 * um, y1 * um, 0}},
            {}};
}
SurfacePart rail(std::size_t i) { return {PartKind::Rail, i}; }
SurfacePart edge(std::size_t i, std::size_t k) { return {PartKind::Edge, i, k}; }
SurfacePart corner(std::size_t i, std::size_t k) { return {PartKind::Corner, i, k}; }
bool near(double a, double b) { return std::abs(a - b) < exact; }

/// Edge 1 of a box has its largest x, edge 3 its least.
AirBearingSurface withKept(AirBearingSurface surface, const PartSelection& parts, bool alongX)
{
    const auto distance = drawnDistance(surface, parts, alongX);
    Q_ASSERT(distance);
    surface.distances.push_back(*distance);
    return surface;
}
AirBearingSurface dragged(const AirBearingSurface& surface, const PartSelection& parts, SurfaceShift by)
{
    return keepingRelations(surface, moved(surface, parts, by), width);
}
Rail shifted(Rail rail, double x, double y)
{
    for (RailPoint& p : rail.points) p.x += x * um, p.y += y * um;
    return rail;
}
bool same(const Rail& a, const Rail& b)
{
    return std::ranges::equal(a.points, b.points,
                              [](const RailPoint& p, const RailPoint& q) { return near(p.x, q.x) && near(p.y, q.y); });
}

/// A shape with relations that it obeys, and what they are, as equations.
struct Drawn {
    AirBearingSurface surface;
    std::vector<std::vector<std::size_t>> orders; // of the corners of mirror images

    std::size_t first(std::size_t rail) const
    {
        std::size_t number = 0;
        for (std::size_t i = 0; i < rail; ++i) number += surface.rails[i].points.size();
        return number;
    }
    std::size_t count() const { return first(surface.rails.size()); }
    std::vector<std::size_t> numbers(const RailPlace& place) const
    {
        std::vector<std::size_t> all{first(place.rail) + place.corner};
        if (place.edge) all.push_back(first(place.rail) + (place.corner + 1) % surface.rails[place.rail].points.size());
        return all;
    }
};

class Pen {
public:
    explicit Pen(unsigned seed) : engine_(seed) {}
    std::size_t below(std::size_t count) { return engine_() % count; }
    double between(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low))); }

    SurfacePart part(const AirBearingSurface& surface)
    {
        const std::size_t i = below(surface.rails.size()), k = below(surface.rails[i].points.size());
        return std::array{rail(i), edge(i, k), corner(i, k)}[below(3)];
    }

    /// Boxes and slanted rails anywhere, symmetric rails, pairs, and distances between any of them.
    Drawn draw()
    {
        Drawn drawn;
        AirBearingSurface& surface = drawn.surface;
        for (std::size_t i = 2 + below(4); i > 0; --i) {
            const double x = between(0, 900), y = between(0, 300), a = between(5, 60), b = between(5, 60);
            if (below(3) > 0)
                surface.rails.push_back(box(x, y, x + a, y + b));
            else
                surface.rails.push_back({RailKind::Step,
                                         {{x * um, y * um}, {(x + a) * um, (y + 3) * um}, {(x + 2) * um, (y + b) * um}},
                                         {}});
        }
        if (below(2) == 0) {
            const double x = between(0, 900), a = between(5, 60), b = between(5, 60);
            surface.rails.push_back(box(x, 400 - b, x + a, 400 + b));
            surface.symmetries.push_back({surface.rails.size() - 1, surface.rails.size() - 1});
            drawn.orders.push_back({3, 2, 1, 0});
        }
        if (below(2) == 0) {
            const std::size_t original = below(2);
            surface = withMirroredCopies(std::move(surface), {rail(original)}, width);
            surface.symmetries.push_back({original, surface.rails.size() - 1});
            drawn.orders.push_back({0, 1, 2, 3});
            drawn.orders.back().resize(surface.rails[original].points.size());
        }
        for (std::size_t i = below(6); i > 0; --i)
            if (const auto kept = drawnDistance(surface, {part(surface), part(surface)}, below(2) == 0))
                if (!(kept->from == kept->to)) surface.distances.push_back(*kept);
        return drawn;
    }

private:
    std::mt19937 engine_;
};

using Rows = std::vector<std::vector<std::pair<std::size_t, double>>>; // the last one of each is the right side

Rows equationsOf(const Drawn& drawn, bool alongX)
{
    Rows rows;
    const std::size_t right = drawn.count();
    for (std::size_t i = 0; i < drawn.orders.size(); ++i) {
        const auto [one, other] = drawn.surface.symmetries[i];
        for (std::size_t k = 0; k < drawn.orders[i].size(); ++k) {
            const std::size_t a = drawn.first(one) + k, b = drawn.first(other) + drawn.orders[i][k];
            rows.push_back({{a, alongX ? -1.0 : 1.0}, {b, 1.0}, {right, alongX ? 0.0 : width}});
        }
    }
    for (const KeptDistance& each : drawn.surface.distances)
        if (each.alongX == alongX)
            for (const std::size_t a : drawn.numbers(each.from))
                for (const std::size_t b : drawn.numbers(each.to))
                    rows.push_back({{a, -1.0}, {b, 1.0}, {right, each.value}});
    return rows;
}

/// Whether the equations have a solution where these places are as in `wanted`, and each rail in `rigid` is as there
/// but for a shift. By least squares in µm, independent of the trees.
bool feasible(const Drawn& drawn, const AirBearingSurface& wanted, const std::set<std::size_t>& fixed,
              const std::set<std::size_t>& rigid, bool alongX)
{
    const auto rows = equationsOf(drawn, alongX);
    const auto unknowns = static_cast<Eigen::Index>(drawn.count() + wanted.rails.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size() + 2 * drawn.count()), unknowns);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(a.rows());
    Eigen::Index row = 0;
    for (const auto& each : rows) {
        for (const auto& [number, factor] : each)
            if (number == drawn.count())
                b[row] = factor / um;
            else
                a(row, static_cast<Eigen::Index>(number)) += factor;
        ++row;
    }
    for (std::size_t i = 0; i < wanted.rails.size(); ++i)
        for (std::size_t k = 0; k < wanted.rails[i].points.size(); ++k) {
            const std::size_t number = drawn.first(i) + k;
            const RailPoint& p = wanted.rails[i].points[k];
            if (!fixed.contains(number) && !rigid.contains(i)) continue;
            a(row, static_cast<Eigen::Index>(number)) = 1.0;
            if (!fixed.contains(number)) a(row, static_cast<Eigen::Index>(drawn.count() + i)) = -1.0;
            b[row++] = (alongX ? p.x : p.y) / um;
        }
    const Eigen::VectorXd solution = a.topRows(row).completeOrthogonalDecomposition().solve(b.head(row));
    return row == 0 || (a.topRows(row) * solution - b.head(row)).norm() < 1e-6;
}

class TestSurfaceRelations : public QObject {
    Q_OBJECT

private slots:
    /// Boxes 20 µm wide with gaps of 80 µm, in a chain: one is dragged by (10, 7) µm and the others follow along x.
    void aChainFollows()
    {
        AirBearingSurface surface;
        for (int i = 0; i < 4; ++i) surface.rails.push_back(box(100 * i, 10 * i, 100 * i + 20, 10 * i + 50));
        const AirBearingSurface free = surface;
        for (std::size_t i = 0; i < 3; ++i) surface = withKept(surface, {rail(i), rail(i + 1)}, true);
        QVERIFY(near(surface.distances[1].value, 80 * um) && surface.distances[1].from.rail == 1);
        QVERIFY(relationProblems(surface, width).empty());
        const AirBearingSurface after = dragged(surface, {rail(1)}, {10 * um, 7 * um});
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(same(after.rails[i], shifted(free.rails[i], 10, i == 1 ? 7 : 0)));
        QVERIFY(keepingRelations(after, after, width) == after);
        // The second gap becomes 100 µm: what is behind it moves.
        const AirBearingSurface wider = withDistance(surface, 1, 100 * um, width);
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(same(wider.rails[i], shifted(free.rails[i], i > 1 ? 20 : 0, 0)));
    }

    /// The width of a box stays when one of its edges is dragged: the opposite edge follows, upright to the bit.
    void anEdgeFollowsItsEdge()
    {
        AirBearingSurface surface;
        surface.rails = {box(100, 100, 150, 200), box(300, 0, 333.3, 70)};
        surface = withKept(surface, {edge(0, 1), edge(0, 3)}, true);
        QVERIFY(near(surface.distances[0].value, 50 * um));
        QVERIFY(surface.distances[0].from == (RailPlace{0, 3, true}));
        QVERIFY(surface.distances[0].to == (RailPlace{0, 1, true}));
        AirBearingSurface after = dragged(surface, {edge(0, 1)}, {10 * um, 0.0});
        QVERIFY(same(after.rails[0], box(110, 100, 160, 200)) && after.rails[1] == surface.rails[1]);
        after = dragged(surface, {corner(0, 1)}, {0.1234567890123 * um, 5 * um}); // the edge stays upright
        QCOMPARE(after.rails[0].points[1].x, after.rails[0].points[2].x);
        QCOMPARE(after.rails[0].points[0].x, after.rails[0].points[3].x);
        QVERIFY(near(after.rails[0].points[1].y, 105 * um) && after.rails[0].points[0].y == 100 * um);
        after = withDistance(surface, 0, 70 * um, width);
        QVERIFY(same(after.rails[0], box(100, 100, 170, 200)));
    }

    void mirrorImagesFollow()
    {
        AirBearingSurface surface;
        surface.rails = {box(100, 100, 150, 200)};
        surface = withMirroredCopies(surface, {rail(0)}, width);
        surface.rails.push_back(box(500, 300, 600, 500));
        surface = withSymmetry(withSymmetry(surface, {0, 1}, width), {2, 2}, width);
        QVERIFY(same(surface.rails[1], box(100, 700, 150, 600)));
        AirBearingSurface after = dragged(surface, {rail(1)}, {10 * um, 5 * um});
        QVERIFY(same(after.rails[0], box(110, 95, 160, 195)));
        after = dragged(surface, {corner(1, 2)}, {3 * um, 4 * um});
        QVERIFY(near(after.rails[0].points[2].x, 153 * um) && near(after.rails[0].points[2].y, 196 * um));
        after = dragged(surface, {rail(2)}, {10 * um, 5 * um}); // it stays on the centre line
        QVERIFY(same(after.rails[2], box(510, 300, 610, 500)) && after.rails[0] == surface.rails[0]);
        // A pair with a distance: both move.
        surface = withKept(surface, {rail(0), rail(1)}, false);
        QVERIFY(near(surface.distances[0].value, 400 * um));
        after = withDistance(surface, 0, 300 * um, width);
        QVERIFY(same(after.rails[0], box(100, 150, 150, 250)) && same(after.rails[1], box(100, 650, 150, 550)));
    }

    /// Boxes at 0 and 100 µm: the second of two distances wants 7 µm more. As drawn the shape obeys the first.
    void namesContradictions()
    {
        AirBearingSurface surface;
        surface.rails = {box(0, 0, 20, 50), box(100, 0, 120, 50), box(300, 0, 320, 50)};
        surface = withKept(surface, {edge(0, 1), edge(1, 3)}, true);
        surface = withKept(surface, {corner(0, 1), corner(1, 0)}, true);
        surface = withKept(surface, {rail(1), rail(2)}, true);
        surface.distances[1].value += 7 * um;
        const auto problems = relationProblems(surface, width);
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(problems[0].key, std::string("abs.distance[2]"));
        QVERIFY(problems[0].sentence.find("contradicts the relations before it by 7000 nm") != std::string::npos);
        const AirBearingSurface drawn = moved(surface, {rail(2)}, {9 * um, 0.0});
        QVERIFY(keepingRelations(surface, drawn, width) == drawn);
        // Alone the second one is not obeyed until an edit solves it.
        surface.distances.erase(surface.distances.begin());
        QVERIFY(relationProblems(surface, width).at(0).sentence.find("is off by 7000 nm") != std::string::npos);
        QVERIFY(keepingRelations(surface, surface, width) == surface);
        const AirBearingSurface after = dragged(surface, {rail(0)}, {1 * um, 0.0});
        QVERIFY(same(after.rails[1], box(108, 0, 128, 50)) && same(after.rails[2], box(308, 0, 328, 50)));
    }

    /// 300 shapes: after an edit all relations hold; what was moved stays, and other rails follow as a whole, wherever
    /// least squares find such a shape; rails that are not connected keep their bits.
    void drawnShapes()
    {
        int kept = 0, followed = 0, restricted = 0;
        for (unsigned seed = 0; seed < 300; ++seed) {
            Pen pen(seed);
            const Drawn drawn = pen.draw();
            const AirBearingSurface& before = drawn.surface;
            QVERIFY2(relationProblems(before, width).empty(), qPrintable(QString::number(seed)));
            const PartSelection parts{pen.part(before)};
            const AirBearingSurface wanted =
                moved(before, parts, {pen.between(-50, 50) * um, pen.between(-50, 50) * um});
            const AirBearingSurface after = keepingRelations(before, wanted, width);
            const auto problems = relationProblems(after, width);
            QVERIFY2(problems.empty(), problems.empty() ? "" : problems[0].sentence.c_str());
            QVERIFY(keepingRelations(before, after, width) == after);

            std::set<std::size_t> fixed, free, connected{parts.begin()->item};
            for (std::size_t i = 0; i < before.rails.size(); ++i)
                for (std::size_t k = 0; k < before.rails[i].points.size(); ++k)
                    if (wanted.rails[i].points[k] != before.rails[i].points[k]) fixed.insert(drawn.first(i) + k);
            for (std::size_t round = 0; round < before.rails.size(); ++round) {
                const auto join = [&](std::size_t a, std::size_t b) {
                    if (connected.contains(a) || connected.contains(b)) connected.insert({a, b});
                };
                for (const KeptDistance& each : before.distances) join(each.from.rail, each.to.rail);
                for (const KeptSymmetry& each : before.symmetries) join(each.rail, each.image);
            }
            for (std::size_t i = 0; i < before.rails.size(); ++i) {
                if (!connected.contains(i)) QVERIFY(after.rails[i] == before.rails[i]);
                if (i != parts.begin()->item) free.insert(i);
            }
            for (const bool alongX : {true, false}) {
                const auto place = [alongX](const AirBearingSurface& s, std::size_t i, std::size_t k) {
                    return alongX ? s.rails[i].points[k].x : s.rails[i].points[k].y;
                };
                const bool canStay = feasible(drawn, wanted, fixed, {}, alongX);
                const bool canFollow = canStay && feasible(drawn, wanted, fixed, free, alongX);
                canFollow ? ++followed : canStay ? ++kept : ++restricted;
                for (std::size_t i = 0; i < before.rails.size(); ++i)
                    for (std::size_t k = 0; k < before.rails[i].points.size(); ++k) {
                        const double shift = place(after, i, k) - place(wanted, i, k);
                        if (canStay && fixed.contains(drawn.first(i) + k)) QVERIFY(std::abs(shift) < exact);
                        if (canFollow && free.contains(i))
                            QVERIFY(near(shift, place(after, i, 0) - place(wanted, i, 0)));
                    }
            }
        }
        QVERIFY2(followed > 300 && kept > 10 && restricted > 10,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(followed).arg(kept).arg(restricted)));
    }

    /// Relations stay with their corners, found by their places, through edits that number corners anew.
    void staysWithItsCorners()
    {
        using Places = std::vector<std::tuple<double, double, double, double, bool>>;
        const auto placesOf = [](const AirBearingSurface& surface) {
            Places places;
            for (const KeptDistance& each : surface.distances) {
                const RailPoint& a = surface.rails.at(each.from.rail).points.at(each.from.corner);
                const RailPoint& b = surface.rails.at(each.to.rail).points.at(each.to.corner);
                places.emplace_back(a.x, a.y, b.x, b.y, each.alongX);
            }
            for (const KeptSymmetry& each : surface.symmetries) {
                const RailPoint& a = surface.rails.at(each.rail).points.front();
                places.emplace_back(a.x, a.y, 0.0, 0.0, surface.rails.at(each.image).points.size() > 3);
            }
            return places;
        };
        int lost = 0, stayed = 0;
        for (unsigned seed = 1000; seed < 1300; ++seed) {
            Pen pen(seed);
            const AirBearingSurface before = pen.draw().surface;
            const PartSelection parts{pen.part(before)}, whole{rail(parts.begin()->item)};
            const std::size_t one = parts.begin()->item, place = pen.below(before.rails.size());
            const RailPoint &a = before.rails[one].points[0], &b = before.rails[one].points[1];
            const AirBearingSurface edits[] = {withCorner(before, one, 0, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}),
                                               without(before, parts),
                                               reordered(before, one, place),
                                               withCopies(before, whole, {1 * um, 1 * um}),
                                               withArray(before, whole, 2, {1 * um, 1 * um}),
                                               withMirroredCopies(before, whole, width),
                                               madeSymmetric(before, whole, width, 1e-7)};
            const Places then = placesOf(before);
            for (const AirBearingSurface& after : edits) {
                for (const auto& each : placesOf(after)) QVERIFY(std::ranges::find(then, each) != then.end());
                QVERIFY(relationProblems(after, width).empty());
                // What concerns other rails alone stays.
                const auto concerned = [&](const KeptDistance& each) {
                    return each.from.rail == one || each.to.rail == one;
                };
                const auto others = before.distances.size() -
                                    static_cast<std::size_t>(std::ranges::count_if(before.distances, concerned));
                QVERIFY(after.distances.size() >= others);
                stayed += static_cast<int>(after.distances.size());
                lost += static_cast<int>(before.distances.size() - after.distances.size());
            }
            for (const std::size_t same : {2, 3, 4, 5}) QVERIFY(placesOf(edits[same]).size() == then.size());
            QVERIFY(edits[0].distances.size() == before.distances.size());
        }
        QVERIFY2(lost > 30 && stayed > 2000, qPrintable(QStringLiteral("%1 %2").arg(lost).arg(stayed)));
        AirBearingSurface surface;
        surface.rails = {box(0, 0, 20, 50), box(100, 0, 120, 50)};
        surface = withKept(surface, {rail(0), rail(1)}, true);
        surface.symmetries = {{0, 0}};
        QVERIFY(without(surface, {{PartKind::Distance, 0}}).distances.empty());
        QVERIFY(without(surface, {{PartKind::Symmetry, 0}}).symmetries.empty());
        QVERIFY(withCorner(surface, 0, 0, {10 * um, 0.0}).symmetries.empty()); // its corners are others
    }

    void whatIsOffered()
    {
        AirBearingSurface surface;
        surface.rails = {box(0, 0, 20, 50), box(100, 200, 120, 250)};
        surface.rails[1].points[2].x += 5 * um; // edge 1 is slanted
        QVERIFY(!drawnDistance(surface, {edge(0, 1), edge(1, 1)}, true));
        QVERIFY(!drawnDistance(surface, {edge(0, 1), edge(1, 3)}, false));
        QVERIFY(!drawnDistance(surface, {rail(0)}, true) && !drawnDistance(surface, {rail(0), rail(7)}, true));
        // A rail and one of its own edges: the edge opposite, not the edge itself.
        const auto own = drawnDistance(surface, {rail(0), edge(0, 1)}, true);
        QVERIFY(own && !(own->from == own->to) && near(own->value, 20 * um));
        QVERIFY(*drawnDistance(surface, {rail(0), rail(1)}, false) ==
                (KeptDistance{{0, 2, true}, {1, 0, true}, false, 150 * um}));
    }
};

TOUCHDOWN_TEST(TestSurfaceRelations)

} // namespace test_surface_relations

#include "test_surface_relations.moc"
