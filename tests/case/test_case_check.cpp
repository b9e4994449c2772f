// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/parameters.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_case_check {

class TestCaseCheck : public QObject {
    Q_OBJECT

private slots:
    void theDefaultMakesSense()
    {
        for (const ModelKind model : {ModelKind::Springs, ModelKind::Film})
            QVERIFY(checkCombinations(defaultsOf(model)).empty());
    }

    void findsNonsense_data()
    {
        QTest::addColumn<QStringList>("settings"); // key=value
        QTest::addColumn<QString>("key");          // "" : it makes sense
        QTest::addColumn<QString>("part");         // of the message

        const auto row = [](const char* name, const QStringList& settings, const char* key, const char* part) {
            QTest::newRow(name) << settings << QString(key) << QString(part);
        };
        row("take-off below touch-down", {"ono_yamane.take_off=2 nm"}, "ono_yamane.take_off",
            "d_e = 2 nm must be at least ono_yamane.touch_down (d_s = 3 nm)");
        row("take-off at touch-down", {"ono_yamane.take_off=3 nm"}, "", "");
        row("take-off below touch-down without contact", {"contact=none", "ono_yamane.take_off=2 nm"}, "", "");
        // z_r0 = 7 nm + (0.575 - 0.545) mm * 90.6 urad = 9.718 nm, z_f0 = 7 nm + 1.125 mm * 90.6 urad = 108.9 nm.
        row("static rear spacing below the cutoff", {"springs.cutoff=9.72 nm"}, "springs.flying_height",
            "the static spacing at the rear air bearing spring is 9.718 nm, which must be greater than springs.cutoff "
            "(d_1 = 9.72 nm)");
        row("static rear spacing above the cutoff", {"springs.cutoff=9.71 nm"}, "", "");
        row("no rear spring", {"springs.cutoff=9.72 nm", "springs.rear_stiffness=0 N/m"}, "", "");
        // 7 nm - 1.125 mm * 10 urad = -4.25 nm.
        row("static front spacing below the cutoff", {"springs.pitch=-10 urad"}, "springs.flying_height",
            "the static spacing at the front air bearing spring is -4.25 nm");
        row("start below the cutoff", {"initial.flying_height=0.3 nm"}, "initial.flying_height",
            "the initial spacing at the front air bearing spring is 0.3 nm, which must be greater than springs.cutoff "
            "(d_1 = 0.3 nm)");
        row("start below the cutoff without springs",
            {"initial.flying_height=0.3 nm", "springs.front_stiffness=0", "springs.rear_stiffness=0"}, "", "");
        row("step longer than the run", {"run.integrator=rk4", "run.step=3 ms"}, "run.step",
            "must be at most run.duration (2 ms)");
        row("unused step longer than the run", {"run.step=3 ms"}, "", "");
        row("too many steps", {"run.integrator=newmark", "run.step=1e-15 s"}, "run.step", "more than 1e11 steps");
        row("sample interval longer than the run", {"run.sample_interval=3 ms"}, "run.sample_interval",
            "must be at most run.duration (2 ms)");
        row("too many samples", {"run.sample_interval=0.01 ns"}, "run.sample_interval", "more than 1e8 samples");
        row("spectrum from the end on", {"spectrum.start=2 ms"}, "spectrum.start",
            "must be less than run.duration (2 ms)");
        row("springs that roll", {"degrees_of_freedom=3"}, "degrees_of_freedom", "must be 2 with model \"springs\"");
        const QStringList film{"model=film", "contact=none", "degrees_of_freedom=3"};
        row("a film that touches", {"model=film"}, "", "");
        row("a film with roll held", {"model=film", "contact=none"}, "", "");
        row("springs that a film does not have",
            film + QStringList{"springs.cutoff=9.72 nm", "run.integrator=rk4", "run.step=3 ms"}, "", "");
        row("a spectrum of a film from the end on", film + QStringList{"spectrum.start=2 ms"}, "spectrum.start",
            "must be less than run.duration (2 ms)");
        row("a fixed step of a film longer than the run", film + QStringList{"run.steps=fixed", "run.step=3 ms"},
            "run.step", "must be at most run.duration (2 ms)");
        row("samples of a film apart by more than the run", film + QStringList{"run.sample_interval=3 ms"},
            "run.sample_interval", "must be at most run.duration (2 ms)");
        row("a start at a static attitude that nobody looks for",
            film + QStringList{"initial.state=static", "steady.fixed_attitude=true"}, "initial.state",
            "must be \"given\" with steady.fixed_attitude");
        row("a start at the static attitude with roll held",
            {"model=film", "contact=none", "initial.state=static", "initial.height_offset=2 nm"}, "", "");
        const QStringList specular = film + QStringList{"air.accommodation=0.9"};
        row("kinetic values of specular walls", specular, "air.accommodation",
            "must be 1 with this air.slip (fukui-kaneko)");
        row("their fit", specular + QStringList{"air.slip=fukui-kaneko-fit"}, "air.accommodation",
            "(fukui-kaneko-fit)");
        row("the second order of specular walls", specular + QStringList{"air.slip=second-order"}, "air.accommodation",
            "(second-order)");
        row("the combination of specular walls", specular + QStringList{"air.slip=combination"}, "air.accommodation",
            "(combination)");
        for (const char* slip : {"first-order", "1.5-order", "new-first-order", "new-second-order", "continuum"})
            row(slip, specular + QStringList{QString("air.slip=") + slip}, "", "");
        row("a skew without its radius", film + QStringList{"steady.skews=1 deg, 2 deg", "steady.radii=20 mm"},
            "steady.skews", "has 2 numbers; steady.radii has 1");
        row("a skew for each radius", film + QStringList{"steady.skews=1 deg, 2 deg", "steady.radii=20 mm, 30 mm"}, "",
            "");
        const auto numbers = [](int count) {
            QStringList list;
            for (int i = 0; i < count; ++i) list << QString::number(0.01 + 1e-4 * i);
            return list.join(',');
        };
        row("ten thousand states", film + QStringList{"steady.radii=" + numbers(100), "steady.speeds=" + numbers(100)},
            "", "");
        row("more states than one may want",
            film + QStringList{"steady.radii=" + numbers(100), "steady.speeds=" + numbers(100), "steady.altitudes=0,1"},
            "steady.radii", "makes 20000 static states");
        const QStringList linear = film + QStringList{"film.motion=linear"};
        const QStringList waves{"disk.surface.kind=waves", "disk.surface.wave_amplitudes=1 nm",
                                "disk.surface.wave_lengths=0.5 mm"};
        row("a linear film over waves", linear + waves, "", "");
        row("a linear film over waves that stand still", linear + waves + QStringList{"disk.surface.motion=still"},
            "film.motion", "must be \"full\"");
        row("a linear film over roughness", linear + QStringList{"disk.surface.kind=rough"}, "film.motion",
            "leaves roughness to a contact that sees it");
        row("a full film over roughness", film + QStringList{"disk.surface.kind=rough"}, "", "");
        row("a linear film over bumps", linear + QStringList{"disk.surface.kind=bumps"}, "film.motion",
            "must be \"full\"");
        row("a taper longer than the slider", film + QStringList{"abs.taper_length=1.3 mm"}, "abs.taper_length",
            "must be at most slider.length (1.25 mm)");
    }
    void findsNonsense()
    {
        QFETCH(QStringList, settings);
        QFETCH(QString, key);
        QFETCH(QString, part);
        Case c;
        for (const QString& setting : settings) {
            const Parameter* parameter = findParameter(setting.section('=', 0, 0).toStdString());
            QVERIFY(parameter != nullptr);
            QCOMPARE(setFromText(c, *parameter, setting.section('=', 1).toStdString()).value_or(""), std::string());
        }
        const auto problems = checkCombinations(c);
        const auto found = std::ranges::find(problems, key.toStdString(), &CaseProblem::key);
        QCOMPARE(problems.empty(), key.isEmpty());
        if (key.isEmpty()) return;
        QVERIFY(found != problems.end());
        QVERIFY2(QString::fromStdString(found->message).contains(part), found->message.c_str());
    }

