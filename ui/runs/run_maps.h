// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields that a run records at some of its times: pressure and gap of the air, and of the patch that can touch its
// contact pressure, adhesion, gap, the disk below. One is seen at one time; the slider at the foot goes through the
// times, and stays at the last one during the run. The least gap to the mean plane is the minimum spacing, as plots
// have it at that time.
//
// Colours and sections span the values of the whole run, so that times can be compared, or those of the shown time.
#pragma once

#include "ui/maps/field_map.h"
#include "ui/maps/map_kinds.h"

#include <QLabel>
#include <QSlider>
#include <QStackedWidget>
#include <QTabBar>

namespace touchdown {

struct FieldHistory;
class RunsModel;
struct RunRecord;

class RunMaps : public QWidget {
    Q_OBJECT

public:
    /// `runs` must outlive the widget.
    explicit RunMaps(RunsModel& runs, QWidget* parent = nullptr);

    /// -1: none. For a run without fields the page shows the reason.
    void showRun(int number);
    int shownRun() const { return number_; }
    void dataArrived(int number);
    /// The snapshot that is nearest to a time [s].
    void showTime(double time);
    void fit() { view_->fit(); }

    FieldsView* view() const { return view_; }
    QTabBar* tabs() const { return tabs_; }
    QSlider* time() const { return time_; }
    QLabel* reading() const { return reading_; }
    QCheckBox* sameScale() const { return sameScale_; }
    bool empty() const { return pages_->currentWidget() != view_; }
    QString emptyText() const { return emptyText_->text(); }

signals:
    /// The user went to this time [s].
    void timeChosen(double time);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void buildRows();
    void takeFields(const RunRecord& run);
    void takeTimes();
    void takeArea();
    int latestOf(const FieldHistory& shown) const;
    void refresh();
    void showField(std::size_t index);
    void showSnapshot();
    const RunRecord* run() const;
    const FieldHistory* history() const;
    FieldAtPoints gapAt(const RunRecord& run, double time) const;
    QString whyEmpty() const;
    QString readingText(const RunRecord& run, const FieldHistory& history, std::size_t index) const;

    RunsModel& runs_;
    int number_ = -1;
    int taken_ = -1;               // the run whose fields the tabs show
    std::vector<RunField> fields_; // one for each tab
    std::optional<GapInTime> gap_; // of a film run whose fields the tabs show
    std::size_t set_ = 0;          // of the field that is seen
    bool follows_ = true;          // the last snapshot, as it comes
    bool stale_ = true;
    QTabBar* tabs_;
    QLabel* name_;
    QCheckBox* sameScale_;
    FieldsView* view_;
    QLabel* emptyText_;
    QStackedWidget* pages_;
    QWidget* foot_;
    QSlider* time_;
    QLabel* reading_;
};

} // namespace touchdown
