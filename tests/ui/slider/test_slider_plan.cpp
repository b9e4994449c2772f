// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/slider_plan.h"

#include <cmath>
#include <memory>

#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_slider_plan {

constexpr double longSide = 0.8e-3;  // [m]
constexpr double shortSide = 0.4e-3; // [m]

/// Paints its slider red, and has a key of 50 pixels.
class RedPlan : public SliderPlan {
public:
    using SliderPlan::SliderPlan;

protected:
    void paintContent(QPainter& painter, const PlotTheme&) override
    {
        painter.fillRect(QRectF(toPixel({0.0, shortSide}), toPixel({longSide, 0.0})), Qt::red);
    }
    void paintKey(QPainter& painter, const QRectF& column, const PlotTheme&) override
    {
        painter.fillRect(column, Qt::blue);
    }
    double keyWidth() const override { return 50.0; }
};

bool near(const QPointF& a, const QPointF& b, double within = 1e-6)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y()) < within;
}

/// The window system's pointer is not the test's to move.
void moveMouse(QWidget* widget, const QPointF& to, Qt::MouseButtons held = Qt::NoButton)
{
    QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, held, Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
}

int pixelsOf(const QImage& image, QRgb colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour;
    return count;
}

class TestSliderPlan : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qRegisterMetaType<std::optional<SurfacePoint>>(); }
    void init();
    void showsTheSliderInTrueProportions();
    void xRunsRightAndYUp();
    void pixelsAndPointsAgree();
    void fitsAgainWhenResized();
    void wheelKeepsThePointUnderThePointer();
    void draggingCarriesTheSliderAlong();
    void aClickChoosesAPointADragDoesNot();
    void doubleClickFits();
    void pointsOnlyOnTheSlider();
    void keysMoveZoomAndFit();
    void someOfTheSliderStaysInSight();
    void zoomHasEnds();
    void paintsIntoAPictureOfAnotherSize();
    void arrowTurnsWithTheSkew();

private:
    std::unique_ptr<RedPlan> plan_;
};

void TestSliderPlan::init()
{
    plan_ = std::make_unique<RedPlan>();
    plan_->resize(700, 500);
    plan_->setSlider(longSide, shortSide);
    plan_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plan_.get()));
}

void TestSliderPlan::showsTheSliderInTrueProportions()
{
    const QPointF origin = plan_->toPixel({0.0, 0.0});
    const QPointF corner = plan_->toPixel({longSide, shortSide});
    // Twice as long as wide.
    QVERIFY(std::abs((corner.x() - origin.x()) - 2.0 * (origin.y() - corner.y())) < 1e-9);
    QVERIFY(plan_->planArea().contains(QRectF(origin, corner).normalized()));
    // It fills most of what there is: the names of the edges and the arrow need the rest.
    QVERIFY((corner.x() - origin.x()) > 0.75 * plan_->planArea().width());
}

void TestSliderPlan::xRunsRightAndYUp()
{
    QVERIFY(plan_->toPixel({0.5e-3, 0.0}).x() > plan_->toPixel({0.1e-3, 0.0}).x());
    QVERIFY(plan_->toPixel({0.0, 0.3e-3}).y() < plan_->toPixel({0.0, 0.1e-3}).y());
}

void TestSliderPlan::pixelsAndPointsAgree()
{
    plan_->zoom(3.7, {300, 200});
    plan_->pan({-12, 31});
    for (const QPointF& pixel : {QPointF(90, 40), QPointF(333.25, 201.5), QPointF(600, 400)})
        QVERIFY(near(plan_->toPixel(plan_->toSlider(pixel)), pixel));
    // What is seen is what lies between the corners of the plan.
    QVERIFY(near(plan_->toPixel({plan_->view().left(), plan_->view().bottom()}), plan_->planArea().topLeft()));
    QVERIFY(near(plan_->toPixel({plan_->view().right(), plan_->view().top()}), plan_->planArea().bottomRight()));
}

