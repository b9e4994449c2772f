// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/fields_view.h"

#include <memory>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/plot/paper_figure.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_fields_view {

class TestFieldsView : public QObject {
    Q_OBJECT

private slots:
    void aFigureIsTheSameInBothThemes();
};

/// Of a field with both signs, and whether or not there are cursors on the screen, which stay there.
void TestFieldsView::aFigureIsTheSameInBothThemes()
{
    FieldsView view;
    view.resize(800, 700);
    view.map()->setSlider(0.8e-3, 0.6e-3);
    view.setKinds({{QStringLiteral("Pressure"), {"kPa"}, MapKind::Colours::Signed}});
    view.setFields({{0.0, 0.2e-3, 0.4e-3, 0.6e-3, 0.8e-3}, {0.0, 0.3e-3, 0.6e-3}},
                   {{-1e3, 2e3, -3e3, 4e3, 5e3, -6e3, 7e3, 8e3}});
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    const auto figure = [&view] {
        const PaperFigure made({view.map()}, {});
        const Picture picture = made.picture();
        QImage image(picture.size.toSize(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        picture.paint(painter);
        return image;
    };
    const auto screen = [&view] { return view.map()->grab().toImage(); };
    applyTheme(Theme::Light);
    QTRY_VERIFY(screen().pixelColor(2, 2).lightness() > 128);
    const QImage inLight = figure();
    applyTheme(Theme::Dark);
    QTRY_VERIFY(screen().pixelColor(2, 2).lightness() < 128);
    QCOMPARE(figure(), inLight);
    const QImage before = screen();
    view.setSectionPoint({0.3e-3, 0.4e-3}, true);
    view.setSecondPoint(SurfacePoint{0.7e-3, 0.1e-3});
    const QImage after = screen();
    QVERIFY(after != before);
    QCOMPARE(figure(), inLight);
    QCOMPARE(screen(), after);
    applyTheme(Theme::Light);
}

TOUCHDOWN_TEST(TestFieldsView)

} // namespace test_fields_view

#include "test_fields_view.moc"
