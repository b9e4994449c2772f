// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/changed_file_question.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "core/formats/text_file.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr qsizetype mostDifferences = 10; // all of them are in the details

} // namespace

void askAboutChangedFile(QWidget& window, const ChangedFile& file)
{
    auto* box = new QMessageBox(QMessageBox::Warning, tr("The file has changed"), file.sentence, QMessageBox::NoButton,
                                &window);
    box->setObjectName(QStringLiteral("changedFile"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QStringList lines{file.heading};
    lines << file.differences.mid(0, mostDifferences);
    if (file.differences.size() > mostDifferences) {
        lines << tr("and %1 more").arg(file.differences.size() - mostDifferences);
        box->setDetailedText(file.differences.join(QLatin1Char('\n')));
    }
    box->setInformativeText(lines.join(QLatin1Char('\n')));
    const auto offer = [box](const QString& text, QMessageBox::ButtonRole role, const std::function<void()>& act) {
        QPushButton* button = box->addButton(text, role);
        button->setEnabled(act != nullptr);
        if (act)
            QObject::connect(box, &QMessageBox::buttonClicked, box, [button, act](QAbstractButton* clicked) {
                if (clicked == button) act();
            });
        return button;
    };
    offer(tr("&Write over it"), QMessageBox::DestructiveRole, file.writeOver);
    offer(tr("&Reload the file"), QMessageBox::AcceptRole, file.reload);
    offer(tr("Save &as…"), QMessageBox::AcceptRole, file.saveAs);
    QPushButton* cancel = offer(tr("Cancel"), QMessageBox::RejectRole, file.cancel);
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    box->open();
}

QString changeOfFile(const QString& file, FileNow now)
{
    const QString name = QFileInfo(file).fileName();
    switch (now) {
    case FileNow::Same: break;
    case FileNow::Other: return tr("%1 was changed by another program.").arg(name);
    case FileNow::Gone: return tr("%1 was deleted or renamed by another program. Save writes it again.").arg(name);
    case FileNow::Unreadable: {
        const QString why = QString::fromStdString(notRegularFile(file.toStdString()));
        return tr("%1 was changed by another program: it %2.").arg(name, why.isEmpty() ? tr("cannot be read") : why);
    }
    }
    return {};
}

} // namespace touchdown
