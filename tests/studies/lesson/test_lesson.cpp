// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/lesson/lesson.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/simulation/run.h"
#include "core/studies/study_plan.h"
#include "tests/support/amounts.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_lesson {

constexpr std::size_t springSteps = 5; // all but the last, which has a film

/// A case with further settings.
struct FurtherRun {
    std::size_t step; // from 1
    std::string name;
    std::vector<CaseSetting> settings;
};

const CaseSetting staticPitch{"initial.pitch", "90.6 urad"};

/// The runs that the questions "what to change" ask for, as far as the answers have numbers of them.
std::vector<FurtherRun> furtherRuns()
{
    std::vector<FurtherRun> runs;
    for (const char* height : {"17 nm", "19 nm", "35 nm"})
        runs.push_back({2, "fig13a", {{"initial.flying_height", height}, staticPitch}});
    for (const char* step : {"9 ns", "20 ns"}) runs.push_back({3, "fig10b_naive_switching", {{"run.step", step}}});
    for (const char* cutoff : {"2.5 nm", "2.2 nm", "1.9 nm"})
        runs.push_back({4, "fig12b", {{"springs.cutoff", cutoff}}});
    return runs;
}

double finalHeight(const Summary& summary) // [m]
{
    const auto found = std::ranges::find(summary.final, std::string("flying_height"),
                                         [](const auto& each) -> std::string { return each.first; });
    return found == summary.final.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

long long lostSprings(const Summary& summary)
{
    return std::ranges::count(summary.events, std::string("rear spring lost"), &RunEvent::name);
}

/// What a run gives, with all its digits.
void addFacts(std::vector<Amount>& facts, const Case& c, const std::vector<CaseSetting>& settings)
{
    for (const CaseSetting& setting : settings)
        for (const Amount& amount : amountsIn(setting.value)) facts.push_back(amount);
    facts.push_back({c.initial.flyingHeight * 1e9, "nm", 0.0, {}});
    facts.push_back({c.initial.pitch * 1e6, "urad", 0.0, {}});
    facts.push_back({c.springs.cutoff * 1e9, "nm", 0.0, {}});
    facts.push_back({c.run.duration * 1e3, "ms", 0.0, {}});
    facts.push_back({c.run.step * 1e9, "ns", 0.0, {}});
    facts.push_back({c.onoYamane.friction, "", 0.0, {}});
    facts.push_back({meniscusForceForWork(c.onoYamane, 0.0) * 1e3, "mN", 0.0, {}});
    double highest = 0.0; // [m]
    const auto height = std::size_t(findQuantity(recordedQuantities(c), "minimum_spacing"));
    const Summary summary = run(c, [&](const RunUpdate& update) {
        for (const double value : update.samples.columns[height]) highest = std::max(highest, value);
        return true;
    });
    facts.push_back({highest * 1e6, "um", 0.0, {}});
    for (const auto& [quantity, value] : summary.final) {
        if (quantity == "flying_height") facts.push_back({value * 1e9, "nm", 0.0, {}});
        if (quantity == "pitch") facts.push_back({value * 1e6, "urad", 0.0, {}});
        if (quantity == "net_contact_force") facts.push_back({-value * 1e3, "mN", 0.0, {}});
    }
    for (const auto& [quantity, tail] : summary.tail)
        if (quantity == "minimum_spacing") facts.push_back({(tail.max - tail.min) * 1e9, "nm", 0.0, {}});
    for (const RunFigure& figure : summary.figures) {
        if (figure.quantity.name == "cycle_work") facts.push_back({figure.value * 1e12, "pJ", 0.0, {}});
        if (figure.quantity.name == "touch_downs") facts.push_back({figure.value, "", 0.0, {}});
    }
    facts.push_back({double(lostSprings(summary)), "", 0.0, {}});
    for (const Amount& amount : amountsIn(summary.message)) facts.push_back(amount);
}

/// The findings of a study; a map has few cells and one start here, as only its marks give numbers.
std::vector<std::string> findingsOf(const LessonRun& study)
{
    std::vector<std::string> options;
    if (study.name == "cycles_map_paper")
        options = {"map.x_points=2", "map.y_points=2", "map.starts=1", "duration=0.1 ms"};
    return openStudy(study.kind, study.name, {}, options).perform(2, {}).findings;
}

QString problemsOf(const Lesson& lesson)
{
    QString all;
    for (const InputProblem& problem : lesson.problems) all += QString::fromStdString(problem.text()) + '\n';
    return all;
}

class TestLesson : public QObject {
    Q_OBJECT

private slots:
    void isRead()
    {
        const Lesson lesson = readLesson(lessonTexts().back().text, "lesson.toml");
        QVERIFY2(lesson.problems.empty(), qPrintable(problemsOf(lesson)));
        QCOMPARE(lesson.steps.size(), std::size_t(6));
        for (const LessonStep& step : lesson.steps) {
            QVERIFY(!step.runs.empty());
            for (const std::string& text : {step.title, step.text, step.question, step.change, step.answer})
                QVERIFY2(!text.empty() && !text.starts_with(' ') && text.find("\n ") == std::string::npos,
                         text.c_str());
        }
    }

    /// Every case with its settings is a valid one, and every study can be performed.
    void canBeRun()
    {
        for (const LessonStep& step : lessonSteps())
            for (const LessonRun& each : step.runs) {
                if (each.kind.empty()) {
                    Case c = sample(each.name);
                    QVERIFY(!changeCase(c, each.settings));
                } else {
                    QVERIFY(each.settings.empty());
                    QVERIFY(openStudy(each.kind, each.name).valid());
                }
            }
    }

    void commands()
    {
        QCOMPARE(commandOf({"", "fig10a", "", {{"springs.flying_height", "5 nm"}, {"run.step", "1 ns"}}}),
                 std::string("touchdown run fig10a --set 'springs.flying_height=5 nm' --set 'run.step=1 ns'"));
        QCOMPARE(commandOf({"", "paper", "statements", {}}), std::string("touchdown study statements paper"));
    }

    void problems_data()
    {
        QTest::addColumn<QString>("run");
        QTest::addColumn<QString>("says");
        QTest::newRow("no TOML") << "case = "
                                 << "l.toml:9: is not TOML";
        QTest::newRow("no purpose") << "case = 'fig10a'"
                                    << "l.toml:8: step[1].run[1].purpose: is missing";
        QTest::newRow("no case") << "purpose = 'x'"
                                 << "step[1].run[1].case: is missing";
        QTest::newRow("unknown case") << "purpose = 'x'\ncase = 'fig99'"
                                      << "\"fig99\" is no sample case";
        QTest::newRow("unknown study") << "purpose = 'x'\nstudy = 'fig10a'"
                                       << "\"fig10a\" is no sample study";
        QTest::newRow("unknown key") << "purpose = 'x'\ncase = 'fig10a'\nsets = 1"
                                     << "l.toml:11: step[1].run[1].sets: unknown key";
    }
    void problems()
    {
        QFETCH(const QString, run);
        QFETCH(const QString, says);
        const std::string step = "[[step]]\ntitle = 'a'\ntext = 'b'\nquestion = 'c'\nchange = 'd'\nanswer = 'e'\n"
                                 "stage.plots = ['spacing']\n";
        const QString said = problemsOf(readLesson(step + "[[step.run]]\n" + run.toStdString() + '\n', "l.toml"));
        QVERIFY2(said.contains(says), qPrintable(said));
    }

    void stageIsRead()
    {
        const std::string step = "[[step]]\ntitle = 'a'\ntext = 'b'\nquestion = 'c'\nchange = 'd'\nanswer = 'e'\n";
        const Lesson good = readLesson(step + "[step.stage]\nplots = ['spacing', 'energy']\nfrom = '0.1 ms'\n"
                                              "until = '0.3 ms'\nlowest = '-5 nm'\nhighest = '20 nm'\nside = true\n",
                                       "l.toml");
        QVERIFY2(good.problems.empty(), qPrintable(problemsOf(good)));
        const LessonStage& stage = good.steps.at(0).stage;
        QCOMPARE(stage.plots, (std::vector<std::string>{"spacing", "energy"}));
        QCOMPARE(stage.from, 0.1e-3);
        QCOMPARE(stage.until, 0.3e-3);
        QCOMPARE(stage.lowest, -5e-9);
        QCOMPARE(stage.highest, 20e-9);
        QVERIFY(stage.side && !stage.spectrum && !stage.parts);
        const std::string run = "[[step.run]]\npurpose = 'x'\ncase = 'fig10a'\n";
        const Lesson parts = readLesson(step + "[step.stage]\nplots = ['energy']\nparts = 2\n" + run + run, "l.toml");
        QVERIFY2(parts.problems.empty(), qPrintable(problemsOf(parts)));
        QCOMPARE(parts.steps.at(0).stage.parts, std::optional<std::size_t>(1));
        const Lesson beyond = readLesson(step + "[step.stage]\nplots = ['energy']\nparts = 2\n" + run, "l.toml");
        QVERIFY(problemsOf(beyond).contains("step[1].stage.parts"));
        QVERIFY(problemsOf(readLesson(step, "l.toml")).contains("step[1].stage.plots: is missing"));
        const std::string wrong = step + "[step.stage]\nplots = ['spacing']\nfrom = '2 ms'\nuntil = '1 ms'\n";
        QVERIFY(problemsOf(readLesson(wrong, "l.toml")).contains("stage.until: is below the other end of its axis"));
    }

    void marksAreRead()
    {
        const std::string step = "[[step]]\ntitle = 'a'\ntext = 'b'\nquestion = 'c'\nchange = 'd'\nanswer = 'e'\n"
                                 "stage.plots = ['spacing']\nstage.until = '1 ms'\n"
                                 "[[step.run]]\npurpose = 'x'\ncase = 'fig10a'\n"
                                 "[[step.run]]\npurpose = 'y'\nstudy = 'hysteresis_flying_height'\n[[step.mark]]\n";
        const Lesson good =
            readLesson(step + "run = 1\nplot = 'spacing'\nat = '25 us'\ntext = 'first touch'\n", "l.toml");
        QVERIFY2(good.problems.empty(), qPrintable(problemsOf(good)));
        const LessonMark& mark = good.steps.at(0).marks.at(0);
        QVERIFY(mark.run == 0 && mark.plot == "spacing" && mark.text == "first touch");
        QCOMPARE(mark.at, 25e-6);
        const std::pair<std::string, QString> wrong[]{
            {"run = 3\nplot = 'spacing'\nat = '25 us'\ntext = 'x'\n", "mark[1].run"},
            {"run = 1.5\nplot = 'spacing'\nat = '25 us'\ntext = 'x'\n", "run: is not a whole number"},
            {"run = 2\nplot = 'spacing'\nat = '25 us'\ntext = 'x'\n", "run: is a study"},
            {"run = 1\nplot = 'energy'\nat = '25 us'\ntext = 'x'\n", "\"energy\" is not a plot of the stage"},
            {"run = 1\nplot = 'spacing'\nat = '2 ms'\ntext = 'x'\n", "mark[1].at"},
            {"run = 1\nplot = 'spacing'\ntext = 'x'\n", "at: is missing"},
            {"run = 1\nplot = 'spacing'\nat = '25 us'\n", "text: is missing"}};
        for (const auto& [text, says] : wrong) {
            const QString said = problemsOf(readLesson(step + text, "l.toml"));
            QVERIFY2(said.contains(says), qPrintable(said));
        }
    }

    /// The last number of a word in a plot is that of its run: at its place, at its end, or how far it swings there.
    /// The numbers before it are those of the run's settings.
    void marksAreTrue()
    {
        int numbers = 0;
        for (const std::vector<LessonStep>* steps : {&lessonSteps(), &demonstrationSteps()})
            for (const LessonStep& step : *steps)
                for (const LessonMark& mark : step.marks) {
                    const LessonRun& lessonRun = step.runs.at(mark.run);
                    const Case c = caseOf(lessonRun);
                    QCOMPARE(c.model, ModelKind::Springs);
                    QCOMPARE(mark.plot, std::string("spacing"));
                    const auto column = std::size_t(findQuantity(recordedQuantities(c), "minimum_spacing"));
                    double there = std::numeric_limits<double>::quiet_NaN();
                    const bool ends = mark.text.find("ends") != std::string::npos;
                    const Summary summary = run(c, [&](const RunUpdate& update) {
                        for (std::size_t i = 0; i < update.samples.time.size(); ++i)
                            if (ends || update.samples.time[i] <= mark.at * (1.0 + 1e-9))
                                there = update.samples.columns[column][i];
                        return true;
                    });
                    const bool swings = mark.text.find("swings") != std::string::npos;
                    for (const auto& [quantity, tail] : summary.tail)
                        if (swings && quantity == "minimum_spacing") there = tail.max - tail.min;
                    const std::vector<Amount> said = amountsIn(mark.text);
                    if (said.empty()) { // "first touch"
                        QVERIFY(mark.text.find("touch") != std::string::npos && there <= c.onoYamane.touchDown);
                        continue;
                    }
                    const double unit = said.back().unit == "um" ? 1e-6 : 1e-9; // [m]
                    QVERIFY2(rounds(there / unit, said.back()), mark.text.c_str());
                    for (std::size_t i = 0; i + 1 < said.size(); ++i)
                        QVERIFY2(std::ranges::any_of(lessonRun.settings,
                                                     [&](const CaseSetting& setting) {
                                                         return setting.value == said[i].text.toStdString();
                                                     }),
                                 mark.text.c_str());
                    ++numbers;
                }
        QVERIFY(numbers >= 10);
    }

    /// The springs of the last step.
    void wavesForceTheSlider()
    {
        const LessonStep& last = lessonSteps().back();
        const Case waves = caseOf(last.runs.at(0));
        QCOMPARE(waves.model, ModelKind::Springs);
        const Summary still = run(waves), moving = run(caseOf(last.runs.at(1)));
        const auto swing = [](const Summary& summary) { // of the minimum spacing at the end [nm]
            for (const auto& [quantity, tail] : summary.tail)
                if (quantity == "minimum_spacing") return (tail.max - tail.min) * 1e9;
            return std::numeric_limits<double>::quiet_NaN();
        };
        QVERIFY(last.answer.find("swings by 8.08 nm from peak to peak") != std::string::npos);
        QVERIFY2(std::abs(swing(moving) - 8.08) < 0.005, qPrintable(QString::number(swing(moving))));
        QVERIFY(swing(still) < 1e-3);
        QVERIFY(last.text.find("waves that are 50 um long and have an amplitude of 0.5 nm") != std::string::npos);
        QCOMPARE(waves.diskSurface.waveAmplitudes, (std::vector<double>{0.5e-9}));
        QCOMPARE(waves.diskSurface.waveLengths, (std::vector<double>{50e-6}));
    }

    /// Each number of an answer is that of a run of its step, of one of its studies, or of its own text and settings.
    void answersAreTrue_data()
    {
        QTest::addColumn<int>("step");
        for (std::size_t i = 0; i < springSteps; ++i)
            QTest::newRow(lessonSteps().at(i).title.c_str()) << static_cast<int>(i);
    }
    void answersAreTrue()
    {
        QFETCH(const int, step);
        const LessonStep& lesson = lessonSteps().at(std::size_t(step));
        std::vector<Amount> facts = amountsIn(lesson.text);
        // The law of step 1, to which step 5 compares its own.
        const OnoYamane first = sample("fig10a").onoYamane;
        facts.push_back({meniscusForceForWork(first, 0.0) * 1e3, "mN", 0.0, {}});
        facts.push_back({OnoYamaneLaw(first).cycleWork() * 1e12, "pJ", 0.0, {}});
        facts.push_back({first.takeOff * 1e9, "nm", 0.0, {}});
        for (const LessonRun& each : lesson.runs) {
            if (each.kind.empty()) {
                addFacts(facts, caseOf(each), each.settings);
                continue;
            }
            for (const std::string& finding : findingsOf(each))
                for (const Amount& amount : amountsIn(finding)) facts.push_back(amount);
        }
        for (const FurtherRun& each : furtherRuns())
            if (each.step == std::size_t(step) + 1)
                addFacts(facts, caseOf({"", each.name, "", each.settings}), each.settings);
        for (const Amount& said : amountsIn(lesson.answer)) {
            const bool found = std::ranges::any_of(facts, [&](const Amount& fact) {
                return fact.unit == said.unit && fact.half <= said.half && rounds(fact.value, said);
            });
            QVERIFY2(found, qPrintable(said.text));
        }
    }

    /// What the answers say of the end of each run.
    void ends_data()
    {
        QTest::addColumn<int>("step");
        QTest::addColumn<QStringList>("ends");
        QTest::newRow("flies") << 1 << QStringList{"at rest 6 7.00", "at rest 1 7.00", "at rest 5 7.00", "settles 12"};
        QTest::newRow("two states") << 2
                                    << QStringList{"at rest 0 7.00", "at rest 5 3.80", "at rest 5 7.00",
                                                   "at rest 6 3.80"};
        QTest::newRow("method") << 3
                                << QStringList{"at rest 4 3.80 warns", "at rest 4 7.00", "at rest 4 7.00",
                                               "at rest 6 7.00"};
        QTest::newRow("model") << 4 << QStringList{"at rest 4 1.60",       "failed -5.04", "failed -5.04 warns",
                                                   "at rest 3 1.60 warns", "failed -5.04", "at rest 0 1.60",
                                                   "at rest 0 7.00",       "failed"};
        QTest::newRow("by itself") << 5
                                   << QStringList{"bounces 514 warns", "at rest 22 3.44", "at rest 35 3.45 warns",
                                                  "at rest 11 2.89", "bounces 674"};
    }
    void ends()
    {
        QFETCH(const int, step);
        QFETCH(const QStringList, ends);
        QStringList found;
        for (const LessonRun& each : lessonSteps().at(std::size_t(step) - 1).runs) {
            if (!each.kind.empty()) continue;
            const Summary summary = run(caseOf(each));
            QString text = summary.status == RunStatus::Failed ? QStringLiteral("failed")
                                                               : QString::fromUtf8(name(summary.verdict.motion));
            for (const RunFigure& figure : summary.figures)
                if (figure.quantity.name == "touch_downs" && summary.status == RunStatus::Completed)
                    text += QStringLiteral(" %1").arg(figure.value);
            if (summary.verdict.motion == Motion::AtRest || summary.failure == RunFailure::RearSpringLost)
                text += QStringLiteral(" %1").arg(1e9 * finalHeight(summary), 0, 'f', 2);
            found << (summary.warnings.empty() ? text : text + QStringLiteral(" warns"));
        }
        QCOMPARE(found, ends);
    }

    /// Step 2: the first height at which the slider is caught, in steps of 2 nm, and the next one at which it flies.
    void heightsAtWhichTheSliderIsCaught()
    {
        std::vector<double> changes; // heights at which the end is another than at the height before [nm]
        bool caught = false;
        for (int height = 9; height <= 35; height += 2) {
            const CaseSetting start{"initial.flying_height", std::to_string(height) + " nm"};
            const Summary summary = run(caseOf({"", "fig13a", "", {start, staticPitch}}));
            QCOMPARE(summary.verdict.motion, Motion::AtRest);
            const bool now = finalHeight(summary) < 5e-9;
            if (now != caught) changes.push_back(height);
            caught = now;
        }
        QCOMPARE(changes, (std::vector<double>{19.0, 35.0}));
    }

    /// Step 4: where the drop from 250 nm ends depends on d_1; the two states of rest do not.
    void endsOverTheCutoff_data()
    {
        QTest::addColumn<QString>("cutoff");
        QTest::addColumn<double>("end"); // [nm]
        QTest::newRow("3 nm") << "3 nm" << -5.036;
        QTest::newRow("2.5 nm") << "2.5 nm" << -5.036;
        QTest::newRow("2.2 nm") << "2.2 nm" << 7.0;
        QTest::newRow("1.9 nm") << "1.9 nm" << 1.602;
        QTest::newRow("1 nm") << "1 nm" << 1.602;
        QTest::newRow("0.3 nm") << "0.3 nm" << 1.602;
    }
    void endsOverTheCutoff()
    {
        QFETCH(const QString, cutoff);
        QFETCH(const double, end);
        const auto endOf = [&](std::vector<CaseSetting> settings) {
            settings.push_back({"springs.cutoff", cutoff.toStdString()});
            return 1e9 * finalHeight(run(caseOf({"", "fig12b", "", settings})));
        };
        QVERIFY(std::abs(endOf({}) - end) < 0.001);
        QVERIFY(std::abs(endOf({{"initial.flying_height", "2 nm"}, {"initial.pitch", "94 urad"}}) - 1.602) < 0.001);
        QVERIFY(std::abs(endOf({{"initial.flying_height", "10 nm"}, staticPitch}) - 7.0) < 0.001);
    }

    /// Step 4: steps that do not locate the switches lead to the end of the default method from 2.6 ns down, by
    /// whatever fraction they are shortened: 24 of them in steps of 0.1 ns, and two halvings of the last. The rear
    /// spring is lost 49.45 us after the start, so that 0.1 ms suffices.
    void shortStepsConverge()
    {
        std::vector<double> steps{0.15, 0.075}; // [ns]
        for (int i = 3; i <= 26; ++i) steps.push_back(0.1 * i);
        Case c = sample("fig12b");
        c.run.duration = 0.1e-3;
        QCOMPARE(run(c).failure, RunFailure::RearSpringLost);
        c.run.integrator = IntegratorKind::Rk4;
        for (const double step : steps) {
            c.run.step = step * 1e-9;
            QVERIFY2(run(c).failure == RunFailure::RearSpringLost, qPrintable(QString::number(step)));
        }
    }

    /// A low start with a pitch of 0 presses the front spring together. The starts of the lesson do not, but for the
    /// one that shows what happens then.
    void lowStartsKeepTheStaticPitch()
    {
        std::size_t pressed = 0;
        for (const LessonStep& step : lessonSteps())
            for (const LessonRun& each : step.runs) {
                if (!each.kind.empty()) continue;
                const Case c = caseOf(each);
                if (c.model != ModelKind::Springs) continue;
                const double front = c.springs.frontDistance + c.springs.padDistance; // from the pad [m]
                pressed += c.initial.flyingHeight + front * c.initial.pitch <
                                   0.8 * (c.springs.flyingHeight + front * c.springs.pitch)
                               ? 1
                               : 0;
            }
        QCOMPARE(pressed, std::size_t(1));
    }
};

TOUCHDOWN_TEST(TestLesson)

} // namespace test_lesson

#include "test_lesson.moc"
