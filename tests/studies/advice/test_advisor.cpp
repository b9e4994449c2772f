// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <algorithm>

#include "core/case/contact_kind.h"
#include "core/formats/toml_document.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/advice/advisor.h"
#include "core/studies/advice/advisor_report.h"
#include "core/studies/advice/advisor_study.h"
#include "core/studies/study/study_reader.h"
#include "tests/support/taper_flat.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_advisor {

class TestAdvisor : public QObject {
    Q_OBJECT

private slots:
    void aQuietSceneNeedsItsStaticState();
    void overWavesTheStaticStateIsWrong();
    void aPartThatDecidesIsKept();
    void fewSamplesOfItsOwnDoNotMisleadIt();
    void whereGrowthIsNotKnownItRunsTheWhole();
    void saysThatGrowthIsNotKnown();
    void aModelThatTakesLongerCosts();
    void stopsWhereItIsTold();
    void saysWhatIsWrong_data();
    void saysWhatIsWrong();
    void itsTemplateIsValid();
    void theCandidatesFitTheScene();
    void menisciCanBeLeftOut();
    void aSumLeavesOutWhatCanBeLeftOut();
    void aBoundIsNotWrittenAsAMeasurement();
    void saysThatTheStepErrorWidens();
    void saysWhatWasMissed();
    void whatIsKnownIsTold();
    void whatIsKnownWithoutTheFullModelIsTold();
    void aBudgetEndsIt();
    void whatTheBudgetLeftOutIsTold();
    void aStopBeforeItIsConfirmedKeepsTheAdvice();
    void aBudgetEndsTheConfirmationAlone();
    void theFullModelIsAdvisedAgainstWhatWasTried();
    void sumsHaveTheirPartsTried();
    void aPeakElsewhereIsNotConfirmed();
};

Case taperFlat()
{
    Case c = test::taperFlat();
    c.initial.state = InitialState::Static;
    c.run.duration = 0.3e-3;
    c.film.tolerance = 1e-7;
    return c;
}

Case overWaves()
{
    Case c = taperFlat();
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {2e-9};
    c.diskSurface.waveLengths = {c.disk.speed * c.disk.radius / 100e3}; // passes at 100 kHz
    return c;
}

StudyPerformance plan(const Case& c, const std::string& text, std::vector<InputProblem>& problems)
{
    const TomlDocument toml = readToml(text);
    StudyReader reader(toml, "advice.toml", c, problems);
    reader.setKeys(advisorForm(c).keys);
    StudyPerformance perform = planAdvisor(reader);
    reader.finish();
    return perform;
}

StudyReport perform(const Case& c, const std::string& text, const StudyCallback& callback = {})
{
    std::vector<InputProblem> problems;
    const StudyPerformance ready = plan(c, text, problems);
    if (problems.empty()) return ready(1, callback);
    StudyReport report;
    report.status = StudyStatus::Failed;
    report.message = problems[0].message;
    return report;
}

/// A value of the table of models; what a text or nothing is stays NaN.
double ofModel(const StudyReport& report, const std::string& model, const std::string& column)
{
    const StudyTable& table = report.tables.at(0);
    const auto at = std::ranges::find(table.columns, column, &StudyColumn::name) - table.columns.begin();
    for (const auto& row : table.rows)
        if (std::get<std::string>(row[0]) == model)
            if (const auto* number = std::get_if<double>(&row[static_cast<std::size_t>(at)])) return *number;
    return std::nan("");
}

std::string textOf(const StudyReport& report, const std::string& model, const std::string& column)
{
    const StudyTable& table = report.tables.at(0);
    const auto at = std::ranges::find(table.columns, column, &StudyColumn::name) - table.columns.begin();
    for (const auto& row : table.rows)
        if (std::get<std::string>(row[0]) == model) return std::get<std::string>(row[static_cast<std::size_t>(at)]);
    return {};
}

/// A full model that was run to its end within a second.
AdvisorResult knownResult()
{
    AdvisorResult result;
    result.pilotTime = 1e-3;
    result.pilotWhole = true;
    result.full.verdict = Verdict::Within;
    result.full.seconds = result.studySeconds = 1.0;
    return result;
}

