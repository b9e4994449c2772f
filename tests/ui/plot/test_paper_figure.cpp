// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/paper_figure.h"

#include <cmath>
#include <memory>
#include <random>
#include <set>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QLocale>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/file_size_limit.h"
#include "tests/support/test_program.h"
#include "ui/maps/field_map.h"
#include "ui/plot/plot_widget.h"

using namespace touchdown;

namespace test_paper_figure {

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class TestPaperFigure : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init();
    void sizesAreThoseOfTheFormat();
    void fontHasItsSize();
    void noTextIsTooSmall();
    void panelsStandBelowAndBesideEachOther();
    void everyAxisHasATitleAndTwoNumbers();
    void titlesCanBeLeftOut();
    void screenStaysAsItIs();
    void mapsAreLossless();
    void numbersStandBeside();
    void foreignNumbersAreNotReplaced();
    void fullDiskLeavesNothing();
    void whatCannotBeReadIsSaid();
    void blackIsBlack();
    void aMapFillsItsColumn();
    void labelsOfLinesKeepPanelsAligned();

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    PaperFigure of(const FigureFormat& format) { return {{plot_.get(), second_.get()}, format}; }
    QString svg(const PaperFigure& figure)
    {
        if (!figure.save(path("figure.svg")).isEmpty()) qFatal("not saved");
        return QString::fromUtf8(contents(path("figure.svg")));
    }

    std::unique_ptr<QTemporaryDir> folder_;
    MinMaxPyramid data_;
    std::unique_ptr<PlotWidget> plot_, second_;
};

void TestPaperFigure::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    data_ = MinMaxPyramid();
    data_.append(std::vector{0.0, 1e-3, 2e-3, 3e-3}, std::vector{1e-9, 5e-9, 2e-9, 4e-9});
    const auto make = [&](const QString& title) {
        auto plot = std::make_unique<PlotWidget>();
        plot->setTitle(title);
        plot->setXLabel({"Time", "ms", 1e-3, AxisScale::Linear});
        plot->setYLabel({{}, "nm", 1e-9, AxisScale::Linear});
        plot->addCurve({"run 1", "FH(0) 7 nm", {0, 0}, &data_});
        plot->addCurve({"run 2", "FH(0) 20 nm", {1, 0}, &data_});
        plot->updateCurves([](PlotCurve& curve) { curve.pale = curve.id == "run 1"; });
        plot->resize(640, 200);
        return plot;
    };
    plot_ = make("Minimum spacing");
    second_ = make("Pitch");
    second_->setXNumbersVisible(false);
}

void TestPaperFigure::sizesAreThoseOfTheFormat()
{
    FigureFormat format;
    format.data = false;
    for (const double width : {85.0, 170.0, 123.4})
        for (const double height : {0.0, 110.0})
            for (const double font : {6.0, 8.0, 11.5}) {
                format.width = width;
                format.height = height;
                format.fontSize = font;
                const PaperFigure figure = of(format);
                QVERIFY(std::abs(figure.size().width() - width) < 1e-9);
                if (height > 0.0) QVERIFY(std::abs(figure.size().height() - height) < 1e-9);
                QCOMPARE(figure.save(path("size.pdf")), QString());
                static const QRegularExpression box("/MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]");
                const auto page = box.match(QString::fromLatin1(contents(path("size.pdf"))));
                QVERIFY(std::abs(page.captured(1).toDouble() - width / 25.4 * 72.0) < 0.51);
                QVERIFY(std::abs(page.captured(2).toDouble() - figure.size().height() / 25.4 * 72.0) < 0.51);
                QCOMPARE(figure.save(path("size.svg")), QString());
                static const QRegularExpression mm("width=\"([0-9.]+)mm\"");
                const auto drawing = mm.match(QString::fromUtf8(contents(path("size.svg"))));
                QVERIFY2(std::abs(drawing.captured(1).toDouble() - width) < 0.2, qPrintable(drawing.captured(0)));
            }
    format = {};
    format.dotsPerInch = 300;
    QCOMPARE(of(format).save(path("size.png")), QString());
    const QImage image(path("size.png"));
    QVERIFY(std::abs(image.width() - 85.0 / 25.4 * 300.0) <= 1.0);
    QCOMPARE(std::lround(image.dotsPerMeterX() * 0.0254), 300L);
}

void TestPaperFigure::fontHasItsSize()
{
    FigureFormat format;
    format.data = false;
    static const QRegularExpression fonts("<text[^>]*font-size=\"([0-9.]+)\"");
    for (const double points : {6.0, 8.0, 12.0}) {
        format.fontSize = points;
        const PaperFigure figure = of(format);
        const double pixels = figure.picture().size.width() / (85.0 / 25.4 * 72.0); // for a point
        std::set<double> sizes;
        for (auto match = fonts.globalMatch(svg(figure)); match.hasNext();)
            sizes.insert(match.next().captured(1).toDouble() / pixels);
        QVERIFY(std::abs(*sizes.rbegin() - points) < 0.01); // titles and legend
        QVERIFY(*sizes.begin() > 0.9 * points);             // numbers
    }
}

