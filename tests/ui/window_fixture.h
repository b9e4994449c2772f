// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <QComboBox>
#include <QDockWidget>
#include <QSignalSpy>
#include <QtTest>

#include "core/case/parameters.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

namespace touchdown::test {

/// A window on a sample case, at full speed.
struct WindowFixture {
    explicit WindowFixture(const char* sample = "fig10a", StudyCatalogue studies = coreStudies())
        : window(std::move(studies))
    {
        window.resize(1400, 900);
        window.show();
        window.files().openNow(QString::fromLatin1(sample));
    }

    void edit(const char* key, const QString& text) { window.edits().enter(*findParameter(key), text); }
    QDockWidget* dock(const char* name) const { return window.findChild<QDockWidget*>(QString::fromLatin1(name)); }
    void choosePace(double simulatedPerWallSecond)
    {
        QComboBox* pace = window.actions().pace;
        pace->setCurrentIndex(pace->findData(simulatedPerWallSecond));
    }
    /// Until the run, the solution or the study that `begin` starts has ended.
    template <class Begin>
    void toEnd(const Begin& begin)
    {
        const QSignalSpy ended(&window, &MainWindow::calculationEnded);
        begin();
        if (!QTest::qWaitFor([&] { return ended.count() == 1; }, 60'000)) qFatal("the calculation does not end");
    }
    /// The record of a run that has ended.
    const RunRecord& runToEnd()
    {
        toEnd([this] { window.startRun(); });
        return window.runs().record(window.runs().count() - 1);
    }

    MainWindow window;
};

} // namespace touchdown::test
