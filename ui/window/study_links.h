// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a field of the case to a study that varies it, and from a study to a case that it found or solved.
#pragma once

#include <functional>

class QWidget;

namespace touchdown {

class CaseEdits;
class CaseFiles;
class CasePanel;
class MessageStrip;
class StudyWindow;

/// All must last.
struct StudyLinkParts {
    QWidget& window; // over which it asks
    StudyWindow& studies;
    CasePanel& panel;
    CaseEdits& edits;
    CaseFiles& files;
    MessageStrip& messages;
};
/// `showStudies` brings the page of the studies.
void linkStudies(const StudyLinkParts& parts, const std::function<void()>& showStudies);

} // namespace touchdown
