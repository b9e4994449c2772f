// SPDX-License-Identifier: GPL-3.0-or-later
//
// The menu of the editor, and what it does.
#include <cmath>
#include <memory>

#include <QContextMenuEvent>
#include <QMenu>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"

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
        choose(QStringLiteral("Mirror about the centre line"));
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
    void withoutASelection()
    {
        it_->editor->select({});
        openByKey();
        QMenu* menu = it_->editor->findChild<QMenu*>();
        QVERIFY(menu != nullptr);
        for (const QAction* action : menu->actions()) // all but copying and saving the picture
            QVERIFY(action->isSeparator() || !action->isEnabled() ||
                    action->text().contains(QStringLiteral("picture")));
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
