// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include <cstdlib>
#include <memory>

#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>
#include <QXmlStreamReader>

#include "tests/support/file_size_limit.h"
#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"

using namespace touchdown;

namespace test_plot_export {

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

int ink(const QImage& image, const QColor& colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                                 std::abs(c.blue() - colour.blue()) <
                             60
                         ? 1
                         : 0;
        }
    return count;
}

class TestPlotExport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void cleanup();

    void svgHoldsLinesAndText();
    void svgHoldsAForeignTitleAsText();
    void svgStaysInsideTheArea();
    void pdfHoldsTextAndNoPicture();
    void pngIsLightWithInk();
    void pageHoldsAllVisiblePlots();
    void clipboardGetsAPicture();
    void csvOfTheVisiblePart();
    void csvOfDifferentTimes();
    void csvQuotesNames();
    void problemsAreSentences_data();
    void problemsAreSentences();
    void fullDiskLeavesNoFile_data();
    void fullDiskLeavesNoFile();

private:
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
    MinMaxPyramid data_;
    std::unique_ptr<QWidget> page_;
    PlotWidget* plot_ = nullptr;
    PlotWidget* second_ = nullptr;
};

void TestPlotExport::init()
{
    QVERIFY(folder_.isValid());
    data_ = MinMaxPyramid();
    data_.append(std::vector{0.0, 1e-3, 2e-3, 3e-3}, std::vector{1e-9, 5e-9, 2e-9, 4e-9});
    page_ = std::make_unique<QWidget>();
    page_->resize(500, 500);
    auto* layout = new QVBoxLayout(page_.get());
    const auto make = [&](const QString& title, int colour) {
        auto* plot = new PlotWidget;
        plot->setTitle(title);
        plot->setXLabel({"Time", "ms", 1e-3, AxisScale::Linear});
        plot->setYLabel({"Spacing", "nm", 1e-9, AxisScale::Linear});
        plot->addCurve({"run", "Run 1", {colour, 0}, &data_});
        layout->addWidget(plot);
        return plot;
    };
    plot_ = make("First plot", 0);
    second_ = make("Second plot", 1);
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
}

void TestPlotExport::cleanup() { page_.reset(); }

void TestPlotExport::svgHoldsLinesAndText()
{
    QCOMPARE(savePicture(*plot_, path("plot.svg")), QString());
    const QByteArray svg = contents(path("plot.svg"));
    QVERIFY(svg.contains("<text"));
    QVERIFY(svg.contains("First plot"));
    QVERIFY(svg.contains("Time [ms]"));
    QVERIFY(svg.contains("<polyline"));
    QVERIFY(!svg.contains("<image"));
    QVERIFY(svg.contains(lightPlotTheme().curves[0].name().toLatin1()));
    QVERIFY(QSvgRenderer(svg).isValid());
}

// Qt's SVG cannot clip: a line that leaves the visible heights must be cut by us.
/// The title of a chart comes from a file; a browser runs the scripts of a drawing.
void TestPlotExport::svgHoldsAForeignTitleAsText()
{
    const QString title = QStringLiteral("</title><script>x & y</script>");
    plot_->setTitle(title);
    QCOMPARE(savePicture(*plot_, path("plot.svg")), QString());
    QXmlStreamReader xml(contents(path("plot.svg")));
    QString read;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("title"))
            read = xml.readElementText();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY2(read.contains(title), qPrintable(read));
}

