// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_picture.h"

#include <array>
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
    void add(double run, bool leads);

    std::deque<MinMaxPyramid> data_;
    std::unique_ptr<PlotWidget> plot_;
};

/// Level lines: run k at k nm.
void TestCurvePicture::add(double run, bool leads)
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

/// A line of one pixel may share its colour between two rows: its ink, the colour that it takes from the paper summed
/// over the rows, is that of a line of its width in the pale colour, wherever it stands.
void TestCurvePicture::showsPaleLines()
{
    const auto image = [this] {
        plot_->refreshNow();
        return plot_->grab().toImage().convertToFormat(QImage::Format_RGB32);
    };
    const auto show = [this](double run, bool on) {
        const QString id = QStringLiteral("run %1").arg(run);
        plot_->updateCurves([&](PlotCurve& curve) { curve.visible = curve.id == id ? on : curve.visible; });
    };
    const QColor paper = plot_->theme().plotArea;
    const auto part = [](const QColor& colour) { return std::array{colour.redF(), colour.greenF(), colour.blueF()}; };
    for (const double run : {4.3, 4.5, 7.0, 11.8}) { // also on a line of the grid
        if (run != 7.0) add(run, false);
        const QImage with = image();
        show(run, false);
        const QImage without = image();
        show(run, true);
        const QColor pale = plot_->theme().paleColour({0, 0});
        const int y = static_cast<int>(std::lround(plot_->toPixel(0.0, 1e-9 * run).y() * with.devicePixelRatio()));
        const int x = with.width() / 2;
        double ink = 0.0, whole = 0.0;
        for (std::size_t k = 0; k < 3; ++k) whole += std::pow(part(paper)[k] - part(pale)[k], 2);
        for (int row = y - 3; row <= y + 3; ++row)
            for (std::size_t k = 0; k < 3; ++k)
                ink += (part(without.pixelColor(x, row))[k] - part(with.pixelColor(x, row))[k]) *
                       (part(paper)[k] - part(pale)[k]) / whole;
        const double width = plot_->theme().width;
        QVERIFY2(ink > 0.85 * width && ink < 1.1 * width, qPrintable(QStringLiteral("%1: %2").arg(run).arg(ink)));
    }
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
