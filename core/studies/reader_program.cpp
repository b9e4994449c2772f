// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/reader_program.h"

#include <new>
#include <string>

#include "core/formats/cml_text.h"
#include "core/formats/dxf_drawing.h"
#include "core/formats/reader_process.h"
#include "core/formats/surfaces/height_map_hdf5.h"
#include "core/results/file_header.h"
#include "core/results/results_reader.h"
#include "core/results/steady_reader.h"
#include "core/results/stored_values.h"
#include "core/studies/study/stored_report.h"
#include "core/studies/study/study_file_reader.h"

namespace touchdown {

namespace {

void sendSurface(PassedOut& answer, const ReaderTask& task)
{
    std::string problem;
    HeightMap map;
    try {
        map = readHeightMapHdf5(task.file, unitsOfKey(task.argument).value_or(ColumnUnits{}));
    } catch (const CmlError& error) {
        problem = error.what();
    } catch (const std::bad_alloc&) {
        problem = "is damaged: it asks for more memory than a file of its size needs";
    }
    answer(problem, map);
}

} // namespace

std::optional<int> runReader(int argc, const char* const* argv)
{
    const std::optional<ReaderTask> task = beginReader(argc, argv);
    if (!task) return {};
    PassedOut answer(sendAnswer);
    if (task->reader == "surface") sendSurface(answer, *task);
    if (task->reader == "run") answer(readResultsDirectly(task->file));
    if (task->reader == "steady") answer(readSteadyDirectly(task->file));
    if (task->reader == "study") answer(readStudyDirectly(task->file));
    if (task->reader == "drawing") answer(readDxfDirectly(task->file));
    if (task->reader == "format") answer(formatDirectly(task->file));
    return 0;
}

} // namespace touchdown
