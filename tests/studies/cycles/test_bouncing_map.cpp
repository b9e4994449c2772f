// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_map.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/studies/cycles/bouncing_map_task.h"
#include "core/studies/study/study_reader.h"
#include "core/studies/study_plan.h"
#include "tests/support/bouncing_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_bouncing_map {

const std::string force = "x = \"ono_yamane.meniscus_force\"\nx_from = \"0.2 mN\"\nx_to = \"8 mN\"\n";
const std::string height = "y = \"ono_yamane.take_off\"\ny_from = \"3.2 nm\"\ny_to = \"6 nm\"\n";

std::string mapText(int points, const std::string& duration, int starts)
{
    const std::string number = std::to_string(points);
    return "duration = \"" + duration + "\"\n[map]\n" + force + "x_points = " + number + "\n" + height +
           "y_points = " + number + "\nstarts = " + std::to_string(starts) + "\n";
}

StudyReport performed(const Case& c, const std::string& text, int jobs = 2, const StudyCallback& callback = {})
{
    const StudyPlan plan = parseStudy("cycles", text, "study", {}, &c);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(jobs, callback);
}

/// The slider with little damping of the air.
Case lightlyDamped(TakeOffShape shape = TakeOffShape::Constant)
{
    Case c = bouncingSlider();
    c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.002;
    c.onoYamane.takeOffShape = shape;
    return c;
}

/// Six values of f_m by as many of d_e as the reader makes them.
BouncingMapTask taskOf(const Case& c)
{
    const StudyForm form{bouncingMapKeys(c, 1e-3)};
    const TomlDocument toml = readToml(mapText(6, "2 ms", 1));
    std::vector<InputProblem> problems;
    StudyReader reader(toml, "study", c, problems);
    reader.setKeys(form.keys);
    const auto task = readBouncingMap(reader, 1, 2e-3);
    if (!task) qFatal("%s", problems.front().text().c_str());
    return *task;
}

class TestBouncingMap : public QObject {
    Q_OBJECT

private slots:
    /// Without friction the contact gives -W in each loop and the dashpots only take energy: bouncing can last only
    /// where W < 0, and with little damping it does.
    void bouncingNeedsALawThatCreatesEnergy_data()
    {
        QTest::addColumn<TakeOffShape>("shape");
        for (const TakeOffShape shape : {TakeOffShape::Constant, TakeOffShape::Linear, TakeOffShape::BothLinear})
            QTest::addRow("%s", std::string(name(shape)).c_str()) << shape;
    }
    void bouncingNeedsALawThatCreatesEnergy()
    {
        QFETCH(TakeOffShape, shape);
        const StudyReport report = performed(lightlyDamped(shape), mapText(6, "2 ms", 1));
        QCOMPARE(report.status, StudyStatus::Completed);
        QCOMPARE(report.tables.size(), std::size_t(1));
        const StudyTable& map = report.tables.front();
        QCOMPARE(map.name, std::string("map"));
        QCOMPARE(map.rows.size(), std::size_t(36));
        int creating = 0, bouncing = 0;
        for (const auto& row : map.rows) {
            const double work = std::get<double>(row[2]);
            QCOMPARE(row.size(), report.tables.front().columns.size());
            const bool bounces = std::get<std::string>(row[3]) == name(MapClass::Bounces);
            QVERIFY2(work <= 0.0 || !bounces, qPrintable(QString("f_m %1, d_e %2, W %3")
                                                             .arg(std::get<double>(row[0]))
                                                             .arg(std::get<double>(row[1]))
                                                             .arg(work)));
            if (work > -0.3e-12) continue;
            ++creating;
            bouncing += bounces ? 1 : 0;
        }
        QVERIFY2(creating >= 6 && 10 * bouncing >= 8 * creating,
                 qPrintable(QString("%1 of %2").arg(bouncing).arg(creating)));
        QVERIFY2(report.findings.front().find(" with W < 0 and in 0 with W >= 0") != std::string::npos,
                 report.findings.front().c_str());

        const ChartPanel& panel = report.charts.front().panels.front();
        QCOMPARE(panel.map->cells.size(), std::size_t(36));
        QCOMPARE(panel.map->details.size(), std::size_t(36));
        QCOMPARE(panel.series.size(), std::size_t(1));
        QCOMPARE(panel.series.front().name, std::string("W = 0"));
    }

