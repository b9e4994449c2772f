// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_names.h"

#include <algorithm>
#include <deque>
#include <random>

#include <QLocale>
#include <QTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "tests/support/test_program.h"
#include "ui/case/parameter_text.h"

using namespace touchdown;

namespace test_run_names {

Case sample(const char* name) { return openCase(name).value; }

/// Of runs of samples with changes, in their order.
class List {
public:
    void add(const Case& before, const std::function<void(Case&)>& change = {})
    {
        before_.push_back(before);
        values_.push_back(before);
        if (change) change(values_.back());
    }
    QStringList names() const
    {
        std::vector<RunToName> runs;
        for (std::size_t i = 0; i < values_.size(); ++i)
            runs.push_back({static_cast<int>(i) + 1, &values_[i], &before_[i]});
        return runNames(runs);
    }
    const Case& value(qsizetype i) const { return values_[static_cast<std::size_t>(i)]; }

private:
    std::deque<Case> before_, values_;
};

class TestRunNames : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void sayTheCaseWhereCasesDiffer();
    void sayValuesBeforeNumerics();
    void sayNumericsWhereNothingElseDiffers();
    void leaveOutWhatAllShare();
    void sayTheValueThatDiffersOfEachRun();
    void sayTheValueBeforeALongLabel();
    void sayTheNumberOfNamesThatAreAlike();
    void tellDrawnRunsApart();
};

/// Fig. 12 (a) and (b), both with another meniscus force.
void TestRunNames::sayTheCaseWhereCasesDiffer()
{
    List list;
    const auto change = [](Case& c) { c.onoYamane.meniscusForce = 10.7e-3; };
    list.add(sample("fig12a"), change);
    list.add(sample("fig12b"), change);
    list.add(sample("fig13a"));
    QCOMPARE(list.names(),
             (QStringList{"Fig. 12 (a), fₘ 10.7\u00a0mN", "Fig. 12 (b), fₘ 10.7\u00a0mN", "Fig. 13 (a)"}));
}

void TestRunNames::sayValuesBeforeNumerics()
{
    const Case c = sample("springs_waviness");
    List list;
    list.add(c);
    list.add(c, [](Case& changed) {
        changed.run.sampleInterval *= 2.0;
        changed.springs.flyingHeight = 5e-9;
    });
    QCOMPARE(list.names()[1], QStringLiteral("FH 5\u00a0nm"));
}

void TestRunNames::sayNumericsWhereNothingElseDiffers()
{
    const Case c = sample("fig10a");
    List list;
    list.add(c);
    list.add(c, [](Case& changed) { changed.run.duration = 1e-3; });
    list.add(c); // the same case again
    QCOMPARE(list.names(), (QStringList{"Fig. 10 (a)", "duration 1\u00a0ms", "Fig. 10 (a), run 3"}));
}

void TestRunNames::leaveOutWhatAllShare()
{
    const Case c = sample("fig10a");
    List list;
    for (const double force : {1e-3, 2e-3})
        list.add(c, [force](Case& changed) {
            changed.springs.flyingHeight = 5e-9;
            changed.onoYamane.meniscusForce = force;
        });
    QCOMPARE(list.names(), (QStringList{"fₘ 1\u00a0mN", "fₘ 2\u00a0mN"}));
    List alone;
    alone.add(c, [](Case& changed) { changed.springs.flyingHeight = 5e-9; });
    QCOMPARE(alone.names(), QStringList{"Fig. 10 (a), FH 5\u00a0nm"});
}

/// Also of a run as it was opened, where the others changed one thing of it.
void TestRunNames::sayTheValueThatDiffersOfEachRun()
{
    const Case c = sample("fig10a");
    const auto force = [](double value) { return [value](Case& changed) { changed.onoYamane.meniscusForce = value; }; };
    List list;
    list.add(c);
    list.add(c, force(1e-3));
    QCOMPARE(list.names(), (QStringList{"fₘ 10.7\u00a0mN", "fₘ 1\u00a0mN"}));
    list.add(c, force(2e-3));
    QCOMPARE(list.names(), (QStringList{"fₘ 10.7\u00a0mN", "fₘ 1\u00a0mN", "fₘ 2\u00a0mN"}));
    list.add(c, [](Case& changed) { changed.springs.flyingHeight = 5e-9; });
    QCOMPARE(list.names().first(), QStringLiteral("Fig. 10 (a)")); // nothing sets it apart from all
}

