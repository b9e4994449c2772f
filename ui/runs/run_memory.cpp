// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_memory.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <malloc.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/unnamed_file.h"

namespace touchdown {

namespace {

constexpr int restBeforeCheck = 100;    // [ms]
constexpr int restBeforeRelease = 3000; // pages that a plot reads again and again stay for a while [ms]
constexpr std::size_t mostFields = std::size_t(1) << 21; // numbers that move at a time: 16 MB
constexpr qint64 fewPages = 1024;                        // 4 MB
constexpr auto settingKey = "runs/memory";

QString bytesText(qint64 bytes)
{
    return QLocale().formattedDataSize(bytes, bytes < (qint64(1) << 30) ? 0 : 1, QLocale::DataSizeTraditionalFormat);
}

/// Of all files that are mapped, the program's own among them.
qint64 mappedPages()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(2).toLongLong() : 0;
}

} // namespace

/// What is written to one file: a piece of all columns of a run, or some of its snapshots.
struct RunMemory::Moved {
    int run = 0;
    std::size_t piece = 0;
    std::vector<std::shared_ptr<const double[]>> owners; // of the numbers; they tell the columns
    std::vector<FieldSnapshot> snapshots;
    std::vector<std::span<const double>> parts;
    std::shared_ptr<const double[]> onDisk;
};

qint64 RunMemory::setting() { return QSettings().value(settingKey, 0).toLongLong(); }

qint64 RunMemory::quarterOfMachine()
{
    return std::max<qint64>(::sysconf(_SC_PHYS_PAGES), 0) * ::sysconf(_SC_PAGESIZE) / 4;
}

RunMemory::RunMemory(RunsModel& runs, QObject* parent)
    : QObject(parent),
      runs_(runs),
      folder_(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)),
      budget_(setting() > 0 ? setting() : quarterOfMachine())
{
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &RunMemory::check);
    connect(&release_, &QTimer::timeout, this, &RunMemory::letGo);
    connect(&runs_, &RunsModel::added, this, [this](int number) {
        blocked_ = false; // there may be room on the disk by now
        // More runs may be read from files before the window is free again.
        if (runs_.find(number)->finished()) settle();
        schedule();
    });
    connect(&runs_, &RunsModel::rowsRemoved, this, &RunMemory::schedule);
    connect(&runs_, &RunsModel::shownChanged, this, &RunMemory::schedule);
}

void RunMemory::setBudget(qint64 bytes)
{
    QSettings().setValue(settingKey, bytes);
    budget_ = bytes > 0 ? bytes : quarterOfMachine();
    blocked_ = false;
    check();
}

QString RunMemory::text() const { return tr("Runs: %1 of %2").arg(bytesText(inMemory_), bytesText(budget_)); }

QString RunMemory::explanation() const
{
    QString text = tr(
        "Memory that the runs of the list take. Above the limit (Run, Memory for runs), samples move to the "
        "disk, those of hidden runs first, then of the oldest. The extremes from which whole runs are drawn stay: half "
        "a byte for each sample of a quantity.");
    if (onDisk_ > 0) text += QLatin1Char(' ') + tr("%1 are on the disk now.").arg(bytesText(onDisk_));
    return text;
}

void RunMemory::schedule()
{
    freed_ = true; // by what brought the samples, and by what is written
    if (!soon_.isActive()) soon_.start(restBeforeCheck);
}

void RunMemory::measure()
{
    const qint64 memoryBefore = inMemory_, diskBefore = onDisk_;
    inMemory_ = onDisk_ = 0;
    for (int row = 0; row < runs_.count(); ++row) {
        inMemory_ += static_cast<qint64>(runs_.record(row).bytesInMemory());
        onDisk_ += static_cast<qint64>(runs_.record(row).bytesOnDisk());
    }
    if (onDisk_ > 0 && !release_.isActive()) release_.start(restBeforeRelease);
    if (onDisk_ == 0) release_.stop();
    if (inMemory_ != memoryBefore || onDisk_ != diskBefore) emit changed();
}

