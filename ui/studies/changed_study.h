// SPDX-License-Identifier: GPL-3.0-or-later
//
// The question before the file of a study is written over that another program has changed.
#pragma once

#include <functional>

#include <QWidget>

#include "core/formats/file_identity.h"

namespace touchdown {

/// What the answers do. Each is given the file's text as the question showed it.
struct ChangedStudyAnswers {
    std::function<void(const std::string&shown)> writeOver, reload;
    std::function<void()> saveAs;
};
/// True, after asking, where the file is no longer the one that was opened or saved. `text` is that of the window.
bool asksAboutStudy(QWidget& window, const QString& file, const FileIdentity& identity, const QString& text,
                    const ChangedStudyAnswers& answers);

} // namespace touchdown
