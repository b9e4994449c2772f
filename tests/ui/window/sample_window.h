// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QSignalSpy>
#include <QtTest>

#include "core/case/parameters.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

namespace touchdown::test {

/// A window on a sample case, at full speed.
struct SampleWindow {
    explicit SampleWindow(const char* sample = "fig10a")
    {
        window.resize(1400, 900);
        window.show();
        window.files().openNow(QString::fromLatin1(sample));
    }

    void edit(const char* key, const QString& text) { window.edits().enter(*findParameter(key), text); }
    void choosePace(double simulatedPerWallSecond)
    {
        QComboBox* pace = window.actions().pace;
        pace->setCurrentIndex(pace->findData(simulatedPerWallSecond));
    }
    /// The record of a run that has ended.
    const RunRecord& runToEnd()
    {
        const QSignalSpy finished(&window.controller(), &RunController::finished);
        window.startRun();
        if (!QTest::qWaitFor([&] { return finished.count() == 1; }, 60'000)) qFatal("the run does not end");
        return window.runs().record(window.runs().count() - 1);
    }

    MainWindow window;
};

} // namespace touchdown::test