std::string verdict(const StudyReport& report, const std::string& model) { return textOf(report, model, "verdict"); }

// It begins in its static state over a flat disk: nothing moves it away.
void TestAdvisor::aQuietSceneNeedsItsStaticState()
{
    const StudyReport report = perform(taperFlat(), "confirm = true\nmodels = [\"static\", \"parts\"]");
    QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
    QCOMPARE(verdict(report, "static state"), std::string("advised"));
    QVERIFY(report.findings.at(0).starts_with("Advice: static state."));
    QVERIFY(report.findings.at(2).starts_with("Confirmed"));
    QCOMPARE(report.charts.at(0).panels.size(), 2u);
    QVERIFY(report.found);
    QVERIFY(std::abs(steady(*report.found).minimumSpacing - ofModel(report, "full model", "mean")) <=
            1e-11); // twice run.step_error
    QVERIFY(std::ranges::any_of(report.findings, [](const std::string& text) {
        return text.find("as its static state") != std::string::npos;
    }));
}

// A wave of 2 nm passes: the static state has no spread at all, and the linear film answers as the full one. The
// spectrum of the second half of 0.9 ms resolves 1.5/0.45 ms = 3.3 kHz, a peak's place a tenth of that. The run takes
// many times longer than the answer.
void TestAdvisor::overWavesTheStaticStateIsWrong()
{
    Case c = overWaves();
    c.run.duration = 0.9e-3;
    const StudyReport report = perform(c, "pilot = 1.0\nconfirm = true\nmodels = [\"static\", \"wave-answer\"]");
    QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
    QCOMPARE(verdict(report, "static state"), std::string("too far"));
    QCOMPARE(verdict(report, "answer to the waves"), std::string("advised"));
    QVERIFY2(report.findings.at(2).starts_with("Confirmed"), report.findings.at(2).c_str());
    const double full = ofModel(report, "full model", "spread");
    QVERIFY(ofModel(report, "static state", "spread") == 0.0);
    QVERIFY(std::abs(ofModel(report, "answer to the waves", "spread") - full) < 0.05 * full);
    QVERIFY(std::abs(ofModel(report, "full model", "peak_frequency") - 100e3) < 1e3);
}

void TestAdvisor::aPartThatDecidesIsKept()
{
    const StudyReport report = perform(overWaves(), "all = true\nmodels = [\"parts\"]");
    QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
    QCOMPARE(verdict(report, "film, flat disk"), std::string("too far"));
    if (report.found) QVERIFY(report.found->diskSurface.kind == DiskSurfaceKind::Waves);
}

// Seven samples of its own: pilots take a thousand. The case that is advised keeps its own.
void TestAdvisor::fewSamplesOfItsOwnDoNotMisleadIt()
{
    Case c = taperFlat();
    c.run.sampleInterval = 50e-6;
    const StudyReport report = perform(c, "models = [\"static\", \"small-motion\", \"springs\"]");
    QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
    QCOMPARE(verdict(report, "static state"), std::string("advised"));
    const double full = ofModel(report, "full model", "mean");
    QVERIFY(std::abs(ofModel(report, "static state", "mean") - full) <= 1e-11); // twice run.step_error
    QVERIFY(std::abs(ofModel(report, "small motions", "mean") - full) <= 1e-11);
    QVERIFY(!report.found || report.found->run.sampleInterval == c.run.sampleInterval);
}

// Critical damping, 2 sqrt(k m), of 1.6 mg on some MN/m of air is a few N s/m: with a hundred the heave does not
// oscillate, and linear_motion.h has no such modes.
void TestAdvisor::whereGrowthIsNotKnownItRunsTheWhole()
{
    Case c = taperFlat();
    c.suspension.damping = 100.0;
    const StudyReport report = perform(c, "pilot = 0.1\nmodels = [\"static\"]");
    QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
    const auto saysSo = [](const std::string& warning) {
        return warning.find("was run to its end") != std::string::npos;
    };
    QVERIFY(std::any_of(report.warnings.begin(), report.warnings.end(), saysSo));
    QVERIFY2(report.findings.at(1).find("over the whole run") != std::string::npos, report.findings.at(1).c_str());
}

