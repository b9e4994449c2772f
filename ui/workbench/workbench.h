// SPDX-License-Identifier: GPL-3.0-or-later
//
// A window as its guides and its session see it: the parts that hold the work, and what they ask of the window. Tests
// have one without a window.
#pragma once

namespace touchdown {

class CaseEdits;
class CaseFiles;
class FilmWindow;
class MessageStrip;
class RunWindow;
class StudyWindow;

class Workbench {
public:
    enum class Page { StaticState, Run, Studies };

    virtual ~Workbench() = default;

    /// The values of the case, with undo.
    virtual CaseEdits& edits() = 0;
    /// Opens another case, after asking.
    virtual CaseFiles& files() = 0;
    /// The list of runs, their page and their solver; likewise of the static state and of studies.
    virtual RunWindow& runWindow() = 0;
    virtual FilmWindow& film() = 0;
    virtual StudyWindow& studies() = 0;
    virtual MessageStrip& messages() = 0;

    virtual Page shownPage() const = 0;
    /// Only a film has the page of the static state; for other cases the run in time is shown instead.
    virtual void setPage(Page page) = 0;
    /// Runs the case in time.
    virtual void startRun() = 0;
    /// Performs the study in the editor of studies.
    virtual void performStudy() = 0;
};

} // namespace touchdown
