// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample studies of a kind: each with its title and what it shows in a sentence.
#pragma once

#include <string>
#include <vector>

#include <QListWidget>

#include "core/studies/study/sample_study.h"

namespace touchdown {

class StudyGallery : public QListWidget {
    Q_OBJECT

public:
    explicit StudyGallery(QWidget* parent = nullptr);
    /// Only those of this kind are shown.
    void setSamples(const std::vector<SampleStudy>& samples, const std::string& kind);

signals:
    void chosen(const SampleStudy& sample);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    std::vector<SampleStudy> samples_; // a row each
};

/// The first sentence of the comment at the head of a study's text; empty if there is none.
QString firstSentence(const std::string& studyText);
/// The text without its licence line.
QString withoutLicence(const std::string& studyText);

} // namespace touchdown