void TestAdvisor::saysThatGrowthIsNotKnown()
{
    AdvisorTask task;
    task.start = taperFlat();
    AdvisorResult result = knownResult();
    result.growthProblem = "no static state was found";
    StudyReport report;
    reportAdvice(task, result, report);
    QCOMPARE(report.warnings.size(), 1u);
    QVERIFY2(report.warnings[0].find("no static state was found") != std::string::npos, report.warnings[0].c_str());
}

void TestAdvisor::aModelThatTakesLongerCosts()
{
    AdvisorTask task;
    task.start = taperFlat();
    AdvisorResult result = knownResult();
    CandidateOutcome slow = result.full;
    slow.model.name = "slow";
    slow.seconds = 1.25;
    result.candidates = {slow};
    StudyReport report;
    reportAdvice(task, result, report);
    QVERIFY(std::ranges::any_of(report.findings,
                                [](const std::string& text) { return text.ends_with("; costs 1.3 times as much."); }));
}

void TestAdvisor::stopsWhereItIsTold()
{
    int calls = 0;
    const StudyReport report = perform(taperFlat(), "", [&](const StudyProgress&) { return ++calls < 2; });
    QCOMPARE(report.status, StudyStatus::Cancelled);
    QVERIFY(!report.message.empty());
}

void TestAdvisor::saysWhatIsWrong_data()
{
    QTest::addColumn<bool>("film");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("key");
    QTest::newRow("springs") << false << ""
                             << "case";
    QTest::newRow("a tolerance of nothing") << true << "tolerance = 0"
                                            << "tolerance";
    QTest::newRow("a pilot beyond the end") << true << "pilot = 1.5"
                                            << "pilot";
    QTest::newRow("a budget of nothing") << true << "budget = 0"
                                         << "budget";
    QTest::newRow("an unknown model") << true << "models = [\"static\", \"magic\"]"
                                      << "models";
    QTest::newRow("an unknown key") << true << "tolerances = 0.1"
                                    << "tolerances";
}

void TestAdvisor::saysWhatIsWrong()
{
    QFETCH(bool, film);
    QFETCH(QString, text);
    QFETCH(QString, key);
    std::vector<InputProblem> problems;
    plan(film ? taperFlat() : Case{}, text.toStdString(), problems);
    QCOMPARE(problems.size(), 1u);
    QCOMPARE(problems[0].key, key.toStdString());
}

void TestAdvisor::itsTemplateIsValid()
{
    std::vector<InputProblem> problems;
    plan(taperFlat(), templateText(advisorForm(taperFlat())), problems);
    QVERIFY2(problems.empty(), problems.empty() ? "" : problems[0].text().c_str());
}

void TestAdvisor::theCandidatesFitTheScene()
{
    AdvisorTask task;
    task.start = overWaves();
    task.start.film.nodes = {129, 65};
    const auto names = [&] {
        std::vector<std::string> list;
        for (const Candidate& candidate : candidatesOf(task, 0.0)) list.push_back(candidate.name);
        return list;
    };
    const auto has = [](const std::vector<std::string>& list, const char* name) {
        return std::ranges::find(list, name) != list.end();
    };
    std::vector<std::string> candidates = names();
    QVERIFY(has(candidates, "answer to the waves") && has(candidates, "film, flat disk") &&
            has(candidates, "film, 65 x 33 grid lines"));
    QVERIFY(!has(candidates, "film, no contact") && !has(candidates, "film, roll held") &&
            !has(candidates, "rest in contact"));
    task.start.diskSurface = {};
    task.start.degreesOfFreedom = 3;
    task.start.contact = ContactKind::OnoYamane;
    candidates = names();
    QVERIFY(!has(candidates, "answer to the waves") && !has(candidates, "film, flat disk"));
    QVERIFY(has(candidates, "film, no contact") && has(candidates, "film, no menisci") &&
            has(candidates, "film, roll held") && has(candidates, "rest in contact"));
}

