// SPDX-License-Identifier: GPL-3.0-or-later
//
// A workbench with a session, without a window.
#pragma once

#include <memory>
#include <utility>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"
#include "tests/ui/fake_workbench.h"
#include "tests/ui/sessions/session_data.h"
#include "ui/sessions/session.h"
#include "ui/sessions/session_offer.h"

namespace touchdown::test {

class BenchSession : protected SessionData {
protected:
    void end()
    {
        kill();
        qunsetenv("XDG_DATA_HOME");
    }
    /// A new session. The one before is left as by a kill.
    void start(const QString& fileOrSample = QStringLiteral("fig10a"), StudyCatalogue studies = coreStudies())
    {
        kill();
        bench_ = std::make_unique<FakeWorkbench>(fileOrSample, std::move(studies));
        session_ = std::make_unique<Session>(*bench_, nullptr);
        QStringList remarks;
        left_ = newestBrokenOff(remarks);
    }
    void kill()
    {
        left_.reset();
        session_.reset();
        bench_.reset();
    }
    /// What the session before left; empty: nothing.
    QString offered() const { return left_ ? describe(readSession(left_->path())) : QString(); }
    /// Until all that can be restored is there.
    void restore()
    {
        session_->restore(std::move(left_));
        QTRY_VERIFY(!session_->restoring());
    }
    void edit(const char* key, const QString& text) { bench_->edits().enter(*findParameter(key), text); }

    std::unique_ptr<FakeWorkbench> bench_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<SessionFolder> left_;
};

} // namespace touchdown::test
