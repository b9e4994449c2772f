// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two cursors on a map of 4 x 2 cells: what the table reads, what moves them, where the sections show them.
#include "ui/maps/field_cursor_table.h"

#include <memory>

#include <QClipboard>
#include <QGuiApplication>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/maps/fields_view.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_field_cursor_table {

class TestFieldCursorTable : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void readsPlaceAndValue();
    void readsTheDifference();
    void shiftAndClickSetsTheSecond();
    void theSecondMovesByCells();
    void escapeTakesTheSecondAway();
    void sectionsShowTheSecondWhereTheyPassIt();
    void othersHaveAColumn();
    void copiesForASpreadsheet();
    void hidesWithoutAField();

private:
    QString cell(int row, int column) const { return table()->text(row, column); }
    ResultTable* table() const { return view_->cursors()->table(); }

    std::unique_ptr<FieldsView> view_;
    CellGrid grid_;
};

void TestFieldCursorTable::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

/// Cells of 0.2 mm x 0.3 mm with 1 to 8 kPa.
void TestFieldCursorTable::init()
{
    grid_ = {{0.0, 0.2e-3, 0.4e-3, 0.6e-3, 0.8e-3}, {0.0, 0.3e-3, 0.6e-3}};
    view_ = std::make_unique<FieldsView>();
    view_->resize(800, 700);
    view_->map()->setSlider(0.8e-3, 0.6e-3);
    view_->setKinds({{QStringLiteral("Pressure"), {"kPa"}}});
    view_->proposeSectionPoint(SurfacePoint{0.1e-3, 0.1e-3});
    view_->setFields(grid_, {{1e3, 2e3, 3e3, 4e3, 5e3, 6e3, 7e3, 8e3}});
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void TestFieldCursorTable::readsPlaceAndValue()
{
    QVERIFY(view_->cursors()->isVisible());
    QCOMPARE(table()->rowCount(), 1);
    view_->setSectionPoint({0.5e-3, 0.4e-3}, true);
    QCOMPARE(table()->head(1), QStringLiteral("x [mm]"));
    QCOMPARE(table()->head(4), QStringLiteral("Pressure [kPa]"));
    QCOMPARE(cell(0, 1), QStringLiteral("0.5000"));
    QCOMPARE(cell(0, 2), QStringLiteral("0.4000"));
    QCOMPARE(cell(0, 4), QStringLiteral("7.000"));
}

/// From (0.3, 0.1) mm with 2 kPa to (0.7, 0.4) mm with 8 kPa: 0.4 mm, 0.3 mm, 0.5 mm, 6 kPa.
void TestFieldCursorTable::readsTheDifference()
{
    view_->setSectionPoint({0.3e-3, 0.1e-3}, true);
    view_->setSecondPoint(SurfacePoint{0.7e-3, 0.4e-3});
    QCOMPARE(table()->rowCount(), 3);
    QCOMPARE(cell(1, 4), QStringLiteral("8.000"));
    QCOMPARE(cell(2, 1), QStringLiteral("0.4000"));
    QCOMPARE(cell(2, 2), QStringLiteral("0.3000"));
    QCOMPARE(cell(2, 3), QStringLiteral("0.5000"));
    QCOMPARE(cell(2, 4), QStringLiteral("6.000"));
    // Fields of another time, at the same cursors.
    view_->setFields(grid_, {{8e3, 7e3, 6e3, 5e3, 4e3, 3e3, 2e3, 1e3}});
    QCOMPARE(cell(2, 4), QStringLiteral("\u22126.000"));
}

void TestFieldCursorTable::shiftAndClickSetsTheSecond()
{
    view_->setSectionPoint({0.1e-3, 0.1e-3}, true);
    FieldMap* map = view_->map();
    QTest::mouseClick(map, Qt::LeftButton, Qt::ShiftModifier, map->toPixel({0.7e-3, 0.4e-3}).toPoint());
    QVERIFY(view_->secondPoint() && std::abs(view_->secondPoint()->x - 0.7e-3) < 3e-6);
    QCOMPARE(view_->sectionPoint()->x, 0.1e-3);
    // Cursor 1 still follows the pointer where it is not pinned.
    QTest::mouseClick(map, Qt::LeftButton, Qt::NoModifier, map->toPixel({0.3e-3, 0.1e-3}).toPoint());
    QVERIFY(std::abs(view_->sectionPoint()->x - 0.3e-3) < 3e-6);
    QVERIFY(view_->secondPoint());
    QCOMPARE(cell(2, 4), QStringLiteral("6.000"));
}

void TestFieldCursorTable::theSecondMovesByCells()
{
    view_->setSectionPoint({0.1e-3, 0.1e-3}, true);
    view_->setSecondPoint(SurfacePoint{0.1e-3, 0.1e-3});
    QTest::keyClick(view_->map(), Qt::Key_Right, Qt::ShiftModifier | Qt::ControlModifier);
    QTest::keyClick(view_->map(), Qt::Key_Up, Qt::ShiftModifier | Qt::ControlModifier);
    QCOMPARE(view_->secondPoint()->x, grid_.centreX(1));
    QCOMPARE(view_->secondPoint()->y, grid_.centreY(1));
    QCOMPARE(view_->sectionPoint()->x, 0.1e-3);
    QCOMPARE(cell(1, 4), QStringLiteral("6.000"));
}

void TestFieldCursorTable::escapeTakesTheSecondAway()
{
    view_->setSectionPoint({0.1e-3, 0.1e-3}, true);
    view_->setSecondPoint(SurfacePoint{0.7e-3, 0.4e-3});
    const QImage with = view_->map()->grab().toImage();
    QTest::keyClick(view_->map(), Qt::Key_Escape);
    QVERIFY(!view_->secondPoint());
    QCOMPARE(table()->rowCount(), 1);
    QVERIFY(view_->map()->grab().toImage() != with);
}

void TestFieldCursorTable::sectionsShowTheSecondWhereTheyPassIt()
{
    view_->setSectionPoint({0.3e-3, 0.1e-3}, true);
    PlotWidget* alongX = view_->sections()->alongX();
    PlotWidget* alongY = view_->sections()->alongY();
    view_->setSecondPoint(SurfacePoint{0.7e-3, 0.4e-3});
    QVERIFY(!alongX->plotCursor(1) && !alongY->plotCursor(1));
    view_->setSecondPoint(SurfacePoint{0.7e-3, 0.2e-3}); // the same row of cells
    QCOMPARE(alongX->plotCursor(1), std::optional(0.7e-3));
    QVERIFY(!alongY->plotCursor(1));
    // Shift + click in a section sets it on the section.
    alongY->refreshNow();
    const QPoint at = alongY->toPixel(0.5e-3, alongY->yAxis().range().low).toPoint() - QPoint(0, 20);
    QTest::mouseClick(alongY, Qt::LeftButton, Qt::ShiftModifier, at);
    QCOMPARE(view_->secondPoint()->x, 0.3e-3);
    QVERIFY(std::abs(view_->secondPoint()->y - 0.5e-3) < 5e-6);
    QCOMPARE(cell(2, 4), QStringLiteral("4.000"));
}

void TestFieldCursorTable::othersHaveAColumn()
{
    view_->setOthers(QStringLiteral("2"), {}, {{QStringLiteral("1"), {1, 0}, {{0.0, 0.8e-3}, {0.0, 0.6e-3}}, {{9e3}}}});
    view_->setFields(grid_, {{1e3, 2e3, 3e3, 4e3, 5e3, 6e3, 7e3, 8e3}});
    view_->setSecondPoint(SurfacePoint{0.7e-3, 0.4e-3});
    QCOMPARE(table()->columnCount(), 6);
    QCOMPARE(table()->head(4), QStringLiteral("Pressure, 2 [kPa]"));
    QCOMPARE(table()->head(5), QStringLiteral("1 [kPa]"));
    QCOMPARE(cell(0, 5), QStringLiteral("9.000"));
    QCOMPARE(cell(2, 5), QStringLiteral("0"));
}

void TestFieldCursorTable::copiesForASpreadsheet()
{
    view_->setSectionPoint({0.7e-3, 0.4e-3}, true);
    view_->setSecondPoint(SurfacePoint{0.3e-3, 0.4e-3});
    QTest::keyClick(table(), Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 4);
    QCOMPARE(lines[0], QStringLiteral("Cursor\tx [mm]\ty [mm]\tDistance [mm]\tPressure [kPa]"));
    QCOMPARE(lines[3], QStringLiteral("2 - 1\t-0.4000\t0.0000\t0.4000\t-2.000"));
}

void TestFieldCursorTable::hidesWithoutAField()
{
    view_->setSecondPoint(SurfacePoint{0.7e-3, 0.4e-3});
    view_->setFields({}, {});
    QVERIFY(!view_->cursors()->isVisible());
    view_->setFields(grid_, {{1e3, 2e3, 3e3, 4e3, 5e3, 6e3, 7e3, 8e3}});
    QVERIFY(view_->cursors()->isVisible());
    QCOMPARE(table()->rowCount(), 3); // and the cursors stand where they stood
}

TOUCHDOWN_TEST(TestFieldCursorTable)

} // namespace test_field_cursor_table

#include "test_field_cursor_table.moc"
