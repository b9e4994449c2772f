// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kept distances and symmetries by mouse and keys, in the plan.
#include "ui/slider/kept_distances.h"

#include <cmath>
#include <memory>

#include <QImage>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/physics/slider/surface_arrange.h"
#include "core/physics/slider/surface_edit.h"
#include "core/physics/slider/surface_relations.h"
#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"
#include "ui/slider/part_picking.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_kept_distances {

const SurfacePart frontPad{PartKind::Rail, 1}, rearShelf{PartKind::Rail, 2}, kept{PartKind::Distance, 0};
constexpr double um = 1e-6;

class TestKeptDistances : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }
    void init()
    {
        it_ = std::make_unique<EditorUnderTest>(sampleFilmCase());
        QVERIFY(QTest::qWaitForWindowExposed(it_->editor.get()));
    }
    void cleanup() { it_.reset(); }

    /// The front pad ends at 400 µm, the rear shelf begins at 550 µm: it follows the pad, also while it is dragged.
    void aRailFollows()
    {
        keepTheGap();
        QCOMPARE(it_->surface().distances.size(), std::size_t(1));
        QVERIFY(std::abs(it_->surface().distances[0].value - 150 * um) < 1e-14);
        QCOMPARE(it_->editor->selection(), PartSelection{kept});
        QCOMPARE(relationText(it_->surface(), kept, false), QStringLiteral("rail 3 stays 150 µm from rail 2 along x"));
        QCOMPARE(relationText(it_->surface(), kept, true),
                 QStringLiteral("edge 4 of rail 3 stays 150 µm from edge 2 of rail 2 along x"));
        const Case before = it_->edits->value();
        const QPoint from = it_->pixel(200 * um, 200 * um);
        it_->drag(from, from + QPoint(-60, 0), {}, false);
        const AirBearingSurface& shown = it_->editor->surface();
        QVERIFY(shown.rails[1].points[1].x < 390 * um);
        QVERIFY(std::abs(gapOf(shown) - 150 * um) < 1e-14);
        QTest::mouseRelease(it_->editor.get(), Qt::LeftButton, {}, from + QPoint(-60, 0));
        const Case after = it_->edits->value();
        QVERIFY(after.surface.rails[1].points[1].x < 390 * um);
        QVERIFY(std::abs(gapOf(after.surface) - 150 * um) < 1e-14);
        QCOMPARE(after.surface.rails[2].points[0].y, before.surface.rails[2].points[0].y);
        QVERIFY(after.surface.rails[3] == before.surface.rails[3]);
        it_->edits->undoStack().undo();
        QVERIFY(it_->edits->value() == before);
        it_->edits->undoStack().redo();

        const CaseDocument reopened = parseCase(formatCase(after), "a.toml");
        QVERIFY(reopened.valid() && reopened.value == after);
        EditorUnderTest again(reopened.value);
        again.editor->select({rearShelf});
        QTest::keyClick(again.editor.get(), Qt::Key_Right);
        QCOMPARE(again.surface().distances.size(), std::size_t(1));
        QVERIFY(std::abs(gapOf(again.surface()) - 150 * um) < 1e-14);
        QVERIFY(std::abs(again.point(1, 1).x - after.surface.rails[1].points[1].x - 1 * um) < 1e-14);
    }

    void aDistanceIsClickedAndDeleted()
    {
        keepTheGap();
        it_->editor->select({});
        it_->click(it_->pixel(450 * um, 350 * um)); // on its line
        QCOMPARE(it_->editor->selection(), PartSelection{kept});
        keepTheGap(); // once more: it is there
        QCOMPARE(it_->surface().distances.size(), std::size_t(1));
        const AirBearingSurface before = it_->surface();
        const QPoint from = it_->pixel(450 * um, 350 * um);
        it_->drag(from, from + QPoint(30, 30)); // a distance has no place of its own
        QVERIFY(it_->surface() == before);
        it_->editor->select({kept});
        QTest::keyClick(it_->editor.get(), Qt::Key_Delete);
        QVERIFY(it_->surface().distances.empty());
        QVERIFY(it_->surface().rails == before.rails);
    }

    void isDrawn()
    {
        keepTheGap();
        const auto pixelsOf = [this](const QColor& colour) {
            const QImage image = it_->editor->grab().toImage();
            const double scale = image.devicePixelRatio();
            int count = 0;
            for (int x = it_->pixel(410 * um, 0).x(); x < it_->pixel(430 * um, 0).x(); ++x)
                for (int y = -2; y <= 2; ++y) {
                    const QPointF at = scale * QPointF(x, it_->pixel(0, 350 * um).y() + y);
                    if (image.pixelColor(at.toPoint()) == colour) ++count;
                }
            return count;
        };
        QVERIFY(pixelsOf(plotTheme(it_->editor->palette()).selection) > 5);
        it_->editor->select({});
        QVERIFY(pixelsOf(plotTheme(it_->editor->palette()).selection) == 0);
        QVERIFY(pixelsOf(plotTheme(it_->editor->palette()).text) > 5);
        AirBearingSurface surface = it_->surface();
        surface.distances.push_back(surface.distances[0]);
        surface.distances[1].value += 5 * um;
        it_->edits->setSurface(surface, QStringLiteral("contradict"));
        QVERIFY(!relationProblem(it_->editor->warnings(), {PartKind::Distance, 1}).isEmpty());
        QVERIFY(relationProblem(it_->editor->warnings(), kept).isEmpty());
    }

    /// The front pad lies across the centre line: one of its corners moves, and its image.
    void aSymmetryIsKept()
    {
        it_->editor->select({frontPad});
        QMenu* keep = nullptr;
        it_->editor->popUpMenu(it_->editor->mapToGlobal(QPoint(10, 10)), {});
        for (QMenu* menu : it_->editor->findChildren<QMenu*>())
            if (menu->title() == QStringLiteral("Keep")) keep = menu;
        QVERIFY(keep != nullptr && !keep->actions()[0]->isEnabled() && !keep->actions()[1]->isEnabled());
        keep->actions()[2]->trigger();
        for (QMenu* menu : it_->editor->findChildren<QMenu*>()) menu->close();
        QCOMPARE(it_->surface().symmetries, (std::vector<KeptSymmetry>{{1, 1}}));
        it_->editor->select({{PartKind::Corner, 1, 1}});
        QTest::keyClick(it_->editor.get(), Qt::Key_Up);
        QTest::keyClick(it_->editor.get(), Qt::Key_Right);
        const double width = it_->edits->value().slider.width;
        QVERIFY(std::abs(it_->point(1, 1).y - 101 * um) < 1e-14 && std::abs(it_->point(1, 1).x - 401 * um) < 1e-14);
        QVERIFY(std::abs(it_->point(1, 2).y - (width - 101 * um)) < 1e-14);
        QCOMPARE(it_->point(1, 2).x, it_->point(1, 1).x);
    }

    /// Once more is no second one, whichever rail comes first in the list.
    void aSymmetryIsKeptOnce()
    {
        const auto offered = [this] {
            it_->editor->popUpMenu(it_->editor->mapToGlobal(QPoint(10, 10)), {});
            bool enabled = false;
            for (QMenu* menu : it_->editor->findChildren<QMenu*>()) {
                if (menu->title() == QStringLiteral("Keep")) enabled = menu->actions()[2]->isEnabled();
                menu->close();
            }
            return enabled;
        };
        AirBearingSurface surface = it_->surface();
        surface = withMirroredCopies(surface, {rearShelf}, it_->edits->value().slider.width);
        const std::size_t copy = surface.rails.size() - 1;
        it_->edits->setSurface(surface, QStringLiteral("copy"));
        it_->editor->select({rearShelf, {PartKind::Rail, copy}});
        QVERIFY(offered());
        surface.symmetries = {{copy, rearShelf.item}};
        it_->edits->setSurface(surface, QStringLiteral("keep"));
        it_->editor->select({rearShelf, {PartKind::Rail, copy}});
        QVERIFY(!offered());
    }

    /// A rail whose width stays is its mirror image when it is flipped.
    void aRailOfKeptWidthIsFlipped()
    {
        const double width = it_->edits->value().slider.width;
        AirBearingSurface surface = it_->surface();
        for (RailPoint& point : surface.rails[1].points) point.y -= 20 * um; // beside the centre line
        it_->edits->setSurface(surface, QStringLiteral("move"));
        it_->editor->select({{PartKind::Edge, 1, 0}, {PartKind::Edge, 1, 2}});
        QTest::keyClick(it_->editor.get(), Qt::Key_K);
        QCOMPARE(it_->surface().distances.size(), std::size_t(1));
        QVERIFY(!it_->surface().distances[0].alongX);
        const AirBearingSurface expected = mirrored(it_->surface(), {frontPad}, width);
        it_->editor->select({frontPad});
        it_->editor->popUpMenu(it_->editor->mapToGlobal(QPoint(10, 10)), {});
        for (QAction* action : it_->editor->findChildren<QAction*>())
            if (action->text() == QStringLiteral("Flip about the centre line") && action->isEnabled()) {
                action->trigger();
                break;
            }
        for (QMenu* menu : it_->editor->findChildren<QMenu*>()) menu->close();
        for (std::size_t k = 0; k < expected.rails[1].points.size(); ++k)
            QVERIFY(std::abs(it_->point(1, k).y - expected.rails[1].points[k].y) < 1e-14);
    }

    /// A symmetry that an edit ends is told.
    void whatEndsIsTold()
    {
        const QSignalSpy ended(it_->edits.get(), &CaseEdits::relationsEnded);
        AirBearingSurface surface = it_->surface();
        surface.symmetries = {{1, 1}};
        it_->edits->setSurface(surface, QStringLiteral("keep"));
        QCOMPARE(ended.count(), 0);
        it_->edits->setSurface(withCorner(it_->surface(), 1, 0, {390 * um, 100 * um}), QStringLiteral("a corner"));
        QVERIFY(it_->surface().symmetries.empty());
        QCOMPARE(ended.count(), 1);
    }

private:
    void keepTheGap()
    {
        it_->editor->select({frontPad, rearShelf});
        QTest::keyClick(it_->editor.get(), Qt::Key_K);
    }
    static double gapOf(const AirBearingSurface& surface)
    {
        return surface.rails[2].points[0].x - surface.rails[1].points[1].x;
    }

    std::unique_ptr<EditorUnderTest> it_;
};

TOUCHDOWN_TEST(TestKeptDistances)

} // namespace test_kept_distances

#include "test_kept_distances.moc"
