// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the editor draws over the plan.
#include <memory>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_surface_editor_paint {

class TestSurfaceEditorPaint : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void init()
    {
        it_ = std::make_unique<EditorUnderTest>(sampleFilmCase());
        QVERIFY(QTest::qWaitForWindowExposed(it_->editor.get()));
    }
    void cleanup() { it_.reset(); }

    /// The front pad's wall of 10 um and the rear shelf's of 20 um meet where the pad's edge comes within 30 um of the
    /// shelf at x = 550 um, beyond the front shelf's end at 450 um. A grid of one cell resolves no edge.
    void warningsStandAtTheirPlaces()
    {
        const Case before = sampleFilmCase();
        const SurfacePart edge{PartKind::Edge, 1, 1};
        QVERIFY(it_->editor->warnings().empty());
        it_->editor->select({edge});
        const auto moveBy = [&](double by) {
            AirBearingSurface surface = moved(before.surface, {edge}, {by, 0.0});
            it_->edits->setSurface(surface, QStringLiteral("wider"));
        };
        moveBy(119e-6);
        QVERIFY(it_->editor->warnings().empty());
        moveBy(121e-6);
        QCOMPARE(it_->editor->warnings().size(), std::size_t(1));
        QVERIFY(it_->editor->problems().empty());
        const QPoint place = it_->editor->toPixel(it_->editor->warnings().front().places.front()).toPoint();
        const QImage picture = it_->editor->grab().toImage();
        const QColor ring = meaningColours(it_->editor->palette()).warning;
        int found = 0;
        for (int i = -10; i <= 10; ++i) found += picture.pixelColor(place + QPoint(i, 0)) == ring;
        QVERIFY(found >= 2);
        // Its sentence stands on the plan at once: without the ghost it is new; as part of the opened shape it is told
        // where the pointer is.
        const auto light = [&] {
            const QImage image = it_->editor->grab().toImage();
            int pixels = 0;
            for (int x = -60; x <= 60; ++x)
                for (int y = 16; y <= 30; ++y) pixels += image.pixelColor(place + QPoint(x, y)).lightness() > 200;
            return pixels;
        };
        const int told = light();
        it_->editor->setGhost(it_->edits->value().surface);
        QVERIFY(light() < told / 2);
        it_->edits->open(before);
        it_->editor->setGridOf([](const AirBearingSurface&) { return CellGrid{{0.0, 1e-3}, {0.0, 1e-3}}; });
        it_->edits->setSurface(moved(before.surface, {edge}, {1e-6, 0.0}), QStringLiteral("wider"));
        QCOMPARE(it_->editor->warnings().size(), before.surface.rails.size());
    }

private:
    std::unique_ptr<EditorUnderTest> it_;
};

TOUCHDOWN_TEST(TestSurfaceEditorPaint)

} // namespace test_surface_editor_paint

#include "test_surface_editor_paint.moc"
