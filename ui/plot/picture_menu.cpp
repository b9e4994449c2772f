// SPDX-License-Identifier: GPL-3.0-or-later
//
// The actions of every picture.
#include "ui/plot/picture_widget.h"

#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>

#include "ui/plot/plot_export.h"
#include "ui/style/save_dialog.h"
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

void chooseSavePicture(QWidget& shown)
{
    askAndSave(&shown, tr("Save picture"), pictureFilters(), QStringLiteral("pdf"),
               [&shown](const QString& path) { return savePicture(shown, path); });
}

void addPictureActions(QMenu& menu, QWidget& shown)
{
    const std::function<void(QIODevice&)> writeData = dynamic_cast<PagePart&>(shown).dataWriter();
    QWidget* part = &shown;
    menu.addAction(tr("&Copy picture"), part, [part] { copyPicture(*part); });
    menu.addAction(tr("&Save picture…"), part, [part] { chooseSavePicture(*part); });
    if (!writeData) return;
    const auto written = [writeData] {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writeData(buffer);
        return buffer.data();
    };
    menu.addAction(tr("Copy &data"), part,
                   [written] { QGuiApplication::clipboard()->setText(QString::fromUtf8(written())); });
    menu.addAction(tr("Save &data…"), part, [part, written] {
        askAndSave(part, tr("Save the data"), {tr("Comma-separated values (*.csv)")}, QStringLiteral("csv"),
                   [written](const QString& path) { return writeWholeFile(path, written()); });
    });
}

} // namespace touchdown
