// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/surface_page.h"

#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_surface_page {

class TestSurfacePage : public QObject {
    Q_OBJECT

private slots:
    /// Two cells, the right one with the larger pressure: U shows both in the colours of a scale about zero.
    void theKeyUShowsThePressure()
    {
        SurfacePage page;
        page.resize(1000, 800);
        const Case c = sampleFilmCase();
        page.setCase(c);
        page.show();
        SurfaceEditor& editor = *page.editor();
        const auto press = [&] { QTest::keyClick(&editor, Qt::Key_U); };
        press();
        QVERIFY(!editor.showsPressure()); // nothing is solved
        const double length = c.slider.length, width = c.slider.width;
        editor.setGrid({{0.0, 0.5 * length, length}, {0.0, width}});
        page.setPressure({-1e3, 5e5});
        QVERIFY(!editor.showsPressure());
        const SurfacePoint left{0.25 * length, 0.03 * width}, right{0.75 * length, 0.03 * width}; // beside the rails
        const auto colourAt = [&](const SurfacePoint& at) {
            return editor.grab().toImage().pixelColor(editor.toPixel(at).toPoint());
        };
        const QColor recess = colourAt(right);
        press();
        QVERIFY(editor.showsPressure());
        const bool dark = plotTheme(editor.palette()).background.lightness() < 128;
        const ColourMap map = dark ? ColourMap::DivergingOnDark : ColourMap::DivergingOnLight;
        const ColourScale scale = ColourScale::aboutZero(map, -1e3, 5e5);
        QCOMPARE(colourAt(left), QColor(scale.colour(-1e3)));
        QCOMPARE(colourAt(right), QColor(scale.colour(5e5)));
        page.setPressureStale(true);
        QVERIFY(colourAt(right) != QColor(scale.colour(5e5))); // pale
        page.setPressureStale(false);
        QCOMPARE(colourAt(right), QColor(scale.colour(5e5)));
        // The influence has the colours for itself.
        QTest::keyClick(&editor, Qt::Key_I);
        QVERIFY(page.showsInfluence() && !editor.showsPressure());
        press();
        QVERIFY(!page.showsInfluence() && editor.showsPressure());
        press();
        QVERIFY(!editor.showsPressure());
        QTRY_COMPARE(colourAt(right), recess);
        press();
        page.setPressure({});
        QVERIFY(!editor.showsPressure());
    }
};

TOUCHDOWN_TEST(TestSurfacePage)

} // namespace test_surface_page

#include "test_surface_page.moc"
