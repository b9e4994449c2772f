// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lists of tables in the form of a study: a heading with the button that adds a row; for each table its texts and
// choices one below the other, its numbers side by side, and the button that removes it.
#include "ui/studies/study_form_view.h"

#include <algorithm>
#include <utility>

#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/style/result_table.h"

namespace touchdown {

QWidget* StudyFormView::makeList(const FormList& list)
{
    auto* box = new QWidget;
    auto* lines = new QVBoxLayout(box);
    lines->setContentsMargins(0, 4, 0, 2);
    lines->setSpacing(3);
    auto* head = new QHBoxLayout;
    const QString name = fieldLabel(list.name), key = QString::fromStdString(list.name);
    auto* heading = new QLabel(list.areDefaults ? tr("%1: the default").arg(name) : name);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    head->addWidget(heading);
    head->addStretch(1);
    auto* button = list.areDefaults
                       ? quietButton(tr("Edit"),
                                     tr("The text names none, so the study takes these rows. Write them into the text"),
                                     tr("Edit: %1").arg(name), box)
                       : quietButton(tr("Add"), tr("Add a row to the study"), tr("Add: %1").arg(name), box);
    connect(button, &QToolButton::clicked, this, [this, key, list] {
        wanted_ = list.name + '[' + std::to_string(list.areDefaults ? 1 : list.rows + 1) + ']';
        list.areDefaults ? emit defaultsWanted() : emit rowAdded(key, list.rows);
    });
    head->addWidget(button);
    lines->addLayout(head);
    lines->addWidget(notes_.emplace_back(list.name, makeProblem()).second);
    for (std::size_t number = 1; number <= list.rows; ++number) lines->addWidget(makeTable(list, number));
    return box;
}

QWidget* StudyFormView::makeTable(const FormList& list, std::size_t number)
{
    auto* box = new QFrame;
    box->setFrameShape(QFrame::StyledPanel);
    box->setEnabled(!list.areDefaults);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(6, 4, 4, 4);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    const std::string table = list.name + '[' + std::to_string(number) + ']';
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(6);
    std::vector<QLabel*> problems{notes_.emplace_back(table, makeProblem()).second};
    int line = 0;
    const auto isNumber = [&](const StudyKey& cell) {
        return tableOf(cell.key) == table && (cell.kind == StudyKeyKind::Number || cell.kind == StudyKeyKind::Integer);
    };
    const bool beside = std::ranges::count_if(fields_.cells, isNumber) > 1;
    for (const StudyKey& cell : fields_.cells) {
        if (tableOf(cell.key) != table) continue;
        const QString name = columnLabel(cell.key);
        const Row& row = addRow(cell, name);
        problems.push_back(row.problem);
        if (beside && isNumber(cell)) {
            auto* column = new QVBoxLayout;
            column->setSpacing(0);
            column->addWidget(row.label);
            column->addWidget(row.input);
            numbers->addLayout(column, 1);
        } else {
            grid->addWidget(row.label, line, 0);
            grid->addWidget(row.input, line++, 1);
        }
    }
    if (!list.areDefaults) {
        const QString name = tr("Remove: %1 %2").arg(fieldLabel(list.name)).arg(number);
        auto* button = quietButton(QStringLiteral("✕"), tr("Remove this row"), name, box);
        connect(button, &QToolButton::clicked, this, [this, list, number] {
            wanted_ = list.name + '[';
            emit rowRemoved(QString::fromStdString(list.name), number);
        });
        grid->addWidget(button, 0, 2, Qt::AlignTop);
    }
    grid->addLayout(numbers, line++, 0, 1, 3);
    for (QLabel* problem : problems) grid->addWidget(problem, line++, 0, 1, 3);
    return box;
}

} // namespace touchdown
