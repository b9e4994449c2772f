// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_reader.h"

#include <QtTest>

#include "core/case/case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_reader {

/// A reader with all that it refers to.
struct Read {
    explicit Read(const std::string& text) : toml(readToml(text)), reader(toml, "a.toml", start, problems)
    {
        if (!toml.problem.empty()) qFatal("%s", toml.problem.c_str());
    }
    std::string said() const
    {
        std::string all;
        for (const InputProblem& problem : problems) all += problem.text() + '\n';
        return all;
    }

    TomlDocument toml;
    Case start;
    std::vector<InputProblem> problems;
    StudyReader reader;
};

QString text(const std::string& value) { return QString::fromStdString(value); }

class TestStudyReader : public QObject {
    Q_OBJECT

private slots:
    void values()
    {
        Read a("length = \"3 nm\"\nbare = 2e-9\ncount = 7\nyes = true\nname = \"x\"\nway = \"up\"\nshare = \"5 %\"\n");
        QCOMPARE(*a.reader.number("length", "m", "nm", 0.0, 1.0), 3e-9);
        QCOMPARE(*a.reader.number("bare", "m", "nm", 0.0, 1.0), 2e-9);
        QCOMPARE(*a.reader.number("share", "", "", 0.0, 1.0), 0.05);
        QCOMPARE(*a.reader.integer("count", 1, 7), 7);
        QCOMPARE(*a.reader.boolean("yes"), true);
        QCOMPARE(*a.reader.text("name"), std::string("x"));
        QCOMPARE(*a.reader.choice("way", {"up", "down"}), std::string("up"));
        QVERIFY(a.reader.has("way"));
        a.reader.finish();
        QCOMPARE(text(a.said()), QString());
    }
    void missing()
    {
        Read a("");
        QVERIFY(!a.reader.number("a", "m", "nm", 0.0, 1.0));
        QVERIFY(!a.reader.integer("a", 0, 1));
        QVERIFY(!a.reader.boolean("a"));
        QVERIFY(!a.reader.text("a"));
        QVERIFY(!a.reader.choice("a", {"b"}));
        QVERIFY(!a.reader.texts("a"));
        QVERIFY(!a.reader.numbers("a", "", "", 0.0, 1.0));
        QVERIFY(a.reader.settings("a").empty());
        QVERIFY(a.reader.tables("a").empty());
        QVERIFY(!a.reader.has("a"));
        a.reader.finish();
        QCOMPARE(text(a.said()), QString());
    }
    /// Values and defaults of a table of keys.
    void fromTheTable()
    {
        Read a("hold = \"3 ns\"\nway = \"up\"\nsteps = 9\n");
        a.reader.setKeys({numberKey("hold", 1e-9, "s", "ns", 0.0, 1.0, ""),
                          numberKey("rest", 2e-9, "s", "ns", 0.0, 1.0, ""), integerKey("steps", 4, 1, 5, ""),
                          booleanKey("on", true, ""), choiceKey("way", "down", {"up", "down"}, ""),
                          choiceKey("end", "x", {"x", "y"}, "")});
        QCOMPARE(a.reader.number("hold"), 3e-9);
        QCOMPARE(a.reader.number("rest"), 2e-9);
        QCOMPARE(a.reader.integer("steps"), 4);
        QVERIFY(a.reader.flag("on"));
        QCOMPARE(a.reader.choice("way"), std::string("up"));
        QCOMPARE(a.reader.choice("end"), std::string("x"));
        QCOMPARE(text(a.said()), QString("a.toml:3: steps: must be a whole number from 1 to 5\n"));
    }
    void lists()
    {
        Read a("x = [\"1 ns\", 1e-8]\ny = [1e-8, \"1 ns\", 3]\n");
        QCOMPARE(*a.reader.numbers("x", "s", "ns", 0.0, 1.0), (std::vector<double>{1e-9, 1e-8}));
        QCOMPARE(*a.reader.texts("y"), (std::vector<std::string>{"1e-8", "1 ns", "3"}));
    }
    void settings_data()
    {
        QTest::addColumn<QString>("written");
        QTest::newRow("inline")
            << "set = {\"run.step\" = \"10 ns\", \"film.nodes\" = [97, 97], \"slider.roll_free\" = false}";
        QTest::newRow("a table")
            << "[set]\n\"run.step\" = \"10 ns\"\n\"film.nodes\" = [97, 97]\n\"slider.roll_free\" = false";
        QTest::newRow("dotted keys") << "[set]\nrun.step = \"10 ns\"\nfilm.nodes = [97, 97]\nslider.roll_free = false";
    }
    void settings()
    {
        QFETCH(QString, written);
        Read a(written.toStdString());
        const auto list = a.reader.settings("set");
        a.reader.finish();
        QCOMPARE(text(a.said()), QString());
        QCOMPARE(list.size(), std::size_t{3});
        QCOMPARE(list[0], (CaseSetting{"run.step", "10 ns"}));
        QCOMPARE(list[1], (CaseSetting{"film.nodes", "97, 97"}));
        QCOMPARE(list[2], (CaseSetting{"slider.roll_free", "false"}));
    }
    void tables()
    {
        Read a("[[method]]\nname = \"a\"\nset = {\"run.step\" = 1e-9}\n[[method]]\nname = \"b\"\n[[methods]]\nname = "
               "\"c\"\n");
        QCOMPARE(a.reader.tables("method"), (std::vector<std::string>{"method[1]", "method[2]"}));
        QCOMPARE(*a.reader.text("method[1].name"), std::string("a"));
        QCOMPARE(a.reader.settings("method[1].set").front().value, std::string("1e-9"));
        QCOMPARE(*a.reader.text("method[2].name"), std::string("b"));
        a.reader.finish();
        QCOMPARE(text(a.said()), QString("a.toml:6: methods: unknown table; did you mean method?\n"));
    }
    void inlineTables()
    {
        Read a("method = [{name = \"a\"}, {name = \"b\"}]\n");
        QCOMPARE(a.reader.tables("method").size(), std::size_t{2});
        QCOMPARE(*a.reader.text("method[2].name"), std::string("b"));
    }