void TestRunNames::sayTheValueBeforeALongLabel()
{
    const Case c = sample("fig10a");
    List list;
    list.add(c);
    const Parameter* potential = findParameter("springs.potential");
    list.add(c, [&](Case& changed) {
        for (const std::string& choice : potential->choices)
            if (choice != std::get<std::string>(potential->get(c))) potential->set(changed, choice);
    });
    QVERIFY2(list.names()[1].contains(QStringLiteral(" (pot")), qPrintable(list.names()[1]));
}

/// Two titles that begin with the same twenty characters.
void TestRunNames::sayTheNumberOfNamesThatAreAlike()
{
    List list;
    Case c = sample("fig10a");
    for (const char* title : {"a slider with a long name, one", "a slider with a long name, two"}) {
        c.title = title;
        list.add(c);
    }
    const QStringList names = list.names();
    QCOMPARE(names[1], QStringLiteral("Run 2: ") + names[0]);
}

/// Where the first word that differs begins.
qsizetype differenceOf(const QString& one, const QString& other)
{
    const QStringList a = one.split(u' '), b = other.split(u' ');
    qsizetype at = 0;
    for (qsizetype word = 0; word < std::min(a.size(), b.size()) && a[word] == b[word]; ++word)
        at += a[word].size() + 1;
    return at;
}

/// Lists of up to ten runs of up to three samples, each with up to four changes. Names differ where cases do, early,
/// and are short. Few need their number.
void TestRunNames::tellDrawnRunsApart()
{
    std::vector<Case> samples;
    for (const SampleCase& each : sampleCases()) samples.push_back(parseCase(each.text, each.name).value);
    std::mt19937 generator(17);
    const auto draw = [&](std::size_t below) {
        return std::uniform_int_distribution<std::size_t>(0, below - 1)(generator);
    };
    int names = 0, numbered = 0;
    for (int repeat = 0; repeat < 200; ++repeat) {
        List list;
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0, count = 1 + draw(3); i < count; ++i) chosen.push_back(draw(samples.size()));
        for (std::size_t i = 0, count = 2 + draw(9); i < count; ++i) {
            const Case& before = samples[chosen[draw(chosen.size())]];
            list.add(before, [&](Case& c) {
                for (std::size_t k = draw(5); k > 0; --k) {
                    const Parameter& parameter = parameters()[draw(parameters().size())];
                    if (!parameter.used(c)) continue;
                    if (parameter.kind == ParameterKind::Number)
                        setFromNumber(c, parameter,
                                      numberOf(parameter, c) * (1.0 + 0.1 * static_cast<double>(1 + draw(5))));
                    else if (parameter.kind == ParameterKind::Choice)
                        setFromText(c, parameter, parameter.choices[draw(parameter.choices.size())]);
                }
            });
        }
        const QStringList all = list.names();
        for (qsizetype i = 0; i < all.size(); ++i) {
            ++names;
            bool equal = false; // to a run before it
            QVERIFY(!all[i].trimmed().isEmpty());
            QVERIFY2(all[i].size() <= longestRunName, qPrintable(all[i]));
            for (qsizetype k = 0; k < i; ++k) {
                const Case &a = list.value(i), &b = list.value(k);
                if (a.title == b.title && caseDifference(a, b).isEmpty()) {
                    equal = true;
                    continue;
                }
                QVERIFY2(all[i] != all[k], qPrintable(all[i]));
                QVERIFY2(differenceOf(all[i], all[k]) < earlyDifference, qPrintable(all[k] + " | " + all[i]));
            }
            numbered += !equal && all[i].startsWith(QStringLiteral("Run ")) ? 1 : 0;
        }
    }
    QVERIFY2(numbered < names / 10, qPrintable(QStringLiteral("%1 of %2").arg(numbered).arg(names)));
}

TOUCHDOWN_TEST(TestRunNames)

} // namespace test_run_names

#include "test_run_names.moc"