/// However many labels there are, no text is smaller than 7 pt beside one of 8 pt; those without room are told.
void TestPaperFigure::noTextIsTooSmall()
{
    static const QRegularExpression fonts("<text[^>]*font-size=\"([0-9.]+)\"");
    FigureFormat format;
    format.data = false;
    for (const int panels : {1, 2, 4})
        for (const int labels : {0, 2, 5, 20}) {
            std::vector<ReferenceLine> lines;
            for (int i = 0; i < labels; ++i) {
                const bool upright = i % 2 == 1;
                const double part = (i + 0.5) / labels;
                lines.push_back(
                    {upright ? 3e-3 * part : 1e-9 + 4e-9 * part, QStringLiteral("take-off at %1 nm").arg(i), upright});
            }
            plot_->setReferenceLines(lines);
            std::vector<QWidget*> chosen;
            for (int i = 0; i < panels; ++i) chosen.push_back(i % 2 == 0 ? plot_.get() : second_.get());
            format.columns = panels == 4 ? 2 : 1;
            const PaperFigure figure(chosen, format);
            const double pixels = figure.picture().size.width() / (85.0 / 25.4 * 72.0); // for a point
            const QString text = svg(figure);
            for (auto match = fonts.globalMatch(text); match.hasNext();)
                QVERIFY(match.next().captured(1).toDouble() / pixels >= 7.0);
            int whole = 0;
            for (int i = 0; i < labels; ++i) whole += text.contains(QStringLiteral("take-off at %1 nm<").arg(i));
            QCOMPARE(figure.remark().isEmpty(), whole == labels);
            if (labels == 20)
                QVERIFY2(figure.remark().contains(QString::number(20 - whole)), qPrintable(figure.remark()));
            if (labels == 2 && panels < 4) QCOMPARE(whole, 2);
        }
}

void TestPaperFigure::panelsStandBelowAndBesideEachOther()
{
    FigureFormat format;
    const QSizeF below = of(format).size();
    format.columns = 2;
    format.width = 170.0;
    const QSizeF beside = of(format).size();
    QVERIFY(beside.height() < 0.6 * below.height());
    const QString text = svg(of(format));
    QVERIFY(text.contains("(a)") && text.contains("(b)"));
    format.letters = false;
    QVERIFY(!svg(of(format)).contains("(a)"));
    QVERIFY(!svg({{plot_.get()}, FigureFormat{}}).contains("(a)")); // alone
}

void TestPaperFigure::everyAxisHasATitleAndTwoNumbers()
{
    std::mt19937 generator(11);
    const auto drawn = [&generator](double low, double high) {
        return std::uniform_real_distribution(low, high)(generator);
    };
    FigureFormat format;
    format.data = false;
    for (int draw = 0; draw < 150; ++draw) {
        format.width = drawn(60.0, 180.0);
        format.fontSize = drawn(6.0, 11.0);
        // The heights of the axes in nm, by chance linear or logarithmic.
        const bool logarithmic = draw % 2 == 1;
        const double low = std::pow(10.0, drawn(-3.0, 3.0));
        const double high = low * (1.0 + std::pow(10.0, drawn(-2.0, 3.0)));
        plot_->setYLabel({{}, "nm", 1e-9, logarithmic ? AxisScale::Logarithmic : AxisScale::Linear});
        plot_->setView({PlotRange{0.0, drawn(1e-5, 3e-3)}, PlotRange{low * 1e-9, high * 1e-9}});
        const PaperFigure figure({plot_.get()}, format);
        if (!figure.problem().isEmpty()) continue;
        const QString text = svg(figure);
        QVERIFY(text.contains("Time"));
        QVERIFY(text.contains("Minimum spacing"));
        // Numbers right of the upright axis' title stand at its left edge, those of time below: at least two of each.
        static const QRegularExpression numbers(">\\s*([\u2212]?[0-9.·⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)\\s*</text>");
        int count = 0;
        for (auto match = numbers.globalMatch(text); match.hasNext(); match.next()) ++count;
        QVERIFY2(count >= 4, qPrintable(QStringLiteral("%1 numbers, %2 to %3 nm").arg(count).arg(low).arg(high)));
    }
}

