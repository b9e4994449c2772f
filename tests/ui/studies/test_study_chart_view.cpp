// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_chart_view.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QImage>
#include <QLocale>
#include <QScrollArea>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>

#include "tests/support/test_program.h"
#include "tests/ui/dark_theme.h"
#include "tests/ui/sample_study.h"
#include "ui/plot/plot_export.h"
#include "ui/studies/study_chart_drawing.h"

using namespace touchdown;

namespace test_study_chart_view {

/// Pixels of about this colour in a part of a picture.
int ink(const QImage& image, const QColor& colour, const QRect& part)
{
    int count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                                 std::abs(c.blue() - colour.blue()) <
                             40
                         ? 1
                         : 0;
        }
    return count;
}

QStringList legendTexts(const StudyChartDrawing& drawing)
{
    QStringList texts;
    for (const StudyLegend::Entry& entry : drawing.legend().entries()) texts << entry.text;
    return texts;
}

class TestStudyChartView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void panelsStandSideBySideOrStacked();
    void oneLegendForAllPanels();
    void aSeriesLooksTheSameInEachPanel();
    void drawsWhatItSays();
    void pointingTellsPointCellAndBand();
    void arrowKeysGoFromPointToPoint();
    void aBoxZoomsAndADoubleClickFits();
    void aGrowingChartKeepsItsZoom();
    void classesDifferByMoreThanColour();
    void theLegendNamesCellsThatAreNotComputed();
    void aUnitOfXIsAsLongAsOneOfY();
    void isDrawnOnDark();
    void savesPictures_data();
    void savesPictures();
    void drawsAnEmptyChart();
    void fitsThePaperWhateverTheScreenHas();

private:
    const StudyPanel& panel(std::size_t i = 0) const { return view_->drawing().panels()[i]; }
    QPoint pixelOf(std::size_t series, std::size_t point) const
    {
        const ChartPoint& p = view_->chart().panels[0].series[series].points[point];
        return panel().toPixel(p.x, p.y).toPoint();
    }

    std::unique_ptr<StudyChartView> view_;
};

void TestStudyChartView::init()
{
    view_ = std::make_unique<StudyChartView>();
    view_->resize(900, 520);
    view_->setChart(samplePrecisionChart());
    view_->show();
}

void TestStudyChartView::panelsStandSideBySideOrStacked()
{
    QCOMPARE(panel(0).area().top(), panel(1).area().top());
    QVERIFY(panel(0).area().right() < panel(1).area().left());
    view_->resize(400, view_->heightForWidth(400));
    QVERIFY(panel(0).area().bottom() < panel(1).area().top());
    QVERIFY(view_->heightForWidth(400) > view_->heightForWidth(900));
}

void TestStudyChartView::oneLegendForAllPanels()
{
    QCOMPARE(legendTexts(view_->drawing()),
             (QStringList{"rk4", "rk4-events", "newmark", "Pareto front", "ends in another state", "no valid answer",
                          "default or recommended"}));
    StudyChart plain = samplePrecisionChart();
    for (ChartPanel& each : plain.panels) each.series.resize(2); // without the failed point of newmark and the front
    view_->setChart(plain);
    QVERIFY(!legendTexts(view_->drawing()).contains(QStringLiteral("no valid answer")));
}

void TestStudyChartView::aSeriesLooksTheSameInEachPanel()
{
    StudyChart chart = samplePrecisionChart();
    std::swap(chart.panels[1].series[0], chart.panels[1].series[2]);
    const ChartStyles styles(chart), before(samplePrecisionChart());
    for (const ChartSeries& series : chart.panels[1].series) QCOMPARE(styles.of(series.name), before.of(series.name));
    QVERIFY(styles.of("rk4").curve.colour != styles.of("newmark").curve.colour);
    QVERIFY(styles.of("rk4").shape != styles.of("newmark").shape);
    QVERIFY(styles.of("Pareto front").quiet);
}

/// A full marker has the colour of its series in its middle, a hollow one that of the paper; a ring goes round a chosen
/// one.
void TestStudyChartView::drawsWhatItSays()
{
    const QImage image = view_->grab().toImage();
    const PlotTheme theme = plotTheme(view_->palette());
    const ChartStyles styles(view_->chart());
    const auto middle = [&](std::size_t series, std::size_t point) {
        return QRect(pixelOf(series, point) - QPoint(1, 1), QSize(2, 2));
    };
    QVERIFY(ink(image, seriesColour(styles.of("rk4"), theme), middle(0, 4)) >= 3);
    QVERIFY(ink(image, theme.plotArea, middle(0, 0)) >= 3);
    QVERIFY(ink(image, theme.text, QRect(pixelOf(1, 2) - QPoint(12, 12), QSize(24, 24))) > 20);
    // The cross of newmark stands where nothing else does.
    QVERIFY(ink(image, seriesColour(styles.of("newmark"), theme), QRect(pixelOf(2, 0) - QPoint(5, 5), QSize(10, 10))) >
            8);
}

