// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of studies from files and samples and to files, and the question before an edited one is replaced.
#include "ui/studies/study_editor.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "core/formats/text_file.h"
#include "core/formats/toml_document.h"
#include "core/studies/study/study_head.h"
#include "ui/case/parameter_text.h"
#include "ui/style/changed_file_question.h"
#include "ui/style/save_dialog.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

/// The kind that the study's text names; empty if it names none.
QString kindIn(const QString& text)
{
    const TomlDocument toml = readStudyText(text.toStdString());
    const auto entry = std::ranges::find(toml.entries, "kind", &TomlEntry::key);
    const auto* kind = entry == toml.entries.end() ? nullptr : std::get_if<std::string>(&entry->value);
    return kind == nullptr ? QString() : QString::fromStdString(*kind);
}

/// The editor has no carriage returns.
QStringList differentLines(QString inFile, const QString& inWindow)
{
    const QStringList theirs = inFile.remove(u'\r').split(u'\n'), own = inWindow.split(u'\n');
    QStringList lines;
    for (const QString& line : theirs)
        if (!own.contains(line)) lines << StudyEditor::tr("in the file: %1").arg(line);
    for (const QString& line : own)
        if (!theirs.contains(line)) lines << StudyEditor::tr("in this window: %1").arg(line);
    return lines;
}

} // namespace

std::vector<StudyDraft> StudyEditor::unsaved() const
{
    std::vector<StudyDraft> all;
    for (const auto& [kind, draft] : drafts_) {
        StudyDraft now = draft;
        now.kind = kind;
        if (const auto typed = form_->typed(); typed && kind == this->kind())
            now.text = textWith(typed->first, typed->second);
        if (now.modified()) all.push_back(now);
    }
    return all;
}

void StudyEditor::openSample(const SampleStudy& sample)
{
    whenSettled(QString::fromStdString(sample.kind), [this, sample] {
        setKind(QString::fromStdString(sample.kind));
        drafts_[kind()].file.clear();
        replaceText(withoutLicence(sample.text));
        drafts_[kind()].saved = toText();
        replan();
        tabs_->setCurrentWidget(form_);
    });
}

void StudyEditor::vary(const std::string& key)
{
    const QString sweep = QStringLiteral("sweep");
    whenSettled(sweep, [this, sweep, key] {
        setKind(sweep);
        drafts_[sweep] = {};
        replaceText(QString::fromStdString(sweepTemplate(case_, key)));
        replan();
        tabs_->setCurrentWidget(form_);
    });
}

void StudyEditor::takeDefaults()
{
    whenSettled(kind(), [this] {
        drafts_[kind()] = {};
        replan();
    });
}

bool StudyEditor::restore(const StudyDraft& draft)
{
    if (kinds_->findData(draft.kind) < 0 || drafts_[draft.kind].modified()) return false;
    static_cast<StudyDraft&>(drafts_[draft.kind]) = draft;
    if (draft.kind != kind()) return true;
    setText(draft.text);
    replan();
    return true;
}

void StudyEditor::showTextOf(const std::string& kind, const std::string& text)
{
    const QString name = QString::fromStdString(kind), shown = QString::fromStdString(text);
    if (!text.empty() && drafts_[name].file.isEmpty()) restore({name, shown, shown, {}});
}

QString StudyEditor::open(const QString& path)
{
    const auto content = readTextFile(path.toStdString(), maximumStudyFileSize, FileContent::Text);
    if (const auto* problem = std::get_if<FileProblem>(&content))
        return QStringLiteral("%1: %2.").arg(QDir::toNativeSeparators(path), QString::fromStdString(problem->message));
    const std::string& bytes = std::get<std::string>(content);
    const QString text = QString::fromStdString(bytes);
    const QString named = kindIn(text);
    // A text without a kind, or with a wrong one, is of the chosen kind.
    const QString opened = kinds_->findData(named) < 0 ? kind() : named;
    whenSettled(opened, [this, opened, text, path, identity = identityOfBytes(bytes)] {
        setKind(opened);
        drafts_[opened].file = path;
        drafts_[opened].identity = identity;
        setText(text);
        drafts_[opened].saved = toText();
        replan();
        emit fileOpened(path);
    });
    return {};
}

