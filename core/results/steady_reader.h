// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads static states from a file (steady_writer.h says what it holds), in a process of its own
// (core/formats/reader_process.h). Other equilibria are not in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

struct StoredSteady {
    std::string title;
    std::string caseText;
    std::vector<SteadyResult> states;
    std::string problem; // "" when it was read; else one sentence, and nothing else is set
};
/// A field whose size does not fit the state's grid makes the file damaged.
StoredSteady readSteady(const std::filesystem::path& file);
/// The same in this process: for that process, and for files that this program wrote.
StoredSteady readSteadyDirectly(const std::filesystem::path& file);

} // namespace touchdown
