// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs and pictures to and from files, by dialogs that leave the window alive.
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

namespace touchdown {

class RunsModel;
struct RunRecord;

/// For a file of a run, without its ending: "run3-2-dof-slider".
QString suggestedName(const RunRecord& run);

class RunFiles : public QObject {
    Q_OBJECT

public:
    /// All must outlive this; `page` holds the plots that are exported together.
    RunFiles(RunsModel& runs, QWidget& page, QWidget& window);

    /// HDF5 or CSV, as the name ends.
    void chooseSave(int number, bool csv);
    void chooseOpen();
    void choosePicture();
    /// A saved run, static solutions or the report of a study.
    void openResults(const QString& file);

signals:
    void succeeded(const QString& sentence);
    void failed(const QString& sentence);
    /// The file that was to be opened holds static solutions, no run.
    void solutionsChosen(const QString& file);
    void studyChosen(const QString& file);

private:
    void openRun(const QString& file);
    /// Emits `succeeded` or `failed`. Returns no problem: the dialog has nothing to show.
    QString reported(const QString& problem, const QString& file);

    RunsModel& runs_;
    QWidget& page_;
    QWidget& window_;
};

} // namespace touchdown
