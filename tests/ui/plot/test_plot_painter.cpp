// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_painter.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <QTest>

#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"

using namespace touchdown;

namespace test_plot_painter {

class TestPlotPainter : public QObject {
    Q_OBJECT

private slots:
    void placesStayWhereTheyHaveRoom();
    void placesShareTheirShifts();
    void placesKeepTheirOrderWithinTheRow();
    /// Words at points close to reference lines, close to each other and at the border, on the screen and on paper.
    void noLabelLiesOverAnother()
    {
        PlotWidget plot;
        plot.resize(640, 300);
        std::mt19937 generator(7);
        const auto draw = [&](double most) { return std::uniform_real_distribution(0.0, most)(generator); };
        std::size_t drawn = 0;
        std::size_t placed = 0;
        int areas = 0;
        for (int repeat = 0; repeat < 100; ++repeat) {
            plot.setView({PlotRange{0.0, 1e-3}, PlotRange{0.0, 30e-9}});
            std::vector<ReferenceLine> lines;
            std::vector<PointMark> marks;
            for (int i = 0; i < 4; ++i) {
                const bool upright = i == 3;
                lines.push_back({draw(upright ? 1e-3 : 30e-9), QStringLiteral("line %1").arg(i), upright});
                // The first two stand on a line, where its label would be without them.
                const double x = i < 2 ? 0.9e-3 + draw(0.1e-3) : draw(1e-3);
                const double y =
                    i < 2 ? std::max(lines[static_cast<std::size_t>(i)].value - draw(1e-9), 0.0) : draw(30e-9);
                marks.push_back({x, y, QStringLiteral("ends at %1 nm").arg(i), {i, 0}});
            }
            marks.push_back({std::nan(""), 1e-9, QStringLiteral("never"), {0, 0}});
            drawn += lines.size() + marks.size();
            plot.setReferenceLines(lines);
            plot.setPointMarks(marks);
            plot.setShadedAreas({{{{2e-4, 1e-9}, {6e-4, 1e-9}, {6e-4, 2e-8}}, QStringLiteral("W = 7.5 pJ"), {0, 0}}});
            plot.refreshNow();
            QFont font;
            font.setPixelSize(11);
            const PlotPainter onScreen(plot, plot.theme());
            const PlotPainter onPaper(plot, plot.theme(), {QSizeF(plot.size()), font});
            for (const PlotPainter* painter : {&onScreen, &onPaper}) {
                const std::vector<PlotLabel> labels = painter->labels();
                placed += labels.size();
                areas += static_cast<int>(std::ranges::count(labels, true, &PlotLabel::behind));
                std::vector<QRectF> taken = painter->pointers();
                QCOMPARE(taken.size(), marks.size() - 1);
                for (const PlotLabel& label : labels) {
                    QCOMPARE(painter->area().intersects(label.box), label.line.isEmpty());
                    for (const QRectF& other : taken) QVERIFY2(!other.intersects(label.box), qPrintable(label.text));
                    taken.push_back(label.box);
                }
            }
        }
        // Of the three places of a label, one is free almost always.
        QVERIFY2(areas > 180, qPrintable(QString::number(areas)));
        QVERIFY2(static_cast<double>(placed) > 1.8 * static_cast<double>(drawn), qPrintable(QString::number(placed)));
    }

