// SPDX-License-Identifier: GPL-3.0-or-later
//
// The demonstrations of the paper's figures: they are read, their values can be moved, and what they say of shares of
// starts is what a run of each start gives.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/parameters.h"
#include "core/simulation/run.h"
#include "core/studies/lesson/lesson.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_demonstrations {

const std::string head = "[[step]]\ntitle = 'a'\nchange = 'd'\nanswer = 'e'\nstage.plots = ['spacing']\n";
const std::string drop = "[[step.run]]\npurpose = 'x'\ncase = 'fig10a'\n";

QString problemsOf(const std::string& text)
{
    QString all;
    for (const InputProblem& problem : readLesson(text, "d.toml").problems)
        all += QString::fromStdString(problem.text()) + '\n';
    return all;
}

double finalHeight(const Case& c) // [nm]
{
    for (const auto& [quantity, value] : run(c).final)
        if (quantity == "flying_height") return value * 1e9;
    return NAN;
}

class TestDemonstrations : public QObject {
    Q_OBJECT

private slots:
    void hasAllFigures()
    {
        for (const LessonText& each : lessonTexts()) {
            const QString problems = problemsOf(each.text);
            QVERIFY2(problems.isEmpty(), qPrintable(problems));
        }
        QStringList titles;
        for (const LessonStep& step : demonstrationSteps())
            titles << QString::fromStdString(step.title).section(u':', 0, 0);
        QCOMPARE(titles, (QStringList{"Fig. 2", "Fig. 5", "Fig. 6", "Fig. 7", "Fig. 8", "Fig. 10", "Fig. 11", "Fig. 12",
                                      "Fig. 13", "Fig. 14", "Table III", "Not in the paper", "Not in the paper"}));
    }

    void takesTextsFromTheCase()
    {
        const LessonStep step = readLesson(head + drop, "d.toml").steps.at(0);
        QCOMPARE(step.text, sample("fig10a").about.paper);
        QCOMPARE(step.question, sample("fig10a").about.watch);
        // Without a case they must be given.
        QVERIFY(problemsOf(head).contains("step[1].text: is missing"));
        const LessonStep given =
            readLesson("[[step]]\ntext = 't'\nquestion = 'q'\n" + head.substr(9) + drop, "d").steps[0];
        QCOMPARE(given.text, std::string("t"));
        QCOMPARE(given.question, std::string("q"));
    }

    /// A case with its value at either end, and at the ends of all values together, can run.
    void valuesCanBeMoved()
    {
        for (const LessonStep& step : demonstrationSteps()) {
            QVERIFY(!step.live.empty());
            const Case own = caseOf(step.runs.front());
            std::vector<Case> cases{own};
            for (const LiveValue& value : step.live) {
                QVERIFY(value.from < value.until);
                const std::vector<Case> before = cases;
                for (const Case& c : before)
                    for (const double end : {value.from, value.until}) {
                        cases.push_back(c);
                        for (const std::string& key : value.keys)
                            QVERIFY(!setFromNumber(cases.back(), *findParameter(key), end));
                    }
            }
            for (const Case& c : cases) {
                const std::vector<CaseProblem> problems = checkCombinations(c);
                QVERIFY2(problems.empty(), (step.title + ": " + (problems.empty() ? "" : problems[0].message)).c_str());
            }
        }
    }

    void wrongValues_data()
    {
        QTest::addColumn<QString>("live");
        QTest::addColumn<QString>("says");
        QTest::newRow("no key") << "from = '1'\nuntil = '2'"
                                << "step[1].live[1].keys: is missing";
        QTest::newRow("unknown") << "keys = ['springs.colour']\nfrom = '1'\nuntil = '2'"
                                 << "live[1].keys: \"springs.colour\" is no parameter with a number";
        QTest::newRow("a choice") << "keys = ['run.integrator']\nfrom = '1'\nuntil = '2'"
                                  << "live[1].keys: \"run.integrator\" is no parameter with a number";
        QTest::newRow("unused") << "keys = ['run.step']\nfrom = '1 ns'\nuntil = '2 ns'"
                                << "live[1].keys: has no effect here";
        QTest::newRow("one end") << "keys = ['springs.cutoff']\nuntil = '2 nm'"
                                 << "live[1].from: is missing";
        QTest::newRow("out of range") << "keys = ['springs.cutoff']\nfrom = '-1 nm'\nuntil = '2 nm'"
                                      << "live[1].from: must be";
        QTest::newRow("beside the case") << "keys = ['springs.cutoff']\nfrom = '1 nm'\nuntil = '2 nm'"
                                         << "live[1].from: and the other end do not enclose the value of the case";
    }
    void wrongValues()
    {
        QFETCH(const QString, live);
        QFETCH(const QString, says);
        const QString said = problemsOf(head + drop + "[[step.live]]\n" + live.toStdString() + '\n');
        QVERIFY2(said.contains(says), qPrintable(said));
    }

    void wrongSettings()
    {
        const QString said = problemsOf(head + drop + "set = { run.tolerance = '2 nm' }\n");
        QVERIFY2(said.contains("step[1].run[1].set: run.tolerance"), qPrintable(said));
    }

