// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/item_study.h"

#include <algorithm>
#include <atomic>
#include <set>

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_item_study {

/// Squares; counts how often each was solved.
struct Squares {
    std::vector<std::atomic<int>> solved;
    explicit Squares(std::size_t count) : solved(count) {}

    ItemStudy study(double factor = 1.0)
    {
        return {.count = solved.size(),
                .width = 1,
                .content = [factor](std::size_t i) { return std::to_string(i) + " " + std::to_string(factor); },
                .solve = [this, factor](std::size_t i, ItemCall&) -> std::optional<ItemRow> {
                    ++solved[i];
                    return ItemRow{factor * double(i * i)};
                },
                .report =
                    [](const ItemRows& rows) {
                        StudyReport report;
                        StudyTable table{"squares", {{.name = "square"}}};
                        for (const auto& row : rows)
                            if (row) table.rows.push_back(*row);
                        report.tables.push_back(std::move(table));
                        report.findings.emplace_back("all done");
                        return report;
                    }};
    }
};

KeptRows rowsOf(const StudyReport& report)
{
    KeptRows rows;
    for (const StudyItem& item : report.items) rows.emplace(item.key, item.row);
    return rows;
}

class TestItemStudy : public QObject {
    Q_OBJECT

private slots:
    void sameForAnyNumberOfThreads()
    {
        Squares one(101);
        const StudyReport whole = performItems(one.study(), {.jobs = 1}, {});
        QCOMPARE(whole.status, StudyStatus::Completed);
        QCOMPARE(whole.items.size(), std::size_t(101));
        for (const int jobs : {2, 3, 7}) {
            Squares more(101);
            const StudyReport report = performItems(more.study(), {.jobs = jobs}, {});
            QVERIFY(report.tables[0].rows == whole.tables[0].rows);
            for (const auto& count : more.solved) QCOMPARE(count.load(), 1);
        }
    }

    /// All parts together have each item once, and joined they are the whole.
    void partsJoin()
    {
        Squares direct(50);
        const StudyReport whole = performItems(direct.study(), {}, {});
        for (const std::size_t of : {1, 2, 3, 7, 50, 64}) {
            Squares squares(50);
            KeptRows kept;
            for (std::size_t part = 1; part <= of; ++part) {
                const StudyReport one = performItems(squares.study(), {.part = {part, of}}, {});
                QCOMPARE(one.items.size(), ItemPart({part, of}).size(50));
                QCOMPARE(one.findings.empty(), of > 1);
                kept.merge(rowsOf(one));
            }
            for (const auto& count : squares.solved) QCOMPARE(count.load(), 1);
            const StudyReport joined = performItems(squares.study(), {.kept = &kept, .onlyKept = true}, {});
            QCOMPARE(joined.status, StudyStatus::Completed);
            QVERIFY(joined.tables[0].rows == whole.tables[0].rows);
            QCOMPARE(joined.findings, whole.findings);
            for (const auto& count : squares.solved) QCOMPARE(count.load(), 1);
        }
    }

    void aPartThatIsMissing()
    {
        Squares squares(10);
        const KeptRows kept = rowsOf(performItems(squares.study(), {.part = {1, 2}}, {}));
        const StudyReport joined = performItems(squares.study(), {.kept = &kept, .onlyKept = true}, {});
        QCOMPARE(joined.status, StudyStatus::Failed);
        QCOMPARE(joined.message, std::string("5 items of 10 have no row in these files: 2, 4, 6, 8, 10"));
        QVERIFY(joined.findings.empty());
    }

    /// Rows of other content are not taken, nor are those of another width.
    void onlyItsOwnRows()
    {
        Squares squares(10);
        KeptRows kept = rowsOf(performItems(squares.study(2.0), {}, {}));
        const StudyReport other = performItems(squares.study(3.0), {.kept = &kept}, {});
        QCOMPARE(std::get<double>(other.items[3].row[0]), 27.0);
        QCOMPARE(other.items.size(), std::size_t(20)); // those of the other content stay
        kept = rowsOf(performItems(squares.study(3.0), {}, {}));
        for (auto& [key, row] : kept) row.emplace_back(1.0);
        const StudyReport again = performItems(squares.study(3.0), {.kept = &kept}, {});
        QCOMPARE(again.items[3].row.size(), std::size_t(1));
        QCOMPARE(squares.solved[3].load(), 4);
    }

    /// What was solved before a stop is kept, and the next call solves the rest alone.
    void stopsAndGoesOn()
    {
        Squares squares(200);
        KeptRows kept;
        ItemOptions options;
        options.keep = [&](const std::string& key, const ItemRow& row) {
            kept.emplace(key, row);
            return std::string();
        };
        ItemStudy slow = squares.study();
        slow.solve = [&, solve = slow.solve](std::size_t i, ItemCall& call) {
            while (kept.size() > 20 && call.goOn()) {
            }
            return call.goOn() ? solve(i, call) : std::nullopt;
        };
        const StudyReport stopped =
            performItems(slow, options, [&](const StudyProgress& progress) { return progress.share < 0.1; });
        QCOMPARE(stopped.status, StudyStatus::Cancelled);
        QCOMPARE(stopped.items.size(), kept.size());
        QVERIFY(!kept.empty() && kept.size() < 200);
        const KeptRows before = kept;
        options.kept = &before;
        const StudyReport whole = performItems(squares.study(), options, {});
        QCOMPARE(whole.status, StudyStatus::Completed);
        QCOMPARE(whole.items.size(), std::size_t(200));
        for (const auto& count : squares.solved) QCOMPARE(count.load(), 1);
    }

    /// A row that cannot be kept ends the study: nothing is solved in vain.
    void aFullDisk()
    {
        Squares squares(1000);
        ItemOptions options;
        options.keep = [](const std::string&, const ItemRow&) { return std::string("no space left"); };
        const StudyReport report = performItems(squares.study(), options, {});
        QCOMPARE(report.status, StudyStatus::Failed);
        QCOMPARE(report.message, std::string("no space left"));
        QCOMPARE(std::ranges::count_if(squares.solved, [](const auto& count) { return count > 0; }), std::ptrdiff_t(1));
    }

    /// Long items begin first; those whose work another one does come last; the share follows the costs.
    void costsOrderTheItems()
    {
        Squares squares(40);
        std::vector<std::size_t> order;
        ItemStudy study = squares.study();
        study.cost = [](std::size_t i) { return i == 17 ? 500.0 : i == 5 ? 300.0 : i % 8 == 0 ? 0.0 : 1.0; };
        study.solve = [&, solve = study.solve](std::size_t i, ItemCall& call) {
            order.push_back(i);
            call.tell(0.5);
            return solve(i, call);
        };
        performItems(study, {.jobs = 1}, {});
        QCOMPARE(order.size(), std::size_t(40));
        QCOMPARE(order[0], std::size_t(17));
        QCOMPARE(order[1], std::size_t(5));
        for (std::size_t k = 0; k < 40; ++k) QCOMPARE(order[k] % 8 == 0, k >= 35);
        QVERIFY(!std::ranges::is_sorted(order.begin() + 2, order.begin() + 35)); // scattered
    }
    /// One item of a cost of 3 and one of 1: after half of the first, 3/8.
    void theShareFollowsTheCosts()
    {
        Squares squares(2);
        ItemStudy study = squares.study();
        study.cost = [](std::size_t i) { return i == 0 ? 3.0 : 1.0; };
        std::atomic<bool> seen = false;
        study.solve = [&, solve = study.solve](std::size_t i, ItemCall& call) {
            call.tell(0.5);
            while (i == 0 && !seen && call.goOn()) {
            }
            return solve(i, call);
        };
        performItems(study, {.jobs = 1}, [&](const StudyProgress& progress) {
            if (progress.share == 0.375) seen = true;
            return progress.share <= 0.375 || seen;
        });
        QVERIFY(seen);
    }
    /// The report waits for what it needs, and a study that is stopped meanwhile solves nothing.
    void preparesItsReport()
    {
        Squares squares(3);
        ItemStudy study = squares.study();
        bool prepared = false;
        study.prepare = [&](const GoOn& goOn) { return prepared = goOn(); };
        study.report = [&, report = study.report](const ItemRows& rows) {
            if (!prepared) qFatal("the report is asked for too early");
            return report(rows);
        };
        QCOMPARE(performItems(study, {}, {}).status, StudyStatus::Completed);
        prepared = false;
        const StudyReport stopped = performItems(study, {}, [](const StudyProgress&) { return false; });
        QCOMPARE(stopped.status, StudyStatus::Cancelled);
        QVERIFY(!prepared && stopped.items.empty());
        for (const auto& count : squares.solved) QCOMPARE(count.load(), 1);
    }
    /// Files are named by the keys of the items; what cannot be written ends the study with its reason.
    void wholeResults()
    {
        Squares squares(3);
        ItemStudy study = squares.study();
        std::set<std::string> files;
        study.solve = [&, solve = study.solve](std::size_t i, ItemCall& call) {
            files.insert(call.file.string());
            return solve(i, call);
        };
        performItems(study, {.files = "runs"}, {});
        QCOMPARE(files, std::set<std::string>{""}); // it keeps none
        study.keepsFiles = true;
        files.clear();
        const StudyReport report = performItems(study, {.files = "runs"}, {});
        for (const StudyItem& item : report.items) {
            QVERIFY(files.contains("runs/" + fileOf(item.key)));
            QVERIFY(isItemFile(fileOf(item.key)));
            QVERIFY(!isItemFile("../" + fileOf(item.key)) && !isItemFile(item.key + ".h5"));
        }
        study.solve = [](std::size_t, ItemCall& call) -> std::optional<ItemRow> {
            call.problem = "runs: no space left";
            return {};
        };
        const StudyReport full = performItems(study, {.files = "runs"}, {});
        QCOMPARE(full.status, StudyStatus::Failed);
        QCOMPARE(full.message, std::string("runs: no space left"));
    }

    /// A row that names its file counts only where the file is.
    void aFileThatIsGone()
    {
        const QTemporaryDir folder;
        Squares squares(2);
        ItemStudy study = squares.study();
        study.keepsFiles = true;
        study.width = 2;
        study.solve = [&, solve = study.solve](std::size_t i, ItemCall& call) {
            auto row = solve(i, call);
            row->emplace_back(i == 0 ? (call.file.parent_path().filename() / call.file.filename()).string() : "");
            return row;
        };
        const ItemOptions options{.files = folder.path().toStdString()};
        KeptRows kept = rowsOf(performItems(study, options, {}));
        ItemOptions again = options;
        again.kept = &kept;
        performItems(study, again, {});
        QCOMPARE(squares.solved[0].load(), 2); // its file was never there
        QCOMPARE(squares.solved[1].load(), 1); // it names none
        again.onlyKept = true;
        QCOMPARE(performItems(study, again, {}).status, StudyStatus::Completed);
    }
    /// Items of the same content are solved once, and their row is kept once, on any number of threads.
    void itemsThatAreAlike()
    {
        for (const int jobs : {1, 4}) {
            Squares squares(60);
            ItemStudy study = squares.study();
            study.content = [](std::size_t i) { return std::to_string(i % 7); };
            std::atomic<int> solved = 0, kept = 0;
            study.solve = [&](std::size_t i, ItemCall&) -> std::optional<ItemRow> {
                ++solved;
                return ItemRow{double(i % 7)};
            };
            const StudyReport report = performItems(study,
                                                    {.jobs = jobs,
                                                     .keep =
                                                         [&](const std::string&, const ItemRow&) {
                                                             ++kept;
                                                             return std::string();
                                                         }},
                                                    {});
            QCOMPARE(report.status, StudyStatus::Completed);
            QCOMPARE(solved.load(), 7);
            QCOMPARE(kept.load(), 7);
            QCOMPARE(report.tables[0].rows.size(), std::size_t(60));
            for (std::size_t i = 0; i < 60; ++i) QCOMPARE(std::get<double>(report.tables[0].rows[i][0]), double(i % 7));
        }
    }
    /// A study that is stopped while its report is prepared keeps the rows that it had; what is made for it ends.
    void stoppedWhileItPrepares()
    {
        Squares squares(10);
        ItemStudy study = squares.study();
        int ends = 0;
        study.end = [&] { ++ends; };
        KeptRows kept = rowsOf(performItems(study, {.part = {1, 2}}, {}));
        study.prepare = [](const GoOn&) { return false; };
        const StudyReport report = performItems(study, {.kept = &kept}, {});
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QCOMPARE(report.items.size(), std::size_t(5));
        QCOMPARE(report.message, std::string("stopped after 5 of 10 items"));
        QCOMPARE(ends, 2);
    }
    void rowsWithoutUse()
    {
        Squares squares(4);
        const KeptRows others = rowsOf(performItems(squares.study(2.0), {}, {}));
        QCOMPARE(performItems(squares.study(), {.kept = &others}, {}).items.size(), std::size_t(8));
        QCOMPARE(performItems(squares.study(), {.kept = &others, .addsUnused = false}, {}).items.size(),
                 std::size_t(4));
    }

    void keysDiffer()
    {
        std::set<std::string> keys;
        for (int i = 0; i < 100000; ++i) keys.insert(itemKey("case " + std::to_string(i)));
        QCOMPARE(keys.size(), std::size_t(100000));
        QCOMPARE(keys.begin()->size(), std::size_t(32));
    }
};

TOUCHDOWN_TEST(TestItemStudy)

} // namespace test_item_study

#include "test_item_study.moc"
