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
                    QVERIFY(painter->area().contains(label.box));
                    for (const QRectF& other : taken) QVERIFY2(!other.intersects(label.box), qPrintable(label.text));
                    taken.push_back(label.box);
                }
            }
        }
        // Of the three places of a label, one is free almost always.
        QVERIFY2(areas > 180, qPrintable(QString::number(areas)));
        QVERIFY2(static_cast<double>(placed) > 1.8 * static_cast<double>(drawn), qPrintable(QString::number(placed)));
    }
};

TOUCHDOWN_TEST(TestPlotPainter)

} // namespace test_plot_painter

#include "test_plot_painter.moc"
