// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/message_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>

#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int scrollBar = 20; // room for it beside the words [px]

} // namespace

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent),
      mark_(new QLabel(this)),
      line_(new QLabel(this)),
      more_(new QToolButton(this)),
      action_(new QPushButton(this)),
      second_(new QPushButton(this)),
      whole_(new QPlainTextEdit(parent ? parent : this))
{
    setAccessibleName(tr("Messages"));
    line_->setMinimumWidth(1);
    line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    line_->installEventFilter(this);
    more_->setText(tr("More"));
    more_->setCheckable(true);
    more_->setAutoRaise(true);
    more_->setToolTip(tr("Show all of the message"));
    more_->setFocusPolicy(Qt::TabFocus);
    QSizePolicy keeping = more_->sizePolicy();
    keeping.setRetainSizeWhenHidden(true); // the line has one width
    more_->setSizePolicy(keeping);
    more_->hide();
    connect(more_, &QToolButton::toggled, this, &MessageStrip::showWhole);
    whole_->setReadOnly(true);
    whole_->setAccessibleName(tr("All of the message"));
    whole_->setFrameShape(QFrame::StyledPanel);
    whole_->hide();
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
    layout->setContentsMargins(12, 2, 6, 2);
    layout->setSpacing(8);
    layout->addWidget(mark_);
    layout->addWidget(line_, 1);
    layout->addWidget(more_);
    for (QPushButton* button : {action_, second_}) {
        button->setAutoDefault(false);
        layout->addWidget(button);
    }
    layout->addWidget(close);
    keepPlace(true);
    fitHeight();
    clear();
}

void MessageStrip::keepPlace(bool kept)
{
    QSizePolicy keeping = sizePolicy();
    keeping.setRetainSizeWhenHidden(kept);
    setSizePolicy(keeping);
}

void MessageStrip::show(Kind kind, const QString& text, const QString& action, Topic topic, const QString& second)
{
    showWhole(false);
    kind_ = kind;
    topic_ = topic;
    text_ = text;
    whole_->setPlainText(text);
    for (const auto& [button, words] : {std::pair(action_, action), std::pair(second_, second)}) {
        button->setText(words);
        button->setVisible(!words.isEmpty());
    }
    colour();
    fitLine();
    setVisible(true);
}

void MessageStrip::clear(Topic topic)
{
    if (topic_ == topic) clear();
}

void MessageStrip::clear()
{
    showWhole(false);
    topic_ = Topic::Any;
    text_.clear();
    action_->hide();
    second_->hide();
    setVisible(false);
}

void MessageStrip::showWhole(bool on)
{
    if (more_->isChecked() != on) return more_->setChecked(on); // which comes back
    whole_->setVisible(on);
    if (!on) return;
    placeWhole();
    whole_->raise();
}

void MessageStrip::placeWhole()
{
    if (whole_->isHidden()) return;
    const QWidget* page = whole_->parentWidget();
    const QRect strip(mapTo(page, QPoint(0, 0)), size());
    const int margin = static_cast<int>(std::ceil(whole_->document()->documentMargin())) + whole_->frameWidth();
    const QRect words = whole_->fontMetrics().boundingRect(QRect(0, 0, strip.width() - 2 * margin - scrollBar, 1),
                                                           Qt::TextWordWrap, text_);
    const int height = std::min(words.height() + line_->fontMetrics().height() / 2 + 2 * margin, strip.top());
    whole_->setGeometry(strip.left(), strip.top() - height, strip.width(), height);
}

/// One line of text, whether or not there are buttons beside it.
void MessageStrip::fitHeight()
{
    const int line = std::max(line_->fontMetrics().height(), action_->sizeHint().height());
    setFixedHeight(line + layout()->contentsMargins().top() + layout()->contentsMargins().bottom());
}

void MessageStrip::fitLine()
{
    const QString line = QString(text_).replace(QLatin1Char('\n'), QStringLiteral(" · "));
    const QString shown = line_->fontMetrics().elidedText(line, Qt::ElideRight, line_->width());
    if (line_->text() != shown) line_->setText(shown);
    const bool cut = shown != line;
    more_->setVisible(cut);
    line_->setTextInteractionFlags(cut ? Qt::NoTextInteraction : Qt::TextSelectableByMouse);
    line_->setCursor(cut ? Qt::PointingHandCursor : Qt::IBeamCursor);
    if (!cut) showWhole(false);
}

void MessageStrip::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colour();
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitHeight();
}

bool MessageStrip::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange) fitLine();
    return QFrame::eventFilter(watched, event);
}

void MessageStrip::mousePressEvent(QMouseEvent* event)
{
    QFrame::mousePressEvent(event);
    if (isCut()) more_->toggle();
}

void MessageStrip::moveEvent(QMoveEvent* event)
{
    QFrame::moveEvent(event);
    placeWhole();
}

void MessageStrip::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    placeWhole();
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
