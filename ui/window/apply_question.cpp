// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/apply_question.h"

#include <QMessageBox>
#include <QPushButton>

#include "core/studies/study/study.h"
#include "ui/case/parameter_text.h"
#include "ui/style/foreign_text.h"
#include "ui/style/loss_question.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr qsizetype mostShown = 10; // changes; all of them are in the details

} // namespace

void askToApply(QWidget& window, const Case& open, const Case& found, bool isOther, const QString& title,
                const std::function<void()>& apply)
{
    const QStringList changes = caseDifference(open, found);
    auto* box = new QMessageBox(open == found ? QMessageBox::Information : QMessageBox::Question,
                                tr("Apply to the case"), {}, QMessageBox::Cancel, &window);
    box->setObjectName(QStringLiteral("applyQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    if (open == found) {
        box->setText(tr("The open case already has the values that the study found."));
        box->setStandardButtons(QMessageBox::Close);
        return box->open();
    }
    box->setText(isOther ? tr("“%1” studied another case. Replace the open case, “%2”, by the case found?")
                               .arg(title, QString::fromStdString(open.title))
                         : tr("Change the open case as “%1” found?").arg(title));
    QStringList shown = changes.mid(0, mostShown);
    if (changes.size() > mostShown) {
        shown << tr("and %1 more").arg(changes.size() - mostShown);
        box->setDetailedText(changes.join(QLatin1Char('\n')));
    }
    shown << (isOther ? tr("The case found has no file: saving asks for a name.") : tr("Undo takes it back."));
    box->setInformativeText(shown.join(QLatin1Char('\n')));
    QPushButton* yes = box->addButton(isOther ? tr("Replace") : tr("Apply"), QMessageBox::AcceptRole);
    box->setDefaultButton(isOther ? qobject_cast<QPushButton*>(box->button(QMessageBox::Cancel)) : yes);
    QObject::connect(yes, &QPushButton::clicked, &window, apply);
    box->open();
}

void askToReplaceReport(QWidget& window, const StudyReport& report, const std::function<void()>& replace)
{
    const QString title = inOneLine(QString::fromStdString(report.title));
    askBeforeLoss(window,
                  {QStringLiteral("unsavedReport"), tr("Replace a report"),
                   title.isEmpty() ? tr("The study under way has a report that is not saved.")
                                   : tr("The report “%1” is not saved.").arg(title),
                   tr("There is one report of each kind of study: the new one would take its place."), tr("&Replace")},
                  replace);
}

} // namespace touchdown
