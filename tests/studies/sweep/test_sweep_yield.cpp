// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_yield.h"

#include <cmath>
#include <random>

#include <QTest>

#include "core/formats/units.h"
#include "core/studies/study_plan.h"
#include "core/studies/sweep/sweep_surface.h"
#include "tests/support/sample_case.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_sweep_yield {

double number(const StudyValue& value) { return std::get<double>(value); }

const StudyTable& tableOf(const StudyReport& report, const std::string& name)
{
    const auto found = std::ranges::find(report.tables, name, &StudyTable::name);
    if (found == report.tables.end()) qFatal("no table %s", name.c_str());
    return *found;
}

StudyReport performed(const Case& c, const std::string& text)
{
    const StudyPlan plan = parseStudy("sweep", text, "study", {}, &c);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(2, {});
}

/// Axes of numbers whose unit does not matter here.
std::vector<SweepAxis> drawnAxes(std::size_t count, std::mt19937& draw)
{
    std::uniform_real_distribution<double> even(0.5, 2.0);
    std::vector<SweepAxis> axes(count);
    for (std::size_t k = 0; k < count; ++k) {
        axes[k].from = -even(draw);
        axes[k].to = even(draw);
        if (k % 2 == 1) {
            axes[k].mean = 0.1 * even(draw);
            axes[k].deviation = 0.3 * even(draw);
        }
    }
    return axes;
}

const std::string tolerances = R"(
calculate = "steady"
[[axis]]
key = "suspension.preload"
distribution = "normal"
mean = "1 gf"
deviation = "0.02 gf"
[[axis]]
key = "abs.crown"
from = "8 nm"
to = "12 nm"
[[axis]]
key = "suspension.pitch_torque"
distribution = "normal"
mean = "0 uN m"
deviation = "0.02 uN m"
)";

class TestSweepYield : public QObject {
    Q_OBJECT

private slots:
    /// What is of second order is met everywhere; a cube is not.
    void aSurfaceOfSecondOrderIsExact()
    {
        std::mt19937 draw(60);
        std::normal_distribution<double> normal;
        for (const std::size_t axes : {1, 2, 3, 5, 8}) {
            const std::vector<std::vector<double>> design = surfaceDesign(drawnAxes(axes, draw), 1);
            QCOMPARE(design.size(), surfaceItems(axes) + surfaceChecks);
            Eigen::MatrixXd a(axes, axes);
            Eigen::VectorXd b(axes);
            for (double& value : a.reshaped()) value = normal(draw);
            for (double& value : b) value = normal(draw);
            const auto exact = [&](const std::vector<double>& at, double cubic) {
                const auto x = Eigen::Map<const Eigen::VectorXd>(at.data(), Eigen::Index(at.size()));
                return 3.0 + b.dot(x) + x.dot(a * x) + cubic * x[0] * x[0] * x[0];
            };
            for (const double cubic : {0.0, 1.0}) {
                std::vector<double> values;
                for (const auto& item : design) values.push_back(exact(item, cubic));
                const ResponseSurface surface(design, values);
                double most = 0.0;
                for (std::size_t i = 0; i < design.size(); ++i)
                    most = std::max(most, std::abs(surface.at(design[i]) - values[i]));
                QVERIFY2(cubic == 0.0 ? most < 1e-9 : most > 1e-3, qPrintable(QString::number(most)));
            }
        }
    }

    /// The samples are the same points, one by one or from the surface.
    void sharesAreThoseOfExactItems()
    {
        Case c = smallSlider(33);
        c.suspension.preload = 1.0e-3 * 9.80665;
        c.initial.state = InitialState::Given;
        const std::string text = tolerances;
        const StudyReport first = performed(c, text + "[samples]\nmethod = \"sobol\"\ncount = 200\nby = \"surface\"\n" +
                                                   "[[reading]]\nquantity = \"pitch\"\n");
        QVERIFY2(first.status == StudyStatus::Completed, first.message.c_str());
        // A limit that about a third of the samples do not hold.
        const StudyTable& spread = tableOf(first, "spread");
        const double mean = number(spread.rows[0][2]), deviation = number(spread.rows[0][3]);
        const std::string limit = "most = \"" + std::to_string(mean + 0.4 * deviation) + " urad\"\n",
                          reading = "[[reading]]\nquantity = \"pitch\"\n" + limit;
        const auto shareOf = [&](const std::string& by) {
            const StudyReport report =
                performed(c, text + "[samples]\nmethod = \"sobol\"\ncount = 200\nby = \"" + by + "\"\n" + reading);
            const double share = number(tableOf(report, "spread").rows[0][7]);
            // With what as many other samples may give, in 95 % of the draws.
            const std::string may = "+- " + fewDigits(196.0 * std::sqrt(share * (1.0 - share) / 200.0), "", 2) + " %";
            const std::string& finding = report.findings.front();
            if (finding.find(may) == std::string::npos) qFatal("%s has no %s", finding.c_str(), may.c_str());
            return share;
        };
        const double surface = shareOf("surface"), exact = shareOf("items");
        QVERIFY(exact > 0.5 && exact < 0.8);
        QVERIFY2(std::lround(200.0 * std::abs(surface - exact)) <= 2, // 1 %
                 qPrintable(QString("%1 %2").arg(surface).arg(exact)));
    }

