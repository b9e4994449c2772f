// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study_plan.h"

#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/studies/study/sample_study.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_plan {

const std::string kind = "hysteresis"; // of which the keys are few

QString said(const StudyPlan& plan)
{
    std::string all;
    for (const InputProblem& problem : plan.problems) all += problem.text() + '\n';
    return QString::fromStdString(all);
}

StudyPlan parse(const std::string& text, const Case* given = nullptr, const std::vector<std::string>& settings = {},
                const std::vector<std::string>& options = {})
{
    return parseStudy(kind, text, "a.toml", ".", given, settings, options);
}

class TestStudyPlan : public QObject {
    Q_OBJECT

private slots:
    /// What the program offers as a beginning is a study without a problem.
    void templates_data()
    {
        QTest::addColumn<QString>("study");
        QTest::addColumn<QString>("sample");
        for (const StudyKind& each : studyKinds())
            for (const char* sample : {"fig10a", "film_fig4_pico", "contact_hertz"})
                QTest::addRow("%s of %s", each.name.c_str(), sample) << QString::fromStdString(each.name) << sample;
    }
    void templates()
    {
        QFETCH(QString, study);
        QFETCH(QString, sample);
        const Case c = openCase(sample.toStdString()).value;
        const std::string text = studyTemplate(study.toStdString(), c);
        const StudyPlan plan = parseStudy(study.toStdString(), text, "a.toml", {}, &c);
        // Not every study can be made of every case; then that is all that is wrong.
        const bool only = plan.problems.size() == 1 && plan.problems.front().key == "case";
        QVERIFY2(plan.valid() || only, qPrintable(said(plan) + QString::fromStdString(text)));
        QCOMPARE(static_cast<bool>(plan.perform), plan.valid());
        for (const QString& line : QString::fromStdString(text).split('\n'))
            QVERIFY2(line.size() < 120, qPrintable(line));
        // What is only offered is right, too.
        QString offers = QString::fromStdString(text);
        offers.replace(QRegularExpression("^# (\\[\\w+\\]|\\w+ = )", QRegularExpression::MultilineOption), "\\1");
        const StudyPlan all = parseStudy(study.toStdString(), offers.toStdString(), "a.toml", {}, &c);
        QVERIFY2(all.valid() || only, qPrintable(said(all) + offers));
    }
    void samples_data()
    {
        QTest::addColumn<QString>("study");
        QTest::addColumn<QString>("name");
        for (const SampleStudy& each : sampleStudies())
            QTest::addRow("%s of %s", each.kind.c_str(), each.name.c_str())
                << QString::fromStdString(each.kind) << QString::fromStdString(each.name);
        QTest::addRow("a case") << QString::fromStdString(kind) << "fig10a";
    }
    void samples()
    {
        QFETCH(QString, study);
        QFETCH(QString, name);
        const StudyPlan plan = openStudy(study.toStdString(), name.toStdString());
        QVERIFY2(plan.valid(), qPrintable(said(plan)));
        QVERIFY(!plan.title.empty());
        QVERIFY(plan.perform);
    }

