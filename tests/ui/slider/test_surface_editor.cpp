// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_editor.h"

#include <cmath>
#include <memory>
#include <random>

#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/physics/slider/surface_check.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/case/case_edits.h"
#include "ui/slider/part_picking.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_surface_editor {

/// The pad on the front shelf and its first corner, away from all other rails.
const SurfacePart pad{PartKind::Rail, 1}, corner{PartKind::Corner, 1, 2}, edge{PartKind::Edge, 1, 1};

class TestSurfaceEditor : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void init();
    void clickSelects();
    void aRubberBandSelects();
    void dragMovesARail();
    void dragMovesACorner();
    void dragMovesAnEdge();
    void snapsToTheCentreLine();
    void escapeGivesBack();
    void previewsWithoutEdits();
    void whatIsWrongStandsAtItsPlace();
    void arrowsMove();
    void aRowOfArrowsIsOneEdit();
    void insertsAndDeletes();
    void drawsRails();
    void copiesMirrorsAndOrders();
    void pairsMoveTogether();
    void spaceAndMiddleButtonPan();
    void aSelectionSurvivesOnlyWithItsPart();
    void everythingCanBeUndone();

private:
    QPoint pixel(double x, double y) const { return editor_->toPixel({x, y}).toPoint(); }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}, bool release = true)
    {
        QTest::mousePress(editor_.get(), Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 4; ++i) {
            const QPointF at = QPointF(from) + 0.25 * i * QPointF(to - from);
            QMouseEvent move(QEvent::MouseMove, at, editor_->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(editor_.get(), &move);
        }
        if (release) QTest::mouseRelease(editor_.get(), Qt::LeftButton, modifiers, to);
    }
    const RailPoint& point(std::size_t rail, std::size_t k) const
    {
        return edits_->value().surface.rails.at(rail).points.at(k);
    }
    double metre() const { return editor_->toPixel({1.0, 0.0}).x() - editor_->toPixel({0.0, 0.0}).x(); }

    Case case_;
    std::unique_ptr<CaseEdits> edits_;
    std::unique_ptr<SurfaceEditor> editor_;
};

void TestSurfaceEditor::init()
{
    case_ = sampleFilmCase();
    edits_ = std::make_unique<CaseEdits>();
    editor_ = std::make_unique<SurfaceEditor>();
    editor_->resize(1000, 800);
    const auto show = [this] {
        const Case& c = edits_->value();
        editor_->setCase(c.surface, c.slider.length, c.slider.width);
    };
    connect(edits_.get(), &CaseEdits::edited, editor_.get(), show);
    connect(editor_.get(), &SurfaceEditor::edited, edits_.get(), &CaseEdits::setSurface);
    edits_->open(case_);
    editor_->show();
    QVERIFY(QTest::qWaitForWindowExposed(editor_.get()));
}

void TestSurfaceEditor::clickSelects()
{
    const RailPoint at = point(1, 2), next = point(1, 3);
    QTest::mouseClick(editor_.get(), Qt::LeftButton, {}, pixel(0.3e-3, 0.3e-3));
    QCOMPARE(editor_->selection(), PartSelection{pad});
    QTest::mouseClick(editor_.get(), Qt::LeftButton, {}, pixel(at.x, at.y));
    QCOMPARE(editor_->selection(), PartSelection{corner});
    QTest::mouseClick(editor_.get(), Qt::LeftButton, Qt::ShiftModifier, pixel(0.5 * (at.x + next.x), at.y));
    QCOMPARE(editor_->selection(), (PartSelection{corner, {PartKind::Edge, 1, 2}}));
    QTest::mouseClick(editor_.get(), Qt::LeftButton, Qt::ShiftModifier, pixel(at.x, at.y));
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Edge, 1, 2}}));
    QTest::mouseClick(editor_.get(), Qt::LeftButton, {}, pixel(0.5e-3, 0.01e-3));
    QVERIFY(editor_->selection().empty());
    QTest::keyClick(editor_.get(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(editor_->selection().size(), case_.surface.rails.size());
    QTest::keyClick(editor_.get(), Qt::Key_Escape);
    QVERIFY(editor_->selection().empty());
    QTest::keyClick(editor_.get(), Qt::Key_N);
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 0}}));
    QTest::keyClick(editor_.get(), Qt::Key_B);
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 3}}));
    const auto press = [this](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(editor_.get(), key, modifiers);
        return editor_->selection();
    };
    QCOMPARE(press(Qt::Key_E), (PartSelection{{PartKind::Edge, 3, 0}}));
    QCOMPARE(press(Qt::Key_E), (PartSelection{{PartKind::Edge, 3, 1}}));
    QCOMPARE(press(Qt::Key_C), (PartSelection{{PartKind::Corner, 3, 0}}));
    QCOMPARE(press(Qt::Key_C, Qt::ShiftModifier), (PartSelection{{PartKind::Corner, 3, 4}}));
    QCOMPARE(press(Qt::Key_C), (PartSelection{{PartKind::Corner, 3, 0}}));
    editor_->select({});
    QVERIFY(press(Qt::Key_E).empty());
    QVERIFY(edits_->value() == case_);
}

