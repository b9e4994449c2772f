// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/formats/file_identity.h"

namespace touchdown {

/// The text of a study in the editor, which has one for each kind.
struct StudyDraft {
    QString kind;
    QString text;
    QString saved;           // as it began, or as its file has it
    QString file;            // where it was opened or saved; empty: none
    FileIdentity identity{}; // of that file then

    bool modified() const { return text != saved; }
};

} // namespace touchdown
