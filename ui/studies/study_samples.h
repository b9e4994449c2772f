// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gallery of the sample studies, by kind, first the kind that is chosen when the gallery appears; words narrow it.
#pragma once

#include <string>
#include <vector>

#include <QLineEdit>
#include <QWidget>

#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "ui/lists/gallery.h"

namespace touchdown {

class StudySamples : public QWidget {
    Q_OBJECT

public:
    explicit StudySamples(QWidget* parent = nullptr);
    /// While they are seen they keep their order.
    void setSamples(std::vector<SampleStudy> samples, std::vector<StudyKind> kinds, std::string chosenKind);

    Gallery* gallery() const { return gallery_; }
    QLineEdit* words() const { return words_; }

signals:
    void chosen(const SampleStudy& sample);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fill();
    void choose(const QString& name);

    std::vector<SampleStudy> samples_;
    std::vector<StudyKind> kinds_;
    std::string chosenKind_;
    QLineEdit* words_;
    Gallery* gallery_;
};

} // namespace touchdown
