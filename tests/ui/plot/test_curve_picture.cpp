// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_picture.h"

#include <cmath>
#include <deque>
#include <memory>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/plot/cold_samples.h"
#include "ui/plot/plot_widget.h"

using namespace touchdown;

namespace test_curve_picture {

constexpr int earlier = 20; // runs

class TestCurvePicture : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { plot_.reset(); }

    void drawsEachLineOnce();
    void addsOnlyWhatIsNew();
    void drawsAnewWhenTheViewChanges();
    void holdsNeitherTheNewestNorWhatGrows();
    void showsPaleLines();
    void takesOtherDataAtTheSamePlace();
    void drawsAgainWhenTheDiskIsRead();

private:
    void add(int run, bool leads);

    std::deque<MinMaxPyramid> data_;
    std::unique_ptr<PlotWidget> plot_;
};

/// Level lines: run k at k nm.
void TestCurvePicture::add(int run, bool leads)
{
    MinMaxPyramid& data = data_.emplace_back();
    for (int k = 0; k <= 1000; ++k) data.append(std::vector{1e-6 * k}, std::vector{1e-9 * run});
    PlotCurve curve{QStringLiteral("run %1").arg(run), QStringLiteral("Run %1").arg(run), {0, 0}, &data};
    curve.pale = !leads;
    curve.leads = leads;
    curve.still = !leads;
    plot_->addCurve(curve);
}

void TestCurvePicture::init()
{
    data_.clear();
    plot_ = std::make_unique<PlotWidget>();
    plot_->resize(700, 300);
    plot_->setXLabel({"Time", "ms", 1e-3, AxisScale::Linear});
    plot_->setYLabel({"Spacing", "nm", 1e-9, AxisScale::Linear});
    for (int run = 1; run <= earlier; ++run) add(run, false);
    add(earlier + 1, true);
    plot_->setView({std::nullopt, PlotRange{0.0, 30e-9}});
    plot_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plot_.get()));
    plot_->refreshNow();
}

void TestCurvePicture::drawsEachLineOnce()
{
    QCOMPARE(plot_->stillPicture().linesDrawn(), earlier);
    // The newest run continues within the same view: nothing else is drawn.
    for (int k = 0; k < 10; ++k) {
        data_.back().append(std::vector{1e-3}, std::vector{21e-9 + 1e-10 * k});
        plot_->refreshNow();
    }
    QCOMPARE(plot_->stillPicture().linesDrawn(), earlier);
}

void TestCurvePicture::addsOnlyWhatIsNew()
{
    plot_->updateCurves([](PlotCurve& curve) { curve.leads = false, curve.pale = curve.still = true; });
    add(earlier + 2, true);
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), earlier + 1);
    plot_->removeCurve(QStringLiteral("run 3")); // out of the middle: all others once more
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), earlier + 1 + earlier);
}

void TestCurvePicture::drawsAnewWhenTheViewChanges()
{
    plot_->setView({PlotRange{0.0, 0.5e-3}, PlotRange{0.0, 30e-9}});
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), 2 * earlier);
    plot_->resize(600, 300);
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), 3 * earlier);
    QPalette dark = plot_->palette();
    dark.setColor(QPalette::Base, Qt::black);
    dark.setColor(QPalette::Text, Qt::white);
    plot_->setPalette(dark);
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), 4 * earlier);
}

void TestCurvePicture::holdsNeitherTheNewestNorWhatGrows()
{
    const auto held = [this] {
        int count = 0;
        for (const PlotCurve& curve : plot_->curves()) count += CurvePicture::holds(curve) ? 1 : 0;
        return count;
    };
    QCOMPARE(held(), earlier);
    plot_->updateCurves([](PlotCurve& curve) { curve.still = curve.id != QStringLiteral("run 1"); });
    QCOMPARE(held(), earlier - 1);
    plot_->setCurveVisible(QStringLiteral("run 2"), false);
    QCOMPARE(held(), earlier - 2);
}

