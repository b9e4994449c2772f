// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast the picture follows a slider of a demonstration: touchdown-live-bench [DEMONSTRATION] [SECONDS] [SLIDER], 6
// (Fig. 10), 10 and 1 if not given.
//
// The slider goes to and fro, one movement each 1/60 s. Prints the time from the movement whose value a run has to the
// first picture with that run, and the time between two such pictures: median, 95 % and largest.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <vector>

#include <QApplication>
#include <QSettings>
#include <QTimer>

#include "core/case/parameters.h"
#include "tests/bench/window/bench_window.h"
#include "ui/case/case_edits.h"
#include "ui/guides/guides.h"
#include "ui/guides/live_values.h"
#include "ui/guides/marked_slider.h"
#include "ui/plot/plot_canvas.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) // [ms]
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Calls back after each paint of a widget.
class Paints : public QObject {
public:
    Paints(QWidget& widget, std::function<void()> painted) : QObject(&widget), painted_(std::move(painted))
    {
        widget.installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Paint) painted_();
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> painted_;
};

void print(const char* what, std::vector<double> times)
{
    if (times.empty()) return;
    std::ranges::sort(times);
    const auto at = [&times](double share) {
        return times[std::min(times.size() - 1, static_cast<std::size_t>(share * static_cast<double>(times.size())))];
    };
    std::printf("%s: %zu, median %.1f ms, 95 %% %.1f ms, largest %.1f ms\n", what, times.size(), at(0.5), at(0.95),
                times.back());
}

} // namespace

int main(int argc, char** argv)
{
    const OwnData data;
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("live-bench"));
    const QStringList arguments = QApplication::arguments();
    const int step = arguments.value(1, QStringLiteral("6")).toInt() - 1;
    const double seconds = arguments.value(2, QStringLiteral("10")).toDouble();
    const int row = arguments.value(3, QStringLiteral("1")).toInt() - 1;
    applyTheme(Theme::Light);
    QSettings().setValue(QStringLiteral("demonstrations/step"), step);

    MainWindow window;
    window.resize(1600, 1000);
    window.show();
    window.beginSession(false);
    window.actions().demonstrations->trigger();
    waitFor(2000);
    LessonPane& pane = *window.guides().pane(LessonPane::Kind::Demonstrations);
    if (row < 0 || static_cast<std::size_t>(row) >= pane.shown().live.size()) {
        std::fprintf(stderr, "The demonstration has %zu sliders.\n", pane.shown().live.size());
        return 2;
    }
    auto& slider = *static_cast<MarkedSlider*>(pane.live().inputs().at(static_cast<std::size_t>(row)));
    const std::string key = pane.shown().live.at(static_cast<std::size_t>(row)).keys.front();
    const auto numberOfCase = [&key](const Case& c) { return numberOf(*findParameter(key), c); };

    std::map<double, Clock::time_point> moved; // by the value that was asked for
    std::vector<double> delays, gaps;
    double shown = std::nan("");
    Clock::time_point last = Clock::now();
    auto* canvas = window.runView().plots()->plot(QStringLiteral("spacing"))->findChild<PlotCanvas*>();
    const Paints paints(*canvas->viewport(), [&] {
        const RunRecord* newest = window.runs().newestShown();
        if (!newest || moved.empty()) return;
        const double value = numberOfCase(newest->value);
        if (value == shown || !moved.contains(value)) return;
        shown = value;
        delays.push_back(since(moved[value]));
        if (delays.size() > 1) gaps.push_back(since(last));
        last = Clock::now();
    });

    const Clock::time_point start = Clock::now();
    slider.setSliderDown(true);
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, [&] {
        // At a constant speed: a slider that stands still asks for no picture.
        const double there = 1.0 - std::abs(1.0 - std::fmod(since(start) / 2000.0, 2.0));
        const Clock::time_point now = Clock::now();
        slider.setSliderPosition(static_cast<int>(std::lround(50.0 + 900.0 * there)));
        moved[numberOfCase(window.edits().value())] = now;
    });
    timer.start(16);
    waitFor(static_cast<int>(1e3 * seconds));
    timer.stop();
    std::printf("%zu movements, %d runs in the list, newest %g\n", moved.size(), window.runs().count(),
                window.runs().newestShown() ? numberOfCase(window.runs().newestShown()->value) : -1.0);
    print("movement to picture", delays);
    print("between pictures", gaps);
    slider.setSliderDown(false);
    waitFor(1000);
}
