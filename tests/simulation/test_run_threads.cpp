// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs, static states, modes and studies have the same bits on any number of threads.
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/studies/study_plan.h"
#include "core/work/team.h"
#include "core/work/team_trials.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_run_threads {

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); }

/// -1: none.
std::ptrdiff_t firstDifference(const Bits& a, const Bits& b)
{
    const auto at = std::ranges::mismatch(a, b).in1;
    return a.size() == b.size() && at == a.end() ? -1 : at - a.begin();
}

/// Rows enough for seven threads.
Case film(const char* name)
{
    Case c = sample(name);
    c.film.nodes = {49, 177};
    c.film.grid = GridKind::Uniform;
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = 0.5e-9;
    c.run.fieldSnapshots = 1;
    return c;
}

/// Samples come in batches, whose lengths depend on the clock.
Bits bitsOfRun(const Case& c)
{
    Bits maps;
    std::vector<Bits> columns(recordedQuantities(c).size());
    const Summary summary = run(c, [&](const RunUpdate& update) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            for (const double value : update.samples.columns[k]) add(columns[k], value);
        for (const FieldSnapshot& map : update.fields)
            for (const std::vector<double>& field : map.values)
                for (const double value : field) add(maps, value);
        return true;
    });
    if (summary.status != RunStatus::Completed) qFatal("%s", summary.message.c_str());
    Bits bits{static_cast<std::uint64_t>(summary.steps)};
    for (const Bits& column : columns) bits.insert(bits.end(), column.begin(), column.end());
    bits.insert(bits.end(), maps.begin(), maps.end());
    return bits;
}

Bits bitsOfState(const Case& c)
{
    Bits bits;
    const SteadyResult state = steadyWithContact(c);
    if (!state.balanced()) qFatal("%s", state.message.c_str());
    for (const auto& [quantity, value] : steadyQuantities(state)) add(bits, value);
    for (const double p : state.pressure) add(bits, p);
    return bits;
}

Bits bitsOfModes(const Case& c)
{
    Bits bits;
    const ModesResult result = modes(c);
    if (result.modes.empty()) qFatal("%s", result.message.c_str());
    for (const AirBearingMode& mode : result.modes)
        for (const double value : {mode.frequency, mode.dampingRatio, mode.frequencyError, mode.dampingError})
            add(bits, value);
    return bits;
}

Bits bitsOfStudy(const Case& c, int jobs)
{
    const StudyPlan plan =
        parseStudy("sweep",
                   "calculate = \"steady\"\n[[axis]]\nkey = \"suspension.preload\"\nfrom = \"14 mN\"\n"
                   "to = \"16 mN\"\ncount = 3\n[[reading]]\nquantity = \"minimum_spacing\"\n",
                   "study", {}, &c);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    Bits bits;
    const StudyReport report = plan.perform(jobs, {});
    if (report.tables.empty()) qFatal("%s", report.message.c_str());
    for (const auto& row : report.tables.front().rows)
        for (const StudyValue& value : row)
            if (const double* number = std::get_if<double>(&value)) add(bits, *number);
    if (bits.size() < 6) qFatal("no rows");
    return bits;
}

class TestRunThreads : public QObject {
    Q_OBJECT

private slots:
    /// Every loop is shared, however busy the cores are.
    void initTestCase() { setTeamTrials(false); }
    void cleanupTestCase() { setTeamTrials(true); }

    void runs_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("duration");
        QTest::newRow("flying") << "film_pico" << 4e-6;
        QTest::newRow("adhesion") << "fig06_de_4nm" << 2e-6;
        QTest::newRow("rough disk that moves, contact") << "fig02_case_2_moving" << 0.2e-6;
    }
    void runs()
    {
        QFETCH(QString, name);
        QFETCH(double, duration);
        Case c = film(qPrintable(name));
        c.run.duration = duration;
        c.run.sampleInterval = 0.1 * duration;
        c.run.threads = 1;
        const Bits alone = bitsOfRun(c);
        for (const int threads : {2, 3, 7}) {
            c.run.threads = threads;
            QCOMPARE(firstDifference(bitsOfRun(c), alone), std::ptrdiff_t(-1));
        }
    }

    void staticStates()
    {
        Case c = film("film_femto");
        c.run.threads = 1;
        const Bits alone = bitsOfState(c);
        for (const int threads : {2, 3, 7}) {
            c.run.threads = threads;
            QCOMPARE(firstDifference(bitsOfState(c), alone), std::ptrdiff_t(-1));
        }
    }

    void modesOfAFilm()
    {
        Case c = film("film_pico");
        c.run.threads = 1;
        const Bits alone = bitsOfModes(c);
        for (const int threads : {2, 3, 7}) {
            c.run.threads = threads;
            QCOMPARE(firstDifference(bitsOfModes(c), alone), std::ptrdiff_t(-1));
        }
    }

    /// Each item may use its part of the cores.
    void aStudy()
    {
        Case c = film("film_pico");
        c.film.nodes = {49, 97};
        c.run.threads = 1;
        const Bits alone = bitsOfStudy(c, 1);
        c.run.threads = 3;
        QVERIFY(bitsOfStudy(c, 1) == alone);
        QVERIFY(bitsOfStudy(c, 3) == alone);
    }

    /// By themselves, films take the cores that they are worth; where they are asked for more, the limit of the thread.
    void numberOfThreads()
    {
        Case c = film("film_pico");
        setThreadShare(6, 5);
        c.film.nodes = {65, 65};
        QCOMPARE(filmThreads(c), 1);
        c.film.nodes = {97, 97};
        QCOMPARE(filmThreads(c), 2);
        QCOMPARE(staticThreads(c), 1);
        c.film.nodes = {385, 385};
        QCOMPARE(filmThreads(c), 6);
        QCOMPARE(staticThreads(c), 2);
        c.run.threads = 4;
        QCOMPARE(filmThreads(c), 4);
        c.run.threads = 8;
        QCOMPARE(filmThreads(c), 5);
        c.run.threads = 0;
        setThreadShare(24);
        QCOMPARE(filmThreads(c), 8); // by themselves no more
        c.film.accuracy = 0.01;      // chooses the grid, up to a very fine one that hardly any film needs
        QCOMPARE(staticThreads(c), 1);
        c.film.accuracy = 0.0;
        setThreadShare(6, 5);
        c.film.nodes = {33, 33};
        c.run.threads = 2;
        QCOMPARE(filmThreads(c), 2);
    }
};

TOUCHDOWN_TEST(TestRunThreads)

} // namespace test_run_threads

#include "test_run_threads.moc"