void TestCurvePicture::showsPaleLines()
{
    const QImage image = plot_->grab().toImage().convertToFormat(QImage::Format_RGB32);
    const auto lineAt = [&](double height, const QColor& colour) {
        const int y = static_cast<int>(std::lround(plot_->toPixel(0.0, height).y() * image.devicePixelRatio()));
        const int x = image.width() / 2;
        for (int row = y - 2; row <= y + 2; ++row) {
            const QColor pixel = image.pixelColor(x, row);
            const int apart = std::abs(pixel.red() - colour.red()) + std::abs(pixel.green() - colour.green()) +
                              std::abs(pixel.blue() - colour.blue());
            if (apart < 70) return true;
        }
        return false;
    };
    QVERIFY(lineAt(21e-9, plot_->theme().colour({0, 0})));
    QVERIFY(!lineAt(5e-9, plot_->theme().colour({0, 0})));
    // A line of one pixel may share two rows.
    const QColor pale = plot_->theme().paleColour({0, 0}), paper = plot_->theme().plotArea;
    const QColor half((pale.red() + paper.red()) / 2, (pale.green() + paper.green()) / 2,
                      (pale.blue() + paper.blue()) / 2);
    QVERIFY(lineAt(5e-9, pale) || lineAt(5e-9, half));
    QVERIFY(!lineAt(25.5e-9, pale) && !lineAt(25.5e-9, half));
}

void TestCurvePicture::takesOtherDataAtTheSamePlace()
{
    plot_->clearCurves();
    plot_->refreshNow();
    MinMaxPyramid& data = data_.emplace_back();
    data.append(std::vector{0.0, 1e-3}, std::vector{1e-9, 1e-9});
    PlotCurve curve{QStringLiteral("difference"), QString(), {0, 0}, &data};
    curve.pale = curve.still = true;
    curve.leads = false;
    plot_->addCurve(curve);
    plot_->refreshNow();
    const long long before = plot_->stillPicture().linesDrawn();
    data = MinMaxPyramid();
    data.append(std::vector{0.0, 1e-3}, std::vector{2e-9, 2e-9});
    plot_->clearCurves();
    plot_->addCurve(curve);
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), before + 1);
}

/// Until then the curve is coarse; nobody has to move the plot. Also the picture of still curves is drawn again.
void TestCurvePicture::drawsAgainWhenTheDiskIsRead()
{
    plot_->clearCurves();
    MinMaxPyramid &moving = data_.emplace_back(), &still = data_.emplace_back();
    for (MinMaxPyramid* data : {&moving, &still})
        for (std::size_t k = 0; k < 3 * SampleColumn::pieceSize; ++k)
            data->append(std::vector{1e-9 * static_cast<double>(k)},
                         std::vector{1e-9 * std::sin(0.01 * static_cast<double>(k))});
    PlotCurve curve{QStringLiteral("moving"), QString(), {0, 0}, &moving};
    plot_->addCurve(curve);
    plot_->refreshNow(); // nothing else is to be drawn now
    if (!makeCold(moving)) QSKIP("this system does not drop pages on request");
    const long long before = plot_->refreshes();
    plot_->refreshNow(); // coarse: the reading begins
    QCOMPARE(plot_->refreshes(), before + 1);
    QTRY_VERIFY(plot_->refreshes() > before + 1);
    const auto waits = [this] {
        bool any = false;
        plot_->curvePath(plot_->curves().front(), &any);
        return any;
    };
    QTRY_VERIFY(!waits());
    plot_->refreshNow();
    const long long after = plot_->refreshes();
    QTest::qWait(200); // longer than a waiting curve rests: only time shows that nothing comes
    QCOMPARE(plot_->refreshes(), after);

    if (!makeCold(still)) QSKIP("this system does not drop pages on request");
    const long long linesBefore = plot_->stillPicture().linesDrawn();
    curve.id = QStringLiteral("still");
    curve.data = &still;
    curve.pale = curve.still = true;
    curve.leads = false;
    plot_->addCurve(curve);
    plot_->refreshNow();
    QCOMPARE(plot_->stillPicture().linesDrawn(), linesBefore + 1);
    QTRY_VERIFY(plot_->stillPicture().linesDrawn() > linesBefore + 1);
}

TOUCHDOWN_TEST(TestCurvePicture)

} // namespace test_curve_picture

#include "test_curve_picture.moc"
