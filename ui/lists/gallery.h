// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples to choose from, grouped by theme: a small picture, a title and a sentence each; words narrow the list.
#pragma once

#include <string>
#include <vector>

#include <QListWidget>
#include <QPixmap>

namespace touchdown {

struct GalleryItem {
    QString name;  // by which it is chosen
    QString theme; // items of a theme follow each other
    QString title;
    QString about;   // a sentence; may be empty
    QPixmap picture; // null: the text has its place
    QString words{}; // by which it is found, too
};

class Gallery : public QListWidget {
    Q_OBJECT

public:
    explicit Gallery(QWidget* parent = nullptr);

    void setItems(std::vector<GalleryItem> items);
    /// Shows the items that have all of these words in name, theme, title, sentence or words of theirs.
    void setWords(const QString& words);
    /// Said where no item has the words.
    void setNothingFound(const QString& sentence) { nothingFound_ = sentence; }
    /// Of those that are shown, in their order.
    QStringList shownNames() const;

    /// The item of a row of the list; nullptr for the heading of a theme.
    const GalleryItem* at(int row) const;

signals:
    /// By a double click, or the key Enter.
    void chosen(const QString& name);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::vector<GalleryItem> items_;
    QString nothingFound_;
};

/// The picture of a sample in the resources of the program, "case_fig10a"; null if there is none.
QPixmap galleryPicture(const QString& name);
/// The first sentence of the comment at the head of a text; empty if there is none.
QString firstSentence(const std::string& text);
/// The text without its licence line.
QString withoutLicence(const std::string& text);

} // namespace touchdown
