// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/case_files.h"

#include <QAbstractButton>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QSettings>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"
#include "core/formats/quotation.h"
#include "core/studies/study_plan.h"
#include "ui/style/save_dialog.h"

namespace touchdown {

namespace {

constexpr int mostRecent = 10;
constexpr auto recentKey = "files/recent";

std::filesystem::path pathOf(const QString& file) { return file.toStdString(); }

QStringList textsOf(const std::vector<InputProblem>& problems)
{
    QStringList texts;
    for (const InputProblem& problem : problems) texts << QString::fromStdString(problem.text());
    return texts;
}

/// Name of the archive or of the folder; the file itself is always rail.dat.
QString importedName(const QFileInfo& file)
{
    if (file.isDir()) return file.fileName();
    return file.suffix().compare(QLatin1String("cml"), Qt::CaseInsensitive) == 0 ? file.completeBaseName()
                                                                                 : file.dir().dirName();
}

} // namespace

CaseFiles::CaseFiles(CaseEdits& edits, QWidget& window) : QObject(&window), edits_(edits), window_(window) {}

void CaseFiles::take(const CaseDocument& document, const QString& file)
{
    const bool import = !file.isEmpty() && isCmlPath(pathOf(file));
    file_ = import ? QString() : file;
    sample_.clear();
    imported_ = import ? importedName(QFileInfo(file)) : QString();
    if (file.isEmpty())
        for (const SampleCase& sample : sampleCases())
            if (sample.name == document.name) sample_ = QString::fromStdString(sample.name);
    text_ = document.text;
    folder_ = document.folder;
    saved_ = document.value;
    edits_.open(document.value);
    if (!file.isEmpty()) remember(file);
    emit opened();
    // A warning of a combination of values stands at its field.
    std::vector<InputProblem> lasting = document.warnings;
    std::erase_if(lasting, [](const InputProblem& warning) { return warning.kind == ProblemKind::Combination; });
    const QStringList warnings = textsOf(lasting) + textsOf(document.unused);
    if (import)
        emit imported(file, warnings);
    else if (!warnings.isEmpty())
        emit warned(warnings);
}

bool CaseFiles::openNow(const QString& fileOrSample)
{
    const QString key = QFileInfo(fileOrSample).absoluteFilePath();
    const CaseDocument document =
        openCase(fileOrSample.toStdString(), allowed_.contains(key) ? OutsidePaths::Allowed : OutsidePaths::Refused);
    if (!document.outsideFiles.empty()) {
        askForOutsideFiles(fileOrSample, document.outsideFiles);
        return false;
    }
    if (!document.valid()) {
        showProblems(tr("%1 could not be opened.").arg(QFileInfo(fileOrSample).fileName()), textsOf(document.problems));
        return false;
    }
    const QFileInfo info(fileOrSample);
    take(document, info.exists() ? info.absoluteFilePath() : QString());
    return true;
}

void CaseFiles::askForOutsideFiles(const QString& file, const std::vector<std::string>& outside)
{
    QStringList names;
    for (const std::string& name : outside) names << QString::fromStdString(inQuotes(name));
    auto* box = new QMessageBox(QMessageBox::Question, tr("Files outside the folder"),
                                tr("This case reads %1 outside its folder. Read it?").arg(names.join(tr(" and "))),
                                QMessageBox::Yes | QMessageBox::No, &window_);
    box->setObjectName(QStringLiteral("outsideFiles"));
    box->setInformativeText(tr("A case from another person could read a private file this way. Without the file the "
                               "case cannot be opened."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::No);
    connect(box, &QMessageBox::buttonClicked, this, [this, box, file](QAbstractButton* button) {
        if (box->standardButton(button) != QMessageBox::Yes) return;
        allowed_.insert(QFileInfo(file).absoluteFilePath());
        openNow(file);
    });
    outside_ = box;
    box->open();
}

void CaseFiles::open(const QString& fileOrSample)
{
    if (isStudyFile(fileOrSample))
        emit studyFileChosen(fileOrSample);
    else
        whenSettled([this, fileOrSample] { openNow(fileOrSample); });
}

void CaseFiles::openChanged(const QString& sample, const std::vector<CaseSetting>& settings,
                            const std::function<void()>& next)
{
    whenSettled([this, sample, settings, next] {
        if (!openNow(sample)) return;
        Case changed = saved_;
        if (const auto problem = changeCase(changed, settings)) {
            showProblems(tr("%1 could not be changed.").arg(sample), {QString::fromStdString(problem->text())});
            return;
        }
        if (!settings.empty()) {
            edits_.setAll(changed, tr("change the sample case"));
            text_ = updateCaseText(text_, changed, folder_);
            saved_ = changed;
            edits_.undoStack().setClean();
        }
        next();
    });
}

void CaseFiles::newCase()
{
    whenSettled([this] {
        CaseDocument document;
        document.text = formatCase(document.value);
        take(document, {});
    });
}

void CaseFiles::chooseFile()
{
    askForFile(
        tr("Open a case or a saved run"),
        tr("Cases and runs (*.toml *.h5 *.cml *.dat *.def);;Case files (*.toml);;Saved runs (*.h5);;All files (*)"));
}

void CaseFiles::chooseImport()
{
    askForFile(tr("Import a CML case"), tr("CML cases (*.cml rail.dat run.dat dynamics.def);;All files (*)"));
}

void CaseFiles::askForFile(const QString& title, const QString& filter)
{
    auto* dialog = new QFileDialog(&window_, title, QFileInfo(file_).absolutePath(), filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        if (isResultsFile(file))
            emit resultsFileChosen(file);
        else
            open(file);
    });
    dialog->open();
}

void CaseFiles::chooseExport()
{
    const QString name = QFileInfo(shortName()).completeBaseName() + QStringLiteral(".cml");
    const QFileDialog* dialog = openSaveDialog(&window_, tr("Export as a CML case"),
                                               {tr("CML archive (*.cml)"), tr("Folder with rail.dat and run.dat (*)")},
                                               QFileInfo(file_).absoluteDir().filePath(name));
    connect(dialog, &QFileDialog::fileSelected, this, &CaseFiles::exportTo);
}

void CaseFiles::exportTo(const QString& path)
{
    const QString what = tr("The case was not exported.");
    if (const QString reason = edits_.reasonNotToRun(); !reason.isEmpty()) {
        showProblems(what, {reason});
        return;
    }
    const CmlOutput output = formatCmlCase(edits_.value());
    const std::string problem = output.problem.empty() ? writeCmlCase(pathOf(path), output.members) : output.problem;
    if (!problem.empty()) {
        showProblems(what, {QString::fromStdString(problem)});
        return;
    }
    QStringList warnings;
    for (const std::string& key : output.keptKeys) warnings << QString::fromStdString(key);
    emit exported(QFileInfo(path).absoluteFilePath(), warnings);
}

void CaseFiles::save()
{
    if (file_.isEmpty())
        saveAs();
    else
        writeAndTell(file_);
}

void CaseFiles::saveThen(const std::function<void()>& next)
{
    afterSave_ = next;
    save();
}

void CaseFiles::saveAs()
{
    const QFileDialog* dialog = openSaveDialog(&window_, tr("Save the case"), {tr("Case files (*.toml)")},
                                               file_.isEmpty() ? shortName() + QStringLiteral(".toml") : file_);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { writeAndTell(file); });
    connect(dialog, &QDialog::rejected, this, [this] { afterSave_ = nullptr; });
}

