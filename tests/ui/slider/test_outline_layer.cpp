// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/outline_layer.h"

#include <algorithm>
#include <cstdlib>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/slider/slider_plan.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_outline_layer {

/// A plan of outlines alone, through a layer or one by one.
class OutlinePlan : public SliderPlan {
public:
    explicit OutlinePlan(bool layered) : layered_(layered)
    {
        resize(600, 500);
        setSlider(0.85e-3, 0.70e-3);
    }
    QImage pictureOf(const std::vector<Rail>& rails)
    {
        rails_ = rails;
        return grab().toImage();
    }

    OutlineLayer layer;

protected:
    void paintContent(QPainter& painter, const PlotTheme&) override
    {
        if (layered_)
            layer.paint(painter, *this, rails_);
        else
            for (const Rail& rail : rails_) paintRailOutline(painter, *this, rail, false);
    }
    void paintKey(QPainter&, const QRectF&, const PlotTheme&) override {}
    double keyWidth() const override { return 10.0; }

private:
    bool layered_;
    std::vector<Rail> rails_;
};

int largestDifference(const QImage& a, const QImage& b)
{
    if (a.size() != b.size()) return 255;
    int largest = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            largest = std::max(
                {largest, std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
        }
    return largest;
}

void shift(Rail& rail, double by)
{
    for (RailPoint& point : rail.points) point.x += by;
}

class TestOutlineLayer : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }

    /// To the rounding of colours, whatever moves: rails of the sample do not touch each other.
    void looksAsDrawnOneByOne()
    {
        OutlinePlan layered(true), plain(false);
        std::vector<Rail> rails = sampleSurface().rails;
        const auto same = [&] { return largestDifference(layered.pictureOf(rails), plain.pictureOf(rails)) <= 3; };
        QVERIFY(same());
        QCOMPARE(layered.layer.drawnAlone(), std::size_t{0});
        for (int i = 0; i < 3; ++i) {
            shift(rails[1], 5e-6);
            QVERIFY(same());
            QCOMPARE(layered.layer.drawnAlone(), std::size_t{1});
        }
        shift(rails[3], -5e-6);
        QVERIFY(same());
        QCOMPARE(layered.layer.drawnAlone(), std::size_t{2});
        rails.erase(rails.begin() + 1);
        QVERIFY(same());
        QCOMPARE(layered.layer.drawnAlone(), std::size_t{0});
        layered.zoom(1.5, {200.0, 200.0});
        plain.zoom(1.5, {200.0, 200.0});
        QVERIFY(same());
        layered.resize(500, 600);
        plain.resize(500, 600);
        QVERIFY(same());
        QVERIFY(largestDifference(layered.pictureOf({}), plain.pictureOf(rails)) > 50); // the check sees outlines
    }

    /// Where many move, as with Ctrl+A, each alone would take as long as all.
    void manyAreOnePicture()
    {
        OutlinePlan layered(true);
        std::vector<Rail> rails;
        for (int i = 0; i < 10; ++i) rails.push_back(sampleSurface().rails[1]);
        layered.pictureOf(rails);
        for (Rail& rail : rails) shift(rail, 1e-6);
        layered.pictureOf(rails);
        QCOMPARE(layered.layer.drawnAlone(), std::size_t{0});
    }
};

TOUCHDOWN_TEST(TestOutlineLayer)

} // namespace test_outline_layer

#include "test_outline_layer.moc"
