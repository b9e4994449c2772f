// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a case is saved, and what happens if another program has changed its file.
#include "ui/case/case_files.h"

#include <system_error>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "ui/case/parameter_text.h"
#include "ui/style/changed_file_question.h"
#include "ui/style/save_dialog.h"

namespace touchdown {

namespace {

std::filesystem::path placeOf(const QString& file) { return file.toStdString(); }

bool isOneFile(const QString& one, const QString& other)
{
    std::error_code none;
    return one == other || std::filesystem::equivalent(placeOf(one), placeOf(other), none);
}

} // namespace

void CaseFiles::save()
{
    emit aboutToUse();
    if (file_.isEmpty())
        saveAs();
    else
        saveTo(file_);
}

void CaseFiles::saveThen(const std::function<void()>& next)
{
    afterSave_ = next;
    save();
}

void CaseFiles::saveAs()
{
    emit aboutToUse();
    const QFileDialog* dialog =
        openSaveDialog(&window_, tr("Save the case"), {tr("Case files (*.toml)")},
                       file_.isEmpty() ? QFileInfo(shortName()).completeBaseName() + QStringLiteral(".toml") : file_);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { saveTo(file); });
    connect(dialog, &QDialog::rejected, this, [this] { afterSave_ = nullptr; });
}

void CaseFiles::saveTo(const QString& file)
{
    if (changedOutside(file) && edits_.reasonNotToRun().isEmpty())
        askAboutFile();
    else
        writeAndTell(file);
}

void CaseFiles::writeAndTell(const QString& file)
{
    const std::function<void()> next = std::exchange(afterSave_, nullptr);
    if (const QString problem = writeOver(file); !problem.isEmpty())
        showProblems(tr("The case was not saved."), {problem});
    else if (next)
        next();
}

QString CaseFiles::write(const QString& file)
{
    if (!changedOutside(file)) return writeOver(file);
    return tr("%1 It was not written over; save the case by itself.").arg(changeOfFile(file_, watched_->now()));
}

QString CaseFiles::writeOver(const QString& file)
{
    if (const QString reason = edits_.reasonNotToRun(); !reason.isEmpty()) return reason;
    const std::filesystem::path folder = placeOf(QFileInfo(file).absolutePath());
    const std::string text = updateCaseText(text_, edits_.value(), folder);
    const std::string problem = writeCaseFile(placeOf(file), text);
    if (!problem.empty()) return QString::fromStdString(problem);
    file_ = QFileInfo(file).absoluteFilePath();
    sample_.clear();
    imported_.clear();
    origin_ = file_;
    text_ = text;
    folder_ = folder;
    saved_ = edits_.value();
    watched_->expect(file_, identityOfBytes(text_));
    edits_.undoStack().setClean();
    remember(file_);
    emit saved();
    return {};
}

bool CaseFiles::changedOutside(const QString& file) const
{
    const FileNow now = watched_->now();
    return (now == FileNow::Other || now == FileNow::Unreadable) && isOneFile(file, file_);
}

void CaseFiles::watch(const CaseDocument& document)
{
    watched_->expect(file_, identityOfBytes(text_));
    named_.clear();
    for (const std::filesystem::path& path : document.inputs()) {
        const QString file = QFileInfo(QString::fromStdString(path.string())).absoluteFilePath();
        const std::optional<FileIdentity> identity = identityOf(path);
        if (file_.isEmpty() || !identity || isOneFile(file, file_)) continue;
        named_.push_back(std::make_unique<WatchedFile>(window_));
        named_.back()->expect(file, *identity);
        connect(named_.back().get(), &WatchedFile::changed, this, &CaseFiles::tellChange);
    }
    tellChange(); // clears messages about the previous files
}

void CaseFiles::tellChange()
{
    const FileNow now = watched_->now();
    QString sentence = changeOfFile(file_, now);
    bool valid = now == FileNow::Same;
    if (now == FileNow::Other) {
        const CaseDocument document = readNow(file_);
        valid = document.valid() || !document.outsideFiles.empty();
        if (!valid) sentence += tr(" It cannot be opened now: %1").arg(textsOf(document.problems).front());
    }
    for (const std::unique_ptr<WatchedFile>& named : named_) {
        const FileNow then = named->now();
        if (!sentence.isEmpty() || then == FileNow::Same) continue;
        const bool surface =
            placeOf(named->path()).filename() == placeOf(QString::fromStdString(saved_.diskSurface.file)).filename();
        valid = then == FileNow::Other;
        const QString what = valid                   ? tr("was changed by another program")
                             : then == FileNow::Gone ? tr("was deleted or renamed by another program")
                                                     : tr("can no longer be read");
        const QString next = surface ? valid ? tr("The next run reads it as it is now.") : tr("Runs need it.")
                             : valid ? tr("Runs use it as it was read, until the case is reloaded.")
                                     : tr("Runs use it as it was read.");
        sentence = tr("%1, which %2 names, %3. %4").arg(QFileInfo(named->path()).fileName(), shortName(), what, next);
    }
    emit fileChanged(sentence, valid);
}

void CaseFiles::askAboutFile()
{
    const std::optional<FileIdentity> shown = identityOf(placeOf(file_));
    const CaseDocument document = readNow(file_);
    ChangedFile question;
    question.sentence = changeOfFile(file_, watched_->now());
    if (document.valid()) {
        question.differences = caseDifference(document.value, edits_.value());
        if (document.value.title != edits_.value().title)
            question.differences.prepend(
                tr("title “%1” → “%2”")
                    .arg(QString::fromStdString(document.value.title), QString::fromStdString(edits_.value().title)));
        question.heading = question.differences.isEmpty()
                               ? tr("The values are the same as in this window. Comments or other texts differ.")
                               : tr("Differences, in the file → in this window:");
    } else {
        question.heading = tr("It cannot be opened:");
        question.differences = textsOf(document.problems);
    }
    question.writeOver = [this, shown] {
        // It may have changed once more while the question was open.
        const bool asShown = shown ? fileNow(placeOf(file_), *shown) == FileNow::Same : !identityOf(placeOf(file_));
        asShown ? writeAndTell(file_) : saveTo(file_);
    };
    if (document.valid() || !document.outsideFiles.empty()) question.reload = [this] { reload(); };
    question.saveAs = [this] { saveAs(); };
    question.cancel = [this] { afterSave_ = nullptr; };
    askAboutChangedFile(window_, question);
}

void CaseFiles::reload()
{
    afterSave_ = nullptr;
    const std::optional<CaseDocument> document = read(file_, [this] { reload(); });
    if (!document) return;
    text_ = document->text;
    folder_ = document->folder;
    saved_ = document->value;
    watch(*document);
    edits_.reopen(saved_, tr("reload %1").arg(shortName()));
    edits_.undoStack().setClean();
    emit reloaded(lastingWarnings(*document));
}

} // namespace touchdown
