// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/shape_panel.h"

#include <cmath>
#include <memory>

#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QStyledItemDelegate>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/case/case_edits.h"
#include "ui/film/part_tree.h"
#include "ui/slider/wall_picture.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_shape_panel {

class TestShapePanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }
    void init()
    {
        case_ = sampleFilmCase();
        edits_ = std::make_unique<CaseEdits>();
        panel_ = std::make_unique<ShapePanel>();
        connect(edits_.get(), &CaseEdits::edited, panel_.get(), [this] { panel_->setCase(edits_->value()); });
        connect(panel_.get(), &ShapePanel::edited, edits_.get(), &CaseEdits::setSurface);
        edits_->open(case_);
        list_ = panel_->findChild<QTreeWidget*>();
        table_ = panel_->findChild<QTableWidget*>();
        panel_->resize(800, 300);
        panel_->show();
    }

    void listsAllParts()
    {
        QCOMPARE(list_->topLevelItem(0)->text(0), QStringLiteral("Rails (4)"));
        QCOMPARE(list_->topLevelItem(0)->child(0)->text(1), QStringLiteral("0.15"));
        QCOMPARE(list_->topLevelItem(0)->child(3)->text(2), QStringLiteral("5"));
        QCOMPARE(list_->topLevelItem(1)->childCount(), 2);
        QCOMPARE(list_->topLevelItem(2)->childCount(), 3);
    }
    void theSelectionIsShared()
    {
        QSignalSpy selected(panel_.get(), &ShapePanel::selected);
        panel_->setSelection({{PartKind::Corner, 3, 2}});
        QCOMPARE(selected.count(), 0);
        QVERIFY(list_->topLevelItem(0)->child(3)->isSelected());
        QCOMPARE(table_->rowCount(), 5);
        QCOMPARE(table_->item(2, 1)->text(), QStringLiteral("0.4"));
        QVERIFY(table_->item(2, 0)->isSelected());
        list_->setCurrentItem(list_->topLevelItem(0)->child(1));
        QCOMPARE(selected.back().front().value<PartSelection>(), (PartSelection{{PartKind::Rail, 1}}));
        QCOMPARE(table_->rowCount(), 4);
        table_->item(3, 1)->setSelected(true);
        QCOMPARE(selected.back().front().value<PartSelection>(), (PartSelection{{PartKind::Corner, 1, 3}}));
    }
    /// In the unit of the column, or with one of its own.
    void numbersAreTyped()
    {
        panel_->setSelection({{PartKind::Rail, 1}});
        table_->item(0, 0)->setText(QStringLiteral("0.16"));
        QCOMPARE(edits_->value().surface.rails[1].points[0].x, 0.16e-3);
        table_->item(0, 1)->setText(QStringLiteral("120 um"));
        QCOMPARE(edits_->value().surface.rails[1].points[0].y, 120e-6);
        QCOMPARE(table_->item(0, 1)->text(), QStringLiteral("0.12"));
        table_->item(2, 2)->setText(QStringLiteral("1"));
        QCOMPARE(edits_->value().surface.rails[1].points[2].wall, 1);
        list_->topLevelItem(0)->child(1)->setText(1, QStringLiteral("0.02"));
        QCOMPARE(edits_->value().surface.rails[1].recess[0], 0.02e-6);
        QCOMPARE(edits_->undoStack().count(), 4);
        for (int i = 0; i < 4; ++i) edits_->undoStack().undo();
        QVERIFY(edits_->value() == case_);
        QCOMPARE(table_->item(0, 0)->text(), QStringLiteral("0.15"));
    }
    /// What is typed for one of several rails, or corners, is that of all of them, as one edit.
    void severalAtOnce()
    {
        panel_->setSelection({{PartKind::Rail, 0}, {PartKind::Rail, 2}});
        list_->topLevelItem(0)->child(2)->setText(1, QStringLiteral("0.02"));
        const auto& rails = edits_->value().surface.rails;
        for (const std::size_t i : {std::size_t(0), std::size_t(2)}) QCOMPARE(rails[i].recess[0], 0.02e-6);
        QCOMPARE(rails[1].recess[0], case_.surface.rails[1].recess[0]);
        QCOMPARE(edits_->undoStack().count(), 1);
        list_->topLevelItem(0)->child(1)->setText(1, QStringLiteral("0.03")); // not one of the chosen ones
        QCOMPARE(rails[0].recess[0], 0.02e-6);
        panel_->setSelection({{PartKind::Corner, 1, 0}, {PartKind::Corner, 1, 2}});
        table_->item(2, 2)->setText(QStringLiteral("0"));
        for (std::size_t k = 0; k < 4; ++k)
            QCOMPARE(rails[1].points[k].wall, k % 2 == 0 ? 0 : case_.surface.rails[1].points[k].wall);
        QCOMPARE(edits_->undoStack().count(), 3);
        panel_->setSelection({{PartKind::Rail, 0}, {PartKind::Rail, 2}});
        for (QToolButton* button : panel_->findChildren<QToolButton*>())
            if (button->text() == QStringLiteral("Wall…")) button->click();
        QMenu* menu = panel_->findChild<QMenu*>();
        QVERIFY(menu != nullptr);
        menu->actions().front()->trigger(); // none
        for (const std::size_t i : {std::size_t(0), std::size_t(2)})
            for (const RailPoint& point : rails[i].points) QCOMPARE(point.wall, 0);
        QCOMPARE(edits_->undoStack().count(), 4);
        edits_->undoStack().setIndex(0);
        QVERIFY(edits_->value() == case_);
    }
    void aDragIsFollowed()
    {
        panel_->setSelection({{PartKind::Rail, 1}});
        panel_->preview(moved(case_.surface, {{PartKind::Rail, 1}}, {10e-6, 0.0}));
        QCOMPARE(table_->item(0, 0)->text(), QStringLiteral("0.16"));
        QCOMPARE(edits_->undoStack().count(), 0);
        panel_->preview(case_.surface);
        QCOMPARE(table_->item(0, 0)->text(), QStringLiteral("0.15"));
    }
    /// An edge that slides along others leaves coordinates of many digits.
    void showsSevenDigits()
    {
        panel_->setSelection({{PartKind::Rail, 1}});
        table_->item(0, 0)->setText(QStringLiteral("0.123456789012"));
        const auto* delegate = qobject_cast<QStyledItemDelegate*>(table_->itemDelegate());
        QCOMPARE(table_->item(0, 0)->text(), QStringLiteral("0.123456789012"));
        QCOMPARE(delegate->displayText(table_->item(0, 0)->text(), QLocale()), QStringLiteral("0.1234568"));
        QCOMPARE(delegate->displayText(QStringLiteral("0.15"), QLocale()), QStringLiteral("0.15"));
    }
    void aWrongNumberIsRefused()
    {
        panel_->setSelection({{PartKind::Rail, 1}});
        for (const auto& [column, text, reason] : {std::tuple(0, "2 mN", "Rail 2, corner 1, x: "),
                                                   std::tuple(0, "wide", "wide"), std::tuple(2, "7", "at most 2")}) {
            table_->item(0, column)->setText(QString::fromUtf8(text));
            QVERIFY(edits_->value() == case_);
            QCOMPARE(table_->item(0, 0)->text(), QStringLiteral("0.15"));
            bool told = false;
            for (const QLabel* label : panel_->findChildren<QLabel*>())
                told = told || (label->isVisible() && label->text().contains(QString::fromUtf8(reason)));
            QVERIFY2(told, text);
        }
        table_->item(0, 0)->setText(QStringLiteral("0.16"));
        for (const QLabel* label : panel_->findChildren<QLabel*>())
            QVERIFY(!label->isVisible() || !label->text().contains(QStringLiteral("out of range")));
    }
    void lengthsAndAnglesAreOnlyShown()
    {
        panel_->setSelection({{PartKind::Rail, 1}});
        QCOMPARE(table_->item(0, 3)->text(), QStringLiteral("250.00"));
        QVERIFY(!table_->item(0, 3)->flags().testFlag(Qt::ItemIsEditable));
        QCOMPARE(panel_->keyAt(0, 3), std::string());
        QCOMPARE(panel_->keyAt(2, 1), std::string("abs.rail[2].point[3].y"));
    }
    void aRampHasThreeRecesses()
    {
        AirBearingSurface ramp = case_.surface;
        ramp.rails[0].kind = RailKind::Ramp;
        ramp.rails[0].recess = {150e-9, 100e-9, 100e-9};
        edits_->setSurface(ramp, QStringLiteral("ramp"));
        panel_->setSelection({{PartKind::Rail, 0}});
        table_->item(1, 5)->setText(QStringLiteral("0.2"));
        QCOMPARE(edits_->value().surface.rails[0].recess[1], 0.2e-6);
        QCOMPARE(panel_->keyAt(3, 5), std::string()); // at the first three points alone
    }
    /// A removed wall leaves vertical edges; the next one keeps its edges.
    void walls()
    {
        const auto press = [&](const QString& name) {
            for (QToolButton* button : panel_->findChildren<QToolButton*>())
                if (button->accessibleName() == name) return button->click();
            QFAIL(qPrintable(name));
        };
        list_->setCurrentItem(list_->topLevelItem(1)->child(0));
        QCOMPARE(table_->rowCount(), 3);
        table_->item(2, 1)->setText(QStringLiteral("1.4"));
        QCOMPARE(edits_->value().surface.walls[0].recess[2], 1.4e-6);
        press(QStringLiteral("Delete the chosen part"));
        QCOMPARE(edits_->value().surface.walls.size(), std::size_t(1));
        QCOMPARE(edits_->value().surface.rails[0].points[0].wall, 0);
        QCOMPARE(edits_->value().surface.rails[1].points[0].wall, 1);
        press(QStringLiteral("Add a wall profile"));
        QCOMPARE(edits_->value().surface.walls.size(), std::size_t(2));
        press(QStringLiteral("Add a point of interest"));
        QCOMPARE(edits_->value().surface.pointsOfInterest.size(), std::size_t(4));
        table_->item(0, 0)->setText(QStringLiteral("0.5"));
        QCOMPARE(edits_->value().surface.pointsOfInterest[3].x, 0.5e-3);
        press(QStringLiteral("Delete the chosen part"));
        QCOMPARE(edits_->value().surface.pointsOfInterest.size(), std::size_t(3));
        panel_->setSelection({{PartKind::Rail, 0}});
        press(QStringLiteral("Forward, over the next rail of the list"));
        QVERIFY(edits_->value().surface.rails[0] == [&] {
            Rail moved = case_.surface.rails[1];
            for (RailPoint& point : moved.points) point.wall = 1;
            return moved;
        }());
    }
    /// Without a mouse: a rail, a corner in the middle of an edge.
    void addsByButtons()
    {
        const auto press = [&](const QString& name) {
            for (QToolButton* button : panel_->findChildren<QToolButton*>())
                if (button->accessibleName() == name) return button->click();
            QFAIL(qPrintable(name));
        };
        press(QStringLiteral("Add a rectangular rail in the middle"));
        QCOMPARE(edits_->value().surface.rails.size(), std::size_t(5));
        const std::vector<RailPoint>& added = edits_->value().surface.rails[4].points;
        QVERIFY(std::abs(added[0].x + added[2].x - case_.slider.length) < 1e-15);
        QVERIFY(std::abs(added[0].y + added[2].y - case_.slider.width) < 1e-15);
        QCOMPARE(table_->rowCount(), 4);
        table_->setCurrentCell(1, 0);
        press(QStringLiteral("Insert a corner after the chosen one"));
        const std::vector<RailPoint>& points = edits_->value().surface.rails[4].points;
        QCOMPARE(points.size(), std::size_t(5));
        QCOMPARE(points[2].y, 0.5 * (points[1].y + points[3].y));
        QCOMPARE(table_->rowCount(), 5);
        QVERIFY(table_->item(2, 0)->isSelected());
    }
    /// The plan answers each selection with its own: the keyboard stays in its cell.
    void arrowsMoveThroughTheTable()
    {
        connect(panel_.get(), &ShapePanel::selected, panel_.get(), &ShapePanel::setSelection);
        panel_->setSelection({{PartKind::Rail, 1}});
        table_->setCurrentCell(0, 2);
        QTest::keyClick(table_, Qt::Key_Down);
        QTest::keyClick(table_, Qt::Key_Down);
        QCOMPARE(table_->currentRow(), 2);
        QCOMPARE(table_->currentColumn(), 2);
        QVERIFY(table_->item(2, 2)->isSelected() && !table_->item(1, 2)->isSelected());
        QTest::keyClick(table_, Qt::Key_Down, Qt::ShiftModifier);
        QVERIFY(table_->item(3, 2)->isSelected());
    }
    /// The pictures of walls are seen in the dark theme, too.
    void picturesFollowTheTheme()
    {
        const auto ink = [&] {
            const QImage image = list_->topLevelItem(1)->child(0)->icon(0).pixmap(32, 16).toImage();
            int lightest = -1;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (const QColor each = image.pixelColor(x, y); each.alpha() > 200)
                        lightest = std::max(lightest, each.lightness());
            return lightest;
        };
        QVERIFY(ink() >= 0 && ink() < 100);
        applyTheme(Theme::Dark);
        QTRY_VERIFY(ink() > 150);
        applyTheme(Theme::Light);
    }
    void drawsAWall()
    {
        list_->setCurrentItem(list_->topLevelItem(1)->child(0));
        const auto* picture = panel_->findChild<WallPicture*>();
        QVERIFY(picture && picture->isVisible());
        panel_->setSelection({{PartKind::Rail, 1}});
        QVERIFY(!picture->isVisible());
    }
    /// Points of a wall from the table and its picture; the row that is chosen in one is chosen in the other.
    void editsAWall()
    {
        list_->setCurrentItem(list_->topLevelItem(1)->child(0)); // (-5, 0.15), (0, 0.3), (20, 1.5) um
        auto* picture = panel_->findChild<WallPicture*>();
        panel_->setSelection({}); // what the plan answers
        QVERIFY(list_->topLevelItem(1)->child(0)->isSelected());
        table_->setCurrentCell(1, 0);
        QCOMPARE(picture->point(), std::optional<std::size_t>(1));
        QTest::keyClick(table_, Qt::Key_Insert);
        const auto wall = [&] { return edits_->value().surface.walls[0]; };
        QCOMPARE(wall().distance, (std::vector{-5e-6, 0.0, 10e-6, 20e-6}));
        QVERIFY(std::abs(wall().recess[2] - 0.9e-6) < 1e-15);
        QCOMPARE(table_->currentRow(), 2);
        QTest::keyClick(table_, Qt::Key_Delete);
        QVERIFY(edits_->value() == case_);
        picture->setPoint(1);
        const int before = edits_->undoStack().count();
        for (int i = 0; i < 3; ++i) QTest::keyClick(picture, Qt::Key_Down);
        QVERIFY(std::abs(wall().recess[1] - 0.33e-6) < 1e-15);
        QCOMPARE(edits_->undoStack().count(), before + 1); // a row of moves is one edit
        QCOMPARE(table_->currentRow(), 1);
        QCOMPARE(table_->item(1, 1)->text(), QStringLiteral("0.33"));
        QTest::keyClick(picture, Qt::Key_N);
        QTest::keyClick(picture, Qt::Key_Right);
        QCOMPARE(edits_->undoStack().count(), before + 2);
        // Two points are left at least.
        for (int i = 0; i < 3; ++i) {
            table_->setCurrentCell(0, 0);
            QTest::keyClick(table_, Qt::Key_Delete);
        }
        QCOMPARE(wall().distance.size(), std::size_t(2));
    }
    /// Of the edges that begin at the chosen corners; of all where none is chosen. A new wall is shown.
    void wallsOfEdges()
    {
        const auto menu = [&](auto action) {
            QToolButton* button = nullptr;
            for (QToolButton* each : panel_->findChildren<QToolButton*>())
                if (each->text() == QStringLiteral("Wall…")) button = each;
            QVERIFY(button != nullptr);
            button->click();
            auto* walls = button->findChild<QMenu*>();
            QVERIFY(walls != nullptr);
            action(walls);
            delete walls;
        };
        panel_->setSelection({{PartKind::Corner, 1, 2}});
        menu([](QMenu* walls) {
            QCOMPARE(walls->actions().size(), 5); // none, two walls, a line, a new one
            QVERIFY(walls->actions()[2]->isChecked() && !walls->actions()[1]->isChecked());
            QVERIFY(!walls->actions()[2]->icon().isNull());
            walls->actions()[1]->trigger();
        });
        QCOMPARE(edits_->value().surface.rails[1].points[2].wall, 1);
        QCOMPARE(edits_->value().surface.rails[1].points[1].wall, 2);
        panel_->setSelection({{PartKind::Rail, 1}});
        menu([](QMenu* walls) {
            for (const QAction* action : walls->actions()) QVERIFY(!action->isChecked()); // they differ
            walls->actions()[0]->trigger();
        });
        for (const RailPoint& point : edits_->value().surface.rails[1].points) QCOMPARE(point.wall, 0);
        panel_->setSelection({{PartKind::Edge, 1, 0}});
        menu([](QMenu* walls) { walls->actions().back()->trigger(); });
        QCOMPARE(edits_->value().surface.walls.size(), std::size_t(3));
        QCOMPARE(edits_->value().surface.rails[1].points[0].wall, 3);
        QCOMPARE(edits_->value().surface.walls[2].recess, (std::vector{0.0, case_.surface.baseRecess}));
        QVERIFY(panel_->findChild<WallPicture*>()->isVisible());
        QVERIFY(panel_->findChild<WallPicture*>()->wall() == edits_->value().surface.walls[2]);
    }
    void aDraggedRailChangesTheOrder()
    {
        QSignalSpy selected(panel_.get(), &ShapePanel::selected);
        emit panel_->findChild<PartTree*>()->reordered(0, 2);
        QVERIFY(edits_->value().surface.rails[2] == case_.surface.rails[0]);
        QCOMPARE(selected.back().front().value<PartSelection>(), (PartSelection{{PartKind::Rail, 2}}));
        QVERIFY(list_->topLevelItem(0)->child(2)->isSelected());
    }
    void theMenuIsTheEditors()
    {
        QSignalSpy wanted(panel_.get(), &ShapePanel::menuWanted);
        const auto at = [&](int group, int item) {
            return list_->visualItemRect(list_->topLevelItem(group)->child(item)).center();
        };
        emit list_->customContextMenuRequested(at(0, 1));
        QCOMPARE(wanted.count(), 1);
        emit list_->customContextMenuRequested(list_->visualItemRect(list_->topLevelItem(0)).center());
        QCOMPARE(wanted.count(), 1);
    }
    void theKeyboardGoesToTheNumbers()
    {
        panel_->setSelection({{PartKind::Edge, 3, 2}});
        panel_->typeCoordinates();
        QCOMPARE(table_->currentRow(), 2);
        panel_->typeRecess();
        QVERIFY(list_->findChild<QLineEdit*>() != nullptr); // being typed
    }
    /// A rail has no name of its own: F2 and a double click on it edit the recess.
    void aNameIsNotEdited()
    {
        QTreeWidgetItem* rail = list_->topLevelItem(0)->child(2);
        list_->setCurrentItem(rail, 0);
        QTest::keyClick(list_, Qt::Key_F2);
        auto* editor = list_->findChild<QLineEdit*>();
        QVERIFY(editor);
        QCOMPARE(editor->text(), rail->text(1));
        QTest::keyClicks(editor, QStringLiteral("0.2"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(edits_->value().surface.rails[2].recess[0], 0.2e-6);
        QCOMPARE(list_->topLevelItem(0)->child(2)->text(0), QStringLiteral("Rail 3"));
    }
    void everyControlHasAName()
    {
        for (const QToolButton* button : panel_->findChildren<QToolButton*>())
            QVERIFY(!button->accessibleName().isEmpty());
        QVERIFY(!list_->accessibleName().isEmpty() && !table_->accessibleName().isEmpty());
    }

private:
    Case case_;
    std::unique_ptr<CaseEdits> edits_;
    std::unique_ptr<ShapePanel> panel_;
    QTreeWidget* list_ = nullptr;
    QTableWidget* table_ = nullptr;
};

TOUCHDOWN_TEST(TestShapePanel)

} // namespace test_shape_panel

#include "test_shape_panel.moc"