void TestPlotExport::svgStaysInsideTheArea()
{
    plot_->setView({PlotRange{0.0, 3e-3}, PlotRange{2.5e-9, 3e-9}});
    QCOMPARE(savePicture(*plot_, path("cut.svg")), QString());
    QImage image(plot_->size(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    QSvgRenderer(path("cut.svg")).render(&painter);
    painter.end();
    const QColor colour = lightPlotTheme().curves[0];
    QVERIFY(ink(image.copy(plot_->plotArea().toRect()), colour) > 20);
    const QRect above(QPoint(int(plot_->plotArea().left()), 0), QSize(200, int(plot_->plotArea().top()) - 2));
    QCOMPARE(ink(image.copy(above), colour), 0); // left of the legend
    QRect below = plot_->plotArea().toRect();
    below.translate(0, below.height() + 3);
    QCOMPARE(ink(image.copy(below.intersected(image.rect())), colour), 0);
}

void TestPlotExport::pdfHoldsTextAndNoPicture()
{
    QCOMPARE(savePicture(*plot_, path("plot.pdf")), QString());
    const QByteArray pdf = contents(path("plot.pdf"));
    QVERIFY(pdf.startsWith("%PDF"));
    QVERIFY(pdf.contains("/FontFile2") || pdf.contains("/FontFile3")); // text as text, with its font inside
    QVERIFY(!pdf.contains("/Subtype /Image"));
}

void TestPlotExport::pngIsLightWithInk()
{
    QPalette dark;
    dark.setColor(QPalette::Base, Qt::black);
    dark.setColor(QPalette::Text, Qt::white);
    plot_->setPalette(dark);
    QCOMPARE(savePicture(*plot_, path("plot.png")), QString());
    const QImage image(path("plot.png"));
    QCOMPARE(image.size(), plot_->size() * 2);
    QCOMPARE(image.pixelColor(1, 1), QColor(Qt::white)); // paper is light, whatever the screen shows
    QVERIFY(ink(image, lightPlotTheme().curves[0]) > 500);
}

void TestPlotExport::pageHoldsAllVisiblePlots()
{
    QCOMPARE(savePicture(*page_, path("page.svg")), QString());
    QByteArray svg = contents(path("page.svg"));
    QVERIFY(svg.contains("First plot") && svg.contains("Second plot"));
    second_->hide();
    QCOMPARE(savePicture(*page_, path("page.svg")), QString());
    svg = contents(path("page.svg"));
    QVERIFY(svg.contains("First plot") && !svg.contains("Second plot"));
    QCOMPARE(savePicture(*page_, path("page.pdf")), QString());
    QVERIFY(contents(path("page.pdf")).startsWith("%PDF"));
}

void TestPlotExport::clipboardGetsAPicture()
{
    copyPicture(*plot_);
    const QImage image = QGuiApplication::clipboard()->image();
    QCOMPARE(image.size(), plot_->size() * 2);
    QVERIFY(ink(image, plot_->theme().curves[0]) > 500);
}

void TestPlotExport::csvOfTheVisiblePart()
{
    plot_->setView({PlotRange{0.5e-3, 2.5e-3}, std::nullopt});
    QCOMPARE(saveCsv(*plot_, path("data.csv")), QString());
    QCOMPARE(contents(path("data.csv")), QByteArray("Time [ms],Run 1 [nm]\r\n1,5\r\n2,2\r\n"));
}

void TestPlotExport::csvOfDifferentTimes()
{
    MinMaxPyramid other;
    other.append(std::vector{1e-3, 1.5e-3}, std::vector{7e-9, 8e-9});
    plot_->addCurve({"other", "Run 2", {1, 1}, &other});
    plot_->setView({PlotRange{0.5e-3, 2.5e-3}, std::nullopt});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeCsv(*plot_, buffer);
    QCOMPARE(buffer.data(), QByteArray("Time [ms],Run 1 [nm],Run 2 [nm]\r\n1,5,7\r\n1.5,,8\r\n2,2,\r\n"));
    plot_->removeCurve("other");
}

void TestPlotExport::csvQuotesNames()
{
    plot_->addCurve({"run", "a \"b\", c", {0, 0}, &data_});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeCsv(*plot_, buffer);
    QVERIFY(buffer.data().startsWith("Time [ms],\"a \"\"b\"\", c [nm]\"\r\n"));
}

void TestPlotExport::problemsAreSentences_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("says");
    QTest::addRow("folder that is not there") << "no/such/folder/plot.svg"
                                              << "could not be written";
    QTest::addRow("unknown format") << "plot.bmp"
                                    << "does not end in .png, .svg or .pdf";
    QTest::addRow("no format") << "plot"
                               << "does not end in";
    QTest::addRow("a folder instead of a file") << "folder.png"
                                                << "could not be written";
}

void TestPlotExport::problemsAreSentences()
{
    QFETCH(QString, name);
    QFETCH(QString, says);
    QDir(folder_.path()).mkdir("folder.png");
    const QString problem = savePicture(*plot_, path(name));
    QVERIFY2(problem.contains(says), qPrintable(problem));
    QVERIFY(problem.contains(QDir::toNativeSeparators(path(name))));
    QVERIFY(problem.endsWith('.'));
}

void TestPlotExport::fullDiskLeavesNoFile_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"full.svg", "full.png", "full.pdf", "full.csv", "full.jpg"}) QTest::newRow(name) << name;
}

void TestPlotExport::fullDiskLeavesNoFile()
{
    QFETCH(QString, name);
    QString problem;
    {
        const test::FileSizeLimit full(20); // [byte]
        problem = name.endsWith("csv")   ? saveCsv(*plot_, path(name))
                  : name.endsWith("jpg") ? saveImage(plot_->grab().toImage(), path(name))
                                         : savePicture(*plot_, path(name));
    }
    QVERIFY(problem.contains(QDir::toNativeSeparators(path(name))));
    QVERIFY2(problem.contains("File too large"), qPrintable(problem));
    QVERIFY(QDir(folder_.path()).entryList({"full*"}).isEmpty());
}

TOUCHDOWN_TEST(TestPlotExport)

} // namespace test_plot_export

#include "test_plot_export.moc"