    void stepsOfEqualRatio()
    {
        QVERIFY((LiveValue{{}, 1.0, 20.0, {}}).logarithmic());
        QVERIFY(!(LiveValue{{}, 1.0, 19.0, {}}).logarithmic());
        QVERIFY(!(LiveValue{{}, 0.0, 20.0, {}}).logarithmic());
    }

    /// "Of 101 starts from 240 to 260 nm, 95 end flying at 7.00 nm": each start is run.
    void sharesOfStarts_data()
    {
        QTest::addColumn<int>("step");
        int count = 0;
        for (std::size_t i = 0; i < demonstrationSteps().size(); ++i) {
            if (caseOf(demonstrationSteps()[i].runs.front()).model != ModelKind::Springs) continue;
            if (demonstrationSteps()[i].title.starts_with("Not")) continue;
            QTest::newRow(demonstrationSteps()[i].title.c_str()) << static_cast<int>(i);
            ++count;
        }
        QCOMPARE(count, 6);
    }
    void sharesOfStarts()
    {
        QFETCH(const int, step);
        const LessonStep& shown = demonstrationSteps().at(std::size_t(step));
        static const QRegularExpression sentence("Of (\\d+) starts from (\\d+) to (\\d+) nm, (\\d+) end (?:flying|in "
                                                 "contact)(?: at| within ([\\d.]+) nm of) "
                                                 "([\\d.]+) nm");
        const QRegularExpressionMatch said = sentence.match(QString::fromStdString(shown.answer).simplified());
        QVERIFY2(said.hasMatch(), shown.answer.c_str());
        const int starts = said.captured(1).toInt();
        const double low = said.captured(2).toDouble(), high = said.captured(3).toDouble();
        const double allowed = said.capturedLength(5) > 0 ? said.captured(5).toDouble() : 0.005; // [nm]
        const double end = said.captured(6).toDouble();
        int found = 0;
        Case c = caseOf(shown.runs.front());
        for (int i = 0; i < starts; ++i) {
            c.initial.flyingHeight = 1e-9 * (low + (high - low) * i / (starts - 1));
            found += std::abs(finalHeight(c) - end) <= allowed ? 1 : 0;
        }
        QCOMPARE(found, said.captured(4).toInt());
    }

    /// "It swings by 3.7 nm at 0.16 nm": each amplitude and each length of the waves is run for 2 ms. The swing is that
    /// of the last tenth, of which the sentence gives one decimal. Between two of the amplitudes a motion ends, so that
    /// the swing doubles; until then it is 20 times the amplitude.
    void swingsOverWaves()
    {
        const LessonStep& waves = demonstrationSteps().back();
        static const QRegularExpression sentence("by ([\\d.]+) nm at ([\\d.]+) (nm|um)");
        auto each = sentence.globalMatch(QString::fromStdString(waves.answer).simplified());
        int amplitudes = 0, lengths = 0;
        while (each.hasNext()) {
            const QRegularExpressionMatch said = each.next();
            const double value = said.captured(2).toDouble();
            Case c = caseOf(waves.runs.front());
            c.run.duration = 2e-3;
            if (said.captured(3) == "nm")
                c.diskSurface.waveAmplitudes = {1e-9 * value};
            else
                c.diskSurface.waveLengths = {1e-6 * value};
            (said.captured(3) == "nm" ? amplitudes : lengths) += 1;
            double swing = NAN; // [nm]
            for (const auto& [quantity, tail] : run(c).tail)
                if (quantity == "minimum_spacing") swing = (tail.max - tail.min) * 1e9;
            QVERIFY2(std::abs(swing - said.captured(1).toDouble()) <= 0.051,
                     qPrintable(QString("%1: %2").arg(said.captured()).arg(swing)));
        }
        QCOMPARE(amplitudes, 5);
        QCOMPARE(lengths, 3);
    }

    /// A film takes too long for a test: its shares and heights are those of the cards of its cases, which are checked
    /// with the study that they come from.
    void numbersOfFilms()
    {
        static const QRegularExpression number("\\d+ of \\d+|[\\d.]*\\d");
        for (const LessonStep& step : demonstrationSteps()) {
            if (caseOf(step.runs.front()).model != ModelKind::Film) continue;
            QString known = "Fig. 8 5 nm"; // what the text refers to, and a height that the study of the paper has
            for (const LessonRun& each : step.runs) {
                const Case c = caseOf(each);
                known += QString::fromStdString(' ' + c.title + ' ' + c.about.paper + ' ' + c.about.watch);
            }
            const QString text = QString::fromStdString(step.answer + ' ' + step.change).simplified();
            auto match = number.globalMatch(text);
            while (match.hasNext()) {
                const QString each = match.next().captured();
                QVERIFY2(known.contains(each), qPrintable(each + " in " + QString::fromStdString(step.title)));
            }
        }
    }
};

TOUCHDOWN_TEST(TestDemonstrations)

} // namespace test_demonstrations

#include "test_demonstrations.moc"
