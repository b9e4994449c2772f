// SPDX-License-Identifier: GPL-3.0-or-later
//
// The actions of the window, their menus and the tool bar. The window connects them.
#pragma once

#include "core/case/case.h"
#include "ui/style/theme.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>
#include <QUndoStack>

#include <vector>

namespace touchdown {

class WindowActions : public QObject {
    Q_OBJECT

public:
    /// Builds the menus and the tool bar of `window`.
    WindowActions(QMainWindow& window, QUndoStack& undo);

    QAction *newCase, *open, *caseGallery, *save, *saveAs, *importCml, *exportCml, *exportDxf, *underlay, *openResults,
        *exportPage, *figure, *exportCsv, *saveResults, *quit;
    QAction *undo, *redo, *resetAll, *findParameter, *copyPage;
    QAction *run, *continueRun, *solve, *solveGiven, *smallMotions, *study, *pause, *step, *stop, *record;
    QAction* printLesson;
    QAction *surface, *fit, *follow, *zoomBack, *zoomForward, *alone, *presenter, *fullScreen;
    QAction *help, *firstSteps, *lesson, *demonstrations, *shortcuts, *aboutProgram, *aboutQt;
    QMenu *samples, *recent, *panes, *plots;
    QMenu* sessions;            // earlier ones that can be restored
    QAction* reopen;            // whether the next start opens the last case
    QActionGroup* runMemory;    // data: bytes that runs may take; 0: a quarter of the machine
    QActionGroup* sessionSpace; // data: bytes that sessions may take on the disk
    QActionGroup* theme;        // data: the name of the theme
    QActionGroup* fontSize;     // data: points added to the system's own
    QComboBox* pace;            // data: simulated seconds per second, as a double
    QToolBar* toolBar;

    /// Draws the icons anew, as after a change of the palette.
    void updateIcons(const QPalette& palette);
    /// All actions with a shortcut, as HTML.
    QString shortcutTable() const;
    /// Offers what the model can do, and what belongs to the page of runs in time, if that is shown.
    void setPage(ModelKind model, bool inTime);

signals:
    void sampleChosen(const QString& name);

private:
    QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys = {}, const QString& iconName = {},
                 const QString& tip = {});
    /// Of which one is chosen.
    QActionGroup* choices(QMenu* menu, const std::vector<std::pair<QVariant, QString>>& entries);
    void buildFile(QMainWindow& window);
    void buildSessions(QMenu* menu);
    void buildEdit(QMainWindow& window, QUndoStack& stack);
    void buildRun(QMainWindow& window);
    void buildView(QMainWindow& window);
    void buildHelp(QMainWindow& window);
    void buildToolBar(QMainWindow& window);

    std::vector<std::pair<QAction*, QString>> icons_;
    std::vector<QAction*> all_;
    std::vector<QAction*> pace_; // label and box in the tool bar
};

} // namespace touchdown
