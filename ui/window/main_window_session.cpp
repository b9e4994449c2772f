// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the window does at its start and its end: arrangement and case of the last session, the work that is kept
// against a crash, the question before it closes.
#include "ui/window/main_window.h"

#include <algorithm>
#include <optional>

#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QProgressDialog>
#include <QScreen>
#include <QSettings>

#include "core/case_files/case_file.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/film/film_window.h"
#include "ui/guides/guides.h"
#include "ui/guides/lesson_print.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_view.h"
#include "ui/sessions/restore_strip.h"
#include "ui/sessions/session.h"
#include "ui/sessions/session_offer.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/message_strip.h"
#include "ui/window/presenter.h"
#include "ui/window/window_actions.h"
#include "ui/workbench/closing_question.h"

namespace touchdown {

namespace {

constexpr int stateVersion = 3;          // of the arrangement of the panes in the settings
constexpr std::size_t mostSessions = 12; // in the menu
constexpr auto reopenKey = "session/reopen";

} // namespace

void MainWindow::connectSession()
{
    connect(closing_, &ClosingQuestion::answered, this, [this] {
        mayClose_ = true;
        close();
    });
    files_->setResultsQuestion(
        [this](const std::function<void()>& next) { return closing_->asksBeforeAnotherCase(next); });
    files_->setKeptTest([this](const Case& c) { return isInResults(*this, c); });
    connect(actions_->sessions, &QMenu::aboutToShow, this, &MainWindow::listSessions);
    actions_->reopen->setChecked(QSettings().value(reopenKey, true).toBool());
    connect(actions_->reopen, &QAction::triggered, this, [](bool on) { QSettings().setValue(reopenKey, on); });
    for (QAction* action : actions_->sessionSpace->actions())
        if (action->data().toLongLong() == Session::budget()) action->setChecked(true);
    connect(actions_->sessionSpace, &QActionGroup::triggered, this,
            [](const QAction* action) { Session::setBudget(action->data().toLongLong()); });
}

void MainWindow::beginSession(bool offer, QStringList remarks)
{
    session_ = new Session(*this, this);
    connect(pages_, &WindowPages::shown, session_, &Session::schedule);
    pages_->addNotice(*restoreStrip(*session_, *messages_, *this));
    connect(session_, &Session::problemChanged, this, &MainWindow::showWhatIsKept);
    showWhatIsKept();
    connect(session_, &Session::failed, this, [this](const QString& text) {
        auto* box = new QMessageBox(QMessageBox::Warning, tr("Touchdown"), text, QMessageBox::Ok, this);
        box->setObjectName(QStringLiteral("notKept"));
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
    if (!session_->folder()) {
        remarks << session_->problem();
        return messages_->show(MessageStrip::Kind::Warning, remarks.join(QLatin1Char('\n')));
    }
    std::unique_ptr<SessionFolder> last = newestBrokenOff(remarks);
    if (last && offer)
        return offerSession(*this, std::move(last), remarks,
                            [this](std::unique_ptr<SessionFolder> taken) { session_->restore(std::move(taken)); });
    if (last) remarks << tr("A session ended without being closed. File, Sessions, Restore brings its work back.");
    if (!remarks.isEmpty()) messages_->show(MessageStrip::Kind::Information, remarks.join(QLatin1Char('\n')));
}

/// A word that stays in the status bar while not all of the work is kept.
void MainWindow::showWhatIsKept()
{
    QLabel* mark = pages_->notKept();
    mark->setVisible(!session_->problem().isEmpty());
    mark->setToolTip(plainTip(session_->problem()));
    mark->setAccessibleDescription(session_->problem());
}

void MainWindow::listSessions()
{
    QMenu* menu = actions_->sessions;
    menu->clear();
    if (session_ && !session_->problem().isEmpty()) menu->addAction(onButton(session_->problem()))->setEnabled(false);
    if (session_ && session_->restoring()) menu->addAction(tr("A session is being restored"))->setEnabled(false);
    const bool ready = session_ && session_->folder() && !session_->restoring();
    std::vector<EndedSession> sessions = ready ? endedSessions() : std::vector<EndedSession>{};
    sessions.resize(std::min(sessions.size(), mostSessions));
    for (const EndedSession& session : sessions) {
        const auto& [path, state] = session;
        const QString left = state.newer ? QString() : describe(state);
        if (left.isEmpty()) continue;
        menu->addAction(QStringLiteral("%1: %2").arg(
                            QLocale().toString(state.written.toLocalTime(), QLocale::ShortFormat), onButton(left)),
                        this, [this, path] {
                            files_->whenSettled([this, path] {
                                if (auto folder = SessionFolder::take(path)) session_->restore(std::move(folder));
                            });
                        });
    }
    if (menu->isEmpty()) menu->addAction(tr("None"))->setEnabled(false);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    takeTyped();
    if (guides_->onlyTried()) files_->leaveUnsaved();
    if (session_) session_->reader().stopAndWait();
    studies_->editor()->plan(); // takes what was typed in its form
    if (!mayClose_ && !closing_->nothingLost(session_ && session_->keepsAll())) {
        event->ignore();
        return;
    }
    for (QProgressDialog* print : findChildren<QProgressDialog*>()) print->cancel();
    qDeleteAll(findChildren<LessonPrint*>());
    controller().stopAndWait();
    film_->controller().stopAndWait();
    studies_->controller().stopAndWait();
    if (session_) session_->close(!unsavedWork(*this).empty() || hasNotesOnFiles(*this));
    saveArrangement();
    event->accept();
}

void MainWindow::saveArrangement()
{
    presenter_->set(false);
    actions_->alone->setChecked(false);
    runs_->view()->setStage(std::nullopt); // the parts have the sizes that the user gave them
    setPage(Page::Run);                    // the next session begins with its panes
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState(stateVersion));
    settings.setValue(QStringLiteral("window/parts"), runs_->view()->splitter()->saveState());
    if (const QAction* theme = actions_->theme->checkedAction())
        settings.setValue(QStringLiteral("window/theme"), theme->data());
    if (const QAction* size = actions_->fontSize->checkedAction())
        settings.setValue(QStringLiteral("window/font"), size->data());
    settings.setValue(QStringLiteral("runs/overlay"), runs_->panel()->overlay());
    settings.setValue(QStringLiteral("runs/side"), runs_->view()->sideWanted()->isChecked());
    settings.setValue(QStringLiteral("runs/plots"),
                      QJsonDocument(runs_->view()->plots()->arrangement()).toJson(QJsonDocument::Compact));
    settings.setValue(QStringLiteral("runs/pace"), actions_->pace->currentIndex());
    settings.setValue(QStringLiteral("files/last"), files_->origin());
}

void MainWindow::fitScreen()
{
    const int title = style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, this);
    const QRect room = screen()->availableGeometry().adjusted(0, title, 0, 0);
    QRect place(pos(), size().boundedTo(room.size()));
    if (!testAttribute(Qt::WA_Moved)) return resize(place.size()); // the system chooses where
    // Another screen had a place for it.
    const QSize shown = place.size().expandedTo(minimumSizeHint());
    place.moveTo(std::max(room.left(), std::min(geometry().left(), room.right() + 1 - shown.width())),
                 std::max(room.top(), std::min(geometry().top(), room.bottom() + 1 - shown.height())));
    if (place != geometry()) setGeometry(place);
}

void MainWindow::restoreArrangement()
{
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    fitScreen(); // before look(), which keeps the size
    arranged_ = restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), stateVersion);
    runs_->view()->splitter()->restoreState(settings.value(QStringLiteral("window/parts")).toByteArray());
    const auto check = [](QActionGroup* group, const QVariant& value) {
        for (QAction* action : group->actions())
            if (action->data().toString() == value.toString()) action->setChecked(true);
    };
    check(actions_->theme, settings.value(QStringLiteral("window/theme"), QStringLiteral("system")));
    check(actions_->fontSize, settings.value(QStringLiteral("window/font"), 0));
    const QByteArray plots = settings.value(QStringLiteral("runs/plots")).toByteArray();
    runs_->view()->plots()->restore(QJsonDocument::fromJson(plots).object());
    runs_->panel()->setOverlay(settings.value(QStringLiteral("runs/overlay"), true).toBool());
    runs_->view()->sideWanted()->setChecked(settings.value(QStringLiteral("runs/side"), false).toBool());
    actions_->pace->setCurrentIndex(settings.value(QStringLiteral("runs/pace"), 0).toInt());
    pages_->showPanesOfPage();
    look();
}

void MainWindow::openLastCase()
{
    const QString last = QSettings().value(QStringLiteral("files/last")).toString();
    const bool sample =
        std::ranges::any_of(sampleCases(), [&last](const SampleCase& c) { return last == QLatin1String(c.name); });
    // A file that was deleted or is no longer valid is no error at the start.
    std::optional<CaseDocument> read;
    if (QSettings().value(reopenKey, true).toBool() && !last.isEmpty() && (sample || QFileInfo::exists(last)))
        read = touchdown::openCase(last.toStdString());
    if (!read || !read->valid())
        files_->openNow(QString::fromUtf8(defaultCaseName.data(), static_cast<qsizetype>(defaultCaseName.size())));
    if (read && (read->valid() || !read->outsideFiles.empty())) files_->openNow(last); // the latter after a question
}

} // namespace touchdown