void RunMemory::check()
{
    measure();
    if (moving_ || blocked_ || inMemory_ <= budget_) return;
    std::vector<RunRecord*> order;
    for (int row = 0; row < runs_.count(); ++row) order.push_back(runs_.find(runs_.record(row).number));
    // The newest run is last in the list and stays last.
    if (!order.empty())
        std::stable_partition(order.begin(), order.end() - 1, [](const RunRecord* run) { return !run->shown; });
    for (RunRecord* run : order)
        if (moveSamples(*run) || moveFields(*run)) return;
}

bool RunMemory::moveSamples(RunRecord& run)
{
    const std::vector<SampleColumn*> columns = run.numbers();
    for (std::size_t piece = 0; piece < run.parts(); ++piece) {
        auto moved = std::make_shared<Moved>();
        for (const SampleColumn* column : columns) {
            if (piece >= column->pieces() || column->onDisk(piece)) continue;
            // More numbers arrive in the last piece while the run goes.
            if (!run.finished() && column->piece(piece).size() < SampleColumn::pieceSize) continue;
            moved->owners.push_back(column->owner(piece));
            moved->parts.push_back(column->piece(piece));
        }
        if (moved->parts.empty()) continue;
        moved->run = run.number;
        moved->piece = piece;
        move(std::move(moved));
        return true;
    }
    return false;
}

bool RunMemory::moveFields(RunRecord& run)
{
    auto moved = std::make_shared<Moved>();
    moved->run = run.number;
    std::size_t numbers = 0;
    for (const FieldHistory& history : run.fields)
        for (std::size_t i = 0; i < history.snapshots.size() && numbers < mostFields; ++i) {
            if (history.onDisk[i]) continue;
            moved->snapshots.push_back(history.snapshots[i]);
            for (const std::vector<double>& field : history.snapshots[i].values) numbers += field.size();
        }
    if (numbers == 0) return false;
    for (const FieldSnapshot& snapshot : moved->snapshots)
        for (const std::vector<double>& field : snapshot.values) moved->parts.emplace_back(field);
    move(std::move(moved));
    return true;
}

void RunMemory::move(std::shared_ptr<Moved> piece)
{
    moving_ = true;
    writer_.post(
        [piece, folder = folder_] {
            QString problem;
            piece->onDisk = toUnnamedFile(folder, piece->parts, problem);
            return problem;
        },
        [this, piece](const QString& problem) { onMoved(*piece, problem); });
}

void RunMemory::onMoved(const Moved& piece, const QString& problem)
{
    moving_ = false;
    if (!piece.onDisk) {
        blocked_ = true;
        if (!std::exchange(reported_, true))
            emit failed(tr("The runs take more memory than the %1 of Run, Memory for runs, and stay in memory: %2")
                            .arg(bytesText(budget_), problem));
        return;
    }
    freed_ = true;
    RunRecord* run = runs_.find(piece.run);
    std::size_t at = 0;
    const auto next = [&](std::size_t numbers) { // what was written next, sharing the file
        return std::shared_ptr<const double[]>(piece.onDisk, piece.onDisk.get() + std::exchange(at, at + numbers));
    };
    for (std::size_t i = 0; run && i < piece.owners.size(); ++i) {
        const std::shared_ptr<const double[]> same = next(piece.parts[i].size());
        for (SampleColumn* column : run->numbers())
            if (piece.piece < column->pieces() && column->owner(piece.piece) == piece.owners[i])
                column->replace(piece.piece, same);
    }
    for (const FieldSnapshot& snapshot : piece.snapshots) {
        std::size_t numbers = 0;
        for (const std::vector<double>& field : snapshot.values) numbers += field.size();
        const std::shared_ptr<const double[]> same = next(numbers);
        if (run) run->fields[snapshot.set].moveToDisk(snapshot.time, same);
    }
    check();
}

void RunMemory::letGo()
{
    if (mappedPages() > mappedBefore_ + fewPages) {
        for (int row = 0; row < runs_.count(); ++row) runs_.record(row).letGo();
        mappedBefore_ = mappedPages();
    }
    if (std::exchange(freed_, false)) ::malloc_trim(0);
}

void RunMemory::settle()
{
    check();
    while (moving_) {
        writer_.wait();
        QCoreApplication::sendPostedEvents(&writer_, QEvent::MetaCall);
    }
}

} // namespace touchdown
