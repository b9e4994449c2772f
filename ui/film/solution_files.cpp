// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/solution_files.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

#include <QDir>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/results/steady_reader.h"
#include "core/results/steady_writer.h"
#include "ui/film/solutions_model.h"
#include "ui/style/quantity_format.h"
#include "ui/style/save_dialog.h"
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

/// Why a solution cannot be saved; empty if it can.
QString reasonNotToSave(const SolutionRecord& solution)
{
    if (!solution.fieldsDropped || !solution.kept.isEmpty()) return {};
    return tr("The fields of solution %1 were given up to save memory; solve it again before saving it.")
        .arg(solution.number);
}

} // namespace

QString saveSolution(const SolutionRecord& solution, const QString& file)
{
    if (const QString reason = reasonNotToSave(solution); !reason.isEmpty()) return reason;
    if (solution.fieldsDropped) return copyWholeFile(solution.kept, file);
    const SteadyResult& state = solution.result;
    SteadyWriter writer;
    const Case c = withoutSeries(solution.value);
    std::string problem = writer.open(std::filesystem::path(file.toStdString()), c, formatCase(c));
    if (problem.empty()) problem = writer.add(seriesOf(c).front(), state);
    if (problem.empty()) problem = writer.finish(state.status, state.message);
    return QString::fromStdString(problem);
}

StoredSolutions readSolutions(const QString& file)
{
    const std::optional<FileIdentity> identity = identityOf(file.toStdString());
    StoredSteady stored = readSteady(std::filesystem::path(file.toStdString()));
    if (!stored.problem.empty()) return {file, {}, {}, sentence(stored.problem)};
    CaseDocument document = parseCase(stored.caseText, file.toStdString());
    // A stored state is shown without the surface of its disk.
    if (!document.outsideFiles.empty())
        std::erase_if(document.problems, [](const InputProblem& each) { return each.key == surfaceFileKey; });
    if (!document.valid())
        return {file,
                {},
                {},
                tr("The case in %1 cannot be read: %2")
                    .arg(QDir::toNativeSeparators(file), QString::fromStdString(document.problems.front().text()))};
    StoredSolutions solutions{file, identity, {}, {}};
    const std::vector<SteadySeriesPoint> points = seriesOf(document.value);
    for (std::size_t i = 0; i < std::min(points.size(), stored.states.size()); ++i)
        if (!stored.states[i].pressure.empty())
            solutions.states.emplace_back(caseAt(document.value, points[i]), std::move(stored.states[i]));
    if (solutions.states.empty())
        solutions.problem = tr("No state in %1 has a pressure field to show.").arg(QDir::toNativeSeparators(file));
    return solutions;
}

std::vector<int> addSolutions(SolutionsModel& solutions, const StoredSolutions& stored, const std::vector<int>& places,
                              const std::vector<int>& numbers)
{
    std::vector<int> added;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& [c, state] = stored.states[static_cast<std::size_t>(places[i])];
        added.push_back(solutions.add(c, state, stored.file, i + 1 == places.size(), places[i], stored.identity,
                                      numbers.empty() ? 0 : numbers[i]));
    }
    return added;
}

SolutionFiles::SolutionFiles(SolutionsModel& solutions, QWidget& window)
    : QObject(&window), solutions_(solutions), window_(window)
{}

void SolutionFiles::chooseSave(int number)
{
    const SolutionRecord* chosen = solutions_.find(number);
    if (!chosen) return;
    if (const QString reason = reasonNotToSave(*chosen); !reason.isEmpty()) {
        emit failed(reason);
        return;
    }
    askAndSave(&window_, tr("Save solution %1").arg(number), {tr("HDF5, the static solution (*.h5)")},
               tr("solution%1.h5").arg(number), [this, number](const QString& file) {
                   const SolutionRecord* solution = solutions_.find(number);
                   if (!solution) return QString();
                   const QString problem = saveSolution(*solution, file);
                   if (problem.isEmpty()) {
                       solutions_.setFile(number, file);
                       emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(file)));
                   } else {
                       emit failed(problem);
                   }
                   return QString();
               });
}

void SolutionFiles::open(const QString& file)
{
    const StoredSolutions stored = readSolutions(file);
    if (!stored.problem.isEmpty()) {
        emit failed(stored.problem);
        return;
    }
    std::vector<int> places(stored.states.size());
    std::iota(places.begin(), places.end(), 0);
    const std::vector<int> added = addSolutions(solutions_, stored, places);
    QStringList numbers;
    for (const int number : added) numbers << QString::number(number);
    emit opened(added.back(), file);
    emit succeeded(
        tr("Read from %1: solutions %2.").arg(QDir::toNativeSeparators(file)).arg(numbers.join(QStringLiteral(", "))));
}

} // namespace touchdown