    void whatToTightenFirst()
    {
        Case c = smallSlider(33);
        const StudyReport report =
            performed(c, tolerances + "[samples]\nmethod = \"sobol\"\ncount = 2000\nby = \"surface\"\n" +
                             "[[reading]]\nquantity = \"minimum_spacing\"\n[[reading]]\nquantity = \"pitch\"\n"
                             "least = \"1 urad\"\n");
        QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
        const StudyTable& tighter = tableOf(report, "tighter");
        QCOMPARE(tighter.rows.size(), std::size_t(3));
        for (std::size_t k = 1; k < tighter.rows.size(); ++k)
            QVERIFY(number(tighter.rows[k - 1][1]) >= number(tighter.rows[k][1]));
        QCOMPARE(report.tables.front().rows.size(), surfaceItems(3) + surfaceChecks);
        QVERIFY(report.charts.size() == 2 && !report.charts.front().panels.front().series.front().points.empty());
    }

    /// A normal distribution that is cut off at its mean still has points on both sides of its middle.
    void aMiddleHasTwoSides()
    {
        SweepAxis axis;
        axis.from = axis.mean = 1.0;
        axis.to = 3.0;
        axis.deviation = 0.5;
        const std::vector<std::vector<double>> design = surfaceDesign({axis}, 1);
        QVERIFY(design[1][0] < design[0][0] && design[0][0] < design[2][0]);
        QVERIFY(design[1][0] >= 1.0 && design[2][0] <= 3.0);
    }

    /// An item may not know its error, and the surface needs none.
    void statedErrorsMayBeMissing()
    {
        std::mt19937 draw(1);
        SweepTask task;
        task.axes = drawnAxes(2, draw);
        task.readings = {{.quantity = {"spacing", "m", "nm", "Spacing"}},
                         {.quantity = {"spacing", "m", "nm", "Spacing"}, .isError = true}};
        task.limits.resize(2);
        task.samples = SweepSamples{.count = 50, .bySurface = true};
        task.points = samplePoints(SampleMethod::Random, 2, 50, 1);
        task.design = surfaceDesign(task.axes, 1);
        ItemRows rows;
        for (const std::vector<double>& item : task.design)
            rows.push_back(ItemRow{1.0 + item[0] - item[1], StudyValue(), std::string()});
        const StudyReport report = surfaceReport(task, rows);
        QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
        QCOMPARE(tableOf(report, "spread").rows.size(), std::size_t(1));
        rows[3]->front() = StudyValue();
        QCOMPARE(surfaceReport(task, rows).status, StudyStatus::Failed);
    }

    void limitsOfAGrid()
    {
        Case c = sample("fig10a");
        c.run.duration = 50e-6;
        const std::string text = R"(
[[axis]]
key = "initial.flying_height"
values = ["150 nm", "180 nm", "210 nm", "240 nm"]
[[reading]]
quantity = "flying_height"
at = "most"
)";
        std::vector<double> values;
        const StudyReport without = performed(c, text);
        for (const auto& row : without.tables.front().rows) values.push_back(number(row[1]));
        std::ranges::sort(values);
        QVERIFY(values[1] < values[2]);
        const std::string limit = std::to_string(0.5e9 * (values[1] + values[2])) + " nm\"\n";
        for (const auto& [line, share] : {std::pair{"most = \"" + limit, "50 %"},
                                          {"least = \"" + limit, "50 %"},
                                          {"least = \"1 nm\"\nmost = \"" + limit, "50 %"},
                                          {std::string("least = \"1 nm\"\n"), "100 %"}}) {
            const StudyReport report = performed(c, text + line);
            QVERIFY2(report.findings.front().starts_with(share + std::string(" of 4 points lie within all limits")),
                     report.findings.front().c_str());
        }
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const QString samples = "[samples]\nmethod = \"random\"\nby = \"surface\"\n",
                      axis = "[[axis]]\nkey = \"slider.mass\"\nfrom = \"1 mg\"\nto = \"2 mg\"\n",
                      read = "[[reading]]\nquantity = \"flying_height\"\n";
        const auto row = [](const char* name, const QString& text, const char* says) {
            QTest::newRow(name) << text << says;
        };
        row("a list", samples + "[[axis]]\nkey = \"slider.mass\"\nvalues = [\"1 mg\", \"2 mg\"]\n" + read,
            "takes no list of values");
        row("a text", samples + axis + "[[reading]]\nquantity = \"motion\"\n", "has no texts");
        row("a grid", "[samples]\nby = \"surface\"\n" + axis + read, "needs samples.method");
        row("limits of a text", axis + "[[reading]]\nquantity = \"motion\"\nleast = 1\n", "has no meaning for a text");
        row("limits", axis + read + "least = \"3 nm\"\nmost = \"2 nm\"\n", "must not be below least");
        row("a unit", axis + read + "least = \"3 urad\"\n", "3 urad");
    }
    void refuses()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Case c = sample("fig10a");
        const StudyPlan plan = parseStudy("sweep", text.toStdString(), "study", {}, &c);
        QVERIFY(!plan.valid());
        QVERIFY2(plan.problems.front().text().find(says.toStdString()) != std::string::npos,
                 plan.problems.front().text().c_str());
    }

    void anItemThatFailsLeavesNoSurface()
    {
        Case c = smallSlider(33);
        const StudyReport report = performed(c, R"(
calculate = "steady"
[samples]
method = "random"
by = "surface"
count = 10
[[axis]]
key = "suspension.preload"
from = "0.1 gf"
to = "400 gf"
[[reading]]
quantity = "pitch"
)");
        QCOMPARE(report.status, StudyStatus::Failed);
        QVERIFY2(report.message.starts_with("the surface needs all of its items"), report.message.c_str());
        QVERIFY(report.tables.front().rows.size() > 3);
    }
};

} // namespace test_sweep_yield

using test_sweep_yield::TestSweepYield;
TOUCHDOWN_TEST(TestSweepYield)
#include "test_sweep_yield.moc"
