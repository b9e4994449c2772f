// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_run_file.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/cml_sample.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_run_file {

struct Reading {
    Case value = defaultsOf(ModelKind::Film);
    CmlParameters parameters{value};
    explicit Reading(const std::string& text)
    {
        parameters.beginFile("run.dat");
        readCmlRun(text, parameters);
    }
    QByteArray problems() const { return joined(parameters.problems); }
    QByteArray warnings() const { return joined(parameters.warnings); }
};

/// The line below the first one that begins with a heading.
std::string withValues(std::string_view heading, std::string_view values)
{
    const std::string text = cmlRunText();
    return withLine(text, lineOf(text, heading) + 1, values);
}

class TestCmlRunFile : public QObject {
    Q_OBJECT

private slots:
    void theSampleSaysItsCase()
    {
        const Reading r(cmlRunText());
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(r.warnings(), QByteArray());
        const Case& c = r.value;
        QCOMPARE(c.model, ModelKind::Film);
        QCOMPARE(c.contact, ContactKind::None);
        QCOMPARE(c.degreesOfFreedom, 3);
        QCOMPARE(c.steady.stiffness, false);
        QCOMPARE(c.steady.fixedAttitude, false);
        QCOMPARE(c.film.grid, GridKind::Uniform);
        QCOMPARE(c.initial.nominalTrailingEdgeHeight, 8e-9);
        QCOMPARE(c.initial.pitch, 1.2e-4);
        QCOMPARE(c.initial.roll, -2e-6);
        QCOMPARE(c.disk.radius, 23e-3);
        QCOMPARE(c.disk.skew, 12.5 * std::numbers::pi / 180.0);
        QCOMPARE(c.disk.speed, 7200.0 * std::numbers::pi / 30.0);
        QCOMPARE(c.disk.field, VelocityField::Rotating);
        QVERIFY(c.steady.radii.empty() && c.steady.skews.empty() && c.steady.speeds.empty());
        QVERIFY(c.steady.altitudes.empty());
        QCOMPARE(c.air.source, AirSource::Given);
        QCOMPARE(c.air.given.pressure, 99000.0);
        QCOMPARE(c.air.given.meanFreePath, 65e-9);
        QCOMPARE(c.air.given.viscosity, 1.82e-5);
        QCOMPARE(c.air.temperature, 313.15);
        QCOMPARE(c.suspension.preload, 1.5e-3 * 9.80665);
        QCOMPARE(c.suspension.offsetX, 1e-5);
        QCOMPARE(c.suspension.offsetY, -2e-5);
        QCOMPARE(c.suspension.staticPitch, 1e-3);
        QCOMPARE(c.suspension.staticRoll, -5e-4);
        QCOMPARE(c.suspension.holdsAttitude, true);
        QCOMPARE(c.suspension.pitchTorque, 0.5e-6);
        QCOMPARE(c.suspension.rollTorque, -0.1e-6);
        QCOMPARE(c.suspension.pitchStiffness, 1.2e-4);
        QCOMPARE(c.suspension.rollStiffness, 1.1e-4);
        QCOMPARE(c.steady.loadTolerance, 1e-5);
        QCOMPARE(c.film.nodes, (std::array<int, 2>{97, 81}));
        QCOMPARE(c.film.scheme, ConvectionScheme::Hybrid);
        QCOMPARE(c.air.slip.model, SlipModel::FirstOrder);
        QCOMPARE(c.air.slip.accommodation, 0.8);
        QCOMPARE(c.film.tolerance, 1e-8);
        QCOMPARE(c.steady.sensitivities, true);
        QCOMPARE(c.steady.shearArm, 1.0); // what the established program does
        QCOMPARE(QByteArray::fromStdString(r.parameters.comments).trimmed(),
                 QByteArray("drawn for tests, pad of 5 \xb5m"));
    }

