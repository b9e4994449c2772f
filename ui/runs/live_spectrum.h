// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the spectra of the shown runs up to date: at most four times a second while a run goes, in full when it has
// ended. The spectrum of a run that has ended is computed once for each quantity and choice of options.
#pragma once

#include <QTimer>
#include <QWidget>

#include <map>
#include <set>
#include <vector>

#include <QElapsedTimer>

#include "core/numerics/spectrum.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

class RunsModel;
class SpectrumView;
struct Case;
struct RunRecord;

class LiveSpectrum : public QWidget {
    Q_OBJECT

public:
    /// `runs` must outlive the widget.
    explicit LiveSpectrum(RunsModel& runs, QWidget* parent = nullptr);

    SpectrumView* view() const { return view_; }
    /// Takes over what the case asks for.
    void setOptionsOf(const Case& c);
    void dataArrived(int number);
    void runFinished(int number);
    /// Spectra computed since the beginning.
    long long computed() const { return computed_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void recomputeAll();
    void computeStale();
    void compute(const RunRecord& run);
    void restyle();

    RunsModel& runs_;
    SpectrumView* view_;
    QTimer timer_;
    QElapsedTimer last_;  // since the last computation
    std::set<int> stale_; // numbers of runs
    struct Kept {
        std::string quantity;
        WelchOptions options;
        Spectrum spectrum;
        std::vector<Peak> peaks;
    };
    std::multimap<int, Kept> kept_; // by number of the run, whole runs only
    std::set<int> whole_;           // numbers of the runs whose last spectrum is shown
    long long computed_ = 0;
    std::vector<Quantity> offered_;
};

} // namespace touchdown
