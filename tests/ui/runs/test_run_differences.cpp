// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differences to a baseline: their numbers, for which plots they are made, and that nothing else is shown meanwhile.
#include "ui/runs/run_differences.h"

#include <cmath>
#include <memory>
#include <random>

#include <QTemporaryDir>
#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_memory.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

using namespace touchdown;

namespace test_run_differences {

constexpr std::size_t samples = 20'000;

/// All quantities of run `number` are `number` times the time.
void add(RunsModel& runs, int number)
{
    const Case c = openCase("fig10a").value;
    auto run = std::make_unique<RunRecord>(number, c, "", recordedQuantities(c));
    SampleBatch batch;
    for (std::size_t k = 0; k < samples; ++k) batch.time.push_back(1e-9 * static_cast<double>(k));
    for (std::size_t i = 0; i < run->quantities.size(); ++i) {
        std::vector<double>& values = batch.columns.emplace_back();
        for (const double time : batch.time) values.push_back(number * time);
    }
    run->append(batch, {});
    runs.add(std::move(run));
    runs.finish(number, Summary{});
}

class TestRunDifferences : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { memory_.reset(), plots_.reset(), runs_.reset(); }

    void isWhatTheSamplesSay();
    void stopsWhenItIsAsked();
    void isMadeForShownPlotsAlone();
    void saysThatItIsBeingMade();
    void saysThatARunThatGoesIsShownLater();
    void anotherBaselineMeanwhile();
    void aRunThatIsRemovedMeanwhile();
    void countsInTheMemoryOfTheRuns();

private:
    PlotWidget* plot(const char* name) const { return plots_->plot(QString::fromLatin1(name)); }
    const RunRecord& run(int number) const { return *runs_->find(number); }
    /// Whether the plot shows run 2 as its difference to a run, of half a microsecond and more.
    bool shows(const char* name, int baseline) const
    {
        for (const PlotCurve& curve : plot(name)->curves())
            if (curve.id.startsWith(QStringLiteral("run 2/")))
                return std::abs(curve.data->value(samples - 1) - (2 - baseline) * 1e-9 * (samples - 1)) < 1e-15;
        return false;
    }

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<LivePlots> plots_;
    std::unique_ptr<RunMemory> memory_;
};

void TestRunDifferences::init()
{
    QLocale::setDefault(QLocale::c());
    runs_ = std::make_unique<RunsModel>();
    plots_ = std::make_unique<LivePlots>(*runs_);
    memory_ = std::make_unique<RunMemory>(*runs_);
    plots_->setCase(openCase("fig10a").value);
    for (const int number : {1, 2, 3}) add(*runs_, number);
}

/// The value of the baseline between two of its samples is that of the straight line: runs and baselines with uneven
/// times that begin and end anywhere.
void TestRunDifferences::isWhatTheSamplesSay()
{
    std::mt19937 generator(11);
    const auto drawn = [&generator] {
        MinMaxPyramid data;
        std::uniform_real_distribution<double> step(0.0, 2.0), value(-1.0, 1.0);
        double time = std::uniform_real_distribution(0.0, 300.0)(generator);
        const int count = std::uniform_int_distribution(1, 1000)(generator);
        for (int k = 0; k < count; ++k, time += k % 7 == 0 ? 0.0 : step(generator))
            data.append(std::vector{time}, std::vector{value(generator)});
        return data;
    };
    int common = 0;
    for (int draw = 0; draw < 200; ++draw) {
        const MinMaxPyramid own = drawn(), other = drawn();
        const MinMaxPyramid made = difference(own, other);
        std::size_t next = 0;
        for (std::size_t k = 0; k < own.size(); ++k) {
            const std::optional<double> expected = other.valueAt(own.time(k));
            if (!expected) continue;
            QVERIFY(next < made.size());
            QCOMPARE(made.time(next), own.time(k));
            QCOMPARE(made.value(next), own.value(k) - *expected);
            ++next;
        }
        QCOMPARE(made.size(), next);
        common += next > 0 ? 1 : 0;
    }
    QVERIFY2(common > 100, qPrintable(QString::number(common)));
}

void TestRunDifferences::stopsWhenItIsAsked()
{
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(difference(run(2).columns[0], run(1).columns[0], stop.get_token()).empty());
}