void TestStudyChartView::pointingTellsPointCellAndBand()
{
    QTest::mouseMove(view_.get(), pixelOf(0, 0));
    QVERIFY2(view_->htmlTip().contains(QStringLiteral("<b>rk4</b> · 100 ns")), qPrintable(view_->htmlTip()));
    QVERIFY2(view_->htmlTip().contains(QStringLiteral("CPU time of a run: 2.0000\u00a0ms")),
             qPrintable(view_->htmlTip()));
    QVERIFY(view_->htmlTip().contains(QStringLiteral("another state")));
    QTest::mouseMove(view_.get(), QPoint(static_cast<int>(panel().area().left()) + 12,
                                         static_cast<int>(panel().area().bottom()) - 4));
    QVERIFY2(view_->htmlTip().contains(QStringLiteral("not known of the reference")), qPrintable(view_->htmlTip()));

    view_->setChart(sampleMapChart());
    QVERIFY(view_->htmlTip().isEmpty());
    QTest::mouseMove(view_.get(), panel().toPixel(1e-7, 1e5).toPoint() + QPoint(5, 9));
    QVERIFY2(view_->htmlTip().contains(QStringLiteral("<b>energy drifts</b>")), qPrintable(view_->htmlTip()));
    QVERIFY(view_->htmlTip().contains(QStringLiteral("Cell of class 2.")));
    QTest::mouseMove(view_.get(), panel().toPixel(1e-7, 1e8).toPoint());
    QVERIFY(view_->htmlTip().contains(QStringLiteral("Not computed")));
}

void TestStudyChartView::arrowKeysGoFromPointToPoint()
{
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QVERIFY(view_->htmlTip().contains(QStringLiteral("rk4</b> · 100 ns")));
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QVERIFY(view_->htmlTip().contains(QStringLiteral("rk4</b> · 31 ns")));
    QTest::keyClick(view_.get(), Qt::Key_Left);
    QVERIFY(view_->htmlTip().contains(QStringLiteral("rk4</b> · 100 ns")));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QVERIFY(view_->htmlTip().isEmpty());
}

/// The box becomes the panel; the other panel stays as it is.
void TestStudyChartView::aBoxZoomsAndADoubleClickFits()
{
    const PanelRange before = panel(0).axes().range(), other = panel(1).axes().range();
    const QRectF area = panel(0).area();
    const QRectF box(area.center(), area.bottomRight() - QPointF(20.0, 20.0));
    const PanelRange wanted = panel(0).rangeOf(QRectF(box.topLeft().toPoint(), box.bottomRight().toPoint()));
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, box.topLeft().toPoint());
    QMouseEvent move(QEvent::MouseMove, box.bottomRight().toPoint(), view_->mapToGlobal(box.bottomRight().toPoint()),
                     Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(view_.get(), &move);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, box.bottomRight().toPoint());
    QCOMPARE(panel(0).axes().range(), wanted);
    QCOMPARE(panel(1).axes().range(), other);
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, area.center().toPoint());
    QCOMPARE(panel(0).axes().range(), before);
}

void TestStudyChartView::aGrowingChartKeepsItsZoom()
{
    const QRectF area = panel(0).area();
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, area.center().toPoint());
    const QPoint to = area.bottomRight().toPoint() - QPoint(9, 9);
    QMouseEvent move(QEvent::MouseMove, to, view_->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(view_.get(), &move);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, to);
    const PanelRange zoomed = panel(0).axes().range();
    StudyChart grown = view_->chart();
    grown.panels[0].series[0].points.push_back({1.0, 1e-20});
    view_->setChart(grown);
    QCOMPARE(panel(0).axes().range(), zoomed);
    view_->setChart(sampleMapChart());
    view_->setChart(grown);
    QVERIFY(panel(0).axes().range() != zoomed);
}

void TestStudyChartView::theLegendNamesCellsThatAreNotComputed()
{
    const QString unknown = QStringLiteral("not computed");
    StudyChart chart = sampleMapChart(); // one cell of which is not
    view_->setChart(chart);
    QCOMPARE(legendTexts(view_->drawing()).back(), unknown);
    view_->setChart(chart, true);
    QCOMPARE(legendTexts(view_->drawing()).back(), QStringLiteral("not yet computed"));
    std::ranges::replace(chart.panels[0].map->cells, -1, 0);
    view_->setChart(chart);
    QVERIFY(!legendTexts(view_->drawing()).contains(unknown));
    QVERIFY(legendTexts(view_->drawing()).contains(QStringLiteral("chatters")));
}

