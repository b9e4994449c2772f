// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session_offer.h"

#include <utility>

#include <QAbstractButton>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "ui/style/translate.h"
#include "ui/window/session_state.h"

namespace touchdown {

std::unique_ptr<SessionFolder> newestBrokenOff()
{
    for (const QString& path : SessionFolder::ended()) {
        std::unique_ptr<SessionFolder> folder = SessionFolder::take(path);
        if (!folder) continue;
        const std::optional<SessionState> state = readSession(path);
        if (state && state->closed) continue;
        if (state && !(state->empty() && studiesIn(path).isEmpty())) return folder;
        SessionFolder::remove(std::move(folder));
    }
    return nullptr;
}

void offerSession(QWidget& window, std::unique_ptr<SessionFolder> folder,
                  const std::function<void(std::unique_ptr<SessionFolder>)>& restore)
{
    const SessionState state = readSession(folder->path()).value_or(SessionState{});
    auto* box = new QMessageBox(QMessageBox::Question, tr("The last session"),
                                tr("The last session ended without being closed."), QMessageBox::NoButton, &window);
    box->setObjectName(QStringLiteral("restoreSession"));
    box->setInformativeText(tr("It left: %1.\nLast kept: %2.")
                                .arg(describe(state, studiesIn(folder->path())),
                                     QLocale().toString(state.written.toLocalTime(), QLocale::ShortFormat)));
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
