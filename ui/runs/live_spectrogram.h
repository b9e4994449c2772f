// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spectrogram of a quantity of the newest run, in a plot over time: power spectral density in dB
// (core/numerics/spectrogram.h), bright where it is high. The range of colours ends at the largest density and begins
// 80 dB below it. The title states the resolution in time and in frequency. The automatic range of frequencies ends
// where no density comes within 60 dB of the largest.
//
// It is computed anew at most four times a second while a run goes, over at most `mostColumns` columns; at each scale
// the columns and the frequencies within a pixel are averaged. So a run of a
// million samples costs some 30 ms.
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "core/numerics/spectrogram.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

class PlotWidget;
class RunsModel;
struct RunRecord;

class LiveSpectrogram : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t mostColumns = 2048;
    static constexpr double shownDecibels = 80.0;

    /// Both must outlive it.
    LiveSpectrogram(RunsModel& runs, PlotWidget& plot, QObject* parent);

    void setQuantity(const std::string& name);
    /// Of the window, in samples; 0: a thirty-second of the run, a power of two from 64 to 4096.
    void setWindow(std::size_t samples);
    std::size_t window() const { return window_; }
    /// Another run is the newest, or it has more samples.
    void update();
    /// At once, and not only where the plot is seen.
    void updateNow();
    const Spectrogram* shown() const { return shown_.get(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(const RunRecord* run);

    RunsModel& runs_;
    PlotWidget& plot_;
    std::string quantity_;
    std::size_t window_ = 0;
    std::shared_ptr<const Spectrogram> shown_;
    // What it was computed from.
    int run_ = -1;
    std::size_t samples_ = 0;
    bool stale_ = true;
    QTimer timer_;
};

/// The default length for a run of so many samples.
std::size_t spectrogramWindow(std::size_t samples);

} // namespace touchdown
