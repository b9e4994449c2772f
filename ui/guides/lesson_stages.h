// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage of the lesson and of the demonstrations: each step shows its own runs alone, in the plots and ranges that
// it names. A step that is left keeps its runs, and they come back with it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "core/studies/lesson/lesson.h"
#include "ui/runs/live_plots.h"

namespace touchdown {

class RunView;
class RunsModel;
struct RunRecord;

/// What a run gave, in a few words: "ends at 7.000 nm · 6 touches". `from`: where the stage begins [s].
QString lessonResult(const RunRecord& run, double from);
/// The words at the curves of those runs of a step that came to their end; `numbers` in the list, by the place of the
/// run in the step.
std::vector<LivePlots::Word> lessonWords(const LessonStep& step, const std::map<std::size_t, int>& numbers,
                                         const RunsModel& runs);

class LessonStages : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this.
    LessonStages(RunView& view, RunsModel& runs, QObject* parent);

    void show(const LessonStep& step);
    /// The newest run of this step in the list, of this case if one is given; nullptr: none.
    const RunRecord* newestOf(const LessonStep& step, const Case* value = nullptr) const;
    /// The plots and the earlier runs are again as the user chose; without such runs those of the step stay.
    void end();
    bool active() const { return step_.has_value(); }

private:
    void tick(int row, bool shown);

    RunView& view_;
    RunsModel& runs_;
    std::optional<std::string> step_;              // its title
    std::map<std::string, std::set<int>> numbers_; // of the runs of each step
    std::set<int> before_;                         // numbers of the runs that were shown before the lesson
};

} // namespace touchdown
