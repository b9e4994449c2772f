// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gallery of the sample studies, by kind, the chosen kind first; words narrow it.
#pragma once

#include <span>
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
    void show(std::vector<SampleStudy> samples, std::span<const StudyKind> kinds, const std::string& chosenKind);

    Gallery* gallery() const { return gallery_; }
    QLineEdit* words() const { return words_; }

signals:
    void chosen(const SampleStudy& sample);

private:
    void choose(const QString& name);

    std::vector<SampleStudy> samples_;
    QLineEdit* words_;
    Gallery* gallery_;
};

} // namespace touchdown
