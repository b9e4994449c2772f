// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lesson and the demonstrations in the window: their panes, their stages, the runs that they ask for, and the
// values that the reader moves.
#pragma once

#include <array>
#include <map>
#include <string>

#include <QObject>

#include "ui/guides/lesson_pane.h"

namespace touchdown {

class GuideStrip;
class LessonStages;
class LiveRuns;
class LiveValues;
class Workbench;

class Guides : public QObject {
    Q_OBJECT

public:
    /// `window`: of the panes and of the strip.
    Guides(Workbench& bench, QWidget& window);

    /// Opens the pane, at its last step; the other one is closed.
    void open(LessonPane::Kind kind);
    /// nullptr before it was opened.
    LessonPane* pane(LessonPane::Kind kind) const { return panes_[static_cast<std::size_t>(kind)]; }
    /// Opens and runs what a step asks for.
    void perform(const LessonRun& run);
    /// Whether the case that was opened is one that a step asked for.
    bool openedCase() const;
    bool staged() const;
    /// The user opened or closed a pane.
    void toggle(QWidget* pane, bool open);
    LiveRuns& live() { return *live_; }
    /// The pane whose stage it is; nullptr: none.
    const LessonPane* shown() const { return shown_; }
    /// For a lecture: what the pane says stands below the page.
    void present(bool on);
    GuideStrip* strip() const { return strip_; }
    /// Whether the case differs from that of its step in values that the step lets the reader move, and in no others.
    bool onlyTried() const;
    /// To another step of it: 1 is the next one.
    void go(int steps);

signals:
    void stepShown();
    /// A pane is to be shown beside the page, `name` of its dock, or no longer.
    void paneWanted(QWidget* pane, const QString& name, const QString& title);
    void paneLeft(QWidget* pane);
    /// A key of a parameter in a text was chosen.
    void keyChosen(const QString& key);

private:
    /// A case was opened: the stage ends, to begin anew if a step asked for that case.
    void leave();
    void showLive();
    bool maybeLost() const;
    void showStrip();
    /// Their movements run the case.
    void follow(const LiveValues& values);
    /// Opens the case of a run, then runs it, or only shows it.
    void openCaseOf(const LessonRun& run, bool start);
    void dropReplaced(int number);
    void takeValuesOfNewestRun();
    LessonPane* build(LessonPane::Kind kind);
    void onStep(LessonPane::Kind kind);
    void showStep();
    void followUndo();
    void showResults();
    void showWords();
    void stage();

    Workbench& bench_;
    QWidget& window_;
    LessonStages* stages_;
    LiveRuns* live_;
    GuideStrip* strip_;
    bool presented_ = false;
    std::array<LessonPane*, 2> panes_{};                        // by kind
    LessonPane* shown_ = nullptr;                               // whose stage it is
    std::map<std::string, std::map<std::size_t, int>> numbers_; // in the list, by title of a step: of its runs
    QString opens_;                                             // the sample case that a step asks for
    bool ownCase_ = false;                                      // the case that is edited was opened by a step
};

} // namespace touchdown
