// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/lesson/lesson.h"

#include <cmath>

#include <QTest>

#include "core/simulation/run.h"
#include "core/studies/study_plan.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_lesson {

constexpr std::size_t springSteps = 5; // all but the last, which has a film

struct Amount {
    double value;
    QString unit;
    int decimals;
    QString text; // "7.00 nm"
};

/// Numbers with a unit, as a text says them.
std::vector<Amount> amountsIn(const std::string& text)
{
    static const QRegularExpression number(QStringLiteral("(-?\\d+(?:\\.(\\d+))?) (nm|urad|mN|pJ|us|ms|ns)\\b"));
    std::vector<Amount> amounts;
    auto match = number.globalMatch(QString::fromStdString(text).simplified());
    while (match.hasNext()) {
        const QRegularExpressionMatch m = match.next();
        amounts.push_back({m.captured(1).toDouble(), m.captured(3), int(m.capturedLength(2)), m.captured()});
    }
    return amounts;
}

Case caseOf(const LessonRun& lessonRun)
{
    Case c = sample(lessonRun.name);
    const std::string problem = changeCase(c, lessonRun.settings);
    if (!problem.empty()) qFatal("%s", problem.c_str());
    return c;
}

/// What a run gives, with all its digits.
void addFacts(std::vector<Amount>& facts, const Summary& summary)
{
    for (const auto& [quantity, value] : summary.final) {
        if (quantity == "flying_height") facts.push_back({value * 1e9, "nm", 9, {}});
        if (quantity == "pitch") facts.push_back({value * 1e6, "urad", 9, {}});
        if (quantity == "net_contact_force") facts.push_back({-value * 1e3, "mN", 9, {}});
    }
    for (const auto& [quantity, tail] : summary.tail)
        if (quantity == "minimum_spacing") facts.push_back({(tail.max - tail.min) * 1e9, "nm", 9, {}});
    for (const RunFigure& figure : summary.figures)
        if (figure.quantity.name == "cycle_work") facts.push_back({figure.value * 1e12, "pJ", 9, {}});
    for (const Amount& amount : amountsIn(summary.message)) facts.push_back(amount);
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
        const Lesson lesson = readLesson(lessonTexts().front().text, "lesson.toml");
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
                    QCOMPARE(changeCase(c, each.settings), std::string());
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
                                 << "l.toml:8: is not TOML";
        QTest::newRow("no purpose") << "case = 'fig10a'"
                                    << "l.toml:7: step[1].run[1].purpose: is missing";
        QTest::newRow("no case") << "purpose = 'x'"
                                 << "step[1].run[1].case: is missing";
        QTest::newRow("unknown case") << "purpose = 'x'\ncase = 'fig99'"
                                      << "\"fig99\" is no sample case";
        QTest::newRow("unknown study") << "purpose = 'x'\nstudy = 'fig10a'"
                                       << "\"fig10a\" is no sample study";
        QTest::newRow("unknown key") << "purpose = 'x'\ncase = 'fig10a'\nsets = 1"
                                     << "l.toml:10: step[1].run[1].sets: unknown key";
    }
    void problems()
    {
        QFETCH(const QString, run);
        QFETCH(const QString, says);
        const std::string step = "[[step]]\ntitle = 'a'\ntext = 'b'\nquestion = 'c'\nchange = 'd'\nanswer = 'e'\n";
        const QString said = problemsOf(readLesson(step + "[[step.run]]\n" + run.toStdString() + '\n', "l.toml"));
        QVERIFY2(said.contains(says), qPrintable(said));
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
        for (const LessonRun& each : lesson.runs) {
            if (!each.kind.empty()) {
                // The map takes 15 s, and the answer has no number of it.
                if (each.name == "cycles_map_paper") continue;
                for (const std::string& finding : openStudy(each.kind, each.name).perform(2, {}).findings)
                    for (const Amount& amount : amountsIn(finding)) facts.push_back(amount);
                continue;
            }
            const Case c = caseOf(each);
            for (const CaseSetting& setting : each.settings)
                for (const Amount& amount : amountsIn(setting.value)) facts.push_back(amount);
            facts.push_back({c.initial.flyingHeight * 1e9, "nm", 9, {}});
            facts.push_back({c.springs.cutoff * 1e9, "nm", 9, {}});
            facts.push_back({c.run.duration * 1e3, "ms", 9, {}});
            facts.push_back({c.run.step * 1e9, "ns", 9, {}});
            addFacts(facts, run(c));
        }
        for (const Amount& said : amountsIn(lesson.answer)) {
            const double half = 0.5 * std::pow(10.0, -said.decimals);
            const bool found = std::ranges::any_of(facts, [&](const Amount& fact) {
                return fact.unit == said.unit && fact.decimals >= said.decimals &&
                       std::abs(fact.value - said.value) <= half * (1.0 + 1e-9);
            });
            QVERIFY2(found, qPrintable(said.text));
        }
    }

    /// What the answers say of the end of each run.
    void ends_data()
    {
        QTest::addColumn<int>("step");
        QTest::addColumn<QStringList>("ends");
        QTest::newRow("flies") << 1 << QStringList{"at rest 6", "at rest 5", "settles 12"};
        QTest::newRow("two states") << 2 << QStringList{"at rest 3", "at rest 5", "at rest 5"};
        QTest::newRow("method") << 3 << QStringList{"at rest 4 warns", "at rest 4", "at rest 4", "at rest 6"};
        QTest::newRow("model") << 4 << QStringList{"at rest 4", "failed", "failed"};
        QTest::newRow("by itself") << 5 << QStringList{"bounces 514 warns", "at rest 22", "at rest 11", "bounces 674"};
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
            found << (summary.warnings.empty() ? text : text + QStringLiteral(" warns"));
        }
        QCOMPARE(found, ends);
    }
};

TOUCHDOWN_TEST(TestLesson)

} // namespace test_lesson

#include "test_lesson.moc"