    void problems_data()
    {
        QTest::addColumn<QString>("written");
        QTest::addColumn<QString>("says");
        QTest::newRow("below the range") << "length = \"0.5 nm\""
                                         << "a.toml:1: length: must be from 1 nm to 9 nm\n";
        QTest::newRow("without its unit")
            << "length = 5"
            << "a.toml:1: length: must be from 1 nm to 9 nm; a number without its unit is in m\n";
        QTest::newRow("another unit") << "length = \"1 s\""
                                      << "a.toml:1: length: ";
        QTest::newRow("no number") << "length = true"
                                   << "a.toml:1: length: has the wrong type; a number or \"1 nm\" is needed\n";
        QTest::newRow("not finite") << "length = inf"
                                    << "a.toml:1: length: is not a finite number\n";
        QTest::newRow("negative without end") << "\nabove = -1"
                                              << "a.toml:2: above: must be at least 0\n";
        QTest::newRow("half a run") << "count = 1.5"
                                    << "a.toml:1: count: must be a whole number from 1 to 5\n";
        QTest::newRow("too many runs") << "count = 6"
                                       << "a.toml:1: count: must be a whole number from 1 to 5\n";
        QTest::newRow("neither true nor false") << "yes = 1"
                                                << "a.toml:1: yes: has the wrong type; true or false is needed\n";
        QTest::newRow("no text") << "name = 1"
                                 << "a.toml:1: name: has the wrong type; text in quotation marks is needed\n";
        QTest::newRow("no choice")
            << "way = \"upp\""
            << "a.toml:1: way: \"upp\" is not known: allowed is one of up, down; did you mean up?\n";
        QTest::newRow("an empty list") << "list = []"
                                       << "a.toml:1: list: is empty; a list of texts or numbers is needed\n";
        QTest::newRow("a text for a list")
            << "list = \"a, b\""
            << "a.toml:1: list: has the wrong type; a list of texts or numbers is needed\n";
        QTest::newRow("a list in a list")
            << "list = [[1]]"
            << "a.toml:1: list: has the wrong type; a list of texts or numbers is needed\n";
        QTest::newRow("no numbers") << "numbers = []"
                                    << "a.toml:1: numbers: is empty; a list such as [1, 1] is needed\n";
        QTest::newRow("one number too small") << "numbers = [1, -1]"
                                              << "a.toml:1: numbers: must be from 0 to 2\n";
        QTest::newRow("an unknown key") << "cuont = 3"
                                        << "a.toml:1: cuont: unknown key; did you mean count?\n";
        QTest::newRow("a strange key") << "completely = 3"
                                       << "a.toml:1: completely: unknown key\n";
        QTest::newRow("an unknown table") << "[other]\na = 1\nb = 1"
                                          << "a.toml:1: other: unknown table\n";
        QTest::newRow("a list as a table") << "[method]\nname = \"a\""
                                           << "a.toml:1: method: is one of a list; write [[method]]\n";
        QTest::newRow("a list as a text") << "method = \"a\""
                                          << "a.toml:1: method: is one of a list; write [[method]]\n";
        QTest::newRow("an unknown key of a table") << "[[method]]\n[[method]]\nnam = \"a\""
                                                   << "a.toml:3: method[2].nam: unknown key; did you mean name?\n";
        QTest::newRow("a table for a number") << "count = {}"
                                              << "a.toml:1: count: is a table, not a value\n";
        QTest::newRow("a table for a text") << "[name]\nx = 1"
                                            << "a.toml:1: name: is a table, not a value\n";
        QTest::newRow("tables for a list") << "[[list]]\nx = 1"
                                           << "a.toml:1: list: is a table, not a value\n";
        QTest::newRow("settings as a text")
            << "set = \"run.step=1\""
            << "a.toml:1: set: must be a table such as { \"run.duration\" = \"1 ms\" }\n";
        QTest::newRow("a date in settings")
            << "set = {a = 1979-05-27}"
            << "a.toml:1: set.a: has the wrong type; a text, a number, true, false or a list of these is needed\n";
    }
    void problems()
    {
        QFETCH(QString, written);
        QFETCH(QString, says);
        Read a(written.toStdString());
        a.reader.number("length", "m", "nm", 1e-9, 9e-9);
        a.reader.number("above", "", "", 0.0, std::numeric_limits<double>::infinity());
        a.reader.integer("count", 1, 5);
        a.reader.boolean("yes");
        a.reader.text("name");
        a.reader.choice("way", {"up", "down"});
        a.reader.texts("list");
        a.reader.numbers("numbers", "", "", 0.0, 2.0);
        a.reader.settings("set");
        for (const std::string& table : a.reader.tables("method")) a.reader.text(table + ".name");
        a.reader.finish();
        QCOMPARE(a.problems.size(), std::size_t{1});
        QVERIFY2(text(a.said()).startsWith(says), a.said().c_str());
    }
    /// A missing key is told at its table.
    void linesOfWhatIsMissing()
    {
        Read a("x = 1\n[[method]]\nname = \"a\"\n\n[[method]]\n");
        a.reader.add("method[2].name", "is missing");
        a.reader.add("y", "is missing");
        QCOMPARE(text(a.said()), QString("a.toml:5: method[2].name: is missing\na.toml: y: is missing\n"));
    }
    /// A problem of a value is one of its key, in an inline table and below a header, and is told once.
    void linesOfSettings()
    {
        Read a(
            "[[method]]\nname = \"a\"\nset = { \"run.step\" = \"1 m\" }\n[common]\n[common.set]\nrun.duration = 1\n");
        for (int i = 0; i < 2; ++i) {
            a.reader.addOfSettings("method[1]", {"method[1].set", "common.set"},
                                   InputProblem{"", 0, "run.step", "is too long"});
            a.reader.addOfSettings("method[1]", {"method[1].set", "common.set"},
                                   InputProblem{"", 0, "run.duration", "is too short"});
            a.reader.addOfSettings("method[1]", {"method[1].set", "common.set"},
                                   InputProblem{"", 0, "run.stepp", "is another key"});
        }
        QCOMPARE(text(a.said()), QString("a.toml:3: method[1].set.\"run.step\": is too long\n"
                                         "a.toml:6: common.set.run.duration: is too short\n"
                                         "a.toml:1: method[1]: run.stepp: is another key\n"));
    }
    /// Keys of the table are no mistake where the study does not read them.
    void knownKeys()
    {
        Read a("x = 1\n[search]\ny = 1\nother = 1\n[[rail]]\nz = 1\nw = 1\n");
        a.reader.setKeys({integerKey("x", 1, 0, 1, ""), integerKey("search.y", 1, 0, 1, ""),
                          inList(integerKey("rail.z", 1, 0, 1, ""))});
        a.reader.finish();
        QCOMPARE(text(a.said()),
                 QString("a.toml:4: search.other: unknown key\na.toml:7: rail[1].w: unknown key; did you mean z?\n"));
    }
    void givenBesideTheFile()
    {
        TomlDocument toml;
        const auto give = [&](const char* key, const TomlValue& value) {
            toml.entries.push_back({key, value, optionLine, 0, 0});
        };
        give("count", std::int64_t{9});
        give("steps", std::string("1 ns, 10 ns"));
        give("share", 0.5);
        give("names", std::string("rk4,dopri5"));
        const Case start;
        std::vector<InputProblem> problems;
        StudyReader reader(toml, "a.toml", start, problems);
        QCOMPARE(*reader.numbers("steps", "s", "ns", 0.0, 1.0), (std::vector<double>{1e-9, 1e-8}));
        QCOMPARE(*reader.numbers("share", "", "", 0.0, 1.0), std::vector<double>{0.5});
        QCOMPARE(*reader.texts("names"), (std::vector<std::string>{"rk4", "dopri5"}));
        QVERIFY(problems.empty());
        reader.integer("count", 1, 5);
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems.front().text(), std::string("--option: count: must be a whole number from 1 to 5"));
    }
    /// Each search ends at once however many tables and mistakes a file has.
    void manyTables()
    {
        std::string many;
        for (int i = 0; i < 20000; ++i) many += "[[method]]\n[x" + std::to_string(i) + "]\n";
        Read a(many);
        for (const std::string& table : a.reader.tables("method")) a.reader.add(table + ".name", "is missing");
        a.reader.finish();
        QCOMPARE(a.problems.size(), std::size_t{40000});
    }
};

TOUCHDOWN_TEST(TestStudyReader)

} // namespace test_study_reader

#include "test_study_reader.moc"
