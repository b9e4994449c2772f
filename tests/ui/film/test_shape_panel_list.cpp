// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kept distances and symmetries in the list of parts, and the number of a distance.
#include <cmath>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/case/case_edits.h"
#include "ui/film/shape_panel.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_shape_panel_list {

class TestShapePanelList : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }

    /// Edge 2 of rail 2 is at 0.4 mm, edge 4 of rail 3 at 0.55 mm: with 200 µm rail 3 moves by 50 µm.
    void listsKeptDistances()
    {
        CaseEdits edits;
        ShapePanel panel;
        connect(&edits, &CaseEdits::edited, &panel, [&] { panel.setCase(edits.value()); });
        connect(&panel, &ShapePanel::edited, &edits, &CaseEdits::setSurface);
        const Case first = sampleFilmCase();
        edits.open(first);
        auto* list = panel.findChild<QTreeWidget*>();
        auto* table = panel.findChild<QTableWidget*>();
        panel.resize(800, 300);
        panel.show();
        QVERIFY(list->topLevelItem(3)->isHidden());
        AirBearingSurface surface = first.surface;
        surface.distances = {{{1, 1, true}, {2, 3, true}, true, 150e-6}};
        surface.symmetries = {{0, 0}};
        edits.setSurface(surface, {});
        const QTreeWidgetItem* group = list->topLevelItem(3);
        QVERIFY(!group->isHidden());
        QCOMPARE(group->child(0)->text(0), QStringLiteral("Rail 3 stays 150 µm from rail 2 along x"));
        QCOMPARE(group->child(1)->text(0), QStringLiteral("Rail 1 stays symmetric"));
        QSignalSpy selected(&panel, &ShapePanel::selected);
        list->setCurrentItem(group->child(1));
        QCOMPARE(selected.back().front().value<PartSelection>(), (PartSelection{{PartKind::Symmetry, 0}}));
        panel.setSelection({{PartKind::Distance, 0}});
        QVERIFY(group->child(0)->isSelected());
        QCOMPARE(table->item(0, 0)->text(), QStringLiteral("150"));
        table->item(0, 0)->setText(QStringLiteral("0.2 mm"));
        QVERIFY(std::abs(edits.value().surface.rails[2].points[0].x - 0.6e-3) < 1e-14);
        QCOMPARE(edits.value().surface.rails[1], first.surface.rails[1]);
        QCOMPARE(group->child(0)->text(0), QStringLiteral("Rail 3 stays 200 µm from rail 2 along x"));
        panel.setSelection({{PartKind::Rail, 2}});
        table->item(3, 0)->setText(QStringLiteral("0.7")); // a corner of edge 4
        QCOMPARE(edits.value().surface.rails[2].points[0].x, 0.7e-3);
        QVERIFY(std::abs(edits.value().surface.rails[1].points[1].x - 0.5e-3) < 1e-14);
        surface = edits.value().surface;
        surface.distances[0].value = 1e-6;
        edits.setSurface(surface, {});
        QCOMPARE(group->child(0)->foreground(0).color(), meaningColours(panel.palette()).failure);
        panel.setSelection({{PartKind::Distance, 0}});
        QTest::keyClick(list, Qt::Key_Delete);
        QVERIFY(edits.value().surface.distances.empty() && group->childCount() == 1);
    }
};

TOUCHDOWN_TEST(TestShapePanelList)

} // namespace test_shape_panel_list

#include "test_shape_panel_list.moc"
