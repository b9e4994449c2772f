// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_dynamics_file.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "core/case/parameters.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/cml_sample.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_dynamics_file {

struct Reading {
    Case value = defaultsOf(ModelKind::Film);
    CmlParameters parameters{value};
    explicit Reading(const std::string& text)
    {
        value.slider.length = 1.25e-3;
        value.slider.width = 1e-3;
        value.slider.thickness = 0.3e-3;
        parameters.beginFile("dynamics.def");
        readCmlDynamics(text, parameters);
    }
    QByteArray problems() const { return joined(parameters.problems); }
    QByteArray warnings() const { return joined(parameters.warnings); }
};

std::string withValues(std::string_view heading, std::string_view values)
{
    const std::string text = cmlDynamicsText();
    return withLine(text, lineOf(text, heading) + 1, values);
}

class TestCmlDynamicsFile : public QObject {
    Q_OBJECT

private slots:
    void theSampleSaysItsCase()
    {
        const Reading r(cmlDynamicsText());
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(r.warnings(), QByteArray());
        const Case& c = r.value;
        QCOMPARE(c.suspension.preload, 1.5e-3 * 9.80665);
        QCOMPARE(c.suspension.offsetX, 0.01 * 1.25e-3); // xf0/xl, of the length
        QCOMPARE(c.suspension.offsetY, -0.02 * 1e-3);   // yf0/yl, of the width
        QCOMPARE(c.slider.mass, 1.6e-6);
        QCOMPARE(c.slider.pitchInertia, 2.2e-13);
        QCOMPARE(c.slider.rollInertia, 1.45e-13);
        QCOMPARE(c.disk.speed, 5400.0 * std::numbers::pi / 30.0);
        QCOMPARE(c.disk.radius, 23e-3);
        QCOMPARE(c.disk.skew, -7.5 * std::numbers::pi / 180.0);
        QCOMPARE(c.run.step, 1e-7);
        QCOMPARE(c.run.duration, 2e-3);
        QCOMPARE(c.run.steps, StepControl::Fixed);
        QCOMPARE(c.suspension.stiffness, 18.0);
        QCOMPARE(c.suspension.pitchStiffness, 1.745e-5);
        QCOMPARE(c.suspension.rollStiffness, 1.845e-5);
        QCOMPARE(c.suspension.damping, 1e-10);
        QCOMPARE(c.suspension.pitchDamping, 1e-17);
        QCOMPARE(c.suspension.rollDamping, 2e-17);
        QVERIFY(c.suspension.holdsAttitude);
        QCOMPARE(c.suspension.staticPitch, 1e-3);
        QCOMPARE(c.suspension.staticRoll, 2e-3);
        QCOMPARE(c.initial.nominalTrailingEdgeHeight, 1e-8);
        QCOMPARE(c.initial.pitch, 1.6e-4);
        QCOMPARE(c.initial.roll, 2e-6);
        QCOMPARE(c.initial.verticalVelocity, 1e-3);
        QCOMPARE(c.initial.pitchVelocity, 2.0);
        QCOMPARE(c.air.slip.model, SlipModel::FukuiKaneko);
        QCOMPARE(c.film.tolerance, 1e-7);
        QCOMPARE(c.steady.loadTolerance, 1e-4);
        QCOMPARE(c.film.scheme, ConvectionScheme::Hybrid);
        QCOMPARE(c.film.grid, GridKind::Adapted);
        QCOMPARE(c.film.nodes, (std::array<int, 2>{97, 193})); // without the dynamic program's extra line
        QCOMPARE(c.air.given.pressure, 99000.0);
        QCOMPARE(c.air.given.meanFreePath, 65e-9);
        QCOMPARE(c.air.given.viscosity, 1.82e-5);
        QCOMPARE(c.steady.shearArm, 1.0);
    }
    void listsBrokenUnderOtherHeadings()
    {
        const std::string text = replaced(cmlDynamicsText(), "1.0000E-003    2.0000E+000    0.0000E+000",
                                          "\nvz vp vr\n1.0000E-003    2.0000E+000    0.0000E+000");
        const Reading r(withLineEnds(text, "\r\n"));
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(firstDifference(r.value, Reading(cmlDynamicsText()).value), std::string());
    }

