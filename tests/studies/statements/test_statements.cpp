// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statements.h"

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/csv_cell.h"
#include "core/formats/toml_document.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study_plan.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_statements {

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

StudyReport performed(const std::string& statements, const std::string& caseName = "fig12a", int jobs = 2)
{
    const Case c = sample(caseName);
    const StudyPlan plan = parseStudy("statements", statements, "study.toml", {}, &c);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(jobs, {});
}

std::string cell(const StudyReport& report, std::size_t row, const std::string& column)
{
    const StudyTable& table = report.tables.front();
    const auto found = std::ranges::find(table.columns, column, &StudyColumn::name);
    return std::get<std::string>(table.rows.at(row).at(std::size_t(found - table.columns.begin())));
}

/// A statement with what is checked.
std::string stating(const std::string& what)
{
    return "[[statement]]\nfigure = \"1\"\nquote = \"As it says.\"\n" + what + "\n";
}

/// What is found in milliseconds.
const std::string ofSprings =
    R"(only=["Fig. 10", "Fig. 11", "Fig. 12", "Fig. 13", "Fig. 14", "Table III", "Section 4", "Section 5, springs"])";

QByteArray helpTable(const std::string& study)
{
    return contents(QString::fromStdString(TOUCHDOWN_SOURCE_DIR "/resources/help/" + study + ".csv"));
}

/// Cells of each row of a table in the help by their columns.
std::vector<std::map<std::string, std::string>> rowsOf(const std::string& study)
{
    const std::vector<std::vector<std::string>> cells = csvRows(helpTable(study).toStdString());
    std::vector<std::map<std::string, std::string>> rows(cells.size() - 1);
    for (std::size_t i = 1; i < cells.size(); ++i)
        for (std::size_t k = 0; k < cells[i].size(); ++k) rows[i - 1][cells[0][k]] = cells[i][k];
    return rows;
}

/// The case of "touchdown run CASE --set ...".
std::string caseOf(const std::map<std::string, std::string>& row)
{
    const std::string command = row.find("command")->second.substr(std::string("touchdown run ").size());
    return command.substr(0, command.find(' '));
}

