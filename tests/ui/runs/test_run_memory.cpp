// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs above the budget are on the disk, and nobody notices.
#include "ui/runs/run_memory.h"

#include <cmath>
#include <memory>

#include <malloc.h>

#include <QDir>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/results/results_reader.h"
#include "core/simulation/recording/run_statistics.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_contact.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

using namespace touchdown;

namespace test_run_memory {

constexpr std::size_t longRun = 2 * SampleColumn::pieceSize + 1000;

/// Sample `k` of quantity `column` of run `number`.
double sample(int number, std::size_t column, std::size_t k)
{
    return std::sin(static_cast<double>(k * (column + 1)) + static_cast<double>(number));
}

class TestRunMemory : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCoreApplication::setApplicationName(QStringLiteral("test_run_memory")); }
    void init()
    {
        QSettings().clear();
        folder_ = std::make_unique<QTemporaryDir>();
        runs_ = std::make_unique<RunsModel>();
        memory_ = std::make_unique<RunMemory>(*runs_);
        memory_->setFolder(folder_->path());
    }
    void cleanup() { memory_.reset(), runs_.reset(), QSettings().clear(); }

    void countsWhatRunsTake();
    void countsWhatTheProcessTakes();
    void movesTheOldestHiddenRunsFirst();
    void samplesStayAsTheyWere();
    void aRunUnderWayMovesWhatIsFull();
    void snapshotsOfFieldsMove();
    void aRunThatIsRemovedMeanwhile();
    void aFullDiskIsSaidOnce();
    void keepsTheBudget();

private:
    RunRecord& add(std::size_t samples, bool finished = true);
    bool unchanged(const RunRecord& run) const;
    bool moved(int number) const { return runs_->find(number)->bytesOnDisk() > 0; }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<RunMemory> memory_;
};

RunRecord& TestRunMemory::add(std::size_t samples, bool finished)
{
    Case c;
    c.run.sampleInterval = 1e-9;
    const int number = runs_->nextNumber();
    auto run = std::make_unique<RunRecord>(
        number, c, "",
        std::vector<Quantity>{{"minimum_spacing", "m", "nm", "Minimum spacing"}, {"pitch", "rad", "urad", "Pitch"}});
    SampleBatch batch;
    batch.columns.resize(2);
    for (std::size_t k = 0; k < samples; ++k) {
        batch.time.push_back(1e-9 * static_cast<double>(k));
        for (std::size_t column = 0; column < 2; ++column) batch.columns[column].push_back(sample(number, column, k));
    }
    run->append(batch, {});
    RunRecord& added = runs_->add(std::move(run));
    if (finished) runs_->finish(number, Summary{});
    return added;
}

bool TestRunMemory::unchanged(const RunRecord& run) const
{
    for (std::size_t k = 0; k < run.sampleCount(); ++k) {
        if ((*run.times)[k] != 1e-9 * static_cast<double>(k)) return false;
        for (std::size_t column = 0; column < 2; ++column)
            if (run.columns[column].value(k) != sample(run.number, column, k)) return false;
    }
    return true;
}

void TestRunMemory::countsWhatRunsTake()
{
    QVERIFY(memory_->budget() == RunMemory::quarterOfMachine());
    QVERIFY(memory_->budget() > 0);
    const RunRecord& run = add(longRun);
    memory_->settle();
    // Times and two quantities of 8 bytes each; of the levels 32 bytes for 64 samples of each of the two, and so on; a
    // time of each block.
    const double perSample = 3 * 8 + 2 * 0.5 * (64.0 / 63.0) + 8.0 / 64.0;
    QVERIFY(std::abs(static_cast<double>(memory_->inMemory()) - perSample * longRun) < 2000.0);
    QCOMPARE(memory_->inMemory(), static_cast<qint64>(run.bytesInMemory()));
    QCOMPARE(memory_->onDisk(), qint64(0));
}

/// What the allocator has given out for runs, with all that stands above their samples, before and after the samples
/// moved to the disk.
void TestRunMemory::countsWhatTheProcessTakes()
{
    const auto allocated = [] {
        const struct mallinfo2 now = ::mallinfo2();
        return static_cast<double>(now.uordblks + now.hblkhd);
    };
    const double before = allocated();
    if (before == 0.0) QSKIP("The sanitizers have an allocator of their own");
    add(10 * longRun);
    memory_->settle();
    QVERIFY2(std::abs((allocated() - before) / static_cast<double>(memory_->inMemory()) - 1.0) < 0.005,
             qPrintable(QStringLiteral("%1 %2").arg(allocated() - before).arg(memory_->inMemory())));
    memory_->setBudget(1);
    memory_->settle();
    // Levels, 0.5 bytes for a sample of each quantity, and a time for each block.
    QVERIFY(std::abs(static_cast<double>(memory_->inMemory()) / (1.14 * 10 * longRun) - 1.0) < 0.01);
    QVERIFY2(std::abs((allocated() - before) / static_cast<double>(memory_->inMemory()) - 1.0) < 0.1,
             qPrintable(QStringLiteral("%1 %2").arg(allocated() - before).arg(memory_->inMemory())));
}

