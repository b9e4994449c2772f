// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the window says of a run, a study or a static solution that has ended or is shown: in the message strip, and
// beside the case as long as the result is of that case.
#pragma once

#include <QString>

namespace touchdown {

class AboutCasePane;
class FilmWindow;
class MessageStrip;
struct Case;
struct RunRecord;
struct SteadyResult;
struct StudyReport;

class ResultMessages {
public:
    /// All must outlive this.
    ResultMessages(MessageStrip& messages, AboutCasePane& about, const FilmWindow& film);

    /// `quiet`: a good end is not said in the strip.
    void runEnded(const RunRecord& run, bool quiet);
    void solved(const SteadyResult& result);
    /// `onItsPage`: the findings stand on the page that is shown.
    void studied(const StudyReport& report, bool onItsPage);
    /// Another solution is shown, or none. `onItsPage`: the page of the static state is shown.
    void solutionShown(bool onItsPage);
    /// The message of a solution leaves with its case.
    void clearSolution();

private:
    void show(const SteadyResult& result);
    void showBesideCase(const Case& solved, const SteadyResult& result);

    MessageStrip& messages_;
    AboutCasePane& about_;
    const FilmWindow& film_;
    QString solutionText_; // the message of the last solution
};

} // namespace touchdown
