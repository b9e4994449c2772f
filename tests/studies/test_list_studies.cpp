// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every kind of study that is a list: parts, kept rows and any number of threads give the tables of one run.
#include <algorithm>
#include <set>

#include <QTest>

#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_list_studies {

const std::string twoDrops = R"(
case = "fig12a"
starts = 3
[[statement]]
figure = "a"
quote = "It ends in contact."
case = "fig12a"
set = { "run.duration" = "60 us" }
end = ["contact"]
spread = "0.4 nm"
[[statement]]
figure = "b"
quote = "It flies higher than the other one."
case = "fig12a"
set = { "run.duration" = "60 us", "initial.flying_height" = "20 nm" }
quantity = "flying_height"
at = "mean"
like = "fig12a"
like_set = { "run.duration" = "60 us" }
at_least = "0 nm"
[[statement]]
figure = "c"
quote = "It comes near."
case = "fig12a"
set = { "run.duration" = "60 us" }
quantity = "flying_height"
at = "least"
at_most = "1 um"
)";

const std::string somePairs = R"(
parameter = "initial.flying_height"
values = ["230 nm", "100 nm"]
picture = true
[[method]]
name = "rk4"
set = { "run.integrator" = "rk4" }
key = "run.step"
values = ["100 ns", "10 ns", "5 ns"]
)";

const std::string smallMap = R"(
case = "fig10a"
[map]
x = "ono_yamane.meniscus_force"
x_from = "1 mN"
x_to = "9 mN"
x_points = 3
y = "ono_yamane.take_off"
y_from = "2 nm"
y_to = "6 nm"
y_points = 2
)";

/// Times that were measured are not the same twice.
std::vector<StudyTable> tablesOf(const StudyReport& report)
{
    std::vector<StudyTable> tables = report.tables;
    for (StudyTable& table : tables)
        for (std::size_t k = 0; k < table.columns.size(); ++k)
            if (table.columns[k].name == "seconds")
                for (auto& row : table.rows) row[k] = {};
    return tables;
}

bool same(const StudyReport& a, const StudyReport& b)
{
    const std::vector<StudyTable> first = tablesOf(a), second = tablesOf(b);
    return a.findings == b.findings && a.warnings == b.warnings && a.charts.size() == b.charts.size() &&
           std::ranges::equal(first, second, [](const StudyTable& x, const StudyTable& y) {
               return x.name == y.name && x.rows == y.rows;
           });
}

class TestListStudies : public QObject {
    Q_OBJECT

private slots:
    void partsAndKeptRowsGiveTheSame_data()
    {
        QTest::addColumn<StudyPlan>("plan");
        const auto row = [](const char* kind, const std::string& text, const char* name = nullptr,
                            const std::vector<std::string>& settings = {},
                            const std::vector<std::string>& options = {}) {
            QTest::newRow(kind) << (name == nullptr ? parseStudy(kind, text, "text", {}, nullptr, settings, options)
                                                    : openStudy(kind, name, settings, options));
        };
        row("statements", twoDrops);
        row("stability", "case = \"fig10b_naive_switching\"\n" + somePairs, nullptr, {"run.duration=0.3 ms"});
        row("convergence", "", "contact_hertz", {}, {"levels=3"});
        row("cycles", smallMap);
        row("sweep", "", "fig10a", {"run.duration=20 us"});
    }
    void partsAndKeptRowsGiveTheSame()
    {
        QFETCH(StudyPlan, plan);
        QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
        QVERIFY(plan.performList);
        const StudyReport whole = plan.perform(2, {});
        QVERIFY2(whole.status == StudyStatus::Completed, whole.message.c_str());
        QCOMPARE(whole.items.size(), plan.items);
        std::set<std::string> keys;
        for (const StudyItem& item : whole.items) keys.insert(item.key);
        QCOMPARE(keys.size(), plan.items); // no two items are taken for one
        for (const StudyTable& table : whole.tables)
            for (const auto& row : table.rows) QCOMPARE(row.size(), table.columns.size());

        KeptRows joined;
        for (std::size_t part = 1; part <= 3; ++part)
            for (StudyItem& item : plan.performList({.jobs = int(part), .part = {part, 3}}, {}).items)
                joined.emplace(std::move(item.key), std::move(item.row));
        QCOMPARE(joined.size(), plan.items);
        QVERIFY(same(plan.performList({.kept = &joined, .onlyKept = true}, {}), whole));

        // Some of the rows: the others are solved again, and come out the same.
        KeptRows some;
        for (std::size_t i = 0; i < whole.items.size(); i += 2) some.emplace(whole.items[i].key, whole.items[i].row);
        std::size_t taken = 0;
        const StudyReport rest = plan.performList({.jobs = 2, .kept = &some, .taken = &taken}, {});
        QVERIFY(same(rest, whole));
        QCOMPARE(taken, some.size());
    }

    /// What a study shows while it is under way holds its rows, so that none is lost with the program.
    void partialReportsHoldTheirRows()
    {
        const StudyPlan plan = openStudy("sweep", "fig10a", {"run.duration=500 ms"});
        std::size_t most = 0;
        plan.perform(1, [&](const StudyProgress& progress) {
            if (progress.soFar != nullptr && !progress.soFar->tables.empty()) {
                if (progress.soFar->items.size() != progress.soFar->tables.front().rows.size()) qFatal("rows are lost");
                most = std::max(most, progress.soFar->items.size());
            }
            return most < 3;
        });
        QVERIFY(most >= 3);
    }
};

TOUCHDOWN_TEST(TestListStudies)

} // namespace test_list_studies

#include "test_list_studies.moc"
