// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/changed_study.h"

#include "core/formats/text_file.h"
#include "core/studies/study/study_head.h"
#include "ui/style/changed_file_question.h"
#include "ui/style/translate.h"

namespace touchdown {

bool asksAboutStudy(QWidget& window, const QString& file, const FileIdentity& identity, const QString& text,
                    const ChangedStudyAnswers& answers)
{
    const FileNow now = fileNow(file.toStdString(), identity);
    if (now == FileNow::Same || now == FileNow::Gone) return false;
    const auto content = readTextFile(file.toStdString(), maximumStudyFileSize);
    const auto* bytes = std::get_if<std::string>(&content);
    const std::string shown = bytes ? *bytes : std::string();
    const QStringList theirs = QString::fromStdString(shown).split(u'\n'), own = text.split(u'\n');
    ChangedFile question;
    question.sentence = changeOfFile(file, now);
    question.heading = tr("Lines that differ:");
    for (const QString& line : theirs)
        if (!own.contains(line)) question.differences << tr("in the file: %1").arg(line);
    for (const QString& line : own)
        if (!theirs.contains(line)) question.differences << tr("in this window: %1").arg(line);
    question.writeOver = [answers, shown] { answers.writeOver(shown); };
    if (bytes) question.reload = [answers, shown] { answers.reload(shown); };
    question.saveAs = answers.saveAs;
    askAboutChangedFile(window, question);
    return true;
}

} // namespace touchdown