    /// W = f_m 1 nm - 2.5 pJ on the map and f_m 5 nm - 2.5 pJ in Fig. 13 with f_m = 10.7 mN; Figs. 10 and 12 have d_e =
    /// 5 nm. A mark by W stands where f_m 1 nm gives the same.
    void marksByWork()
    {
        const std::string marks = "[[mark]]\nname = \"Fig. 10\"\nwork_of = \"fig10a\"\ny = 0.01\n"
                                  "[[mark]]\nname = \"Fig. 13\"\nwork_of = \"fig13a\"\ny = 0.005\n"
                                  "[[mark]]\nname = \"weak\"\nx = \"2 mN\"\ny = 0.01\n";
        const StudyReport report = performed(
            bouncingSlider(), "duration = \"0.05 ms\"\n[map]\nx = \"ono_yamane.meniscus_force\"\nx_from = \"1 mN\"\n"
                              "x_to = \"100 mN\"\nx_points = 2\nx_scale = \"logarithmic\"\ny = "
                              "\"springs.rear_damping_ratio\"\ny_from = 0.001\ny_to = 0.1\ny_points = 2\nstarts = 1\n" +
                                  marks);
        const auto found = std::ranges::find(report.tables, std::string("marks"), &StudyTable::name);
        QVERIFY(found != report.tables.end());
        QCOMPARE(found->rows.size(), std::size_t(3));
        const double fig10 = 10.7e-3 * 2e-9 - 2.5e-12, fig13 = 10.7e-3 * 5e-9 - 2.5e-12, weak = 2e-12 - 2.5e-12;
        std::size_t i = 0;
        for (const double work : {fig10, fig13, weak}) {
            QVERIFY(std::abs(std::get<double>(found->rows[i][1]) / ((work + 2.5e-12) / 1e-9) - 1.0) < 1e-9);
            QVERIFY(std::abs(std::get<double>(found->rows[i][3]) - work) < 1e-9 * 2.5e-12);
            ++i;
        }
        QCOMPARE(std::get<double>(found->rows[1][2]), 0.005);
        // The chart says how such marks are placed, and a cell names only the ends that occur.
        const StudyChart& chart = report.charts.front();
        const StudyReport plain = performed(bouncingSlider(), mapText(2, "0.05 ms", 1));
        QVERIFY(chart.caption.size() > plain.charts.front().caption.size());
        for (const std::string& detail : chart.panels.front().map->details)
            QVERIFY2(detail.find(" 0 ") == std::string::npos, detail.c_str());
        // Two of the cells have f_m = 1 mN, W = -1.5 pJ.
        QVERIFY(std::ranges::any_of(report.warnings, [](const std::string& each) {
            return each.starts_with("W is negative in 2 of 4 cells");
        }));
    }

    /// W is linear in f_m.
    void theLineIsWhereTheWorkIsZero()
    {
        for (const TakeOffShape shape : {TakeOffShape::Constant, TakeOffShape::Linear, TakeOffShape::BothLinear}) {
            const BouncingMapTask task = taskOf(lightlyDamped(shape));
            const auto line = zeroWork(task);
            QVERIFY(line.size() > 50);
            for (const auto& [x, y] : line) {
                OnoYamane law = task.start.onoYamane;
                law.takeOff = y;
                QVERIFY(std::abs(x / meniscusForceForWork(law, 0.0) - 1.0) < 1e-9);
            }
        }
    }
    void noLineWhereTheWorkKeepsItsSign()
    {
        BouncingMapTask task = taskOf(lightlyDamped());
        task.x.values = {0.1e-3, 0.2e-3};
        QVERIFY(zeroWork(task).empty());
    }

    void classes()
    {
        const auto kind = [](int flies, int caught, int bounces, int failed, int unknown = 0) {
            MapCell cell;
            cell.ends = {flies, caught, bounces, unknown, failed};
            return cell.kind();
        };
        QCOMPARE(kind(3, 0, 0, 0), MapClass::Flies);
        QCOMPARE(kind(0, 3, 0, 0), MapClass::Caught);
        QCOMPARE(kind(1, 2, 0, 0), MapClass::FliesOrCaught);
        QCOMPARE(kind(1, 0, 1, 1), MapClass::Bounces);
        QCOMPARE(kind(2, 0, 0, 1), MapClass::Fails);
        QCOMPARE(kind(1, 1, 0, 0, 1), MapClass::Unknown);
        QCOMPARE(kind(1, 0, 1, 0, 1), MapClass::Bounces);
        QCOMPARE(kind(1, 0, 0, 1, 1), MapClass::Fails);
    }

    /// A take-off height below that of touch-down is no case.
    void cellsWithoutACaseFail()
    {
        const BouncingMapTask task = taskOf(lightlyDamped());
        const MapCell cell = judgeCell(task, 1e-3, 2e-9);
        QVERIFY(cell.done);
        QCOMPARE(cell.kind(), MapClass::Fails);
        QVERIFY(!cell.problem.empty());
    }

    void sameWithOneThreadOrThree()
    {
        const std::string text = mapText(3, "0.3 ms", 2);
        const StudyReport one = performed(bouncingSlider(), text, 1), three = performed(bouncingSlider(), text, 3);
        QCOMPARE(one.findings, three.findings);
        QVERIFY(one.tables.front().rows == three.tables.front().rows);
        QVERIFY(one.charts.front().panels.front().map->cells == three.charts.front().panels.front().map->cells);
    }