    /// Twenty level lines: at the right in their order, none over another, each within the height of the area. Six
    /// upright ones above, likewise.
    void labelsOfLinesKeepTheirOrder()
    {
        PlotWidget plot;
        std::mt19937 generator(13);
        const auto draw = [&](double most) { return std::uniform_real_distribution(0.0, most)(generator); };
        QFont font;
        font.setPixelSize(11);
        for (int repeat = 0; repeat < 100; ++repeat) {
            plot.resize(static_cast<int>(400.0 + draw(500.0)), static_cast<int>(120.0 + draw(500.0)));
            plot.setView({PlotRange{0.0, 1e-3}, PlotRange{0.0, 30e-9}});
            std::vector<ReferenceLine> lines;
            for (int i = 0; i < 26; ++i) {
                const bool upright = i >= 20;
                const double value = draw(upright ? 1e-3 : 30e-9);
                lines.push_back({value, QStringLiteral("%1 %2").arg(value, 0, 'g', 9).arg(QString(i, u'n')), upright});
            }
            plot.setReferenceLines(lines);
            plot.refreshNow();
            const QSizeF sheet(300.0 + draw(200.0), 150.0 + draw(300.0));
            const PlotPainter onScreen(plot, plot.theme());
            const PlotPainter onPaper(plot, plot.theme(), {sheet, font});
            for (const auto& [painter, size] :
                 {std::pair(&onScreen, QSizeF(plot.size())), std::pair(&onPaper, sheet)}) {
                const QRectF& area = painter->area();
                const double most = painter == &onPaper ? PlotFrame::mostOnPaper : PlotFrame::mostLabels;
                QVERIFY(size.width() - area.right() <= most * size.width() + 1.0);
                double lowest = 1.0;   // value of the last label at the right
                double highest = -1.0; // of the last label above
                double bottom = area.top(), right = 0.0;
                int beside = 0, above = 0;
                double row = 1.0;
                for (const PlotLabel& label : painter->labels()) {
                    QVERIFY(QRectF(QPointF(), size).contains(label.box));
                    const double value = label.line.section(u' ', 0, 0).toDouble();
                    if (value < 30e-9) {
                        ++beside;
                        row = label.box.height();
                        QVERIFY(label.box.left() > area.right());
                        QVERIFY(value <= lowest && label.box.top() >= bottom - 1e-6);
                        QVERIFY(label.box.bottom() <= area.bottom() + 1e-6);
                        lowest = value;
                        bottom = label.box.bottom();
                    } else {
                        ++above;
                        QVERIFY(label.box.bottom() < area.top());
                        QVERIFY(value >= highest && label.box.left() >= right - 1e-6);
                        highest = value;
                        right = label.box.right();
                    }
                }
                QCOMPARE(beside, std::min(20, static_cast<int>(area.height() / row)));
                QVERIFY(above >= 1);
            }
        }
    }
};

void TestPlotPainter::placesStayWhereTheyHaveRoom()
{
    const auto places = labelPlaces({{20.0, 10.0}, {30.0, 10.0}, {80.0, 10.0}}, 0.0, 100.0);
    QCOMPARE(places[0], 20.0);
    QCOMPARE(places[1], 30.0);
    QCOMPARE(places[2], 80.0);
    QVERIFY(labelPlaces({}, 0.0, 100.0).empty());
    QVERIFY(!labelPlaces({{5.0, 10.0}}, 0.0, 5.0)[0]); // no room at all
}

/// Two at one place move by half a label each; at the border of the row both move inwards. Of three in a row for two
/// the nearest to another is left out.
void TestPlotPainter::placesShareTheirShifts()
{
    auto places = labelPlaces({{50.0, 10.0}, {50.0, 10.0}}, 0.0, 100.0);
    QCOMPARE(places[0], 45.0);
    QCOMPARE(places[1], 55.0);
    places = labelPlaces({{1.0, 10.0}, {2.0, 20.0}}, 0.0, 100.0);
    QCOMPARE(places[0], 5.0);
    QCOMPARE(places[1], 20.0);
    places = labelPlaces({{1.0, 10.0}, {18.0, 10.0}, {19.0, 10.0}}, 0.0, 20.0);
    QCOMPARE(places[0], 5.0);
    QCOMPARE(places[1], 15.0);
    QVERIFY(!places[2]);
}

void TestPlotPainter::placesKeepTheirOrderWithinTheRow()
{
    std::mt19937 generator(11);
    const auto draw = [&](double from, double to) { return std::uniform_real_distribution(from, to)(generator); };
    for (int repeat = 0; repeat < 500; ++repeat) {
        std::vector<WantedPlace> wanted(20);
        double all = 0.0;
        for (WantedPlace& each : wanted) {
            each = {draw(0.0, 400.0), draw(8.0, 30.0)};
            all += each.size;
        }
        std::ranges::sort(wanted, {}, &WantedPlace::at);
        const double low = draw(0.0, 50.0), high = draw(150.0, 600.0);
        const auto places = labelPlaces(wanted, low, high);
        QCOMPARE(places.size(), wanted.size());
        double end = low;
        int placed = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (!places[i]) continue;
            ++placed;
            QVERIFY(*places[i] - wanted[i].size / 2.0 >= end - 1e-9);
            end = *places[i] + wanted[i].size / 2.0;
        }
        QVERIFY(end <= high + 1e-9);
        if (all <= high - low) QCOMPARE(placed, 20);
        QVERIFY(placed >= 4);
    }
}

TOUCHDOWN_TEST(TestPlotPainter)

} // namespace test_plot_painter

#include "test_plot_painter.moc"
