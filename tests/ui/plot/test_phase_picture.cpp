// SPDX-License-Identifier: GPL-3.0-or-later
//
// Portraits of many samples: the picture that comes from the other thread is the full drawing, and until it comes the
// one before stands at its place.
#include "ui/plot/phase_picture.h"

#include <cmath>
#include <memory>
#include <random>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/plot/plot_path.h"
#include "ui/plot/plot_widget.h"

using namespace touchdown;

namespace test_phase_picture {

constexpr int count = 250'000;

class TestPhasePicture : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { plot_.reset(); }

    void isTheFullDrawing_data();
    void isTheFullDrawing();
    void movesUntilTheNextComes();
    void followsTheNewestView();
    void showsNothingOfARemovedCurve();
    void anotherRunAtTheSamePlaceIsNotTheOneBefore();
    void aSavedPictureHasItsArrows();
    void fewSamplesAreDrawnAtOnce();

private:
    void fill(const std::function<QPointF(double)>& at, int samples = count);
    void addCurve();
    QImage fullDrawing() const;
    bool ready() const { return !plot_->phasePicture().busy() && !plot_->phasePicture().image().isNull(); }

    std::unique_ptr<MinMaxPyramid> x_, y_;
    std::unique_ptr<PlotWidget> plot_;
};

void TestPhasePicture::init()
{
    plot_ = std::make_unique<PlotWidget>();
    plot_->resize(500, 400);
    plot_->setPhasePortrait(true);
    plot_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plot_.get()));
}

void TestPhasePicture::fill(const std::function<QPointF(double)>& at, int samples)
{
    x_ = std::make_unique<MinMaxPyramid>();
    y_ = std::make_unique<MinMaxPyramid>(x_->times());
    std::vector<double> times, across, up;
    for (int k = 0; k < samples; ++k) {
        times.push_back(k);
        const QPointF point = at(static_cast<double>(k) / samples);
        across.push_back(point.x());
        up.push_back(point.y());
    }
    x_->append(times, across);
    y_->append(times, up);
}

void TestPhasePicture::addCurve()
{
    PlotCurve curve{QStringLiteral("run 1/y"), QStringLiteral("Run 1"), {0, 0}, y_.get(), x_.get()};
    curve.arrows = true;
    plot_->addCurve(curve);
    plot_->refreshNow();
}

