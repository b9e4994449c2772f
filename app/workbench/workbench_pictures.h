// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of the window and of the charts of a study, for scripts and for the README. The names of the files go to
// standard output. The functions return the exit code: 0; 1 when there is no valid answer; 2 when something could not
// be read or written.
#pragma once

#include <QString>

#include "core/case_files/outside_path.h"

namespace touchdown {

class MainWindow;

struct PictureRequest {
    QString exportFolder;     // of plots; empty for none
    QString screenshot;       // of the window; empty for none
    QString size;             // of the window, "1600x1000"
    bool staticState = false; // of a film, instead of its run in time
};

/// Runs the case of the window and writes what the window shows.
int takePictures(MainWindow& window, const PictureRequest& request);

/// Performs a study without a window and writes each chart as <kind>.png and <kind>.svg to the folder, numbered from 1
/// where there are several; its findings go to standard error.
int takeStudyPictures(const QString& kind, const QString& fileOrSample, const QString& folder, OutsidePaths outside);

/// Performs the runs of the lesson without a window and writes it as PDF.
int printLesson(const QString& file);

} // namespace touchdown
