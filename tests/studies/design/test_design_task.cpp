// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design_task.h"

#include <random>

#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/studies/design/design_study.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study/study_reader.h"
#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_design_task {

const std::string good = R"(title = "A study"
case = "film_pico"

[[parameter]]
key = "abs.rail[4].width"
minimum = "0.1 mm"
maximum = "0.3 mm"

[[parameter]]
keys = ["abs.rail[1].recess", "abs.rail[3].recess"]
start = "0.25 um"
minimum = "0.1 um"
maximum = 3e-7

[[target]]
quantity = "minimum_spacing"
value = "8 nm"
tolerance = "0.1 nm"

[[target]]
quantity = "pitch"
value = "150 urad"
tolerance = "1 urad"

[search]
iterations = 12
difference = 0.02
)";

StudyPlan plan(const std::string& text, const std::vector<std::string>& settings = {})
{
    return parseStudy("design", text, "a.toml", ".", nullptr, settings);
}

/// The task of a study without problems.
DesignTask taskOf(const std::string& text, const Case& start)
{
    const TomlDocument toml = readToml(text);
    std::vector<InputProblem> problems;
    StudyReader reader(toml, "a.toml", start, problems);
    reader.setKeys(designForm(start).keys);
    DesignTask task = readDesignTask(reader);
    if (!problems.empty()) qFatal("%s", problems.front().text().c_str());
    return task;
}

QString said(const StudyPlan& plan)
{
    QString all;
    for (const InputProblem& problem : plan.problems) all += QString::fromStdString(problem.text()) + '\n';
    return all;
}

std::string with(const std::string& old, const std::string& now)
{
    std::string text = good;
    const auto at = text.find(old);
    if (at == std::string::npos) qFatal("%s", old.c_str());
    return text.replace(at, old.size(), now);
}

