// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/result_pages.h"

#include <QSplitter>

namespace touchdown {

void addResultPages(QStackedWidget& pages, QLabel& empty, QWidget* upper, QWidget* lower, const QList<int>& heights)
{
    empty.setWordWrap(true);
    empty.setAlignment(Qt::AlignCenter);
    empty.setMargin(60);
    empty.setAutoFillBackground(true);
    empty.setBackgroundRole(QPalette::Base);
    auto* split = new QSplitter(Qt::Vertical, &pages);
    split->addWidget(upper);
    split->addWidget(lower);
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 0);
    split->setSizes(heights);
    split->setChildrenCollapsible(false);
    pages.addWidget(&empty);
    pages.addWidget(split);
}

} // namespace touchdown