/// What a plot is called stands above it where its axis has another name: a spectrum's.
void TestPaperFigure::titlesCanBeLeftOut()
{
    plot_->setTitle(QStringLiteral("Spectrum of the spacing"));
    plot_->setYLabel({QStringLiteral("Density"), "nm", 1e-9, AxisScale::Linear});
    FigureFormat format;
    QVERIFY(svg(of(format)).contains("Spectrum of the spacing"));
    format.titles = false;
    const QString without = svg(of(format));
    QVERIFY(!without.contains("Spectrum of the spacing"));
    QVERIFY(without.contains("Density") && without.contains("Pitch")); // names of axes stay
}

void TestPaperFigure::screenStaysAsItIs()
{
    plot_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plot_.get()));
    plot_->refreshNow();
    const QImage before = plot_->grab().toImage();
    const QSize size = plot_->size();
    QCOMPARE(of({}).save(path("figure.pdf")), QString());
    QCOMPARE(plot_->size(), size);
    QCOMPARE(plot_->grab().toImage(), before);
    FieldMap map;
    map.setSlider(1.25e-3, 1e-3);
    map.setField({{0.0, 0.4e-3, 0.85e-3}, {0.0, 0.7e-3}}, {1.0, 1.0});
    map.resize(500, 400);
    map.zoom(2.0, {200.0, 200.0});
    const QRectF view = map.view();
    const QFont font = map.font();
    QCOMPARE(PaperFigure({&map}, {}).save(path("map.pdf")), QString());
    QCOMPARE(map.view(), view);
    QCOMPARE(map.size(), QSize(500, 400));
    QCOMPARE(map.font(), font);
}

void TestPaperFigure::mapsAreLossless()
{
    FieldMap map;
    map.setSlider(1.25e-3, 1e-3);
    map.setField({{0.0, 0.5e-3, 1.25e-3}, {0.0, 1e-3}}, {1.0, 2.0});
    map.resize(500, 400);
    QCOMPARE(PaperFigure({&map}, {}).save(path("map.pdf")), QString());
    const QByteArray pdf = contents(path("map.pdf"));
    QVERIFY(pdf.contains("/Subtype /Image"));
    QVERIFY(!pdf.contains("DCTDecode")); // JPEG
    QVERIFY(pdf.contains("/FontFile2") || pdf.contains("/FontFile3"));
}

void TestPaperFigure::numbersStandBeside()
{
    QCOMPARE(of({}).save(path("figure.pdf")), QString());
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), (QStringList{"figure-a.csv", "figure-b.csv", "figure.pdf"}));
    QVERIFY(contents(path("figure-a.csv")).startsWith("Time [ms],FH(0) 7 nm [nm],FH(0) 20 nm [nm]\r\n0,1,1\r\n"));
    FigureFormat none;
    none.data = false;
    QCOMPARE(of(none).save(path("alone.png")), QString());
    QVERIFY(of(none).dataFiles(path("alone.png")).isEmpty());
    QCOMPARE(QDir(folder_->path()).entryList({"alone*"}), QStringList{"alone.png"});
    QVERIFY(of({}).save(path("figure.gif")).contains("does not end in"));
    FigureFormat huge;
    huge.width = 500.0;
    huge.height = 500.0;
    huge.fontSize = 36.0;
    huge.dotsPerInch = 1200;
    huge.columns = 2;
    QCOMPARE(of(huge).picture().dotsPerInch, 1200.0); // 23,622 pixels each way
    huge.width = 700.0;                               // 33,071
    QVERIFY(of(huge).save(path("huge.png")).contains("too many pixels"));
    QVERIFY(QDir(folder_->path()).entryList({"huge*"}).isEmpty());
}

void TestPaperFigure::foreignNumbersAreNotReplaced()
{
    QFile measured(path("figure-b.csv"));
    QVERIFY(measured.open(QIODevice::WriteOnly));
    measured.write("mine");
    measured.close();
    const QString problem = of({}).save(path("figure.pdf"));
    QVERIFY2(problem.contains("figure-b.csv") && problem.endsWith('.'), qPrintable(problem));
    QCOMPARE(contents(path("figure-b.csv")), QByteArray("mine"));
    QVERIFY(!QFile::exists(path("figure.pdf")) && !QFile::exists(path("figure-a.csv")));
    // Nor where the figure itself is replaced.
    FigureFormat none;
    none.data = false;
    QCOMPARE(of(none).save(path("figure.pdf")), QString());
    QVERIFY(of({}).save(path("figure.pdf")).contains("figure-b.csv"));
    QCOMPARE(contents(path("figure-b.csv")), QByteArray("mine"));
    // The numbers of the same panels are replaced, also under another format.
    QFile::remove(path("figure-b.csv"));
    QCOMPARE(of({}).save(path("figure.pdf")), QString());
    QCOMPARE(of({}).save(path("figure.svg")), QString());
}

