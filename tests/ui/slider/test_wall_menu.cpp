// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/wall_menu.h"

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_wall_menu {

class TestWallMenu : public QObject {
    Q_OBJECT

private slots:
    void offersAllWalls()
    {
        QMenu menu;
        int chosen = -1;
        fillWallMenu(menu, sampleSurface(), 2, [&](int wall) { chosen = wall; });
        const QList<QAction*> actions = menu.actions();
        QCOMPARE(actions.size(), 5); // the fourth is a line
        for (const int i : {0, 1, 2}) {
            QVERIFY(!actions[i]->icon().isNull());
            QCOMPARE(actions[i]->isChecked(), i == 2);
        }
        for (const int i : {0, 1, 2}) {
            actions[i]->trigger();
            QCOMPARE(chosen, i);
        }
        actions[4]->trigger();
        QCOMPARE(chosen, 3);
    }
    void whatEdgesHaveInCommon()
    {
        AirBearingSurface surface = sampleSurface();
        QCOMPARE(commonWall(surface, {{PartKind::Rail, 1}}), std::optional(2));
        QCOMPARE(commonWall(surface, {{PartKind::Rail, 0}, {PartKind::Edge, 1, 0}}), std::optional<int>());
        QCOMPARE(commonWall(surface, {{PartKind::Interest, 0}}), std::optional<int>());
        surface.rails[1].points[1].wall = 0;
        QCOMPARE(commonWall(surface, {{PartKind::Edge, 1, 1}}), std::optional(0));
        QCOMPARE(commonWall(surface, {{PartKind::Rail, 1}}), std::optional<int>());
    }
    void aNewWall()
    {
        const AirBearingSurface surface = withChosenWall(sampleSurface(), {{PartKind::Edge, 0, 1}}, 3);
        QCOMPARE(surface.walls.size(), std::size_t(3));
        QCOMPARE(surface.walls[2].recess, (std::vector{150e-9, 1.5e-6}));
        QCOMPARE(surface.rails[0].points[1].wall, 3);
        QCOMPARE(withChosenWall(sampleSurface(), {{PartKind::Edge, 0, 1}}, 2).walls.size(), std::size_t(2));
    }
};

TOUCHDOWN_TEST(TestWallMenu)

} // namespace test_wall_menu

#include "test_wall_menu.moc"