void TestRunMemory::movesTheOldestHiddenRunsFirst()
{
    for (int i = 0; i < 4; ++i) add(10'000);
    runs_->setData(runs_->index(1), Qt::Unchecked, Qt::CheckStateRole);
    runs_->setData(runs_->index(2), Qt::Unchecked, Qt::CheckStateRole);
    memory_->settle();
    const qint64 one = memory_->inMemory() / 4;
    const std::vector<std::vector<int>> order{{2}, {2, 3}, {1, 2, 3}, {1, 2, 3, 4}};
    for (std::size_t i = 0; i < order.size(); ++i) {
        memory_->setBudget((4 - static_cast<qint64>(i)) * one - 1);
        memory_->settle();
        for (int number = 1; number <= 4; ++number)
            QCOMPARE(moved(number), std::ranges::find(order[i], number) != order[i].end());
    }
    QVERIFY(memory_->inMemory() < one / 4); // levels
    QVERIFY(QDir(folder_->path()).isEmpty(QDir::Files | QDir::Hidden));
}

void TestRunMemory::samplesStayAsTheyWere()
{
    const RunRecord& run = add(longRun);
    const auto spectrum = [&run] { return spectrumOf(run, "pitch", WelchOptions{}, 0.0); };
    const Spectrum before = spectrum();
    const auto view = run.columns[0].thinned(1e-5, 2e-5, 800);
    QVERIFY(run.bytesOnDisk() == 0);
    memory_->setBudget(1);
    memory_->settle();
    QVERIFY(run.bytesOnDisk() == longRun * 3 * sizeof(double));
    QVERIFY(unchanged(run));
    QCOMPARE(spectrum().power, before.power);
    QCOMPARE(run.columns[0].thinned(1e-5, 2e-5, 800), view);
    run.letGo();
    const QString file = folder_->filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(run, file), QString());
    const StoredRun stored = readResults(file.toStdString());
    QCOMPARE(stored.samples.size(), longRun);
    for (std::size_t k = 0; k < longRun; k += 101) QCOMPARE(stored.samples.columns[1][k], sample(run.number, 1, k));
}

void TestRunMemory::aRunUnderWayMovesWhatIsFull()
{
    RunRecord& run = add(longRun, false);
    memory_->setBudget(1);
    memory_->settle();
    QCOMPARE(run.bytesOnDisk(), 2 * 3 * SampleColumn::pieceSize * sizeof(double));
    QVERIFY(unchanged(run));
    SampleBatch more;
    more.columns.resize(2);
    for (std::size_t k = longRun; k < longRun + 100; ++k) {
        more.time.push_back(1e-9 * static_cast<double>(k));
        for (std::size_t column = 0; column < 2; ++column)
            more.columns[column].push_back(sample(run.number, column, k));
    }
    run.append(more, {});
    QVERIFY(unchanged(run));
    runs_->finish(run.number, Summary{});
    memory_->settle();
    QCOMPARE(run.bytesOnDisk(), 3 * (longRun + 100) * sizeof(double));
    QVERIFY(unchanged(run));
}

void TestRunMemory::snapshotsOfFieldsMove()
{
    RunRecord& run = runs_->add(sampleContactRun(1));
    const FieldHistory& history = run.fields.front();
    std::vector<FieldSnapshot> before;
    for (std::size_t i = 0; i < history.snapshots.size(); ++i) before.push_back(history.snapshot(i));
    QVERIFY(before.size() > 2);
    memory_->setBudget(1);
    memory_->settle();
    QVERIFY(history.bytesOnDisk() > 0);
    QCOMPARE(history.bytesInMemory(), std::size_t(0));
    for (std::size_t i = 0; i < before.size(); ++i) {
        QCOMPARE(history.snapshot(i).time, before[i].time);
        QCOMPARE(history.snapshot(i).values, before[i].values);
    }
    run.letGo();
    const QString file = folder_->filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(run, file), QString());
    const StoredRun stored = readResults(file.toStdString());
    QCOMPARE(stored.fields.size(), before.size());
    QCOMPARE(stored.fields.back().values, before.back().values);
}

void TestRunMemory::aRunThatIsRemovedMeanwhile()
{
    add(longRun);
    add(1000);
    memory_->setBudget(1); // begins with the first
    runs_->remove(0);
    memory_->settle();
    QCOMPARE(memory_->onDisk(), static_cast<qint64>(runs_->record(0).bytesOnDisk()));
    QVERIFY(unchanged(runs_->record(0)));
}

void TestRunMemory::aFullDiskIsSaidOnce()
{
    const QSignalSpy failed(memory_.get(), &RunMemory::failed);
    memory_->setFolder(QStringLiteral("/dev/null/full"));
    const RunRecord& first = add(longRun);
    memory_->setBudget(1);
    memory_->settle();
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed[0][0].toString().contains(QStringLiteral("/dev/null/full")));
    QCOMPARE(memory_->onDisk(), qint64(0));
    QVERIFY(unchanged(first));
    add(longRun); // tries again, and says nothing
    memory_->settle();
    QCOMPARE(failed.count(), 1);
    memory_->setFolder(folder_->path()); // there is room again
    add(1000);
    memory_->settle();
    QVERIFY(first.bytesOnDisk() > 0);
    QVERIFY(unchanged(first));
}

void TestRunMemory::keepsTheBudget()
{
    memory_->setBudget(qint64(123) << 20);
    QCOMPARE(RunMemory::setting(), qint64(123) << 20);
    RunMemory next(*runs_);
    QCOMPARE(next.budget(), qint64(123) << 20);
    add(longRun);
    const QSignalSpy changed(&next, &RunMemory::changed);
    QTRY_VERIFY(changed.count() > 0);
    QCOMPARE(next.text(), QStringLiteral("Runs: 3 MB of 123 MB"));
    QVERIFY(!next.explanation().contains(QStringLiteral("on the disk now")));
    next.setFolder(folder_->path());
    next.setBudget(1);
    next.settle();
    QVERIFY(next.explanation().contains(QStringLiteral("3 MB are on the disk now")));
    next.setBudget(0);
    QCOMPARE(next.budget(), RunMemory::quarterOfMachine());
}

TOUCHDOWN_TEST(TestRunMemory)

} // namespace test_run_memory

#include "test_run_memory.moc"
