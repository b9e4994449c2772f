// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long the window does not answer: touchdown-gap-bench [SAMPLES OF TWO RUNS] [SAMPLES OF A PORTRAIT], 2e6 and 1e7
// if not given.
//
// A timer fires each 5 ms. Prints the longest time between two of its calls, wall and processor time, until a task is
// done: a baseline is chosen, a spectrogram is shown, a phase portrait is moved and zoomed. The runs are oscillations
// whose amplitude decays.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QKeyEvent>
#include <QTimer>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/bench/window/bench_window.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrogram.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace {

const QString phase = QStringLiteral("phase");

void add(RunsModel& runs, std::size_t samples, bool all)
{
    const Case c = openCase("fig10a").value;
    std::vector<Quantity> quantities = recordedQuantities(c);
    if (!all)
        std::erase_if(quantities, [](const Quantity& each) {
            return each.name != "minimum_spacing" && each.name != "height" && each.name != "vertical_velocity";
        });
    const int number = runs.nextNumber();
    auto run = std::make_unique<RunRecord>(number, c, "", quantities);
    constexpr std::size_t part = 100'000;
    for (std::size_t first = 0; first < samples; first += part) {
        SampleBatch batch;
        batch.columns.resize(quantities.size());
        for (std::size_t k = first; k < std::min(samples, first + part); ++k) {
            const double time = c.run.duration * static_cast<double>(k) / static_cast<double>(samples);
            batch.time.push_back(time);
            const double fades = std::exp(-2.0 * time / c.run.duration);
            for (std::size_t i = 0; i < quantities.size(); ++i)
                batch.columns[i].push_back(1e-9 * fades * std::sin(6e5 * time + static_cast<double>(i) + 0.1 * number));
        }
        run->append(batch, {});
    }
    runs.add(std::move(run));
    runs.finish(number, Summary{});
}

/// Prints the longest gap of the event loop from `begin` until `done`, and how long that takes.
void measure(const char* name, const std::function<void()>& begin, const std::function<bool()>& done)
{
    QTimer timer;
    QElapsedTimer clock, since;
    qint64 longest = 0;
    double most = 0.0, before = processorTime();
    QEventLoop loop;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        longest = std::max(longest, since.nsecsElapsed());
        most = std::max(most, processorTime() - before);
        since.restart();
        before = processorTime();
        if (done()) loop.quit();
    });
    timer.setTimerType(Qt::PreciseTimer);
    timer.start(5);
    clock.start();
    since.start();
    begin();
    loop.exec();
    std::printf("%s: longest gap %.1f ms, of processor time %.1f ms; done after %.1f ms\n", name,
                1e-6 * static_cast<double>(longest), most, 1e-6 * static_cast<double>(clock.nsecsElapsed()));
}

} // namespace

int main(int argc, char** argv)
{
    const OwnData data;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const auto argument = [&](int index, double otherwise) {
        return static_cast<std::size_t>(arguments.size() > index ? arguments[index].toDouble() : otherwise);
    };
    applyTheme(Theme::Light);
    MainWindow window;
    window.resize(1600, 1000);
    window.show();
    LivePlots& plots = *window.runView().plots();
    RunsModel& runs = window.runs();
    add(runs, argument(1, 2e6), true);
    add(runs, argument(1, 2e6), true);
    waitFor(3000);

    PlotWidget& spacing = *plots.plot(QStringLiteral("spacing"));
    const auto isMade = [&] { return spacing.curves().size() == 1 && spacing.title().endsWith(QLatin1Char('1')); };
    for (int again = 0; again < 3; ++again) {
        measure(
            "baseline chosen", [&] { runs.setBaseline(1); }, isMade);
        waitFor(1000);
        measure(
            "baseline taken away", [&] { runs.setBaseline(-1); }, [&] { return spacing.curves().size() == 2; });
        waitFor(1000);
    }
    QAction* spectrogram = plots.entry(QStringLiteral("spectrogram")).wanted;
    measure(
        "spectrogram shown", [&] { spectrogram->trigger(); },
        [&] {
            return plots.spectrogram()->shown() != nullptr && plots.plot(QStringLiteral("spectrogram"))->backdrop();
        });
    waitFor(1000);
    spectrogram->trigger();

    while (runs.count() > 0) runs.remove(runs.count() - 1);
    add(runs, argument(2, 1e7), false);
    plots.entry(phase).wanted->trigger();
    waitFor(3000);
    PlotWidget& portrait = *plots.plot(phase);
    for (const int key : {Qt::Key_Plus, Qt::Key_Plus, Qt::Key_Right, Qt::Key_Up, Qt::Key_Left, Qt::Key_Minus}) {
        const long long before = portrait.refreshes();
        measure(
            "portrait moved or zoomed",
            [&] {
                QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
                QApplication::sendEvent(&portrait, &press);
            },
            [&] { return portrait.refreshes() > before && !portrait.phasePicture().busy(); });
    }
    return 0;
}
