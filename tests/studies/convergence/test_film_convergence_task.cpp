// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/film_convergence_task.h"

#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_convergence_task {

std::string said(const std::string& text)
{
    const StudyPlan plan = parseStudy("convergence", text, "a.toml", {});
    return plan.valid() ? std::string() : plan.problems.front().text();
}

class TestFilmConvergenceTask : public QObject {
    Q_OBJECT

private slots:
    void defaults()
    {
        const StudyForm form = filmConvergenceForm(openCase("film_plane").value);
        QCOMPARE(form.keys.at(0).key, std::string("fixed_attitude"));
        QCOMPARE(form.keys.at(0).standard, StudyDefault(true)); // as the case has it
        QCOMPARE(filmConvergenceForm(openCase("film_femto").value).keys.at(0).standard, StudyDefault(false));
        QCOMPARE(said("case = \"film_femto\""), std::string());
    }
    /// Own, power law and established manner, on two grids.
    void performs()
    {
        const StudyPlan plan =
            openStudy("convergence", "film_femto", {}, {"grids=33,49", "reference=65", "fixed_attitude=true"});
        QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
        const StudyReport report = plan.perform(2, {});
        QCOMPARE(report.status, StudyStatus::Completed);
        const StudyTable& runs = report.tables.at(0);
        QCOMPARE(runs.rows.size(), std::size_t{3 * 2});
        QCOMPARE(runs.rows.at(0).at(1), StudyValue(std::string("complete-flux, adapted")));
        QCOMPARE(runs.rows.at(2).at(1), StudyValue(std::string("power-law, uniform")));
        QCOMPARE(runs.rows.at(4).at(1), StudyValue(std::string("established manner")));
        for (const auto& row : runs.rows) QVERIFY(std::get<double>(row.at(7)) > 0.0);
    }
    /// In flight, with a method of its own instead.
    void ownMethods()
    {
        const StudyPlan plan =
            parseStudy("convergence",
                       "case = \"film_femto\"\ngrids = [33]\nreference = 49\nestablished = false\n[[method]]\nname = "
                       "\"upwind\"\nset = { \"film.scheme\" = \"upwind\" }\n",
                       "a.toml", {});
        QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
        const StudyReport report = plan.perform(1, {});
        QCOMPARE(report.tables.at(0).rows.size(), std::size_t{2});
        QCOMPARE(report.tables.at(0).rows.at(1).at(1), StudyValue(std::string("upwind")));
    }
    /// Beside the study's file, with the changes of the study and of the command line.
    void furtherSliders()
    {
        const QTemporaryDir folder;
        const std::string place = folder.path().toStdString();
        QCOMPARE(writeCaseFile(place + "/mine.toml", openCase("film_femto").text), std::string());
        QCOMPARE(writeCaseFile(place + "/a.toml", "case = \"mine.toml\"\ncases = [\"film_pico\", \"mine.toml\"]\n"
                                                  "set = { \"title\" = \"Changed\" }\ngrids = [33]\nreference = 49\n"
                                                  "fixed_attitude = true\nestablished = false\n"),
                 std::string());
        const StudyPlan plan = openStudy("convergence", place + "/a.toml", {"disk.skew=0"});
        QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
        const StudyTable references = plan.perform(2, {}).tables.at(2);
        QCOMPARE(references.rows.size(), std::size_t{3});
        for (const auto& row : references.rows) QCOMPARE(row.at(0), StudyValue(std::string("Changed")));
        QCOMPARE(references.rows.at(0).at(2), references.rows.at(2).at(2));
        QVERIFY(references.rows.at(0).at(2) != references.rows.at(1).at(2));
    }
    void refuses_data()
    {
        QTest::addColumn<QString>("keys");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* keys, const char* says) {
            QTest::newRow(name) << keys << says;
        };
        row("a grid that is none", "grids = [50]", "grids: must be 16 k + 1 lines");
        row("half a line", "grids = [49.5]", "grids: must be 16 k + 1 lines");
        row("too few lines", "grids = [17]", "grids: must be");
        row("no numbers", "grids = [\"many\"]", "grids: ");
        row("a reference that is none", "reference = 500", "reference: must be 16 k + 1 lines");
        row("a coarse reference", "reference = 97", "reference: must have more lines");
        row("levels", "levels = 3", "levels: ");
        row("no case", "cases = [\"no_such\"]", "cases: no_such: ");
        row("springs", "cases = [\"fig10a\"]", "cases: \"fig10a\" is no case of model \"film\"");
        row("a method without a name", "[[method]]\nset = { \"film.scheme\" = \"upwind\" }", "has no name");
        row("a wrong method", "[[method]]\nname = \"a\"\nset = { \"film.scheme\" = \"up\" }", "film.scheme");
        row("a name twice", "[[method]]\nname = \"complete-flux, adapted\"", "is the name of another method");
        row("the grid as a method", "[[method]]\nname = \"a\"\nset = { \"film.nodes\" = [49, 49] }", "take grids");
    }
    void refuses()
    {
        QFETCH(QString, keys);
        QFETCH(QString, says);
        const std::string message = said("case = \"film_femto\"\n" + keys.toStdString() + "\n");
        QVERIFY2(QString::fromStdString(message).contains(says), message.c_str());
    }
};

TOUCHDOWN_TEST(TestFilmConvergenceTask)

} // namespace test_film_convergence_task

#include "test_film_convergence_task.moc"
