// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session_offer.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QAbstractButton>
#include <QDir>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "ui/sessions/session_state.h"
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

QString leaveRest(std::unique_ptr<SessionFolder> folder, const SessionState& rest)
{
    if (!rest.empty()) return writeWholeFile(folder->stateFile(), toJson(rest));
    SessionFolder::remove(std::move(folder));
    return {};
}

void finishRestoring(const SessionFolder& folder)
{
    SessionState state = readSession(folder.path());
    if (state.restoring.isEmpty()) return;
    const QString path = earlierFolder(folder.path(), state.restoring);
    if (std::unique_ptr<SessionFolder> from = SessionFolder::take(path)) {
        for (const ListedState& run : state.runs)
            if (run.from > 0) moveOwnFile(from->runFile(run.from), folder.runFile(run.number));
        for (const ListedState& solution : state.solutions)
            if (solution.from > 0) moveOwnFile(from->solutionFile(solution.from), folder.solutionFile(solution.number));
        moveOwnFile(from->seriesFile(), folder.seriesFile());
        for (const QString& kind : readSession(path).reports)
            moveOwnFile(from->studyFile(kind), folder.studyFile(kind));
        SessionState rest = readSession(path);
        if (rest.edited.text == state.edited.text) rest.edited = {};
        if (rest.modes && state.modes && toJson(*rest.modes) == toJson(*state.modes)) rest.modes.reset();
        std::erase_if(rest.runs, [&](const ListedState& run) { return !isOwnFile(from->runFile(run.number)); });
        std::erase_if(rest.solutions,
                      [&](const ListedState& each) { return !isOwnFile(from->solutionFile(each.number)); });
        std::erase_if(rest.drafts, [&](const StudyDraft& draft) {
            return std::ranges::find(state.drafts, draft.text, &StudyDraft::text) != state.drafts.end();
        });
        if (rest.notUnderstood.isEmpty()) leaveRest(std::move(from), rest);
    }
    state.restoring.clear();
    for (std::vector<ListedState>* list : {&state.runs, &state.solutions})
        for (ListedState& each : *list) each.from = 0;
    // If it cannot be written, the next start does the same again.
    std::ignore = writeWholeFile(folder.stateFile(), toJson(state));
}

std::unique_ptr<SessionFolder> newestBrokenOff(QStringList& remarks)
{
    for (const QString& path : SessionFolder::all())
        if (SessionFolder::hasForeignLock(path) && !readSession(path).empty())
            remarks << tr("A session cannot be offered, because its file “lock” is not one that the program makes. "
                          "Remove that file, and the next start offers the session: %1")
                           .arg(QDir::toNativeSeparators(path));
    for (const auto& [path, left] : endedSessions()) {
        if (left.closed && left.restoring.isEmpty()) continue;
        std::unique_ptr<SessionFolder> folder = SessionFolder::take(path);
        if (!folder) continue;
        finishRestoring(*folder);
        SessionState state = readSession(path);
        if (state.closed) continue;
        if (state.newer) {
            remarks << tr("A session of a newer version of the program is left to that version: %1")
                           .arg(QDir::toNativeSeparators(path));
            continue;
        }
        if (!state.notUnderstood.isEmpty()) {
            remarks << folder->setStateAside(state.notUnderstood);
            state = readSession(path);
            if (!state.notUnderstood.isEmpty()) continue; // it could not be renamed
        }
        if (!state.empty()) return folder;
        SessionFolder::remove(std::move(folder));
    }
    return nullptr;
}

qint64 keepSessionsWithin(qint64 budget)
{
    qint64 bytes = 0;
    for (const QString& path : SessionFolder::all()) bytes += bytesIn(path);
    if (bytes <= budget) return bytes;
    QStringList closed, brokenOff; // the newest first
    for (const auto& [path, state] : endedSessions()) {
        if (!state.notUnderstood.isEmpty()) continue; // nobody knows what it is
        (state.closed || state.empty() ? closed : brokenOff) << path;
    }
    if (!brokenOff.isEmpty()) brokenOff.removeFirst();
    QStringList order = brokenOff + closed;
    while (bytes > budget && !order.isEmpty()) {
        std::unique_ptr<SessionFolder> folder = SessionFolder::take(order.takeLast());
        if (!folder) continue; // a window restores it
        bytes -= bytesIn(folder->path());
        SessionFolder::remove(std::move(folder));
    }
    return bytes;
}

void offerSession(QWidget& window, std::unique_ptr<SessionFolder> folder, const QStringList& remarks,
                  const std::function<void(std::unique_ptr<SessionFolder>)>& restore)
{
    const SessionState state = readSession(folder->path());
    auto* box = new QMessageBox(QMessageBox::Question, tr("The last session"),
                                tr("The last session ended without being closed."), QMessageBox::NoButton, &window);
    box->setObjectName(QStringLiteral("restoreSession"));
    QStringList lines{tr("It left: %1.").arg(describe(state)),
                      tr("Last kept: %1.").arg(QLocale().toString(state.written.toLocalTime(), QLocale::ShortFormat))};
    box->setInformativeText((lines + remarks).join(QLatin1Char('\n')));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QAbstractButton* take = box->addButton(tr("&Restore"), QMessageBox::AcceptRole);
    QAbstractButton* discard = box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box->addButton(tr("&Later"), QMessageBox::RejectRole);
    take->setToolTip(tr("Bring back the case and the results"));
    discard->setToolTip(tr("Delete what the session left"));
    later->setToolTip(tr("Leave it on the disk; the next start asks again, and File > Sessions has it"));
    box->setDefaultButton(qobject_cast<QPushButton*>(take));
    box->setEscapeButton(later);
    auto held = std::make_shared<std::unique_ptr<SessionFolder>>(std::move(folder));
    QObject::connect(box, &QMessageBox::buttonClicked, &window, [=](QAbstractButton* chosen) {
        if (chosen == take) restore(std::exchange(*held, nullptr));
        if (chosen == discard) SessionFolder::remove(std::exchange(*held, nullptr));
        held->reset();
    });
    box->open();
}

} // namespace touchdown
