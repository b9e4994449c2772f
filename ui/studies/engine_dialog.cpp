// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/engine_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>

namespace touchdown {

namespace {

constexpr int standardParts = 8, mostParts = 10000, mostThreads = 256;

/// The command line, which each job runs: beside this program, or in PATH.
QString commandLine()
{
    const QString name = QStringLiteral("touchdown");
    const QString beside = QDir(QCoreApplication::applicationDirPath()).filePath(name);
    return QFileInfo(beside).isExecutable() ? beside : QStandardPaths::findExecutable(name);
}

} // namespace

EngineDialog::EngineDialog(const QString& folder, QWidget* parent)
    : QDialog(parent),
      folder_(new QLineEdit(this)),
      options_(new QLineEdit(this)),
      parts_(new QSpinBox(this)),
      threads_(new QSpinBox(this))
{
    setWindowTitle(tr("Perform on a cluster"));
    setAttribute(Qt::WA_DeleteOnClose);
    const QString suggested =
        folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : folder;
    folder_->setText(QDir::toNativeSeparators(QDir(suggested).filePath(QStringLiteral("cluster"))));
    folder_->setMinimumWidth(fontMetrics().averageCharWidth() * 48);
    folder_->setAccessibleName(tr("Folder"));
    options_->setPlaceholderText(tr("such as --partition=long --time=2:00:00"));
    options_->setAccessibleName(tr("Options of sbatch"));
    parts_->setRange(1, mostParts);
    parts_->setValue(standardParts);
    parts_->setAccessibleName(tr("Parts"));
    threads_->setRange(1, mostThreads);
    threads_->setAccessibleName(tr("Threads of each part"));
    auto* choose = new QPushButton(tr("Choose…"), this);
    choose->setAutoDefault(false);
    auto* place = new QHBoxLayout;
    place->addWidget(folder_, 1);
    place->addWidget(choose);
    auto* note =
        new QLabel(tr("Each part is a job of Slurm and should take minutes. All computers must see the folder. "
                      "Stopping leaves the jobs; performing again with the same folder takes them up."),
                   this);
    const QString program = commandLine();
    if (program.isEmpty())
        note->setText(tr("The program touchdown, which each job runs, is neither beside this one nor in PATH."));
    note->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Submit"));
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("Folder"), place);
    layout->addRow(tr("&Parts"), parts_);
    layout->addRow(tr("&Threads of each part"), threads_);
    layout->addRow(tr("&Options of sbatch"), options_);
    layout->addRow(note);
    layout->addRow(buttons);
    const auto check = [this, buttons, program] {
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!program.isEmpty() && QDir::isAbsolutePath(folder_->text()));
    };
    connect(folder_, &QLineEdit::textChanged, this, check);
    connect(choose, &QPushButton::clicked, this, &EngineDialog::chooseFolder);
    check();
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this, program] {
        emit taken({.kind = EngineKind::Slurm,
                    .folder = QDir::fromNativeSeparators(folder_->text()).toStdString(),
                    .program = program.toStdString(),
                    .parts = std::size_t(parts_->value()),
                    .jobs = threads_->value(),
                    .options = options_->text().toStdString(),
                    .submit = {}});
        accept();
    });
}

void EngineDialog::chooseFolder()
{
    auto* dialog = new QFileDialog(this, tr("Folder of the study"), folder_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& folder) { folder_->setText(QDir::toNativeSeparators(folder)); });
    dialog->open();
}

} // namespace touchdown