    void aProblemConcernsItsKeysAndTheirGroups()
    {
        const CaseProblem problem{"run.step", "must be at most run.duration", {"run.duration", "disk.surface"}};
        for (const char* key : {"run.step", "run.duration", "run", "disk.surface.rms", "disk"})
            QVERIFY2(problem.concerns(key), key);
        for (const char* key : {"run.step_error", "disk.speed", "model", "ru"}) QVERIFY2(!problem.concerns(key), key);
    }

    /// Those of the surface under the key of their rail or wall.
    void surfaces()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.surface.rails.resize(2);
        c.surface.rails[0].points = {{0.0, 0.0, 0}, {1e-3, 0.0, 0}, {0.0, 1e-3, 0}};
        c.surface.rails[1].points = {{0.0, 0.0, 0}, {1e-3, 1e-3, 0}, {1e-3, 0.0, 0}, {0.0, 1e-3, 1}};
        c.surface.walls.push_back({{1e-6, 0.0}, {0.0, 1e-6}});
        QStringList problems;
        for (const CaseProblem& problem : checkCombinations(c))
            problems << QString::fromStdString(problem.key + ": " + problem.message);
        QCOMPARE(problems,
                 (QStringList{"abs.rail[2]: Rail 2: the outline crosses itself",
                              "abs.wall[1]: Wall profile 1: the distances must ascend; point 2 lies before the point "
                              "ahead of it"}));
        c.model = ModelKind::Springs;
        c.degreesOfFreedom = 2;
        QVERIFY(checkCombinations(c).empty());
    }

    void saysWhatAValueWithoutEffectWants_data()
    {
        QTest::addColumn<QStringList>("settings"); // key=value
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("message");

        const auto row = [](const char* name, const QStringList& settings, const char* key, const char* message) {
            QTest::newRow(name) << settings << QString(key) << QString(message);
        };
        row("a step that is adaptive", {"model=film", "contact=none"}, "run.step",
            "has no effect here, only with run.steps = \"fixed\"");
        row("a step that is fixed", {"model=film", "contact=none", "run.steps=fixed"}, "run.step", "");
        row("a step of an adaptive integrator", {}, "run.step",
            "has no effect here, only with run.integrator = \"rk4\" or \"rk4-events\" or \"newmark\"");
        row("an integrator of the film", {"model=film", "contact=none"}, "run.integrator",
            "has no effect here, only with model = \"springs\"");
        row("a coupling of springs", {}, "film.coupling", "has no effect here, only with model = \"film\"");
        row("a contact that is not there", {"contact=none"}, "ono_yamane.touch_down",
            "has no effect here, only with contact = \"ono-yamane\"");
        const QStringList linear{"model=film", "contact=none", "film.motion=linear"};
        row("a coupling of a linear film", linear, "film.coupling",
            "has no effect here, only with film.motion = \"full\"");
        row("maps of a linear film", linear, "run.field_snapshots",
            "has no effect here, only with film.motion = \"full\"");
        row("a limit of a full film", {"model=film", "contact=none"}, "film.linear_limit",
            "has no effect here, only with film.motion = \"linear\"");
        row("a load at a fixed attitude", {"model=film", "contact=none", "steady.fixed_attitude=true"},
            "steady.load_tolerance", "has no effect here, only with steady.fixed_attitude = false");
        row("a window of springs that do not move by themselves", {"model=contact", "contact=elastic"},
            "spectrum.window", "has no effect here, only with model = \"springs\" or \"film\"");
        // Neither the model alone nor the contact alone would make a pad of it.
        row("what wants more than one other choice", {"contact=none"}, "pad.radius", "has no effect here");
    }
    void saysWhatAValueWithoutEffectWants()
    {
        QFETCH(QStringList, settings);
        QFETCH(QString, key);
        QFETCH(QString, message);
        Case c;
        for (const QString& setting : settings)
            QVERIFY(!setFromText(c, *findParameter(setting.section('=', 0, 0).toStdString()),
                                 setting.section('=', 1).toStdString()));
        const Parameter* parameter = findParameter(key.toStdString());
        QVERIFY(parameter != nullptr);
        QCOMPARE(QString::fromStdString(unusedMessage(c, *parameter)), message);
    }

    void everyProblemIsReported()
    {
        Case c;
        c.onoYamane.takeOff = 1e-9;
        c.run.sampleInterval = 1.0;
        c.spectrum.start = 1.0;
        QCOMPARE(checkCombinations(c).size(), std::size_t{3});
    }
};

TOUCHDOWN_TEST(TestCaseCheck)

} // namespace test_case_check

#include "test_case_check.moc"
