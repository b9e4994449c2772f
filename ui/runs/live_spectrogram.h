// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spectrogram of a quantity of the newest run, in a plot over time: power spectral density in dB
// (core/numerics/spectrogram.h), bright where it is high. The range of colours ends at the largest density and begins
// 80 dB below it. The tool tip states the resolution in time and in frequency. The automatic range of frequencies ends
// where no density comes within 60 dB of the largest.
//
// It is computed on another thread, and shown when it is there: at most four times a second while a run goes, and for
// at most a fifth of the time. A hidden plot has none. All samples count, of a run of any length: windows are averaged
// into at most `mostColumns` columns, and at each scale the columns and the frequencies within a pixel.
#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include <QObject>
#include <QTimer>

#include "core/numerics/spectrogram.h"
#include "core/simulation/recording/quantity.h"
#include "ui/calculation/task_queue.h"

namespace touchdown {

class MinMaxPyramid;
class PlotWidget;
class RunsModel;

class LiveSpectrogram : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t mostColumns = 2048;
    static constexpr double shownDecibels = 80.0;

    /// Both must outlive it.
    LiveSpectrogram(RunsModel& runs, PlotWidget& plot, QObject* parent);
    ~LiveSpectrogram() override;

    void setQuantity(const std::string& name);
    /// Of the window, in samples; 0: a thirty-second of the run, a power of two from 64 to 4096.
    void setWindow(std::size_t samples);
    std::size_t window() const { return window_; }
    /// Another run is the newest, or it has more samples.
    void update();
    /// Begins at once, and not only where the plot is seen.
    void updateNow();
    /// nullptr while there is none of the quantity.
    const Spectrogram* shown() const { return shown_.get(); }
    struct Shown;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Source {
        int run = -1;
        std::string quantity = {};
        std::size_t window = 0;
        std::size_t samples = 0;
        bool operator==(const Source&) const = default;
        bool isMoreOf(const Source& other) const
        {
            return run == other.run && quantity == other.quantity && window == other.window;
        }
    };
    Source wanted() const;
    void forget();
    void compute(const MinMaxPyramid& column, std::size_t length);
    void show(const std::shared_ptr<Shown>& picture, const Quantity& quantity, double end);
    void fail(const QString& problem);
    void setTitle(const QString& remark);

    RunsModel& runs_;
    PlotWidget& plot_;
    std::string quantity_;
    std::size_t window_ = 0;
    std::shared_ptr<const Spectrogram> shown_;
    Source source_; // of what is shown or being computed
    bool computing_ = false;
    std::stop_source stop_; // of what is being computed
    qint64 took_ = 0;       // the last computation [ms]
    QTimer timer_;
    TaskQueue queue_{this};
};

/// The default length for a run of so many samples.
std::size_t spectrogramWindow(std::size_t samples);

} // namespace touchdown
