// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_samples.h"

#include <algorithm>
#include <utility>

#include <QVBoxLayout>

#include "ui/style/readable.h"

namespace touchdown {

StudySamples::StudySamples(QWidget* parent) : QWidget(parent), words_(new QLineEdit(this)), gallery_(new Gallery(this))
{
    gallery_->setAccessibleName(tr("Sample studies"));
    gallery_->setNothingFound(tr("No study has all of these words."));
    words_->setPlaceholderText(tr("Words to look for"));
    words_->setAccessibleName(tr("Words that a sample study has"));
    words_->setClearButtonEnabled(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(words_);
    layout->addWidget(gallery_, 1);
    connect(words_, &QLineEdit::textChanged, gallery_, &Gallery::setWords);
    connect(gallery_, &Gallery::chosen, this, &StudySamples::choose);
}

void StudySamples::setSamples(std::vector<SampleStudy> samples, std::vector<StudyKind> kinds, std::string chosenKind)
{
    samples_ = std::move(samples);
    kinds_ = std::move(kinds);
    chosenKind_ = std::move(chosenKind);
    if (!isVisible()) fill();
}

void StudySamples::fill()
{
    std::vector<GalleryItem> items;
    for (const bool chosen : {true, false})
        for (const StudyKind& kind : kinds_) {
            if ((kind.name == chosenKind_) != chosen) continue;
            for (const SampleStudy& sample : samples_) {
                if (sample.kind != kind.name) continue;
                const QString name = QString::fromStdString(sample.name);
                items.push_back({name, readable(kind.title), readable(sample.title), firstSentence(sample.text),
                                 galleryPicture(QStringLiteral("study_") + name)});
            }
        }
    gallery_->setItems(std::move(items));
    gallery_->setWords(words_->text());
}

void StudySamples::showEvent(QShowEvent* event)
{
    fill();
    QWidget::showEvent(event);
}

void StudySamples::choose(const QString& name)
{
    const auto found = std::ranges::find(samples_, name.toStdString(), &SampleStudy::name);
    if (found != samples_.end()) emit chosen(SampleStudy(*found)); // the list may change with it
}

} // namespace touchdown