    void aStudysFile()
    {
        const StudyPlan plan =
            parse("title = \"Mine\"\ncase = \"fig10a\"\nset = { \"run.duration\" = \"1 ms\" }\nsteps = 5\n");
        QVERIFY2(plan.valid(), qPrintable(said(plan)));
        QCOMPARE(plan.title, std::string("Mine"));
        QCOMPARE(plan.kind, kind);
        QCOMPARE(plan.start.name, std::string("fig10a"));
        QCOMPARE(plan.start.value.run.duration, 1e-3);
        // The command line has the last word on the case.
        QCOMPARE(parse(plan.text, nullptr, {"run.duration=3 ms"}).start.value.run.duration, 3e-3);
    }
    /// The case stands beside the study, whatever the present folder is.
    void aCaseBesideTheStudy()
    {
        const QTemporaryDir folder;
        const std::string place = folder.path().toStdString();
        std::filesystem::create_directory(place + "/studies");
        QCOMPARE(writeCaseFile(place + "/my.toml", openCase("fig10a").text), std::string());
        QCOMPARE(writeCaseFile(place + "/studies/a.toml", "case = \"../my.toml\"\n"), std::string());
        const StudyPlan plan = openStudy(kind, place + "/studies/a.toml");
        QVERIFY2(plan.valid(), qPrintable(said(plan)));
        QCOMPARE(plan.start.name, place + "/studies/../my.toml");
        const StudyPlan ofCase = openStudy(kind, place + "/my.toml", {"run.duration=1 ms"});
        QVERIFY2(ofCase.valid(), qPrintable(said(ofCase)));
        QCOMPARE(ofCase.text, std::string());
        QCOMPARE(ofCase.start.value.run.duration, 1e-3);
    }
    /// Within the folder above that of the study cases may stand, other files not.
    void aCaseElsewhere()
    {
        const QTemporaryDir folder, other;
        const std::string place = folder.path().toStdString(), study = place + "/a/b/study.toml";
        std::filesystem::create_directories(place + "/a/b");
        const std::string text = openCase("fig10a").text;
        for (const std::string& file : {place + "/near.toml", place + "/a/near.toml", place + "/a/hidden.txt",
                                        other.path().toStdString() + "/far.toml"})
            QCOMPARE(writeCaseFile(file, text), std::string());
        const auto planOf = [&](const std::string& name, OutsidePaths outside) {
            [&] { QCOMPARE(writeCaseFile(study, "case = \"" + name + "\"\n"), std::string()); }();
            return openStudy(kind, study, {}, {}, outside);
        };
        QVERIFY(planOf("../near.toml", OutsidePaths::Refused).valid());
        for (const std::string& name :
             {std::string("../../near.toml"), std::string("../hidden.txt"), other.path().toStdString() + "/far.toml"}) {
            const StudyPlan refused = planOf(name, OutsidePaths::Refused);
            QCOMPARE(refused.problems.size(), std::size_t{1});
            QCOMPARE(refused.problems.front().key, std::string("case"));
            QCOMPARE(refused.problems.front().line, 1);
            QVERIFY(refused.problems.front().text().find("--allow-paths") != std::string::npos);
            QVERIFY(planOf(name, OutsidePaths::Allowed).valid());
        }
    }
    /// A study sets no path that leads out of the folder of its case.
    void aSurfaceElsewhere()
    {
        const QTemporaryDir folder;
        const std::string secret = folder.filePath("secret.txt").toStdString();
        QCOMPARE(writeCaseFile(secret, "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n"), std::string());
        const StudyPlan plan = parse("case = \"contact_hertz\"\n[set]\n\"disk.surface.file\" = \"" + secret + "\"\n");
        QVERIFY2(said(plan).contains("lies outside the folder of the case"), qPrintable(said(plan)));
        const StudyPlan asked = parse("case = \"contact_hertz\"\n", nullptr, {"disk.surface.file=" + secret});
        QVERIFY2(!said(asked).contains("outside"), qPrintable(said(asked)));
    }
    /// A contradiction that settings make stands at the setting: that of the key, or another one that takes part.
    void aContradictionOfSettingsHasTheirPlace()
    {
        const std::string head = "case = \"fig10a\"\n[set]\n";
        const StudyPlan own = parse(head + "\"run.sample_interval\" = \"1 s\"\n");
        QCOMPARE(own.problems.size(), std::size_t{1});
        QCOMPARE(own.problems.front().file, std::string("a.toml"));
        QCOMPARE(own.problems.front().line, 3);
        QCOMPARE(own.problems.front().key, std::string("set.run.sample_interval"));
        const StudyPlan duration = parse(head + "title = \"t\"\n\"run.duration\" = \"1 ns\"\n");
        QVERIFY(!duration.problems.empty());
        for (const InputProblem& problem : duration.problems) {
            QCOMPARE(problem.line, 4);
            QCOMPARE(problem.key, std::string("set.run.duration"));
        }
        QVERIFY2(said(duration).contains("run.sample_interval must be at most run.duration"),
                 qPrintable(said(duration)));
        const StudyPlan typed = parse("case = \"fig10a\"\n", nullptr, {"run.sample_interval=1 s"});
        QCOMPARE(typed.problems.front().file, std::string("--set"));
    }
    /// Nor does a method, unless the user allows it.
    void aMethodsSurfaceElsewhere()
    {
        const QTemporaryDir folder, other;
        const std::string study = folder.filePath("study.toml").toStdString(),
                          surface = other.filePath("track.txt").toStdString();
        QCOMPARE(writeCaseFile(surface, "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n"), std::string());
        QCOMPARE(writeCaseFile(study, "case = \"advise_waviness\"\n\n[[method]]\nname = \"measured\"\nset = { "
                                      "\"disk.surface.kind\" = \"file\", \"disk.surface.file\" = \"" +
                                          surface + "\" }\n"),
                 std::string());
        const StudyPlan refused = openStudy("work-precision", study);
        QCOMPARE(refused.problems.size(), std::size_t{1});
        QCOMPARE(refused.problems.front().line, 5);
        QVERIFY2(said(refused).contains("lies outside the folder of the case"), qPrintable(said(refused)));
        const StudyPlan allowed = openStudy("work-precision", study, {}, {}, OutsidePaths::Allowed);
        QVERIFY2(allowed.valid(), qPrintable(said(allowed)));
    }
    void aGivenCase()
    {
        Case c = openCase("fig10a").value;
        c.run.duration = 1.5e-3;
        const StudyPlan plan = parse("steps = 3\n", &c);
        QVERIFY2(plan.valid(), qPrintable(said(plan)));
        QCOMPARE(plan.start.value.run.duration, 1.5e-3);
        QCOMPARE(plan.title, c.title);
        QCOMPARE(parse("case = \"fig13a\"\n", &c).start.name, std::string("fig13a"));
        c.springs.cutoff = 1e-3; // above the slider
        QVERIFY2(said(parse("", &c)).startsWith("the case: springs.flying_height: "), qPrintable(said(parse("", &c))));
    }
    /// What a case says in vain is told all the same.
    void warnings()
    {
        const StudyPlan plan = parse("case = \"fig10a\"\n[set]\nfilm.coupling = \"staggered\"\n");
        QVERIFY2(plan.valid(), qPrintable(said(plan)));
        QCOMPARE(plan.start.unused.size(), std::size_t{1});
        QCOMPARE(plan.start.unused.front().text(),
                 std::string("a.toml:3: set.film.coupling: has no effect here, only with model = \"film\""));
    }
    void options()
    {
        QVERIFY(parse("case = \"fig10a\"\n", nullptr, {}, {"steps=3", " hold = 1 ms", "equilibria=false"}).valid());
        QVERIFY(parse("case = \"fig10a\"\nsteps = 0\n", nullptr, {}, {"steps=0", "steps=4"}).valid());
        QVERIFY(
            openStudy(kind, "fig10a", {}, {"steps=3", "parameter=springs.flying_height", "from=10 nm", "to = \"2 nm\""})
                .valid());
    }

