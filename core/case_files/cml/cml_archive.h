// SPDX-License-Identifier: GPL-3.0-or-later
//
// .cml archives of the established program, versions 7 and 8: PKZIP files that hold its text files. They are read and
// written in memory, and all sizes are limited, because an archive may come from an untrusted source.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/formats/text_file.h"

namespace touchdown {

/// One of the text files: rail.dat, run.dat or dynamics.def.
struct CmlMember {
    std::string name; // in lower case, without folders
    std::string text;
};

struct CmlArchive {
    std::vector<CmlMember> members;
    std::vector<std::string> warnings; // sentences
};

/// The text files in the folder of the topmost rail.dat.
std::variant<CmlArchive, FileProblem> readCmlArchive(std::string_view bytes);

/// The bytes of an archive.
std::variant<std::string, FileProblem> formatCmlArchive(const std::vector<CmlMember>& members);

/// Whether one of the program's text files has this name, in lower case.
bool isCmlMember(std::string_view name);

} // namespace touchdown
