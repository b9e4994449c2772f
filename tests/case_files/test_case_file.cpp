// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_file.h"

#include "core/case/contact_kind.h"
#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <random>

using namespace touchdown;

namespace test_case_file {

QStringList problemsOf(const CaseDocument& document)
{
    QStringList texts;
    for (const InputProblem& problem : document.problems) texts << QString::fromStdString(problem.text());
    return texts;
}

class TestCaseFile : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(folder_.isValid()); }

    void readsValues()
    {
        const CaseDocument document = parseCase("title = 'A case'\n"
                                                "contact = \"none\"\n"
                                                "[springs]\n"
                                                "flying_height = \"0.0032 um\" # another unit\n"
                                                "pitch = 94.2e-6              # bare: SI\n"
                                                "front_damping_ratio = \"0.2 %\"\n"
                                                "[suspension]\n"
                                                "stiffness = 18\n"
                                                "[run]\n"
                                                "integrator = \"rk4\"\n"
                                                "step_check = false\n",
                                                "a.toml");
        QCOMPARE(problemsOf(document), QStringList());
        QCOMPARE(document.name, std::string("a.toml"));
        QCOMPARE(document.value.title, std::string("A case"));
        QCOMPARE(document.value.contact, ContactKind::None);
        QVERIFY(document.value.springs.flyingHeight == 3.2e-9);
        QVERIFY(document.value.springs.pitch == 94.2e-6);
        QVERIFY(document.value.springs.frontDampingRatio == 0.002);
        QVERIFY(document.value.suspension.stiffness == 18.0);
        QCOMPARE(document.value.run.integrator, IntegratorKind::Rk4);
        QCOMPARE(document.value.run.stepCheck, false);
        // What the text does not say has its default.
        QVERIFY(document.value.slider.mass == Case{}.slider.mass);
    }

    void readsLists()
    {
        const CaseDocument document = parseCase("model = 'film'\n[film]\nnodes = [97, 193]\n"
                                                "[steady]\nradii = ['20 mm', 0.03,\n  '4 cm']\nspeeds = []\n",
                                                "a.toml");
        QCOMPARE(problemsOf(document), QStringList());
        QCOMPARE(document.value.film.nodes, (std::array<int, 2>{97, 193}));
        QCOMPARE(document.value.steady.radii, (std::vector<double>{0.02, 0.03, 0.04}));
        QVERIFY(document.value.steady.speeds.empty());
    }
    /// A film case that says nothing more is one that flies freely.
    void readsTheDefaultsOfTheModel()
    {
        const CaseDocument film = parseCase("model = 'film'\n[slider]\nmass = '2 mg'\n", "a.toml");
        QCOMPARE(problemsOf(film), QStringList());
        QCOMPARE(film.value.contact, ContactKind::None);
        QCOMPARE(film.value.degreesOfFreedom, 3);
        QCOMPARE(parseCase("model = 'film'\ndegrees_of_freedom = 2\n", "").value.degreesOfFreedom, 2);
        QCOMPARE(parseCase("[slider]\nmass = '2 mg'\n", "").value.contact, ContactKind::OnoYamane);
    }

    void namesTheProblem_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, QByteArray text, const char* says) {
            QTest::newRow(name) << text << QString(says);
        };
        row("unknown key", "[springs]\ncutof = '1 nm'",
            "a.toml:2: springs.cutof: unknown key; did you mean springs.cutoff?");
        row("unknown key like no other", "\nbanana = 1", "a.toml:2: banana: unknown key");
        row("key in the wrong table", "[slider]\nfriction = 1",
            "a.toml:2: slider.friction: unknown key; did you mean ono_yamane.friction?");
        row("key in quotation marks", "'springs.cutoff' = '1 nm'",
            "a.toml:1: \"springs.cutoff\": unknown key; did you mean springs.cutoff?");
        row("unknown table", "[spring]\ncutoff = '1 nm'\npitch = 1",
            "a.toml:1: spring: unknown table; did you mean springs?");
        row("unknown table like no other", "[banana]\nnodes = [1, 2]", "a.toml:1: banana: unknown table");
        row("unknown tables in an array", "[[banana]]\nx = 1\n[[banana]]\nx = 1", "a.toml:1: banana: unknown table");
        row("tables for a list", "[[steady.radii]]\nx = 1", "a.toml:1: steady.radii: is a value, not a table");
        row("unknown table in a known one", "[slider.pad]\nx = 1", "a.toml:1: slider.pad: unknown table");
        row("missing unit", "[springs]\n\ncutoff = '7'",
            "a.toml:3: springs.cutoff: \"7\" has no unit; a length such as nm, um or mm is needed");
        row("wrong unit", "[springs]\ncutoff = '7 kg'",
            "a.toml:2: springs.cutoff: \"7 kg\" has the wrong unit; a length such as nm, um or mm is needed");
        row("unknown unit", "[springs]\ncutoff = '7 nn'",
            "a.toml:2: springs.cutoff: \"7 nn\" has an unknown unit; a length such as nm, um or mm is needed");
        row("negative mass", "[slider]\nmass = '-1.6 mg'",
            "a.toml:2: slider.mass: -1.6 mg is out of range: allowed is at least 1e-6 mg, at most 10 kg");
        row("negative bare mass", "[slider]\nmass = -1",
            "a.toml:2: slider.mass: -1 kg is out of range: allowed is at least 1e-6 mg, at most 10 kg");
        row("take-off below touch-down", "[ono_yamane]\ntake_off = '2 nm'",
            "a.toml:2: ono_yamane.take_off: d_e = 2 nm must be at least ono_yamane.touch_down (d_s = 3 nm)");
        row("take-off below touch-down, by the default", "[ono_yamane]\ntouch_down = '6 nm'",
            "a.toml: ono_yamane.take_off: d_e = 5 nm must be at least ono_yamane.touch_down (d_s = 6 nm)");
        row("not a number", "[run]\ntolerance = nan", "a.toml:2: run.tolerance: is not a finite number");
        row("infinity", "[initial]\nvertical_velocity = -inf",
            "a.toml:2: initial.vertical_velocity: is not a finite number");
        row("text for an integer", "degrees_of_freedom = '2'",
            "a.toml:1: degrees_of_freedom: is text; a whole number is needed");
        row("text for a boolean", "[run]\nstep_check = 'no'",
            "a.toml:2: run.step_check: is text; true or false is needed");
        row("a number for a boolean", "[run]\nstep_check = 1",
            "a.toml:2: run.step_check: is a number; true or false is needed");
        row("a number for a choice", "[initial]\nbranch = 1",
            "a.toml:2: initial.branch: is a number; allowed is one of touch-down, take-off");
        row("a number for a text", "title = 1", "a.toml:1: title: is a number; text in quotation marks is needed");
        row("a boolean for a number", "[run]\ntolerance = true",
            "a.toml:2: run.tolerance: is true; a number is needed");
        row("an array for a length", "[springs]\ncutoff = [1]",
            "a.toml:2: springs.cutoff: has the wrong type; a number or \"1 nm\" is needed");
        row("a value for a table", "slider = 5", "a.toml:1: slider: is a table, not a value; write [slider]");
        row("tables for a table", "[[slider]]\nmass = 1", "a.toml:1: slider: is a table, not a value; write [slider]");
        row("a table for a value", "[slider.mass]\nx = 1", "a.toml:1: slider.mass: is a value, not a table");
        row("a model of a later version", "model = 'foil'",
            "a.toml:1: model: \"foil\" is not known: allowed is one of springs, film, contact");
        row("springs that roll", "degrees_of_freedom = 3",
            "a.toml:1: degrees_of_freedom: must be 2 with model \"springs\", which has height and pitch only");
        row("a number for a list", "[film]\nnodes = 97",
            "a.toml:2: film.nodes: is a number; a list such as [193, 193] is needed");
        row("a text for a list", "[steady]\nradii = '20 mm'",
            "a.toml:2: steady.radii: is text; a list such as [\"1 mm\", \"1 mm\"] is needed");
        row("a short list", "[film]\nnodes = [97]",
            "a.toml:2: film.nodes: has 1 number: allowed is 2 numbers, each 17, 33, 49 and so on to 2049");
        row("a list in a list", "[film]\nnodes = [97, [97]]",
            "a.toml:2: film.nodes: has the wrong type; a number is needed");
        row("a wrong unit in a list", "[steady]\nskews = ['1 deg', '2 mm']",
            "a.toml:2: steady.skews: \"2 mm\" has the wrong unit; an angle such as urad, mrad or deg is needed");
        row("a list for a choice", "[initial]\nbranch = ['take-off']",
            "a.toml:2: initial.branch: has the wrong type; allowed is one of touch-down, take-off");
        row("no TOML", "a = \n", "a.toml:1: is not TOML: expected value, but the line ends");
        row("Latin-1", "# \xb5", "a.toml:1: is not valid UTF-8 text");
    }
    /// One sentence for each problem, with file, line and key.
    void namesTheProblem()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        QCOMPARE(problemsOf(parseCase(text.toStdString(), "a.toml")), QStringList(says));
    }

    void reportsEverythingAtOnce()
    {
        const CaseDocument document = parseCase(
            "banana = 1\n[slider]\nmass = '-1 mg'\nthicknes = 1\n[run]\nduration = '2'\nstep = '1 s'\n"
            "integrator = 'rk4'\nsample_interval = '200 s'\n[foil]\nnodes = 7\n[ono_yamane]\ntake_off = '1 nm'\n",
            "a.toml");
        QStringList places;
        for (const InputProblem& problem : document.problems)
            places << QString("%1 %2").arg(problem.line).arg(problem.key.c_str());
        // The duration was not read, so nothing is said about the step that would exceed it.
        QCOMPARE(places, (QStringList{"1 banana", "3 slider.mass", "4 slider.thicknes", "6 run.duration",
                                      "9 run.sample_interval", "10 foil", "13 ono_yamane.take_off"}));
        QVERIFY(!document.valid());
    }
    void aThousandProblemsTakeNoTime()
    {
        std::string text;
        for (int i = 0; i < 20000; ++i) text += "springs_cutof" + std::to_string(i) + " = 1\n";
        QCOMPARE(parseCase(text, "").problems.size(), std::size_t{20000});
    }

    void refusesFiles_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("says");
        QTest::newRow("an empty file") << QByteArray("") << "is empty";
        QTest::newRow("blank lines alone") << QByteArray("\n \r\n\t\n") << "is empty";
        QTest::newRow("binary noise") << QByteArray("\x89HDF\r\n\x1a\n\0\0\0", 11) << "is not a text file";
        QTest::newRow("UTF-16") << QByteArray("\xff\xfe"
                                              "a\0=\0",
                                              6)
                                << "is not a text file";
    }
    void refusesFiles()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, says);
        const auto file = path("bad.toml");
        std::ofstream(file, std::ios::binary) << content.toStdString();
        QCOMPARE(problemsOf(readCaseFile(file)), QStringList(QString::fromStdString(file.string()) + ": " + says));
    }
    void refusesHundredMegabytesOfNoise()
    {
        const auto file = path("noise.toml");
        std::mt19937_64 generator(3);
        std::string block(1 << 20, ' ');
        for (std::size_t i = 0; i + 8 <= block.size(); i += 8) {
            const std::uint64_t noise = generator();
            block.replace(i, 8, reinterpret_cast<const char*>(&noise), 8);
        }
        std::ofstream out(file, std::ios::binary);
        for (int i = 0; i < 100; ++i) out << block;
        out.close();
        QCOMPARE(std::filesystem::file_size(file), std::uintmax_t{100} << 20);
        QCOMPARE(problemsOf(readCaseFile(file)), QStringList(QString::fromStdString(file.string()) +
                                                             ": is larger than 1024 KiB, so it is not a case file"));
        std::filesystem::remove(file);
    }
    /// Noise of every length that is read: one sentence, whatever the bytes.
    void refusesAnyNoise()
    {
        std::mt19937 generator(5);
        for (int length = 1; length < 300; ++length) {
            std::string noise;
            for (int i = 0; i < length; ++i) noise += static_cast<char>(generator() % 256);
            const CaseDocument document = parseCase("#\n" + noise, "noise");
            QVERIFY(document.valid() || document.problems.size() == 1);
        }
    }
    /// A good case with a few bytes changed is read or refused, and never ends the program.
    void survivesChangedBytes()
    {
        const std::string good = sampleCases().front().text;
        std::mt19937 generator(6);
        for (int round = 0; round < 2000; ++round) {
            std::string text = good;
            for (int i = 0; i < 3; ++i) text[generator() % text.size()] = static_cast<char>(generator() % 128);
            const CaseDocument document = parseCase(text, "x");
            for (const InputProblem& problem : document.problems) QVERIFY(!problem.message.empty());
        }
    }
    void refusesWhatIsNoFile()
    {
        QCOMPARE(problemsOf(readCaseFile(folder_.path().toStdString())),
                 QStringList(folder_.path() + ": is a directory, not a file"));
        QCOMPARE(problemsOf(readCaseFile("/proc/self/mem")), QStringList("/proc/self/mem: is not a regular file"));
        QCOMPARE(problemsOf(readCaseFile(path("none.toml"))),
                 QStringList(folder_.path() + "/none.toml: does not exist"));
        QCOMPARE(problemsOf(readCaseFile("")), QStringList("a file name is needed"));
    }

    void opensFilesAndSamples()
    {
        const auto file = path("mine.toml");
        QCOMPARE(writeCaseFile(file, "title = 'mine'\n"), std::string());
        QCOMPARE(openCase(file.string()).value.title, std::string("mine"));
        const CaseDocument sample = openCase(std::string(defaultCaseName));
        QCOMPARE(problemsOf(sample), QStringList());
        QCOMPARE(sample.name, std::string(defaultCaseName));
        QCOMPARE(problemsOf(openCase("fig10x")),
                 QStringList("fig10x: is neither a file nor a sample case; did you mean fig10a?"));
        QCOMPARE(problemsOf(openCase("banana")), QStringList("banana: is neither a file nor a sample case"));
        QVERIFY(openCase("banana").problems.front().kind == ProblemKind::NotFound);
    }

    /// A warning keeps the line of its value; where a setting made it, the setting is its place.
    void warningsKeepTheirPlace()
    {
        CaseDocument document = parseCase("model = \"springs\"\ncontact = \"ono-yamane\"\n[ono_yamane]\n"
                                          "meniscus_force = \"1 mN\"\n",
                                          "weak.toml");
        QCOMPARE(document.warnings.size(), std::size_t{1});
        applySettings(document, {"run.duration=1 ms"});
        QCOMPARE(document.warnings.size(), std::size_t{1});
        QCOMPARE(document.warnings.front().file, std::string("weak.toml"));
        QCOMPARE(document.warnings.front().line, 4);
        applySettings(document, {"ono_yamane.meniscus_force=0.9 mN"});
        QCOMPARE(document.warnings.front().file, std::string("--set"));
        applySettings(document, {"ono_yamane.meniscus_force=9 mN"});
        QVERIFY(document.warnings.empty());
    }

    void settings_data()
    {
        QTest::addColumn<QStringList>("settings");
        QTest::addColumn<QStringList>("says");
        QTest::newRow("a quantity") << QStringList("springs.flying_height=8 nm") << QStringList();
        QTest::newRow("spaces and quotation marks")
            << QStringList(" springs.flying_height = \"8 nm\" ") << QStringList();
        QTest::newRow("SI") << QStringList("springs.flying_height=8e-9") << QStringList();
        QTest::newRow("the last one holds")
            << QStringList{"springs.flying_height=9 nm", "springs.flying_height=8 nm"} << QStringList();
        QTest::newRow("an unknown key") << QStringList("springs.hight=8 nm")
                                        << QStringList("--set: springs.hight: unknown key");
        QTest::newRow("a slip") << QStringList("springs.flying_hight=8 nm")
                                << QStringList(
                                       "--set: springs.flying_hight: unknown key; did you mean springs.flying_height?");
        QTest::newRow("no value") << QStringList("springs.flying_height")
                                  << QStringList("--set: \"springs.flying_height\" is not key=value");
        QTest::newRow("an empty value") << QStringList("springs.flying_height=")
                                        << QStringList("--set: springs.flying_height: is empty; a number is needed");
        QTest::newRow("no unit in quotation marks")
            << QStringList("springs.flying_height='8'")
            << QStringList("--set: springs.flying_height: \"8\" has no unit; a length such as nm, um or mm is needed");
        QTest::newRow("two problems")
            << QStringList{"slider.mass=0 mg", "initial.branch=x"}
            << QStringList{"--set: slider.mass: 0 mg is out of range: allowed is at least 1e-6 mg, at most 10 kg",
                           "--set: initial.branch: \"x\" is not known: allowed is one of touch-down, take-off"};
        QTest::newRow("a list, and a quantity")
            << QStringList{"steady.radii=[20 mm, 30 mm]", "springs.flying_height=8 nm"} << QStringList();
        QTest::newRow("a short list")
            << QStringList("film.nodes=97")
            << QStringList("--set: film.nodes: has 1 number: allowed is 2 numbers, each 17, 33, 49 and so on to 2049");
        QTest::newRow("list without commas")
            << QStringList("film.nodes=97 193")
            << QStringList("--set: film.nodes: \"97 193\" is not a number; separate the numbers of a list by commas");
        QTest::newRow("a combination")
            << QStringList("ono_yamane.take_off=1 nm")
            << QStringList(
                   "--set: ono_yamane.take_off: d_e = 1 nm must be at least ono_yamane.touch_down (d_s = 3 nm)");
    }
    void settings()
    {
        QFETCH(QStringList, settings);
        QFETCH(QStringList, says);
        CaseDocument document = parseCase("title = 'x' # kept\n", "a.toml");
        std::vector<std::string> list;
        for (const QString& setting : settings) list.push_back(setting.toStdString());
        applySettings(document, list);
        QCOMPARE(problemsOf(document), says);
        if (!says.isEmpty()) return;
        QVERIFY(document.value.springs.flyingHeight == 8e-9);
        // The text says so too, for whoever stores it.
        QVERIFY(document.text.starts_with("title = 'x' # kept\n"));
        QVERIFY(parseCase(document.text, "").value.springs.flyingHeight == 8e-9);
    }
    /// A value that could not be read has its default, which a combination must not blame on the others.
    void combinationsWaitForTheirValues()
    {
        QCOMPARE(parseCase("[run]\nduration = 'x'\nsample_interval = '3 ms'\n", "a.toml").problems.size(),
                 std::size_t{1});
        QCOMPARE(parseCase("[run]\nstep = 'x'\nsample_interval = '3 ms'\n", "a.toml").problems.size(), std::size_t{2});
    }
    void aSettingMendsACombination()
    {
        CaseDocument document = parseCase("[ono_yamane]\ntouch_down = '6 nm'\n", "a.toml");
        QVERIFY(!document.valid());
        applySettings(document, {"ono_yamane.take_off=7 nm"});
        QCOMPARE(problemsOf(document), QStringList());
    }
    void aSettingDoesNotHideAProblemOfTheFile()
    {
        CaseDocument document = parseCase("banana = 1\n", "a.toml");
        applySettings(document, {"slider.mass=2 mg"});
        QCOMPARE(problemsOf(document), QStringList("a.toml:1: banana: unknown key"));
    }

    void writeProblemsNameTheFile()
    {
        const auto file = path("no folder/case.toml");
        QCOMPARE(QString::fromStdString(writeCaseFile(file, "x")),
                 QString::fromStdString(file.string()) + ": cannot be written: No such file or directory");
    }

    void samples_data()
    {
        QTest::addColumn<QString>("name");
        for (const SampleCase& sample : sampleCases())
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
    }
    void samples()
    {
        QFETCH(QString, name);
        const CaseDocument document = openCase(name.toStdString());
        QCOMPARE(problemsOf(document), QStringList());
        QStringList said;
        for (const auto* list : {&document.warnings, &document.unused})
            for (const InputProblem& warning : *list) said << QString::fromStdString(warning.text());
        QCOMPARE(said, QStringList());
        QVERIFY(!document.value.about.paper.empty());
        QVERIFY(!document.value.about.watch.empty());
        QVERIFY(!document.value.about.assumed.empty());
        QVERIFY(document.value.title != Case{}.title);
        QCOMPARE(titleOf(*std::ranges::find(sampleCases(), name.toStdString(), &SampleCase::name)),
                 document.value.title);
    }
    /// Figs. 5 to 8 are of the one slider of Fig. 4, which stands in each of their files.
    void theFiguresFlyTheSliderOfFigureFour()
    {
        const Case slider = openCase("film_fig4_pico").value;
        int figures = 0;
        for (const SampleCase& sample : sampleCases()) {
            if (!sample.name.starts_with("fig0") || sample.name.starts_with("fig02")) continue;
            ++figures;
            const Case c = openCase(sample.name).value;
            QCOMPARE(c.model, ModelKind::Film);
            QCOMPARE(c.contact, ContactKind::OnoYamane);
            for (const Parameter& parameter : parameters())
                if (QStringList{"slider", "suspension", "abs", "air", "disk", "film", "steady"}.contains(
                        QString::fromStdString(parameter.group())) &&
                    parameter.key != "film.nodes") // more of them along the slider, for its motion
                    QVERIFY2(parameter.get(c) == parameter.get(slider), (sample.name + ": " + parameter.key).c_str());
            QVERIFY2(c.surface == slider.surface, sample.name.c_str());
            // What all of them share of the contact, by the paper's section 4.
            QCOMPARE(c.onoYamane.contactStiffness, 5e6);
            QCOMPARE(c.onoYamane.initialContactForce, 5e-3);
            QCOMPARE(c.onoYamane.touchDown, 3e-9);
        }
        QCOMPARE(figures, 12);
    }
    /// Fig. 2 twice: on a pad that is pressed onto the disk, and on the micro pad of Fig. 1.
    void figureTwoFliesItsSliders()
    {
        int figures = 0;
        for (const SampleCase& sample : sampleCases()) {
            if (!sample.name.starts_with("fig02")) continue;
            ++figures;
            const bool micro = sample.name.starts_with("fig02_micro_pad");
            const Case slider = openCase(micro ? "film_fig1_micro_pad" : "film_fig2_pressed_pad").value;
            const Case c = openCase(sample.name).value;
            for (const Parameter& parameter : parameters())
                if (QStringList{"slider", "suspension", "abs", "air", "film", "steady"}.contains(
                        QString::fromStdString(parameter.group())) &&
                    (micro || parameter.key != "film.nodes")) // fewer of them for the runs of the pressed pad
                    QVERIFY2(parameter.get(c) == parameter.get(slider), (sample.name + ": " + parameter.key).c_str());
            QVERIFY2(c.surface == slider.surface, sample.name.c_str());
            // The paper: no roughness, or one of 0.2 nm that moves or does not.
            QCOMPARE(c.contact, ContactKind::Elastic);
            const bool flat = sample.name.ends_with("case_1_flat");
            QCOMPARE(c.diskSurface.kind == DiskSurfaceKind::Flat, flat);
            if (flat) continue;
            QCOMPARE(c.diskSurface.rms, 0.2e-9);
            QCOMPARE(c.diskSurface.motion == SurfaceMotion::Moving, sample.name.ends_with("case_2_moving"));
        }
        QCOMPARE(figures, 6);
    }
    void theDefaultSampleIsTheDefaultCase()
    {
        Case c = openCase(std::string(defaultCaseName)).value;
        c.title = Case{}.title;
        c.about = {};
        QCOMPARE(test::firstDifference(c, Case{}), std::string());
    }

private:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestCaseFile)

} // namespace test_case_file

#include "test_case_file.moc"
