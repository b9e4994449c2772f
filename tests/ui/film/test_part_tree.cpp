// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/part_tree.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_part_tree {

class TestPartTree : public QObject {
    Q_OBJECT

private slots:
    /// Four rails, the second of which is dragged: in the upper half of a row it goes before that one, in the lower
    /// half behind it. It cannot go among the walls.
    void placesOfADrop()
    {
        PartTree tree;
        tree.resize(200, 300);
        auto* rails = new QTreeWidgetItem(&tree, {QStringLiteral("Rails")});
        auto* walls = new QTreeWidgetItem(&tree, {QStringLiteral("Walls")});
        for (int i = 0; i < 4; ++i) new QTreeWidgetItem(rails, {QString::number(i)});
        auto* wall = new QTreeWidgetItem(walls, {QStringLiteral("Wall 1")});
        tree.expandAll();
        tree.show();
        QVERIFY(QTest::qWaitForWindowExposed(&tree));
        tree.setCurrentItem(rails->child(1));
        const auto upper = [&](QTreeWidgetItem* item) {
            return tree.placeAt(tree.visualItemRect(item).center() - QPoint(0, 4));
        };
        const auto lower = [&](QTreeWidgetItem* item) {
            return tree.placeAt(tree.visualItemRect(item).center() + QPoint(0, 4));
        };
        QCOMPARE(upper(rails->child(0)), 0);
        QCOMPARE(lower(rails->child(0)), 1);
        QCOMPARE(upper(rails->child(1)), 1);
        QCOMPARE(lower(rails->child(1)), 1);
        QCOMPARE(upper(rails->child(2)), 1);
        QCOMPARE(lower(rails->child(2)), 2);
        QCOMPARE(lower(rails->child(3)), 3);
        QCOMPARE(upper(rails), 0);
        QCOMPARE(upper(wall), -1);
        QCOMPARE(tree.placeAt({100, 290}), -1); // below all
        tree.setCurrentItem(wall);
        QCOMPARE(upper(rails->child(0)), -1);
    }
};

TOUCHDOWN_TEST(TestPartTree)

} // namespace test_part_tree

#include "test_part_tree.moc"
