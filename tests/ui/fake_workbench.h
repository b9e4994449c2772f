// SPDX-License-Identifier: GPL-3.0-or-later
//
// A workbench without a window: a case with its runs, solutions and studies.
#pragma once

#include <utility>

#include <QAction>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QtTest>

#include "core/simulation/static_state/contact_rest.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/workbench/workbench.h"

namespace touchdown::test {

class FakeWorkbench : public Workbench {
public:
    explicit FakeWorkbench(const QString& fileOrSample = QStringLiteral("fig10a"),
                           StudyCatalogue studies = coreStudies())
        : edits_(new CaseEdits(&window_)),
          files_(new CaseFiles(*edits_, window_)),
          runs_(new RunWindow(&window_)),
          film_(new FilmWindow(steadyWithContact, new QAction(&window_), &window_)),
          studies_(new StudyWindow(std::move(studies), &window_)),
          messages_(new MessageStrip(&window_))
    {
        window_.resize(1000, 800);
        (new QVBoxLayout(&window_))->addWidget(runs_->view());
        for (auto* part : window_.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
            part->setVisible(part == runs_->view());
        QObject::connect(files_, &CaseFiles::opened, runs_, [this] {
            film_->open(edits_->value());
            runs_->view()->opened(files_->sample(), edits_->value());
        });
        QObject::connect(edits_, &CaseEdits::edited, runs_, [this] {
            film_->edit(edits_->value());
            runs_->view()->setCase(edits_->value());
            studies_->editor()->setCase(edits_->value());
        });
        files_->openNow(fileOrSample);
    }
    ~FakeWorkbench() override
    {
        runs_->controller().stopAndWait();
        film_->controller().stopAndWait();
        studies_->controller().stopAndWait();
        edits_->disconnect();
        qDeleteAll(window_.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)); // they show the rest
    }

    CaseEdits& edits() override { return *edits_; }
    CaseFiles& files() override { return *files_; }
    RunWindow& runWindow() override { return *runs_; }
    FilmWindow& film() override { return *film_; }
    StudyWindow& studies() override { return *studies_; }
    MessageStrip& messages() override { return *messages_; }
    Page shownPage() const override { return page_; }
    void setPage(Page page) override { page_ = page; }
    void startRun() override { runs_->start({edits_->value(), files_->wholeText(), {}}); }
    void performStudy() override { studies_->perform(); }

    RunsModel& runs() { return runs_->runs(); }
    RunController& controller() { return runs_->controller(); }
    RunView& runView() { return *runs_->view(); }
    /// Holds all widgets and dialogs; not shown unless the test shows it.
    QWidget& window() { return window_; }
    void runToEnd()
    {
        const QSignalSpy ended(runs_, &RunWindow::ended);
        startRun();
        if (!QTest::qWaitFor([&] { return ended.count() == 1; }, 60'000)) qFatal("the run does not end");
    }

private:
    QWidget window_;
    CaseEdits* edits_;
    CaseFiles* files_;
    RunWindow* runs_;
    FilmWindow* film_;
    StudyWindow* studies_;
    MessageStrip* messages_;
    Page page_ = Page::Run;
};

} // namespace touchdown::test
