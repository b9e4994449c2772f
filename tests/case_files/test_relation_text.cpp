// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/relation_text.h"

#include <algorithm>
#include <fstream>
#include <random>

#include <QTemporaryDir>
#include <QTest>

#include "core/case/case_difference.h"
#include "core/case/case_key.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/simulation/static_state/static_solution.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_relation_text {

/// Two boxes of 0.2 mm, mirror images on a slider 1 mm wide, with a gap of 0.2 mm, and a rail with three corners.
const std::string rails = "model = 'film'\n"
                          "slider.width = '1 mm'\n"
                          "slider.length = '1.2 mm'\n"
                          "[[abs.rail]] # the lower one\n"
                          "points = [['0.1 mm', '0.2 mm'], ['0.3 mm', '0.2 mm'], ['0.3 mm', '0.4 mm'], "
                          "['0.1 mm', '0.4 mm']]\n"
                          "[[abs.rail]]\n"
                          "points = [['0.1 mm', '0.8 mm'], ['0.3 mm', '0.8 mm'], ['0.3 mm', '0.6 mm'], "
                          "['0.1 mm', '0.6 mm']]\n"
                          "[[abs.rail]]\n"
                          "points = [['0.8 mm', '0.1 mm'], ['0.9 mm', '0.1 mm'], ['0.8 mm', '0.3 mm']]\n";
const std::string relations = "# the gap\n"
                              "[[abs.distance]]\n"
                              "from = \"edge 3 of rail 1\" # upper\n"
                              "to = \"edge 3 of rail 2\"\n"
                              "along = \"y\"\n"
                              "value = \"200 um\"\n"
                              "[[abs.distance]]\n"
                              "from = \"corner 2 of rail 1\"\n"
                              "to = \"corner 1 of rail 3\"\n"
                              "along = \"x\"\n"
                              "value = \"0.5 mm\" # half\n"
                              "[[abs.symmetric]]\n"
                              "rails = [1, 2]\n";

CaseDocument read(const std::string& text) { return parseCase(text, "a.toml"); }
QStringList textsOf(const std::vector<InputProblem>& problems)
{
    QStringList texts;
    for (const InputProblem& each : problems) texts << QString::fromStdString(each.text());
    return texts;
}

class TestRelationText : public QObject {
    Q_OBJECT

private slots:
    void reads()
    {
        const CaseDocument document = read(rails + relations);
        QCOMPARE(textsOf(document.problems), QStringList());
        QCOMPARE(textsOf(document.warnings), QStringList());
        const AirBearingSurface& surface = document.value.surface;
        QVERIFY((surface.distances == std::vector<KeptDistance>{{{0, 2, true}, {1, 2, true}, false, 200e-6},
                                                                {{0, 1, false}, {2, 0, false}, true, 0.5e-3}}));
        QVERIFY((surface.symmetries == std::vector<KeptSymmetry>{{0, 1}}));
        QVERIFY((read(rails + "[[abs.symmetric]]\nrails = [3]").value.surface.symmetries ==
                 std::vector<KeptSymmetry>{{2, 2}}));
    }

