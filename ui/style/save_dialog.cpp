// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/save_dialog.h"

#include <algorithm>

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace touchdown {

QFileDialog* openSaveDialog(QWidget* parent, const QString& title, const QStringList& filters,
                            const QString& suggestion)
{
    auto* dialog = new QFileDialog(parent, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(filters);
    const auto endingOf = [](const QString& filter) {
        return filter.section(QLatin1String("*."), 1).section(u')', 0, 0);
    };
    const bool named = suggestion.contains(u'.') || suggestion.contains(u'/');
    const QString ending = named ? QFileInfo(suggestion).suffix() : suggestion;
    const bool offered =
        std::ranges::any_of(filters, [&](const QString& filter) { return endingOf(filter) == ending; });
    dialog->setDefaultSuffix(offered ? ending : endingOf(filters.front()));
    if (named) dialog->selectFile(suggestion);
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog,
                     [=](const QString& filter) { dialog->setDefaultSuffix(endingOf(filter)); });
    dialog->open();
    return dialog;
}

void askAndSave(QWidget* parent, const QString& title, const QStringList& filters, const QString& suggestion,
                const std::function<QString(const QString&)>& save)
{
    const QFileDialog* dialog = openSaveDialog(parent, title, filters, suggestion);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, [parent, title, save](const QString& path) {
        const QString problem = save(path);
        if (problem.isEmpty()) return;
        auto* box = new QMessageBox(QMessageBox::Warning, title, problem, QMessageBox::Ok, parent);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
}

QStringList pictureFilters()
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("touchdown::SaveDialog", text); };
    return {tr("Portable document (*.pdf)"), tr("Scalable vector graphics (*.svg)"), tr("PNG picture (*.png)")};
}

} // namespace touchdown
