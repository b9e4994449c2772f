// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lists/gallery.h"

#include <algorithm>
#include <utility>

#include <QPainter>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QTextDocument>

#include "ui/style/foreign_text.h"
#include "ui/style/readable.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int itemMargin = 5;                                   // around an item and between picture and text [px]
constexpr QSize pictureSize(120, 80), smallPictureSize(84, 56); // [px]
constexpr int narrow = 330;                                     // a list that is narrower has small pictures [px]
constexpr int itemRole = Qt::UserRole;                          // the index of an item; none of a heading

class GalleryDelegate : public QStyledItemDelegate {
public:
    explicit GalleryDelegate(Gallery& gallery) : QStyledItemDelegate(&gallery), gallery_(gallery) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const GalleryItem* item = gallery_.at(index.row());
        QStyleOptionViewItem frame = option;
        initStyleOption(&frame, index);
        if (item == nullptr) return paintHeading(painter, frame);
        frame.text.clear();
        frame.widget->style()->drawControl(QStyle::CE_ItemViewItem, &frame, painter, frame.widget);
        const QRect picture(option.rect.topLeft() + QPoint(itemMargin, itemMargin), sizeOfPicture(*item));
        paintPicture(painter, option, *item, picture);
        OwnDocument text;
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        layOut(text, option, *item, option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter->save();
        painter->translate(picture.topRight() + QPoint(2 * itemMargin, 0));
        text.drawContents(painter);
        painter->restore();
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int width = gallery_.viewport()->width() - 2 * gallery_.spacing();
        const GalleryItem* item = gallery_.at(index.row());
        if (item == nullptr) return {width, 2 * option.fontMetrics.height()};
        OwnDocument text;
        layOut(text, option, *item, {});
        const int height = std::max(sizeOfPicture(*item).height(), static_cast<int>(text.size().height()));
        return {width, height + 2 * itemMargin};
    }

private:
    /// No size where there is none: the text has its place.
    QSize sizeOfPicture(const GalleryItem& item) const
    {
        if (item.picture.isNull()) return {0, 0};
        return gallery_.viewport()->width() < narrow ? smallPictureSize : pictureSize;
    }

    static void paintHeading(QPainter* painter, const QStyleOptionViewItem& option)
    {
        painter->save();
        QFont font = option.font;
        font.setWeight(QFont::DemiBold);
        painter->setFont(font);
        painter->setPen(meaningColours(option.palette).muted);
        painter->drawText(option.rect.adjusted(itemMargin, 0, -itemMargin, -2), Qt::AlignLeft | Qt::AlignBottom,
                          option.text);
        painter->restore();
    }
    /// On the ground of a list also where the item is chosen, for which the pictures are drawn.
    static void paintPicture(QPainter* painter, const QStyleOptionViewItem& option, const GalleryItem& item,
                             const QRect& box)
    {
        if (item.picture.isNull()) return;
        painter->save();
        painter->fillRect(box, option.palette.color(QPalette::Base));
        painter->drawPixmap(box, item.picture);
        painter->setPen(option.palette.color(QPalette::Mid));
        painter->drawRect(box.adjusted(0, 0, -1, -1));
        painter->restore();
    }
    void layOut(QTextDocument& text, const QStyleOptionViewItem& option, const GalleryItem& item,
                const QColor& colour) const
    {
        text.setDefaultFont(option.font);
        text.setDocumentMargin(0.0);
        text.setTextWidth(gallery_.viewport()->width() - 2 * gallery_.spacing() - sizeOfPicture(item).width() -
                          4 * itemMargin);
        text.setHtml(QStringLiteral("<div style='color:%1'><b>%2</b><br>%3</div>")
                         .arg(colour.name(), escaped(item.title), escaped(item.about)));
    }

    Gallery& gallery_;
};

} // namespace

Gallery::Gallery(QWidget* parent) : QListWidget(parent)
{
    setFrameShape(QFrame::NoFrame);
    setResizeMode(QListView::Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setSpacing(2);
    setItemDelegate(new GalleryDelegate(*this));
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* row) {
        if (const GalleryItem* item = at(this->row(row))) emit chosen(item->name);
    });
}

