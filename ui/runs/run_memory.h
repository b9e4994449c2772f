// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the runs of the window within a budget of memory. Above it, samples and snapshots of fields move to the disk,
// piece by piece on another thread: first those of runs that are not shown, then those of shown runs, the oldest first,
// and those of the newest run last. The pyramids above the samples stay in memory: 0.5 bytes for each sample of a
// quantity, which count. So do the differences of runs from the baseline.
//
// A file that cannot be written is reported once; then the runs stay in memory.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "ui/calculation/task_queue.h"

namespace touchdown {

class RunsModel;
struct RunRecord;

class RunMemory : public QObject {
    Q_OBJECT

public:
    /// Bytes that the runs may take; a setting. A quarter of the machine's memory if it is 0.
    static qint64 setting();
    static qint64 quarterOfMachine();

    /// `runs` must outlive this.
    explicit RunMemory(RunsModel& runs, QObject* parent = nullptr);

    qint64 budget() const { return budget_; }
    void setBudget(qint64 bytes);
    /// Where the files are; at first the folder of the program's data.
    void setFolder(const QString& folder) { folder_ = folder; }
    qint64 inMemory() const { return inMemory_; }
    qint64 onDisk() const { return onDisk_; }
    /// "Runs: 212 MB of 3.9 GB", and what it means.
    QString text() const;
    QString explanation() const;

    /// Samples have arrived, or a run has ended.
    void schedule();
    /// Waits until nothing more can move.
    void settle();

signals:
    void changed();
    /// Once: what does not fit stays in memory.
    void failed(const QString& sentence);

private:
    struct Moved;

    void measure();
    void check();
    bool moveSamples(RunRecord& run);
    bool moveFields(RunRecord& run);
    void move(std::shared_ptr<Moved> piece);
    void onMoved(const Moved& piece, const QString& problem);
    void letGo();

    RunsModel& runs_;
    QString folder_;
    qint64 budget_;
    qint64 inMemory_ = 0;
    qint64 onDisk_ = 0;
    bool moving_ = false;
    bool blocked_ = false; // the disk has failed
    bool reported_ = false;
    bool freed_ = false;      // memory that the system does not know of yet
    qint64 mappedBefore_ = 0; // pages that the process held after the last release
    QTimer soon_;
    QTimer release_;
    TaskQueue writer_{this};
};

} // namespace touchdown
