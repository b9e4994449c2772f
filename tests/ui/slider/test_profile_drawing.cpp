// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/profile_drawing.h"

#include <vector>

#include <QImage>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_profile_drawing {

/// 200 px for 1 mm, 100 px for 50 nm below to 200 nm above the disk.
ProfileDrawing drawing() { return {{10.0, 20.0, 200.0, 100.0}, 1e-3, {-50e-9, 200e-9}}; }

class TestProfileDrawing : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void placesPoints();
    void cutsDeepRecesses();
    void drawsTheBodyAboveTheDisk();
    void marksMoveWithTheDisk();
};

void TestProfileDrawing::placesPoints()
{
    QCOMPARE(drawing().toPixel(0.0, -50e-9), QPointF(10.0, 120.0));
    QCOMPARE(drawing().toPixel(0.25e-3, 200e-9), QPointF(60.0, 20.0));
    QCOMPARE(drawing().toPixel(1e-3, 0.0), QPointF(210.0, 100.0)); // a fifth of the heights from below
    // 100 px / 250 nm over 200 px / 1 mm.
    QCOMPARE(drawing().exaggeration(), 2000.0);
}

void TestProfileDrawing::cutsDeepRecesses()
{
    const std::vector<double> heights{100e-9, 1e-6, 50e-9};
    const QPolygonF line = drawing().line(heights);
    QCOMPARE(line.size(), 3);
    QCOMPARE(line[0], drawing().toPixel(0.0, 100e-9));
    QCOMPARE(line[1], drawing().toPixel(0.5e-3, ProfileDrawing::ceiling * 200e-9));
    QCOMPARE(line[2], drawing().toPixel(1e-3, 50e-9));
}

void TestProfileDrawing::drawsTheBodyAboveTheDisk()
{
    QImage image(220, 160, QImage::Format_RGB32);
    const PlotTheme theme = lightPlotTheme();
    image.fill(theme.plotArea);
    {
        QPainter painter(&image);
        drawing().paintDisk(painter, theme);
        drawing().paintSlider(painter, theme.curves[0], std::vector<double>{100e-9, 100e-9});
    }
    // 100 nm is at y = 60, the disk at y = 100.
    QVERIFY(image.pixelColor(100, 40) != theme.plotArea);
    QCOMPARE(image.pixelColor(100, 80), theme.plotArea);
    QCOMPARE(image.pixelColor(100, 110), theme.grid);
    QCOMPARE(image.pixelColor(100, 130), theme.plotArea); // below the area
}

/// A step of 0.2 mm is one of the marks: the same picture again.
void TestProfileDrawing::marksMoveWithTheDisk()
{
    const auto picture = [](double distance) {
        QImage image(220, 160, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        drawing().paintMotion(painter, lightPlotTheme(), distance);
        return image;
    };
    QVERIFY(picture(0.0) != picture(0.1e-3));
    QCOMPARE(picture(0.05e-3), picture(0.25e-3));
}

TOUCHDOWN_TEST(TestProfileDrawing)

} // namespace test_profile_drawing

#include "test_profile_drawing.moc"