    void otherSpellings_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QByteArray::fromStdString(text);
        };
        const std::string text = cmlRunText();
        row("Windows line ends", withLineEnds(text, "\r\n"));
        row("no last line end", text.substr(0, text.size() - 1));
        row("blank lines between", withLineEnds(text, "\n \n"));
        row("no blank lines", [&] {
            std::string result = text;
            for (const char* blank : {"\n\n", "\n \n"})
                for (auto at = result.find(blank); at != std::string::npos; at = result.find(blank))
                    result.replace(at, std::string_view(blank).size(), "\n");
            return result;
        }());
        row("numbers broken over lines", withValues("f0(kg)", "1.5E-3 1.0E-5\n-2.0E-5\n1.0E-3\n-5.0E-4 1"));
        row("Fortran's double precision", withValues("f0(kg)", "1.5D-3 1.0D-5 -.2D-4 1.D-3 -5.0d-04 1"));
        row("remarks behind the numbers", withValues("hm(m)", "8e-9 1.2e-4 -2e-6 ! 3 4"));
        row("no comments", text.substr(0, text.find("***************Comments")));
    }
    void otherSpellings()
    {
        QFETCH(QByteArray, text);
        const Reading r(text.toStdString());
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(r.warnings(), QByteArray());
        QCOMPARE(firstDifference(r.value, Reading(cmlRunText()).value), std::string());
    }

    void switches_data()
    {
        QTest::addColumn<QByteArray>("heading");
        QTest::addColumn<QByteArray>("values");
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<QByteArray>("value");
        const auto row = [](const char* name, const char* heading, const char* values, const char* key,
                            const char* value) {
            QTest::newRow(name) << QByteArray(heading) << QByteArray(values) << QByteArray(key) << QByteArray(value);
        };
        row("stiffness", "istiff", "1 1 0 0 1", "steady.stiffness", "true");
        row("fixed attitude", "istiff", "0 0 0 0 1", "steady.fixed_attitude", "true");
        row("adapted grid", "istiff", "0 1 0 1 1", "film.grid", "adapted");
        row("adapted anew for each run", "istiff", "0 1 0 2 1", "film.grid", "adapted");
        row("upwind", "ischeme", "0 1 1e-8 6 6", "film.scheme", "upwind");
        row("power law", "ischeme", "2 1 1e-8 6 6", "film.scheme", "complete-flux");
        row("continuum", "ischeme", "2 0 1e-8 6 6", "air.slip", "continuum");
        row("second order", "ischeme", "2 2 1e-8 6 6", "air.slip", "second-order");
        row("Fukui-Kaneko", "ischeme", "2 3 1e-8 6 6 1 4", "air.slip", "fukui-kaneko");
        row("no sensitivities", "crowninc", "0 0 0.0", "steady.sensitivities", "false");
        row("standard air", "output_shear", "1 0 1", "air.source", "established-standard");
        row("old load", "f0(kg)", "2E-3 0 0", "suspension.preload", "2 gf");
        row("torques", "f0(kg)", "2E-3 0 0 1 1 0", "suspension.holds_attitude", "false");
        row("ghosts of a grid", "nx ", "98 80", "film.nodes", "97, 81");
    }
    void switches()
    {
        QFETCH(QByteArray, heading);
        QFETCH(QByteArray, values);
        QFETCH(QByteArray, key);
        QFETCH(QByteArray, value);
        const Reading r(withValues(heading.toStdString(), values.toStdString()));
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(QByteArray::fromStdString(toText(r.value, *findParameter(key.toStdString()))), value);
    }

    void severalRuns()
    {
        const std::string text = cmlRunText();
        const std::size_t begin = text.find(" 1             1              1              0");
        const std::size_t end = text.find("***************Air");
        const std::string runs = "3 2 2 1\nradii(m)\n2.0E-2\n2.5E-2 3.0E-2\nskews(deg)\n-10 0 10\nRPMs\n5400 7200\n"
                                 "altitudes(m)\n0 3000\n";
        std::string several = text.substr(0, begin) + runs + text.substr(end);
        const Reading given(several);
        QCOMPARE(given.problems(), QByteArray());
        QCOMPARE(given.warnings(), QByteArray("run.dat:20: Runs: the altitudes do not count without use_standard_air; "
                                              "the file's air is taken"));
        QCOMPARE(given.value.steady.radii, (std::vector<double>{0.02, 0.025, 0.03}));
        QCOMPARE(given.value.steady.skews.size(), std::size_t(3));
        QCOMPARE(given.value.steady.skews[0], -10.0 * std::numbers::pi / 180.0);
        QCOMPARE(given.value.steady.speeds[1], 7200.0 * std::numbers::pi / 30.0);
        QVERIFY(given.value.steady.altitudes.empty());
        QCOMPARE(given.value.disk.radius, 0.02);

        const Reading standard(replaced(several, "  0              0              0\n", "0 0 1\n"));
        QCOMPARE(standard.warnings(), QByteArray());
        QCOMPARE(standard.value.steady.altitudes, (std::vector<double>{0.0, 3000.0}));
        QCOMPARE(standard.value.air.source, AirSource::EstablishedStandard);
    }
    void oneAltitude()
    {
        const std::string high = withValues("altitudes", "3000");
        const Reading standard(replaced(high, "  0              0              0\n", "0 0 1\n"));
        QCOMPARE(standard.value.air.source, AirSource::Atmosphere);
        QCOMPARE(standard.value.air.altitude, 3000.0);
        const Reading given(high);
        QCOMPARE(given.value.air.source, AirSource::Given);
        QCOMPARE(given.value.air.altitude, 0.0);
        QVERIFY(given.warnings().contains("run.dat:19: Runs: the altitudes do not count"));
        // No altitude at all, and a line that is blank.
        const std::string none = replaced(withValues("altitudes", ""), " 1             1              1 ",
                                          " 1             1              0 ");
        QCOMPARE(Reading(none).problems(), QByteArray());
    }

    void notModelled_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("warning");
        const auto row = [](const char* name, const std::string& text, const char* warning) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(warning);
        };
        row("geometry only", withValues("istiff", "0 2 0 0 1"),
            "run.dat:3: Solution Control: not modelled: geometry only or its extrapolation (isolv = 2)");
        row("an existing grid", withValues("istiff", "0 1 1 0 1"),
            "run.dat:3: Solution Control: not modelled: an existing grid (ioldg)");
        row("grid sections and symmetry", withValues("nsx  ", "3 1 1"),
            "run.dat:28: Grid Control: not modelled: grid sections (nsx, nsy), symmetry (isymm); the whole width is "
            "solved");
        row("other numbers of nodes", withValues("nx ", "100 81"),
            "run.dat:28: Grid Control: not modelled: 100 x 81 grid lines; 97 x 81 are taken");
        row("refined bands", withValues("numXRegions", "1"),
            "run.dat:50: Mesh Refinement in X Direction: not modelled: refined bands (1)");
        row("accommodation", withValues("ischeme", "2 3 1e-8 6 6 0.8 4"),
            "run.dat:58: Reynolds Equation: not modelled: the power law as such; complete-flux is taken, film.scheme = "
            "power-law compares, the accommodation coefficient = 0.8 with this slip model");
        row("asperity contact", withValues("icmodel", "1 3e-10 1e12 1e-19 1e-76"),
            "run.dat:61: Partial Contact: not modelled: partial contact (icmodel = 1)");
        row("electric potential", withValues("rdsasp", "1e-8 1e10 1e12 0.5"),
            "run.dat:61: Partial Contact: not modelled: an electric potential (elecpot)");
        row("intermolecular forces, as of old", withValues("icmodel", "3 3e-10 1e12"),
            "run.dat:61: Partial Contact: not modelled: intermolecular forces (icmodel = 3)");
        row("intermolecular forces", withValues("output_shear", "0 1 0"),
            "run.dat:77: Additional Parameters: not modelled: intermolecular forces (use_imf)");
        row("humidity", withValues("do_humidity", "1 40 50"),
            "run.dat:77: Additional Parameters: not modelled: humidity");
        row("an unknown parameter",
            replaced(cmlRunText(), "***************Comments", "stagger\n2\n***************Comments"),
            "run.dat:77: Additional Parameters: not modelled: stagger = 2");
        row("an unknown section",
            replaced(cmlRunText(), "***************Sens", "*****SBL_params*****\nlube(m)\n1e-9\n***************Sens"),
            "run.dat:68: SBL_params: an unknown section, which is not used");
        row("a section twice",
            replaced(cmlRunText(), "***************Sens",
                     "***Air***\np0 al vis\n99000 65e-9 1.82e-5\n***************Sens"),
            "run.dat:68: Air: is there twice; the last one counts");
        row("no word on the air", cmlRunText().substr(0, cmlRunText().find("***********************Additional")),
            "run.dat:22: Air Parameters: the air of the file is used, because the file does not contain "
            "use_standard_air");
    }
    void notModelled()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, warning);
        const Reading r(text.toStdString());
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(r.warnings(), warning);
    }

    void malformed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem");
        const std::string text = cmlRunText();
        const auto row = [](const char* name, const std::string& changed, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(changed) << QByteArray(problem);
        };
        row("empty", "", "run.dat: is empty");
        row("binary", std::string("\0\1\2", 3), "run.dat:1: holds bytes that no text holds; it may be a binary file");
        row("a word for a number", withValues("hm(m)", "8e-9 steep 0"),
            "run.dat:8: Intial Attitude: the pitch must be a number, not \"steep\"");
        row("a word for the first number", withValues("hm(m)", "low 0 0"),
            "run.dat:8: Intial Attitude: hm must be a number, not \"low\"");
        row("not a number", withValues("p0(pa)", "NaN 6e-8 1.8e-5"),
            "run.dat:22: Air Parameters: p0 must be a number, not \"NaN\"");
        row("infinite", withValues("p0(pa)", "1e5 inf 1.8e-5"),
            "run.dat:22: Air Parameters: the mean free path must be a number, not \"inf\"");
        row("a number too few", withValues("p0(pa)", "1e5 6e-8"),
            "run.dat:22: Air Parameters: the section ends where the viscosity is needed");
        row("no air", withValues("p0(pa)", "0 6e-8 1.8e-5"),
            "run.dat:22: air.pressure: 0 kPa is out of range: allowed is at least 1 Pa, at most 1e8 Pa");
        row("two billion radii", withValues("irad", "2000000000 1 1"),
            "run.dat:11: Runs: the number of radii must be a whole number from 1 to 1000, not \"2000000000\"");
        row("no radius", withValues("irad", "0 1 1"),
            "run.dat:11: Runs: the number of radii must be a whole number from 1 to 1000, not \"0\"");
        row("a radius that is missing", withValues("irad", "2 1 1"),
            "run.dat:14: Runs: a radius must be a number, not \"skews(deg)\"");
        row("a speed that is missing", withValues("irad", "1 3 1"),
            "run.dat:18: Runs: a speed must be a number, not \"altitudes(m)\"");
        row("an altitude that is missing", withValues("irad", "1 1 5"),
            "run.dat:19: Runs: the section ends where an altitude is needed");
        row("a radius beyond the disk", withValues("radii", "23"),
            "run.dat:13: disk.radius: 23 m is out of range: allowed is greater than 0 mm, at most 1 m");
        row("two billion nodes", withValues("nx ", "2000000000 97"),
            "run.dat:30: Grid Control: the number of grid lines must be a whole number from 2 to 1000000, not "
            "\"2000000000\"");
        row("a negative number of nodes", withValues("nx ", "-97 97"),
            "run.dat:30: Grid Control: the number of grid lines must be a whole number from 2 to 1000000, not \"-97\"");
        row("an unknown scheme", withValues("ischeme", "7 3 1e-7"),
            "run.dat:60: Reynolds Equation: ischeme must be a whole number from 0 to 2, not \"7\"");
        row("an unknown slip model", withValues("ischeme", "2 4 1e-7"),
            "run.dat:60: Reynolds Equation: the slip model must be a whole number from 0 to 3, not \"4\"");
        row("half a switch", withValues("istiff", "0.5 1 0 0"),
            "run.dat:5: Solution Control: istiff must be a whole number from 0 to 9, not \"0.5\"");
        row("a switch of two billion", withValues("nsx  ", "1 1 2000000000"),
            "run.dat:32: Grid Control: isymm must be a whole number from 0 to 9, not \"2000000000\"");
        row("half of a new load", withValues("f0(kg)", "1e-3 0 0 0"),
            "run.dat:26: Load Parameters: rsa must be a number, not \"xfs(?NM)\"");
        row("no load", withValues("f0(kg)", ""), "run.dat:26: Load Parameters: f0 must be a number, not \"xfs(?NM)\"");
        row("a heading alone", firstLines(text, 21),
            "run.dat:21: Air Parameters: the section ends where p0 is needed\n"
            "run.dat:21: the file ends without the section \"Load Parameters\"\n"
            "run.dat:21: the file ends without the section \"Grid Control\"\n"
            "run.dat:21: the file ends without the section \"Reynolds Equation\"");
        row("a section's line alone", firstLines(text, 57) + "***Reynolds***",
            "run.dat:58: Reynolds: the section ends where ischeme is needed");
        row("rails in place of runs", cmlRailText(),
            "run.dat:32: the file ends without the section \"Solution Control\"\n"
            "run.dat:32: the file ends without the section \"Initial Attitude\"\n"
            "run.dat:32: the file ends without the section \"Runs\"\n"
            "run.dat:32: the file ends without the section \"Air Parameters\"\n"
            "run.dat:32: the file ends without the section \"Load Parameters\"\n"
            "run.dat:32: the file ends without the section \"Grid Control\"\n"
            "run.dat:32: the file ends without the section \"Reynolds Equation\"");
        row("two problems", replaced(withValues("hm(m)", "low 0 0"), "7.2000E+003", "fast"),
            "run.dat:8: Intial Attitude: hm must be a number, not \"low\"\n"
            "run.dat:17: Runs: a speed must be a number, not \"fast\"");
    }
    void malformed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        QCOMPARE(Reading(text.toStdString()).problems(), problem);
    }

    void cutAtEveryLine()
    {
        const std::string text = cmlRunText();
        const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
        const int needed = lineOf(text, "ischeme") + 1; // what comes below may be missing
        for (int count = 1; count < lines; ++count) {
            const Reading r(firstLines(text, count));
            QCOMPARE(r.parameters.problems.empty(), count >= needed && !r.problems().contains("section ends"));
            if (count < needed) QVERIFY2(r.problems().contains("ends "), r.problems());
            for (const InputProblem& problem : r.parameters.problems) {
                QVERIFY2(problem.line > 0 && problem.line <= count, problem.text().c_str());
                QCOMPARE(problem.file, std::string("run.dat"));
            }
        }
    }
    void damagedFilesDoNoHarm()
    {
        std::mt19937 generator(5);
        const std::string text = cmlRunText();
        std::uniform_int_distribution<std::size_t> place(0, text.size() - 1);
        std::uniform_int_distribution<int> byte(0, 255);
        for (int round = 0; round < 1000; ++round) {
            std::string damaged = text;
            for (int i = 0; i < 5; ++i) damaged[place(generator)] = static_cast<char>(byte(generator));
            const Reading r(damaged);
            for (const InputProblem& problem : r.parameters.problems) QVERIFY(problem.line > 0);
            for (const Parameter& parameter : parameters()) {
                const ParameterValue value = parameter.get(r.value);
                if (const auto* number = std::get_if<double>(&value)) QVERIFY(std::isfinite(*number));
            }
        }
    }

    void whatIsWrittenReadsBack()
    {
        // All that a run.dat has a place for, off its defaults.
        Case c = Reading(cmlRunText()).value;
        c.title = "Untitled";
        c.steady.radii = {0.02, 0.025};
        c.steady.skews = {0.1, -0.2};
        c.steady.speeds = {500.0, 600.0, 700.5};
        c.disk.radius = 0.02;
        c.disk.skew = 0.1;
        c.disk.speed = 500.0;
        c.film.grid = GridKind::Adapted;
        c.film.scheme = ConvectionScheme::Upwind;
        const Reading r(formatCmlRun(c, ""));
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(r.warnings(), QByteArray());
        QCOMPARE(firstDifference(r.value, c), std::string());

        c.air.source = AirSource::EstablishedStandard;
        c.steady.altitudes = {0.0, 1500.0};
        QCOMPARE(firstDifference(Reading(formatCmlRun(c, "")).value, c), std::string());
        c.steady.altitudes.clear();
        QCOMPARE(firstDifference(Reading(formatCmlRun(c, "")).value, c), std::string());
        c.air.source = AirSource::Atmosphere;
        c.air.altitude = 2500.0;
        QCOMPARE(firstDifference(Reading(formatCmlRun(c, "")).value, c), std::string());
    }
    void whatHasNoPlaceIsNear()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.film.scheme = ConvectionScheme::Exponential;
        c.air.slip.model = SlipModel::NewFirstOrder;
        c.film.grid = GridKind::Graded;
        const Case read = Reading(formatCmlRun(c, "")).value;
        QCOMPARE(read.film.scheme, ConvectionScheme::CompleteFlux);
        QCOMPARE(read.air.slip.model, SlipModel::FukuiKaneko);
        QCOMPARE(read.film.grid, GridKind::Uniform);
    }
};

TOUCHDOWN_TEST(TestCmlRunFile)

} // namespace test_cml_run_file

#include "test_cml_run_file.moc"