void TestPaperFigure::fullDiskLeavesNothing()
{
    const std::vector<double> many(3000, 1e-9);
    std::vector<double> times;
    for (std::size_t i = 0; i < many.size(); ++i) times.push_back(1e-6 * static_cast<double>(i));
    MinMaxPyramid longer;
    longer.append(times, many);
    second_->addCurve({"run 3", "long", {2, 0}, &longer}); // its numbers are the largest file
    for (const char* name : {"full.pdf", "full.svg", "full.png"})
        for (const rlim_t size : {0UL, 20UL, 150UL, 5000UL}) {
            QString problem;
            {
                const test::FileSizeLimit full(size); // [byte]
                problem = of({}).save(path(name));
            }
            QVERIFY2(problem.contains("could not be written"), qPrintable(problem));
            QVERIFY(QDir(folder_->path()).isEmpty());
        }
}

void TestPaperFigure::whatCannotBeReadIsSaid()
{
    QCOMPARE(of({}).problem(), QString());
    FigureFormat low;
    low.height = 25.0;
    QVERIFY(of(low).problem().contains("Panel (a) is too low"));
    FigureFormat narrow;
    narrow.width = 20.0;
    QVERIFY(of(narrow).problem().contains("too narrow"));
    for (int i = 0; i < 9; ++i)
        plot_->addCurve({QStringLiteral("more %1").arg(i), QStringLiteral("more %1").arg(i), {i, 0}, &data_});
    QCOMPARE(of({}).problem(), QString()); // colours and dashes tell eleven apart
    FigureFormat black;
    black.colours = PaperColours::Black;
    QVERIFY(of(black).problem().contains("more curves than can be told apart"));
}

void TestPaperFigure::blackIsBlack()
{
    FigureFormat black;
    black.colours = PaperColours::Black;
    QCOMPARE(of(black).save(path("black.png")), QString());
    const QImage image(path("black.png"));
    for (int y = 0; y < image.height(); y += 3)
        for (int x = 0; x < image.width(); x += 3)
            QVERIFY(qAbs(qRed(image.pixel(x, y)) - qBlue(image.pixel(x, y))) < 12);
}

/// Beside the slider there are its edges' names, the numbers of the axis and the colours, and nothing else: the air
/// flow stands above it. With the air flow beside it the slider had 108 of 361 pixels.
void TestPaperFigure::aMapFillsItsColumn()
{
    FieldMap map;
    map.setSlider(0.85e-3, 0.7e-3);
    map.setSkew(0.1);
    map.setField({{0.0, 0.85e-3}, {0.0, 0.7e-3}}, {1.0});
    map.setLook(
        {QStringLiteral("Pressure"), QStringLiteral("atm"), 1.0, ColourScale::linear(ColourMap::Viridis, 0.0, 2.0)});
    map.resize(640, 460);
    const PaperFigure figure({&map}, {});
    const QSizeF size = figure.picture().size;
    QImage image(size.toSize(), QImage::Format_RGB32);
    QPainter painter(&image);
    figure.picture().paint(painter);
    painter.end();
    const QRgb inside = image.pixel(image.width() / 3, 2 * image.height() / 5);
    int left = image.width(), right = 0;
    for (int column = 0; column < image.width(); ++column)
        for (int row = image.height() / 3; row < image.height() / 2; ++row)
            if (image.pixel(column, row) == inside && column < image.width() * 4 / 5) {
                left = std::min(left, column);
                right = std::max(right, column);
            }
    QVERIFY2(right - left > 0.43 * image.width(),
             qPrintable(QStringLiteral("%1 of %2").arg(right - left).arg(image.width())));
    QCOMPARE(map.size(), QSize(640, 460));
}

/// A label of one panel takes its room from both, so that one time stands below itself.
void TestPaperFigure::labelsOfLinesKeepPanelsAligned()
{
    // The longest black line of each panel: its axis of time.
    const auto ends = [this] {
        const PaperFigure figure = of({});
        const Picture picture = figure.picture();
        QImage image(picture.size.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        picture.paint(painter);
        std::vector<int> found;
        for (const int half : {0, 1}) {
            int longest = 0, end = 0;
            for (int y = half * image.height() / 2; y < (half + 1) * image.height() / 2; ++y)
                for (int x = 0, length = 0; x < image.width(); ++x) {
                    length = image.pixelColor(x, y).lightness() < 190 ? length + 1 : 0;
                    if (length <= longest) continue;
                    longest = length;
                    end = x;
                }
            found.push_back(end);
        }
        return found;
    };
    const std::vector<int> without = ends();
    QCOMPARE(without[0], without[1]);
    plot_->setReferenceLines({{3e-9, QStringLiteral("d = 3 nm"), false}});
    const std::vector<int> with = ends();
    QCOMPARE(with[0], with[1]);
    QVERIFY2(with[0] < without[0] - 20, qPrintable(QString::number(with[0])));
}

TOUCHDOWN_TEST(TestPaperFigure)

} // namespace test_paper_figure

#include "test_paper_figure.moc"
