// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the window costs the solver: touchdown-film-window-bench PAIRS CASE DURATION [CASE DURATION ...], durations in
// us.
//
// Each pair runs the case once in the window, with its plots, and once beside it while the window has nothing to do;
// every second pair in the other order. Prints for each case the ratio of the solver's time and of the wall time,
// window to alone: median, least and largest of the pairs, and how far two runs alone differ.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include <QApplication>
#include <QEventLoop>

#include "core/simulation/run.h"
#include "tests/bench/window/bench_window.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace {

using Clock = std::chrono::steady_clock;

struct Times {
    double solver = 0.0; // [s]
    double wall = 0.0;   // from the start until the end is known [s]
};

Times inWindow(MainWindow& window)
{
    QEventLoop loop;
    QObject::connect(&window, &MainWindow::calculationEnded, &loop, &QEventLoop::quit);
    const Clock::time_point start = Clock::now();
    window.startRun();
    loop.exec();
    const double wall = std::chrono::duration<double>(Clock::now() - start).count();
    const RunRecord* run = window.runs().newestShown();
    return run && run->summary ? Times{run->summary->solverSeconds, wall} : Times{};
}

Times alone(const Case& c)
{
    Times times;
    const Clock::time_point start = Clock::now();
    std::thread worker([&] { times.solver = run(c).solverSeconds; });
    worker.join();
    times.wall = std::chrono::duration<double>(Clock::now() - start).count();
    return times;
}

void print(const char* what, std::vector<double> ratios)
{
    std::ranges::sort(ratios);
    std::printf("  %s: median %.3f, %.3f to %.3f\n", what, ratios[ratios.size() / 2], ratios.front(), ratios.back());
}

} // namespace

int main(int argc, char** argv)
{
    const OwnData data;
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const int pairs = arguments.value(1).toInt();
    if (pairs < 1 || arguments.size() < 4) {
        std::printf("touchdown-film-window-bench PAIRS CASE DURATION [CASE DURATION ...], durations in us\n");
        return 2;
    }
    applyTheme(Theme::Light);
    MainWindow window;
    window.resize(1600, 1000);
    window.show();
    window.beginSession(false);
    for (qsizetype i = 2; i + 1 < arguments.size(); i += 2) {
        window.files().leaveUnsaved();
        window.files().openNow(arguments[i]);
        Case c = window.edits().value();
        c.run.duration = 1e-6 * arguments[i + 1].toDouble();
        window.edits().setAll(c, QStringLiteral("duration"));
        waitFor(1000);
        alone(c); // pages of memory and files are there
        std::vector<double> solver, wall, spread;
        double last = 0.0;
        for (int pair = 0; pair < pairs; ++pair) {
            Times shown, bare;
            for (const bool first : {true, false}) {
                if (first == (pair % 2 == 0))
                    shown = inWindow(window);
                else
                    bare = alone(c);
                waitFor(500);
            }
            solver.push_back(shown.solver / bare.solver);
            wall.push_back(shown.wall / bare.wall);
            if (last > 0.0) spread.push_back(bare.solver / last);
            last = bare.solver;
        }
        std::printf("%s, %s us: %.2f s alone\n", qPrintable(arguments[i]), qPrintable(arguments[i + 1]), last);
        print("solver, window to alone", solver);
        print("wall, window to alone", wall);
        if (!spread.empty()) print("solver, alone to the run alone before", spread);
        std::fflush(stdout);
    }
}
