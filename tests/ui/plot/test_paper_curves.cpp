// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/paper_curves.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_paper_curves {

class TestPaperCurves : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { data_.append(std::vector{0.0, 1.0}, std::vector{1.0, 2.0}); }
    void noTwoLookAlike_data();
    void noTwoLookAlike();
    void noneIsPaleAndEachNamesItsRun();
    void bordersOfABandStayAlike();
    void hiddenAndEmptyCurvesAreLeftOut();
    void aRunLooksTheSameInEachPanel();

private:
    MinMaxPyramid data_, none_;
};

void TestPaperCurves::noTwoLookAlike_data()
{
    QTest::addColumn<int>("colours");
    QTest::addRow("coloured") << static_cast<int>(PaperColours::Coloured);
    QTest::addRow("black") << static_cast<int>(PaperColours::Black);
}

void TestPaperCurves::noTwoLookAlike()
{
    QFETCH(int, colours);
    const auto paper = static_cast<PaperColours>(colours);
    std::mt19937 generator(7);
    for (int draw = 0; draw < 200; ++draw) {
        const int shades = std::uniform_int_distribution(1, 9)(generator);
        const auto most = std::min<std::size_t>(distinctPaperCurves(paper), 4 * std::min(shades, 7));
        std::vector<PlotCurve> curves;
        for (std::size_t i = 0; i < most; ++i) // as many of each colour as there are dashes
            curves.push_back({QString::number(i),
                              QStringLiteral("run %1").arg(i),
                              {static_cast<int>(i) % std::min(shades, 7), draw % 4},
                              &data_});
        std::set<std::pair<QRgb, QList<qreal>>> seen;
        const PlotTheme theme = paperTheme(paper);
        for (const PlotCurve& curve : paperCurves(curves, paper)) {
            const QPen pen = curvePen(curve.style, theme);
            seen.insert({pen.color().rgb(), pen.style() == Qt::SolidLine ? QList<qreal>() : pen.dashPattern()});
        }
        QCOMPARE(seen.size(), most);
    }
}

void TestPaperCurves::noneIsPaleAndEachNamesItsRun()
{
    PlotCurve older{"run 1/kinetic", "Kinetic, FH 7 nm", {0, 0}, &data_};
    older.legend = "Kinetic";
    older.pale = true;
    older.inLegend = false;
    PlotCurve newer = older;
    newer.id = "run 2/kinetic";
    newer.name = "Kinetic, FH 20 nm";
    newer.pale = false;
    newer.inLegend = true;
    const auto both = paperCurves({older, newer}, PaperColours::Coloured);
    for (const PlotCurve& curve : both) QVERIFY(!curve.pale && curve.inLegend && curve.legend.isEmpty());
    QVERIFY(both[0].style != both[1].style);
    // One run alone: its quantities have their short names.
    QCOMPARE(paperCurves({newer}, PaperColours::Coloured)[0].legend, QString("Kinetic"));
}

void TestPaperCurves::bordersOfABandStayAlike()
{
    const std::vector<PlotCurve> band{{"upper", "error", {0, 2}, &data_}, {"lower", "error", {0, 2}, &data_}};
    for (const PaperColours colours : {PaperColours::Coloured, PaperColours::Black}) {
        const auto printed = paperCurves(band, colours);
        QCOMPARE(printed[0].style, printed[1].style);
    }
    QCOMPARE(paperCurves(band, PaperColours::Coloured)[0].style, (CurveStyle{0, 2})); // dotted as on the screen
}

void TestPaperCurves::hiddenAndEmptyCurvesAreLeftOut()
{
    PlotCurve hidden{"hidden", "hidden", {0, 0}, &data_};
    hidden.visible = false;
    const PlotCurve empty{"empty", "empty", {0, 0}, &none_};
    QVERIFY(paperCurves({hidden, empty}, PaperColours::Coloured).empty());
}

/// Drawn figures: panels show some of eight runs in any order, some beside curves of quantities.
void TestPaperCurves::aRunLooksTheSameInEachPanel()
{
    std::mt19937 generator(3);
    for (int draw = 0; draw < 200; ++draw)
        for (const PaperColours colours : {PaperColours::Coloured, PaperColours::Black}) {
            std::vector<PaperStyle> styles;
            std::map<QString, CurveStyle> ofRun;
            for (int panel = 0; panel < 4; ++panel) {
                std::vector<int> numbers{1, 2, 3, 4, 5, 6, 7, 8};
                std::ranges::shuffle(numbers, generator);
                numbers.resize(std::uniform_int_distribution<std::size_t>(1, 8)(generator));
                std::vector<PlotCurve> curves;
                for (const int number : numbers)
                    curves.push_back({QStringLiteral("run %1/quantity %2").arg(number).arg(panel),
                                      QStringLiteral("quantity %1 of %2").arg(panel).arg(number),
                                      {number - 1, 0},
                                      &data_});
                std::set<std::pair<int, int>> seen;
                for (const PlotCurve& curve : paperCurves(curves, colours, styles)) {
                    const QString run = curve.id.section(QLatin1Char('/'), 0, 0);
                    QCOMPARE(curve.style, ofRun.try_emplace(run, curve.style).first->second);
                    seen.insert({curve.style.colour, curve.style.dash});
                }
                QCOMPARE(seen.size(), numbers.size());
            }
        }
    // The quantities of one run look the same in each panel as long as no two of a panel look alike.
    std::vector<PaperStyle> styles;
    const auto quantity = [&](const char* name, int colour) {
        PlotCurve curve{QStringLiteral("run 1/%1").arg(name), name, {colour, 0}, &data_};
        curve.legend = name;
        return curve;
    };
    const auto first = paperCurves({quantity("contact", 0), quantity("net", 1)}, PaperColours::Black, styles);
    const auto second = paperCurves({quantity("friction", 2), quantity("net", 1)}, PaperColours::Black, styles);
    QCOMPARE(second[1].style, first[1].style);
    QVERIFY(second[0].style != second[1].style);
}

TOUCHDOWN_TEST(TestPaperCurves)

} // namespace test_paper_curves

#include "test_paper_curves.moc"