class TestDesignTask : public QObject {
    Q_OBJECT

private slots:
    void reads()
    {
        const StudyPlan whole = plan(good);
        QVERIFY2(whole.valid(), qPrintable(said(whole)));
        QCOMPARE(whole.title, std::string("A study"));
        const DesignTask task = taskOf(good, whole.start.value);
        QCOMPARE(task.parameters.size(), std::size_t{2});
        QCOMPARE(task.parameters[0].keys[0].key, std::string("abs.rail[4].width"));
        QVERIFY(std::abs(task.parameters[0].start - 0.2e-3) < 1e-12); // of the case
        QCOMPARE(task.parameters[1].keys.size(), std::size_t{2});
        QCOMPARE(task.parameters[1].start, 0.25e-6);
        QCOMPARE(task.parameters[1].maximum, 0.3e-6);
        QCOMPARE(task.targets.size(), std::size_t{2});
        QCOMPARE(task.targets[0].value, 8e-9);
        QCOMPARE(task.targets[1].quantity.unit, std::string("rad"));
        QCOMPARE(task.targets[1].tolerance, 1e-6);
        QCOMPARE(task.maximumIterations, 12);
        QCOMPARE(task.difference, 0.02);
    }
    /// Without tables the preload is searched; where the attitude is held, the height.
    void defaults()
    {
        const Case flying = openCase("film_pico").value, held = openCase("film_plane").value;
        const DesignTask preload = taskOf("", flying);
        QCOMPARE(preload.parameters.at(0).keys.at(0).key, std::string("suspension.preload"));
        QCOMPARE(preload.targets.at(0).quantity.name, std::string("minimum_spacing"));
        QCOMPARE(preload.maximumIterations, DesignTask{}.maximumIterations);
        const DesignTask height = taskOf("", held);
        QCOMPARE(height.parameters.at(0).keys.at(0).key, std::string("initial.nominal_trailing_edge_height"));
        QCOMPARE(height.targets.at(0).quantity.name, std::string("net_force"));
    }
    /// The template says the same, in short numbers of the window's unit, whatever the preload is.
    void templateHasShortNumbers()
    {
        std::mt19937 draw(5);
        for (int i = 0; i < 200; ++i) {
            Case c = openCase(i % 2 == 0 ? "film_pico" : "film_plane").value;
            c.suspension.preload = 9.80665e-3 * std::uniform_real_distribution(0.3, 9.0)(draw);
            c.initial.nominalTrailingEdgeHeight = std::uniform_real_distribution(2e-9, 90e-9)(draw);
            const DesignTask task = taskOf("", c), written = taskOf(templateText(designForm(c)), c);
            const DesignParameter &a = task.parameters.at(0), &b = written.parameters.at(0);
            const std::string& unit = a.keys.at(0).displayUnit;
            QCOMPARE(b.minimum, a.minimum);
            QCOMPARE(b.maximum, a.maximum);
            QCOMPARE(written.targets.at(0).tolerance, task.targets.at(0).tolerance);
            for (const double each : {a.minimum, a.maximum}) {
                const std::string text = formatQuantity(each, unit);
                QVERIFY2(text.ends_with(' ' + unit) && text.size() <= 6 + unit.size(), text.c_str());
            }
        }
    }
    void settings()
    {
        const StudyPlan d = plan(good, {"film.nodes=97, 97"});
        QVERIFY(d.valid());
        QCOMPARE(d.start.value.film.nodes[0], 97);
        QCOMPARE(plan(good, {"film.nodes=1, 1"}).problems.front().file, std::string("--set"));
    }
    /// The files beside the sample cases are studies that can be done.
    void samples_data()
    {
        QTest::addColumn<QString>("file");
        int count = 0;
        for (const SampleStudy& study : sampleStudies()) {
            if (study.kind != "design") continue;
            QTest::newRow(study.name.c_str())
                << QString(TOUCHDOWN_SOURCE_DIR "/sample_cases/studies/%1.toml").arg(study.name.c_str());
            ++count;
        }
        QVERIFY(count >= 2);
    }
    /// Their cases hold what they find: the state is as wanted, and a search from there ends at once.
    void samples()
    {
        QFETCH(QString, file);
        const StudyPlan whole = openStudy("design", file.toStdString());
        QVERIFY2(whole.valid(), qPrintable(said(whole)));
        const Case& c = whole.start.value;
        DesignTask task = taskOf(whole.text, c);
        for (DesignParameter& parameter : task.parameters) parameter.start = numberOf(parameter.keys.front(), c);
        const DesignStudy study = studyDesign(c, task);
        QVERIFY2(study.status == StudyStatus::Completed, study.message.c_str());
        QCOMPARE(study.solves, 1);
    }

