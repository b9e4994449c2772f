// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/loss_question.h"

#include <QMessageBox>
#include <QPushButton>

namespace touchdown {

void withdrawQuestion(const QWidget& window, const QString& name)
{
    for (auto* box : window.findChildren<QMessageBox*>(name)) {
        box->setObjectName({}); // it is deleted later
        box->close();
    }
}

void askBeforeLoss(QWidget& window, const Loss& loss, const std::function<void()>& goOn)
{
    withdrawQuestion(window, loss.name);
    auto* box = new QMessageBox(QMessageBox::Question, loss.title, loss.what, QMessageBox::Cancel, &window);
    box->setObjectName(loss.name);
    box->setInformativeText(loss.why);
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* yes = box->addButton(loss.button, QMessageBox::DestructiveRole);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setEscapeButton(QMessageBox::Cancel);
    QObject::connect(box, &QMessageBox::buttonClicked, &window, [yes, goOn](const QAbstractButton* chosen) {
        if (chosen == yes) goOn();
    });
    box->open();
}

} // namespace touchdown
