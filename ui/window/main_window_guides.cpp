// SPDX-License-Identifier: GPL-3.0-or-later
//
// What helps a person along: first steps, gallery, lesson, help, and the figure for a paper.
#include "ui/window/main_window.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "core/case_files/case_file.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/surface_page.h"
#include "ui/guides/guides.h"
#include "ui/guides/lesson_print.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/small_motions_strip.h"
#include "ui/runs/run_view.h"
#include "ui/slider/surface_editor.h"
#include "ui/style/message_strip.h"
#include "ui/style/save_dialog.h"
#include "ui/style/whole_file.h"
#include "ui/window/case_gallery.h"
#include "ui/window/figure_dialog.h"
#include "ui/window/presenter.h"
#include "ui/window/start_card.h"
#include "ui/window/window_actions.h"

namespace touchdown {

namespace {

constexpr double greetedPart = 0.3e-3; // of the default case that a newcomer sees in slow motion [s]
constexpr double greetedPace = 3e-5;   // [simulated seconds per second]

} // namespace

void MainWindow::connectHelp()
{
    connect(actions_->help, &QAction::triggered, this, [this] { showHelp(HelpWindow::Page::Use); });
    connect(actions_->firstSteps, &QAction::triggered, this, [this] { files_->whenSettled([this] { greet(); }); });
    const auto open = [this](LessonPane::Kind kind) {
        startCard_->close();
        guides_->open(kind);
    };
    connect(actions_->lesson, &QAction::triggered, this, [open] { open(LessonPane::Kind::Lesson); });
    connect(actions_->demonstrations, &QAction::triggered, this, [open] { open(LessonPane::Kind::Demonstrations); });
    connect(actions_->printLesson, &QAction::triggered, this, &MainWindow::printLesson);
    connect(startCard_->lesson(), &QPushButton::clicked, actions_->lesson, &QAction::trigger);
    connect(startCard_->figures(), &QPushButton::clicked, actions_->demonstrations, &QAction::trigger);
    connect(guides_, &Guides::paneWanted, pages_, [this](QWidget* pane, const QString& name, const QString& title) {
        pages_->showGuide(*pane, name, title);
    });
    connect(guides_, &Guides::paneLeft, pages_, [this](QWidget* pane) { pages_->hideGuide(*pane); });
    connect(pages_, &WindowPages::guideToggled, guides_, &Guides::toggle);
    connect(guides_, &Guides::keyChosen, this, [this](const QString& key) {
        findChild<QDockWidget*>(QStringLiteral("parameters"))->show();
        casePanel_->showParameter(key.toStdString());
    });
    connect(actions_->stop, &QAction::triggered, &guides_->live(), &LiveRuns::leave);
    connect(&guides_->live(), &LiveRuns::busyChanged, this, &MainWindow::updateRunActions);
    connect(pages_, &WindowPages::shown, smallMotions_, &SmallMotionsStrip::showState);
    connect(presenter_, &Presenter::changed, smallMotions_, &SmallMotionsStrip::showState);
    connect(startCard_->openFile(), &QPushButton::clicked, files_, &CaseFiles::chooseFile);
    connect(startCard_, &StartCard::closed, this, [this] {
        endSlowMotion();
        if (!guides_->staged()) runView().setStage({});
    });
    connect(files_, &CaseFiles::opened, startCard_, &StartCard::close);
    // Slow where it bounces.
    connect(&controller(), &RunController::delivered, this, [this](const RunDelivery& delivery) {
        if (slowMotion_ && delivery.time > greetedPart) endSlowMotion();
    });
    connect(actions_->shortcuts, &QAction::triggered, this, [this] { showHelp(HelpWindow::Page::Shortcuts); });
    connect(actions_->aboutProgram, &QAction::triggered, this, [this] { showHelp(HelpWindow::Page::About); });
    connect(actions_->aboutQt, &QAction::triggered, this, [this] {
        auto* box =
            new QMessageBox(QMessageBox::NoIcon, tr("About Qt"),
                            tr("Touchdown uses Qt %1, by The Qt Company and its contributors, under the GNU General "
                               "Public License, version 3.")
                                .arg(QString::fromLatin1(qVersion())),
                            QMessageBox::Close, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
}

void MainWindow::greet()
{
    files_->openNow(QString::fromUtf8(defaultCaseName.data(), static_cast<qsizetype>(defaultCaseName.size())));
    setPage(Page::Run);
    runView().setPage(RunView::Page::Plots);
    PlotStage stage;
    stage.plots << QStringLiteral("spacing");
    stage.side = true;
    runView().setStage(stage);
    startCard_->open();
    startRun();
    slowMotion_ = true;
    controller().setPace(greetedPace);
}

void MainWindow::endSlowMotion()
{
    slowMotion_ = false;
    controller().setPace(actions_->pace->currentData().toDouble());
}

void MainWindow::makeFigure()
{
    const QString source = files_->file().isEmpty() ? files_->shortName() : files_->file();
    auto* dialog = new FigureDialog(*page(), QStringLiteral("%1 %2").arg(int(pages_->page())).arg(source),
                                    files_->shortName().section(u'.', 0, 0), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

/// The window can be used meanwhile.
void MainWindow::printLesson()
{
    const QFileDialog* dialog =
        openSaveDialog(this, tr("Print the lesson"), {tr("Portable document (*.pdf)")}, QStringLiteral("lesson.pdf"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { printLessonTo(file); });
}

void MainWindow::printLessonTo(const QString& file)
{
    auto* print = new LessonPrint(lessonSteps(), tr("Touchdown: the lesson"), this);
    print->showProgress(this, QFileInfo(file).fileName());
    connect(print, &LessonPrint::ended, this, [this, print, file](bool whole, const QString& problem) {
        print->deleteLater();
        const QString said = whole ? writeWholeFile(file, print->pdf()) : problem;
        if (!said.isEmpty())
            messages_->show(MessageStrip::Kind::Failure, said);
        else if (whole)
            messages_->show(MessageStrip::Kind::Success,
                            tr("The lesson is in %1.").arg(QDir::toNativeSeparators(file)));
    });
    print->start();
}

void MainWindow::showGallery()
{
    auto* dialog = new CaseGallery(tr("Gallery of cases"), sampleCaseItems(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CaseGallery::chosen, files_, &CaseFiles::open);
    dialog->open();
}

void MainWindow::chooseNewCase()
{
    auto* dialog = new CaseGallery(tr("New case"), newCaseItems(palette()), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CaseGallery::chosen, files_, &CaseFiles::newCase);
    // The keys of the plan draw on it at once.
    connect(dialog, &CaseGallery::chosen, film_->view()->shape()->editor(), qOverload<>(&QWidget::setFocus));
    dialog->gallery()->setCurrentRow(1); // below its heading: Enter takes it
    dialog->open();
}

void MainWindow::showHelp(HelpWindow::Page page)
{
    if (!help_) help_ = new HelpWindow(actions_->shortcutTable(), this);
    help_->open(page);
}

} // namespace touchdown
