// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static solutions to and from files (core/results/steady_writer.h), by dialogs that leave the window alive.
#pragma once

#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QWidget>

namespace touchdown {

class SolutionsModel;
struct SolutionRecord;

/// "" or the problem in a sentence.
QString saveSolution(const SolutionRecord& solution, const QString& file);

/// Adds every state of a file that has a field, with the case of that state; the last one is chosen. With `places`,
/// only those states: they count from 0 among those with a field. Returns their numbers; none with `problem` set.
std::vector<int> addSolutions(SolutionsModel& solutions, const QString& file, QString& problem,
                              std::optional<std::vector<int>> places = {});

class SolutionFiles : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    SolutionFiles(SolutionsModel& solutions, QWidget& window);

    void chooseSave(int number);
    /// See addSolutions.
    void open(const QString& file);

signals:
    /// The last of them is `number`.
    void opened(int number, const QString& file);
    void succeeded(const QString& sentence);
    void failed(const QString& sentence);

private:
    SolutionsModel& solutions_;
    QWidget& window_;
};

} // namespace touchdown
