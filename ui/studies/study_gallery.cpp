// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_gallery.h"

#include <QPainter>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QTextDocument>

#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr int itemMargin = 4; // around the text of an item [px]

/// The first line of an item is its title, in bold.
class TitledItem : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyleOptionViewItem frame = option;
        initStyleOption(&frame, index);
        frame.text.clear();
        frame.widget->style()->drawControl(QStyle::CE_ItemViewItem, &frame, painter, frame.widget);
        QTextDocument text;
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        layOut(text, option, index, option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter->save();
        painter->translate(option.rect.topLeft() + QPoint(itemMargin, itemMargin));
        text.drawContents(painter);
        painter->restore();
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QTextDocument text;
        layOut(text, option, index, {});
        return {static_cast<int>(text.textWidth()), static_cast<int>(text.size().height()) + 2 * itemMargin};
    }

private:
    static void layOut(QTextDocument& text, const QStyleOptionViewItem& option, const QModelIndex& index,
                       const QColor& colour)
    {
        const QStringList lines = index.data().toString().split(QLatin1Char('\n'));
        const auto* list = qobject_cast<const QListWidget*>(option.widget);
        text.setDefaultFont(option.font);
        text.setDocumentMargin(0.0);
        text.setTextWidth(list->viewport()->width() - 2 * itemMargin - 2 * list->spacing());
        text.setHtml(QStringLiteral("<div style='color:%1'><b>%2</b><br>%3</div>")
                         .arg(colour.name(), lines.front().toHtmlEscaped(),
                              lines.mid(1).join(QLatin1Char(' ')).toHtmlEscaped()));
    }
};

} // namespace

QString withoutLicence(const std::string& studyText)
{
    static const QRegularExpression licence(QStringLiteral("^# SPDX[^\n]*\n(#[ \t]*\n)?"));
    return QString::fromStdString(studyText).remove(licence);
}

QString firstSentence(const std::string& studyText)
{
    QString comment;
    for (const QString& line : withoutLicence(studyText).split(QLatin1Char('\n'))) {
        if (!line.startsWith(QLatin1Char('#'))) break;
        comment += line.mid(1).trimmed() + QLatin1Char(' ');
    }
    static const QRegularExpression end(QStringLiteral("(?<!Fig)(?<!Figs)(?<!Eq)[.:](?=\\s)"));
    const qsizetype last = comment.indexOf(end);
    QString sentence = last < 0 ? comment.trimmed() : comment.left(last);
    if (!sentence.isEmpty()) sentence += QLatin1Char('.');
    return readable(sentence.toStdString());
}

StudyGallery::StudyGallery(QWidget* parent) : QListWidget(parent)
{
    setAccessibleName(tr("Sample studies"));
    setFrameShape(QFrame::NoFrame);
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setResizeMode(QListView::Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSpacing(3);
    setItemDelegate(new TitledItem(this));
    const auto choose = [this](QListWidgetItem* item) { emit chosen(samples_[std::size_t(row(item))]); };
    connect(this, &QListWidget::itemActivated, this, choose);
    connect(this, &QListWidget::itemClicked, this, choose);
}

void StudyGallery::setSamples(const std::vector<SampleStudy>& samples, const std::string& kind)
{
    clear();
    samples_.clear();
    for (const SampleStudy& sample : samples) {
        if (sample.kind != kind) continue;
        const QString about = firstSentence(sample.text);
        samples_.push_back(sample);
        addItem(QString::fromStdString(sample.title) + (about.isEmpty() ? QString() : QLatin1Char('\n') + about));
    }
}

void StudyGallery::resizeEvent(QResizeEvent* event)
{
    QListWidget::resizeEvent(event);
    scheduleDelayedItemsLayout(); // texts wrap at another place
}

} // namespace touchdown
