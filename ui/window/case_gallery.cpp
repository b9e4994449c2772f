// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/case_gallery.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "ui/case/parameter_text.h"
#include "ui/plot/colour_scale.h"
#include "ui/slider/rail_drawing.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr std::size_t fewItems = 12; // are looked through without words

struct ThemeOfCases {
    const char* title;
    std::vector<const char*> prefixes; // of the names of its cases
};
const std::array<ThemeOfCases, 5> themes{{
    {QT_TRANSLATE_NOOP("CaseGallery", "Figures of the paper"), {"fig", "table"}},
    {QT_TRANSLATE_NOOP("CaseGallery", "Films"), {"film"}},
    {QT_TRANSLATE_NOOP("CaseGallery", "Contacts"), {"contact"}},
    {QT_TRANSLATE_NOOP("CaseGallery", "Advice"), {"advise"}},
    {QT_TRANSLATE_NOOP("CaseGallery", "Textbook"), {""}}, // all others
}};

std::size_t themeOf(const QString& name)
{
    const auto fits = [&name](const char* prefix) { return name.startsWith(QLatin1String(prefix)); };
    const auto found = std::ranges::find_if(
        themes, [&](const ThemeOfCases& theme) { return std::ranges::any_of(theme.prefixes, fits); });
    return static_cast<std::size_t>(found - themes.begin());
}

/// "air film asperities"
QString wordsOf(const Case& c)
{
    return valueText(c, *findParameter("model"), QLocale()) + QLatin1Char(' ') +
           valueText(c, *findParameter("contact"), QLocale());
}

/// The surface from below: base and rails by their recess, the pads lightest, as the plan has them.
QPixmap surfacePixmap(const Case& c, const QPalette& palette)
{
    constexpr int width = 96, height = 72, margin = 4; // [px]
    QPixmap picture(width, height);
    picture.fill(palette.color(QPalette::Base));
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale =
        std::min((width - 2 * margin) / c.slider.length, (height - 2 * margin) / c.slider.width); // [px/m]
    painter.translate(0.5 * (width - scale * c.slider.length), 0.5 * (height + scale * c.slider.width));
    painter.scale(scale, -scale);
    QPen outline(palette.color(QPalette::Text), 1.0);
    outline.setCosmetic(true);
    painter.setPen(outline);
    const ColourScale colours = ColourScale::throughLevels(ColourMap::Mako, recessLevels(c.surface)).reversed();
    painter.setBrush(QColor(colours.colour(c.surface.baseRecess)));
    painter.drawRect(QRectF(0.0, 0.0, c.slider.length, c.slider.width));
    for (const Rail& rail : c.surface.rails) {
        painter.setBrush(QColor(colours.colour(rail.recess.front())));
        painter.drawPolygon(railPolygon(rail));
    }
    return picture;
}

} // namespace

std::vector<GalleryItem> sampleCaseItems()
{
    std::array<std::vector<GalleryItem>, themes.size()> byTheme;
    for (const SampleCase& sample : sampleCases()) {
        const QString name = QString::fromStdString(sample.name);
        const std::size_t theme = themeOf(name);
        const Case c = parseCase(sample.text, sample.name).value;
        byTheme[theme].push_back({name, CaseGallery::tr(themes[theme].title), readable(c.title),
                                  firstSentence(sample.text), galleryPicture(QStringLiteral("case_") + name),
                                  wordsOf(c)});
    }
    std::vector<GalleryItem> all;
    for (std::vector<GalleryItem>& items : byTheme) std::ranges::move(items, std::back_inserter(all));
    return all;
}

std::vector<GalleryItem> newCaseItems(const QPalette& palette)
{
    std::vector<GalleryItem> items;
    for (const SampleCase& slider : sliderTemplates()) {
        const Case c = parseCase(slider.text, slider.name).value;
        items.push_back({QString::fromStdString(slider.name), CaseGallery::tr("Sliders on an air film"),
                         readable(c.title), firstSentence(slider.text), surfacePixmap(c, palette), wordsOf(c)});
    }
    items.push_back({QString(),
                     CaseGallery::tr("Other"),
                     CaseGallery::tr("Nothing but defaults"),
                     CaseGallery::tr("A slider on springs; the model can be changed to an air film, with an empty "
                                     "surface, or to a contact alone."),
                     {}});
    return items;
}

CaseGallery::CaseGallery(const QString& title, std::vector<GalleryItem> items, QWidget* parent)
    : QDialog(parent), words_(new QLineEdit(this)), gallery_(new Gallery(this))
{
    setWindowTitle(title);
    words_->setHidden(items.size() < fewItems);
    words_->setPlaceholderText(tr("Words to look for, as menisci or rough disk"));
    words_->setAccessibleName(tr("Words that a sample case has"));
    words_->setClearButtonEnabled(true);
    words_->installEventFilter(this);
    gallery_->setAccessibleName(tr("Cases to choose from"));
    gallery_->setNothingFound(tr("No case has all of these words."));
    gallery_->setItems(std::move(items));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    open_ = buttons->button(QDialogButtonBox::Open);
    open_->setText(tr("Open"));
    open_->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(words_);
    layout->addWidget(gallery_, 1);
    layout->addWidget(buttons);
    resize(720, 640);
    connect(words_, &QLineEdit::textChanged, this, [this](const QString& words) {
        gallery_->setWords(words);
        chooseFirst();
    });
    connect(gallery_, &Gallery::currentRowChanged, this, &CaseGallery::updateOpen);
    connect(gallery_, &Gallery::chosen, this, &CaseGallery::choose);
    connect(open_, &QPushButton::clicked, this, [this] {
        if (const GalleryItem* item = gallery_->at(gallery_->currentRow())) choose(item->name);
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    updateOpen();
}

void CaseGallery::choose(const QString& name)
{
    accept();
    emit chosen(name);
}

/// So that the key Enter opens it.
void CaseGallery::chooseFirst()
{
    int row = 0;
    while (row < gallery_->count() && (gallery_->at(row) == nullptr || gallery_->item(row)->isHidden())) ++row;
    gallery_->setCurrentRow(row < gallery_->count() ? row : -1);
    updateOpen();
}

void CaseGallery::updateOpen() { open_->setEnabled(gallery_->at(gallery_->currentRow()) != nullptr); }

bool CaseGallery::eventFilter(QObject* watched, QEvent* event)
{
    // The arrow leads from the words to the first case that has them.
    if (watched == words_ && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down) {
        gallery_->setFocus();
        if (gallery_->currentRow() < 0) chooseFirst();
        return true;
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace touchdown
