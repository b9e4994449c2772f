// SPDX-License-Identifier: GPL-3.0-or-later
//
// The menu of the editor, and what it does.
#include <cmath>
#include <memory>

#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"
#include "ui/slider/array_dialog.h"
#include "ui/slider/drag_field.h"

using namespace touchdown;

namespace test_surface_editor_menu {

class TestSurfaceEditorMenu : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        it_ = std::make_unique<EditorUnderTest>(sampleFilmCase());
        QVERIFY(QTest::qWaitForWindowExposed(it_->editor.get()));
    }
    void cleanup() { it_.reset(); }

    /// On an edge at the right of the front pad.
    void insertsWhereTheButtonWasPressed()
    {
        openAt(it_->pixel(0.40e-3, 0.25e-3));
        QCOMPARE(it_->editor->selection(), (PartSelection{{PartKind::Edge, 1, 1}}));
        choose(QStringLiteral("Insert a corner here"));
        QCOMPARE(it_->surface().rails[1].points.size(), std::size_t(5));
        QVERIFY(std::abs(it_->point(1, 2).y - 0.25e-3) < 2e-6);
    }
    void wallOfAnEdge()
    {
        QSignalSpy wanted(it_->editor.get(), &SurfaceEditor::wallWanted);
        openAt(it_->pixel(0.40e-3, 0.25e-3));
        choose(QStringLiteral("Wall of this edge"), QStringLiteral("Wall 1"));
        QCOMPARE(it_->point(1, 1).wall, 1);
        QCOMPARE(it_->point(1, 2).wall, 2);
        openAt(it_->pixel(0.40e-3, 0.25e-3));
        choose(QStringLiteral("Wall of this edge"), QStringLiteral("None, a vertical edge"));
        QCOMPARE(it_->point(1, 1).wall, 0);
        QCOMPARE(wanted.count(), 0);
        openAt(it_->pixel(0.40e-3, 0.25e-3));
        choose(QStringLiteral("Wall of this edge"), QStringLiteral("New wall…"));
        QCOMPARE(it_->point(1, 1).wall, 3);
        QCOMPARE(wanted.back().front().toInt(), 3);
    }
    void verbs()
    {
        it_->editor->select({{PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Duplicate"));
        QCOMPARE(it_->surface().rails.size(), std::size_t(5));
        openByKey();
        choose(QStringLiteral("Backward"));
        QCOMPARE(it_->editor->selection(), (PartSelection{{PartKind::Rail, 3}}));
        openByKey();
        choose(QStringLiteral("Forward"));
        QCOMPARE(it_->editor->selection(), (PartSelection{{PartKind::Rail, 4}}));
        openByKey();
        choose(QStringLiteral("Arrange"), QStringLiteral("Flip about the centre line"));
        openByKey();
        choose(QStringLiteral("Delete"));
        QCOMPARE(it_->surface().rails.size(), std::size_t(4));
        QSignalSpy coordinates(it_->editor.get(), &SurfaceEditor::coordinatesWanted);
        QSignalSpy recess(it_->editor.get(), &SurfaceEditor::recessWanted);
        it_->editor->select({{PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Coordinates…"));
        openByKey();
        choose(QStringLiteral("Recess…"));
        QCOMPARE(coordinates.count(), 1);
        QCOMPARE(recess.count(), 1);
    }
    /// Without a drag: by numbers, and Enter opens the fields, too.
    void movesByNumbers()
    {
        const RailPoint before = it_->point(1, 0);
        it_->editor->select({{PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Move by…"));
        auto* field = it_->editor->findChild<DragField*>();
        QVERIFY(field->isVisible());
        it_->moveTo(it_->pixel(0.6e-3, 0.3e-3), Qt::NoButton); // the pointer does not lead
        QTest::keyClicks(field->focusWidget(), "3");           // over the 0
        QTest::keyClick(field->focusWidget(), Qt::Key_Return);
        QVERIFY(!field->isVisible());
        QVERIFY2(std::abs(it_->point(1, 0).x - before.x - 3e-6) < 1e-15,
                 qPrintable(QString::number(it_->point(1, 0).x - before.x)));
        QCOMPARE(it_->point(1, 0).y, before.y);
        QTest::keyClick(it_->editor.get(), Qt::Key_Return);
        QVERIFY(field->isVisible());
        QTest::keyClick(field->focusWidget(), Qt::Key_Escape);
        QVERIFY(!field->isVisible());
        QVERIFY(std::abs(it_->point(1, 0).x - before.x - 3e-6) < 1e-15);
    }
    /// The front pad moved outwards by 30 um crosses the centre line and is made symmetric from its outer half, which
    /// reaches from 350 to 630 um; a rail at the side gets an image.
    void makesSymmetric()
    {
        AirBearingSurface surface = moved(it_->surface(), {{PartKind::Rail, 1}}, {0.0, 30e-6});
        surface.rails.push_back(
            {RailKind::Step, {{0.5e-3, 0.05e-3, 0}, {0.6e-3, 0.05e-3, 0}, {0.55e-3, 0.1e-3, 0}}, {}});
        it_->edits->setSurface(surface, QStringLiteral("as it is"));
        it_->editor->select({{PartKind::Rail, 1}, {PartKind::Rail, 4}});
        openByKey();
        choose(QStringLiteral("Make symmetric"));
        QCOMPARE(it_->surface().rails.size(), std::size_t(6));
        for (const RailPoint& point : it_->surface().rails[1].points)
            QVERIFY(std::abs(std::abs(point.y - 350e-6) - 280e-6) < 1e-12);
        const auto images = mirrorImages(it_->surface(), 0.7e-3, 1e-9);
        QVERIFY(images[1] && images[4] && images[4]->rail == 5);
    }
    /// The front pad is its own image: flipped it lies on itself, its mirrored copy on it. A wall at the side goes
    /// over.
    void mirroredCopiesAndFlips()
    {
        it_->edits->setSurface(moved(it_->surface(), {{PartKind::Rail, 1}}, {0.0, 50e-6}), QStringLiteral("aside"));
        const AirBearingSurface before = it_->surface();
        it_->editor->select({{PartKind::Rail, 1}});
        QTest::keyClick(it_->editor.get(), Qt::Key_M, Qt::ShiftModifier);
        QCOMPARE(it_->surface().rails.size(), before.rails.size() + 1);
        QCOMPARE(it_->surface().rails[1], before.rails[1]);
        QCOMPARE(it_->editor->selection(), (PartSelection{{PartKind::Rail, before.rails.size()}}));
        const double width = it_->edits->value().slider.width;
        QVERIFY(std::abs(it_->point(before.rails.size(), 0).y - (width - before.rails[1].points[0].y)) < 1e-15);
        it_->edits->undoStack().undo();
        QVERIFY(it_->surface() == before);
        it_->editor->select({{PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Arrange"), QStringLiteral("Flip about the centre line"));
        QCOMPARE(it_->surface().rails.size(), before.rails.size());
        QVERIFY(std::abs(it_->point(1, 0).y - (width - before.rails[1].points[0].y)) < 1e-15);
    }
    /// Each verb reaches its own function of core.
    void arranges()
    {
        const AirBearingSurface before = it_->surface();
        const PartSelection two{{PartKind::Rail, 1}, {PartKind::Rail, 2}};
        PartSelection three = two;
        three.insert({PartKind::Rail, 3});
        const auto gives = [&](const PartSelection& parts, const char* verb, const AirBearingSurface& expected) {
            it_->editor->select(parts);
            openByKey();
            choose(QStringLiteral("Arrange"), QString::fromUtf8(verb));
            const bool right = it_->surface() == expected && expected != before;
            it_->edits->undoStack().setIndex(0);
            return right && it_->surface() == before;
        };
        QVERIFY(gives(two, "Align left edges", aligned(before, two, Alignment::Left)));
        QVERIFY(gives(two, "Align right edges", aligned(before, two, Alignment::Right)));
        QVERIFY(gives(two, "Align top edges", aligned(before, two, Alignment::Top)));
        QVERIFY(gives(two, "Align bottom edges", aligned(before, two, Alignment::Bottom)));
        QVERIFY(gives(two, "Align centres at one x", aligned(before, two, Alignment::MiddleX)));
        it_->edits->setSurface(moved(before, {{PartKind::Rail, 1}}, {0.0, 10e-6}), QStringLiteral("aside"));
        const AirBearingSurface aside = it_->surface();
        it_->editor->select(two);
        openByKey();
        choose(QStringLiteral("Arrange"), QStringLiteral("Align centres at one y"));
        QVERIFY(it_->surface() == aligned(aside, two, Alignment::MiddleY));
        it_->edits->undoStack().setIndex(0);
        QVERIFY(gives(three, "Equal gaps along x", distributed(before, three, true)));
    }
    void anArrayIsTyped()
    {
        const AirBearingSurface before = it_->surface();
        it_->editor->select({{PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Arrange"), QStringLiteral("Array…"));
        auto* dialog = it_->editor->findChild<ArrayDialog*>();
        QVERIFY(dialog != nullptr);
        QPushButton* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QVERIFY(!ok->isEnabled()); // the copies would lie on the rail
        const QList<QLineEdit*> texts = dialog->findChildren<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
        QCOMPARE(texts.size(), 2);
        dialog->findChild<QSpinBox*>()->setValue(2);
        texts[0]->setText(QStringLiteral("20"));
        texts[1]->setText(QStringLiteral("wide"));
        QVERIFY(!ok->isEnabled());
        texts[1]->setText(QStringLiteral("-0.03 mm"));
        ok->click();
        QVERIFY(it_->surface() == withArray(before, {{PartKind::Rail, 1}}, 2, {20e-6, -0.03e-3}));
        QCOMPARE(it_->editor->selection().size(), std::size_t(2));
        QCOMPARE(it_->edits->undoStack().count(), 1);
    }
    /// The words say what gets the wall; recess is typed for several rails, too.
    void severalRails()
    {
        it_->editor->select({{PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Walls of this rail"), QStringLiteral("None, a vertical edge"));
        it_->editor->select({{PartKind::Edge, 1, 0}, {PartKind::Edge, 1, 1}});
        openByKey();
        choose(QStringLiteral("Walls of these edges"), QStringLiteral("Wall 1"));
        it_->editor->select({{PartKind::Rail, 0}, {PartKind::Rail, 1}});
        openByKey();
        choose(QStringLiteral("Walls of these rails"), QStringLiteral("Wall 2"));
        for (const std::size_t rail : {std::size_t(0), std::size_t(1)})
            for (const RailPoint& point : it_->surface().rails[rail].points) QCOMPARE(point.wall, 2);
        QCOMPARE(it_->edits->undoStack().count(), 3);
        QSignalSpy recess(it_->editor.get(), &SurfaceEditor::recessWanted);
        openByKey();
        choose(QStringLiteral("Recess…"));
        QCOMPARE(recess.count(), 1);
    }
    void withoutASelection()
    {
        it_->editor->select({});
        openByKey();
        QMenu* menu = it_->editor->findChild<QMenu*>();
        QVERIFY(menu != nullptr);
        for (const QAction* action : menu->actions()) // all but copying and saving picture and data
            QVERIFY(
                action->isSeparator() || !action->isEnabled() || action->text().contains(QStringLiteral("Drawing")) ||
                action->text().contains(QStringLiteral("picture")) || action->text().contains(QStringLiteral("data")));
        menu->close();
    }

private:
    void openAt(const QPoint& at)
    {
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, it_->editor->mapToGlobal(at));
        QCoreApplication::sendEvent(it_->editor.get(), &event);
    }
    void openByKey()
    {
        QContextMenuEvent event(QContextMenuEvent::Keyboard, {}, {});
        QCoreApplication::sendEvent(it_->editor.get(), &event);
    }
    void choose(const QString& text, const QString& below = {})
    {
        QMenu* menu = it_->editor->findChild<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY(menu != nullptr);
        const auto find = [](QMenu* in, const QString& wanted) -> QAction* {
            for (QAction* action : in->actions())
                if (action->text().split(QRegularExpression(QStringLiteral("[\t:]"))).front() == wanted) return action;
            return nullptr;
        };
        QAction* action = find(menu, text);
        if (action != nullptr && !below.isEmpty()) action = find(action->menu(), below);
        QVERIFY2(action != nullptr && action->isEnabled(), qPrintable(text + below));
        action->trigger();
        delete menu;
    }
    std::unique_ptr<EditorUnderTest> it_;
};

TOUCHDOWN_TEST(TestSurfaceEditorMenu)

} // namespace test_surface_editor_menu

#include "test_surface_editor_menu.moc"
