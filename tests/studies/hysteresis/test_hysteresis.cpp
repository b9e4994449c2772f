// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case_files/case_file.h"
#include "core/formats/toml_document.h"
#include "core/studies/study_plan.h"
#include "tests/support/small_slider.h"
#include "tests/support/study_cells.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_hysteresis {

StudyPlan planOf(const Case& c, const std::string& text) { return parseStudy("hysteresis", text, "study", {}, &c); }

StudyReport performed(const Case& c, const std::string& text, int jobs = 2, const StudyCallback& callback = {})
{
    const StudyPlan plan = planOf(c, text);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(jobs, callback);
}

bool says(const StudyReport& report, const std::string& part)
{
    return std::ranges::any_of(report.findings,
                               [&](const std::string& each) { return each.find(part) != std::string::npos; });
}

bool hasSeries(const StudyReport& report, const std::string& name)
{
    for (const StudyChart& chart : report.charts)
        for (const ChartPanel& panel : chart.panels)
            for (const ChartSeries& series : panel.series)
                if (series.name == name) return true;
    return false;
}

class TestHysteresis : public QObject {
    Q_OBJECT

private slots:
    /// The default slider, set lower and lower: it falls where its static height is d_s = 3 nm, and is caught until the
    /// menisci break.
    void defaultCaseHasALoop()
    {
        const StudyReport report = performed(Case{}, templateText(hysteresisForm(Case{})));
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(report.findings.front().starts_with("Forced"));
        QVERIFY(says(report, "Touch-down at 3.132 nm"));
        QVERIFY(says(report, "ends at 3 nm"));
        QVERIFY(says(report, "Take-off"));
        QVERIFY(says(report, "Hysteresis from"));
        for (const char* name : {"held, falling", "held, rising", "stable equilibria", "ends at a switch of the law"})
            QVERIFY2(hasSeries(report, name), name);
        QCOMPARE(table(report, "steps").rows.size(), std::size_t(82));
        for (const StudyTable& each : report.tables)
            for (const auto& row : each.rows) {
                QCOMPARE(row.size(), each.columns.size());
                for (const StudyValue& value : row)
                    if (const auto* number = std::get_if<double>(&value)) QVERIFY(std::isfinite(*number));
            }
    }

