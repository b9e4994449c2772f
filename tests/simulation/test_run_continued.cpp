// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run that continues from one of its states tells the same, bit for bit, as one that was never interrupted.
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/simulation/recording/run_checkpoint.h"
#include "core/simulation/run.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_continued {

std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }

/// All that a run told, as bits and texts.
struct Told {
    std::vector<std::vector<std::uint64_t>> samples; // one row each
    std::vector<std::string> events;
    std::vector<std::vector<std::uint64_t>> maps;
    struct State {
        RunCheckpoint at;
        std::size_t samples, maps; // before it
    };
    std::vector<State> states;
    Summary summary;
};

/// Goes on with what `before` told up to the state.
Told tell(const Case& c, RunOptions options, const Told* before = nullptr, std::size_t state = 0)
{
    Told told;
    if (before) {
        const Told::State& from = before->states[state];
        told.samples.assign(before->samples.begin(), before->samples.begin() + std::ptrdiff_t(from.samples));
        told.maps.assign(before->maps.begin(), before->maps.begin() + std::ptrdiff_t(from.maps));
        options.from = std::make_shared<const RunCheckpoint>(from.at);
    }
    const auto receive = [&](const RunUpdate& update) {
        for (std::size_t k = 0; k < update.samples.size(); ++k) {
            std::vector<std::uint64_t>& row = told.samples.emplace_back(1, bitsOf(update.samples.time[k]));
            for (const std::vector<double>& column : update.samples.columns) row.push_back(bitsOf(column[k]));
        }
        for (const FieldSnapshot& map : update.fields) {
            std::vector<std::uint64_t>& values = told.maps.emplace_back(1, bitsOf(map.time));
            for (const std::vector<double>& field : map.values)
                for (const double value : field) values.push_back(bitsOf(value));
        }
        if (update.checkpoint) told.states.push_back({*update.checkpoint, told.samples.size(), told.maps.size()});
        return true;
    };
    told.summary = run(c, receive, options);
    for (const RunEvent& event : told.summary.events)
        told.events.push_back(event.name + ' ' + std::to_string(bitsOf(event.time)));
    return told;
}

/// "film_time", and the share of it that was saved.
bool isOfClock(const RunFigure& figure)
{
    return figure.ofSolver && (figure.quantity.name.ends_with("_time") || figure.quantity.name == "contact_saved");
}

/// Every number of the summary but times of the clock.
std::vector<std::string> linesOf(const Summary& s)
{
    std::vector<std::string> lines{std::string(name(s.status)) + s.message, std::to_string(s.steps),
                                   std::to_string(s.rejectedSteps), std::to_string(s.evaluations), s.verdict.rule};
    const auto add = [&](const std::string& text, std::initializer_list<double> values) {
        lines.push_back(text);
        for (const double value : values) lines.back() += ' ' + std::to_string(bitsOf(value));
    };
    add("end", {s.endTime, s.verdict.swing, s.verdict.rms, s.verdict.frequency});
    for (const auto& [key, value] : s.final) add(key, {value});
    for (const auto& [key, value] : s.tail) add(key, {value.mean, value.std, value.min, value.max});
    for (const auto& [key, value] : s.extremes) add(key, {value.least, value.most});
    for (const Peak& peak : s.peaks) add("peak", {peak.frequency, peak.amplitude});
    for (const RunFigure& figure : s.figures)
        if (!isOfClock(figure)) add(figure.quantity.name, {figure.value});
    if (s.stepCheck) add(s.stepCheck->message, {s.stepCheck->flyingHeight, s.stepCheck->pitch});
    if (s.fit) add(s.fit->message, {s.fit->contact.worst});
    lines.insert(lines.end(), s.warnings.begin(), s.warnings.end());
    return lines;
}