/// The force of the menisci is left out, whichever law of contact has them.
void TestAdvisor::menisciCanBeLeftOut()
{
    AdvisorTask task;
    task.start = overWaves();
    for (const ContactKind law : {ContactKind::OnoYamane, ContactKind::MultiAsperity}) {
        task.start.contact = law;
        const std::vector<Candidate> candidates = candidatesOf(task, 0.0);
        const auto without = std::ranges::find(candidates, "film, no menisci", &Candidate::name);
        QVERIFY(without != candidates.end());
        QVERIFY(law == ContactKind::OnoYamane ? without->c.onoYamane.meniscusForce == 0.0
                                              : without->c.meniscus.surfaceTension == 0.0);
    }
}

void TestAdvisor::aSumLeavesOutWhatCanBeLeftOut()
{
    AdvisorTask task;
    task.start = overWaves();
    task.start.contact = ContactKind::OnoYamane;
    const ModelPart flat{"flat disk", "the disk's surface", {{"disk.surface.kind", "flat"}}, "surface"};
    const ModelPart grid{"17 x 17 grid lines", "grid lines", {{"film.nodes", "17, 17"}}, "grid"};
    const ModelPart withoutContact{"no contact", "contact", {{"contact", "none"}}, "contact"};
    const ModelPart noMenisci{"no menisci", "menisci", {{"ono_yamane.meniscus_force", "0 N"}}, "adhesion"};
    const std::optional<Candidate> sum = sumOf(task, {flat, grid, withoutContact, noMenisci});
    QVERIFY(sum && sum->parts.size() == 3); // without contact there are no menisci
    QVERIFY(sum->c.diskSurface.kind == DiskSurfaceKind::Flat && sum->c.contact == noContact &&
            sum->c.film.nodes[0] == 17);
    QVERIFY(!sumOf(task, {withoutContact, noMenisci}));
    QCOMPARE(sumOf(task, {grid, flat})->name, sumOf(task, {flat, grid})->name);
    task.models = {"parts"};
    QVERIFY(!sumOf(task, {flat, grid}));
}

// Twice run.step_error, 0.01 nm, is the least that is claimed.
void TestAdvisor::aBoundIsNotWrittenAsAMeasurement()
{
    const StudyReport report = perform(taperFlat(), "models = [\"static\"]");
    QCOMPARE(textOf(report, "static state", "mean_claim"), std::string("< 0.01 nm"));
    QCOMPARE(ofModel(report, "static state", "mean_error_below"), 1e-11);
    QVERIFY(std::isnan(ofModel(report, "static state", "mean_error")));
    QVERIFY2(report.findings.at(1).find("mean spacing < 0.01 nm") != std::string::npos, report.findings.at(1).c_str());
    const ChartPoint& point = report.charts.at(0).panels.at(0).series.at(0).points.at(0);
    QCOMPARE(point.y, 1e-11);
    QCOMPARE(point.label, std::string("static state, < 0.01 nm"));
}

void TestAdvisor::saysThatTheStepErrorWidens()
{
    const auto widens = [](const StudyReport& report) {
        return std::ranges::any_of(report.findings, [](const std::string& text) {
            return text.find("one step may displace the slider by 0.5 nm") != std::string::npos;
        });
    };
    AdvisorTask task;
    task.start = taperFlat();
    AdvisorResult result = knownResult();
    result.full.tail.mean = 10e-9;
    for (const double stepError : {5e-12, 0.5e-9}) {
        task.start.run.stepError = stepError;
        result.allowed = allowanceOf(result.full.tail, task);
        StudyReport report;
        reportAdvice(task, result, report);
        QCOMPARE(widens(report), stepError > 0.1e-9);
    }
}

