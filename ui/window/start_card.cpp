// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_card.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QSettings>
#include <QToolButton>

#include "ui/style/foreign_text.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr auto startCardKey = "start/card";

QLabel* cardLabel(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    return label;
}

} // namespace

bool StartCard::wanted()
{
    const QSettings settings;
    return settings.value(startCardKey, !settings.contains(QStringLiteral("files/last"))).toBool();
}

StartCard::StartCard(QWidget* parent)
    : QFrame(parent),
      title_(cardLabel(this)),
      watch_(cardLabel(this)),
      tries_(cardLabel(this)),
      lesson_(new QPushButton(tr("Start the lesson"), this)),
      figure_(new QPushButton(tr("See the figures of the paper"), this)),
      open_(new QPushButton(tr("Open your slider…"), this))
{
    setAccessibleName(tr("First steps"));
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setAccessibleName(tr("Close the first steps"));
    close->setToolTip(tr("Close this; Help, First steps brings it back"));
    connect(close, &QToolButton::clicked, this, &StartCard::close);

    auto* head = new QHBoxLayout;
    head->addWidget(title_, 1);
    head->addWidget(close, 0, Qt::AlignTop);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {lesson_, figure_, open_}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 8, 8, 8);
    layout->setSpacing(4);
    layout->addLayout(head);
    layout->addWidget(watch_);
    layout->addWidget(tries_);
    layout->addLayout(buttons);
    write();
    hide();
}

void StartCard::open()
{
    QSettings().setValue(startCardKey, false);
    show();
}

void StartCard::close()
{
    if (isHidden()) return;
    hide();
    emit closed();
}

QString StartCard::text() const
{
    QString all;
    for (const QLabel* label : {title_, watch_, tries_}) {
        OwnDocument plain;
        plain.setHtml(label->text());
        all += plain.toPlainText() + u'\n';
    }
    return all;
}

void StartCard::write()
{
    const MeaningColours colours = meaningColours(palette());
    const auto paragraph = [&](const QString& word, const QString& text) {
        return QStringLiteral("<b style='color:%1'>%2</b> %3").arg(colours.change.name(), word, text);
    };
    title_->setText(QStringLiteral("<b>%1</b>")
                        .arg(tr("A slider falls from 250 nm onto a disk. Does it fly again, bounce on, or stick?")));
    watch_->setText(paragraph(
        tr("Watch:"),
        tr("the picture shows the slider on the two springs of its air bearing, and its pad near the disk; the "
           "plot below shows the smallest distance to the disk. At each contact the slider loses energy. It "
           "ends at 7.00 nm and flies.")));
    tries_->setText(
        paragraph(tr("Try:"), tr("at the left set the <i>Static flying height</i> to 5 nm and press F5. The same fall "
                                 "ends in contact, at 3.01 nm: the menisci hold the pad.")));
}

void StartCard::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) write();
}

void StartCard::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor tone = meaningColours(palette()).change;
    QColor wash = tone;
    wash.setAlphaF(0.08F);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.fillRect(rect(), wash);
    painter.fillRect(0, 0, 4, height(), tone);
}

} // namespace touchdown
