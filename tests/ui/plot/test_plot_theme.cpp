// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_theme.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/dark_theme.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_plot_theme {

class TestPlotTheme : public QObject {
    Q_OBJECT

private slots:
    void standsOutOfItsPaper_data();
    void standsOutOfItsPaper();
    void followsThePalette();
    void stylesRepeat();
};

void TestPlotTheme::standsOutOfItsPaper_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addRow("light") << false;
    QTest::addRow("dark") << true;
}

void TestPlotTheme::standsOutOfItsPaper()
{
    QFETCH(bool, dark);
    const PlotTheme theme = dark ? darkPlotTheme() : lightPlotTheme();
    QCOMPARE(theme.plotArea.lightness() < 128, dark);
    for (const QColor& colour : theme.curves) // graphics: 3:1
        QVERIFY2(contrast(colour, theme.plotArea) >= 3.0, qPrintable(colour.name()));
    for (int colour = 0; colour < theme.curves.size(); ++colour) // pale ones, also in the legend
        QVERIFY2(contrast(palePen({colour, 0}, theme).color(), theme.background) >= 3.0,
                 qPrintable(theme.curves[colour].name()));
    QVERIFY(contrast(theme.referenceLine, theme.background) >= 3.0);
    for (const QColor& colour : {theme.text, theme.mutedText}) // text: 4.5:1
        QVERIFY2(contrast(colour, theme.background) >= 4.5, qPrintable(colour.name()));
    QVERIFY(contrast(theme.grid, theme.plotArea) < 1.6); // the grid stays in the background
}

void TestPlotTheme::followsThePalette()
{
    QPalette palette;
    palette.setColor(QPalette::Base, Qt::black);
    palette.setColor(QPalette::Text, Qt::white);
    QCOMPARE(plotTheme(palette).background, QColor(Qt::black));
    QCOMPARE(plotTheme(palette).curves, darkPlotTheme().curves);
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::Text, Qt::black);
    QCOMPARE(plotTheme(palette).curves, lightPlotTheme().curves);
}

void TestPlotTheme::stylesRepeat()
{
    const PlotTheme theme = lightPlotTheme();
    QCOMPARE(theme.colour({7, 0}), theme.colour({0, 0}));
    QCOMPARE(curvePen({0, 5}, theme).dashPattern(), curvePen({0, 1}, theme).dashPattern());
    QCOMPARE(curvePen({0, 0}, theme).style(), Qt::SolidLine);
    QCOMPARE(curvePen({0, 1}, theme, false).style(), Qt::SolidLine);
    QCOMPARE(curvePen({0, 1}, theme).style(), Qt::CustomDashLine);
    QCOMPARE(palePen({0, 1}, theme).style(), Qt::SolidLine);
    QVERIFY(palePen({0, 0}, theme).widthF() < curvePen({0, 0}, theme).widthF());
    for (const PlotTheme& each : {lightPlotTheme(), darkPlotTheme()}) // nearer to the paper than to the full colour
        for (int colour = 0; colour < 7; ++colour) {
            const auto apart = [](const QColor& a, const QColor& b) { return std::abs(a.lightness() - b.lightness()); };
            const QColor pale = each.paleColour({colour, 0});
            QVERIFY(apart(pale, each.plotArea) > 15);
            QVERIFY(apart(pale, each.plotArea) < apart(each.colour({colour, 0}), each.plotArea));
        }
}

TOUCHDOWN_TEST(TestPlotTheme)

} // namespace test_plot_theme

#include "test_plot_theme.moc"
