// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the editor draws over the plan.
#include <cmath>
#include <memory>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"
#include "ui/plot/colour_scale.h"
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

    /// Rails are filled by their influence alone, and an arrow in black with a white rim goes out of an edge: 0.5 nm
    /// per 10 nm, the largest, is the end of the colours, half of it on the other side lies a quarter from the other
    /// end, 0.036 nm per µm has its two digits.
    void influenceIsSeen()
    {
        SurfaceEditor& editor = *it_->editor;
        const ShownInfluence influence{
            {{PartKind::Rail, 1}, 0.05}, {{PartKind::Rail, 2}, -0.025}, {{PartKind::Edge, 1, 1}, 0.036e-3}};
        const QRectF plan = editor.planArea();
        editor.setInfluence(influence);
        QCOMPARE(editor.planArea(), plan);
        QVERIFY(editor.influenceWords().contains(QStringLiteral("0.50\u00A0nm")));
        QVERIFY(editor.influenceWords().contains(QStringLiteral("0.036\u00A0nm per µm")));
        const QImage picture = editor.grab().toImage();
        const auto inside = [&](std::size_t rail) {
            const auto& points = it_->surface().rails[rail].points;
            return editor.toPixel({points[0].x, points[0].y}).toPoint() + QPoint(4, -4);
        };
        const auto near = [&](const QPoint& at, const QColor& colour) {
            const QColor seen = picture.pixelColor(at);
            return std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                       std::abs(seen.blue() - colour.blue()) <
                   12;
        };
        QVERIFY(near(inside(1), mapColour(ColourMap::DivergingOnLight, 1.0)));
        QVERIFY(near(inside(2), mapColour(ColourMap::DivergingOnLight, 0.25)));
        const auto& points = it_->surface().rails[1].points;
        const QPoint middle =
            editor.toPixel({0.5 * (points[1].x + points[2].x), 0.5 * (points[1].y + points[2].y)}).toPoint();
        int black = 0, white = 0;
        for (int i = -8; i <= 8; ++i) {
            const QColor seen = picture.pixelColor(middle + QPoint(20, i));
            black += seen.lightness() < 40;
            white += seen.lightness() > 250;
        }
        QVERIFY(black >= 1 && white >= 1);
    }

private:
    std::unique_ptr<EditorUnderTest> it_;
};

TOUCHDOWN_TEST(TestSurfaceEditorPaint)

} // namespace test_surface_editor_paint

#include "test_surface_editor_paint.moc"
