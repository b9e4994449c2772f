// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the spectra of the shown runs up to date: gently while a run goes, in full when it has ended.
#pragma once

#include <QTimer>
#include <QWidget>

#include <set>
#include <vector>

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

protected:
    void showEvent(QShowEvent* event) override;

private:
    void recomputeAll();
    void computeStale();
    void compute(const RunRecord& run);

    RunsModel& runs_;
    SpectrumView* view_;
    QTimer timer_;
    std::set<int> stale_; // numbers of runs
    std::vector<Quantity> offered_;
};

} // namespace touchdown