    /// A cell that is shown early has the class that it keeps.
    void growsWhileItIsMade()
    {
        std::vector<std::vector<int>> seen;
        const StudyReport report =
            performed(bouncingSlider(), mapText(8, "10 ms", 2), 2, [&seen](const StudyProgress& progress) {
                if (progress.soFar) seen.push_back(progress.soFar->charts.back().panels.front().map->cells);
                return true;
            });
        const std::vector<int>& whole = report.charts.front().panels.front().map->cells;
        QVERIFY2(seen.size() >= 2, qPrintable(QString::number(seen.size())));
        std::ptrdiff_t before = 0;
        for (const std::vector<int>& cells : seen) {
            const std::ptrdiff_t done = std::ranges::count_if(cells, [](int kind) { return kind >= 0; });
            QVERIFY(done >= before && done <= std::ptrdiff_t(whole.size())); // one may be written, but not counted
            before = done;
            for (std::size_t i = 0; i < cells.size(); ++i) QVERIFY(cells[i] < 0 || cells[i] == whole[i]);
        }
    }

    void stops()
    {
        const StudyReport report =
            performed(bouncingSlider(), mapText(30, "50 ms", 2), 2, [](const StudyProgress&) { return false; });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QVERIFY(report.findings.empty());
        QCOMPARE(report.charts.front().panels.front().map->cells.back(), -1);
    }

    /// With a range of its own the study follows cycles as well.
    void cyclesAndMap()
    {
        std::vector<double> shares;
        const StudyReport report =
            performed(bouncingSlider(), "from = \"4 mN\"\nto = \"5 mN\"\nvalues = 1\n" + mapText(2, "0.2 ms", 1), 1,
                      [&](const StudyProgress& progress) {
                          shares.push_back(progress.share);
                          return true;
                      });
        QCOMPARE(report.tables.front().name, std::string("cycles"));
        QCOMPARE(report.tables.back().name, std::string("map"));
        QVERIFY(std::ranges::is_sorted(shares) && shares.back() <= 1.0);
    }

    void problems_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* title, const std::string& text, const char* says) {
            QTest::newRow(title) << QString::fromStdString("[map]\n" + text) << says;
        };
        const std::string y = "y = \"slider.mass\"\n";
        row("no x", height, "study:1: map.x: is missing; a key of the case");
        row("no such key", "x = \"slider.mas\"\n" + height, "study:2: map.x: \"slider.mas\" is no key of a case");
        row("of the start", "x = \"initial.pitch\"\n" + height,
            "study:2: map.x: \"initial.pitch\" belongs to the start");
        row("no end", force + y + "y_from = \"1 mg\"\n", "study:1: map.y_to: is missing: ");
        row("an empty range", force + y + "y_from = \"1 mg\"\ny_to = \"1 mg\"\n",
            "study:7: map.y_to: is the same as y_from");
        row("out of range", force + y + "y_from = \"-1 mg\"\ny_to = \"1 mg\"\n", "study:6: map.y_from: ");
        row("points", force + height + "x_points = 1\n", "study:8: map.x_points: must be a whole number from 2 to 100");
        row("starts", force + height + "starts = 0\n", "study:8: map.starts: must be a whole number from 1 to 8");
        row("scale", force + height + "y_scale = \"log\"\n", "study:8: map.y_scale: \"log\" is not known");
        row("zero on a logarithmic scale",
            force + "y = \"ono_yamane.friction\"\ny_from = 0\ny_to = 1\ny_scale = \"logarithmic\"\n",
            "study:6: map.y_from: must be greater than 0");
        row("one key twice", force + "y = \"ono_yamane.meniscus_force\"\ny_from = \"1 mN\"\ny_to = \"2 mN\"\n",
            "study:5: map.y: \"ono_yamane.meniscus_force\" is the key of x, too");
        row("a mark off the map", force + height + "[[mark]]\nname = \"a\"\nx = \"9 mN\"\ny = \"4 nm\"\n",
            "study:10: mark[1].x: ");
        row("a mark with two places",
            force + height + "[[mark]]\nname = \"a\"\nx = \"1 mN\"\nwork_of = \"fig10a\"\ny = \"4 nm\"\n",
            "study:11: mark[1].work_of: stands beside x");
        row("a mark of no case", force + height + "[[mark]]\nname = \"a\"\nwork_of = \"fig99\"\ny = \"4 nm\"\n",
            "study:10: mark[1].work_of: \"fig99\" is no valid case");
        row("W is not on the map", force + height + "[[mark]]\nname = \"a\"\nwork_of = \"fig12a\"\ny = \"4 nm\"\n",
            "study:10: mark[1].work_of: \"fig12a\" has W = 97.5 pJ");
        row("an unknown key", force + height + "z = 3\n", "study:8: map.z: unknown key");
    }
    void problems()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Case c = bouncingSlider();
        const StudyPlan plan = parseStudy("cycles", text.toStdString(), "study", {}, &c);
        QStringList said;
        for (const InputProblem& each : plan.problems) said.append(QString::fromStdString(each.text()));
        QVERIFY2(said.size() == 1 && said.front().startsWith(says), qPrintable(said.join('\n')));
    }
};

TOUCHDOWN_TEST(TestBouncingMap)

} // namespace test_bouncing_map

#include "test_bouncing_map.moc"
