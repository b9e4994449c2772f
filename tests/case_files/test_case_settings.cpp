// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_settings.h"

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_case_settings {

std::string problemsOf(const CaseDocument& document)
{
    std::string all;
    for (const InputProblem& problem : document.problems) all += problem.text() + '\n';
    return all;
}

class TestCaseSettings : public QObject {
    Q_OBJECT

private slots:
    /// Numbers of the surface by their keys; the text that a results file keeps is that of the changed case.
    void surface()
    {
        const CaseDocument before = openCase("film_fig4_pico");
        CaseDocument document = before;
        applySettings(document,
                      {"abs.rail[4].recess=10 nm", "abs.rail[4].point[1].x = 1.185 mm", "abs.rail[4].wall[2]=1",
                       "abs.wall[2].recess[1]=0.3 um", "abs.points_of_interest[2].y=0.4 mm"});
        QCOMPARE(problemsOf(document), std::string());
        Case expected = before.value;
        expected.surface.rails[3].recess[0] = 10e-9;
        expected.surface.rails[3].points[0].x = 1.185e-3;
        expected.surface.rails[3].points[1].wall = 1;
        expected.surface.walls[1].recess[0] = 0.3e-6;
        expected.surface.pointsOfInterest[1].y = 0.4e-3;
        QVERIFY(document.value == expected);
        QVERIFY(document.unused.empty());
        const CaseDocument again = parseCase(document.text, "again", document.folder);
        QCOMPARE(problemsOf(again), std::string());
        QVERIFY(again.value.surface == expected.surface);
        Case changed = before.value;
        QVERIFY(!changeCase(changed, {{"abs.rail[4].recess", "10 nm"}}));
        QCOMPARE(changed.surface.rails[3].recess[0], 10e-9);
    }

    void wrong_data()
    {
        QTest::addColumn<QString>("setting");
        QTest::addColumn<QString>("problem");
        QTest::newRow("no such rail") << "abs.rail[5].recess=1 nm"
                                      << "--set: abs.rail[5].recess: there is no rail 5; the case has 4";
        QTest::newRow("no such number") << "abs.rail[1].depth=1 nm"
                                        << "--set: abs.rail[1].depth: is none of the numbers abs.rail[N].recess, ";
        QTest::newRow("no such wall") << "abs.rail[1].wall[1]=3"
                                      << "--set: abs.rail[1].wall[1]: 3 is out of range: allowed is ";
        QTest::newRow("unit") << "abs.rail[1].recess=1 mN"
                              << "--set: abs.rail[1].recess: ";
        QTest::newRow("far away") << "abs.rail[1].point[2].x=1100 mm"
                                  << "--set: abs.rail[1].point[2].x: 1.1 m is out of range: allowed is at least -1 m";
        QTest::newRow("an outline that crosses itself") << "abs.rail[4].point[1].y=0.6 mm"
                                                        << "Rail 4";
        QTest::newRow("no list") << "abs.rial[1].recess=1 nm"
                                 << "--set: abs.rial[1].recess: is no key of a case";
    }
    void wrong()
    {
        QFETCH(QString, setting);
        QFETCH(QString, problem);
        CaseDocument document = openCase("film_fig4_pico");
        applySettings(document, {setting.toStdString()});
        QVERIFY(!document.valid());
        const QString all = QString::fromStdString(problemsOf(document));
        QVERIFY2(all.contains(problem), qPrintable(all));
        QCOMPARE(document.problems.size(), std::size_t(1));
        Case c = openCase("film_fig4_pico").value;
        const Case before = c;
        const qsizetype equals = setting.indexOf(QLatin1Char('='));
        QVERIFY(changeCase(c, {{setting.left(equals).toStdString(), setting.mid(equals + 1).toStdString()}}));
        QVERIFY(c == before);
    }

    /// A stretch by nearly nothing, then corners on one another: one sentence, no more.
    void aRailWithoutExtent()
    {
        CaseDocument document = openCase("film_fig4_pico");
        applySettings(document,
                      {"abs.rail[4].length=0.03 mm", "abs.rail[4].point[1].x=1.2 mm", "abs.rail[4].point[2].x=1.2 mm",
                       "abs.rail[4].point[3].x=1.2 mm", "abs.rail[4].point[4].x=1.2 mm"});
        QVERIFY2(problemsOf(document).find("Rail 4 has no area") != std::string::npos, problemsOf(document).c_str());
    }
    /// As they are from a file.
    void warningsOfTheSurface()
    {
        CaseDocument document = openCase("film_fig4_pico");
        QVERIFY(document.warnings.empty());
        applySettings(document, {"abs.points_of_interest[1].x=3 mm"});
        QCOMPARE(document.warnings.size(), std::size_t(1));
        QVERIFY(document.warnings.front().message.find("outside the slider") != std::string::npos);
        applySettings(document, {"abs.points_of_interest[1].x=1 mm"});
        QVERIFY(document.warnings.empty());
    }

    /// A film has three degrees of freedom and no contact law, unless the text or a setting states them. In springs,
    /// which have two, the values of the other model are not kept either.
    void aModelBringsItsDefaults()
    {
        const auto with = [](const std::string& text, const std::vector<std::string>& settings) {
            CaseDocument document = parseCase(text, "a.toml");
            applySettings(document, settings);
            const CaseDocument again = parseCase(document.text, "again");
            if (!(again.value == document.value)) qFatal("the text is of another case");
            return document.value;
        };
        const Case film = with("model = 'springs'\n", {"model=film"});
        QCOMPARE(film.degreesOfFreedom, 3);
        QCOMPARE(film.contact, ContactKind::None);
        QVERIFY(film == defaultsOf(ModelKind::Film));
        QVERIFY(with("model = 'film'\n", {"model=springs"}) == defaultsOf(ModelKind::Springs));
        QCOMPARE(with("", {"degrees_of_freedom=2", "model=film"}).degreesOfFreedom, 2);
        QCOMPARE(with("", {"model=film", "degrees_of_freedom=2"}).degreesOfFreedom, 2);
        QCOMPARE(with("degrees_of_freedom = 2\n", {"model=film"}).degreesOfFreedom, 2);
        QCOMPARE(with("contact = 'ono-yamane'\n", {"model=film"}).contact, ContactKind::OnoYamane);
    }

    /// A springs case has no rails.
    void notOfThisModel()
    {
        CaseDocument document = openCase("fig10a");
        applySettings(document, {"abs.rail[1].recess=1 nm"});
        QCOMPARE(problemsOf(document), std::string("--set: abs.rail[1].recess: there is no rail 1; the case has 0\n"));
    }
};

TOUCHDOWN_TEST(TestCaseSettings)

} // namespace test_case_settings

#include "test_case_settings.moc"
