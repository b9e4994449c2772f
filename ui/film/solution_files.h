// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static solutions to and from files (core/results/steady_writer.h), by dialogs that leave the window alive.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QObject>
#include <QString>
#include <QWidget>

#include "core/formats/file_identity.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

class SolutionsModel;
struct SolutionRecord;

/// "" or the problem in a sentence.
QString saveSolution(const SolutionRecord& solution, const QString& file);

/// The states of a file that have a field, each with the case of that state.
struct StoredSolutions {
    QString file;
    std::optional<FileIdentity> identity; // of that file
    std::vector<std::pair<Case, SteadyResult>> states;
    QString problem; // empty when there is one at least
};
StoredSolutions readSolutions(const QString& file);
/// Adds the states at these places, which count from 0; the last one is chosen. `numbers`: that they get; empty: the
/// next ones. Returns their numbers.
std::vector<int> addSolutions(SolutionsModel& solutions, const StoredSolutions& stored, const std::vector<int>& places,
                              const std::vector<int>& numbers = {});

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