    void sameWithOneThreadOrTwo_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("there and back") << "parameter = \"ono_yamane.meniscus_force\"\nfrom = \"50 mN\"\nto = \"0 "
                                           "mN\"\nsteps = 6\nhold = \"0.2 ms\"\n";
        QTest::newRow("each anew") << "parameter = \"initial.flying_height\"\nfrom = \"1 nm\"\nto = \"250 nm\"\nsteps "
                                      "= 6\nhold = \"0.2 ms\"\n";
    }
    void sameWithOneThreadOrTwo()
    {
        QFETCH(QString, text);
        const StudyReport one = performed(Case{}, text.toStdString(), 1),
                          two = performed(Case{}, text.toStdString(), 2);
        QCOMPARE(one.findings, two.findings);
        QCOMPARE(one.warnings, two.warnings);
        for (std::size_t i = 0; i < one.tables.size(); ++i) QVERIFY(one.tables[i].rows == two.tables[i].rows);
    }

    /// A pad ahead of the mass centre, pressed for good, flutters from some friction on: see the test of the
    /// equilibria.
    void tellsSelfExcitation()
    {
        Case c;
        c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
        c.springs.flyingHeight = 1e-9;
        c.springs.pitch = 0.0;
        c.slider.thickness = 1e-3;
        c.suspension.stiffness = 1e6;
        c.suspension.pitchStiffness = 0.9;
        c.suspension.dampingRatio = c.suspension.pitchDampingRatio = 0.01;
        c.springs.padDistance = -0.3e-3;
        c.onoYamane.meniscusForce = 0.0;
        c.initial.flyingHeight = 1e-9;
        const StudyReport report =
            performed(c, "parameter = \"ono_yamane.friction\"\nfrom = 0.5\nto = 0.7\nsteps = 4\nhold = \"0.1 ms\"\n");
        QVERIFY(report.findings.front().starts_with(
            "Self-excited: an equilibrium is unstable by an oscillation that grows"));
        QVERIFY(hasSeries(report, "Hopf points"));
        QVERIFY(hasSeries(report, "unstable equilibria"));
    }

    void startsAreFresh()
    {
        const StudyReport report = performed(
            Case{},
            "parameter = \"initial.flying_height\"\nfrom = \"20 nm\"\nto = \"250 nm\"\nsteps = 4\nhold = \"0.5 ms\"\n");
        QCOMPARE(table(report, "steps").rows.size(), std::size_t(5));
        QVERIFY(hasSeries(report, "end states"));
        QVERIFY(says(report, "Started anew at each value, the slider ends flying in "));
        QVERIFY(says(report, "5 runs"));
    }

    /// From its own start, 250 nm, the default slider flies at 7 nm: moved there and back through lower heights it
    /// would be caught on the way.
    void anyValueMayBeginAnew()
    {
        const char* range = "parameter = \"springs.flying_height\"\nfrom = \"2 nm\"\nto = \"7 nm\"\nsteps = 10\nhold = "
                            "\"2 ms\"\nequilibria = false\n";
        const auto last = [&](const StudyReport& report, std::size_t row) {
            return std::get<std::string>(table(report, "steps").rows[row][2]);
        };
        const StudyReport anew = performed(Case{}, std::string(range) + "anew = true\n"),
                          carried = performed(Case{}, range);
        QCOMPARE(table(anew, "steps").rows.size(), std::size_t(11));
        QCOMPARE(std::get<std::string>(table(anew, "steps").rows[0][0]), std::string("anew"));
        QCOMPARE(last(anew, 10), std::string("flying"));
        QCOMPARE(table(carried, "steps").rows.size(), std::size_t(22));
        QCOMPARE(last(carried, 10), std::string("contact"));
        QVERIFY(says(anew, "Started anew at each value"));
    }

    /// Over a disk that is not flat the values of springs are held; their equilibria are refused.
    void equilibriaOfSpringsNeedAFlatDisk()
    {
        Case c;
        c.diskSurface.kind = DiskSurfaceKind::Waves;
        c.diskSurface.waveAmplitudes = {0.2e-9};
        c.diskSurface.waveLengths = {100e-6};
        const std::string range = "steps = 1\nhold = \"20 us\"\n";
        const StudyPlan asked = planOf(c, range + "equilibria = true\n");
        QVERIFY(!asked.valid());
        QCOMPARE(asked.problems.front().key, std::string("equilibria"));
        const StudyReport report = performed(c, range);
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(std::ranges::none_of(report.tables, [](const StudyTable& t) { return t.name == "equilibria"; }));
    }

    /// A film's branches lie on one grid, which does not fit a slider of another length.
    void sizesOfAFilmsSliderAreHeldAlone()
    {
        Case c = test::smallSlider(33);
        c.contact = ContactKind::OnoYamane;
        for (const std::string key : {"slider.length", "slider.width"}) {
            const std::string range =
                "parameter = \"" + key + "\"\nfrom = \"1 mm\"\nto = \"1.01 mm\"\nsteps = 1\nhold = \"1 us\"\n";
            QVERIFY(planOf(c, range).valid());
            const StudyPlan asked = planOf(c, range + "equilibria = true\n");
            QVERIFY(!asked.valid());
            QVERIFY(asked.problems.front().text().find("one grid over the slider, which " + key + " would change") !=
                    std::string::npos);
        }
        c.degreesOfFreedom = 2;
        c.initial.state = InitialState::Static;
        const StudyReport report = performed(
            c, "parameter = \"slider.width\"\nfrom = \"0.8 mm\"\nto = \"0.81 mm\"\nsteps = 1\nhold = \"1 us\"\n");
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(std::ranges::any_of(report.warnings, [](const std::string& each) {
            return each.starts_with("equilibria of a film are followed on one grid");
        }));
        QVERIFY(!hasSeries(report, "stable equilibria"));
    }

    void filmIsHeld()
    {
        Case c = test::smallSlider(33);
        c.degreesOfFreedom = 2;
        c.contact = ContactKind::OnoYamane;
        c.onoYamane.touchDown = 5e-9;
        c.onoYamane.takeOff = 8e-9;
        c.initial.state = InitialState::Static;
        const StudyReport report = performed(
            c, "parameter = \"disk.speed\"\nfrom = \"7200 rpm\"\nto = \"7000 rpm\"\nsteps = 1\nhold = \"1 us\"\n");
        QCOMPARE(report.status, StudyStatus::Completed);
        QCOMPARE(table(report, "steps").rows.size(), std::size_t(4));
        for (const auto& row : table(report, "steps").rows)
            QCOMPARE(std::get<std::string>(row[2]), std::string("flying"));
        // At both values it flies at the static state; on so few cells its stability means little, and the study says
        // so.
        QVERIFY(table(report, "equilibria").rows.size() >= 2);
        QVERIFY(std::ranges::any_of(report.warnings, [](const std::string& each) {
            return each.find("fewer than six cells") != std::string::npos;
        }));
    }

    void stopsAtOnce()
    {
        int calls = 0;
        const StudyReport report = performed(Case{}, "hold = \"1 s\"\n", 2, [&](const StudyProgress& progress) {
            ++calls;
            return progress.share < 0.0;
        });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QVERIFY(!report.message.empty());
        QCOMPARE(calls, 1);
    }

    void saysWhatIsWrong_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        QTest::newRow("unknown parameter") << "parameter = \"springs.flying_hight\"\nfrom = 1\nto = 2"
                                           << "parameter";
        QTest::newRow("no number") << "parameter = \"springs.potential\"\nfrom = 1\nto = 2"
                                   << "parameter";
        QTest::newRow("of the computation") << "parameter = \"run.step\"\nfrom = \"1 ns\"\nto = \"2 ns\""
                                            << "parameter";
        QTest::newRow("no end") << "parameter = \"ono_yamane.friction\"\nfrom = 0.1"
                                << "to";
        QTest::newRow("out of range") << "parameter = \"ono_yamane.friction\"\nfrom = -0.1\nto = 1"
                                      << "from";
        QTest::newRow("no valid case there") << "from = \"7 nm\"\nto = \"-5 nm\""
                                             << "to";
        QTest::newRow("nothing to move") << "from = \"7 nm\"\nto = \"7 nm\""
                                         << "to";
        QTest::newRow("unknown key") << "stepz = 3"
                                     << "stepz";
        QTest::newRow("a start cannot be carried over")
            << "parameter = \"initial.flying_height\"\nfrom = \"5 nm\"\nto = \"9 nm\"\nanew = false"
            << "anew";
    }
    void saysWhatIsWrong()
    {
        QFETCH(QString, text);
        QFETCH(QString, key);
        const StudyPlan plan = planOf(Case{}, text.toStdString());
        QCOMPARE(plan.problems.size(), std::size_t(1));
        QCOMPARE(plan.problems.front().key, key.toStdString());
    }

    void aPadAloneIsNotStudied()
    {
        const StudyPlan plan = planOf(openCase("contact_hertz").value, "");
        QCOMPARE(plan.problems.size(), std::size_t(1));
    }

    void aSliderThatIsHeldIsNotStudied()
    {
        const StudyPlan plan = planOf(openCase("film_plane").value, "");
        QVERIFY(!plan.valid());
        QVERIFY(plan.problems.front().message.find("steady.fixed_attitude") != std::string::npos);
    }

    /// On 193 x 193 nodes 14 runs of at most 5 s per node and second of the run: 200 us take 5 14 200e-6 37249 s = 521
    /// s, which is 9 min; and at least a tenth of it.
    void aFilmsTemplateSaysWhatItCosts()
    {
        const std::string text = templateText(hysteresisForm(openCase("film_plane").value));
        QVERIFY2(text.starts_with("# 14 runs of the film take some 0.9 to 9 min"), text.c_str());
        QVERIFY(text.find("hold = \"200 us\"") != std::string::npos);
        QVERIFY(templateText(hysteresisForm(Case{})).starts_with("parameter"));
    }

    void templatesAreValid_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"fig10a", "table3_3nm_from_100nm", "textbook_oscillator", "textbook_bounce",
                                 "springs_waviness", "film_pico", "fig06_de_4nm", "fig02_micro_pad_case_2_moving"})
            QTest::newRow(name) << name;
    }
    void templatesAreValid()
    {
        QFETCH(QString, name);
        const Case c = openCase(name.toStdString()).value;
        const StudyPlan plan = planOf(c, templateText(hysteresisForm(c)));
        QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
        QVERIFY(planOf(c, "").valid());
    }
};

TOUCHDOWN_TEST(TestHysteresis)

} // namespace test_hysteresis

#include "test_hysteresis.moc"