/// Where they differ; "" where they do not.
std::string difference(const Told& a, const Told& b)
{
    if (a.samples.size() != b.samples.size())
        return std::to_string(a.samples.size()) + " and " + std::to_string(b.samples.size()) + " samples";
    for (std::size_t k = 0; k < a.samples.size(); ++k)
        if (a.samples[k] != b.samples[k]) return "sample " + std::to_string(k);
    if (a.events != b.events) return "events";
    if (a.maps != b.maps) return "maps";
    const std::vector<std::string> left = linesOf(a.summary), right = linesOf(b.summary);
    for (std::size_t k = 0; k < std::min(left.size(), right.size()); ++k)
        if (left[k] != right[k]) return left[k] + " | " + right[k];
    return left.size() == right.size() ? "" : "lines of the summary";
}

RunOptions eachTime()
{
    RunOptions options;
    options.checkpointEach = 0.0;
    return options;
}

Case springs(const char* name, IntegratorKind integrator)
{
    Case c = sample(name);
    c.run.integrator = integrator;
    c.run.duration = 0.4e-3;
    return c;
}

Case film(const char* name, double duration, int maps = 4)
{
    Case c = sample(name);
    c.film.nodes = {33, 33};
    c.steady.stiffness = false;
    c.run.duration = duration;
    c.run.sampleInterval = duration / 50.0;
    c.run.fieldSnapshots = maps;
    return c;
}

void same(const Told& a, const Told& b)
{
    const std::string other = difference(a, b);
    QVERIFY2(other.empty(), other.c_str());
}

using Make = std::function<Case()>;

class TestRunContinued : public QObject {
    Q_OBJECT

private slots:
    void tellsTheSame_data()
    {
        QTest::addColumn<Make>("make");
        const auto add = [](const char* name, Make make) { QTest::newRow(name) << make; };
        add("dopri5", [] { return springs("fig10a", IntegratorKind::Dopri5); });
        add("rk4, step check", [] { return springs("fig10a", IntegratorKind::Rk4); });
        add("rk4-events", [] { return springs("fig13b", IntegratorKind::Rk4Events); });
        add("newmark", [] { return springs("fig13b", IntegratorKind::Newmark); });
        add("loose tolerance", [] {
            Case c = springs("fig10a", IntegratorKind::Dopri5);
            c.run.tolerance = 1e-3;
            return c;
        });
        add("waves", [] { return springs("springs_waviness", IntegratorKind::Dopri5); });
        add("waves, contact", [] {
            Case c = springs("springs_waviness", IntegratorKind::Dopri5);
            c.contact = ContactKind::OnoYamane;
            c.run.stepCheck = true;
            return c;
        });
        for (const char* name : {"contact_ono_yamane", "contact_ono_yamane_full", "contact_greenwood_williamson",
                                 "contact_hertz", "contact_rough", "contact_waves", "contact_pull_off"})
            add(name, [name] {
                Case c = sample(name);
                c.run.sampleInterval = c.run.duration / 100.0;
                return c;
            });
        add("film, flies", [] { return film("film_pico", 10e-6); });
        add("film, menisci", [] { return film("advise_snap", 10e-6, 0); });
        add("film, asperities", [] {
            Case c = film("advise_snap", 10e-6);
            c.contact = ContactKind::Asperity;
            return c;
        });
        add("film, many asperities", [] {
            Case c = film("advise_snap", 10e-6);
            c.contact = ContactKind::MultiAsperity;
            return c;
        });
        add("film, elastic, rough", [] { return film("fig02_case_2_moving", 3e-6); });
        add("film, elastic, flat", [] { return film("film_fig1_micro_pad", 5e-6); });
        add("film, waves", [] { return film("advise_waviness", 8e-6); });
        add("film, staggered", [] {
            Case c = film("advise_snap", 5e-6);
            c.film.coupling = FilmCoupling::Staggered;
            return c;
        });
        add("film, fixed steps", [] {
            Case c = film("film_pico", 5e-6);
            c.run.steps = StepControl::Fixed;
            c.run.step = 20e-9;
            return c;
        });
    }
    void tellsTheSame()
    {
        QFETCH(Make, make);
        const Case c = make();
        const std::vector<CaseProblem> problems = checkCombinations(c);
        QVERIFY2(problems.empty(), problems.empty() ? "" : problems.front().message.c_str());
        const Told whole = tell(c, {});
        QVERIFY(whole.states.empty());
        const Told kept = tell(c, eachTime());
        same(whole, kept);
        QVERIFY(!kept.states.empty());
        std::mt19937 draw(60);
        const Told again = tell(c, eachTime(), &kept, draw() % kept.states.size());
        same(whole, again);
        if (!again.states.empty()) same(whole, tell(c, {}, &again, draw() % again.states.size()));
    }

