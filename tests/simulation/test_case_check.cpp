// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/fields.h"

#include <QTest>

using namespace touchdown;

class TestCaseCheck : public QObject {
    Q_OBJECT

private slots:
    void theDefaultMakesSense() { QVERIFY(checkCombinations(Case{}).empty()); }

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
        // z_r0 = 7 nm + (0.6 - 0.575) mm * 90 urad = 9.25 nm, z_f0 = 7 nm + 1.1 mm * 90 urad = 106 nm.
        row("static rear spacing below the cutoff", {"springs.cutoff=9.26 nm"}, "springs.flying_height",
            "the static spacing at the rear air bearing spring is 9.25 nm, which must be greater than springs.cutoff "
            "(d_1 = 9.26 nm)");
        row("static rear spacing above the cutoff", {"springs.cutoff=9.24 nm"}, "", "");
        row("no rear spring", {"springs.cutoff=9.26 nm", "springs.rear_stiffness=0 N/m"}, "", "");
        // 7 nm - 1.1 mm * 10 urad = -4 nm.
        row("static front spacing below the cutoff", {"springs.pitch=-10 urad"}, "springs.flying_height",
            "the static spacing at the front air bearing spring is -4 nm");
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
    }
    void findsNonsense()
    {
        QFETCH(QStringList, settings);
        QFETCH(QString, key);
        QFETCH(QString, part);
        Case c;
        for (const QString& setting : settings) {
            const Field* field = findField(setting.section('=', 0, 0).toStdString());
            QVERIFY(field != nullptr);
            QCOMPARE(setFromText(c, *field, setting.section('=', 1).toStdString()).value_or(""), std::string());
        }
        const auto problems = checkCombinations(c);
        const auto found = std::ranges::find(problems, key.toStdString(), &CaseProblem::key);
        QCOMPARE(problems.empty(), key.isEmpty());
        if (key.isEmpty()) return;
        QVERIFY(found != problems.end());
        QVERIFY2(QString::fromStdString(found->message).contains(part), found->message.c_str());
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

QTEST_GUILESS_MAIN(TestCaseCheck)
#include "test_case_check.moc"
