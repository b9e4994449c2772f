// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the benchmarks of the window share: settings and session of their own, waiting, processor time.
#pragma once

#include <time.h>

#include <QEventLoop>
#include <QString>
#include <QTemporaryDir>
#include <QTimer>

namespace touchdown {

/// Settings and session of the benchmark alone, while this lives; to be made before the application.
class OwnData {
public:
    /// `folder`: a pattern of QTemporaryDir; empty: where the system keeps temporary files.
    explicit OwnData(const QString& folder = {}) : data_(folder.isEmpty() ? QTemporaryDir() : QTemporaryDir(folder))
    {
        qputenv("XDG_DATA_HOME", data_.path().toLocal8Bit());
        qputenv("XDG_CONFIG_HOME", data_.path().toLocal8Bit());
    }

private:
    QTemporaryDir data_;
};

inline void waitFor(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Of the calling thread [ms].
inline double processorTime()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

} // namespace touchdown
