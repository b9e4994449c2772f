// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of studies from files and samples and to files, and the question before an edited one is replaced.
#include "ui/studies/study_editor.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "core/formats/toml_document.h"
#include "core/studies/study/study_head.h"
#include "ui/case/parameter_text.h"
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

std::vector<StudyDraft> StudyEditor::unsaved()
{
    form_->commitTyped();
    std::vector<StudyDraft> all;
    for (const auto& [kind, draft] : drafts_)
        if (draft.modified()) all.emplace_back(draft).kind = kind;
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

QString StudyEditor::open(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tr("%1 cannot be read: %2.").arg(QDir::toNativeSeparators(path), file.errorString());
    if (file.size() > static_cast<qint64>(maximumStudyFileSize))
        return tr("%1 is too large for a study file.").arg(QDir::toNativeSeparators(path));
    const QString text = QString::fromUtf8(file.readAll());
    const QString named = kindIn(text);
    // A text without a kind, or with a wrong one, is of the chosen kind.
    const QString opened = kinds_->findData(named) < 0 ? kind() : named;
    whenSettled(opened, [this, opened, text, path] {
        setKind(opened);
        drafts_[opened].file = path;
        setText(text);
        drafts_[opened].saved = toText();
        replan();
        emit fileOpened(path);
    });
    return {};
}

QString StudyEditor::save(const QString& kind, const QString& path)
{
    StudyDraft& draft = drafts_[kind];
    if (QString problem = writeWholeFile(path, draft.text.toUtf8()); !problem.isEmpty()) return problem;
    draft.file = path;
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
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("Do you want to save its text?"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QMessageBox::buttonClicked, this, [this, box, kind, next](QAbstractButton* button) {
        const auto chosen = box->standardButton(button);
        if (chosen == QMessageBox::Discard) next();
        if (chosen == QMessageBox::Save) saveThen(kind, next);
    });
    box->open();
}

void StudyEditor::saveThen(const QString& kind, const std::function<void()>& next)
{
    const QString file = drafts_[kind].file;
    const auto write = [this, kind, next](const QString& path) {
        const QString problem = save(kind, path);
        if (!problem.isEmpty()) return problem;
        emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
        if (next) next();
        return problem;
    };
    if (!next || file.isEmpty())
        askAndSave(this, tr("Save the study"), {tr("Study (*.toml)")}, kind + QStringLiteral(".toml"), write);
    else if (const QString problem = write(file); !problem.isEmpty())
        emit failed(problem);
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