void TestSurfaceEditor::aRubberBandSelects()
{
    drag(pixel(0.5e-3, 0.19e-3), pixel(0.849e-3, 0.55e-3));
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 2},
                                                  {PartKind::Rail, 3},
                                                  {PartKind::Interest, 0},
                                                  {PartKind::Interest, 1},
                                                  {PartKind::Interest, 2}}));
    QVERIFY(edits_->value() == case_);
}

/// By 50 px along x and 20 px upwards, on the raster of 1 um; one step back restores the case.
void TestSurfaceEditor::dragMovesARail()
{
    const RailPoint before = point(1, 0);
    drag(pixel(0.3e-3, 0.32e-3), pixel(0.3e-3, 0.32e-3) + QPoint(20, -12));
    const RailPoint after = point(1, 0);
    QVERIFY(std::abs(after.x - before.x - 20 / metre()) < 1.1e-6);
    QVERIFY(std::abs(after.y - before.y - 12 / metre()) < 1.1e-6);
    for (std::size_t k = 0; k < 4; ++k) {
        QVERIFY(std::abs(point(1, k).x * 1e6 - std::round(point(1, k).x * 1e6)) < 1e-6);
        QCOMPARE(point(1, k).wall, 2);
    }
    QCOMPARE(edits_->undoStack().count(), 1);
    QCOMPARE(edits_->undoStack().undoText(), QStringLiteral("move rail 2"));
    edits_->undoStack().undo();
    QVERIFY(edits_->value() == case_);
}

void TestSurfaceEditor::dragMovesACorner()
{
    const RailPoint before = point(1, 2);
    const QPoint from = pixel(before.x, before.y);
    drag(from, from + QPoint(-25, 18), Qt::ControlModifier); // without the snap
    QVERIFY(std::abs(point(1, 2).x - before.x + 25 / metre()) < 0.6 / metre());
    QVERIFY(std::abs(point(1, 2).y - before.y + 18 / metre()) < 0.6 / metre());
    for (const std::size_t k : {0, 1, 3}) QVERIFY(point(1, k) == case_.surface.rails[1].points[k]);
}

void TestSurfaceEditor::dragMovesAnEdge()
{
    const QPoint from = pixel(0.40e-3, 0.3e-3);
    QTest::mouseClick(editor_.get(), Qt::LeftButton, {}, from);
    QCOMPARE(editor_->selection(), PartSelection{edge});
    drag(from, from + QPoint(-30, 25));
    QVERIFY(std::abs(point(1, 1).x - 0.40e-3 + 30 / metre()) < 1.1e-6);
    QCOMPARE(point(1, 1).x, point(1, 2).x);
    QCOMPARE(point(1, 1).y, case_.surface.rails[1].points[1].y);
    QCOMPARE(point(1, 2).y, case_.surface.rails[1].points[2].y);
}

/// The front pad's lower edge comes within 4 px of the centre line; with Shift x stays.
void TestSurfaceEditor::snapsToTheCentreLine()
{
    const RailPoint lower = point(1, 0);
    const double centre = 0.5 * case_.slider.width;
    const QPoint from = pixel(lower.x, lower.y);
    const int up = static_cast<int>(std::lround((centre - lower.y) * metre())) - 4;
    drag(from, from + QPoint(9, -up), Qt::ShiftModifier);
    QCOMPARE(point(1, 0).y, centre);
    QCOMPARE(point(1, 0).x, lower.x);
}

