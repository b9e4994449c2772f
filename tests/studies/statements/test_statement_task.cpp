// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statement_task.h"

#include <QTest>

#include "core/studies/study_plan.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_statement_task {

class TestStatementTask : public QObject {
    Q_OBJECT

private slots:
    /// One mistake is one problem, with the line and the key of the mistake.
    void oneProblemForOneMistake_data()
    {
        QTest::addColumn<QString>("text"); // from line 4 on
        QTest::addColumn<QStringList>("places");
        const auto row = [](const char* name, const char* text, const QStringList& places) {
            QTest::newRow(name) << QString::fromUtf8(text) << places;
        };
        row("an empty list of ends", "end = []", {"4 statement[1].end"});
        row("a bound that is no length", "quantity = \"flying_height\"\nat_least = \"3 apples\"",
            {"5 statement[1].at_least"});
        row("no table of changes", "end = [\"flying\"]\nset = \"x\"", {"5 statement[1].set"});
        row("an unknown key among the changes", "end = [\"flying\"]\nset = { \"springs.cutof\" = \"1 nm\" }",
            {"5 statement[1].set.\"springs.cutof\""});
        row("a wrong value below a header", "end = [\"flying\"]\n[statement.set]\nrun.duration = \"1 nm\"",
            {"6 statement[1].set.run.duration"});
        row("a date among the changes", "end = [\"flying\"]\nset = { \"run.step\" = 2024-01-01 }",
            {"5 statement[1].set.\"run.step\""});
        row("changes of no second case", "end = [\"flying\"]\nlike_set = { \"run.step\" = \"1 ns\" }",
            {"5 statement[1].like_set"});
        row("changes of a second case that is missing",
            "quantity = \"pitch\"\nat = \"difference\"\nat_most = 1\nlike_set = { \"run.step\" = \"1 ns\" }",
            {"1 statement[1]"});
        row("a wrong value of the second case",
            "quantity = \"pitch\"\nat = \"distance\"\nat_most = 1\nlike = \"fig10a\"\n"
            "like_set = { \"run.step\" = \"1 nm\" }",
            {"8 statement[1].like_set.\"run.step\""});
        row("a mistake that every candidate meets",
            "end = []\n[[candidate]]\nname = \"a\"\n[[candidate]]\nname = \"b\"", {"4 statement[1].end"});
        row("a wrong value of a candidate",
            "end = [\"flying\"]\n[[candidate]]\nname = \"a\"\nset = { \"run.duration\" = \"1 nm\" }",
            {"7 candidate[1].set.\"run.duration\""});
    }
    void oneProblemForOneMistake()
    {
        QFETCH(QString, text);
        QFETCH(QStringList, places);
        const Case c = sample("fig12a");
        const std::string whole =
            "[[statement]]\nfigure = \"1\"\nquote = \"As it says.\"\n" + text.toStdString() + "\n";
        const StudyPlan plan = parseStudy("statements", whole, "study.toml", {}, &c);
        QStringList found;
        for (const InputProblem& each : plan.problems)
            found << QString::number(each.line) + QLatin1Char(' ') + QString::fromStdString(each.key);
        QCOMPARE(found, places);
    }
};

TOUCHDOWN_TEST(TestStatementTask)

} // namespace test_statement_task

#include "test_statement_task.moc"
