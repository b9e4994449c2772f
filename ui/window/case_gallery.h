// SPDX-License-Identifier: GPL-3.0-or-later
//
// All sample cases with a small picture of what comes of them, to choose the one that is opened.
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QPushButton>

#include "ui/lists/gallery.h"

namespace touchdown {

class CaseGallery : public QDialog {
    Q_OBJECT

public:
    explicit CaseGallery(QWidget* parent);

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

} // namespace touchdown
