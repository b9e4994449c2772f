// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recording.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"

namespace touchdown {

Recording::Recording(QAction& action, RunWindow& runs, QWidget& window)
    : QObject(&window), action_(action), runs_(runs), window_(window)
{
    connect(&runs, &RunWindow::ended, this, [this](int number) {
        const RunRecord* run = runs_.runs().find(number);
        if (run && !file_.isEmpty() && run->file == file_) expect(file_);
    });
}

void Recording::choose(bool on)
{
    if (!on) return expect({});
    auto* dialog = new QFileDialog(&window_, tr("Record the next runs to"), {}, tr("HDF5 (*.h5)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("h5"));
    connect(dialog, &QFileDialog::fileSelected, this, &Recording::expect);
    connect(dialog, &QDialog::finished, this, [this] { action_.setChecked(!file_.isEmpty()); });
    dialog->open();
}

void Recording::expect(const QString& file)
{
    file_ = file;
    identity_ = file.isEmpty() ? std::nullopt : identityOf(file.toStdString());
}

void Recording::whenFree(const std::function<void()>& next)
{
    const RunRecord* underWay = runs_.runUnderWay();
    const bool isOurs = underWay && underWay->file == file_;
    const FileNow now = fileNow(file_.toStdString(), identity_.value_or(FileIdentity{}));
    if (file_.isEmpty() || isOurs || now == FileNow::Gone || (identity_ && now == FileNow::Same)) return next();
    auto* box = new QMessageBox(
        QMessageBox::Warning, tr("The file has changed"),
        tr("%1, to which runs are recorded, was changed by another program.").arg(QFileInfo(file_).fileName()),
        QMessageBox::Cancel, &window_);
    box->setObjectName(QStringLiteral("recordingChanged"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* over = box->addButton(tr("&Write over it"), QMessageBox::DestructiveRole);
    const QPushButton* other = box->addButton(tr("&Another file…"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(over, &QPushButton::clicked, this, [this, next] {
        expect(file_);
        next();
    });
    connect(other, &QPushButton::clicked, this, [this] { choose(true); });
    box->open();
}

} // namespace touchdown
