// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/message_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "ui/style/theme.h"

namespace touchdown {

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent),
      mark_(new QLabel(this)),
      text_(new QLabel(this)),
      action_(new QPushButton(this)),
      second_(new QPushButton(this))
{
    setAccessibleName(tr("Messages"));
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text_->setFocusPolicy(Qt::ClickFocus);
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setAccessibleName(tr("Close the message"));
    close->setToolTip(tr("Close the message"));
    close->setFocusPolicy(Qt::NoFocus);
    connect(close, &QToolButton::clicked, this, [this] { clear(); });
    connect(action_, &QPushButton::clicked, this, &MessageStrip::actionRequested);
    connect(second_, &QPushButton::clicked, this, &MessageStrip::secondRequested);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 5, 6, 5);
    layout->setSpacing(8);
    layout->addWidget(mark_, 0, Qt::AlignTop);
    layout->addWidget(text_, 1);
    for (QPushButton* button : {action_, second_}) {
        button->setAutoDefault(false);
        button->hide();
        layout->addWidget(button, 0, Qt::AlignVCenter);
    }
    layout->addWidget(close, 0, Qt::AlignTop);
    keepPlace(true);
    hide();
}

void MessageStrip::keepPlace(bool kept)
{
    // The page above keeps its place when a message of one line comes or goes.
    QSizePolicy keeping = sizePolicy();
    keeping.setRetainSizeWhenHidden(kept);
    setSizePolicy(keeping);
}

void MessageStrip::show(Kind kind, const QString& text, const QString& action, Topic topic, const QString& second)
{
    kind_ = kind;
    topic_ = topic;
    text_->setText(text);
    for (const auto& [button, words] : {std::pair(action_, action), std::pair(second_, second)}) {
        button->setText(words);
        button->setVisible(!words.isEmpty());
    }
    colour();
    setVisible(true);
}

void MessageStrip::clear(Topic topic)
{
    if (topic_ == topic) clear();
}

void MessageStrip::clear()
{
    topic_ = Topic::Any;
    text_->clear();
    action_->hide();
    second_->hide();
    setVisible(false);
}

void MessageStrip::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colour();
}

void MessageStrip::colour()
{
    const MeaningColours colours = meaningColours(palette());
    const auto mark = [this](const QString& sign, const QColor& tone) {
        mark_->setText(sign);
        setTextColour(mark_, tone);
    };
    switch (kind_) {
    case Kind::Information: mark(QStringLiteral("ℹ"), colours.change); break;
    case Kind::Success: mark(QStringLiteral("✓"), colours.success); break;
    case Kind::Warning: mark(QStringLiteral("⚠"), colours.warning); break;
    case Kind::Failure: mark(QStringLiteral("✕"), colours.failure); break;
    }
    update();
}

void MessageStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor tone = mark_->palette().color(QPalette::WindowText);
    QColor wash = tone;
    wash.setAlphaF(0.08F);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.fillRect(rect(), wash);
    painter.fillRect(0, 0, 4, height(), tone);
}

} // namespace touchdown
