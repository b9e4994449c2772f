// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/paper_curves.h"

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

TOUCHDOWN_TEST(TestPaperCurves)

} // namespace test_paper_curves

#include "test_paper_curves.moc"