void TestSurfaceEditor::escapeGivesBack()
{
    QSignalSpy previewed(editor_.get(), &SurfaceEditor::previewed);
    drag(pixel(0.3e-3, 0.32e-3), pixel(0.35e-3, 0.35e-3), {}, false);
    QVERIFY(editor_->dragging());
    QVERIFY(editor_->surface() != case_.surface);
    QTest::keyClick(editor_.get(), Qt::Key_Escape);
    QVERIFY(!editor_->dragging());
    QCOMPARE(editor_->surface(), case_.surface);
    QCOMPARE(previewed.back().front().value<AirBearingSurface>(), case_.surface);
    QTest::mouseRelease(editor_.get(), Qt::LeftButton, {}, pixel(0.35e-3, 0.35e-3));
    QVERIFY(edits_->value() == case_);
    QCOMPARE(edits_->undoStack().count(), 0);
}

void TestSurfaceEditor::previewsWithoutEdits()
{
    QSignalSpy edited(edits_.get(), &CaseEdits::edited), previewed(editor_.get(), &SurfaceEditor::previewed);
    drag(pixel(0.3e-3, 0.32e-3), pixel(0.35e-3, 0.35e-3), {}, false);
    QTRY_VERIFY(previewed.count() >= 2); // the first position at once, and the last
    QCOMPARE(previewed.back().front().value<AirBearingSurface>(), editor_->surface());
    QCOMPARE(edited.count(), 0);
    QTest::mouseRelease(editor_.get(), Qt::LeftButton, {}, pixel(0.35e-3, 0.35e-3));
    QCOMPARE(edited.count(), 1);
}

/// A corner dragged over the opposite edge: the outline crosses itself, during the drag and after it.
void TestSurfaceEditor::whatIsWrongStandsAtItsPlace()
{
    const RailPoint from = point(1, 2), to = point(1, 0);
    drag(pixel(from.x, from.y), pixel(to.x - 0.05e-3, to.y + 0.1e-3), Qt::ControlModifier, false);
    QTRY_COMPARE(editor_->problems().size(), std::size_t(1));
    QVERIFY(editor_->problems().front().sentence.find("crosses itself") != std::string::npos);
    QCOMPARE(editor_->problems().front().places.size(), std::size_t(1));
    const QPoint place = editor_->toPixel(editor_->problems().front().places.front()).toPoint();
    QTest::mouseRelease(editor_.get(), Qt::LeftButton, Qt::ControlModifier, pixel(to.x - 0.05e-3, to.y + 0.1e-3));
    QCOMPARE(editor_->problems().size(), std::size_t(1)); // the shape stays: it is the user's
    const QImage picture = editor_->grab().toImage();
    const QColor ring = meaningColours(editor_->palette()).failure;
    int found = 0;
    for (int i = -10; i <= 10; ++i) found += picture.pixelColor(place + QPoint(i, 0)) == ring;
    QVERIFY(found >= 2);
    edits_->undoStack().undo();
    QVERIFY(editor_->problems().empty());
}

void TestSurfaceEditor::arrowsMove()
{
    editor_->select({pad});
    const RailPoint before = point(1, 0);
    QTest::keyClick(editor_.get(), Qt::Key_Right);
    QTest::keyClick(editor_.get(), Qt::Key_Up, Qt::ShiftModifier);
    QTest::keyClick(editor_.get(), Qt::Key_Left, Qt::AltModifier);
    QVERIFY(std::abs(point(1, 0).x - before.x - 0.9e-6) < 1e-15);
    QVERIFY(std::abs(point(1, 0).y - before.y - 10e-6) < 1e-15);
}

