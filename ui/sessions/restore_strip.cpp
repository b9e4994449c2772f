// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/restore_strip.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>

#include "ui/calculation/progress_strip.h"
#include "ui/sessions/session.h"
#include "ui/style/message_strip.h"

namespace touchdown {

namespace {

constexpr qsizetype mostRefusals = 3; // in the message; more are in a box

} // namespace

RestoreStrip::RestoreStrip(Session& session, MessageStrip& messages, QWidget& window)
    : QWidget(&window), messages_(messages), window_(window)
{
    setObjectName(QStringLiteral("restoring"));
    SessionReader& reader = session.reader();
    auto* stop = new QPushButton(tr("Stop"), this);
    stop->setAccessibleName(tr("Stop restoring the session"));
    stop->setToolTip(tr("What is not restored yet stays in File, Sessions, Restore"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    row->addWidget(new ProgressStrip(reader, tr("session that is restored"), tr("Restoring"), this), 1);
    row->addWidget(stop);
    hide();
    connect(stop, &QPushButton::clicked, &reader, &SessionReader::stop);
    connect(&reader, &SessionReader::stateChanged, this, [this, &reader] { setVisible(reader.active()); });
    connect(&session, &Session::restored, this, &RestoreStrip::tell);
}

void RestoreStrip::tell(const QString& what, const QStringList& problems, bool stopped)
{
    const QString rest = tr("The rest stays in File, Sessions, Restore.");
    if (problems.isEmpty() && !stopped)
        return messages_.show(MessageStrip::Kind::Success, tr("Restored: %1.").arg(what));
    if (problems.isEmpty())
        return messages_.show(MessageStrip::Kind::Information, tr("Restoring was stopped.") + u' ' + rest);
    if (problems.size() <= mostRefusals)
        return messages_.show(MessageStrip::Kind::Warning, problems.join(QLatin1Char('\n')));
    const QString told = tr("%1 results were not restored.").arg(problems.size()) + u' ' + rest;
    messages_.show(MessageStrip::Kind::Warning, told);
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Restore"), told, QMessageBox::Close, &window_);
    box->setObjectName(QStringLiteral("notRestored"));
    box->setDetailedText(problems.join(QLatin1Char('\n')));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace touchdown