    void becomesLonger_data()
    {
        QTest::addColumn<Make>("make");
        QTest::newRow("springs") << Make([] { return springs("fig10a", IntegratorKind::Dopri5); });
        QTest::newRow("springs, fixed steps") << Make([] { return springs("fig13b", IntegratorKind::Rk4Events); });
        QTest::newRow("springs over waves") << Make([] {
            Case c = springs("springs_waviness", IntegratorKind::Dopri5);
            c.initial.flyingHeight = 33e-9;
            return c;
        });
        QTest::newRow("springs over waves, contact") << Make([] {
            Case c = springs("springs_waviness", IntegratorKind::Rk4Events);
            c.contact = ContactKind::OnoYamane;
            c.initial.flyingHeight = 90e-9;
            return c;
        });
        QTest::newRow("film") << Make([] { return film("film_pico", 150e-6, 0); });
        QTest::newRow("film, menisci") << Make([] { return film("advise_snap", 150e-6, 0); });
    }
    void becomesLonger()
    {
        QFETCH(Make, make);
        const Case c = make();
        const Told whole = tell(c, {});
        Case shorter = c;
        shorter.run.duration = 0.7 * c.run.duration;
        const Told first = tell(shorter, eachTime());
        const auto last = std::ranges::find_if(first.states.rbegin(), first.states.rend(),
                                               [](const Told::State& state) { return state.at.extends; });
        QVERIFY(last != first.states.rend());
        QVERIFY(last->at.time > 0.4 * shorter.run.duration);
        same(whole, tell(c, {}, &first, std::size_t(first.states.rend() - last) - 1));
    }

    void whatDependsOnTheDurationDoesNotBecomeLonger()
    {
        for (const Case& c : {film("film_pico", 20e-6), sample("contact_hertz")}) // maps, the pad's way
            for (const Told::State& state : tell(c, eachTime()).states) QVERIFY(!state.at.extends);
    }

    void anotherStateIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"fig10a", "contact_pull_off"}) QTest::newRow(name) << name;
    }
    void anotherStateIsRefused()
    {
        QFETCH(QString, name);
        const Case c = sample(name.toStdString());
        const Told kept = tell(c, eachTime());
        QVERIFY(!kept.states.empty());
        const std::string& state = kept.states.front().at.state;
        for (const std::size_t bytes : {std::size_t{0}, std::size_t{8}, state.size() / 2, state.size() - 1}) {
            RunOptions options;
            options.from = std::make_shared<const RunCheckpoint>(RunCheckpoint{0.0, false, state.substr(0, bytes)});
            const Summary summary = run(c, {}, options);
            QCOMPARE(summary.status, RunStatus::Failed);
            QVERIFY2(summary.message.find("cannot be continued") != std::string::npos, summary.message.c_str());
        }
        RunOptions options;
        options.from = std::make_shared<const RunCheckpoint>(RunCheckpoint{0.0, false, state + "x"});
        QCOMPARE(run(c, {}, options).status, RunStatus::Failed);
    }

    void cvodeDoesNotContinue()
    {
        Case c = springs("fig10a", IntegratorKind::Cvode);
        if (!reasonNotToRun(c).empty()) QSKIP("without SUNDIALS");
        QVERIFY(tell(c, eachTime()).states.empty());
        RunOptions options;
        options.from = std::make_shared<const RunCheckpoint>();
        const Summary summary = run(c, {}, options);
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY(summary.message.find("cvode") != std::string::npos);
    }
};

} // namespace test_run_continued

using test_run_continued::TestRunContinued;
TOUCHDOWN_TEST(TestRunContinued)
#include "test_run_continued.moc"
