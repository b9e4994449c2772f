// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lists/record_delegate.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>

#include "ui/lists/record_list.h"
#include "ui/plot/plot_theme.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int margin = 5;       // [px]
constexpr int swatchWidth = 22; // [px]

QFont smaller(const QFont& font)
{
    QFont small = font;
    if (font.pointSizeF() > 0) small.setPointSizeF(font.pointSizeF() * 0.92);
    return small;
}

int lineCount(const QModelIndex& index) { return index.data(RecordList::NoteRole).toString().isEmpty() ? 2 : 3; }

} // namespace

QRect RecordDelegate::checkRect(const QStyleOptionViewItem& option)
{
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    const int size = style->pixelMetric(QStyle::PM_IndicatorWidth, &option, option.widget);
    const int top = option.rect.top() + margin + (option.fontMetrics.height() - size) / 2;
    return {option.rect.left() + margin, top, size, size};
}

void RecordDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    // A fifth of the selection colour keeps the colour of the curve visible.
    const QColor base = item.palette.color(QPalette::Base);
    const QColor tone = item.palette.color(QPalette::Highlight);
    const auto mixed = [](int from, int to) { return from + (to - from) / 5; };
    item.palette.setColor(QPalette::Highlight, QColor(mixed(base.red(), tone.red()), mixed(base.green(), tone.green()),
                                                      mixed(base.blue(), tone.blue())));
    const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
    painter->save();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &item, painter, item.widget);

    const bool shown = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    const MeaningColours meaning = meaningColours(item.palette);
    const QColor ink = item.palette.color(QPalette::Text);

    QStyleOptionButton check;
    check.rect = checkRect(item);
    check.state = QStyle::State_Enabled | (shown ? QStyle::State_On : QStyle::State_Off);
    check.palette = item.palette;
    style->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &check, painter, item.widget);

    const int height = item.fontMetrics.height();
    const QRect inner = item.rect.adjusted(margin, margin, -margin, -margin);
    int left = check.rect.right() + 1 + margin;
    const CurveStyle curve{index.data(RecordList::StyleColourRole).toInt(),
                           index.data(RecordList::StyleDashRole).toInt()};
    const bool speaks = index.data(RecordList::SpeaksRole).toBool();
    QPen pen = speaks ? curvePen(curve, plotTheme(item.palette)) : palePen(curve, plotTheme(item.palette));
    pen.setWidthF(speaks ? 3.0 : 1.5);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(pen);
    if (shown)
        painter->drawLine(QPointF(left, inner.top() + height / 2.0),
                          QPointF(left + swatchWidth, inner.top() + height / 2.0));
    left += swatchWidth + margin;

    const QString result = index.data(RecordList::ResultRole).toString();
    QFont bold = item.font;
    bold.setBold(true);
    const int resultWidth = QFontMetrics(bold).horizontalAdvance(result);
    const QFont small = smaller(item.font);
    const QFontMetrics metrics(small);
    const QRect top(left, inner.top(), inner.right() - left + 1, height);
    QRect line(left, inner.top() + height + 1, top.width(), metrics.height());
    const QString name = index.data(Qt::DisplayRole).toString();
    // A name that has no room beside the result has its line for itself.
    const bool beside = item.fontMetrics.horizontalAdvance(name) + 8 + resultWidth <= top.width();
    painter->setFont(bold);
    painter->setPen(index.data(RecordList::FailedRole).toBool() ? meaning.failure : ink);
    painter->drawText(beside ? top : line, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, result);
    painter->setFont(item.font);
    painter->setPen(ink);
    painter->drawText(top, Qt::AlignLeft | Qt::AlignVCenter,
                      item.fontMetrics.elidedText(name, Qt::ElideMiddle, top.width()));

    painter->setFont(small);
    painter->setPen(meaning.muted);
    QString changes = index.data(RecordList::ChangesRole).toString();
    if (index.data(RecordList::BaselineRole).toBool()) changes = tr("baseline \u00b7 %1").arg(changes);
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                      metrics.elidedText(changes, Qt::ElideRight, line.width() - (beside ? 0 : resultWidth + 8)));
    const QString note = index.data(RecordList::NoteRole).toString();
    if (!note.isEmpty()) {
        line.translate(0, metrics.height());
        QFont italic = small;
        italic.setItalic(true);
        painter->setFont(italic);
        painter->setPen(ink);
        painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                          metrics.elidedText(note, Qt::ElideRight, line.width()));
    }

    if (item.state.testFlag(QStyle::State_HasFocus)) {
        QStyleOptionFocusRect focus;
        focus.QStyleOption::operator=(item);
        focus.rect = item.rect.adjusted(1, 1, -1, -1);
        focus.backgroundColor = item.palette.color(QPalette::Base);
        style->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter, item.widget);
    }
    painter->restore();
}

QSize RecordDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const int small = QFontMetrics(smaller(option.font)).height();
    return {200, 2 * margin + option.fontMetrics.height() + 1 + (lineCount(index) - 1) * small};
}

QWidget* RecordDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const
{
    auto* editor = new QLineEdit(parent);
    editor->setPlaceholderText(tr("Note"));
    editor->setAccessibleName(tr("Note"));
    return editor;
}

void RecordDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    const int height = std::min(editor->sizeHint().height(), option.rect.height());
    editor->setGeometry(option.rect.left(), option.rect.bottom() - height + 1, option.rect.width(), height);
}

bool RecordDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                 const QModelIndex& index)
{
    bool toggle = false;
    if (event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        toggle = mouse->button() == Qt::LeftButton &&
                 checkRect(option).adjusted(-margin, -margin, margin + swatchWidth, margin).contains(mouse->pos());
    } else if (event->type() == QEvent::KeyPress) {
        toggle = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space;
    }
    if (!toggle) return false;
    const bool shown = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    return model->setData(index, shown ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

} // namespace touchdown
