// SPDX-License-Identifier: GPL-3.0-or-later
//
// The areas between the ways in and out of a pad, and the energies written into them.
#include "ui/runs/cycle_areas.h"

#include <cmath>
#include <memory>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

using namespace touchdown;

namespace test_cycle_areas {

/// A way in from 5 nm to 1 nm without force, and back with `force` [mN] between `from` and `to` [nm].
struct Loop {
    MinMaxPyramid separation, net;
    Loop(double force, double from, double to, bool back = true)
    {
        std::vector<double> times, d, f;
        const auto add = [&](double at, double value) {
            times.push_back(static_cast<double>(times.size()));
            d.push_back(at * 1e-9);
            f.push_back(value * 1e-3);
        };
        for (int i = 0; i <= 400; ++i) add(5.0 - 0.01 * i, 0.0);
        for (int i = 0; back && i <= 400; ++i) {
            const double at = 1.0 + 0.01 * i;
            add(at, at >= from && at <= to ? force : 0.0);
        }
        separation.append(times, d);
        net.append(times, f);
    }
    std::vector<ShadedArea> areas() const { return cycleAreas(separation, net); }
};

/// The area inside an outline by the shoelace formula [J].
double inside(const ShadedArea& area)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < area.outline.size(); ++i) {
        const auto& [x, y] = area.outline[i];
        const auto& [nextX, nextY] = area.outline[(i + 1) % area.outline.size()];
        twice += x * nextY - nextX * y;
    }
    return std::abs(0.5 * twice);
}

class TestCycleAreas : public QObject {
    Q_OBJECT

private slots:
    void aPullTakesEnergy();
    void aPushOnTheWayOutCreatesEnergy();
    void withoutALoopThereIsNoArea();
    void theFullLawIsShaded();
};

// 1 mN from 1 to 3 nm: 2 pJ.
void TestCycleAreas::aPullTakesEnergy()
{
    const auto areas = Loop(-1.0, 1.0, 3.0).areas();
    QCOMPARE(areas.size(), std::size_t(1));
    QVERIFY2(std::abs(inside(areas[0]) - 2e-12) < 0.02e-12, qPrintable(QString::number(inside(areas[0]))));
    QVERIFY2(areas[0].label.startsWith(QStringLiteral("W = 2")), qPrintable(areas[0].label));
}

// A push of 1 mN from 3 to 4 nm creates 1 pJ: W is negative.
void TestCycleAreas::aPushOnTheWayOutCreatesEnergy()
{
    const auto areas = Loop(1.0, 3.0, 4.0).areas();
    QCOMPARE(areas.size(), std::size_t(2));
    QVERIFY(std::abs(inside(areas[1]) - 1e-12) < 0.02e-12);
    QVERIFY(inside(areas[0]) < 1e-18);
    QVERIFY(areas[1].label.startsWith(QStringLiteral("creates 1")));
    QVERIFY(areas[0].label.contains(QStringLiteral("W = \u22121")));
    QVERIFY(areas[0].style.colour != areas[1].style.colour);
}

void TestCycleAreas::withoutALoopThereIsNoArea()
{
    QVERIFY(Loop(-1.0, 1.0, 3.0, false).areas().empty()); // it has not turned back
    QVERIFY(Loop(0.0, 1.0, 3.0).areas().empty());
    QVERIFY(cycleAreas(MinMaxPyramid(), MinMaxPyramid()).empty());
}

// The area of the plot is the work that the run reports: W of the loop of 401 points each way (multi_asperity.h).
void TestCycleAreas::theFullLawIsShaded()
{
    const Case c = openCase("contact_ono_yamane_full").value;
    auto record = std::make_unique<RunRecord>(1, c, "", recordedQuantities(c));
    const Summary summary = run(c, [&record](const RunUpdate& update) {
        record->append(update.samples, update.events);
        return true;
    });
    double work = 0.0;
    for (const RunFigure& figure : summary.figures)
        if (figure.quantity.name == "loop_work") work = figure.value;
    QVERIFY(work > 0.0);

    RunsModel runs;
    LivePlots plots(runs);
    runs.add(std::move(record));
    const PlotWidget* forces = plots.plot(QStringLiteral("force_separation"));
    QVERIFY(forces->shadedAreas().empty()); // not before its end
    runs.finish(1, summary);
    plots.runFinished(1);
    QCOMPARE(forces->shadedAreas().size(), std::size_t(1));
    const double shaded = inside(forces->shadedAreas()[0]);
    QVERIFY2(std::abs(shaded / work - 1.0) < 0.01, qPrintable(QStringLiteral("%1 %2").arg(shaded).arg(work)));
    QVERIFY(forces->shadedAreas()[0].label.startsWith(QStringLiteral("W = ")));
}

TOUCHDOWN_TEST(TestCycleAreas)

} // namespace test_cycle_areas

#include "test_cycle_areas.moc"