bool StudyEditor::changedOutside(const StudyDraft& draft, const QString& file)
{
    if (draft.file.isEmpty() || QFileInfo(draft.file) != QFileInfo(file)) return false;
    const FileNow now = fileNow(file.toStdString(), draft.identity);
    return now == FileNow::Other || now == FileNow::Unreadable;
}

QString StudyEditor::save(const QString& kind, const QString& path)
{
    StudyDraft& draft = drafts_[kind];
    if (changedOutside(draft, path))
        return tr("%1 was changed by another program. It was not written over; save the study by itself.")
            .arg(QDir::toNativeSeparators(path));
    const QByteArray bytes = draft.text.toUtf8();
    if (QString problem = writeWholeFile(path, bytes); !problem.isEmpty()) return problem;
    draft.file = path;
    draft.identity = identityOfBytes(bytes.toStdString());
    draft.saved = draft.text;
    stale_ = true;
    replan();
    emit edited();
    return {};
}

void StudyEditor::whenSettled(const QString& kind, const std::function<void()>& next)
{
    form_->commitTyped();
    const StudyDraft& draft = drafts_[kind];
    if (!draft.modified()) return next();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                tr("The study \"%1\" has changed.").arg(titleOf(kind)),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window());
    box->setObjectName(QStringLiteral("unsavedStudy"));
    box->setInformativeText(tr("Do you want to save its text?"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QMessageBox::buttonClicked, this, [this, box, kind, next](QAbstractButton* button) {
        const auto chosen = box->standardButton(button);
        if (chosen == QMessageBox::Discard) next();
        if (chosen != QMessageBox::Save) return;
        if (const QString file = drafts_[kind].file; file.isEmpty())
            chooseSave(kind, next);
        else
            saveTo(kind, file, next);
    });
    box->open();
}

void StudyEditor::chooseSave(const QString& kind, const std::function<void()>& next)
{
    askAndSave(this, tr("Save the study"), {tr("Study (*.toml)")}, kind + QStringLiteral(".toml"),
               [this, kind, next](const QString& file) {
                   saveTo(kind, file, next);
                   return QString();
               });
}

void StudyEditor::saveTo(const QString& kind, const QString& file, const std::function<void()>& next)
{
    const StudyDraft& draft = drafts_[kind];
    if (changedOutside(draft, file)) return askAboutFile(kind, file, next);
    if (const QString problem = save(kind, file); !problem.isEmpty()) {
        emit failed(problem);
        return;
    }
    emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(file)));
    if (next) next();
}

void StudyEditor::askAboutFile(const QString& kind, const QString& file, const std::function<void()>& next)
{
    const StudyDraft& draft = drafts_[kind];
    const auto content = readTextFile(file.toStdString(), maximumStudyFileSize, FileContent::Text);
    const auto* bytes = std::get_if<std::string>(&content);
    ChangedFile question;
    question.sentence = changeOfFile(file, fileNow(file.toStdString(), draft.identity));
    if (bytes) {
        question.heading = tr("Lines that differ:");
        question.differences = differentLines(QString::fromStdString(*bytes), draft.text);
        question.writeOver = [this, kind, file, next, shown = identityOfBytes(*bytes)] {
            drafts_[kind].identity = shown; // it may change once more
            saveTo(kind, file, next);
        };
        question.reload = [this, kind, file] {
            // The person gives the text up, but only for one that can be read.
            const QString before = std::exchange(drafts_[kind].saved, drafts_[kind].text);
            const QString problem = open(file);
            if (problem.isEmpty()) return;
            drafts_[kind].saved = before;
            emit failed(problem);
        };
    } else {
        question.heading = tr("It cannot be opened:");
        question.differences << QString::fromStdString(std::get<FileProblem>(content).message);
    }
    question.saveAs = [this, kind, next] { chooseSave(kind, next); };
    askAboutChangedFile(*window(), question);
}

void StudyEditor::chooseOpen()
{
    auto* dialog = new QFileDialog(this, tr("Open a study"), {}, tr("Studies (*.toml);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        if (const QString problem = open(file); !problem.isEmpty()) emit failed(problem);
    });
    dialog->open();
}

QString StudyEditor::titleOf(const QString& kind) const { return kinds_->itemText(kinds_->findData(kind)); }

} // namespace touchdown
