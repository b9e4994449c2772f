// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the spectra of the shown runs up to date: at most four times a second while a run goes, in full when it has
// ended. The spectrum of a run that has ended is computed once for each quantity and choice of options; that of a long
// run on another thread.
#pragma once

#include <QTimer>
#include <QWidget>

#include <map>
#include <memory>
#include <set>
#include <vector>

#include <QElapsedTimer>

#include "core/numerics/spectrum.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/reference_frequencies.h"
#include "ui/calculation/task_queue.h"

namespace touchdown {

class RunsModel;
class SpectrumView;
struct Case;
struct ModesResult;
struct RunRecord;

class LiveSpectrum : public QWidget {
    Q_OBJECT

public:
    /// `runs` must outlive the widget.
    explicit LiveSpectrum(RunsModel& runs, QWidget* parent = nullptr);
    ~LiveSpectrum() override;

    /// Every shown run that has a spectrum shows it. SpectrumView::curvesChanged follows when this becomes true.
    bool complete() const { return stale_.empty() && begun_.empty(); }
    SpectrumView* view() const { return view_; }
    /// Takes over what the case asks for.
    void setOptionsOf(const Case& c);
    /// Air bearing modes that were found for a case: the spectrum offers lines at them while the newest run has the
    /// same film.
    void setFilmModes(const touchdown::Case& solved, const touchdown::ModesResult& result);
    void dataArrived(int number);
    void runFinished(int number);
    /// Spectra computed since the beginning.
    long long computed() const { return computed_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Kept {
        std::string quantity;
        WelchOptions options;
        Spectrum spectrum;
        std::vector<Peak> peaks;
    };

    void recomputeAll();
    void computeStale();
    void compute(const RunRecord& run);
    void computeElsewhere(const RunRecord& run, const std::string& quantity, const WelchOptions& options);
    void keep(int number, Kept kept);
    void restyle();
    void updateReferences();

    RunsModel& runs_;
    SpectrumView* view_;
    QTimer timer_;
    QElapsedTimer last_;             // since the last computation
    std::set<int> stale_;            // numbers of runs
    int leader_ = -1;                // number of the run whose case gives the reference frequencies
    std::multimap<int, Kept> kept_;  // by number of the run, whole runs only
    std::set<int> whole_;            // numbers of the runs whose last spectrum is shown
    std::multimap<int, Kept> begun_; // on the other thread, without spectra
    long long computed_ = 0;
    std::vector<Quantity> offered_;
    struct FilmModes;
    std::unique_ptr<FilmModes> filmModes_; // nullptr: none are known
    TaskQueue queue_{this};
};

} // namespace touchdown
