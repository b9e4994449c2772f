// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases with a small picture each, to choose the one that is opened: all sample cases, or what a new case begins with.
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QPushButton>

#include "ui/lists/gallery.h"

namespace touchdown {

class CaseGallery : public QDialog {
    Q_OBJECT

public:
    CaseGallery(const QString& title, std::vector<GalleryItem> items, QWidget* parent);

    QLineEdit* words() const { return words_; }
    Gallery* gallery() const { return gallery_; }
    QPushButton* openButton() const { return open_; }

signals:
    /// The dialog closes.
    void chosen(const QString& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void choose(const QString& name);
    void chooseFirst();
    void updateOpen();

    QLineEdit* words_;
    Gallery* gallery_;
    QPushButton* open_;
};

/// The sample cases by theme, in the order of the paper within each.
std::vector<GalleryItem> sampleCaseItems();

/// Sliders to begin a design with, drawn from below in the colours of the palette, and, without a name, the case that
/// is all defaults.
std::vector<GalleryItem> newCaseItems(const QPalette& palette);

} // namespace touchdown