void TestSliderPlan::fitsAgainWhenResized()
{
    const double before = plan_->toPixel({longSide, 0.0}).x() - plan_->toPixel({0.0, 0.0}).x();
    plan_->resize(1400, 1000);
    const double after = plan_->toPixel({longSide, 0.0}).x() - plan_->toPixel({0.0, 0.0}).x();
    QVERIFY(after > 1.8 * before);
    // A view that was chosen keeps its scale.
    plan_->zoom(2.0, plan_->planArea().center());
    QVERIFY(!plan_->isFitted());
    const double chosen = plan_->toPixel({longSide, 0.0}).x() - plan_->toPixel({0.0, 0.0}).x();
    plan_->resize(700, 500);
    QVERIFY(std::abs(plan_->toPixel({longSide, 0.0}).x() - plan_->toPixel({0.0, 0.0}).x() - chosen) < 1e-6);
}

void TestSliderPlan::wheelKeepsThePointUnderThePointer()
{
    const QPointF at = plan_->toPixel({0.6e-3, 0.1e-3});
    QWheelEvent wheel(at, plan_->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    const double before = plan_->view().width();
    QApplication::sendEvent(plan_.get(), &wheel);
    // Two notches of a quarter each.
    QVERIFY(std::abs(before / plan_->view().width() - 1.5625) < 1e-9);
    QVERIFY(near(plan_->toPixel({0.6e-3, 0.1e-3}), at));
}

void TestSliderPlan::draggingCarriesTheSliderAlong()
{
    const SurfacePoint held = plan_->toSlider({300, 200});
    QTest::mousePress(plan_.get(), Qt::LeftButton, {}, {300, 200});
    moveMouse(plan_.get(), {340, 230}, Qt::LeftButton);
    moveMouse(plan_.get(), {360, 250}, Qt::LeftButton);
    QTest::mouseRelease(plan_.get(), Qt::LeftButton, {}, {360, 250});
    QVERIFY(near(plan_->toPixel(held), {360, 250}));
}

void TestSliderPlan::aClickChoosesAPointADragDoesNot()
{
    QSignalSpy chosen(plan_.get(), &SliderPlan::chosen);
    const QPoint at = plan_->toPixel({0.3e-3, 0.2e-3}).toPoint();
    QTest::mouseClick(plan_.get(), Qt::LeftButton, {}, at);
    QCOMPARE(chosen.count(), 1);
    const auto point = chosen[0][0].value<SurfacePoint>();
    // To the rounding of a pixel.
    const double pixel = plan_->view().width() / plan_->planArea().width();
    QVERIFY(std::abs(point.x - 0.3e-3) <= pixel && std::abs(point.y - 0.2e-3) <= pixel);

    QTest::mousePress(plan_.get(), Qt::LeftButton, {}, at);
    moveMouse(plan_.get(), at + QPoint(30, 0), Qt::LeftButton);
    QTest::mouseRelease(plan_.get(), Qt::LeftButton, {}, at + QPoint(30, 0));
    QCOMPARE(chosen.count(), 1);
    QTest::mouseClick(plan_.get(), Qt::LeftButton, {},
                      plan_->planArea().topLeft().toPoint() + QPoint(2, 2)); // beside the slider
    QCOMPARE(chosen.count(), 1);
}

void TestSliderPlan::doubleClickFits()
{
    const QRectF whole = plan_->view();
    plan_->zoom(5.0, {200, 200});
    QVERIFY(plan_->view().width() < 0.5 * whole.width());
    QTest::mouseDClick(plan_.get(), Qt::LeftButton, {}, {250, 250});
    QVERIFY(plan_->isFitted());
    QVERIFY(std::abs(plan_->view().width() - whole.width()) < 1e-12);
}

void TestSliderPlan::pointsOnlyOnTheSlider()
{
    QSignalSpy pointed(plan_.get(), &SliderPlan::pointed);
    moveMouse(plan_.get(), plan_->toPixel({0.3e-3, 0.2e-3}));
    QCOMPARE(pointed.count(), 1);
    QVERIFY(pointed.last()[0].value<std::optional<SurfacePoint>>().has_value());
    moveMouse(plan_.get(), plan_->planArea().topLeft() + QPointF(3, 3));
    QCOMPARE(pointed.count(), 2);
    QVERIFY(!pointed.last()[0].value<std::optional<SurfacePoint>>().has_value());
}

void TestSliderPlan::keysMoveZoomAndFit()
{
    const double middle = plan_->view().center().x();
    QTest::keyClick(plan_.get(), Qt::Key_Right);
    QVERIFY(plan_->view().center().x() > middle);
    QTest::keyClick(plan_.get(), Qt::Key_Left);
    QVERIFY(std::abs(plan_->view().center().x() - middle) < 1e-12);
    const double seen = plan_->view().width();
    QTest::keyClick(plan_.get(), Qt::Key_Plus);
    QVERIFY(std::abs(plan_->view().width() - seen / 1.25) < 1e-12);
    QTest::keyClick(plan_.get(), Qt::Key_Minus);
    QVERIFY(std::abs(plan_->view().width() - seen) < 1e-12);
    QTest::keyClick(plan_.get(), Qt::Key_Home);
    QVERIFY(plan_->isFitted());
}

void TestSliderPlan::someOfTheSliderStaysInSight()
{
    plan_->pan({1e5, -1e5});
    QVERIFY(plan_->planArea().intersects(QRectF(plan_->toPixel({0.0, shortSide}), plan_->toPixel({longSide, 0.0}))));
}

void TestSliderPlan::zoomHasEnds()
{
    for (int i = 0; i < 200; ++i) plan_->zoom(2.0, {300, 200});
    QVERIFY(plan_->view().width() > 1e-7); // a tenth of a micrometre is still seen
    for (int i = 0; i < 200; ++i) plan_->zoom(0.5, {300, 200});
    QVERIFY(plan_->view().width() < 10.0 * longSide);
}

void TestSliderPlan::paintsIntoAPictureOfAnotherSize()
{
    // The red area of a picture of twice the size has four times the pixels.
    const auto red = [this](int factor) {
        QImage image(plan_->size() * factor, QImage::Format_RGB32);
        QPainter painter(&image);
        plan_->paintInto(painter, image.rect(), lightPlotTheme());
        painter.end();
        return pixelsOf(image, qRgb(255, 0, 0));
    };
    const double once = red(1);
    QVERIFY(once > 10'000.0);
    QVERIFY2(std::abs(red(2) / once - 4.0) < 0.1, qPrintable(QString::number(red(2) / once)));
}

void TestSliderPlan::arrowTurnsWithTheSkew()
{
    // Left of the slider's middle stands the arrow in a wide place; a flow from the outer edge enters from above.
    plan_->resize(900, 600);
    const auto ink = [this](bool upper) {
        const QImage image = plan_->grab().toImage();
        const QPointF middle = plan_->toPixel({0.0, 0.5 * shortSide});
        int dark = 0;
        for (int dx = 60; dx > 25; --dx)
            for (int dy = 3; dy < 30; ++dy) {
                const QPoint at(static_cast<int>(middle.x()) - dx, static_cast<int>(middle.y()) + (upper ? -dy : dy));
                dark += image.rect().contains(at) && qGray(image.pixel(at)) < 140;
            }
        return dark;
    };
    plan_->setSkew(0.5);
    const int above = ink(true);
    const int below = ink(false);
    plan_->setSkew(-0.5);
    QVERIFY2(above > below, qPrintable(QStringLiteral("%1 %2").arg(above).arg(below)));
    QVERIFY(ink(false) > ink(true));
}

TOUCHDOWN_TEST(TestSliderPlan)

} // namespace test_slider_plan

#include "test_slider_plan.moc"
