// SPDX-License-Identifier: GPL-3.0-or-later
//
// A window with a session, in a folder of its own for the data of the program.
#pragma once

#include <memory>

#include <QComboBox>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sessions/session_data.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_window.h"
#include "ui/runs/runs_model.h"
#include "ui/sessions/session.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

namespace touchdown::test {

class WindowSession : protected SessionData {
protected:
    void end()
    {
        window_.reset();
        qunsetenv("XDG_DATA_HOME");
    }

    /// A new window, as the program starts it. Without close() the one before is left as by a kill.
    MainWindow& start(bool offer = true, const QString& fileOrSample = QStringLiteral("fig10a"))
    {
        window_.reset();
        window_ = std::make_unique<MainWindow>();
        window_->files().openNow(fileOrSample);
        window_->show();
        window_->beginSession(offer);
        return *window_;
    }
    Session& session() const { return *window_->findChild<Session*>(); }
    /// Until all that can be restored is in the window.
    void restore()
    {
        answer(*window_, "restoreSession", QStringLiteral("Restore"));
        QTRY_VERIFY(!session().restoring());
    }
    void run()
    {
        window_->startRun();
        QTRY_VERIFY(!window_->controller().active());
    }
    void kill() { window_.reset(); }
    /// What the question at the start says; empty: it does not ask.
    QString offered() const
    {
        const QMessageBox* box = question(*window_, "restoreSession");
        return box ? box->informativeText() : QString();
    }
    void edit(const char* key, const QString& text) { window_->edits().enter(*findParameter(key), text); }

    std::unique_ptr<MainWindow> window_;
};

} // namespace touchdown::test