    void notModelled_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("warning");
        const auto row = [](const char* name, const std::string& text, const char* warning) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(warning);
        };
        row("another slider", withValues("xl(m)", "0.85e-3 0.8 0 0 0 0"),
            "dynamics.def:2: Problem Definition Menu: not modelled: a slider of another size than that of the rails "
            "(xl, yl)");
        row("mass centre", withValues("xl(m)", "1.25e-3 0.8 0.01 0 0.2 0"),
            "dynamics.def:2: Problem Definition Menu: not modelled: a mass centre off the middle of the slider (xg, "
            "yg), "
            "the height of the mass centre (zg)");
        row("actuator and modes",
            replaced(withValues("iact ", "1 0.05 0 0 -7.5"), "0              0              0              0.0",
                     "1              0              0              0.0"),
            "dynamics.def:9: Suspension Menu: not modelled: an actuator (iact), a suspension of modes (isusp)");
        row("central differences", withValues("iqpo", "5 1e-7 1e-4 2"),
            "dynamics.def:21: Solution Control Menu: not modelled: central differences; complete-flux is taken");
        row("start of a track profile", withValues("inwave", "1 500 0.5 3"),
            "dynamics.def:41: Disk Track Profile Menu: not modelled: where the profile starts (dinit)");
        row("asperities without numbers", withValues("nwave", "0 0 2"),
            "dynamics.def:44: Disk Surface Menu: not modelled: the whole section, which is switched on and has 3 "
            "numbers, "
            "not 20");
        row("times and zones", withValues("nwave", "0 1 0 0 1e-3 0\n0.01 1e-9 0.02 2e-9 0.03 0"),
            "dynamics.def:44: Disk Surface Menu: not modelled: times (t1, t2, t3), zones of the disk (nzone)");
        row("waves of other forms",
            withValues("nwave", "3 0 0 0 0 0\n1 1e-9 0 1e-4 0 1e-5 1e-5 0 0\n"
                                "0 1e-9 0 1e-4 1e-4 0 0 0 0\n0 1e-9 0 1e-4 0 0 0 0.02 0.023"),
            "dynamics.def:44: Disk Surface Menu: not modelled: wave 1, which is not a sine (type 1), wave 2, which "
            "does "
            "not "
            "have the one wavelength x, wave 3, which begins or ends under the slider");
        row("asperities of other forms",
            withValues("nwave", "0 0 4 0 0 0\n3 1e-9 0 0 0 1e-5 1e-5\n1 1e-9 0 0 0 1e-5 0\n0 1e-9 45 0 0 1e-5 2e-5\n"
                                "2 1e-9 0 0 0 1e-5 1e-5"),
            "dynamics.def:44: Disk Surface Menu: not modelled: asperity 1, which is neither sinusoidal nor ellipsoidal "
            "(type 3), asperity 2, which has no size, asperity 3, which is turned, asperity 4, which is neither "
            "sinusoidal "
            "nor ellipsoidal (type 2)");
        row("contact", withValues("icmod", "1 1e11 1e9 0.3 0.3"),
            "dynamics.def:47: Asperity Contact Menu: not modelled: contact of a statistical surface (icmod = 1)");
        row("waves on the slider",
            replaced(cmlDynamicsText(), "*****************End",
                     "***Slider Surface***\nnswave nsasper\n0 1\n*****************End"),
            "dynamics.def:53: Slider Surface: not modelled: the whole section, which is switched on");
        row("what nobody knows",
            replaced(cmlDynamicsText(), "*****************End", "***Shock***\nmode\n2\n*****************End"),
            "dynamics.def:53: Shock: not modelled: the whole section, which is switched on");
        row("yaw", replaced(cmlDynamicsText(), "*****************End", "iyaw\n1e-13\n*****************End"),
            "dynamics.def:50: Additional Parameters: not modelled: iyaw = 1e-13");
    }
    void notModelled()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, warning);
        const Reading r(text.toStdString());
        QCOMPARE(r.problems(), QByteArray());
        QCOMPARE(r.warnings(), warning);
    }

    void rollVelocity()
    {
        const Reading r(withValues("hm(m)", "1e-8 1.6e-4 2e-6 0 0 3"));
        QCOMPARE(r.warnings(), QByteArray());
        QCOMPARE(r.value.initial.rollVelocity, 3.0);
    }
    void malformed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "\n", "dynamics.def: is empty");
        row("a word for a number", withValues("f0(kg)", "1.5e-3 0.01 -0.02 heavy 2.2e-13 1.45e-13"),
            "dynamics.def:6: Problem Definition Menu: needs 18 numbers, but has 15; \"heavy\" is none");
        row("not a number", withValues("hm(m)", "1e-8 NaN 0 0 0 0"),
            "dynamics.def:20: Initial Condition Menu: needs 6 numbers, but has 1; \"NaN\" is none");
        row("an unknown slip model", withValues("iqpo", "3 1e-7 1e-4 1"),
            "dynamics.def:23: Solution Control Menu: the slip model must be 0, 1, 2 or 5, not 3");
        row("an unknown scheme", withValues("iqpo", "5 1e-7 1e-4 0"),
            "dynamics.def:23: Solution Control Menu: the scheme must be a whole number from 1 to 4, not \"0\"");
        row("no mass", withValues("f0(kg)", "1.5e-3 0.01 -0.02 0 2.2e-13 1.45e-13"),
            "dynamics.def:6: slider.mass: 0 mg is out of range: allowed is at least 1e-6 mg, at most 10 kg");
        row("two billion nodes", withValues("iadapt", "1 0 0 2000000000 194 1 1"),
            "dynamics.def:26: Grid Control Menu: the number of grid lines must be a whole number from 2 to 1000000, "
            "not "
            "\"2000000000\"");
    }
    void malformed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        QCOMPARE(Reading(text.toStdString()).problems(), problem);
    }
    void cutAtEveryLine()
    {
        const std::string text = cmlDynamicsText();
        const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
        const int needed = lineOf(text, "iadapt") + 1;
        for (int count = 1; count < lines; ++count) {
            const Reading r(firstLines(text, count));
            QCOMPARE(r.parameters.problems.empty(), count >= needed);
            for (const InputProblem& problem : r.parameters.problems)
                QVERIFY2(problem.line > 0 && problem.line <= count, problem.text().c_str());
        }
    }
    void damagedFilesDoNoHarm()
    {
        std::mt19937 generator(5);
        const std::string text = cmlDynamicsText();
        std::uniform_int_distribution<std::size_t> place(0, text.size() - 1);
        std::uniform_int_distribution<int> byte(0, 255);
        for (int round = 0; round < 1000; ++round) {
            std::string damaged = text;
            for (int i = 0; i < 5; ++i) damaged[place(generator)] = static_cast<char>(byte(generator));
            const Reading r(damaged);
            for (const Parameter& parameter : parameters()) {
                const ParameterValue value = parameter.get(r.value);
                if (const auto* number = std::get_if<double>(&value)) QVERIFY(std::isfinite(*number));
            }
        }
    }
};

TOUCHDOWN_TEST(TestCmlDynamicsFile)

} // namespace test_cml_dynamics_file

#include "test_cml_dynamics_file.moc"