void TestAdvisor::saysWhatWasMissed()
{
    AdvisorTask task;
    task.start = taperFlat();
    AdvisorResult result = knownResult();
    result.pilotWhole = false;
    result.full.tail = {.kind = EndKind::Flying, .mean = 8.8e-9, .meanUncertainty = 0.02e-9};
    CandidateOutcome advice = result.full;
    advice.model.name = "another";
    advice.errors.mean = 0.1e-9;
    advice.seconds = 0.1;
    result.candidates = {advice};
    result.advice = 0;
    result.fullEnd = result.full.tail;
    result.fullEnd->mean = 9.08e-9;
    result.fullEnd->meanUncertainty = 0.0;
    result.found = CandidateErrors{.mean = 0.3e-9};
    StudyReport report;
    reportAdvice(task, result, report);
    QVERIFY2(
        report.findings.at(2).starts_with(
            "NOT confirmed by the full model to its end: error of the mean spacing 0.3 nm (claimed 0.1 nm: missed)"),
        report.findings.at(2).c_str());
    QVERIFY(std::ranges::any_of(report.findings,
                                [](const std::string& text) { return text.ends_with("; NOT as predicted."); }));
    QCOMPARE(report.warnings.size(), 2u);
}

// Stopped when the full model is known, and the static state with it: its parts are missing.
void TestAdvisor::whatIsKnownIsTold()
{
    bool told = false;
    const StudyReport report =
        perform(taperFlat(), "models = [\"static\", \"parts\"]", [&](const StudyProgress& progress) {
            told = told || progress.soFar != nullptr;
            return !told;
        });
    QVERIFY(told);
    QCOMPARE(report.status, StudyStatus::Cancelled);
    QVERIFY2(report.findings.at(0).starts_with("Advice so far: static state."), report.findings.at(0).c_str());
    QCOMPARE(verdict(report, "static state"), std::string("advised"));
    QVERIFY(std::ranges::any_of(report.warnings, [](const std::string& text) {
        return text.starts_with("the study was stopped before these models were tried: film, ");
    }));
}

// Its static state was found before; the full model takes many times longer than it goes on before it is stopped.
void TestAdvisor::whatIsKnownWithoutTheFullModelIsTold()
{
    Case c = taperFlat();
    c.run.duration = 10e-3;
    const StudyReport report = perform(c, "pilot = 1.0\nmodels = [\"static\"]", [&](const StudyProgress& progress) {
        return progress.doing != "the full model";
    });
    QCOMPARE(report.status, StudyStatus::Cancelled);
    QVERIFY2(report.findings.at(0).starts_with("There is no advice: the full model "), report.findings.at(0).c_str());
    QCOMPARE(verdict(report, "static state"), std::string("not known"));
    QVERIFY(ofModel(report, "static state", "mean") > 0.0);
    QVERIFY(std::isnan(ofModel(report, "static state", "mean_error_below")));
    QVERIFY(report.charts.empty() && !report.found);
}

// Of a film of 33 x 33 lines alone 0.3 ms take longer than 10 ms.
void TestAdvisor::aBudgetEndsIt()
{
    Case c = taperFlat();
    c.suspension.damping = 100.0; // no modes: it is to be run to its end
    const StudyReport report = perform(c, "budget = 0.01\nmodels = [\"parts\"]");
    QCOMPARE(report.status, StudyStatus::Failed);
    QVERIFY2(report.message.find("budget") != std::string::npos, report.message.c_str());
}

void TestAdvisor::whatTheBudgetLeftOutIsTold()
{
    AdvisorTask task;
    task.start = taperFlat();
    task.budget = 2.0;
    AdvisorResult result = knownResult();
    result.late = true;
    result.missing = {"film, flat disk", "film, roll held"};
    StudyReport report;
    reportAdvice(task, result, report);
    QVERIFY2(report.findings.at(0).starts_with("So far there is no advice"), report.findings.at(0).c_str());
    QVERIFY(std::ranges::count(
                report.warnings,
                "the budget of 2 s was spent before these models were tried: film, flat disk, film, roll held") == 1);
    QVERIFY(!report.found);
}

