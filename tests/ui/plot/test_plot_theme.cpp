// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_theme.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/dark_theme.h"

using namespace touchdown;

namespace test_plot_theme {

/// Relative luminance and contrast of WCAG 2.1.
double luminance(const QColor& colour)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

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
