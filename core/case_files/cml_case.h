// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases of the established slider program (CML): a folder or an archive with rail.dat and run.dat or dynamics.def.
// Contents that Touchdown does not model become warnings; values of a case that the files cannot hold are kept in the
// comments of run.dat.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_document.h"
#include "core/case_files/cml/cml_archive.h"
#include "core/case_files/cml/cml_parameters.h"
#include "core/case_files/outside_path.h"

namespace touchdown {

/// The file of a folder with this name in any case; in lower case if there are several.
std::optional<std::filesystem::path> findCmlMember(const std::filesystem::path& folder, const std::string& name);

/// Whether a path is one of its files, a folder that holds a rail.dat, or has the name of an archive.
bool isCmlPath(const std::filesystem::path& path);

/// Reads the case. If there are both run.dat and dynamics.def, the file that the path names is read, else run.dat.
/// `text` of the document is the same case as TOML.
CaseDocument readCmlCase(const std::filesystem::path& path, OutsidePaths outside = OutsidePaths::Refused);

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
/// Puts their values into the case, which has the defaults of a film.
void readCmlFiles(const CmlFiles& files, CmlParameters& parameters);

/// The files of a film case, as far as they can describe it.
struct CmlOutput {
    std::vector<CmlMember> members;
    std::vector<std::string> keptKeys; // of values that only the comments hold
    std::string lost;                  // a sentence about what no file has, or ""
    std::string problem;               // why there are no files, or ""
};
CmlOutput formatCmlCase(const Case& c);

/// The archive, or the files of the folder, in whose place writeCmlCase() would write; none where there is nothing.
std::vector<std::filesystem::path> replacedCmlFiles(const std::filesystem::path& path);

/// Writes them as an archive if the path ends with .cml, else into a folder, which is created if necessary. The files
/// appear when all are written, so that a failure leaves the old files unchanged. Returns the problem, or "".
std::string writeCmlCase(const std::filesystem::path& path, const std::vector<CmlMember>& members);

} // namespace touchdown
