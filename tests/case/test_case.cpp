// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case.h"

#include "core/case/parameters.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace touchdown;

namespace test_case {

class TestCase : public QObject {
    Q_OBJECT

private slots:
    void differsInEachParameter_data()
    {
        QTest::addColumn<QString>("key");
        for (const Parameter& parameter : parameters())
            QTest::newRow(parameter.key.c_str()) << QString::fromStdString(parameter.key);
    }
    void differsInEachParameter()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        Case drawn;
        test::RandomCase random(7);
        // A value of a narrow range can be drawn that is the default.
        for (int i = 0; i < 100 && parameter.get(drawn) == parameter.get(Case{}); ++i) random.change(drawn, 1.0);
        Case changed;
        parameter.set(changed, parameter.get(drawn));
        QVERIFY(changed != Case{});
        parameter.set(changed, parameter.get(Case{}));
        QVERIFY(changed == Case{});
    }

    void differsInRailsWallsAndPoints_data()
    {
        QTest::addColumn<int>("what");
        const QStringList rows{
            "rail",        "recess", "second recess of a ramp", "corner",      "wall of an edge", "wall",
            "wall recess", "order",  "point of interest",       "kind of rail"};
        for (int i = 0; i < rows.size(); ++i) QTest::newRow(qPrintable(rows[i])) << i;
    }
    void differsInRailsWallsAndPoints()
    {
        QFETCH(int, what);
        Case c;
        const Rail rail{RailKind::Ramp, {{0.0, 0.0, 1}, {1e-3, 0.0, 1}, {1e-3, 1e-3, 1}}, {1e-7, 2e-7, 3e-7}};
        c.surface.rails = {rail, rail};
        c.surface.rails[1].recess[0] = 0.0;
        c.surface.walls = {{{0.0, 1e-6}, {0.0, 1e-6}}};
        c.surface.pointsOfInterest = {{1e-3, 1e-3}};
        const Case before = c;
        QVERIFY(c == before);
        AirBearingSurface& s = c.surface;
        switch (what) {
        case 0: s.rails.pop_back(); break;
        case 1: s.rails[1].recess[0] = 1e-9; break;
        case 2: s.rails[1].recess[1] = 1e-9; break;
        case 3: s.rails[0].points[2].y = 0.9e-3; break;
        case 4: s.rails[0].points[2].wall = 0; break;
        case 5: s.walls.push_back(s.walls[0]); break;
        case 6: s.walls[0].recess[1] = 2e-6; break;
        case 7: std::swap(s.rails[0], s.rails[1]); break;
        case 8: s.pointsOfInterest[0].x = 0.0; break;
        case 9: s.rails[0].kind = RailKind::Step; break;
        }
        QVERIFY(c != before);
    }

    /// A relative name of a file means another file in another folder.
    void differsInItsFolder()
    {
        Case c;
        c.folder = "/elsewhere";
        QVERIFY(c != Case{});
    }
};

TOUCHDOWN_TEST(TestCase)

} // namespace test_case

#include "test_case.moc"