    void namesTheProblem_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QByteArray& text, const char* says) {
            QTest::newRow(name) << text << "a.toml:" + QString(says);
        };
        const auto distance = [](const QByteArray& from, const QByteArray& rest = "along = 'x'\nvalue = 0\n") {
            return "[[abs.distance]]\nto = 'corner 1 of rail 2'\nfrom = " + from + "\n" + rest;
        };
        row("a rail that does not exist", distance("'corner 1 of rail 4'"),
            "12: abs.distance[1].from: rail 4 does not exist: there are 3 rails");
        row("a corner that does not exist", distance("'corner 4 of rail 3'"),
            "12: abs.distance[1].from: corner 4 does not exist: rail 3 has 3 corners");
        row("an edge 0", distance("'edge 0 of rail 3'"),
            "12: abs.distance[1].from: a place is \"corner 3 of rail 1\" or \"edge 2 of rail 1\"");
        row("a list as a place", distance("[1, 2]"),
            "12: abs.distance[1].from: a place is \"corner 3 of rail 1\" or \"edge 2 of rail 1\"");
        row("one place", distance("'corner 1 of rail 2'"), "10: abs.distance[1]: has from and to at one place");
        row("along", distance("'edge 1 of rail 3'", "along = 'z'\nvalue = 0\n"),
            "13: abs.distance[1].along: is neither \"x\" nor \"y\"");
        row("value", distance("'edge 1 of rail 3'", "along = 'x'\nvalue = '2 m'\n"),
            "14: abs.distance[1].value: 2 m is out of range: allowed is at most 1 m");
        row("unit", distance("'edge 1 of rail 3'", "along = 'x'\nvalue = '2 mg'\n"),
            "14: abs.distance[1].value: \"2 mg\" has the wrong unit; a length such as nm, um or mm is needed");
        row("a missing key", distance("'edge 1 of rail 3'", "along = 'x'\n"),
            "10: abs.distance[1]: needs from, to, along and value");
        row("an unknown key", "[[abs.symmetric]]\nrails = [1]\nrail = 2\n",
            "12: abs.symmetric[1].rail: unknown key; did you mean rails?");
        row("twice", (relations + relations.substr(relations.find("[[abs.sym"))).c_str(),
            "23: abs.symmetric[2]: repeats abs.symmetric[1]");
        row("other corners", "[[abs.symmetric]]\nrails = [1, 3]\n",
            "11: abs.symmetric[1].rails: has rails with 4 and 3 corners; mirror images have equally many");
        row("three rails", "[[abs.symmetric]]\nrails = [1, 2, 3]\n",
            "11: abs.symmetric[1].rails: is no list of one or two numbers of rails, such as [1, 2]");
        row("rail 0", "[[abs.symmetric]]\nrails = [0]\n",
            "11: abs.symmetric[1].rails: is no list of one or two numbers of rails, such as [1, 2]");
        row("one table", "[abs.symmetric]\nrails = [1]\n",
            "10: abs.symmetric: is one table; write [[abs.symmetric]] for each symmetry");
    }
    void namesTheProblem()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, says);
        QCOMPARE(textsOf(read(rails + text.toStdString()).problems), QStringList{says});
    }

    /// The shape is read as it is drawn, with a warning at the line of its table.
    void saysWhatIsNotObeyed()
    {
        std::string text = rails + relations;
        text.replace(text.find("200 um"), 6, "210 um");
        const CaseDocument document = read(text);
        QVERIFY(document.valid() && document.value.surface.rails == read(rails).value.surface.rails);
        QVERIFY(textsOf(document.warnings)
                    .contains(QStringLiteral("a.toml:11: abs.distance[1]: Kept distance 1 is off by 10000 nm.")));
    }

    /// 100 shapes with relations of any kind, written and read, whole and into a text with comments.
    void thereAndBack()
    {
        std::mt19937 engine(3);
        const auto below = [&engine](std::size_t count) { return engine() % count; };
        Case c = read(rails + relations).value;
        std::string text = rails + relations;
        for (int i = 0; i < 100; ++i) {
            AirBearingSurface& surface = c.surface;
            surface.distances.clear();
            surface.symmetries.clear();
            for (std::size_t k = 0; k < 5; ++k) {
                const RailPlace from{below(3), below(3), below(2) == 0}, to{below(3), below(3), below(2) == 0};
                const bool alongX = below(2) == 0;
                const bool repeated = std::ranges::any_of(surface.distances, [&](const KeptDistance& each) {
                    return each.alongX == alongX &&
                           ((each.from == from && each.to == to) || (each.from == to && each.to == from));
                });
                if (from == to || repeated) continue;
                surface.distances.push_back({from, to, alongX, static_cast<double>(below(1000)) * 1e-7 / 3.0});
            }
            if (below(2) == 0) surface.symmetries.push_back({below(2), 1});
            if (below(2) == 0) surface.symmetries.push_back({2, 2});
            QVERIFY(read(formatCase(c)).value == c);
            text = updateCaseText(text, c);
            QCOMPARE(textsOf(read(text).problems), QStringList());
            QVERIFY(read(text).value == c);
            QVERIFY(text.find("[[abs.rail]] # the lower one") != std::string::npos);
        }
    }
    void changesOnlyWhatChanged()
    {
        const std::string text = rails + relations;
        Case c = read(text).value;
        c.surface.distances[1].value = 0.6e-3;
        std::string expected = text;
        expected.replace(expected.find("\"0.5 mm\""), 8, "\"600 um\"");
        QCOMPARE(updateCaseText(text, c), expected);
        c.surface.distances[0].value = 1e-3;
        const auto changes = caseChanges(read(expected).value, c);
        QCOMPARE(changes.size(), std::size_t(1));
        QCOMPARE(changes[0].label, std::string("kept distance 1"));
        QVERIFY(sameFilm(c, read(rails).value) && c != read(rails).value);
    }
    /// A file of rails stays, and its relations stand in the case.
    void besideAFileOfRails()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path(folder.path().toStdString());
        Case c = read(rails).value;
        std::ofstream(path / "rail.dat") << formatCmlRails(c.slider.length, c.slider.width, 0.3e-3, c.surface);
        const std::string text = "model = 'film'\n[abs]\nrails = 'rail.dat' # mine\n";
        const CaseDocument document = parseCase(text, "a.toml", path);
        QCOMPARE(textsOf(document.problems), QStringList());
        Case changed = document.value;
        changed.surface.symmetries = {{0, 1}};
        const std::string updated = updateCaseText(text, changed, path);
        QVERIFY(updated.find("rail.dat' # mine") != std::string::npos);
        QVERIFY(parseCase(updated, "a.toml", path).value == changed);
        changed.surface.rails.pop_back();
        QVERIFY(read(updateCaseText(updated, changed, path)).value.surface == changed.surface);
    }

    /// --set abs.distance[2].value: rail 3 moves, rail 1 stays.
    void aValueIsSet()
    {
        Case c = read(rails + relations).value;
        const auto parameter = std::get<Parameter>(caseKey(c, "abs.distance[2].value"));
        QVERIFY(!setFromText(c, parameter, "600 um"));
        QVERIFY(std::abs(c.surface.rails[2].points[1].x - 1e-3) < 1e-14);
        QCOMPARE(c.surface.rails[0].points[1].x, 0.3e-3);
    }
};

TOUCHDOWN_TEST(TestRelationText)

} // namespace test_relation_text

#include "test_relation_text.moc"
