// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/file_notice.h"

#include "ui/case/case_files.h"

namespace touchdown {

FileNotice::FileNotice(CaseFiles& files, QWidget* parent) : MessageStrip(parent)
{
    setObjectName(QStringLiteral("fileNotice"));
    setAccessibleName(tr("The file of the case"));
    keepPlace(false);
    connect(&files, &CaseFiles::fileChanged, this, [this, &files](const QString& sentence, bool valid) {
        if (sentence.isEmpty()) return clear();
        show(Kind::Warning, sentence, valid ? tr("Reload") : QString(), Topic::Any,
             valid && files.changedOutside() ? tr("Differences…") : QString());
    });
    connect(this, &MessageStrip::actionRequested, &files, &CaseFiles::reload);
    connect(this, &MessageStrip::secondRequested, &files, &CaseFiles::askAboutFile);
}

} // namespace touchdown
