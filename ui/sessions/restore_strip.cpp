// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/restore_strip.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>

#include "ui/calculation/progress_strip.h"
#include "ui/sessions/session.h"
#include "ui/style/message_strip.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr qsizetype mostRefusals = 3; // in the message; more are in a box

void tell(MessageStrip& messages, QWidget& window, const QString& what, const QStringList& problems, bool stopped)
{
    const QString rest = tr("The rest stays in File, Sessions, Restore.");
    if (problems.isEmpty() && !stopped)
        return messages.show(MessageStrip::Kind::Success, tr("Restored: %1.").arg(what));
    if (problems.isEmpty())
        return messages.show(MessageStrip::Kind::Information, tr("Restoring was stopped.") + u' ' + rest);
    if (problems.size() <= mostRefusals)
        return messages.show(MessageStrip::Kind::Warning, problems.join(QLatin1Char('\n')));
    const QString told = tr("%1 results were not restored.").arg(problems.size()) + u' ' + rest;
    messages.show(MessageStrip::Kind::Warning, told);
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Restore"), told, QMessageBox::Close, &window);
    box->setObjectName(QStringLiteral("notRestored"));
    box->setDetailedText(problems.join(QLatin1Char('\n')));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace

QWidget* restoreStrip(Session& session, MessageStrip& messages, QWidget& window)
{
    auto* strip = new QWidget(&window);
    strip->setObjectName(QStringLiteral("restoring"));
    SessionReader& reader = session.reader();
    auto* stop = new QPushButton(tr("Stop"), strip);
    stop->setAccessibleName(tr("Stop restoring the session"));
    stop->setToolTip(tr("What is not restored yet stays in File, Sessions, Restore"));
    auto* row = new QHBoxLayout(strip);
    row->setContentsMargins(0, 0, 8, 0);
    row->addWidget(new ProgressStrip(reader, tr("session that is restored"), tr("Restoring"), strip), 1);
    row->addWidget(stop);
    strip->hide();
    QObject::connect(stop, &QPushButton::clicked, &reader, &SessionReader::stop);
    QObject::connect(&reader, &SessionReader::stateChanged, strip,
                     [strip, &reader] { strip->setVisible(reader.active()); });
    QObject::connect(&session, &Session::restored, strip,
                     [&](const QString& what, const QStringList& problems, bool stopped) {
                         tell(messages, window, what, problems, stopped);
                     });
    return strip;
}

} // namespace touchdown
