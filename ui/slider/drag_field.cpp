// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/drag_field.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>

#include "core/formats/units.h"

namespace touchdown {

std::optional<double> typedLength(QString text)
{
    text = text.trimmed();
    text.replace(QChar(0x2212), QLatin1Char('-'));
    for (const char16_t micro : {u'\u00B5', u'\u03BC'}) text.replace(QChar(micro), QLatin1Char('u'));
    text.replace(QLocale().decimalPoint(), QLatin1String("."));
    bool isNumber = false;
    if (const double number = text.toDouble(&isNumber); isNumber && std::isfinite(number))
        return number * unitFactor("um");
    const auto quantity = parseQuantity(text.toStdString(), "m");
    if (const double* length = std::get_if<double>(&quantity)) return *length;
    return {};
}

DragField::DragField(QWidget* parent) : QFrame(parent)
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 3, 6, 3);
    for (int i = 0; i < 2; ++i) {
        const Entry entry{new QLabel(this), new QLineEdit(this)};
        entry.text->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("−0000.000")) + 12);
        layout->addWidget(entry.name);
        layout->addWidget(entry.text);
        connect(entry.text, &QLineEdit::textEdited, this, &DragField::changed);
        entries_.push_back(entry);
    }
    layout->addWidget(new QLabel(tr("µm"), this));
    hide();
}

void DragField::open(const QPoint& beside, const std::vector<DragWay>& ways, int first, const QString& typed)
{
    ways_ = ways;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const auto& [name, text] = entries_[i];
        const bool shown = i < ways.size();
        name->setVisible(shown);
        text->setVisible(shown);
        name->setText(shown ? ways[i].name : QString());
        text->setAccessibleName(tr("Distance %1").arg(name->text()));
        text->setText(static_cast<int>(i) == first ? typed : QStringLiteral("0"));
    }
    adjustSize();
    const QPoint room(parentWidget()->width() - width(), parentWidget()->height() - height());
    const QPoint at = beside + QPoint(18, 18);
    move(std::clamp(at.x(), 0, std::max(0, room.x())), std::clamp(at.y(), 0, std::max(0, room.y())));
    show();
    raise();
    entries_[static_cast<std::size_t>(first)].text->setFocus();
}

void DragField::selectText()
{
    for (const Entry& entry : entries_) entry.text->selectAll();
}

std::optional<SurfaceShift> DragField::shift() const
{
    SurfaceShift by;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
        const std::optional<double> length = typedLength(entries_[i].text->text());
        if (!length) return {};
        by.x += *length * ways_[i].direction.x;
        by.y += *length * ways_[i].direction.y;
    }
    return by;
}

bool DragField::event(QEvent* event)
{
    // Before actions of the window with the same keys.
    if (event->type() == QEvent::ShortcutOverride) switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Escape:
        case Qt::Key_Return:
        case Qt::Key_Enter: event->accept();
        }
    return QFrame::event(event);
}

bool DragField::focusNextPrevChild(bool)
{
    const bool second = entries_[1].text->hasFocus() || entries_[1].text->isHidden();
    QLineEdit* next = entries_[second ? 0 : 1].text;
    next->setFocus(Qt::TabFocusReason);
    next->selectAll();
    return true;
}

void DragField::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape: emit givenBack(); break;
    case Qt::Key_Return:
    case Qt::Key_Enter: emit taken(); break;
    default: break; // nothing else reaches the plan below
    }
}

} // namespace touchdown
