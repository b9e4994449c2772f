// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/copied_text.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/style/foreign_text.h"
#include "ui/style/result_table.h"

namespace touchdown {

CopiedText::CopiedText(const QString& textName, const QString& copyName, QWidget* parent)
    : QWidget(parent),
      text_(new OwnTextBrowser(this)),
      copy_(quietButton(tr("Copy"), tr("Copy all numbers for a spreadsheet"), copyName, this))
{
    text_->setAccessibleName(textName);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenLinks(false);
    text_->document()->setDocumentMargin(8);
    connect(copy_, &QToolButton::clicked, this, &CopiedText::copy);

    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(6, 0, 6, 0);
    tools->addStretch(1);
    tools->addWidget(copy_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(2);
    layout->addWidget(text_, 1);
    layout->addLayout(tools);
}

void CopiedText::copy() const { QGuiApplication::clipboard()->setText(plainText()); }

void CopiedText::write()
{
    text_->setHtml(html());
    copy_->setEnabled(!plainText().isEmpty());
}

void CopiedText::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) write();
}

} // namespace touchdown