void TestStudyChartView::classesDifferByMoreThanColour()
{
    const std::vector<ChartClass> classes = sampleMapChart().panels[0].map->classes;
    for (const PlotTheme& theme : {lightPlotTheme(), darkPlotTheme()}) {
        const std::vector<ClassStyle> styles = classStyles(classes, theme);
        std::set<QChar> letters;
        for (const ClassStyle& style : styles) letters.insert(style.letter);
        QCOMPARE(letters.size(), classes.size());
        // Drifts and chatters are equally severe.
        QCOMPARE(styles[2].colour, styles[3].colour);
        QVERIFY(styles[2].pattern != styles[3].pattern);
        // The worse, the further from the paper in lightness: what a grey copy leaves.
        const auto away = [&](std::size_t i) {
            return std::abs(qGray(styles[i].colour.rgb()) - qGray(theme.plotArea.rgb()));
        };
        QVERIFY(away(0) < away(2) && away(2) < away(1) && away(1) < away(4));
    }
}

void TestStudyChartView::aUnitOfXIsAsLongAsOneOfY()
{
    view_->setChart(sampleRegionChart());
    const QPointF origin = panel().toPixel(0.0, 0.0), right = panel().toPixel(-1.0, 0.0),
                  top = panel().toPixel(0.0, 1.0);
    QVERIFY(std::abs((origin.x() - right.x()) - (origin.y() - top.y())) < 1e-6);
}

void TestStudyChartView::isDrawnOnDark()
{
    QPalette dark;
    dark.setColor(QPalette::Base, QColor("#1a1d21"));
    dark.setColor(QPalette::Text, QColor("#e4e8ec"));
    view_->setPalette(dark);
    const QImage image = view_->grab().toImage();
    QVERIFY(qGray(image.pixel(3, 3)) < 60);
    QVERIFY(ink(image, plotTheme(dark).text, QRect(10, 10, 300, 30)) > 30); // the title
}

void TestStudyChartView::savesPictures_data()
{
    QTest::addColumn<QString>("ending");
    for (const char* ending : {"png", "svg", "pdf"}) QTest::newRow(ending) << QString::fromLatin1(ending);
}

void TestStudyChartView::savesPictures()
{
    QFETCH(const QString, ending);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("chart.") + ending);
    QCOMPARE(savePicture(*view_, file), QString());
    if (ending == QLatin1String("png")) QCOMPARE(QImage(file).size(), QSize(1800, 1040)); // twice the screen's
    if (ending == QLatin1String("svg")) QCOMPARE(QSvgRenderer(file).viewBox().size(), QSize(900, 520));
    if (ending == QLatin1String("pdf")) {
        QFile pdf(file);
        QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.readAll().startsWith("%PDF"));
    }
}

void TestStudyChartView::drawsAnEmptyChart()
{
    view_->setChart({});
    QVERIFY(!view_->grab().isNull());
    QTest::keyClick(view_.get(), Qt::Key_Right);
    view_->setChart({"Nothing yet", "", {{{"x", "", "", true}, {"y", "", "", true}, {}, {}, {}, false}}});
    QVERIFY(!view_->grab().isNull());
    QTest::mouseMove(view_.get(), panel().area().center().toPoint());
    QVERIFY(view_->htmlTip().isEmpty());
}

/// A figure for a paper is laid out anew: in a page of the window, in one with a least size, and without any.
void TestStudyChartView::fitsThePaperWhateverTheScreenHas()
{
    QFont font;
    font.setPixelSize(12);
    const auto onPaper = [&font](StudyChartView& view) {
        const QSizeF size(321.0, view.heightOnPaper(321.0, font));
        QImage image(2 * size.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.scale(2.0, 2.0);
        view.paintOnPaper(painter, size, font, PaperColours::Coloured);
        return image;
    };
    const auto filled = [this](StudyChartView& view) { view.setChart(view_->chart()); };
    StudyChartView alone;
    filled(alone);
    const QImage wanted = onPaper(alone);
    QWidget page;
    auto* scroll = new QScrollArea(&page);
    auto* inPage = new StudyChartView;
    filled(*inPage);
    scroll->setWidget(inPage);
    scroll->setWidgetResizable(true);
    auto* layout = new QVBoxLayout(&page);
    layout->addWidget(scroll);
    page.resize(1000, 700);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    for (const QSize& least : {QSize(0, 0), QSize(900, 650)}) {
        inPage->setMinimumSize(least);
        QCoreApplication::processEvents();
        const QSize before = inPage->size();
        QVERIFY(onPaper(*inPage) == wanted);
        QCOMPARE(inPage->size(), before);
        QCOMPARE(inPage->minimumSize(), least);
    }
}

TOUCHDOWN_TEST(TestStudyChartView)

} // namespace test_study_chart_view

#include "test_study_chart_view.moc"
