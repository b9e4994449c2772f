// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the case of a window and writes what it shows, for scripts and for the README.
#pragma once

#include <QString>

namespace touchdown {

class MainWindow;

struct PictureRequest {
    QString exportFolder;     // of plots; empty for none
    QString screenshot;       // of the window; empty for none
    QString size;             // of the window, "1600x1000"
    bool staticState = false; // of a film, instead of its run in time
};

/// The exit code: 0, 1 when the run came to no valid answer, 2 when something could not be written.
int takePictures(MainWindow& window, const PictureRequest& request);

} // namespace touchdown
