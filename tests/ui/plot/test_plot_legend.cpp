// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_legend.h"

#include <random>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_plot_legend {

std::vector<PlotCurve> drawnCurves(std::mt19937& generator, const MinMaxPyramid& data)
{
    std::vector<PlotCurve> curves;
    const int count = std::uniform_int_distribution(1, 12)(generator);
    for (int i = 0; i < count; ++i) {
        const int length = std::uniform_int_distribution(1, 60)(generator);
        curves.push_back(
            {QString::number(i), QStringLiteral("%1 ").arg(i) + QString(length, u'n'), {i % 7, i / 7}, &data});
    }
    return curves;
}

class TestPlotLegend : public QObject {
    Q_OBJECT

private slots:
    void rowOfTheScreenStaysInside();
    void rowsOnPaperNameEveryCurve();
    void plotThatStandsAloneNeedsNone();

private:
    QFont font_;
    MinMaxPyramid data_;
};

void TestPlotLegend::rowOfTheScreenStaysInside()
{
    std::mt19937 generator(3);
    for (int draw = 0; draw < 200; ++draw) {
        const auto curves = drawnCurves(generator, data_);
        const QRectF row(60.0, 6.0, std::uniform_real_distribution(40.0, 900.0)(generator), 15.0);
        const Legend legend = legendInRow(curves, {}, row, font_);
        QCOMPARE(legend.entries.size() + legend.more, curves.size());
        for (const LegendEntry& entry : legend.entries) QVERIFY(entry.box.left() >= row.left() - 1.0);
    }
}

void TestPlotLegend::rowsOnPaperNameEveryCurve()
{
    std::mt19937 generator(4);
    for (int draw = 0; draw < 200; ++draw) {
        const auto curves = drawnCurves(generator, data_);
        const double width = std::uniform_real_distribution(90.0, 700.0)(generator);
        const Legend legend = legendInRows(curves, {}, {60.0, 6.0}, width, font_);
        QCOMPARE(legend.entries.size(), curves.size());
        QCOMPARE(legend.more, std::size_t(0));
        for (std::size_t i = 0; i < legend.entries.size(); ++i) {
            const LegendEntry& entry = legend.entries[i];
            QCOMPARE(entry.text, entry.curve->name); // not shortened
            QVERIFY(entry.box.left() >= 60.0 && entry.box.right() <= 60.0 + width + 1e-9);
            QVERIFY(entry.box.bottom() <= 6.0 + legend.height + 1e-9);
            for (std::size_t k = 0; k < i; ++k) QVERIFY(!entry.box.intersects(legend.entries[k].box));
        }
    }
}

void TestPlotLegend::plotThatStandsAloneNeedsNone()
{
    const std::vector<PlotCurve> one{{"run", "Pitch", {0, 0}, &data_}};
    QVERIFY(legendInRows(one, "Pitch", {}, 200.0, font_).entries.empty());
    QCOMPARE(legendInRows(one, "Pitch", {}, 200.0, font_).height, 0.0);
    QCOMPARE(legendInRow(one, "Roll", {0.0, 0.0, 200.0, 15.0}, font_).entries.size(), std::size_t(1));
}

TOUCHDOWN_TEST(TestPlotLegend)

} // namespace test_plot_legend

#include "test_plot_legend.moc"
