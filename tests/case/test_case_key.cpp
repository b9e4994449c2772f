// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_key.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/formats/units.h"

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_case_key {

/// A key with its case.
struct Key {
    Parameter parameter;
    double get(const Case& c) const { return numberOf(parameter, c); }
    std::optional<std::string> set(Case& c, double value) const { return setFromNumber(c, parameter, value); }
};
Key key(const Case& c, const char* name)
{
    auto found = numberKey(c, name);
    if (const auto* problem = std::get_if<std::string>(&found)) qFatal("%s %s", name, problem->c_str());
    return {std::get<Parameter>(std::move(found))};
}

bool near(double a, double b) { return std::abs(a - b) < 1e-15; } // [m]

/// All numbers of the rails, walls and points of interest of a case.
std::vector<Parameter> surfaceNumbers(const Case& c)
{
    std::vector<Parameter> all;
    const auto add = [&](const std::string& key) {
        auto found = caseKey(c, key);
        if (auto* parameter = std::get_if<Parameter>(&found)) all.push_back(std::move(*parameter));
    };
    const auto at = [](const std::string& list, std::size_t i) { return list + '[' + std::to_string(i + 1) + ']'; };
    const AirBearingSurface& surface = c.surface;
    for (std::size_t i = 0; i < surface.rails.size(); ++i) {
        const std::string rail = at("abs.rail", i);
        for (const char* leaf : {".recess", ".x", ".y", ".length", ".width"}) add(rail + leaf);
        for (std::size_t k = 0; k < surface.rails[i].recess.size(); ++k) add(at(rail + ".recess", k));
        for (std::size_t k = 0; k < surface.rails[i].points.size(); ++k) {
            for (const char* axis : {".x", ".y"}) add(at(rail + ".point", k) + axis);
            add(at(rail + ".wall", k));
        }
    }
    for (std::size_t i = 0; i < surface.walls.size(); ++i) {
        const std::string wall = at("abs.wall", i);
        add(wall + ".shift");
        for (std::size_t k = 0; k < surface.walls[i].distance.size(); ++k) add(at(wall + ".distance", k));
        for (std::size_t k = 0; k < surface.walls[i].recess.size(); ++k) add(at(wall + ".recess", k));
    }
    for (std::size_t i = 0; i < surface.pointsOfInterest.size(); ++i)
        for (const char* axis : {".x", ".y"}) add(at("abs.points_of_interest", i) + axis);
    return all;
}

class TestCaseKey : public QObject {
    Q_OBJECT

private slots:
    void field()
    {
        Case c = test::smallSlider();
        const Key offset = key(c, "suspension.offset_x");
        QCOMPARE(offset.parameter.unit, std::string("m"));
        QCOMPARE(offset.get(c), 0.02e-3);
        QVERIFY(!offset.set(c, -0.01e-3));
        QCOMPARE(c.suspension.offsetX, -0.01e-3);
        const Key preload = key(c, "suspension.preload");
        const double before = c.suspension.preload;
        QVERIFY(preload.set(c, 1e9).has_value());
        QCOMPARE(c.suspension.preload, before);
    }
    /// The rear pad reaches from x = 0.88 to 0.97 mm and from y = 0.33 to 0.47 mm.
    void railIsMoved()
    {
        Case c = test::smallSlider();
        const Key x = key(c, "abs.rail[5].x");
        QVERIFY(near(x.get(c), 0.925e-3));
        QVERIFY(!x.set(c, 0.915e-3));
        QVERIFY(near(c.surface.rails[4].points[0].x, 0.87e-3) && near(c.surface.rails[4].points[1].x, 0.96e-3));
        QVERIFY(!key(c, "abs.rail[5].y").set(c, 0.41e-3));
        QVERIFY(near(c.surface.rails[4].points[0].y, 0.34e-3) && near(c.surface.rails[4].points[2].y, 0.48e-3));
    }
    void railIsStretched()
    {
        Case c = test::smallSlider();
        const Key width = key(c, "abs.rail[5].width");
        QVERIFY(near(width.get(c), 0.14e-3));
        QVERIFY(!width.set(c, 0.07e-3));
        QVERIFY(near(c.surface.rails[4].points[0].y, 0.365e-3) && near(c.surface.rails[4].points[2].y, 0.435e-3));
        QVERIFY(!key(c, "abs.rail[5].length").set(c, 0.18e-3));
        QVERIFY(near(c.surface.rails[4].points[0].x, 0.835e-3) && near(c.surface.rails[4].points[1].x, 1.015e-3));
        QVERIFY(width.set(c, 0.0).has_value());
        QVERIFY(near(width.get(c), 0.07e-3));
    }
    void recess()
    {
        Case c = test::smallSlider();
        QVERIFY(!key(c, "abs.rail[4].recess").set(c, 90e-9));
        QVERIFY(c.surface.rails[3].recess == (std::array{90e-9, 0.0, 0.0}));
    }
    /// A ramp from 300 to 50 nm, moved by 10 nm.
    void ramp()
    {
        Case c = test::smallSlider();
        c.surface.rails[0].kind = RailKind::Ramp;
        c.surface.rails[0].recess = {300e-9, 50e-9, 50e-9};
        QVERIFY(!key(c, "abs.rail[1].recess").set(c, 310e-9));
        QVERIFY(near(c.surface.rails[0].recess[1], 60e-9) && near(c.surface.rails[0].recess[2], 60e-9));
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("says");
        QTest::newRow("a slip of the pen") << "suspension.ofset_x"
                                           << "is no key of a case; did you mean suspension.offset_x?";
        QTest::newRow("a choice") << "film.grid"
                                  << "is no number with a range to search";
        QTest::newRow("of another model") << "springs.cutoff"
                                          << "has no part in this case";
        QTest::newRow("a rail that is not there") << "abs.rail[6].x"
                                                  << "there is no rail 6; the case has 5";
        QTest::newRow("rail 0") << "abs.rail[0].x"
                                << "there is no rail 0; the case has 5";
        QTest::newRow("no number") << "abs.rail[a].x"
                                   << "is none of the numbers abs.rail[N].recess, ";
        QTest::newRow("an open bracket") << "abs.rail[1"
                                         << "is none of the numbers ";
        QTest::newRow("points") << "abs.rail[1].points"
                                << "is none of the numbers ";
        QTest::newRow("a list of its own") << "abs.wall[1].x"
                                           << "is none of the numbers abs.wall[N].distance[K], ";
        QTest::newRow("a point that is not there") << "abs.rail[5].point[5].x"
                                                   << "there is no point 5; rail 5 has 4";
        QTest::newRow("point 0") << "abs.rail[5].point[0].x"
                                 << "is none of the numbers ";
        QTest::newRow("more") << "abs.rail[5].point[1].x.y"
                              << "is none of the numbers ";
        for (const char* twice : {"abs.rail[5].x.", "abs.rail[5].x..", "abs.rail[05].x", "abs.rail[5].point[01].x"})
            QTest::newRow(twice) << twice << "is none of the numbers ";
        QTest::newRow("the recess of a step") << "abs.rail[5].recess[2]"
                                              << "rail 5 is a step, which has one recess";
        QTest::newRow("a whole number") << "abs.rail[5].wall[2]"
                                        << "is no number with a range to search";
        QTest::newRow("no such point of interest") << "abs.points_of_interest[9].x"
                                                   << "there is no point of interest 9; the case has ";
    }
    void refuses()
    {
        QFETCH(QString, name);
        QFETCH(QString, says);
        const auto found = numberKey(test::smallSlider(), name.toStdString());
        QVERIFY(std::holds_alternative<std::string>(found));
        const QString told = QString::fromStdString(std::get<std::string>(found));
        QVERIFY2(told.startsWith(says), qPrintable(told));
        if (!says.endsWith(QLatin1Char(' '))) QCOMPARE(told, says);
    }

    /// Each number is found again under its name, takes a value within its range, and gives it back; the case is then
    /// another one. Setting its old value restores the case, but for rounding of a rail that was moved or stretched.
    void everyNumberOfTheSurface()
    {
        Case c = test::smallSlider();
        c.surface.rails[0].kind = RailKind::Ramp;
        c.surface.rails[0].recess = {300e-9, 50e-9, 50e-9};
        if (c.surface.walls.empty()) c.surface.walls.push_back({{0.0, 4e-6}, {0.0, 2e-6}});
        c.surface.pointsOfInterest = {{0.1e-3, 0.2e-3}, {0.3e-3, 0.4e-3}};
        const std::vector<Parameter> all = surfaceNumbers(c);
        std::size_t expected = 2 * 2;
        for (const Rail& rail : c.surface.rails)
            expected += 5 + 3 * rail.points.size() + (rail.kind == RailKind::Ramp ? 3 : 0);
        for (const WallProfile& wall : c.surface.walls) expected += 1 + 2 * wall.distance.size();
        QCOMPARE(all.size(), expected);
        for (const Parameter& parameter : all) {
            Case changed = c;
            const bool whole = parameter.kind == ParameterKind::Integer;
            const double before = numberOf(parameter, c), after = whole ? 1.0 - std::min(before, 1.0) : before + 1e-6;
            QVERIFY2(!setFromText(changed, parameter, formatNumber(after)), parameter.key.c_str());
            QVERIFY2(std::abs(numberOf(parameter, changed) - after) < 1e-15, parameter.key.c_str());
            QVERIFY2(!(changed == c), parameter.key.c_str());
            QVERIFY2(std::holds_alternative<Parameter>(caseKey(changed, parameter.key)), parameter.key.c_str());
            QVERIFY(!setFromText(changed, parameter, formatNumber(before)));
            QVERIFY2(std::abs(numberOf(parameter, changed) - before) < 1e-15, parameter.key.c_str());
        }
    }
    /// A corner, a wall of an edge and a profile, each alone.
    void oneNumberAlone()
    {
        const Case c = test::smallSlider();
        Case expected = c, changed = c;
        expected.surface.rails[4].points[2].y = 0.45e-3;
        QVERIFY(!key(c, "abs.rail[5].point[3].y").set(changed, 0.45e-3));
        QCOMPARE(changed == expected, true);
        Case walled = c;
        walled.surface.walls.assign(2, {{0.0, 4e-6}, {0.0, 2e-6}});
        expected = changed = walled;
        expected.surface.rails[4].points[1].wall = 2;
        QVERIFY(!setFromText(changed, std::get<Parameter>(caseKey(walled, "abs.rail[5].wall[2]")), "2"));
        QCOMPARE(changed == expected, true);
        QVERIFY(setFromText(changed, std::get<Parameter>(caseKey(walled, "abs.rail[5].wall[2]")), "3").has_value());
        QVERIFY(!key(walled, "abs.wall[2].shift").set(changed, -1e-6));
        QCOMPARE(changed.surface.walls[1].distance, (std::vector{-1e-6, 3e-6}));
        QCOMPARE(changed.surface.walls[0].distance, (std::vector{0.0, 4e-6}));
    }
};

TOUCHDOWN_TEST(TestCaseKey)

} // namespace test_case_key

#include "test_case_key.moc"