    void problems_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QString::fromStdString(text) << says;
        };
        row("no TOML", "case = ", "a.toml:1: ");
        row("empty", "",
            "a.toml: case: is missing; the file of a case, or the name of a sample case, in quotation marks is needed");
        row("a case that is not there", with("\"film_pico\"", "\"film_pigo\""),
            "a.toml:2: case: \"film_pigo\" is neither a file nor a sample case; did you mean film_pico?");
        row("a case without a film", with("\"film_pico\"", "\"fig10a\""),
            "a.toml:2: case: a design study takes a case of model \"film\", whose static state it looks for");
        row("case is a number", with("\"film_pico\"", "7"),
            "a.toml:2: case: has the wrong type; the file of a case, or the name of a sample case, in quotation marks "
            "is needed");
        row("another kind", "kind = \"stability\"\n" + good, "a.toml:1: kind: is \"stability\", not \"design\"");
        row("a wrong setting of its own", "set = { \"film.node\" = 3 }\n" + good,
            "a.toml:1: set.film.node: unknown key; did you mean film.nodes?");
        row("an unknown key", with("start = ", "stat = "),
            "a.toml:11: parameter[2].stat: unknown key; did you mean start?");
        row("an unknown table", with("[search]", "[serch]"), "a.toml:25: serch: unknown table; did you mean search?");
        row("a root key", "file = 1\n" + good, "a.toml:1: file: unknown key");
        row("one parameter as a table", with("[[parameter]]\nkey", "[parameter]\nkey"), "a.toml:");
        row("no parameters", good.substr(0, good.find("[[parameter]]")) + good.substr(good.find("[[target]]")),
            "a.toml: parameter: is missing; write one [[parameter]] or more");
        row("no targets", good.substr(0, good.find("[[target]]")),
            "a.toml: target: is missing; write one [[target]] or more");
        row("a key that is none", with("abs.rail[4].width", "abs.base_reces"),
            "a.toml:5: parameter[1].key: \"abs.base_reces\" is no key of a case; did you mean abs.base_recess?");
        row("a rail that is not there", with("abs.rail[4].width", "abs.rail[9].width"),
            "a.toml:5: parameter[1].key: \"abs.rail[9].width\" there is no rail 9; the case has 4");
        row("no key", with("key = \"abs.rail[4].width\"\n", ""),
            "a.toml:4: parameter[1].key: is missing; a key of the case in quotation marks is needed");
        row("keys as text", with("[\"abs.rail[1].recess\", \"abs.rail[3].recess\"]", "\"abs.rail[1].recess\""),
            "a.toml:10: parameter[2].keys: has the wrong type; a list such as [");
        row("a key and keys", with("start = ", "key = \"abs.crown\"\nstart = "),
            "a.toml:11: parameter[2].key: is one key, and keys are several; write one of the two");
        row("keys of two kinds", with("\"abs.rail[3].recess\"", "\"suspension.preload\""),
            "a.toml:10: parameter[2].keys: \"suspension.preload\" has another unit than the first key");
        row("a key twice", with("\"abs.rail[3].recess\"", "\"abs.rail[4].width\""),
            "a.toml:10: parameter[2].keys: \"abs.rail[4].width\" is changed by more than one parameter");
        row("no minimum", with("minimum = \"0.1 mm\"\n", ""), "a.toml:4: parameter[1].minimum: is missing");
        row("another unit", with("\"0.1 mm\"", "\"0.1 N\""), "a.toml:6: parameter[1].minimum: ");
        row("bounds upside down", with("\"0.3 mm\"", "\"0.05 mm\""),
            "a.toml:7: parameter[1].maximum: must be greater than minimum (0.1 mm)");
        row("a start outside", with("\"0.25 um\"", "\"0.35 um\""),
            "a.toml:11: parameter[2].start: 0.35 um is not between minimum (0.1 um) and maximum (0.3 um)");
        row("the case outside", with("\"0.1 mm\"", "\"0.25 mm\""),
            "a.toml:4: parameter[1].start: 0.2 mm is not between minimum (0.25 mm) and maximum (0.3 mm)");
        row("a bound that the key refuses", with("\"0.1 mm\"", "\"-0.1 mm\""),
            "a.toml:6: parameter[1].minimum: abs.rail[4].width: -0.1 mm is out of range: allowed is greater than 0 mm");
        row("an unknown quantity", with("\"pitch\"", "\"pich\""),
            "a.toml:21: target[2].quantity: \"pich\" is no quantity of a static state; did you mean pitch?");
        row("an error of the grid", with("\"pitch\"", "\"pitch_error\""), "is no quantity of a static state");
        row("no tolerance", with("tolerance = \"1 urad\"\n", ""), "a.toml:20: target[2].tolerance: is missing");
        row("no tolerance at all", with("\"1 urad\"", "0"), "a.toml:23: target[2].tolerance: must be greater than 0");
        row("half an iteration", with("= 12", "= 0.5"),
            "a.toml:26: search.iterations: must be a whole number from 1 to 1000");
        row("a large difference", with("0.02", "0.6"), "a.toml:27: search.difference: must be from 1e-6 to 0.25");
    }
    void problems()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const StudyPlan d = plan(text.toStdString());
        QVERIFY(!d.valid());
        QVERIFY2(said(d).contains(says), qPrintable(said(d)));
    }
    /// The study and its case have the same name.
    void byName()
    {
        const StudyPlan d = openStudy("design", "film_fig4_pico");
        QVERIFY2(d.valid(), qPrintable(said(d)));
        QCOMPARE(d.start.name, std::string("film_fig4_pico"));
        QVERIFY(!d.text.empty());
    }
};

TOUCHDOWN_TEST(TestDesignTask)

} // namespace test_design_task

#include "test_design_task.moc"
