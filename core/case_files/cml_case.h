// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases of the established slider program (CML): a folder or an archive with rail.dat and run.dat or dynamics.def. What
// they say and Touchdown does not model becomes warnings; what a case says and they cannot, is kept in the comments of
// run.dat.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/case_files/case_file.h"
#include "core/case_files/cml/cml_archive.h"
#include "core/case_files/cml/cml_fields.h"

namespace touchdown {

/// Whether a path leads to one of its files, to a folder that holds a rail.dat, or bears the name of an archive.
bool isCmlPath(const std::filesystem::path& path);

/// Reads the case. Of run.dat and dynamics.def, that which the path names counts, else run.dat. `text` of the document
/// is the same case as TOML.
CaseDocument readCmlCase(const std::filesystem::path& path);

/// The program's files, each with the name for its problems.
struct CmlFiles {
    struct File {
        std::string name;
        std::string text;
    };
    File rail;
    File run; // one of these two, or none
    File dynamics;
};
/// Puts what they say into the case, which has the defaults of a film.
void readCmlFiles(const CmlFiles& files, CmlFields& fields);

/// The files that say as much of a film case as they can.
struct CmlOutput {
    std::vector<CmlMember> members;
    std::vector<std::string> keptKeys; // of values that the established program will not see
    std::string problem;               // why there are none; "" when there are
};
CmlOutput formatCmlCase(const Case& c);

/// Writes them as an archive if the path ends with .cml, else into a folder, which is made if need be. All is written
/// under other names first, so that a failure leaves what was there. Returns the problem, or "".
std::string writeCmlCase(const std::filesystem::path& path, const std::vector<CmlMember>& members);

} // namespace touchdown
