// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of the texts: opened, saved, and what happens if another program has changed one.
#include "ui/studies/study_editor.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "core/formats/text_file.h"
#include "core/formats/toml_document.h"
#include "core/studies/study/study_head.h"
#include "ui/style/changed_file_question.h"
#include "ui/style/save_dialog.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

/// The kind that the study's text names; empty if it names none.
QString kindIn(const QString& text)
{
    const TomlDocument toml = readToml(text.toStdString());
    const auto entry = std::ranges::find(toml.entries, "kind", &TomlEntry::key);
    const auto* kind = entry == toml.entries.end() ? nullptr : std::get_if<std::string>(&entry->value);
    return kind == nullptr ? QString() : QString::fromStdString(*kind);
}

} // namespace

QString StudyEditor::open(const QString& path)
{
    QFile file(path);
    if (const std::string problem = notRegularFile(path.toStdString()); !problem.empty())
        return tr("%1 %2.").arg(QDir::toNativeSeparators(path), QString::fromStdString(problem));
    if (!file.open(QIODevice::ReadOnly))
        return tr("%1 cannot be read: %2.").arg(QDir::toNativeSeparators(path), file.errorString());
    if (file.size() > static_cast<qint64>(maximumStudyFileSize))
        return tr("%1 is too large for a study file.").arg(QDir::toNativeSeparators(path));
    const QByteArray bytes = file.readAll();
    const QString text = QString::fromUtf8(bytes);
    setKind(kindIn(text)); // a text without a kind is of the chosen kind
    drafts_[kind()].file = path;
    drafts_[kind()].identity = identityOfBytes(bytes.toStdString());
    setText(text);
    replan();
    return {};
}

QString StudyEditor::save(const QString& path)
{
    const QByteArray bytes = toText().toUtf8();
    if (QString problem = writeWholeFile(path, bytes); !problem.isEmpty()) return problem;
    drafts_[kind()].file = path;
    drafts_[kind()].identity = identityOfBytes(bytes.toStdString());
    stale_ = true;
    replan();
    return {};
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

void StudyEditor::chooseSave()
{
    askAndSave(this, tr("Save the study"), {tr("Study (*.toml)")}, kind() + QStringLiteral(".toml"),
               [this](const QString& file) {
                   saveTo(file);
                   return QString();
               });
}

void StudyEditor::saveTo(const QString& file)
{
    const Draft& draft = drafts_[kind()];
    if (!draft.file.isEmpty() && QFileInfo(draft.file) == QFileInfo(file)) {
        const FileNow now = fileNow(file.toStdString(), draft.identity);
        if (now == FileNow::Other || now == FileNow::Unreadable) return askAboutFile();
    }
    if (const QString problem = save(file); !problem.isEmpty())
        emit failed(problem);
    else
        emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(file)));
}

void StudyEditor::askAboutFile()
{
    const QString file = drafts_[kind()].file;
    const auto content = readTextFile(file.toStdString(), maximumStudyFileSize);
    const auto* text = std::get_if<std::string>(&content);
    const std::string shown = text ? *text : std::string();
    const QStringList theirs = QString::fromStdString(shown).split(u'\n'), own = toText().split(u'\n');
    ChangedFile question;
    question.sentence = changeOfFile(file, fileNow(file.toStdString(), drafts_[kind()].identity));
    question.heading = tr("Lines that differ:");
    for (const QString& line : theirs)
        if (!own.contains(line)) question.differences << tr("in the file: %1").arg(line);
    for (const QString& line : own)
        if (!theirs.contains(line)) question.differences << tr("in this window: %1").arg(line);
    question.writeOver = [this, file, shown] {
        drafts_[kind()].identity = identityOfBytes(shown); // it may have changed once more
        saveTo(file);
    };
    if (text)
        question.reload = [this, file] {
            if (const QString problem = open(file); !problem.isEmpty()) emit failed(problem);
        };
    question.saveAs = [this] { chooseSave(); };
    askAboutChangedFile(*window(), question);
}

} // namespace touchdown