    /// A key of a table is named with it, whether the file has the table or not.
    void optionsOfTables()
    {
        const std::string none = "case = \"fig10a\"\n", some = none + "[ensemble]\nstarts = 1\nspread = \"1 nm\"\n";
        for (const std::string& text : {none, some}) {
            const StudyPlan plan = parseStudy("work-precision", text, "a.toml", {}, nullptr, {}, {"ensemble.starts=3"});
            QVERIFY2(plan.valid(), qPrintable(said(plan)));
        }
        QVERIFY(said(parseStudy("work-precision", some, "a.toml", {})).contains("a.toml:3: ensemble.starts: must be "));
        QCOMPARE(said(parseStudy("work-precision", none + "ensemble = 3\n", "a.toml", {})),
                 QString("a.toml:2: ensemble: is a table, not a value; write [ensemble]\n"));
        const std::string list = none + "[[method]]\nname = \"a\"\n";
        for (const char* option : {"method=3", "method.name=b"})
            QVERIFY(said(parseStudy("work-precision", list, "a.toml", {}, nullptr, {}, {option}))
                        .contains("is of a list of tables; it stands in the study's file"));
    }
    /// What a study cannot do is told once.
    void onlyTheCase()
    {
        const StudyPlan plan = openStudy("stability", "contact_hertz");
        QCOMPARE(plan.problems.size(), std::size_t{1});
        QCOMPARE(plan.problems.front().key, std::string("case"));
    }
    void sources()
    {
        const auto sample = findStudySource("hysteresis_take_off");
        QVERIFY(sample);
        QCOMPARE(sample->kind, std::string("hysteresis"));
        QVERIFY(sample->kindLine > 0);
        QVERIFY(!findStudySource("fig10a"));
        QVERIFY(!findStudySource("film_fig4_pico")); // a case, too
        QVERIFY(!findStudySource("no_such"));
        const QTemporaryDir folder;
        const std::string file = folder.filePath("a.toml").toStdString();
        QCOMPARE(writeCaseFile(file, openCase("fig10a").text), std::string());
        QVERIFY(!findStudySource(file));
        QCOMPARE(writeCaseFile(file, "case = \"fig10a\"\n"), std::string());
        QCOMPARE(findStudySource(file)->kind, std::string());
    }

