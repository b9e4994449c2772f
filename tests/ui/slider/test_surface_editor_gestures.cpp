// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a gesture says and takes: snap, numbers, pairs, measure.
#include <cmath>
#include <memory>

#include <QLineEdit>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"
#include "ui/slider/drag_field.h"
#include "ui/slider/part_picking.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_surface_editor_gestures {

const SurfacePart pad{PartKind::Rail, 1}, corner{PartKind::Corner, 1, 2};
constexpr double um = 1e-6;

bool near(double a, double b) { return std::abs(a - b) < 1e-13; } // [m]

/// The sample and two side rails that are mirror images, rails 5 and 6.
Case pairedCase()
{
    Case c = sampleFilmCase();
    const Rail lower{RailKind::Step, {{500 * um, 20 * um, 0}, {600 * um, 20 * um, 0}, {560 * um, 150 * um, 0}}, {}};
    c.surface.rails.push_back(lower);
    c.surface.rails.push_back(lower);
    for (RailPoint& p : c.surface.rails.back().points) p.y = c.slider.width - p.y;
    return c;
}

class TestSurfaceEditorGestures : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }
    void init()
    {
        it_ = std::make_unique<EditorUnderTest>(pairedCase());
        QVERIFY(QTest::qWaitForWindowExposed(it_->editor.get()));
    }
    void cleanup() { it_.reset(); }

    /// The rear pad ends with the shelf below it: of edges that look the same the upper one is taken.
    void theUpperOfTwoEdgesIsTaken()
    {
        AirBearingSurface surface = it_->surface();
        for (const std::size_t k : {1, 2}) surface.rails[2].points[k].x = 840.1 * um; // nearer by less than 0.1 px
        const auto part = partAt(*it_->editor, surface, it_->editor->toPixel({840.1 * um, 320 * um}), {});
        QVERIFY(part == std::optional(SurfacePart{PartKind::Edge, 3, 1}));
        const PartSelection shelf{{PartKind::Rail, 2}};
        const auto chosen = partAt(*it_->editor, surface, it_->editor->toPixel({840.1 * um, 320 * um}), shelf);
        QVERIFY(chosen == std::optional(SurfacePart{PartKind::Edge, 2, 1}));
    }

    /// The lower left corner of the front pad comes within 4 px of the centre line and of the front shelf's x = 50 um.
    void saysWhatItSnapsTo()
    {
        const QPoint from = it_->pixel(it_->point(1, 0).x, it_->point(1, 0).y);
        QVERIFY(snapWords(it_->editor->gesture()).isEmpty());
        it_->drag(from, it_->pixel(50 * um, 350 * um) + QPoint(4, 4), {}, false);
        QCOMPARE(snapWords(it_->editor->gesture()),
                 (QStringList{QStringLiteral("corner 1 of rail 1"), QStringLiteral("centre line")}));
        it_->moveTo(it_->pixel(0, 200 * um) + QPoint(3, 0), Qt::LeftButton);
        QCOMPARE(snapWords(it_->editor->gesture()), QStringList{QStringLiteral("border")});
        it_->moveTo(it_->pixel(0, 200 * um) + QPoint(3, 0), Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(snapWords(it_->editor->gesture()).isEmpty());
        QTest::keyClick(it_->editor.get(), Qt::Key_Escape);
        QVERIFY(snapWords(it_->editor->gesture()).isEmpty());
    }

    /// To the left and upwards: 12.5 um and 3 um that way.
    void takesTypedNumbers()
    {
        const RailPoint before = it_->point(1, 0);
        const QPoint from = it_->pixel(0.3e-3, 0.32e-3);
        it_->drag(from, from + QPoint(-40, -10), {}, false);
        const auto& shift = it_->editor->gesture().shift; // beside the pointer
        QVERIFY(shift && std::abs(shift->x * it_->metre() + 40.0) < 8.0 && shift->y > 0.0);
        type(it_->editor.get(), "1");
        QVERIFY(!shift); // the fields have it
        auto* field = it_->editor->findChild<DragField*>();
        QVERIFY(field->isVisible());
        type(field->focusWidget(), "2.5");
        QVERIFY(near(it_->editor->surface().rails[1].points[0].x, before.x - 12.5 * um)); // a preview
        QTest::keyClick(field->focusWidget(), Qt::Key_Tab);
        type(field->focusWidget(), "0.003 mm");
        QTest::mouseRelease(it_->editor.get(), Qt::LeftButton, {}, from + QPoint(-40, -10));
        QVERIFY(it_->editor->dragging());
        QCOMPARE(it_->edits->undoStack().count(), 0);
        QTest::keyClick(field->focusWidget(), Qt::Key_Return);
        QVERIFY(!field->isVisible() && !it_->editor->dragging());
        QVERIFY(near(it_->point(1, 0).x, before.x - 12.5 * um));
        QVERIFY(near(it_->point(1, 0).y, before.y + 3 * um));
        QCOMPARE(it_->edits->undoStack().count(), 1);
    }
    void escapeGivesTypedNumbersBack()
    {
        const Case before = it_->edits->value();
        const QPoint from = it_->pixel(0.3e-3, 0.32e-3);
        it_->drag(from, from + QPoint(40, 0), {}, false);
        type(it_->editor.get(), "5");
        QTest::keyClick(it_->editor->findChild<DragField*>()->focusWidget(), Qt::Key_Escape);
        QVERIFY(!it_->editor->dragging() && it_->edits->value() == before);
        QCOMPARE(it_->editor->surface(), before.surface);
        QTest::mouseRelease(it_->editor.get(), Qt::LeftButton, {}, from);
        QCOMPARE(it_->edits->undoStack().count(), 0);
    }
    /// No number: nothing is taken. A click beside the field takes the number.
    void aTextThatIsNoNumber()
    {
        const QPoint from = it_->pixel(0.3e-3, 0.32e-3);
        it_->drag(from, from + QPoint(40, 0), {}, false);
        type(it_->editor.get(), "-");
        QWidget* text = it_->editor->findChild<DragField*>()->focusWidget();
        QTest::keyClick(text, Qt::Key_Return);
        QVERIFY(it_->editor->dragging());
        type(text, "2");
        const double before = it_->point(1, 0).x;
        it_->click(it_->pixel(0.02e-3, 0.02e-3));
        QVERIFY(!it_->editor->dragging());
        QVERIFY(near(it_->point(1, 0).x, before - 2 * um));
    }
    /// The edge of the rear pad from (740, 420) to (700, 350) um, pulled outwards by 5 um normal to it. Its corners
    /// slide along their neighbours; its distance from the far corner at (740, 280) um grows by 5 um.
    void anEdgeMovesByItsNormal()
    {
        const SurfacePart slanted{PartKind::Edge, 3, 3};
        it_->editor->select({slanted});
        const auto distance = [&] {
            const RailPoint &a = it_->point(3, 3), &b = it_->point(3, 4);
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            return std::abs((b.x - a.x) * (280 * um - a.y) - (b.y - a.y) * (740 * um - a.x)) / length;
        };
        const double before = distance();
        const QPoint from = it_->pixel(720 * um, 385 * um);
        it_->drag(from, from + QPoint(-30, -10), {}, false);
        type(it_->editor.get(), "5");
        QTest::keyClick(it_->editor->findChild<DragField*>()->focusWidget(), Qt::Key_Return);
        QVERIFY(std::abs(distance() - before - 5 * um) < 1e-12);
    }

    /// Dragged by its middle: only the coordinate normal to it snaps; a slanted one does not snap.
    void edgesSnapNormalToThemselves()
    {
        const QPoint right = it_->pixel(400 * um, 200 * um);
        it_->editor->select({{PartKind::Edge, 1, 1}});
        it_->drag(right, it_->pixel(450 * um, 250 * um) + QPoint(3, 3), {}, false);
        QCOMPARE(snapWords(it_->editor->gesture()), QStringList{QStringLiteral("corner 2 of rail 1")}); // x = 450 um
        QTest::keyClick(it_->editor.get(), Qt::Key_Escape);
        QTest::mouseRelease(it_->editor.get(), Qt::LeftButton, {}, right);
        it_->editor->select({{PartKind::Edge, 3, 3}});
        const QPoint slanted = it_->pixel(720 * um, 385 * um);
        it_->drag(slanted, slanted + QPoint(-12, 7), {}, false);
        QVERIFY(snapWords(it_->editor->gesture()).isEmpty());
    }
    void pairsHaveLinks()
    {
        QVERIFY(it_->editor->verbs().pairLinks().empty());
        it_->editor->setPairs(true);
        QCOMPARE(it_->editor->verbs().pairLinks().size(), std::size_t(1));
        const PairLink link = it_->editor->verbs().pairLinks().front();
        QCOMPARE(link.rail, std::size_t(4));
        QCOMPARE(link.image, std::size_t(5));
        QVERIFY(!link.broken);
        QVERIFY(std::abs(0.5 * (link.from.y + link.to.y) - 350 * um) < 1e-12);
        it_->editor->setPairs(false);
        QVERIFY(it_->editor->verbs().pairLinks().empty());
    }
    void aClickBreaksAndJoinsAPair()
    {
        it_->editor->setPairs(true);
        const QPoint at = linkSymbol(*it_->editor, it_->editor->verbs().pairLinks().front()).toPoint();
        const auto imageMoves = [&] {
            const double before = it_->point(5, 0).x;
            it_->editor->select({{PartKind::Rail, 4}});
            QTest::keyClick(it_->editor.get(), Qt::Key_Right);
            const double after = it_->point(5, 0).x;
            it_->edits->undoStack().undo();
            return after != before;
        };
        QVERIFY(imageMoves());
        it_->click(at);
        QVERIFY(it_->editor->verbs().pairLinks().front().broken);
        QVERIFY(!imageMoves());
        QVERIFY(it_->editor->verbs().pairLinks().front().broken); // also after the way there and back
        it_->click(at);
        QVERIFY(!it_->editor->verbs().pairLinks().front().broken);
        QVERIFY(imageMoves());
        it_->editor->select({{PartKind::Rail, 5}});
        QTest::keyClick(it_->editor.get(), Qt::Key_L);
        QVERIFY(it_->editor->verbs().pairLinks().front().broken);
        // The numbers of rails change with those below; the pair stays broken.
        it_->editor->select({{PartKind::Rail, 0}});
        it_->editor->verbs().remove();
        QCOMPARE(it_->editor->verbs().pairLinks().front().rail, std::size_t(3));
        QVERIFY(it_->editor->verbs().pairLinks().front().broken);
    }

    /// From the front shelf's corner (50, 60) um to the one at (450, 640) um.
    void measures()
    {
        QTest::keyClick(it_->editor.get(), Qt::Key_M);
        QCOMPARE(it_->editor->tool(), SurfaceEditor::Tool::Measure);
        QVERIFY(measureText(it_->editor->gesture()).isEmpty());
        it_->click(it_->pixel(50 * um, 60 * um) + QPoint(2, 1));
        it_->moveTo(it_->pixel(50 * um, 640 * um), Qt::NoButton);
        QVERIFY(
            measureText(it_->editor->gesture()).startsWith(QStringLiteral("580.00 µm   dx 0.00   dy 580.00   90.00°")));
        it_->click(it_->pixel(450 * um, 640 * um) + QPoint(-2, 2));
        const QString expected = QStringLiteral("704.56 µm   dx 400.00   dy 580.00   55.41°"); // atan(580/400)
        QCOMPARE(measureText(it_->editor->gesture()), expected);
        QTest::keyClick(it_->editor.get(), Qt::Key_V);
        QCOMPARE(measureText(it_->editor->gesture()), expected);
        QTest::keyClick(it_->editor.get(), Qt::Key_Escape);
        QVERIFY(measureText(it_->editor->gesture()).isEmpty());
        // In one drag; a third place begins another one.
        it_->editor->setTool(SurfaceEditor::Tool::Measure);
        it_->drag(it_->pixel(50 * um, 60 * um), it_->pixel(450 * um, 60 * um));
        QVERIFY(measureText(it_->editor->gesture()).startsWith(QStringLiteral("400.00 µm")));
        it_->click(it_->pixel(150 * um, 100 * um));
        it_->click(it_->pixel(150 * um, 600 * um));
        QVERIFY(measureText(it_->editor->gesture()).startsWith(QStringLiteral("500.00 µm")));
        QVERIFY(it_->edits->undoStack().count() == 0);
    }
    void measuresWithoutAMouse()
    {
        it_->editor->select({{PartKind::Corner, 0, 0}, {PartKind::Corner, 0, 1}});
        QTest::keyClick(it_->editor.get(), Qt::Key_M);
        QVERIFY(
            measureText(it_->editor->gesture()).startsWith(QStringLiteral("400.00 µm   dx 400.00   dy 0.00   0.00°")));
        it_->editor->select({{PartKind::Edge, 0, 1}});
        QTest::keyClick(it_->editor.get(), Qt::Key_M);
        QVERIFY(measureText(it_->editor->gesture()).startsWith(QStringLiteral("580.00 µm")));
    }

    /// What the pointer snaps to may be gone after an undo.
    void undoUnderAMeasure()
    {
        it_->editor->setTool(SurfaceEditor::Tool::Rectangle);
        it_->drag(it_->pixel(0.50e-3, 0.10e-3), it_->pixel(0.54e-3, 0.15e-3));
        const std::size_t rails = it_->surface().rails.size();
        it_->editor->setTool(SurfaceEditor::Tool::Measure);
        it_->moveTo(it_->editor->toPixel({0.50e-3, 0.10e-3}), Qt::NoButton);
        QVERIFY(!snapWords(it_->editor->gesture()).isEmpty());
        it_->edits->undoStack().undo();
        QCOMPARE(it_->surface().rails.size(), rails - 1);
        it_->editor->grab();
        QVERIFY(snapWords(it_->editor->gesture()).isEmpty());
    }

    void anotherCaseForgetsWhatWasBegun()
    {
        it_->editor->setTool(SurfaceEditor::Tool::Measure);
        it_->click(it_->pixel(0.2e-3, 0.2e-3));
        it_->click(it_->pixel(0.3e-3, 0.2e-3));
        QVERIFY(!measureText(it_->editor->gesture()).isEmpty());
        it_->editor->open();
        QVERIFY(measureText(it_->editor->gesture()).isEmpty());
    }

private:
    static void type(QWidget* into, const char* text)
    {
        for (const char* c = text; *c != 0; ++c) QTest::keyClick(into, *c);
    }
    std::unique_ptr<EditorUnderTest> it_;
};

TOUCHDOWN_TEST(TestSurfaceEditorGestures)

} // namespace test_surface_editor_gestures

#include "test_surface_editor_gestures.moc"