class TestStatements : public QObject {
    Q_OBJECT

private slots:
    /// The help shows what this study finds; what takes milliseconds is found again here, word for word.
    void helpAgreesWithTheProgram()
    {
        const QByteArray kept = helpTable("paper");
        const StudyPlan plan = openStudy("statements", "paper", {}, {ofSprings});
        QVERIFY2(plan.valid(), plan.problems.empty() ? "" : plan.problems.front().text().c_str());
        const StudyReport report = plan.perform(2, {});
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(report.tables.front().rows.size() >= 52);
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("springs.csv"));
        QCOMPARE(writeStudyCsv(file.toStdString(), report), std::string());
        for (const QByteArray& line : contents(file).split('\n')) QVERIFY2(kept.contains(line), line.constData());
    }

    /// A check is worth what it refuses: with a case that contradicts it no statement of the springs holds.
    void eachCheckRefusesWhatContradictsIt()
    {
        const StudyPlan plan = openStudy("statements", "paper", {}, {ofSprings, "contradict=true"});
        QVERIFY2(plan.valid(), plan.problems.empty() ? "" : plan.problems.front().text().c_str());
        const StudyReport report = plan.perform(2, {});
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(report.tables.front().rows.size() >= 52);
        for (std::size_t i = 0; i < report.tables.front().rows.size(); ++i)
            QVERIFY2(cell(report, i, "holds") == "no", cell(report, i, "statement").c_str());
    }

    /// Of the film, too, each statement has a case that contradicts it; it takes ten minutes to run them all.
    void eachCheckHasACaseThatContradictsIt()
    {
        const StudyPlan plan = openStudy("statements", "paper", {}, {"contradict=true"});
        QVERIFY2(plan.valid(), plan.problems.empty() ? "" : plan.problems.front().text().c_str());
    }

    /// And no statement of the studies is missing in the help or says something else there.
    void everyStatementIsInTheHelp()
    {
        int statements = 0;
        for (const char* study : {"paper", "film_fig5_to_8"}) {
            const QByteArray kept = helpTable(study);
            for (const TomlEntry& entry : readToml(findSampleStudy("statements", study)->text).entries) {
                if (!entry.key.ends_with(".quote") && !entry.key.ends_with(".remark") && !entry.key.ends_with(".name"))
                    continue;
                statements += entry.key.ends_with(".quote");
                const std::string text = csvCell(std::get<std::string>(entry.value));
                QVERIFY2(kept.contains(text.c_str()), text.c_str());
            }
        }
        QVERIFY(statements >= 99);
    }

    /// The card of a case of Figs. 5 to 8 ends as its row of the help shows, and tells how many of the random starts on
    /// all grids do as the paper says.
    void cardsAgreeWithTheHelp()
    {
        std::map<std::string, std::array<int, 2>> shares; // of a case: starts that do, all
        for (const auto& row : rowsOf("film_fig5_to_8")) {
            const auto starts = row.find("starts")->second;
            auto& share = shares[caseOf(row)];
            share[0] += std::stoi(starts);
            share[1] += std::stoi(starts.substr(starts.find(" of ") + 4));
        }
        QCOMPARE(shares.size(), std::size_t(9));
        // One and the same run has a case in each figure.
        for (const char* sameAsDefault : {"fig05_fm_3_62mN", "fig06_de_4nm", "fig07_mu_0_3"})
            shares[sameAsDefault] = shares.at("fig08_start_10nm");
        const std::regex end("(?:flies at|ends in contact at|bounces about) ([0-9.]+ nm).*");
        std::set<std::string> cards;
        for (const auto& row : rowsOf("paper")) {
            std::smatch found;
            const auto share = shares.find(caseOf(row));
            const std::string& text = row.find("found")->second;
            if (share == shares.end() || row.find("command")->second.find("--set") != std::string::npos ||
                !std::regex_match(text, found, end))
                continue;
            cards.insert(share->first);
            const QString card = QString::fromStdString(sample(share->first).about.watch).simplified();
            const std::string counted =
                std::to_string(share->second[0]) + " of " + std::to_string(share->second[1]) + " random starts";
            for (const std::string& part : {found[1].str(), counted})
                QVERIFY2(card.contains(QString::fromStdString(part)), (share->first + ": " + part).c_str());
        }
        QCOMPARE(cards.size(), shares.size());
    }

    /// A number that is not what the text says is told as such, with what was found.
    void tellsWhatDoesNotHold()
    {
        const StudyReport report =
            performed(stating("quantity = \"flying_height\"\nat_least = \"1.65 nm\"\nremark = \"Another one.\"") +
                      stating("end = [\"flying\", \"in and out of contact\"]") +
                      stating("quantity = \"flying_height\"\nat_least = \"1.55 nm\"\nat_most = \"1.65 nm\""));
        QCOMPARE(report.findings.front(), std::string("1 of 3 statements hold."));
        QCOMPARE(report.findings.at(1), std::string("1 does not hold: \"As it says.\" Expected: at least 1.65 nm; "
                                                    "found: 1.602 nm."));
        QCOMPARE(cell(report, 0, "holds"), std::string("no"));
        QCOMPARE(cell(report, 0, "remark"), std::string("Another one."));
        QCOMPARE(cell(report, 1, "found"), std::string("ends in contact at 1.6 nm"));
        QCOMPARE(cell(report, 2, "holds"), std::string("yes"));
        QVERIFY(report.charts.empty());
    }

    /// The oscillator's exact solution: FH(t) = 150 nm + 100 nm exp(-xi w t) (cos w_d t + ...), as its file says.
    void takesQuantitiesWhereAsked()
    {
        const auto at = [](const char* place, const char* rest) {
            return stating("quantity = \"flying_height\"\nat = \"" + std::string(place) + "\"\n" + rest);
        };
        const StudyReport report = performed(
            at("greatest", "at_least = \"249.9999 nm\"\nat_most = \"250.0001 nm\"") + // it is released there
                                                                                      // after half a period: 150 - 100
                                                                                      // exp(-pi xi / sqrt(1 - xi^2))
                at("least", "at_least = \"56.08 nm\"\nat_most = \"56.1 nm\"") +
                at("peak", "at_least = \"9.96 kHz\"\nat_most = \"10.16 kHz\"") +
                // over the last tenth the root of the mean of 100^2 exp(-2 xi w t)/2 is 6.43 nm
                at("rms", "at_least = \"6.3 nm\"\nat_most = \"6.55 nm\"") +
                // from 1.8 to 2 ms it turns after 37 and 38 half periods: 100 (exp(-37 a) + exp(-38 a)) = 18.956 nm
                at("swing", "at_least = \"18.955 nm\"\nat_most = \"18.957 nm\"") +
                // w^2 int x dt = -[x' + 2 xi w x] from 0 to 2 ms, by the equation of motion: the mean of x is 0.075 nm
                at("mean", "at_least = \"150.07 nm\"\nat_most = \"150.08 nm\"") +
                at("distance", "like = \"textbook_oscillator\"\nlike_set = { initial.flying_height = \"240 "
                               "nm\" }\nat_least = \"9.999 nm\"\nat_most = \"10.001 nm\"") +
                at("difference", "like = \"textbook_oscillator\"\nlike_set = { springs.flying_height = "
                                 "\"140 nm\", initial.flying_height = \"240 nm\" }\nat_least = \"9.99 "
                                 "nm\"\nat_most = \"10.01 nm\""),
            "textbook_oscillator");
        QCOMPARE(report.findings.front(), std::string("8 of 8 statements hold."));
    }

    /// A run is no distance away from itself, whatever the samples; a difference of swings, too.
    void samplesDoNotMatter()
    {
        const std::string like = "like = \"fig14a\"\nlike_set = { run.sample_interval = \"0.37 us\" }\n";
        const StudyReport report = performed(
            stating("quantity = \"flying_height\"\nat = \"distance\"\n" + like + "at_most = \"1e-6 nm\"") +
                stating("quantity = \"rear_spacing\"\nat = \"least\"\nset = { run.sample_interval = \"10 us\" }\n"
                        "at_least = \"1.5 nm\"") +
                stating("quantity = \"flying_height\"\nat = \"swing\"\n" + like +
                        "at_least = \"-1e-6 nm\"\nat_most = \"1e-6 nm\""),
            "fig14a");
        QCOMPARE(cell(report, 0, "found"), std::string("0 nm"));
        QCOMPARE(cell(report, 2, "holds"), std::string("yes"));
        const StudyReport fine =
            performed(stating("quantity = \"rear_spacing\"\nat = \"least\"\nat_least = \"1.5 nm\""), "fig14a");
        QCOMPARE(cell(report, 1, "found"), cell(fine, 0, "found"));
    }

    /// The oscillator has one peak, at 10.06 kHz. With four times the stiffness it lies an octave higher: both spectra
    /// are a Lorentzian's wing of the other.
    void spectra()
    {
        const auto peaks = [](const char* from, const char* to) {
            return stating("quantity = \"flying_height\"\nat = \"peaks\"\nfrom = \"" + std::string(from) +
                           "\"\nto = \"" + to + "\"\nat_least = 1");
        };
        const auto like = [](const char* stiffness) {
            return stating(
                "quantity = \"flying_height\"\nat = \"likeness\"\nlike = \"textbook_oscillator\"\nlike_set = { "
                "suspension.stiffness = \"" +
                std::string(stiffness) + " N/m\" }\nat_least = 0.999");
        };
        const StudyReport report = performed(
            peaks("9 kHz", "11 kHz") + peaks("15 kHz", "30 kHz") + like("4000") + like("16000"), "textbook_oscillator");
        QCOMPARE(cell(report, 0, "found"), std::string("1"));
        QCOMPARE(cell(report, 1, "found"), std::string("0"));
        QCOMPARE(cell(report, 2, "found"), std::string("1"));
        QVERIFY(std::stod(cell(report, 3, "found")) < 0.5);
    }

    void howTheMotionEnds()
    {
        const StudyReport report = performed(
            stating("motion = [\"settles\"]") + stating("end = [\"contact\"]\nmotion = [\"settles\"]") +
                stating("motion = [\"at rest\"]\nset = { run.duration = \"8 ms\" }") +
                stating("like = \"fig10a\"\nlike_end = \"same\"") + stating("like = \"fig12a\"\nlike_end = \"same\"") +
                stating("like = \"fig12a\"\nlike_end = \"other\"") +
                stating("quantity = \"slider.mass\"\nat = \"case\"\nat_most = \"1.7 mg\""),
            "fig14a");
        std::string holds;
        for (std::size_t i = 0; i < 7; ++i) holds += cell(report, i, "holds") + ' ';
        QCOMPARE(holds, std::string("yes no yes yes no yes yes "));
    }

    /// All starts near 250 nm end in contact with 50 mN, and fly with 10.7 mN. Intervals: Wilson 1927.
    void sharesOfStarts()
    {
        const std::string ensembles =
            "starts = 10\n" + stating("end = [\"contact\"]\nspread = \"0.5 nm\"") +
            stating("end = [\"flying\"]\nspread = \"0.5 nm\"") +
            stating("set = { ono_yamane.meniscus_force = \"10.7 mN\" }\nend = [\"flying\"]\nspread = \"0.5 nm\"");
        const StudyReport report = performed(ensembles);
        QCOMPARE(cell(report, 0, "starts"), std::string("10 of 10 starts (72 % to 100 %)"));
        QCOMPARE(cell(report, 1, "starts"), std::string("0 of 10 starts (0 % to 28 %)"));
        QCOMPARE(cell(report, 1, "holds"), std::string("no"));
        QCOMPARE(cell(report, 2, "holds"), std::string("yes"));
        QCOMPARE(report.charts.front().panels.front().series.front().points.size(), std::size_t{3});
        const StudyReport alone = performed(ensembles, "fig12a", 1);
        QCOMPARE(alone.tables.front().rows, report.tables.front().rows);
        // Without ensembles the run itself decides.
        QCOMPARE(cell(performed("starts = 1\n" + stating("end = [\"contact\"]\nspread = \"0.5 nm\"")), 0, "starts"),
                 std::string());
    }

    void candidates()
    {
        const StudyReport report = performed(
            "[[candidate]]\nname = \"weak\"\nset = { ono_yamane.meniscus_force = \"10.7 mN\" }\n"
            "[[candidate]]\nname = \"strong\"\nset = { ono_yamane.meniscus_force = \"50 mN\" }\n" +
            stating("end = [\"contact\"]") + stating("set = { ono_yamane.take_off = \"8 nm\" }\nend = [\"contact\"]"));
        QCOMPARE(report.tables.front().rows.size(), std::size_t{4});
        QCOMPARE(cell(report, 0, "command"), std::string("touchdown run CASE --set \"ono_yamane.meniscus_force=10.7 "
                                                         "mN\""));
        QCOMPARE(report.tables.at(1).rows.at(0), (std::vector<StudyValue>{std::string("weak"), 1.0, 2.0, 1.0}));
        QCOMPARE(report.tables.at(1).rows.at(1), (std::vector<StudyValue>{std::string("strong"), 2.0, 2.0, 1.0}));
    }

    void wrongInputs_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("problem");
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QString::fromStdString(text) << QString::fromUtf8(problem);
        };
        row("none", "", "write one [[statement]] or more");
        row("nothing to check", stating(""), "nothing would be checked");
        row("both", stating("end = [\"flying\"]\nquantity = \"pitch\"\nat_most = 1"), "one of the two");
        row("end", stating("end = [\"flyng\"]"), "did you mean flying?");
        row("quantity", stating("quantity = \"pich\"\nat_most = 1"), "pitch");
        row("no bound", stating("quantity = \"pitch\""), "neither at_least nor at_most");
        row("bounds", stating("quantity = \"pitch\"\nat_least = \"2 urad\"\nat_most = \"1 urad\""),
            "above its at_most");
        row("unit", stating("quantity = \"pitch\"\nat_most = \"1 nm\""), "urad");
        row("no like", stating("quantity = \"pitch\"\nat = \"distance\"\nat_most = 1"), "has no like");
        row("like", stating("quantity = \"pitch\"\nat = \"least\"\nlike = \"fig10a\"\nat_most = 1"), "does not need");
        row("like of an end", stating("end = [\"flying\"]\nlike = \"fig10a\""), "does not need");
        row("like_end alone", stating("like_end = \"same\""), "has no like");
        row("like_end", stating("like_end = \"equal\"\nlike = \"fig10a\""), "same");
        row("motion", stating("motion = [\"boounces\"]"), "did you mean bounces?");
        row("a bound of an end", stating("end = [\"flying\"]\nat_most = \"1 nm\""), "belongs to a quantity");
        row("a place of an end", stating("end = [\"flying\"]\nat = \"least\""), "belongs to a quantity");
        row("durations",
            stating("quantity = \"pitch\"\nat = \"distance\"\nat_most = 1\nlike = \"fig12a\"\nlike_set "
                    "= { run.duration = \"1 ms\" }"),
            "must last as long");
        row("band", stating("quantity = \"pitch\"\nfrom = \"1 kHz\"\nat_most = 1"), "belongs to");
        row("likeness alone", stating("quantity = \"pitch\"\nat = \"likeness\"\nat_least = 0.5"), "has no like");
        row("no spread", stating("end = [\"flying\"]\nspread = \"0 nm\""), "must be greater than 0");
        row("starts that run refuses", stating("end = [\"flying\"]\nspread = \"400 nm\""), "springs.cutoff");
        row("nothing contradicts", "contradict = true\n" + stating("end = [\"flying\"]"), "has no against");
        row("against", stating("end = [\"flying\"]\nagainst = { run.duration = \"1 nm\" }"), "run.duration");
        row("a case that changes and is not there",
            stating("quantity = \"pitch\"\nlike = \"fig99\"\nlike_set = { run.duration = \"1 ms\" }\nat_most = 1"),
            "fig99");
        row("a number without a unit, as a text", stating("quantity = \"pitch\"\nat = \"peaks\"\nat_least = \"some\""),
            "at_least");
        row("case", stating("case = \"fig99\"\nend = [\"flying\"]"), "fig99");
        row("set", stating("set = { run.duration = \"1 nm\" }\nend = [\"flying\"]"), "run.duration");
        row("spread", stating("end = [\"flying\"]\nspread = \"2 m\""), "initial.flying_height");
        row("only", "only = [\"2\"]\n" + stating("end = [\"flying\"]"), "leaves no statement");
        row("peak", stating("quantity = \"pitch\"\nat = \"peak\"\nat_most = \"1 kHz\""), "has no peaks");
        row("unknown", stating("end = [\"flying\"]\nwhen = 1"), "when");
    }
    void wrongInputs()
    {
        QFETCH(QString, text);
        QFETCH(QString, problem);
        const Case c = sample("fig12a");
        const StudyPlan plan = parseStudy("statements", text.toStdString(), "study.toml", {}, &c);
        QVERIFY(!plan.valid());
        QString all;
        for (const InputProblem& each : plan.problems) all += QString::fromStdString(each.text()) + QLatin1Char('\n');
        QVERIFY2(all.contains(problem), qPrintable(all));
        QVERIFY2(plan.problems.size() <= (problem == QStringLiteral("fig99") ? 1 : 2), qPrintable(all));
    }

    void endsWhenAsked()
    {
        const Case c = sample("fig12a");
        const StudyPlan plan = parseStudy(
            "statements", stating("set = { run.integrator = \"rk4\", run.step = \"0.02 ns\" }\nend = [\"contact\"]"),
            "study", {}, &c);
        const StudyReport report = plan.perform(1, [](const StudyProgress&) { return false; });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QVERIFY(report.tables.front().rows.empty());
    }
};

TOUCHDOWN_TEST(TestStatements)

} // namespace test_statements

#include "test_statements.moc"
