// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/case_files.h"

#include <algorithm>

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
#include "core/formats/dxf_surface.h"
#include "core/formats/text_file.h"
#include "core/studies/study_plan.h"
#include "ui/style/foreign_text.h"
#include "ui/style/loss_question.h"
#include "ui/style/quantity_format.h"
#include "ui/style/save_dialog.h"

namespace touchdown {

namespace {

constexpr int mostRecent = 10;
constexpr auto recentKey = "files/recent";

std::filesystem::path pathOf(const QString& file) { return file.toStdString(); }

/// Also the mark of the byte order at its beginning, which fromStdString drops.
QString wholeTextOf(const std::string& text)
{
    return (text.starts_with("\xef\xbb\xbf") ? QString(QChar(QChar::ByteOrderMark)) : QString()) +
           QString::fromStdString(text);
}

/// Name of the archive or of the folder; the file itself is always rail.dat.
QString importedName(const QFileInfo& file)
{
    if (file.isDir()) return file.fileName();
    return file.suffix().compare(QLatin1String("cml"), Qt::CaseInsensitive) == 0 ? file.completeBaseName()
                                                                                 : file.dir().dirName();
}

} // namespace

CaseFiles::CaseFiles(CaseEdits& edits, QWidget& window)
    : QObject(&window), edits_(edits), window_(window), watched_(new WatchedFile(window, this))
{
    connect(watched_, &WatchedFile::changed, this, &CaseFiles::tellChange);
}

void CaseFiles::take(const CaseDocument& document, const QString& file)
{
    const bool import = !file.isEmpty() && isCmlPath(pathOf(file));
    file_ = import ? QString() : file;
    sample_.clear();
    imported_ = import ? importedName(QFileInfo(file)) : QString();
    origin_ = file;
    if (file.isEmpty()) {
        const bool isSample = std::ranges::find(sampleCases(), document.name, &SampleCase::name) != sampleCases().end();
        (isSample ? sample_ : imported_) = QString::fromStdString(document.name);
        origin_ = sample_;
    }
    text_ = document.text;
    folder_ = document.folder;
    saved_ = document.value;
    watch(document);
    edits_.open(document.value);
    if (!file.isEmpty()) remember(file);
    emit opened();
    const QStringList warnings = lastingWarnings(document);
    if (import)
        emit imported(file, warnings);
    else if (!warnings.isEmpty())
        emit warned(warnings);
}

void CaseFiles::use(const Case& c, const QString& name, const QString& step, const std::function<void()>& next)
{
    if (isOpen(c)) {
        if (c != edits_.value()) edits_.setAll(c, step);
        return next();
    }
    whenSettled([this, c, name, next] {
        CaseDocument document;
        document.value = c;
        document.text = formatCase(c);
        document.name = name.toStdString();
        take(document, {});
        next();
    });
}

bool CaseFiles::isOpen(const Case& c) const
{
    const auto like = [&c](const Case& open) { return c.model == open.model && c.title == open.title; };
    return like(edits_.value()) || like(saved_);
}

std::optional<CaseDocument> CaseFiles::read(const QString& fileOrSample, const std::function<void()>& again)
{
    CaseDocument document = readNow(fileOrSample);
    if (!document.outsideFiles.empty()) {
        askForOutsideFiles(fileOrSample, document.outsideFiles, again);
        return std::nullopt;
    }
    if (!document.valid()) {
        showProblems(tr("%1 could not be opened.").arg(inOneLine(QFileInfo(fileOrSample).fileName())),
                     textsOf(document.problems));
        return std::nullopt;
    }
    return document;
}

bool CaseFiles::openNow(const QString& fileOrSample)
{
    const std::optional<CaseDocument> document = read(fileOrSample, [this, fileOrSample] { openNow(fileOrSample); });
    if (!document) return false;
    const QFileInfo info(fileOrSample);
    take(*document, info.exists() ? info.absoluteFilePath() : QString());
    return true;
}

void CaseFiles::open(const QString& fileOrSample)
{
    if (isResultsFile(fileOrSample))
        emit resultsFileChosen(fileOrSample);
    else if (isStudyFile(fileOrSample))
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

void CaseFiles::newCase(const QString& slider)
{
    whenSettled([this, slider] {
        const auto found = std::ranges::find(sliderTemplates(), slider.toStdString(), &SampleCase::name);
        CaseDocument document;
        if (found != sliderTemplates().end())
            document = parseCase(found->text, found->name);
        else
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
    connect(dialog, &QFileDialog::fileSelected, this, &CaseFiles::open);
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
    emit aboutToUse();
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
    QStringList remarks, keys;
    for (const std::string& key : output.keptKeys) keys << QString::fromStdString(key);
    if (!keys.isEmpty())
        remarks << tr("Written as comments of run.dat, which the established program ignores: %1")
                       .arg(keys.join(QStringLiteral(", ")));
    if (!output.lost.empty()) remarks << sentence(output.lost);
    emit exported(QFileInfo(path).absoluteFilePath(), remarks.join(QLatin1Char('\n')));
}

void CaseFiles::chooseDrawing()
{
    const QString name = QFileInfo(shortName()).completeBaseName() + QStringLiteral(".dxf");
    askAndSave(&window_, tr("Save the surface as a drawing"), {tr("DXF drawing (*.dxf)")},
               QFileInfo(file_).absoluteDir().filePath(name),
               [this](const QString& path) { return exportDrawing(path); });
}

QString CaseFiles::exportDrawing(const QString& path)
{
    emit aboutToUse();
    const Case& c = edits_.value();
    const std::string problem = writeTextFile(pathOf(path), dxfText(c.surface, c.slider.length, c.slider.width));
    if (!problem.empty()) return inOneLine(QFileInfo(path).fileName()) + ' ' + QString::fromStdString(problem);
    const std::string lost = lostInDrawing(c.surface);
    emit exported(QFileInfo(path).absoluteFilePath(), lost.empty() ? QString() : sentence(lost));
    return {};
}

void CaseFiles::whenSettled(const std::function<void()>& next)
{
    emit aboutToUse();
    if (askAboutResults_ && askAboutResults_(next)) return;
    withdrawQuestion(window_, QStringLiteral("unsavedChanges"));
    if (!hasChangesToSave()) return next();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                tr("The case \"%1\" has changed.").arg(inOneLine(shortName())),
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

bool CaseFiles::hasChangesToSave() const
{
    const bool isSample = file_.isEmpty() && !sample_.isEmpty();
    return modified() && !(isSample && !edits_.anyBadEntry() && isKept_ && isKept_(edits_.value()));
}

QString CaseFiles::shortName() const
{
    if (!file_.isEmpty()) return QFileInfo(file_).fileName();
    if (!imported_.isEmpty()) return imported_;
    return sample_.isEmpty() ? tr("Untitled") : sample_;
}

std::string CaseFiles::text() const { return modified() ? updateCaseText(text_, edits_.value(), folder_) : text_; }

std::string CaseFiles::wholeText() const { return updateCaseText(text_, edits_.value()); }

CaseState CaseFiles::state() const
{
    CaseState state;
    state.name = shortName();
    state.file = file_;
    state.sample = sample_;
    state.import = imported_;
    state.origin = origin_;
    state.folder = QString::fromStdString(folder_.string());
    state.savedText = wholeTextOf(text_);
    state.text = wholeTextOf(text());
    state.modified = modified() || !edits_.typed().empty();
    for (const auto& [key, entry] : edits_.badEntries()) state.entries[QString::fromStdString(key)] = entry.text;
    for (const auto& [key, text] : edits_.typed()) state.entries[QString::fromStdString(key)] = text;
    return state;
}

QString CaseFiles::restore(const CaseState& state)
{
    if (state.savedText.isEmpty() || (state.modified && state.text.isEmpty())) return tr("its text is missing");
    const CaseDocument saved = readState(state, state.savedText);
    const CaseDocument edited = state.modified ? readState(state, state.text) : saved;
    for (const CaseDocument* document : {&saved, &edited})
        for (const InputProblem& problem : document->problems)
            // A case with values that contradict each other, or without its measured surface, was edited as well.
            if (problem.kind != ProblemKind::Combination && problem.kind != ProblemKind::MeasuredDisk)
                return QString::fromStdString(problem.text());
    delete outside_; // yes would replace what is restored
    file_ = state.file;
    sample_ = state.sample;
    imported_ = state.import;
    origin_ = !state.origin.isEmpty() ? state.origin : file_.isEmpty() ? sample_ : file_;
    folder_ = pathOf(state.folder);
    text_ = state.savedText.toStdString();
    saved_ = saved.value;
    watch(saved);
    edits_.open(saved_);
    emit opened();
    if (!state.modified) return {};
    if (edited.value != saved_) edits_.setAll(edited.value, tr("restore the edits"));
    for (const auto& [key, text] : state.entries)
        if (const Parameter* parameter = findParameter(key.toStdString())) edits_.enter(*parameter, text);
    return {};
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

QStringList CaseFiles::textsOf(const std::vector<InputProblem>& problems)
{
    QStringList texts;
    for (const InputProblem& problem : problems) texts << QString::fromStdString(problem.text());
    return texts;
}

QStringList CaseFiles::lastingWarnings(const CaseDocument& document)
{
    std::vector<InputProblem> lasting = document.warnings;
    std::erase_if(lasting, [](const InputProblem& warning) { return warning.kind == ProblemKind::Combination; });
    return textsOf(lasting) + textsOf(document.unused);
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

bool CaseFiles::canOpen(const QString& file)
{
    return isResultsFile(file) || QFileInfo(file).suffix().compare(QLatin1String("toml"), Qt::CaseInsensitive) == 0 ||
           isCmlPath(pathOf(file));
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
