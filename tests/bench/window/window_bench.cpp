// SPDX-License-Identifier: GPL-3.0-or-later
//
// What runs cost the window: touchdown-window-bench [OVERLAID] [RERUNS] [SAMPLE CASE], 20, 10 and fig10a if not given.
//
// Some runs are overlaid; then the case runs again and again. Prints the processor time of the window's thread for
// each rerun, from the start until the window has nothing left to do, and the memory of the process.
#include <algorithm>
#include <cstdio>
#include <vector>

#include <QApplication>
#include <QEventLoop>
#include <QFile>
#include <QSettings>

#include "tests/bench/window/bench_window.h"
#include "ui/case/case_files.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace {

/// Resident [MB].
double memory()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) return 0.0;
    return file.readAll().split(' ').value(1).toDouble() * 4096.0 / 1e6;
}

void runOnce(MainWindow& window)
{
    QEventLoop loop;
    QObject::connect(&window, &MainWindow::calculationEnded, &loop, &QEventLoop::quit);
    window.startRun();
    loop.exec();
}

} // namespace

int main(int argc, char** argv)
{
    const OwnData data;
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const int overlaid = arguments.value(1, QStringLiteral("20")).toInt();
    const int reruns = arguments.value(2, QStringLiteral("10")).toInt();
    applyTheme(Theme::Light);

    MainWindow window;
    window.resize(1600, 1000);
    window.files().openNow(arguments.value(3, QStringLiteral("fig10a")));
    window.show();
    window.beginSession(false);
    waitFor(500);
    for (int run = 0; run < overlaid; ++run) {
        const double before = processorTime();
        runOnce(window);
        waitFor(300);
        std::printf("run %d: %.1f ms\n", run + 1, processorTime() - before);
    }
    waitFor(1000);
    std::vector<double> costs;
    for (int rerun = 0; rerun < reruns; ++rerun) {
        const double before = processorTime();
        runOnce(window);
        waitFor(700);
        costs.push_back(processorTime() - before);
        std::printf("rerun over %d: %.1f ms\n", overlaid + rerun, costs.back());
    }
    if (costs.empty()) return 0;
    std::sort(costs.begin(), costs.end());
    std::printf("median %.1f ms, largest %.1f ms, memory %.0f MB\n", costs[costs.size() / 2], costs.back(), memory());
}