void Gallery::setItems(std::vector<GalleryItem> items)
{
    clear();
    items_ = std::move(items);
    QString theme;
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (items_[i].theme != theme) {
            theme = items_[i].theme;
            auto* heading = new QListWidgetItem(theme, this);
            heading->setFlags(Qt::NoItemFlags);
        }
        const GalleryItem& item = items_[i];
        auto* row =
            new QListWidgetItem(item.about.isEmpty() ? item.title : item.title + QLatin1Char('\n') + item.about, this);
        row->setData(itemRole, static_cast<int>(i));
    }
}

void Gallery::setWords(const QString& words)
{
    const QStringList wanted = words.split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
    QListWidgetItem* heading = nullptr;
    for (int row = 0; row < count(); ++row) {
        const GalleryItem* item = at(row);
        if (item == nullptr) {
            heading = this->item(row);
            heading->setHidden(true); // until one of its items is shown
            continue;
        }
        const QString text =
            QStringList{item->name, item->theme, item->title, item->about, item->words}.join(QLatin1Char(' '));
        const bool shown = std::ranges::all_of(
            wanted, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
        this->item(row)->setHidden(!shown);
        if (shown && heading != nullptr) heading->setHidden(false);
    }
    if (currentItem() == nullptr || currentItem()->isHidden()) setCurrentRow(-1);
    setAccessibleDescription(shownNames().isEmpty() ? nothingFound_ : QString());
    viewport()->update();
}

QStringList Gallery::shownNames() const
{
    QStringList names;
    for (int row = 0; row < count(); ++row)
        if (const GalleryItem* each = at(row); each != nullptr && !item(row)->isHidden()) names << each->name;
    return names;
}

const GalleryItem* Gallery::at(int row) const
{
    const QListWidgetItem* entry = item(row);
    const QVariant index = entry == nullptr ? QVariant() : entry->data(itemRole);
    return index.isValid() ? &items_[index.toUInt()] : nullptr;
}

void Gallery::paintEvent(QPaintEvent* event)
{
    QListWidget::paintEvent(event);
    if (items_.empty() || !shownNames().isEmpty()) return;
    QPainter painter(viewport());
    painter.setPen(meaningColours(palette()).muted);
    painter.drawText(viewport()->rect().adjusted(2 * itemMargin, 2 * itemMargin, -2 * itemMargin, -2 * itemMargin),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, nothingFound_);
}

void Gallery::resizeEvent(QResizeEvent* event)
{
    QListWidget::resizeEvent(event);
    scheduleDelayedItemsLayout(); // texts wrap at another place
}

QPixmap galleryPicture(const QString& name)
{
    QPixmap picture(QStringLiteral(":/gallery/%1.png").arg(name));
    picture.setDevicePixelRatio(2.0);
    return picture;
}

QString withoutLicence(const std::string& text)
{
    static const QRegularExpression licence(QStringLiteral("^# SPDX[^\n]*\n(#[ \t]*\n)?"));
    return QString::fromStdString(text).remove(licence);
}

QString firstSentence(const std::string& text)
{
    QString comment;
    for (const QString& line : withoutLicence(text).split(QLatin1Char('\n'))) {
        const QString words = line.mid(1).trimmed();
        if (!line.startsWith(QLatin1Char('#')) || (words.isEmpty() && !comment.isEmpty())) break;
        comment += words + QLatin1Char(' ');
    }
    static const QRegularExpression end(QStringLiteral("(?<!Fig)(?<!Figs)(?<!Eq)[.?](?=\\s)"));
    const qsizetype last = comment.indexOf(end);
    QString sentence = last < 0 ? comment.trimmed() : comment.left(last + 1);
    if (!sentence.isEmpty() && last < 0) sentence += QLatin1Char('.');
    return readable(sentence.toStdString());
}

} // namespace touchdown