// A pilot of 5 % knows the end of what rests, the static state is it. It is stopped at a share of 0.15 + 0.45 * 0.3: 30
// % of the run.
void TestAdvisor::aStopBeforeItIsConfirmedKeepsTheAdvice()
{
    Case c = taperFlat();
    c.run.duration = 3e-3;
    const StudyReport report =
        perform(c, "pilot = 0.05\nconfirm = true\nmodels = [\"static\", \"parts\"]", [](const StudyProgress& progress) {
            return progress.doing != "the full model" || progress.share < 0.285;
        });
    QCOMPARE(report.status, StudyStatus::Cancelled);
    QVERIFY2(report.findings.at(0).starts_with("Advice so far: static state."), report.findings.at(0).c_str());
    QCOMPARE(verdict(report, "static state"), std::string("advised"));
    QVERIFY(std::ranges::count(report.warnings, "the study was stopped before the advice was confirmed") == 1);
    QVERIFY(std::ranges::any_of(report.warnings, [](const std::string& text) {
        return text.starts_with("the study was stopped before these models were tried: film, ");
    }));
}

// Where nothing was to be confirmed, a budget that is spent at the end has left out nothing.
void TestAdvisor::aBudgetEndsTheConfirmationAlone()
{
    AdvisorTask task;
    task.start = taperFlat();
    task.budget = 2.0;
    AdvisorResult result = knownResult();
    result.late = true;
    for (const bool confirm : {false, true}) {
        task.confirm = confirm;
        StudyReport report;
        reportAdvice(task, result, report);
        QCOMPARE(std::ranges::count(report.warnings, "the budget of 2 s was spent before the advice was confirmed"),
                 confirm ? 1 : 0);
    }
}

// A model that takes 1/1.1 of the full model's time is within, and no advice.
void TestAdvisor::theFullModelIsAdvisedAgainstWhatWasTried()
{
    AdvisorTask task;
    task.start = taperFlat();
    AdvisorResult result = knownResult();
    StudyReport none;
    reportAdvice(task, result, none);
    QCOMPARE(none.findings.at(0), std::string("There is no advice: no other model was tried."));
    QCOMPARE(verdict(none, {}), std::string("reference"));
    QVERIFY(!none.found);
    CandidateOutcome little = result.full, late = result.full;
    little.model.name = "little";
    little.seconds = 1.0 / 1.1;
    late.givenUp = true;
    result.candidates = {little, late};
    StudyReport tried;
    reportAdvice(task, result, tried);
    QCOMPARE(
        tried.findings.at(0),
        std::string(
            "Advice: the full model; none of the models that were tried is known to be within the tolerance and takes "
            "at most 1/1.2 of the full model's time."));
    QVERIFY(tried.found);
    QVERIFY(std::ranges::any_of(
        tried.findings, [](const std::string& text) { return text.starts_with("1 model in time was stopped "); }));
}

// Stopped after its parts began, or before: what is built from them is missing.
void TestAdvisor::sumsHaveTheirPartsTried()
{
    AdvisorTask task;
    task.start = overWaves();
    task.models = {"sums"};
    const std::vector<Candidate> candidates = candidatesOf(task, 0.0);
    QVERIFY(candidates.size() > 1 && std::ranges::all_of(candidates, [](const Candidate& candidate) {
                return candidate.kind == CandidateKind::Part;
            }));
    const StudyReport report = perform(overWaves(), "models = [\"sums\"]",
                                       [](const StudyProgress& progress) { return progress.soFar == nullptr; });
    QCOMPARE(report.status, StudyStatus::Cancelled);
    QVERIFY(std::ranges::any_of(
        report.warnings, [](const std::string& text) { return text.ends_with(", film without several parts"); }));
}

void TestAdvisor::aPeakElsewhereIsNotConfirmed()
{
    AdvisorTask task;
    task.start = taperFlat();
    AdvisorResult result = knownResult();
    result.candidates = {result.full};
    result.advice = 0;
    result.fullEnd = result.full.tail;
    for (const bool same : {true, false}) {
        result.found = CandidateErrors{.samePeak = same};
        StudyReport report;
        reportAdvice(task, result, report);
        QVERIFY2(report.findings.at(2).starts_with(same ? "Confirmed" : "NOT confirmed"),
                 report.findings.at(2).c_str());
        QCOMPARE(report.findings.at(2).find("its largest peak elsewhere: missed") == std::string::npos, same);
    }
}

TOUCHDOWN_TEST(TestAdvisor)

} // namespace test_advisor

#include "test_advisor.moc"