/// Every sample at once, as the thread of the window draws a shorter curve.
QImage TestPhasePicture::fullDrawing() const
{
    const QRectF area(QPointF(), plot_->plotArea().size());
    QImage image(area.size().toSize(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotCurve& curve = plot_->curves().front();
    const std::vector<QPointF> path = plot_->curvePath(curve);
    painter.setPen(pathPen(curve, path, area.size(), plot_->theme()));
    drawPath(painter, path, area);
    drawArrows(painter, path, area, plot_->theme().colour(curve.style));
    return image;
}

void TestPhasePicture::isTheFullDrawing_data()
{
    QTest::addColumn<int>("kind");
    QTest::addRow("noise") << 0;
    QTest::addRow("chirp") << 1;
    QTest::addRow("spiral") << 2;
    QTest::addRow("rare spike") << 3;
}

/// Of drawn curves, in drawn views.
void TestPhasePicture::isTheFullDrawing()
{
    QFETCH(const int, kind);
    std::mt19937 generator(static_cast<unsigned>(kind + 1));
    std::uniform_real_distribution<double> drawn(-1.0, 1.0);
    const int spike = std::uniform_int_distribution(1, count - 2)(generator);
    fill([&](double part) -> QPointF {
        if (kind == 0) return {drawn(generator), drawn(generator)};
        if (kind == 1) return {std::sin(3e4 * part * part), std::cos(2e4 * part * part)};
        if (kind == 2) return {part * std::sin(3e3 * part), part * std::cos(3e3 * part)};
        const bool is = std::lround(part * count) == spike;
        return {0.1 * std::sin(900.0 * part), is ? 1.0 : 0.1 * std::cos(900.0 * part)};
    });
    addCurve();
    QTRY_VERIFY(ready());
    QCOMPARE(plot_->phasePicture().image(), fullDrawing());
    // A view of another part.
    for (int draw = 0; draw < 3; ++draw) {
        const double x = 0.5 * drawn(generator), y = 0.5 * drawn(generator),
                     width = 0.1 + 0.3 * (1.0 + drawn(generator));
        plot_->setView({PlotRange{x, x + width}, PlotRange{y, y + width}});
        plot_->setTimeWindow(draw == 0 ? std::optional<PlotRange>() : PlotRange{0.01 * count, 0.99 * count});
        plot_->refreshNow();
        QTRY_VERIFY(ready());
        QCOMPARE(plot_->phasePicture().image(), fullDrawing());
    }
}

/// A view that moved by some pixels shows the picture moved by as many.
void TestPhasePicture::movesUntilTheNextComes()
{
    fill([](double part) { return QPointF(part * std::sin(300.0 * part), part * std::cos(300.0 * part)); });
    plot_->setView({PlotRange{-1.0, 1.0}, PlotRange{-1.0, 1.0}});
    addCurve();
    QTRY_VERIFY(ready());
    const QRect area = plot_->plotArea().toAlignedRect().adjusted(2, 2, -2, -2);
    const auto painted = [&] {
        QImage image(plot_->size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        plot_->phasePicture().paint(painter);
        painter.end();
        return image.copy(area);
    };
    const QImage before = painted();
    constexpr int by = 40;
    const double step = 2.0 * by / plot_->plotArea().width();
    plot_->setView({PlotRange{-1.0 + step, 1.0 + step}, PlotRange{-1.0, 1.0}}); // not refreshed yet
    const QImage moved = painted();
    double difference = 0.0;
    int dark = 0;
    for (int row = 0; row < moved.height(); ++row)
        for (int column = 0; column + by < moved.width(); ++column) {
            const int there = qGray(before.pixel(column + by, row));
            difference += std::abs(qGray(moved.pixel(column, row)) - there);
            dark += there < 200 ? 1 : 0;
        }
    QVERIFY2(difference < 5.0 * dark, qPrintable(QString::number(difference / dark)));
    QVERIFY(dark > 5000);
    plot_->refreshNow();
    QTRY_VERIFY(ready());
    QCOMPARE(plot_->phasePicture().image(), fullDrawing());
}

void TestPhasePicture::followsTheNewestView()
{
    fill([](double part) { return QPointF(std::sin(900.0 * part), std::cos(700.0 * part)); });
    addCurve();
    for (const double width : {1.9, 1.5, 1.1, 0.7}) { // faster than pictures come
        plot_->setView({PlotRange{0.0, width}, PlotRange{0.0, width}});
        plot_->refreshNow();
    }
    QTRY_VERIFY(ready());
    QCOMPARE(plot_->phasePicture().image(), fullDrawing());
}

void TestPhasePicture::showsNothingOfARemovedCurve()
{
    fill([](double part) { return QPointF(std::sin(900.0 * part), std::cos(700.0 * part)); });
    addCurve();
    QTRY_VERIFY(ready());
    plot_->setView({PlotRange{0.0, 0.5}, PlotRange{0.0, 0.5}});
    plot_->refreshNow(); // another picture is being drawn
    plot_->clearCurves();
    x_.reset();
    y_.reset();
    plot_->refreshNow();
    QVERIFY(plot_->phasePicture().image().isNull());
    QTRY_VERIFY(!plot_->phasePicture().busy());
    QVERIFY(plot_->phasePicture().image().isNull());
}

/// Another run with the same number: its samples may stand where those of the one before stood.
void TestPhasePicture::anotherRunAtTheSamePlaceIsNotTheOneBefore()
{
    fill([](double part) { return QPointF(std::sin(900.0 * part), std::cos(700.0 * part)); });
    addCurve();
    QTRY_VERIFY(ready());
    plot_->removeCurve(plot_->curves().front().id);
    MinMaxPyramid across, up(across.times());
    std::vector<double> times, values;
    for (int k = 0; k < count; ++k) {
        times.push_back(k);
        values.push_back(std::sin(2e-3 * k));
    }
    across.append(times, values);
    up.append(times, values);
    *x_ = std::move(across); // at the same addresses
    *y_ = std::move(up);
    PlotCurve curve{QStringLiteral("run 1/y"), QStringLiteral("Run 1"), {0, 0}, y_.get(), x_.get()};
    curve.arrows = true;
    plot_->setCurves({curve});
    plot_->refreshNow();
    QVERIFY(plot_->phasePicture().image().isNull());
    QTRY_VERIFY(ready());
    QCOMPARE(plot_->phasePicture().image(), fullDrawing());
}

/// In the plot area, an exported picture is the one on the screen: a spiral of one turn, with three arrows or more.
void TestPhasePicture::aSavedPictureHasItsArrows()
{
    fill([](double part) { return QPointF(part * std::sin(6.3 * part), part * std::cos(6.3 * part)); });
    addCurve();
    QTRY_VERIFY(ready());
    const auto saved = [this](bool arrows) {
        plot_->updateCurves([arrows](PlotCurve& curve) { curve.arrows = arrows; });
        QImage image(plot_->size(), QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&image);
        plot_->paintInto(painter, plot_->rect(), plot_->theme());
        painter.end();
        int dark = 0;
        const QColor ink = plot_->theme().colour({0, 0});
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) dark += image.pixelColor(x, y) == ink ? 1 : 0;
        return dark;
    };
    const int without = saved(false), with = saved(true);
    QVERIFY2(with > without + 20, qPrintable(QStringLiteral("%1, %2").arg(without).arg(with)));
}

void TestPhasePicture::fewSamplesAreDrawnAtOnce()
{
    fill([](double part) { return QPointF(std::sin(90.0 * part), std::cos(70.0 * part)); }, 1000);
    addCurve();
    QVERIFY(!plot_->phasePicture().busy() && plot_->phasePicture().image().isNull());
    QCOMPARE(plot_->phasePaths().size(), std::size_t(1));
}

TOUCHDOWN_TEST(TestPhasePicture)

} // namespace test_phase_picture

#include "test_phase_picture.moc"