    void problems_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("no TOML") << "case = "
                                 << "a.toml:1: is not TOML";
        QTest::newRow("no case") << "steps = 3"
                                 << "a.toml: case: is missing; the file of a case, or the name of a sample case, in "
                                    "quotation marks is needed\n";
        QTest::newRow("no such case")
            << "case = \"fig10q\""
            << "a.toml:1: case: \"fig10q\" is neither a file nor a sample case; did you mean fig10a?\n";
        QTest::newRow("another kind") << "kind = \"stability\"\ncase = \"fig10a\""
                                      << "a.toml:1: kind: is \"stability\", not \"hysteresis\"\n";
        QTest::newRow("no kind at all") << "kind = 3\ncase = \"fig10a\""
                                        << "a.toml:1: kind: has the wrong type; text in quotation marks is needed\n";
        QTest::newRow("a kind in a table") << "kind = {}\ncase = \"fig10a\""
                                           << "a.toml:1: kind: is a table, not a value\n";
        QTest::newRow("a case in a table") << "[case]\nname = 1"
                                           << "a.toml:1: case: is a table, not a value\n";
        QTest::newRow("an unknown key") << "case = \"fig10a\"\nstep = 3"
                                        << "a.toml:2: step: unknown key; did you mean steps?\n";
        QTest::newRow("a value out of range") << "case = \"fig10a\"\nsteps = 0"
                                              << "a.toml:2: steps: must be a whole number from 1 to ";
        QTest::newRow("an unknown key of the case")
            << "case = \"fig10a\"\nset = { \"run.duratio\" = \"1 ms\" }"
            << "a.toml:2: set.run.duratio: unknown key; did you mean run.duration?\n";
        QTest::newRow("a bad value of the case")
            << "case = \"fig10a\"\n[set]\nrun.step = \"1 ns\"\nrun.duration = \"1 nm\""
            << "a.toml:4: set.run.duration: ";
        QTest::newRow("a directory as case") << "case = \"..\""
                                             << "a.toml:1: case: \"..\" is a directory";
    }
    void problems()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const StudyPlan plan = parse(text.toStdString());
        QVERIFY(!plan.valid());
        QVERIFY(!plan.perform);
        QCOMPARE(plan.problems.size(), std::size_t{1});
        QVERIFY2(said(plan).startsWith(says), qPrintable(said(plan)));
    }
    void allProblemsAtOnce()
    {
        const StudyPlan plan =
            parse("case = \"fig10a\"\nsteps = 0\nother = 1\n", nullptr, {}, {"hold=never", "fast=1", "case=x"});
        QCOMPARE(plan.problems.size(), std::size_t{5});
        for (const char* part :
             {"--option: case: is no option; it stands in the study's file", "--option: fast: unknown key",
              "--option: hold: ", "a.toml:2: steps: ", "a.toml:3: other: unknown key"})
            QVERIFY2(said(plan).contains(part), qPrintable(said(plan)));
    }
    void wrongOptions_data()
    {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QString>("says");
        QTest::newRow("no value") << "steps"
                                  << "--option: \"steps\" is not key=value\n";
        QTest::newRow("no key") << "=3"
                                << "--option: \"=3\" is not key=value\n";
        QTest::newRow("an empty part of a key") << "a..b=3"
                                                << "--option: \"a..b=3\" is not key=value\n";
        QTest::newRow("a setting") << "set.run.step=3"
                                   << "--option: set.run.step: is no option; --set KEY=VALUE changes the case\n";
        QTest::newRow("a bad key") << "steps]=3"
                                   << "--option: \"steps]=3\" is not key=value\n";
        QTest::newRow("settings") << "set={}"
                                  << "--option: set: is no option; --set KEY=VALUE changes the case\n";
        QTest::newRow("a text for a number") << "steps=many"
                                             << "--option: steps: must be a whole number from 1 to ";
        QTest::newRow("two lines") << "steps=3\nhold=1"
                                   << "--option: steps: must be a whole number from 1 to ";
        QTest::newRow("near") << "stesp=3"
                              << "--option: stesp: unknown key; did you mean steps?\n";
    }
    void wrongOptions()
    {
        QFETCH(QString, option);
        QFETCH(QString, says);
        const StudyPlan plan = openStudy(kind, "fig10a", {}, {option.toStdString()});
        QCOMPARE(plan.problems.size(), std::size_t{1});
        QVERIFY2(said(plan).startsWith(says), qPrintable(said(plan)));
    }
    void wrongNames_data()
    {
        QTest::addColumn<QString>("study");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("says");
        const QString own = QString::fromStdString(kind);
        QTest::newRow("no such name")
            << own << "fig10q"
            << "fig10q: is neither a file, a sample case nor a sample study of this kind; did you mean fig10a?\n";
        QTest::newRow("no such file") << own << "no/such.toml"
                                      << "no/such.toml: does not exist\n";
        QTest::newRow("nothing") << own << ""
                                 << "a file name is needed\n";
        QTest::newRow("a directory") << own << TOUCHDOWN_SOURCE_DIR "/tests" << TOUCHDOWN_SOURCE_DIR "/tests: ";
        QTest::newRow("no such kind") << "hysterese"
                                      << "fig10a"
                                      << "fig10a: \"hysterese\" is no kind of study; did you mean hysteresis?\n";
        QTest::newRow("a design") << own << TOUCHDOWN_SOURCE_DIR "/sample_cases/studies/film_fig4_pico.toml"
                                  << TOUCHDOWN_SOURCE_DIR
            "/sample_cases/studies/film_fig4_pico.toml:9: kind: is \"design\", not \"hysteresis\"\n";
    }
    void wrongNames()
    {
        QFETCH(QString, study);
        QFETCH(QString, name);
        QFETCH(QString, says);
        const StudyPlan plan = openStudy(study.toStdString(), name.toStdString());
        QCOMPARE(plan.problems.size(), std::size_t{1});
        QVERIFY2(said(plan).startsWith(says), qPrintable(said(plan)));
    }
    /// A study that is performed says what it is.
    void performed()
    {
        const StudyPlan plan =
            openStudy(kind, "fig10a", {"run.duration=20 us"}, {"steps=1", "hold=20 us", "equilibria=false"});
        QVERIFY2(plan.valid(), qPrintable(said(plan)));
        const StudyReport report = plan.perform(1, {});
        QCOMPARE(report.kind, kind);
        QVERIFY(!report.title.empty());
        const StudyReport stopped = plan.perform(1, [](const StudyProgress&) { return false; });
        QCOMPARE(stopped.status, StudyStatus::Cancelled);
    }
};

TOUCHDOWN_TEST(TestStudyPlan)

} // namespace test_study_plan

#include "test_study_plan.moc"
