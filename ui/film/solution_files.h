// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static solutions to and from files (core/results/steady_writer.h), by dialogs that leave the window alive.
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

namespace touchdown {

class SolutionsModel;
struct SolutionRecord;

/// "" or the problem in a sentence.
QString saveSolution(const SolutionRecord& solution, const QString& file);

class SolutionFiles : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    SolutionFiles(SolutionsModel& solutions, QWidget& window);

    void chooseSave(int number);
    /// Adds every state of the file that has a field, with the case of that state.
    void open(const QString& file);

signals:
    /// The last of them is `number`.
    void opened(int number);
    void succeeded(const QString& sentence);
    void failed(const QString& sentence);

private:
    SolutionsModel& solutions_;
    QWidget& window_;
};

} // namespace touchdown
