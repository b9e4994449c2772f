// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence_file.h"

#include <cmath>

#include "core/formats/decimal.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/text_file.h"
#include "core/results/file_header.h"

namespace touchdown {

namespace {

std::vector<double> column(const ConvergenceStudy& study, const auto& of)
{
    std::vector<double> values;
    for (const ConvergenceLevel& level : study.levels) values.push_back(of(level));
    return values;
}

void writeLevels(const Hdf5Group& file, const ConvergenceStudy& study)
{
    const Hdf5Group group = file.create("levels");
    const auto write = [&](const std::string& name, const std::vector<double>& values, const std::string& unit,
                           const std::string& longName) { group.put(name, values, unit, longName); };
    write("cell", column(study, [](const auto& level) { return level.cell; }), "m", "Side of a cell");
    write("cells", column(study, [](const auto& level) { return static_cast<double>(level.cells); }), "",
          "Cells of all patches");
    write("seconds", column(study, [](const auto& level) { return level.seconds; }), "s", "Wall time");
    for (std::size_t i = 0; i < study.quantities.size(); ++i)
        write(study.quantities[i].name, column(study, [i](const auto& level) { return level.values[i]; }),
              study.quantities[i].unit, study.quantities[i].longName);
}

void writeObserved(const Hdf5Group& file, const ConvergenceStudy& study)
{
    const Hdf5Group group = file.create("observed");
    std::vector<std::string> names;
    std::vector<double> orders, limits, errors;
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        names.push_back(study.quantities[i].name);
        orders.push_back(study.observed[i].order.value_or(0.0));
        limits.push_back(study.observed[i].limit);
        errors.push_back(study.observed[i].error);
    }
    group.put("quantity", names, "1", "Quantities");
    group.put("order", orders, "1", "Observed order; 0 where there is none");
    group.put("limit", limits, "SI unit of the quantity", "Limit by Richardson's extrapolation");
    group.put("error", errors, "SI unit of the quantity", "Estimated error of the finest level");
}

} // namespace

std::string writeConvergence(const std::filesystem::path& path, const Case& c, const std::string& caseText,
                             const ConvergenceStudy& study)
{
    if (study.status != StudyStatus::Completed) return "a study that did not end has no results to write";
    return writeHdf5File(path, "the study", [&](const Hdf5Group& file) {
        writeFileHeader(file, "touchdown-convergence", 1, 0, dateNow(), c.title);
        file.set("status", name(study.status));
        file.set("message", study.message);
        writeCaseGroup(file, c, caseText);
        writeLevels(file, study);
        writeObserved(file, study);
    });
}

std::string writeConvergenceCsv(const std::filesystem::path& path, const ConvergenceStudy& study)
{
    if (study.status != StudyStatus::Completed) return "a study that did not end has no results to write";
    std::string text = "cell [m],cells,seconds [s]";
    for (const Quantity& quantity : study.quantities) text += ',' + quantity.name + " [" + quantity.unit + ']';
    text += "\r\n";
    for (const ConvergenceLevel& level : study.levels) {
        text += decimalText(level.cell) + ',' + std::to_string(level.cells) + ',' + decimalText(level.seconds);
        for (const double value : level.values) text += ',' + decimalText(value);
        text += "\r\n";
    }
    const std::string problem = writeTextFile(path, text);
    return problem.empty() ? problem : path.string() + ": " + problem;
}

} // namespace touchdown
