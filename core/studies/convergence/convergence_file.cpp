// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence_file.h"

#include <cmath>

#include "core/formats/decimal.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/text_file.h"
#include "core/results/results_layout.h"

namespace touchdown {

namespace {

std::vector<double> column(const ConvergenceStudy& study, const auto& of)
{
    std::vector<double> values;
    for (const ConvergenceLevel& level : study.levels) values.push_back(of(level));
    return values;
}

void writeLevels(hid_t file, const ConvergenceStudy& study)
{
    const Hdf5Handle group = createHdf5Group(file, "levels");
    const auto write = [&](const std::string& name, const std::vector<double>& values, const std::string& unit,
                           const std::string& longName) {
        describeHdf5(writeHdf5Array(group, name, values), unit.empty() ? "1" : unit, longName);
    };
    write("cell", column(study, [](const auto& level) { return level.cell; }), "m", "Side of a cell");
    write("cells", column(study, [](const auto& level) { return static_cast<double>(level.cells); }), "",
          "Cells of all patches");
    write("seconds", column(study, [](const auto& level) { return level.seconds; }), "s", "Wall time");
    for (std::size_t i = 0; i < study.quantities.size(); ++i)
        write(study.quantities[i].name, column(study, [i](const auto& level) { return level.values[i]; }),
              study.quantities[i].unit, study.quantities[i].longName);
}

void writeObserved(hid_t file, const ConvergenceStudy& study)
{
    const Hdf5Handle group = createHdf5Group(file, "observed");
    std::vector<std::string> names;
    std::vector<double> orders, limits, errors;
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        names.push_back(study.quantities[i].name);
        orders.push_back(study.observed[i].order.value_or(0.0));
        limits.push_back(study.observed[i].limit);
        errors.push_back(study.observed[i].error);
    }
    describeHdf5(writeHdf5Array(group, "quantity", names), "1", "Quantities");
    describeHdf5(writeHdf5Array(group, "order", orders), "1", "Observed order; 0 where there is none");
    describeHdf5(writeHdf5Array(group, "limit", limits), "SI unit of the quantity",
                 "Limit by Richardson's extrapolation");
    describeHdf5(writeHdf5Array(group, "error", errors), "SI unit of the quantity",
                 "Estimated error of the finest level");
}

} // namespace

std::string writeConvergence(const std::filesystem::path& path, const Case& c, const std::string& caseText,
                             const ConvergenceStudy& study)
{
    if (study.status != StudyStatus::Completed) return "a study that did not end has no results to write";
    return writeHdf5File(path, "the study", [&](hid_t file) {
        writeFileHeader(file, "touchdown-convergence", 1, 0, dateNow(), c.title);
        writeHdf5Attribute(file, "status", std::string(name(study.status)));
        writeHdf5Attribute(file, "message", study.message);
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
