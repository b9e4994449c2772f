// SPDX-License-Identifier: GPL-3.0-or-later
//
// The question before the file of a study is written over that another program has changed.
#pragma once

#include <functional>

#include <QWidget>

#include "core/formats/file_identity.h"

namespace touchdown {

/// What the answers do. `shown` is the file's text as the question showed it.
struct ChangedStudyAnswers {
    std::function<void(const std::string& shown)> writeOver;
    std::function<void()> reload, saveAs;
};
/// Shows the lines that differ, and asks. `identity`: of the file as it was opened or saved. `text`: of the window.
void askAboutStudy(QWidget& window, const QString& file, const FileIdentity& identity, const QString& text,
                   const ChangedStudyAnswers& answers);

} // namespace touchdown
