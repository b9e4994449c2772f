// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/results/file_header.h"
#include "core/results/steady_writer.h"
#include "core/studies/study/study_file.h"
#include "ui/plot/plot_export.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/save_dialog.h"

namespace touchdown {

RunFiles::RunFiles(RunsModel& runs, QWidget& page, QWidget& window)
    : QObject(&window), runs_(runs), page_(page), window_(window)
{}

void RunFiles::chooseSave(int number, bool csv)
{
    const RunRecord* run = runs_.find(number);
    if (!run) return;
    const QString hdf5 = tr("HDF5, all of the run (*.h5)");
    const QString table = tr("CSV, the time series (*.csv)");
    const QStringList filters = csv ? QStringList{table, hdf5} : QStringList{hdf5, table};
    const QString suggestion = suggestedName(*run) + (csv ? QStringLiteral(".csv") : QStringLiteral(".h5"));
    askAndSave(&window_, tr("Save run %1").arg(number), filters, suggestion, [this, number](const QString& file) {
        const RunRecord* chosen = runs_.find(number);
        if (!chosen) return QString();
        const bool asCsv = QFileInfo(file).suffix().compare(QLatin1String("csv"), Qt::CaseInsensitive) == 0;
        const QString problem = asCsv ? saveTimeSeries(*chosen, file) : saveHdf5(*chosen, file);
        if (problem.isEmpty() && !asCsv) runs_.setFile(number, file);
        return reported(problem, file);
    });
}

void RunFiles::chooseOpen()
{
    auto* dialog = new QFileDialog(&window_, tr("Open saved results"), {}, tr("Results (*.h5 *.hdf5);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
        for (const QString& file : files) openResults(file);
    });
    dialog->open();
}

void RunFiles::openResults(const QString& file)
{
    const std::string format = formatOf(file.toStdString());
    if (format == steadyFormat)
        emit solutionsChosen(file);
    else if (format == studyFormat)
        emit studyChosen(file);
    else
        openRun(file);
}

void RunFiles::openRun(const QString& file)
{
    QString problem;
    std::unique_ptr<RunRecord> record = recordFromFile(runs_.nextNumber(), file, problem);
    if (!record) {
        emit failed(problem);
        return;
    }
    const QString caseProblem = record->caseProblem;
    const int number = runs_.add(std::move(record)).number;
    if (!caseProblem.isEmpty()) {
        emit failed(tr("Run %1 was read, but not its case, so its parameters are not known: %2")
                        .arg(QString::number(number), caseProblem));
        return;
    }
    emit succeeded(tr("Run %1 was read from %2.").arg(number).arg(QDir::toNativeSeparators(file)));
}

void RunFiles::choosePicture()
{
    askAndSave(&window_, tr("Export the plots"),
               {tr("PNG picture (*.png)"), tr("SVG drawing (*.svg)"), tr("PDF document (*.pdf)")},
               QStringLiteral("touchdown.png"),
               [this](const QString& file) { return reported(savePicture(page_, file), file); });
}

QString RunFiles::reported(const QString& problem, const QString& file)
{
    if (problem.isEmpty())
        emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(file)));
    else
        emit failed(problem);
    return {};
}

QString suggestedName(const RunRecord& run)
{
    QString name = (run.label.isEmpty() ? run.name : run.label).left(40).toLower();
    name.replace(QRegularExpression(QStringLiteral("[^a-z0-9]+")), QStringLiteral("-"));
    return QStringLiteral("run%1-%2").arg(run.number).arg(name).remove(QRegularExpression(QStringLiteral("-+$")));
}

} // namespace touchdown