void TestRunDifferences::isMadeForShownPlotsAlone()
{
    runs_->setBaseline(1);
    QTRY_VERIFY(shows("spacing", 1) && shows("pitch", 1) && shows("energy", 1));
    QVERIFY(!run(2).differences.contains("vertical_velocity") && run(2).differences.contains("pitch"));
    QVERIFY(run(1).differences.empty());
    // Quantities of a run share its times.
    QVERIFY(run(2).differences.at("pitch").times() == run(2).times);
    plots_->entry(QStringLiteral("velocity")).wanted->trigger();
    QVERIFY(plot("velocity")->curves().empty());
    QTRY_VERIFY(shows("velocity", 1));
    plots_->entry(QStringLiteral("velocity")).wanted->trigger();
    QVERIFY(!run(2).differences.contains("vertical_velocity") && plot("velocity")->curves().empty());
    runs_->setData(runs_->index(1), Qt::Unchecked, Qt::CheckStateRole);
    QVERIFY(run(2).differences.empty() && !run(3).differences.empty());
    runs_->setBaseline(-1);
    QVERIFY(run(3).differences.empty());
    QVERIFY(plot("pitch")->curves()[0].data == run(1).pyramid("pitch"));
}

void TestRunDifferences::saysThatItIsBeingMade()
{
    QVERIFY(shows("pitch", 0));
    runs_->setBaseline(1);
    QCOMPARE(plot("pitch")->title(), QStringLiteral("Pitch minus run 1: being computed"));
    QVERIFY(plot("pitch")->curves().empty());
    QTRY_COMPARE(plot("pitch")->title(), QStringLiteral("Pitch minus run 1"));
    QCOMPARE(plot("pitch")->curves().size(), std::size_t(2));
    runs_->setBaseline(-1);
    QCOMPARE(plot("pitch")->title(), QStringLiteral("Pitch"));
}

void TestRunDifferences::saysThatARunThatGoesIsShownLater()
{
    runs_->setBaseline(1);
    const Case c = openCase("fig10a").value;
    runs_->add(std::make_unique<RunRecord>(4, c, "", recordedQuantities(c)));
    QTRY_COMPARE(plot("pitch")->title(), QStringLiteral("Pitch minus run 1: run 4 is shown when it ends"));
    runs_->setBaseline(4);
    QCOMPARE(plot("pitch")->title(), QStringLiteral("Pitch minus run 4: shown when run 4 ends"));
    runs_->setBaseline(1);
    runs_->finish(4, Summary{});
    plots_->runFinished(4);
    QTRY_COMPARE(plot("pitch")->title(), QStringLiteral("Pitch minus run 1"));
}

void TestRunDifferences::anotherBaselineMeanwhile()
{
    runs_->setBaseline(1);
    runs_->setBaseline(3);
    QVERIFY(plot("pitch")->curves().empty());
    QTRY_VERIFY(shows("pitch", 3));
    QTRY_COMPARE(plot("energy")->title(), QStringLiteral("Energy minus run 3"));
    for (const char* name : {"spacing", "pitch", "energy"}) QVERIFY(shows(name, 3));
    runs_->setBaseline(1);
    runs_->setBaseline(-1);
    QVERIFY(run(2).differences.empty() && shows("pitch", 0));
    runs_->setBaseline(3); // what was made for run 1 has come by the time that this is there
    QTRY_VERIFY(shows("pitch", 3));
}

void TestRunDifferences::aRunThatIsRemovedMeanwhile()
{
    runs_->setBaseline(1);
    runs_->remove(1);
    QTRY_COMPARE(plot("pitch")->title(), QStringLiteral("Pitch minus run 1"));
    QCOMPARE(plot("pitch")->curves().size(), std::size_t(1));
    runs_->remove(0); // the baseline
    QCOMPARE(plot("pitch")->curves()[0].data, run(3).pyramid("pitch"));
    QVERIFY(run(3).differences.empty());
}

/// 8.5 bytes a sample more for each difference, which move to the disk with the run.
void TestRunDifferences::countsInTheMemoryOfTheRuns()
{
    const QTemporaryDir folder;
    memory_->setFolder(folder.path());
    memory_->settle();
    const qint64 before = memory_->inMemory();
    const std::size_t own = run(2).bytesInMemory();
    runs_->setBaseline(1);
    QTRY_COMPARE(plot("energy")->title(), QStringLiteral("Energy minus run 1"));
    const std::size_t made = run(2).differences.size();
    QVERIFY(made > 5);
    const double bytes = static_cast<double>(run(2).bytesInMemory() - own);
    QVERIFY2(std::abs(bytes / (8.5 * samples * static_cast<double>(made)) - 1.0) < 0.01,
             qPrintable(QString::number(bytes)));
    memory_->settle();
    QCOMPARE(memory_->inMemory() - before, 2 * static_cast<qint64>(bytes));
    memory_->setBudget(1);
    memory_->settle();
    QCOMPARE(run(2).bytesOnDisk(), (run(2).columns.size() + 1 + made) * samples * sizeof(double));
    for (const auto& [quantity, difference] : run(2).differences) QCOMPARE(difference.value(1000), 1e-9 * 1000);
    memory_->setBudget(0);
}

TOUCHDOWN_TEST(TestRunDifferences)

} // namespace test_run_differences

#include "test_run_differences.moc"
