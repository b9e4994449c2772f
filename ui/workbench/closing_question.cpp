// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/closing_question.h"

#include <QAbstractButton>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_window.h"

namespace touchdown {

namespace {

constexpr auto folderKey = "files/saveAllFolder";

} // namespace

ClosingQuestion::ClosingQuestion(Workbench& bench, QWidget& window) : QObject(&window), bench_(bench), window_(window)
{}

bool ClosingQuestion::nothingLost(bool kept)
{
    const UnsavedWork work = unsavedWork(bench_);
    if (work.empty() || (kept && work.onlyChangesOfSample())) return true;
    if (asking_ && asking_->isVisible()) {
        asking_->raise();
        asking_->activateWindow();
    } else {
        closes_ = true;
        leave_ = [this] { emit answered(); };
        ask(work, kept);
    }
    return false;
}

bool ClosingQuestion::asksBeforeAnotherCase(const std::function<void()>& next)
{
    const UnsavedWork work = workOfCase(bench_);
    if (!work.anyResult() && work.underWay.isEmpty()) return false;
    if (asking_) asking_->close(); // the case that was to be opened before
    closes_ = false;
    leave_ = next;
    ask(work, false);
    return true;
}

UnsavedWork ClosingQuestion::work() const { return closes_ ? unsavedWork(bench_) : workOfCase(bench_); }

void ClosingQuestion::ask(const UnsavedWork& work, bool kept)
{
    auto* box = new QMessageBox(QMessageBox::Question, closes_ ? tr("Close Touchdown") : tr("Open another case"),
                                tr("Not everything is saved."), QMessageBox::NoButton, &window_);
    box->setObjectName(closes_ ? QStringLiteral("closing") : QStringLiteral("anotherCase"));
    QStringList text{closes_ ? tr("Closing would stop or leave behind:") : tr("Another case would stop or remove:")};
    for (const QString& line : linesOf(work, bench_)) text += QStringLiteral("• ") + line;
    if (kept)
        text += QLatin1Char('\n') +
                tr("Without saving, it stays on this computer for a while: File, Sessions brings it back.");
    box->setInformativeText(text.join(QLatin1Char('\n')));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* save =
        box->addButton(closes_ ? tr("&Save all and close") : tr("&Save all and open"), QMessageBox::AcceptRole);
    const QPushButton* leave = box->addButton(closes_ ? tr("&Close without saving") : tr("&Open without saving"),
                                              QMessageBox::DestructiveRole);
    QPushButton* stay = box->addButton(tr("&Go on working"), QMessageBox::RejectRole);
    box->setDefaultButton(save);
    box->setEscapeButton(stay);
    connect(box, &QMessageBox::buttonClicked, this, [=, this](const QAbstractButton* chosen) {
        if (chosen == save) saveAll();
        if (chosen == leave) leave_();
    });
    asking_ = box;
    box->open();
}

void ClosingQuestion::saveAll()
{
    // What is under way ends with what it has.
    if (closes_) {
        bench_.runWindow().controller().stopAndWait();
        bench_.studies().controller().stopAndWait();
    }
    bench_.film().controller().stopAndWait();
    bench_.film().view()->stopAndWait();
    const UnsavedWork left = work();
    // What is in the file is asked for before the folder of the results.
    if (!left.editedCase.isEmpty() && bench_.files().changedOutside())
        return bench_.files().saveThen([this] { saveAll(); });
    if (!left.anyResult() && left.drafts.empty()) {
        if (left.editedCase.isEmpty())
            leave_();
        else
            bench_.files().saveThen(leave_);
        return;
    }
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    QString folder = QSettings().value(folderKey, documents).toString();
    if (!QDir(folder).exists()) folder = QDir::homePath(); // the dialog takes none that is not there
    auto* dialog = new QFileDialog(&window_, tr("Save all to the folder"), folder);
    dialog->setObjectName(QStringLiteral("saveAllFolder"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setLabelText(QFileDialog::Accept, tr("&Save all"));
    connect(dialog, &QFileDialog::fileSelected, this, &ClosingQuestion::saveInto);
    asking_ = dialog;
    dialog->open();
}

void ClosingQuestion::saveInto(const QString& folder)
{
    QSettings().setValue(folderKey, folder);
    const QStringList problems = saveWork(work(), bench_, QDir(folder));
    if (problems.isEmpty()) return leave_();
    auto* box = new QMessageBox(QMessageBox::Warning, closes_ ? tr("Close Touchdown") : tr("Open another case"),
                                closes_ ? tr("Not all could be saved, so the window stays open.")
                                        : tr("Not all could be saved, so the case stays open."),
                                QMessageBox::Close, &window_);
    box->setObjectName(QStringLiteral("notSaved"));
    box->setInformativeText(problems.mid(0, 8).join(QLatin1Char('\n')));
    if (problems.size() > 8) box->setDetailedText(problems.join(QLatin1Char('\n')));
    box->setAttribute(Qt::WA_DeleteOnClose);
    asking_ = box;
    box->open();
}

} // namespace touchdown