void CaseFiles::whenSettled(const std::function<void()>& next)
{
    if (!modified()) {
        next();
        return;
    }
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                tr("The case \"%1\" has changed.").arg(shortName()),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
    box->setObjectName(QStringLiteral("unsavedChanges"));
    box->setInformativeText(tr("Do you want to save the changes?"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QMessageBox::buttonClicked, this, [this, box, next](QAbstractButton* button) {
        const auto chosen = box->standardButton(button);
        if (chosen == QMessageBox::Discard) next();
        if (chosen != QMessageBox::Save) return;
        saveThen(next);
    });
    box->open();
}

void CaseFiles::leaveUnsaved() { edits_.undoStack().setClean(); }

bool CaseFiles::modified() const
{
    // Values that were changed and changed back leave nothing to save.
    return !edits_.undoStack().isClean() && (edits_.anyBadEntry() || edits_.value() != saved_);
}

QString CaseFiles::shortName() const
{
    if (!file_.isEmpty()) return QFileInfo(file_).fileName();
    if (!imported_.isEmpty()) return imported_;
    return sample_.isEmpty() ? tr("Untitled") : sample_;
}

std::string CaseFiles::text() const { return modified() ? updateCaseText(text_, edits_.value(), folder_) : text_; }

std::string CaseFiles::wholeText() const { return updateCaseText(text_, edits_.value()); }

void CaseFiles::writeAndTell(const QString& file)
{
    const std::function<void()> next = std::exchange(afterSave_, nullptr);
    if (const QString problem = write(file); !problem.isEmpty())
        showProblems(tr("The case was not saved."), {problem});
    else if (next)
        next();
}

QString CaseFiles::write(const QString& file)
{
    if (const QString reason = edits_.reasonNotToRun(); !reason.isEmpty()) return reason;
    const std::filesystem::path folder = pathOf(QFileInfo(file).absolutePath());
    const std::string text = updateCaseText(text_, edits_.value(), folder);
    const std::string problem = writeCaseFile(pathOf(file), text);
    if (!problem.empty()) return QString::fromStdString(problem);
    file_ = QFileInfo(file).absoluteFilePath();
    sample_.clear();
    imported_.clear();
    text_ = text;
    folder_ = folder;
    saved_ = edits_.value();
    edits_.undoStack().setClean();
    remember(file_);
    emit saved();
    return {};
}

CaseState CaseFiles::state() const
{
    CaseState state;
    state.name = shortName();
    state.file = file_;
    state.sample = sample_;
    state.import = imported_;
    state.folder = QString::fromStdString(folder_.string());
    state.savedText = QString::fromStdString(text_);
    state.text = QString::fromStdString(text());
    state.modified = modified();
    for (const auto& [key, entry] : edits_.badEntries()) state.entries[QString::fromStdString(key)] = entry.text;
    return state;
}

void CaseFiles::restore(const CaseState& state)
{
    delete outside_; // yes would replace what is restored
    file_ = state.file;
    sample_ = state.sample;
    imported_ = state.import;
    folder_ = pathOf(state.folder);
    text_ = state.savedText.toStdString();
    // What it read was asked for in the session that it comes from.
    saved_ = parseCase(text_, state.name.toStdString(), folder_, OutsidePaths::Allowed).value;
    edits_.open(saved_);
    emit opened();
    if (!state.modified) return;
    // A case with values that contradict each other was edited as well.
    const Case edited =
        parseCase(state.text.toStdString(), state.name.toStdString(), folder_, OutsidePaths::Allowed).value;
    if (edited != saved_) edits_.setAll(edited, tr("restore the edits"));
    for (const auto& [key, text] : state.entries)
        if (const Parameter* parameter = findParameter(key.toStdString())) edits_.enter(*parameter, text);
}

QStringList CaseFiles::recent() const { return QSettings().value(recentKey).toStringList(); }

void CaseFiles::remember(const QString& file)
{
    QStringList list = recent();
    list.removeAll(file);
    list.prepend(file);
    while (list.size() > mostRecent) list.removeLast();
    QSettings().setValue(recentKey, list);
}

void CaseFiles::showProblems(const QString& what, const QStringList& problems)
{
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Touchdown"), what, QMessageBox::Close, &window_);
    box->setObjectName(QStringLiteral("problems"));
    box->setInformativeText(problems.mid(0, 8).join(QLatin1Char('\n')));
    if (problems.size() > 8) box->setDetailedText(problems.join(QLatin1Char('\n')));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

bool CaseFiles::isCaseFile(const QString& file)
{
    return QFileInfo(file).suffix().compare(QLatin1String("toml"), Qt::CaseInsensitive) == 0 || isCmlPath(pathOf(file));
}

bool CaseFiles::isResultsFile(const QString& file)
{
    const QString suffix = QFileInfo(file).suffix().toLower();
    return suffix == QLatin1String("h5") || suffix == QLatin1String("hdf5");
}

bool CaseFiles::isStudyFile(const QString& file)
{
    const QFileInfo info(file);
    return info.isFile() && info.suffix().compare(QLatin1String("toml"), Qt::CaseInsensitive) == 0 &&
           findStudySource(pathOf(file).string()).has_value();
}

} // namespace touchdown
