// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/study_links.h"

#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/style/translate.h"
#include "ui/window/apply_question.h"

namespace touchdown {

namespace {

void apply(const StudyLinkParts& parts, const Case& found, const QString& title)
{
    const bool isOpen = parts.files.isOpen(found);
    askToApply(parts.window, parts.edits.value(), found, !isOpen, title, [parts, found, title, isOpen] {
        parts.files.use(found, title, tr("apply the study: %1").arg(title), [parts, isOpen] {
            QString text = tr("The parameters are now those of the case that the study found.");
            if (isOpen) text += tr(" Undo restores the previous ones.");
            parts.messages.show(MessageStrip::Kind::Success, text);
        });
    });
}

} // namespace

void linkStudies(const StudyLinkParts& parts, const std::function<void()>& showStudies)
{
    QObject::connect(&parts.panel, &CasePanel::varyWanted, &parts.studies, [parts, showStudies](const QString& key) {
        showStudies();
        parts.studies.editor()->vary(key.toStdString());
    });
    QObject::connect(
        &parts.studies, &StudyWindow::caseRequested, &parts.files,
        [parts](const Case& c, const QString& name) { parts.files.use(c, name, tr("open the case of %1").arg(name)); });
    QObject::connect(&parts.studies, &StudyWindow::runRequested, &parts.files, &CaseFiles::resultsFileChosen);
    QObject::connect(&parts.studies, &StudyWindow::applyRequested, &parts.files,
                     [parts](const Case& found, const QString& title) { apply(parts, found, title); });
}

} // namespace touchdown