void TestSurfaceEditor::aRowOfArrowsIsOneEdit()
{
    editor_->select({pad});
    for (int i = 0; i < 5; ++i) QTest::keyClick(editor_.get(), Qt::Key_Right);
    QCOMPARE(edits_->undoStack().count(), 1);
    editor_->select({corner});
    QTest::keyClick(editor_.get(), Qt::Key_Right);
    QCOMPARE(edits_->undoStack().count(), 2);
    edits_->undoStack().undo();
    edits_->undoStack().undo();
    QVERIFY(edits_->value() == case_);
}

void TestSurfaceEditor::insertsAndDeletes()
{
    QTest::mouseDClick(editor_.get(), Qt::LeftButton, {}, pixel(0.40e-3, 0.3e-3));
    QCOMPARE(edits_->value().surface.rails[1].points.size(), std::size_t(5));
    QCOMPARE(point(1, 2).x, 0.40e-3); // on its edge
    QCOMPARE(point(1, 2).wall, 2);
    QVERIFY(std::abs(point(1, 2).y - 0.3e-3) < 2e-6);
    QCOMPARE(editor_->selection(), PartSelection{corner});
    QTest::keyClick(editor_.get(), Qt::Key_Delete);
    QVERIFY(edits_->value() == case_);
    editor_->select({pad});
    QTest::keyClick(editor_.get(), Qt::Key_Delete);
    QCOMPARE(edits_->value().surface.rails.size(), std::size_t(3));
    QVERIFY(editor_->selection().size() <= 1); // the number is now that of another rail
}

void TestSurfaceEditor::drawsRails()
{
    QTest::keyClick(editor_.get(), Qt::Key_R);
    QCOMPARE(editor_->tool(), SurfaceEditor::Tool::Rectangle);
    drag(pixel(0.50e-3, 0.05e-3), pixel(0.70e-3, 0.15e-3));
    QCOMPARE(edits_->value().surface.rails.size(), std::size_t(5));
    QCOMPARE(point(4, 0).wall, 0);
    QVERIFY(std::abs(point(4, 2).x - 0.70e-3) < 3e-6 && std::abs(point(4, 2).y - 0.15e-3) < 3e-6);
    QCOMPARE(editor_->tool(), SurfaceEditor::Tool::Select);
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 4}}));
    editor_->setTool(SurfaceEditor::Tool::Polygon);
    for (const auto& [x, y] : {std::pair(0.5e-3, 0.6e-3), std::pair(0.7e-3, 0.6e-3), std::pair(0.6e-3, 0.66e-3)})
        QTest::mouseClick(editor_.get(), Qt::LeftButton, {}, pixel(x, y));
    QTest::keyClick(editor_.get(), Qt::Key_Return);
    QCOMPARE(edits_->value().surface.rails.size(), std::size_t(6));
    QCOMPARE(edits_->value().surface.rails[5].points.size(), std::size_t(3));
    QVERIFY(surfaceProblems(edits_->value().surface).empty());
    // Two corners are no rail.
    editor_->setTool(SurfaceEditor::Tool::Polygon);
    QTest::mouseClick(editor_.get(), Qt::LeftButton, {}, pixel(0.5e-3, 0.6e-3));
    QTest::keyClick(editor_.get(), Qt::Key_Return);
    QCOMPARE(edits_->value().surface.rails.size(), std::size_t(6));
}

void TestSurfaceEditor::copiesMirrorsAndOrders()
{
    editor_->select({corner}); // stands for its rail
    QTest::keyClick(editor_.get(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(edits_->value().surface.rails.size(), std::size_t(5));
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 4}}));
    const double y = point(4, 0).y;
    editor_->verbs().flip();
    QVERIFY(std::abs(point(4, 0).y - (case_.slider.width - y)) < 1e-15);
    QTest::keyClick(editor_.get(), Qt::Key_PageDown);
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 3}}));
    QCOMPARE(edits_->value().surface.rails[4], case_.surface.rails[3]);
    QTest::keyClick(editor_.get(), Qt::Key_PageUp);
    QTest::keyClick(editor_.get(), Qt::Key_PageUp); // already on top
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 4}}));
}

void TestSurfaceEditor::pairsMoveTogether()
{
    editor_->setPairs(true);
    editor_->select({corner}); // of a pad that is its own mirror image; corner 2's image is corner 1
    QTest::keyClick(editor_.get(), Qt::Key_Up);
    QVERIFY(std::abs(point(1, 2).y - case_.surface.rails[1].points[2].y - 1e-6) < 1e-15);
    QVERIFY(std::abs(point(1, 1).y - case_.surface.rails[1].points[1].y + 1e-6) < 1e-15);
}

