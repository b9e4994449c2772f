// SPDX-License-Identifier: GPL-3.0-or-later
//
// The message that another program has changed the file of the case. It stays until the file is saved, reloaded or as
// before, or until it is closed.
#pragma once

#include "ui/style/message_strip.h"

namespace touchdown {

class CaseFiles;

class FileNotice : public MessageStrip {
    Q_OBJECT

public:
    explicit FileNotice(CaseFiles& files, QWidget* parent = nullptr);
};

} // namespace touchdown
