// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory and pictures of long lists and long runs: touchdown-memory-bench [BUDGET MB] [RUNS] [LONG RUNS] [SAMPLES]
// [SAMPLES OF THE LAST RUN], 300, 200, 10, 1e6 and 1e7 if not given.
//
// Runs fig10a as it is, then with a shorter sample interval. Prints the memory of the process, compares every number of
// every run with what the solver delivered, then moves and zooms the plots over the last run alone. A frame is the time
// that the thread of the window is occupied from a key to the picture of all plots: wall time, which includes waiting
// for the disk and for other programs, and processor time.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <thread>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QKeyEvent>

#include "core/case/parameters.h"
#include "tests/bench/window/bench_window.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/runs/runs_model.h"
#include "ui/sessions/session.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace {

/// A line of the status of the process [MB]: "VmRSS", "RssAnon", "VmHWM".
double status(const char* line)
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly)) return 0.0;
    for (const QByteArray& each : file.readAll().split('\n'))
        if (each.startsWith(line)) return each.simplified().split(' ').value(1).toDouble() / 1e3;
    return 0.0;
}

/// Of numbers bit for bit, in their order (Fowler, Noll and Vo 1991).
struct Digest {
    std::uint64_t value = 14695981039346656037ULL;
    void take(double number)
    {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        value = (value ^ bits) * 1099511628211ULL;
    }
};

class Bench {
public:
    Bench()
    {
        window_.resize(1600, 1000);
        window_.files().openNow(QStringLiteral("fig10a"));
        window_.show();
        window_.beginSession(false);
        QObject::connect(&window_.controller(), &RunController::delivered, [this](const RunDelivery& delivery) {
            if (delivery.samples.size() == 0) return;
            std::vector<Digest>& digests = delivered_[window_.runs().record(window_.runs().count() - 1).number];
            digests.resize(delivery.samples.columns.size() + 1);
            for (const double time : delivery.samples.time) digests[0].take(time);
            for (std::size_t i = 0; i + 1 < digests.size(); ++i)
                for (const double value : delivery.samples.columns[i]) digests[i + 1].take(value);
        });
        waitFor(500);
    }

    MainWindow& window() { return window_; }

    void run(double samples)
    {
        if (samples > 0.0) {
            const double interval = window_.edits().value().run.duration / samples;
            window_.edits().enter(*findParameter("run.sample_interval"), QString::number(interval * 1e6) + " us");
        }
        QElapsedTimer clock;
        clock.start();
        QEventLoop loop;
        QObject::connect(&window_, &MainWindow::calculationEnded, &loop, &QEventLoop::quit);
        window_.startRun();
        loop.exec();
        waitFor(50);
        const RunRecord& last = window_.runs().record(window_.runs().count() - 1);
        if (samples > 0.0) {
            std::printf("run of %zu samples: %.1f s\n", last.sampleCount(),
                        1e-3 * static_cast<double>(clock.elapsed()));
            print();
        }
    }

    void print()
    {
        RunMemory& memory = window_.runWindow().memory();
        std::printf("%d runs: %s, %.0f MB on the disk; resident %.0f MB, of it anonymous %.0f MB, at most %.0f MB\n",
                    window_.runs().count(), qPrintable(memory.text()), static_cast<double>(memory.onDisk()) / 1e6,
                    status("VmRSS"), status("RssAnon"), status("VmHWM"));
    }

    /// Runs whose numbers are not those that were delivered.
    int different()
    {
        int count = 0;
        for (int row = 0; row < window_.runs().count(); ++row) {
            const RunRecord& run = window_.runs().record(row);
            std::vector<Digest> digests(run.columns.size() + 1);
            for (std::size_t k = 0; k < run.sampleCount(); ++k) digests[0].take((*run.times)[k]);
            for (std::size_t i = 0; i < run.columns.size(); ++i)
                for (std::size_t k = 0; k < run.columns[i].size(); ++k) digests[i + 1].take(run.columns[i].value(k));
            if (!std::ranges::equal(digests, delivered_[run.number], {}, &Digest::value, &Digest::value)) ++count;
        }
        return count;
    }

    void frames(const char* name, int key, int count)
    {
        std::vector<double> costs, processor;
        std::vector<PlotWidget*> plots;
        for (PlotWidget* plot : window_.runView().plots()->group()->plots())
            if (plot->isVisible() && !plot->isPhasePortrait()) plots.push_back(plot);
        for (int frame = 0; frame < count; ++frame) {
            std::vector<long long> before;
            for (const PlotWidget* plot : plots) before.push_back(plot->refreshes());
            const auto waits = [&] {
                for (std::size_t i = 0; i < plots.size(); ++i)
                    if (plots[i]->refreshes() == before[i]) return true;
                return false;
            };
            const double processorBefore = processorTime();
            QElapsedTimer clock;
            clock.start();
            QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
            QApplication::sendEvent(plots.front(), &press);
            double cost = static_cast<double>(clock.nsecsElapsed());
            for (int rounds = 0; waits() && rounds < 1000; ++rounds) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                clock.start();
                QApplication::processEvents();
                cost += static_cast<double>(clock.nsecsElapsed());
            }
            clock.start();
            QApplication::processEvents(); // the picture
            costs.push_back(1e-6 * (cost + static_cast<double>(clock.nsecsElapsed())));
            processor.push_back(processorTime() - processorBefore);
        }
        std::ranges::sort(costs);
        std::ranges::sort(processor);
        std::printf(
            "%s, %zu plots, %d frames: median %.1f ms, worst %.1f ms; processor: median %.1f ms, worst %.1f ms\n", name,
            plots.size(), count, costs[costs.size() / 2], costs.back(), processor[processor.size() / 2],
            processor.back());
    }

private:
    MainWindow window_;
    std::map<int, std::vector<Digest>> delivered_;
};

} // namespace

int main(int argc, char** argv)
{
    const OwnData data(QStringLiteral("/var/tmp/touchdown-bench-XXXXXX")); // on a disk
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const auto argument = [&](int index, double otherwise) {
        return arguments.size() > index ? arguments[index].toDouble() : otherwise;
    };
    applyTheme(Theme::Light);
    Session::setBudget(qint64(50) << 30);

    Bench bench;
    RunMemory& memory = bench.window().runWindow().memory();
    memory.setBudget(static_cast<qint64>(argument(1, 300.0) * 1024.0 * 1024.0));
    bench.print();
    const int runs = static_cast<int>(argument(2, 200.0));
    for (int run = 0; run < runs; ++run) bench.run(0.0);
    waitFor(2000);
    bench.print();
    const int longRuns = static_cast<int>(argument(3, 10.0));
    for (int run = 0; run < longRuns; ++run) bench.run(argument(4, 1e6));
    if (argument(5, 1e7) > 0.0) bench.run(argument(5, 1e7));
    waitFor(5000);
    memory.settle();
    bench.print();

    RunsModel& list = bench.window().runs();
    for (int row = 0; row + 1 < list.count(); ++row) list.setData(list.index(row), Qt::Unchecked, Qt::CheckStateRole);
    waitFor(1000);
    bench.frames("zoom in", Qt::Key_Plus, 60);
    bench.frames("move", Qt::Key_Right, 60);
    bench.frames("zoom out", Qt::Key_Minus, 60);
    bench.frames("zoom in again", Qt::Key_Plus, 20);
    bench.frames("move back", Qt::Key_Left, 60);
    bench.print();
    waitFor(4000);
    bench.print();

    std::printf("runs with other numbers than delivered: %d of %d\n", bench.different(), list.count());
    bench.print();
    waitFor(4000);
    bench.print();
    return 0;
}