void TestSurfaceEditor::spaceAndMiddleButtonPan()
{
    const QRectF before = editor_->view();
    QTest::keyPress(editor_.get(), Qt::Key_Space);
    drag(pixel(0.3e-3, 0.32e-3), pixel(0.3e-3, 0.32e-3) + QPoint(40, 0));
    QTest::keyRelease(editor_.get(), Qt::Key_Space);
    QVERIFY(std::abs(editor_->view().left() - before.left() + 40 / metre()) < 1 / metre());
    QVERIFY(edits_->value() == case_);
    QTest::keyClick(editor_.get(), Qt::Key_F);
    QVERIFY(editor_->isFitted());
}

void TestSurfaceEditor::aSelectionSurvivesOnlyWithItsPart()
{
    editor_->select({{PartKind::Rail, 3}, {PartKind::Rail, 0}});
    Case fewer = case_;
    fewer.surface.rails.pop_back();
    edits_->setSurface(fewer.surface, QStringLiteral("fewer"));
    QCOMPARE(editor_->selection(), (PartSelection{{PartKind::Rail, 0}}));
}

/// 300 random edits: after each the case's text opens as the same case, where it is one; 300 steps back end with the
/// first case, bit for bit.
void TestSurfaceEditor::everythingCanBeUndone()
{
    std::mt19937 engine(11);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(engine() % n); };
    const auto step = [&] { return (double(engine() % 2001) - 1000.0) * 13e-9; };
    int legal = 0;
    for (int i = 0; i < 300; ++i) {
        const AirBearingSurface& surface = edits_->value().surface;
        const std::size_t rail = below(surface.rails.size());
        const std::size_t k = below(surface.rails[rail].points.size());
        const auto kind = std::array{PartKind::Rail, PartKind::Edge, PartKind::Corner}[below(3)];
        editor_->select({{kind, rail, kind == PartKind::Rail ? 0 : k}});
        editor_->setPairs(below(2) == 0);
        switch (below(10)) {
        case 0: editor_->verbs().insertCorner(rail, k, {double(below(850)) * 1e-6, double(below(700)) * 1e-6}); break;
        case 1:
            if (surface.rails.size() > 2) editor_->verbs().remove();
            break;
        case 2:
            if (surface.rails.size() < 12) editor_->verbs().copy();
            break;
        case 3: editor_->verbs().flip(); break;
        case 4: editor_->verbs().moveInOrder(below(2) == 0 ? 1 : -1); break;
        case 5:
            if (surface.walls.size() > 1) edits_->setSurface(withoutWall(surface, 0), QStringLiteral("wall"));
            break;
        case 6:
            if (surface.rails.size() < 12) editor_->verbs().makeSymmetric();
            break;
        case 7:
            editor_->verbs().chooseWall(static_cast<int>(below(std::min<std::size_t>(surface.walls.size() + 2, 6))));
            break;
        default: editor_->verbs().nudge({step(), step()}); break;
        }
        if (!surfaceProblems(edits_->value().surface).empty()) {
            if (below(3) == 0) // back to the last shape that is one
                while (!surfaceProblems(edits_->value().surface).empty()) edits_->undoStack().undo();
            continue;
        }
        ++legal;
        const CaseDocument again = parseCase(formatCase(edits_->value()), "again");
        QVERIFY(again.valid());
        QVERIFY(again.value.surface == edits_->value().surface);
    }
    QVERIFY(legal > 50);
    QVERIFY(edits_->undoStack().count() > 100);
    const Case last = edits_->value();
    while (edits_->undoStack().canUndo()) edits_->undoStack().undo();
    QVERIFY(edits_->value() == case_);
    while (edits_->undoStack().canRedo()) edits_->undoStack().redo();
    QVERIFY(edits_->value() == last);
}

TOUCHDOWN_TEST(TestSurfaceEditor)

} // namespace test_surface_editor

#include "test_surface_editor.moc"
