// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a series of static states: what varies, plots over it, and a table. Points appear as they are solved;
// what was solved before a stop remains.
#pragma once

#include "core/simulation/static_state/contact_rest.h"
#include "ui/calculation/result_page.h"
#include "ui/film/series_controller.h"
#include "ui/film/series_file.h"
#include "ui/film/series_plots.h"

namespace touchdown {

class SeriesSetup;

class SeriesPage : public ResultPage {
    Q_OBJECT

public:
    explicit SeriesPage(SteadyController::Solver solver = steadyWithContact, QWidget* parent = nullptr);

    /// The case as it is edited.
    void setCase(const Case& c);
    /// Another case was opened: no series of it is known.
    void open(const Case& c);
    void fit() { plots_->fit(); }

    SeriesController& controller() { return controller_; }
    SeriesSetup* setup() const { return setup_; }
    SeriesPlots* plots() const { return plots_; }
    const std::vector<SeriesState>& states() const { return states_; }
    bool stale() const override;
    /// The states that are known, and the case that lists their points; to be shown by another window.
    StoredSeries series() const;
    void restore(const StoredSeries& series);
    /// The states that no file has.
    std::size_t unsaved() const { return saved() ? 0 : states_.size(); }
    /// See csvOf().
    QByteArray csv() const override { return csvOf(states_); }

public slots:
    void startOrStop() override;

signals:
    /// A state of the series: the case at its point, and the result with its fields.
    void solved(const touchdown::Case& c, const touchdown::SteadyResult& result);

protected:
    Notes notes() const override;

private:
    TableRow heads() const;
    TableRow rowOf(const SeriesState& state) const;
    void begin(const Case& c, std::vector<SteadySeriesPoint> points);
    void append(std::size_t index, const SteadyResult& result);
    void onSolved(std::size_t index, const SteadyResult& result);
    void onFinished(bool stopped);
    void showProblem(const QString& text);

    SeriesController controller_;
    SeriesSetup* setup_;
    SeriesPlots* plots_;
    QString problem_;
    Case case_, solved_;
    std::vector<SteadySeriesPoint> points_;
    std::vector<SeriesState> states_;
};

} // namespace touchdown
